//! Spread of landings to first order: J Σ Jᵀ with the exact derivatives J of the landing position.

use flight::throw::Throw;
use nalgebra::{DMatrix, Matrix2, Vector2};
use ode::IntegrationOptions;

use super::scattered::Scattered;
use crate::design::bounds::Scatter;
use crate::design::throw_flight::{By, ThrowFlightError, ThrowFlights};

/// Mean and covariance of the landing positions of a throw that varies at random.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Landings {
    /// Mean of the landing position (x, y), m.
    pub mean: Vector2<f64>,
    /// Covariance of the landing position (x, y), m².
    pub covariance: Matrix2<f64>,
}

impl Landings {
    /// Ellipse of a fraction of the normal distribution: semi-axes, m, the longer first, and its direction, rad.
    pub fn ellipse(&self, fraction: f64) -> (f64, f64, f64) {
        let eigen = self.covariance.symmetric_eigen();
        let (long, short) = match eigen.eigenvalues[0] >= eigen.eigenvalues[1] {
            true => (0, 1),
            false => (1, 0),
        };
        let scale = -2.0 * (1.0 - fraction).ln();
        let half = |k: usize| (scale * eigen.eigenvalues[k].max(0.0)).sqrt();
        let axis = eigen.eigenvectors.column(long);
        (half(long), half(short), axis.y.atan2(axis.x))
    }
}

/// Covariance of the landing position, m², to first order; `near` is a similar state at release.
///
/// # Errors
/// [`ThrowFlightError`] if the throw cannot be flown.
pub fn landing_covariance(
    flights: &ThrowFlights<'_>,
    throw: &Throw,
    near: Option<&[f64]>,
    scatter: &Scatter,
    options: &IntegrationOptions,
) -> Result<Matrix2<f64>, ThrowFlightError> {
    let scattered = Scattered::of(flights, scatter);
    Ok(linear(flights, throw, near, &scattered, options)?.covariance)
}

/// Mean and covariance of the landing position, to first order in the quantities that vary at random.
pub(super) fn linear(
    flights: &ThrowFlights<'_>,
    throw: &Throw,
    near: Option<&[f64]>,
    scattered: &Scattered,
    options: &IntegrationOptions,
) -> Result<Landings, ThrowFlightError> {
    let by: &[By] = &scattered.by;
    let landing = flights
        .fly_with_derivatives(throw, near, by, options)?
        .landing();
    let moved = DMatrix::from_fn(2, by.len(), |i, j| landing.position_by[j][i]);
    let covariance = &moved * &scattered.covariance * moved.transpose();
    Ok(Landings {
        mean: landing.position.xy(),
        covariance: covariance.fixed_view::<2, 2>(0, 0).into_owned(),
    })
}
