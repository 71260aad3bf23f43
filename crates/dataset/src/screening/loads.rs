//! Regression of measured accelerations on gravity and generic aerodynamic loads, and the model's gravity and drag.

use model_spec::unit::Unit;
use nalgebra::{DMatrix, DVector, Matrix3, UnitQuaternion, Vector3};
use ode::IntegrationOptions;

use super::Body;
use super::track::{Parabola, Track};
use crate::contact::PathPoint;
use crate::statistics::{median, median_of};

/// Prior standard deviation of each load, as its acceleration at the median speed, in median accelerations.
const PRIOR: f64 = 3.0;
/// Residual standard deviation in the first iteration, in median accelerations.
const FIRST_SCALE: f64 = 0.1;
/// Number of iterations of the robust regression, which reduces the weights of time windows with large residuals.
const REPETITIONS: usize = 6;

/// Measured motion of one time window, and the loads that may cause its acceleration.
#[derive(Clone, Debug)]
pub struct Row {
    pub motion: Parabola,
    /// Acceleration per unit of each load's coefficient, m²/s²; m/s² for lift by the spin of a point mass.
    pub loads: Vec<Vector3<f64>>,
}

/// Constant acceleration (gravity) and coefficients of the loads.
pub struct Regression {
    /// The constant acceleration (gravity), m/s²: fitted, or fixed by the caller.
    pub gravity: Vector3<f64>,
    /// Covariance of the constant acceleration (gravity), m²/s⁴; zero if the constant was fixed by the caller.
    pub covariance: Matrix3<f64>,
    /// Coefficients of the loads, 1/m; dimensionless for lift by the spin of a point mass.
    pub coefficients: Vec<f64>,
    /// Median magnitude, over the time windows, of the accelerations that the regression does not explain, m/s².
    pub remaining: f64,
}

/// Regression data of the time windows of a path; `omega` is the known angular velocity of a point mass, rad/s.
pub fn rows(track: &Track, omega: Option<Vector3<f64>>) -> Vec<Row> {
    let each = track.windows().into_iter();
    each.map(|(range, motion)| Row {
        loads: loads(&motion, &track.points[range], omega),
        motion,
    })
    .collect()
}

/// Regressors with the speed v and direction u: drag v² u, and for each body axis a with c = a · u the vectors v² a, v²
/// c a, v² a × u and v² c² u, m²/s². Of a point mass: drag and lift, `omega` × velocity, m/s².
fn loads(
    motion: &Parabola,
    points: &[PathPoint],
    omega: Option<Vector3<f64>>,
) -> Vec<Vector3<f64>> {
    let speed = motion.velocity.norm();
    let along = motion
        .velocity
        .try_normalize(1e-12)
        .unwrap_or_else(Vector3::zeros);
    let pressure = speed * speed;
    let mut loads = vec![pressure * along];
    let attitudes = || points.iter().filter_map(|point| point.attitude);
    let count = attitudes().count();
    if count == 0 {
        // Lift by spin is linear in the speed; spin times speed has the dimension of an acceleration.
        loads.extend(omega.map(|omega| omega.cross(&motion.velocity)));
        return loads;
    }
    for axis in [Vector3::x(), Vector3::y(), Vector3::z()] {
        let mut sums = [Vector3::zeros(); 4];
        for attitude in attitudes() {
            let axis = attitude * axis;
            let part = axis.dot(&along);
            sums[0] += axis;
            sums[1] += part * axis;
            sums[2] += axis.cross(&along);
            sums[3] += part * part * along;
        }
        loads.extend(sums.map(|sum| sum * (pressure / count as f64)));
    }
    loads
}

/// Robust regression on loads and a constant acceleration, which is `gravity` (m/s²) or fitted; `None` if the windows
/// do not determine the unknowns.
pub fn regress(rows: &[&Row], gravity: Option<Vector3<f64>>) -> Option<Regression> {
    let loads = rows.first()?.loads.len();
    let first = if gravity.is_some() { 0 } else { 3 };
    let unknowns = first + loads;
    if 3 * rows.len() < unknowns + 3 {
        return None;
    }
    let given = gravity.unwrap_or_else(Vector3::zeros);
    let typical = median_of(rows.iter().map(|row| row.motion.acceleration.norm()))?;
    let pressure = median_of(rows.iter().map(|row| row.motion.velocity.norm_squared()))?;
    if !(typical > 0.0 && pressure > 0.0) {
        return None;
    }
    // The coefficients are scaled to the load at the typical speed.
    let column = |row: &Row, k: usize| row.loads[k] / pressure;
    let mut scale = FIRST_SCALE * typical;
    let size = |row: &Row| row.motion.acceleration.norm();
    let mut weights: Vec<f64> = rows
        .iter()
        .map(|row| (typical / size(row).max(typical)).powi(2))
        .collect();
    let mut found = DVector::zeros(unknowns);
    let mut inverse = DMatrix::zeros(unknowns, unknowns);
    let mut remaining = typical;
    for _ in 0..REPETITIONS {
        let mut normal = DMatrix::zeros(unknowns, unknowns);
        let mut right = DVector::zeros(unknowns);
        for (row, weight) in rows.iter().zip(&weights) {
            let weight = weight / (scale * scale + row.motion.error * row.motion.error);
            let wanted = row.motion.acceleration - given;
            for k in 0..loads {
                let one = column(row, k);
                right[first + k] += weight * one.dot(&wanted);
                for l in 0..=k {
                    normal[(first + k, first + l)] += weight * one.dot(&column(row, l));
                }
                for axis in 0..first {
                    normal[(first + k, axis)] += weight * one[axis];
                }
            }
            for axis in 0..first {
                right[axis] += weight * wanted[axis];
                normal[(axis, axis)] += weight;
            }
        }
        for k in first..unknowns {
            normal[(k, k)] += (PRIOR * typical).powi(-2);
        }
        normal.fill_upper_triangle_with_lower_triangle();
        inverse = normal.cholesky()?.inverse();
        found = &inverse * right;
        let mut sizes = Vec::with_capacity(rows.len());
        for row in rows {
            let mut rest = row.motion.acceleration - given;
            for axis in 0..first {
                rest[axis] -= found[axis];
            }
            for k in 0..loads {
                rest -= found[first + k] * column(row, k);
            }
            sizes.push(rest.norm());
        }
        remaining = median(&mut sizes.clone());
        scale = (remaining / 3.0_f64.sqrt()).max(1e-6 * typical);
        for (weight, size) in weights.iter_mut().zip(sizes) {
            *weight = 1.0 / (1.0 + (size / (2.0 * remaining.max(1e-6 * typical))).powi(2));
        }
    }
    let constant = match gravity {
        Some(gravity) => gravity,
        None => Vector3::new(found[0], found[1], found[2]),
    };
    let covariance = match gravity {
        Some(_) => Matrix3::zeros(),
        None => inverse.fixed_view::<3, 3>(0, 0).into(),
    };
    Some(Regression {
        gravity: constant,
        covariance,
        coefficients: (first..unknowns).map(|k| found[k] / pressure).collect(),
        remaining,
    })
}

impl Regression {
    /// Acceleration in a time window less the fitted loads, m/s².
    pub fn without_loads(&self, row: &Row) -> Vector3<f64> {
        let loads = row.loads.iter().zip(&self.coefficients);
        row.motion.acceleration
            - loads
                .map(|(load, coefficient)| load * *coefficient)
                .sum::<Vector3<f64>>()
    }
}

// The acceleration of gravity in a model, determined by simulating a fall from rest.

/// Half of the simulated duration, s; a fall stays too slow for aerodynamic forces.
const HALF_DURATION: f64 = 1e-2;
/// Maximum relative difference of accelerations at different positions and attitudes.
const MAX_DIFFERENCE: f64 = 1e-2;
/// Displacements from the default state, rad and × 3 m, at which a release from rest is simulated.
const VARIATIONS: [f64; 3] = [0.0, 0.4, -0.9];

/// Acceleration after a release at rest in still air, m/s², inertial. `None` if it is at most 0.1 m/s², depends on
/// position or attitude, as of a body that is held or driven, or cannot be simulated.
pub fn gravity(body: &dyn Body) -> Option<Vector3<f64>> {
    let falls = VARIATIONS.map(|variation| fall(body, variation));
    let [first, others @ ..] = falls;
    let first = first.filter(|first| first.norm() > 0.1)?;
    let same = |other: Option<Vector3<f64>>| {
        other.is_some_and(|other| (other - first).norm() < MAX_DIFFERENCE * first.norm())
    };
    others.into_iter().all(same).then_some(first)
}

/// Speed of a simulated point mass, m/s, from whose deceleration the drag of the model is computed.
const SPEED: f64 = 8.0;

/// Drag of a point mass: deceleration over squared speed, 1/m; `None` with an attitude.
pub fn drag(body: &dyn Body) -> Option<f64> {
    if body.points().has_attitude {
        return None;
    }
    let model = body.model();
    let first = model
        .states
        .iter()
        .position(|state| state.unit == Unit::SPEED)?;
    let mut state = body.compiled().layout().default_states();
    for (declared, value) in model.states.iter().zip(&mut state) {
        if declared.unit == Unit::SPEED {
            *value = 0.0;
        }
    }
    let still = acceleration(body, &state)?;
    state[first] = SPEED;
    let moving = acceleration(body, &state)?;
    Some((moving - still).norm() / (SPEED * SPEED))
}

/// Acceleration after a release at rest, m/s², from the default state displaced by `variation`.
fn fall(body: &dyn Body, variation: f64) -> Option<Vector3<f64>> {
    let model = body.model();
    let mut state = body.compiled().layout().default_states();
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
    acceleration(body, &state)
}

/// Acceleration of the body's origin at the state `state`, m/s², by a second difference.
pub fn acceleration(body: &dyn Body, state: &[f64]) -> Option<Vector3<f64>> {
    let conditions = body.compiled().bind(body.parameters().to_vec());
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
