//! Our functions: `f64` through the model's table, and in lanes.

use crate::rows::{FLIGHTS, Flight, PARAMETERS, PREPARED, STATES, STEPS};
use generated::disc;
use lanes::{Kernel, Lanes};
use std::hint::black_box;
use std::time::Instant;

/// Entries of the state Jacobian.
pub const J: usize = disc::J_PATTERN.len();
/// Entries of the parameter Jacobian.
pub const JP: usize = disc::JP_PATTERN.len();

/// Room for results.
pub struct Results {
    /// Derivatives of the states.
    pub dx: [f64; STATES],
    /// State Jacobian.
    pub j: [f64; J],
    /// Parameter Jacobian.
    pub jp: [f64; JP],
}

impl Results {
    /// Room that a function that does not write is caught by.
    pub fn new() -> Results {
        Results {
            dx: [f64::NAN; STATES],
            j: [f64::NAN; J],
            jp: [f64::NAN; JP],
        }
    }
}

/// Calls a function for `f64`: f, f+J, f+J+Jp.
#[inline(always)]
pub fn call(function: usize, flight: &Flight, x: &[f64; STATES], to: &mut Results) {
    let Results { dx, j, jp } = to;
    match function {
        0 => (disc::MODEL.f)(0.0, x, &flight.p, &flight.k, dx),
        1 => (disc::MODEL.f_jac)(0.0, x, &flight.p, &flight.k, dx, j),
        _ => (disc::MODEL.f_jac_par)(0.0, x, &flight.p, &flight.k, dx, j, jp),
    }
}

/// A function in lanes, one flight in each: `passes` times over all states. Nanoseconds a state, and all results of the
/// last states in the order of flights, derivatives first.
pub struct InLanes<'a> {
    /// Which function.
    pub function: usize,
    /// As many flights as the widest lanes have, at least.
    pub flights: &'a [Flight],
    /// How often.
    pub passes: usize,
}

impl Kernel for InLanes<'_> {
    type Output = (f64, Vec<Vec<f64>>);

    #[inline(always)]
    fn run<T: Lanes>(self) -> Self::Output {
        match self.function {
            0 => self.measure::<T, 0>(),
            1 => self.measure::<T, 1>(),
            _ => self.measure::<T, 2>(),
        }
    }
}

impl InLanes<'_> {
    #[inline(always)]
    fn measure<T: Lanes, const FUNCTION: usize>(self) -> (f64, Vec<Vec<f64>>) {
        let zero = T::splat(0.0);
        let (mut dx, mut j, mut jp) = ([zero; STATES], [zero; J], [zero; JP]);
        let mut results = Vec::new();
        let mut seconds = 0.0;
        for flights in self.flights.chunks_exact(T::WIDTH) {
            let (mut p, mut k) = ([zero; PARAMETERS], [zero; PREPARED]);
            for (i, p) in p.iter_mut().enumerate() {
                *p = T::from_fn(|lane| flights[lane].p[i]);
            }
            for (i, k) in k.iter_mut().enumerate() {
                *k = T::from_fn(|lane| flights[lane].k[i]);
            }
            let mut states = vec![[zero; STATES]; STEPS];
            for (step, x) in states.iter_mut().enumerate() {
                for (i, x) in x.iter_mut().enumerate() {
                    *x = T::from_fn(|lane| flights[lane].x[step][i]);
                }
            }
            let start = Instant::now();
            for _ in 0..self.passes {
                for x in &states {
                    let (x, p, k) = (black_box(x), black_box(&p), black_box(&k));
                    match FUNCTION {
                        0 => disc::f(zero, x, p, k, &mut dx),
                        1 => disc::f_jac(zero, x, p, k, &mut dx, &mut j),
                        _ => disc::f_jac_par(zero, x, p, k, &mut dx, &mut j, &mut jp),
                    }
                    black_box((&mut dx, &mut j, &mut jp));
                }
            }
            seconds += start.elapsed().as_secs_f64();
            for lane in 0..T::WIDTH {
                let all = dx.iter().chain(&j).chain(&jp);
                results.push(all.map(|value| value.lane(lane)).collect());
            }
        }
        let count = self.passes * STEPS * FLIGHTS;
        (1e9 * seconds / count as f64, results)
    }
}
