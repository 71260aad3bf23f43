//! Flights and many states in lanes as a C library: FrisPy's equations as `hyzer generate --lanes` prints them, and the
//! built-in disc.

mod frispy;
mod states;

use generated::disc;
use lanes::Lanes;
use ode::{
    FlightEnd, FlightQueue, FlightSpan, IntegrationOptions, LanePoint, LaneRhs, LaneSizes, Method, fly_on,
};

macro_rules! model {
    ($name:ident, $limits:expr) => {
        LaneSizes {
            states: $name::STATES.len(),
            parameters: $name::PARAMETERS.len(),
            prepared: $name::PREPARED.len(),
            limits: $limits,
            scratch: 0,
        }
    };
}

macro_rules! exact {
    ($of:expr) => {
        $of.try_into().expect("as long as the model requires")
    };
}

struct Frispy;
impl LaneRhs for Frispy {
    fn sizes(&self) -> LaneSizes {
        model!(frispy, 0)
    }
    #[inline(always)]
    fn prepare<T: Lanes>(&self, p: &[T], _: &mut [T], prepared: &mut [T]) {
        frispy::prepare(exact!(p), exact!(prepared));
    }
    #[inline(always)]
    fn derivative<T: Lanes>(&self, at: LanePoint<'_, T>, _: &mut [T], dx: &mut [T]) {
        frispy::f(at.t, exact!(at.x), exact!(at.p), exact!(at.prepared), exact!(dx));
    }
    #[inline(always)]
    fn limits<T: Lanes>(&self, _: LanePoint<'_, T>, _: &mut [T], _: &mut [T]) {}
}

struct Disc;
impl LaneRhs for Disc {
    fn sizes(&self) -> LaneSizes {
        model!(disc, 1)
    }
    #[inline(always)]
    fn prepare<T: Lanes>(&self, p: &[T], _: &mut [T], prepared: &mut [T]) {
        disc::prepare(exact!(p), exact!(prepared));
    }
    #[inline(always)]
    fn derivative<T: Lanes>(&self, at: LanePoint<'_, T>, _: &mut [T], dx: &mut [T]) {
        disc::f(at.t, exact!(at.x), exact!(at.p), exact!(at.prepared), exact!(dx));
    }
    #[inline(always)]
    fn limits<T: Lanes>(&self, at: LanePoint<'_, T>, _: &mut [T], margins: &mut [T]) {
        disc::limits(at.t, exact!(at.x), exact!(at.p), exact!(at.prepared), exact!(&mut *margins));
        margins[0] = margins[0] - T::splat(disc::LIMITS[0]);
    }
}

/// Twelve states a flight; the end is the time and the states.
struct Queue<'a> {
    next: usize,
    starts: &'a [f64],
    parameters: &'a [f64],
    ends: &'a mut [f64],
    evaluations: u64,
}

impl FlightQueue for Queue<'_> {
    fn next(&mut self, x: &mut [f64], p: &mut [f64]) -> Option<u64> {
        let start = self.starts.get(12 * self.next..12 * (self.next + 1))?;
        x.copy_from_slice(start);
        p.copy_from_slice(self.parameters);
        self.next += 1;
        Some(self.next as u64 - 1)
    }
    fn end(&mut self, end: FlightEnd<'_>) {
        let to = &mut self.ends[13 * end.flight as usize..][..13];
        to[0] = end.time;
        to[1..].copy_from_slice(end.state);
        self.evaluations += end.stats.evaluations as u64;
    }
}

/// Flies `count` flights on one thread; returns the evaluations of all.
///
/// # Safety
/// `starts` has 12 numbers a flight, `parameters` as many as the model, `ends` room for 13 numbers a flight.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn flights(
    model: i32,
    dop853: i32,
    rtol: f64,
    atol: f64,
    count: usize,
    starts: *const f64,
    parameters: *const f64,
    ends: *mut f64,
) -> u64 {
    let len = if model == 0 { frispy::PARAMETERS.len() } else { disc::PARAMETERS.len() };
    // SAFETY: as the caller promises.
    let (starts, parameters, ends) = unsafe {
        (
            std::slice::from_raw_parts(starts, 12 * count),
            std::slice::from_raw_parts(parameters, len),
            std::slice::from_raw_parts_mut(ends, 13 * count),
        )
    };
    let mut queue = Queue { next: 0, starts, parameters, ends, evaluations: 0 };
    let span = FlightSpan { t_end: 600.0, height: Some(2), seeks_apex: false, until_ground: true };
    let method = if dop853 == 1 { Method::Dop853 } else { Method::Tsit5 };
    let options = IntegrationOptions { method, rtol, atol, ..IntegrationOptions::default() };
    match model {
        0 => fly_on(lanes::Isa::best(), &Frispy, &mut queue, &span, &options),
        _ => fly_on(lanes::Isa::best(), &Disc, &mut queue, &span, &options),
    };
    queue.evaluations
}

/// The disc's right-hand side, for SciPy.
///
/// # Safety
/// `x`, `p` and `prepared` have 12, 18 and 22 numbers, `dx` room for 12.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn disc_rate(x: *const f64, p: *const f64, prepared: *const f64, dx: *mut f64) {
    // SAFETY: as the caller promises.
    unsafe {
        (disc::MODEL.f)(
            0.0,
            std::slice::from_raw_parts(x, 12),
            std::slice::from_raw_parts(p, disc::PARAMETERS.len()),
            std::slice::from_raw_parts(prepared, disc::PREPARED.len()),
            std::slice::from_raw_parts_mut(dx, 12),
        )
    }
}

/// The invariants of its parameters.
///
/// # Safety
/// `p` has 18 numbers, `prepared` room for 22.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn disc_prepare(p: *const f64, prepared: *mut f64) {
    // SAFETY: as the caller promises.
    unsafe {
        (disc::MODEL.prepare)(
            std::slice::from_raw_parts(p, disc::PARAMETERS.len()),
            std::slice::from_raw_parts_mut(prepared, disc::PREPARED.len()),
        )
    }
}
