//! Least-squares fits of smooth motion, and of motion whose velocity and acceleration jump, to points of a path.

use nalgebra::{SMatrix, SVector, Vector3};

use super::PathPoint;
use crate::levels::ROUNDING;

/// Unit of time in the polynomials that describe the motion of a body, s: their variable is time divided by this value.
const SCALE: f64 = 0.1;
/// Prior standard deviation of the fourth derivative, m/s⁴: a lift of several g that decays within half a second.
const SNAP: f64 = 300.0;
/// Ratio of the noise variance to the prior variance of a coefficient that stays 0.
const FIXED: f64 = 1e9;
/// Minimum of 1 − leverage as a divisor; smaller values are rounding errors.
const MIN_FREE_PART: f64 = 0.05;

/// Number of functions of time: five powers, and two for the jumps of velocity and acceleration.
const FUNCTIONS: usize = 7;
/// Index of the function whose coefficient is the jump of the velocity.
const JUMP: usize = 5;

/// Fit of motion to points of a path, of which times count from the time at which the motion may change.
#[derive(Debug)]
pub struct Fitted {
    /// Coefficients of the functions of time, m; one column per axis.
    coefficients: SMatrix<f64, FUNCTIONS, 3>,
    inverse: SMatrix<f64, FUNCTIONS, FUNCTIONS>,
    origin: Vector3<f64>,
    about: f64,
    /// Sum of squared residuals, m², plus the penalty by the prior of the fourth derivative.
    pub squares: f64,
    pub freedom: f64,
}

/// Functions of the time `t`, s, of motion that may change at time 0.
fn functions(t: f64) -> SVector<f64, FUNCTIONS> {
    let (u, since) = (t / SCALE, t.max(0.0) / SCALE);
    [1.0, u, u * u, u.powi(3), u.powi(4), since, since * since].into()
}

/// Fits motion to points with noise `noise`, m, per coordinate, which jumps at the time `about`, s, if `jumps`.
pub fn fit(points: &[&PathPoint], noise: f64, about: f64, jumps: bool) -> Option<Fitted> {
    let origin = points.first()?.position;
    let mut normal = SMatrix::<f64, FUNCTIONS, FUNCTIONS>::zeros();
    let mut right = SMatrix::<f64, FUNCTIONS, 3>::zeros();
    let mut squares = 0.0;
    for point in points {
        let (row, value) = (functions(point.time - about), point.position - origin);
        normal.ger(1.0, &row, &row, 1.0);
        right.ger(1.0, &row, &value, 1.0);
        squares += value.norm_squared();
    }
    for index in 0..FUNCTIONS {
        normal[(index, index)] += ROUNDING * normal[(index, index)];
        if index >= JUMP && !jumps {
            normal[(index, index)] += FIXED;
        }
    }
    let snap = SNAP * SCALE.powi(4) / 24.0;
    normal[(JUMP - 1, JUMP - 1)] += (noise / snap).powi(2);
    let inverse = normal.cholesky()?.inverse();
    let coefficients = inverse * right;
    Some(Fitted {
        squares: (squares - coefficients.dot(&right)).max(0.0),
        freedom: (3 * points.len().saturating_sub(FUNCTIONS)).max(3) as f64,
        coefficients,
        inverse,
        origin,
        about,
    })
}

impl Fitted {
    /// Velocity just before the change, m/s.
    pub fn velocity(&self) -> Vector3<f64> {
        Vector3::from(self.coefficients.row(1).transpose()) / SCALE
    }

    pub fn jump(&self) -> Vector3<f64> {
        Vector3::from(self.coefficients.row(JUMP).transpose()) / SCALE
    }

    /// Decrease of the sum of squares if a fitted point is left out, m².
    pub fn removal(&self, point: &PathPoint) -> f64 {
        let row = functions(point.time - self.about);
        let residual = point.position - self.origin - self.coefficients.tr_mul(&row);
        let free_part = 1.0 - row.dot(&(self.inverse * row));
        residual.norm_squared() / free_part.max(MIN_FREE_PART)
    }
}
