//! Spread of landings due to the scatter of release, wind and coefficients: linearized, by exact derivatives, and
//! sampled, by simulated flights.

mod linear;
mod sampled;
mod scattered;

use flight::throw::Throw;
use nalgebra::{Matrix2, Vector2, Vector3};
use ode::IntegrationOptions;

pub use linear::{Landings, landing_covariance};
pub use sampled::{Band, QUANTILES, Sampled};
pub use scattered::Scattered;

use crate::design::goal::Obstacle;
use crate::design::throw_flight::{ThrowFlightError, ThrowFlights};

/// Options of the sampled spread.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SampleOptions {
    /// Number of sampled flights; default 1000. 0 disables sampling.
    pub count: usize,
    /// Seed of the random draws; default 1.
    pub seed: u64,
    /// Number of threads, which does not affect the result; default: all processors.
    pub threads: usize,
}

impl Default for SampleOptions {
    fn default() -> Self {
        SampleOptions {
            count: 1000,
            seed: 1,
            threads: flight::parallel::threads(),
        }
    }
}

/// Spread of the landings of a throw that varies at random.
#[derive(Clone, Debug, PartialEq)]
pub struct Spread {
    /// To first order.
    pub linear: Landings,
    /// Of sampled flights; `None` without sampling or if fewer than three landed.
    pub sampled: Option<Sampled>,
    /// Fraction of the draws that land within the landing circle about the aim; one that cannot be flown does not.
    pub inside: Option<f64>,
    /// Fraction of the draws whose path comes within the radius of the landing circle of a target in the air.
    pub near_target: Option<f64>,
    /// Fraction of the flown draws whose path enters the obstacle.
    pub touching: Option<f64>,
    /// Comparison of the two; `None` without samples or if the linear covariance is singular.
    pub agreement: Option<Agreement>,
}

/// Comparison of the linear and the sampled spread.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// Mahalanobis distance of the means, by the linear covariance.
    pub shift: f64,
    /// Smallest and largest ratio of the sampled to the linear standard deviation over the horizontal directions.
    pub ratios: (f64, f64),
    /// Sampling standard errors of `shift`, and of each of `ratios`.
    pub errors: (f64, f64),
    /// Whether `shift` differs from 0 and both `ratios` from 1 by at most [`TOLERATED`] or three standard errors.
    pub agrees: bool,
}

/// Tolerated distance of the means, in standard deviations, and relative difference of the standard deviations.
pub const TOLERATED: f64 = 0.15;

/// What the scattered flights of a throw are compared with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aims {
    /// Aim on the ground, x and y, m.
    pub landing: Vector2<f64>,
    /// Radius of the landing circle about the aim, m.
    pub circle: f64,
    /// Target in the air, m.
    pub target: Option<Vector3<f64>>,
    /// Obstacle that the paths must not enter.
    pub obstacle: Option<Obstacle>,
}

/// Spread of the landings of a throw that varies at random, compared with its aims.
///
/// # Errors
/// [`ThrowFlightError`] if the throw itself, without scatter, cannot be flown.
pub fn spread(
    flights: &ThrowFlights<'_>,
    throw: &Throw,
    aims: &Aims,
    scattered: &Scattered,
    options: &SampleOptions,
) -> Result<Spread, ThrowFlightError> {
    let settings = IntegrationOptions::with_tolerance(1e-6);
    let linear = linear::linear(flights, throw, None, scattered, &settings)?;
    let along = (linear.mean, aims);
    let sampled = (options.count > 0)
        .then(|| sampled::sampled(flights, throw, along, scattered, options, &settings))
        .flatten();
    // Draws without a flight count as outside the circle.
    let share = |count: usize, sampled: &Sampled| {
        count as f64 / (sampled.points.len() + sampled.failed) as f64
    };
    let inside = sampled.as_ref().map(|sampled| {
        let near = |point: &&Vector2<f64>| (**point - aims.landing).norm() <= aims.circle;
        share(sampled.points.iter().filter(near).count(), sampled)
    });
    let near_target = sampled.as_ref().filter(|_| aims.target.is_some());
    let touching = sampled.as_ref().filter(|_| aims.obstacle.is_some());
    let compared = sampled.as_ref();
    Ok(Spread {
        linear,
        inside,
        near_target: near_target.map(|sampled| share(sampled.near_target, sampled)),
        touching: touching
            .map(|sampled| sampled.touching as f64 / sampled.points.len().max(1) as f64),
        agreement: compared
            .and_then(|sampled| compare(&linear, &sampled.landings, sampled.points.len())),
        sampled,
    })
}

/// Compares the linear spread with that of `count` sampled landings; `None` if the linear covariance is singular.
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
