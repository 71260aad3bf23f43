//! Spread of landings from the scatter of release, wind and coefficients: linear, by exact derivatives, and sampled, by flights.

mod linear;
mod sampled;
mod scattered;

use flight::throw::Throw;
use nalgebra::{Matrix2, Vector2};
use ode::IntegrationOptions;

pub use linear::{Landings, landing_covariance};
pub use sampled::{Band, QUANTILES, Sampled};
pub use scattered::{CoefficientErrors, Scattered};

use crate::throw_flight::{ThrowFlightError, ThrowFlights};

/// How many flights are sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SampleOptions {
    /// Number of draws; default 1000. None are sampled where it is 0.
    pub count: usize,
    /// Seed of the draws; default 1.
    pub seed: u64,
    /// Number of threads, on which the result does not depend; default all processors.
    pub threads: usize,
}

impl Default for SampleOptions {
    fn default() -> Self {
        SampleOptions {
            count: 1000,
            seed: 1,
            threads: flight::batch::threads(),
        }
    }
}

/// Spread of the landings of a throw.
#[derive(Clone, Debug, PartialEq)]
pub struct Spread {
    /// To first order.
    pub linear: Landings,
    /// By flights; `None` where none were asked for or fewer than three landed.
    pub sampled: Option<Sampled>,
    /// Fraction of the landings within the circle about the aim: of the samples, or else of the linear distribution's.
    pub inside: Option<f64>,
    /// Whether linear and sampled spread agree.
    pub agreement: Option<Agreement>,
}

/// Comparison of the linear with the sampled spread.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// Distance of the means as a part of the linear standard deviation in its direction (a Mahalanobis distance).
    pub shift: f64,
    /// Least and greatest ratio of the sampled to the linear standard deviation over all directions.
    pub ratios: (f64, f64),
    /// Standard errors of the shift and of a ratio by the number of samples.
    pub errors: (f64, f64),
    /// Whether they agree: shift and ratios differ from 0 and 1 by less than [`TOLERATED`] or three standard errors.
    pub agrees: bool,
}

/// Shift in standard deviations, and relative difference of standard deviations, up to which linear and sampled spread agree.
pub const TOLERATED: f64 = 0.15;

/// Spread of the landings of a throw about an aim on the ground, m.
///
/// # Errors
/// [`ThrowFlightError`] where the throw itself has no flight.
pub fn spread(
    flights: &ThrowFlights<'_>,
    throw: &Throw,
    (aim, circle): (Vector2<f64>, f64),
    scattered: &Scattered,
    options: &SampleOptions,
) -> Result<Spread, ThrowFlightError> {
    let settings = IntegrationOptions::with_tolerance(1e-6);
    let linear = linear::linear(flights, throw, None, scattered, &settings)?;
    let how = (options.count, options.seed, options.threads);
    let sampled = match options.count {
        0 => None,
        _ => sampled::sampled(flights, throw, linear.mean, scattered, how, &settings),
    };
    let inside = sampled.as_ref().map(|sampled| {
        let near = |point: &&Vector2<f64>| (**point - aim).norm() <= circle;
        // Throws that have no flight do not land in the circle.
        sampled.points.iter().filter(near).count() as f64
            / (sampled.points.len() + sampled.failed) as f64
    });
    let agreement = sampled
        .as_ref()
        .and_then(|sampled| compare(&linear, &sampled.landings, sampled.points.len()));
    Ok(Spread {
        linear,
        sampled,
        inside,
        agreement,
    })
}

/// Compares two distributions; `None` where the linear one has no extent in some direction.
fn compare(linear: &Landings, sampled: &Landings, count: usize) -> Option<Agreement> {
    let factor = linear.covariance.cholesky()?;
    let inverse = factor.l().try_inverse()?;
    let shift = (inverse * (sampled.mean - linear.mean)).norm();
    let relative: Matrix2<f64> = inverse * sampled.covariance * inverse.transpose();
    let values = relative.symmetric_eigenvalues().map(|v| v.max(0.0).sqrt());
    let ratios = (values.min(), values.max());
    let count = count as f64;
    let errors = ((2.0 / count).sqrt(), (0.5 / count).sqrt());
    let far = (shift > TOLERATED.max(3.0 * errors.0))
        || (ratios.1 - 1.0 > TOLERATED.max(3.0 * errors.1))
        || (1.0 - ratios.0 > TOLERATED.max(3.0 * errors.1));
    Some(Agreement {
        shift,
        ratios,
        errors,
        agrees: !far,
    })
}
