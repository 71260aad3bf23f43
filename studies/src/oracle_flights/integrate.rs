//! Integration of the oracle's equations of motion by the classic Runge–Kutta method with a small constant step.

use std::cell::RefCell;

use nalgebra::Vector3;
use oracle::{Motion, Physical, Point, Quaternion, Reference};

/// Default maximum step size, s, of the Runge–Kutta integration of simulated flights; small enough for tests that
/// compare flights to the last digits. With this step, the relative error of a nutation of 100 rad/s stays below 1e-9
/// over one second of flight.
pub(super) const SMALL_STEP: f64 = 4e-4;

/// Integrates a motion under the law of motion `reference` from the state `start` at time 0, with constant parameters
/// and coefficients. Returns the states at `times` (s, increasing).
///
/// # Panics
/// If `times` decrease.
pub fn integrate(
    reference: &Reference,
    constants: &Point<f64>,
    start: Physical<f64>,
    times: &[f64],
) -> Vec<Physical<f64>> {
    integrate_with_constants(reference, constants, &|_, _| {}, start, times, SMALL_STEP)
}

/// Integrates a motion under the law of motion `reference` from the state `start` at time 0. Some parameters and
/// coefficients are functions of the state: `set` writes them, for example to replace the model's polynomials by
/// tabulated aerodynamic curves. No step is longer than `max_step`, s. Returns the states at `times` (s, increasing).
///
/// # Panics
/// If `times` decrease.
pub fn integrate_with_constants(
    reference: &Reference,
    constants: &Point<f64>,
    set: &dyn Fn(&Physical<f64>, &mut Point<f64>),
    start: Physical<f64>,
    times: &[f64],
    max_step: f64,
) -> Vec<Physical<f64>> {
    let constants = RefCell::new(constants.clone());
    let law = |body: &Physical<f64>, _: f64, _: f64| {
        let mut constants = constants.borrow_mut();
        set(body, &mut constants);
        Derivatives {
            motion: reference.motion_at(body, &constants),
            internal_rate: 0.0,
        }
    };
    integrate_in_steps(&law, start, 0.0, times, max_step)
}

/// Time derivatives of body state and internal state that a law of motion gives at one time.
#[derive(Clone, Copy, Debug)]
pub struct Derivatives {
    /// Acceleration of the mass centre (m/s²) and angular acceleration of the body (rad/s²), in inertial axes.
    pub motion: Motion<f64>,
    /// Rate of change of the law's internal state, in that state's unit per second.
    pub internal_rate: f64,
}

/// A law of motion: a function of the body state, the time (s) and one scalar internal state (for example a lagged
/// angle of attack).
type Law<'l> = &'l dyn Fn(&Physical<f64>, f64, f64) -> Derivatives;

/// Integrates a law of motion with one scalar internal state, from the state `start` and the value `internal` at time
/// 0. Returns the body states at `times` (s, increasing).
///
/// # Panics
/// If `times` decrease.
pub fn integrate_law(
    law: Law<'_>,
    start: Physical<f64>,
    internal: f64,
    times: &[f64],
) -> Vec<Physical<f64>> {
    integrate_in_steps(law, start, internal, times, SMALL_STEP)
}

fn integrate_in_steps(
    law: Law<'_>,
    start: Physical<f64>,
    internal: f64,
    times: &[f64],
    max_step: f64,
) -> Vec<Physical<f64>> {
    let mut now = State {
        time: 0.0,
        body: start,
        internal,
    };
    let states = times.iter().map(|&time| {
        assert!(time >= now.time, "times increase");
        let steps = ((time - now.time) / max_step).ceil().max(1.0);
        let h = (time - now.time) / steps;
        for _ in 0..steps as usize {
            now = step(law, &now, h);
        }
        now.time = time;
        now.body
    });
    states.collect()
}

/// Positions (m, inertial axes) of markers that are fixed to the body at `markers` (m, body axes).
pub fn marker_positions(body: &Physical<f64>, markers: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let position = |marker: &[f64; 3]| body.position + body.attitude.carry((*marker).into());
    let each = markers.iter().map(|marker| position(marker).into());
    each.collect()
}

#[derive(Clone, Copy)]
struct State {
    time: f64,
    body: Physical<f64>,
    internal: f64,
}

/// Time derivative, component by component, of the integrated state: body state and internal state of the law of
/// motion.
struct Rate {
    velocity: Vector3<f64>,
    acceleration: Vector3<f64>,
    attitude: Quaternion<f64>,
    angular_acceleration: Vector3<f64>,
    internal: f64,
}

fn rate(law: Law<'_>, at: &State) -> Rate {
    let derivatives = law(&at.body, at.time, at.internal);
    let half_spin = Quaternion {
        w: 0.0,
        v: at.body.angular_velocity * 0.5,
    };
    Rate {
        velocity: at.body.velocity,
        acceleration: derivatives.motion.acceleration,
        attitude: half_spin.times(at.body.attitude),
        angular_acceleration: derivatives.motion.angular_acceleration,
        internal: derivatives.internal_rate,
    }
}

/// Returns the state after `h` seconds at the constant rate of change `rate`. The quaternion is not normalised.
fn advanced(from: &State, h: f64, rate: &Rate) -> State {
    let body = &from.body;
    State {
        time: from.time + h,
        body: Physical {
            position: body.position + rate.velocity * h,
            velocity: body.velocity + rate.acceleration * h,
            attitude: Quaternion {
                w: body.attitude.w + h * rate.attitude.w,
                v: body.attitude.v + rate.attitude.v * h,
            },
            angular_velocity: body.angular_velocity + rate.angular_acceleration * h,
        },
        internal: from.internal + h * rate.internal,
    }
}

/// One classic Runge–Kutta step of `h` seconds. Normalises the quaternion.
fn step(law: Law<'_>, x: &State, h: f64) -> State {
    let k1 = rate(law, x);
    let k2 = rate(law, &advanced(x, h / 2.0, &k1));
    let k3 = rate(law, &advanced(x, h / 2.0, &k2));
    let k4 = rate(law, &advanced(x, h, &k3));
    let vector =
        |of: fn(&Rate) -> Vector3<f64>| (of(&k1) + (of(&k2) + of(&k3)) * 2.0 + of(&k4)) / 6.0;
    let scalar = |of: fn(&Rate) -> f64| (of(&k1) + 2.0 * (of(&k2) + of(&k3)) + of(&k4)) / 6.0;
    let mean = Rate {
        velocity: vector(|k| k.velocity),
        acceleration: vector(|k| k.acceleration),
        attitude: Quaternion {
            w: scalar(|k| k.attitude.w),
            v: vector(|k| k.attitude.v),
        },
        angular_acceleration: vector(|k| k.angular_acceleration),
        internal: scalar(|k| k.internal),
    };
    let mut next = advanced(x, h, &mean);
    let attitude = next.body.attitude;
    let norm = (attitude.w * attitude.w + attitude.v.norm_squared()).sqrt();
    next.body.attitude = Quaternion {
        w: attitude.w / norm,
        v: attitude.v / norm,
    };
    next
}
