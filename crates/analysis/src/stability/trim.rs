//! Trim: steady flight, straight or in a helix about the vertical, at a given constant spin.
//!
//! Velocity through the air, body axis and angular velocity rotate together about the vertical at a rate Ω: v̇ = Ω × v,
//! ṅ = Ω × n and, normal to the axis, ω̇ = Ω × ω. A constant wind carries the flight along. The second condition is satisfied by ω = r n + Ω − (Ω·n) n; a damped Newton method
//! solves the other conditions for speed, climb angle, nose, hyzer and Ω. The spin r is held constant: the moment that
//! slows it down is ignored.

use std::f64::consts::PI;

use flight::throw::{Motion, Throw, Turning};
use nalgebra::{DMatrix, DVector, Rotation3, Vector3};

use crate::stability::linearise::{BoundBody, Linearised, StabilityError};

/// A steady flight of a body, straight or in a turn.
#[derive(Clone, Debug)]
pub struct Trim {
    /// State of the model, with the mass centre above the origin at the default height of a throw.
    pub state: Vec<f64>,
    /// Motion through the air, by the quantities of a throw.
    pub throw: Throw,
    /// Rate of change of the heading, positive to the left, rad/s; 0 in straight flight.
    pub turn: f64,
    /// Motion linearised about the state.
    pub linearised: Linearised,
}

/// Norm of the residual accelerations, in units of 10 m/s² and 10 rad/s², below which a flight is steady.
const STEADY: f64 = 1e-9;
const MAX_STEPS: usize = 60;
/// Starting points of the search for a steady flight: speed (m/s), climb angle, nose angle and hyzer angle (rad).
const STARTS: [[f64; 4]; 8] = [
    [10.0, -0.2, 0.1, 0.0],
    [15.0, -0.1, 0.05, 0.0],
    [25.0, -0.1, 0.03, 0.0],
    [7.0, -0.4, 0.2, 0.0],
    [10.0, -0.3, 0.1, 0.5],
    [10.0, -0.3, 0.1, -0.5],
    [15.0, -0.3, 0.05, 1.0],
    [15.0, -0.3, 0.05, -1.0],
];

/// Steady flight with the given spin, rad/s about the axis of [`Turning::axis`] (negative: a right-hander's backhand).
pub fn trim(body: &BoundBody<'_>, spin: f64) -> Option<Trim> {
    let found = STARTS
        .into_iter()
        .filter_map(|[speed, climb, nose, hyzer]| {
            let start = DVector::from_vec(vec![speed, climb, nose, hyzer, 0.0]);
            newton(body, spin, start)
        });
    found.min_by(|a, b| a.turn.abs().total_cmp(&b.turn.abs()))
}

/// Motion through the air of a steady flight with a given spin, rad/s; `of` is speed (m/s), climb, nose, hyzer (rad) and
/// turn (rad/s).
fn motion(of: &DVector<f64>, spin: f64, is_along: bool) -> Motion {
    let course = Rotation3::from_axis_angle(&Vector3::y_axis(), -of[1]);
    let attitude = course
        * Rotation3::from_axis_angle(&Vector3::x_axis(), -of[3])
        * Rotation3::from_axis_angle(&Vector3::y_axis(), -of[2]);
    let turn = Vector3::new(0.0, 0.0, of[4]);
    let mut turning = Turning {
        axes: attitude.into_inner(),
        rates: turn,
        is_along,
    };
    let n = turning.axis();
    turning.rates = n * spin + turn - n * turn.dot(&n);
    Motion {
        position: Vector3::new(0.0, 0.0, Throw::DEFAULT_HEIGHT),
        velocity: course * Vector3::x() * of[0],
        turning: Some(turning),
    }
}

/// Acceleration (three components) and angular acceleration (two, normal to the axis) of a motion less those of steady
/// flight, in 10 m/s² and 10 rad/s²; also the state. `None` if not finite or without a state.
fn residual(
    body: &BoundBody<'_>,
    of: &DVector<f64>,
    spin: f64,
    near: Option<&[f64]>,
) -> Option<(DVector<f64>, Vec<f64>)> {
    let thrown = &body.body.thrown;
    let axes = body.body.model.flight_axes();
    let is_along = axes.is_some_and(|(_, axes)| axes.is_along());
    let through_air = motion(of, spin, is_along);
    let wanted = Motion {
        velocity: through_air.velocity + body.wind(),
        ..through_air
    };
    // The two axes across that of the spin.
    let across = if is_along { [1, 2] } else { [0, 1] };
    let state = thrown.state_of(&wanted, &body.parameters, near).ok()?;
    let (acceleration, angular) = body.accelerations(&state)?;
    let turning = wanted.turning?;
    let turn = Vector3::new(0.0, 0.0, of[4]);
    let off = acceleration - turn.cross(&through_air.velocity);
    let twist = angular - turn.cross(&turning.rates);
    let parts = [
        off.x / 10.0,
        off.y / 10.0,
        off.z / 10.0,
        twist.dot(&turning.axes.column(across[0])) / 10.0,
        twist.dot(&turning.axes.column(across[1])) / 10.0,
    ];
    parts
        .iter()
        .all(|v| v.is_finite())
        .then(|| (DVector::from_row_slice(&parts), state))
}

fn newton(body: &BoundBody<'_>, spin: f64, start: DVector<f64>) -> Option<Trim> {
    let mut at = start;
    let (mut off, mut state) = residual(body, &at, spin, None)?;
    let mut damping = 1e-3;
    for _ in 0..MAX_STEPS {
        if off.norm() < STEADY {
            return finished(body, &at, state);
        }
        let mut jacobian = DMatrix::zeros(5, 5);
        for k in 0..5 {
            let step = 1e-5 * if k == 0 { at[0].abs().max(1.0) } else { 1.0 };
            let mut moved = at.clone();
            moved[k] += step;
            let up = residual(body, &moved, spin, Some(&state))?.0;
            moved[k] -= 2.0 * step;
            let down = residual(body, &moved, spin, Some(&state))?.0;
            jacobian.set_column(k, &((up - down) / (2.0 * step)));
        }
        let normal = jacobian.tr_mul(&jacobian);
        let slope = jacobian.tr_mul(&off);
        let mut gained = false;
        while damping < 1e8 {
            let mut damped = normal.clone();
            for k in 0..5 {
                damped[(k, k)] += damping * normal[(k, k)].max(1e-12);
            }
            let Some(step) = damped.cholesky().map(|factor| factor.solve(&slope)) else {
                damping *= 10.0;
                continue;
            };
            let there = &at - step;
            let is_flight =
                there[0] > 0.1 && there[0] < 150.0 && there.rows(1, 3).amax() < 0.5 * PI;
            let new = residual(body, &there, spin, Some(&state)).filter(|_| is_flight);
            match new.filter(|(new, _)| new.norm() < off.norm()) {
                Some((new, new_state)) => {
                    (at, off, state) = (there, new, new_state);
                    damping = (damping * 0.1).max(1e-14);
                    gained = true;
                    break;
                }
                None => damping *= 10.0,
            }
        }
        if !gained {
            return None;
        }
    }
    None
}

fn finished(body: &BoundBody<'_>, at: &DVector<f64>, state: Vec<f64>) -> Option<Trim> {
    let linearised: Result<Linearised, StabilityError> = body.linearise(0.0, &state);
    let (thrown, parameters) = (&body.body.thrown, &body.parameters);
    let mut through_air = thrown.motion(&state, parameters);
    through_air.velocity -= body.wind();
    let in_calm_air = thrown.state_of(&through_air, parameters, Some(&state));
    Some(Trim {
        throw: thrown.throw(&in_calm_air.ok()?, parameters),
        turn: at[4],
        linearised: linearised.ok()?,
        state,
    })
}
