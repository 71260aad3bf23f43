//! The acceleration of gravity in a model, determined by simulating a fall from rest.

use model_spec::unit::Unit;
use nalgebra::{UnitQuaternion, Vector3};
use ode::IntegrationOptions;

use crate::problem::FitProblem;

/// Half of the duration of the simulation from which an acceleration is computed, s; so short that the speed of a fall
/// from rest stays too low for aerodynamic forces to matter.
const HALF_DURATION: f64 = 1e-2;
/// Maximum relative difference between the accelerations of bodies released from rest at different positions and
/// attitudes, at which gravity counts as independent of position and attitude.
const MAX_DIFFERENCE: f64 = 1e-2;
/// Three displacements from the default state, at each of which the acceleration of a body released from rest is
/// computed, to test whether it depends on position or attitude. A displacement changes angles by up to its value in
/// rad, and coordinates by up to 3 m times its value.
const VARIATIONS: [f64; 3] = [0.0, 0.4, -0.9];

/// Acceleration of gravity in the model, m/s², inertial frame: the acceleration of the body's origin after a release at
/// rest in still air. `None` if the acceleration is at most 0.1 m/s² or depends on position or attitude, as for a body
/// that is held, driven or not under gravity, and if a simulation fails.
pub fn gravity(problem: &FitProblem) -> Option<Vector3<f64>> {
    let falls = VARIATIONS.map(|variation| fall(problem, variation));
    let [first, others @ ..] = falls;
    let first = first.filter(|first| first.norm() > 0.1)?;
    let same = |other: Option<Vector3<f64>>| {
        other.is_some_and(|other| (other - first).norm() < MAX_DIFFERENCE * first.norm())
    };
    others.into_iter().all(same).then_some(first)
}

/// Speed of a simulated point mass, m/s, from whose deceleration the drag of the model is computed.
const SPEED: f64 = 8.0;

/// Drag of a point mass with the model's coefficients: deceleration divided by squared speed, 1/m; `None` for a body
/// with an attitude.
pub fn drag(problem: &FitProblem) -> Option<f64> {
    if problem.has_attitude {
        return None;
    }
    let model = &problem.model;
    let first = model
        .states
        .iter()
        .position(|state| state.unit == Unit::SPEED)?;
    let mut state = problem.body.layout().default_states();
    for (declared, value) in model.states.iter().zip(&mut state) {
        if declared.unit == Unit::SPEED {
            *value = 0.0;
        }
    }
    let still = acceleration(problem, &state)?;
    state[first] = SPEED;
    let moving = acceleration(problem, &state)?;
    Some((moving - still).norm() / (SPEED * SPEED))
}

/// Acceleration of the body's origin, m/s², inertial frame, when the body is released at rest. Its position and
/// attitude are those of the default state, shifted by up to 3 `variation` (m) and turned by up to `variation` (rad)
/// about each axis; `variation` is an entry of [`VARIATIONS`]. `None` if the simulation fails.
fn fall(problem: &FitProblem, variation: f64) -> Option<Vector3<f64>> {
    let model = &problem.model;
    let mut state = problem.body.layout().default_states();
    for (index, (declared, value)) in model.states.iter().zip(&mut state).enumerate() {
        let sign = [1.0, -0.7, 0.5][index % 3];
        match declared.unit {
            Unit::METRE => *value += sign * 3.0 * variation,
            Unit::RADIAN => *value += sign * variation,
            Unit::SPEED | Unit::RATE => *value = 0.0,
            _ => {}
        }
    }
    for quaternion in model.quaternions() {
        let turn = UnitQuaternion::from_euler_angles(variation, -0.7 * variation, 0.5 * variation);
        let turn = [turn.w, turn.i, turn.j, turn.k];
        for (place, value) in quaternion.into_iter().zip(turn) {
            state[place] = value;
        }
    }
    acceleration(problem, &state)
}

/// Acceleration of the body's origin, m/s², inertial frame, when the simulation starts at the state `state`. It is
/// computed by a second difference of the positions in a short simulation; `None` if the simulation fails.
pub fn acceleration(problem: &FitProblem, state: &[f64]) -> Option<Vector3<f64>> {
    let conditions = problem.body.bind(problem.parameters.clone());
    let times = [0.0, HALF_DURATION, 2.0 * HALF_DURATION];
    let mut states = vec![0.0; times.len() * state.len()];
    let options = IntegrationOptions::with_tolerance(1e-12);
    let start = (0.0, &state.into());
    conditions
        .integrate_at(start, &times, &options, &mut [], &mut states)
        .ok()?;
    let mut observer = conditions.observer();
    let seen = times.iter().zip(states.chunks(state.len()));
    let seen: Vec<Vector3<f64>> = seen
        .map(|(&t, x)| observer.position(t, x, &[0.0; 3]).into())
        .collect();
    let acceleration = (seen[2] - 2.0 * seen[1] + seen[0]) / (HALF_DURATION * HALF_DURATION);
    acceleration
        .iter()
        .all(|axis| axis.is_finite())
        .then_some(acceleration)
}
