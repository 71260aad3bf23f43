//! Least-squares fits of smooth motion, and of motion whose velocity and acceleration jump, to points of a path.

use nalgebra::{Cholesky, Const, SMatrix, SVector, Vector3};

use super::PathPoint;
use crate::levels::ROUNDING;

/// Unit of time in the polynomials that describe the motion of a body, s: their variable is time divided by this value.
const SCALE: f64 = 0.1;
/// Prior standard deviation of the fourth derivative, m/s⁴: a lift of several g that decays within half a second.
const SNAP: f64 = 300.0;
/// Minimum of 1 − leverage as a divisor; smaller values are rounding errors.
const MIN_FREE_PART: f64 = 0.05;

/// Numbers of functions of time: the powers of smooth motion, and all, two more of which are the jumps of velocity and
/// acceleration.
const FUNCTIONS: (usize, usize) = (5, 7);

/// Fit of smooth motion to points of a path.
pub type Smooth = Fitted<{ FUNCTIONS.0 }>;
/// Fit of motion whose velocity and acceleration jump.
pub type Changed = Fitted<{ FUNCTIONS.1 }>;

/// Fit of `N` functions of time to points of a path, of which times count from the time at which the motion may change.
#[derive(Debug)]
pub struct Fitted<const N: usize> {
    /// Coefficients of the functions of time, m; one column per axis.
    coefficients: SMatrix<f64, N, 3>,
    factor: Cholesky<f64, Const<N>>,
    origin: Vector3<f64>,
    about: f64,
    /// Sum of squared residuals, m², plus the penalty by the prior of the fourth derivative.
    pub squares: f64,
    pub freedom: f64,
}

/// The first functions of the time `t`, s, of motion that may change at time 0.
fn functions<const N: usize>(t: f64) -> SVector<f64, N> {
    let (u, since) = (t / SCALE, t.max(0.0) / SCALE);
    let all = [1.0, u, u * u, u.powi(3), u.powi(4), since, since * since];
    SVector::from_row_slice(&all[..N])
}

impl<const N: usize> Fitted<N> {
    /// Fits motion to points with noise `noise`, m, per coordinate, which may jump at the time `about`, s.
    pub fn through(points: &[&PathPoint], noise: f64, about: f64) -> Option<Self> {
        let origin = points.first()?.position;
        let mut normal = SMatrix::<f64, N, N>::zeros();
        let mut right = SMatrix::<f64, N, 3>::zeros();
        let mut squares = 0.0;
        for point in points {
            let row = functions::<N>(point.time - about);
            let value = point.position - origin;
            normal.ger(1.0, &row, &row, 1.0);
            right.ger(1.0, &row, &value, 1.0);
            squares += value.norm_squared();
        }
        for index in 0..N {
            normal[(index, index)] += ROUNDING * normal[(index, index)];
        }
        let (snap, fourth) = (SNAP * SCALE.powi(4) / 24.0, FUNCTIONS.0 - 1);
        normal[(fourth, fourth)] += (noise / snap).powi(2);
        let factor = normal.cholesky()?;
        let coefficients = factor.solve(&right);
        Some(Self {
            squares: (squares - coefficients.dot(&right)).max(0.0),
            freedom: (3 * points.len().saturating_sub(FUNCTIONS.1)).max(3) as f64,
            coefficients,
            factor,
            origin,
            about,
        })
    }

    /// Decreases of the sum of squares if each of the fitted points is left out, m².
    pub fn removals(&self, points: &[&PathPoint]) -> impl Iterator<Item = f64> {
        let inverse = self.factor.inverse();
        points.iter().map(move |point| {
            let row = functions::<N>(point.time - self.about);
            let residual = point.position - self.origin - self.coefficients.tr_mul(&row);
            let free_part = 1.0 - row.dot(&(inverse * row));
            residual.norm_squared() / free_part.max(MIN_FREE_PART)
        })
    }
}

impl Changed {
    /// Velocity just before the change, m/s.
    pub fn velocity(&self) -> Vector3<f64> {
        Vector3::from(self.coefficients.row(1).transpose()) / SCALE
    }

    pub fn jump(&self) -> Vector3<f64> {
        Vector3::from(self.coefficients.row(FUNCTIONS.0).transpose()) / SCALE
    }
}
