//! The disc's functions over many states, each with parameters of its own, in lanes.

use generated::disc;
use lanes::{Kernel, Lanes, dispatch};

const STATES: usize = disc::STATES.len();
const PARAMETERS: usize = disc::PARAMETERS.len();
const J: usize = disc::J_PATTERN.len();
const JP: usize = disc::JP_PATTERN.len();

/// Columns of `count` numbers each: of the states and then the parameters, and of the results.
struct Columns<'a> {
    count: usize,
    rows: &'a [f64],
    results: &'a mut [f64],
    with_jacobians: bool,
}

impl Kernel for Columns<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let Columns { count, rows, results, with_jacobians } = self;
        let zero = T::splat(0.0);
        let (mut x, mut p, mut k) = ([zero; STATES], [zero; PARAMETERS], [zero; disc::PREPARED.len()]);
        let (mut dx, mut j, mut jp) = ([zero; STATES], [zero; J], [zero; JP]);
        for at in (0..count).step_by(T::WIDTH) {
            // Loops over indices: closures would not be compiled for the instruction set of `T`.
            for i in 0..STATES {
                x[i] = T::load(&rows[i * count + at..]);
            }
            for i in 0..PARAMETERS {
                p[i] = T::load(&rows[(STATES + i) * count + at..]);
            }
            disc::prepare(&p, &mut k);
            if with_jacobians {
                disc::f_jac_par(zero, &x, &p, &k, &mut dx, &mut j, &mut jp);
            } else {
                disc::f(zero, &x, &p, &k, &mut dx);
            }
            for i in 0..STATES {
                dx[i].store(&mut results[i * count + at..]);
            }
            if with_jacobians {
                for i in 0..J {
                    j[i].store(&mut results[(STATES + i) * count + at..]);
                }
                for i in 0..JP {
                    jp[i].store(&mut results[(STATES + J + i) * count + at..]);
                }
            }
        }
    }
}

/// f, or f with both Jacobians, of `count` states. Columns follow each other.
///
/// # Safety
/// `rows` has 30 columns of `count` numbers, a multiple of 8; `results` has room for 12 columns, or for 139 with Jacobians.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn disc_states(with_jacobians: bool, count: usize, rows: *const f64, results: *mut f64) {
    let columns = if with_jacobians { STATES + J + JP } else { STATES };
    // SAFETY: as the caller promises.
    let (rows, results) = unsafe {
        (
            std::slice::from_raw_parts(rows, (STATES + PARAMETERS) * count),
            std::slice::from_raw_parts_mut(results, columns * count),
        )
    };
    dispatch(Columns { count, rows, results, with_jacobians });
}

/// Row and column of each result after the derivatives, of the state Jacobian and then the parameter Jacobian, whose columns
/// follow those of the states.
///
/// # Safety
/// `places` has room for 254 numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn disc_places(places: *mut u32) {
    // SAFETY: as the caller promises.
    let places = unsafe { std::slice::from_raw_parts_mut(places, 2 * (J + JP)) };
    let by_parameters = disc::JP_PATTERN.map(|(row, column)| (row, STATES as u32 + column));
    for (to, (row, column)) in places.chunks_mut(2).zip(disc::J_PATTERN.into_iter().chain(by_parameters)) {
        to.copy_from_slice(&[row, column]);
    }
}
