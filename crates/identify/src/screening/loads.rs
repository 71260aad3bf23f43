//! Regression of measured accelerations on gravity and on generic aerodynamic loads, which are quadratic in the
//! speed. It needs no aerodynamic model: the constant part of the acceleration is gravity.

use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

use super::track::{Parabola, Track};
use crate::ground_contact::PathPoint;
use dataset::statistics::{median, median_of};

/// Standard deviation of the prior of each aerodynamic load coefficient; the mean of the prior is zero. It is stated as
/// the acceleration that the load causes at the median speed, in units of the median acceleration.
const PRIOR: f64 = 3.0;
/// Residual standard deviation assumed in the first iteration of the robust regression, in units of the median
/// acceleration; later iterations estimate it from the residuals.
const FIRST_SCALE: f64 = 0.1;
/// Number of iterations of the robust regression, which reduces the weights of time windows with large residuals.
const REPETITIONS: usize = 6;

/// Regression data of one time window of a flight: the measured motion and the aerodynamic loads that may cause its
/// acceleration.
#[derive(Clone, Debug)]
pub struct Row {
    /// Velocity and acceleration of the body's origin in the time window.
    pub motion: Parabola,
    /// Regressor of each aerodynamic load: the acceleration per unit of the load's coefficient, m²/s²; m/s² for the
    /// lift caused by the spin of a point mass.
    pub loads: Vec<Vector3<f64>>,
}

/// Result of a regression of accelerations: the constant acceleration (gravity) and the coefficients of the aerodynamic
/// loads.
pub struct Regression {
    /// The constant acceleration (gravity), m/s²: fitted, or fixed by the caller.
    pub gravity: Vector3<f64>,
    /// Covariance of the constant acceleration (gravity), m²/s⁴; zero if the constant was fixed by the caller.
    pub covariance: Matrix3<f64>,
    /// Coefficients of the aerodynamic loads, in the order of [`Row::loads`], 1/m; dimensionless for the lift caused by
    /// the spin of a point mass.
    pub coefficients: Vec<f64>,
    /// Median magnitude, over the time windows, of the accelerations that the regression does not explain, m/s².
    pub remaining: f64,
}

/// Divides the path of a body (`track`) into time windows and computes the regression data of each. `omega` is the
/// angular velocity of a body modelled as a point mass, rad/s, in the axes of the path; `None` if it is unknown.
pub fn rows(track: &Track, omega: Option<Vector3<f64>>) -> Vec<Row> {
    let each = track.windows().into_iter();
    each.map(|(range, motion)| Row {
        loads: loads(&motion, &track.points[range], omega),
        motion,
    })
    .collect()
}

/// Regressors of the aerodynamic loads in a time window, with the speed v and the direction u of the velocity. For a
/// body with an attitude: drag, v² u, and for each body axis a with c = a · u the four vectors v² a, v² c a, v² a × u
/// and v² c² u, averaged over the points in the window, m²/s². For a point mass: drag and, if its angular velocity
/// `omega` (rad/s, in the axes of the path) is known, lift caused by spin: the vector product of `omega` and the
/// velocity, m/s².
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

/// Robust regression of the accelerations in the time windows `rows` on aerodynamic loads and a constant acceleration.
/// The constant is `gravity` (m/s²) or, if that is `None`, is fitted. The result is `None` if the windows do not
/// determine the unknowns.
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
    /// Acceleration in a time window minus the fitted aerodynamic loads, m/s²; equal to gravity if the fitted loads are
    /// exact.
    pub fn without_loads(&self, row: &Row) -> Vector3<f64> {
        let loads = row.loads.iter().zip(&self.coefficients);
        row.motion.acceleration
            - loads
                .map(|(load, coefficient)| load * *coefficient)
                .sum::<Vector3<f64>>()
    }
}
