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
pub use scattered::{CoefficientErrors, Scattered};

use crate::design::goal::Obstacle;
use crate::design::throw_flight::{ThrowFlightError, ThrowFlights};

/// Options for sampling flights at random to determine the spread of the landings.
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

/// Spread of the landings of a throw whose quantities, wind and parameters vary at random.
#[derive(Clone, Debug, PartialEq)]
pub struct Spread {
    /// Distribution of the landings by linear propagation of the random variation of the throw (to first order).
    pub linear: Landings,
    /// Distribution of landings of sampled flights; `None` if sampling was disabled or fewer than three flights
    /// landed.
    pub sampled: Option<Sampled>,
    /// Fraction of the draws that land within the landing circle about the aim; draws that cannot be flown count as
    /// outside. `None` without samples.
    pub inside: Option<f64>,
    /// Fraction of the draws whose path comes within the radius of the landing circle of the target; `None` without
    /// samples, or if there is no target in the air.
    pub near_target: Option<f64>,
    /// Fraction of the flown draws whose path enters the obstacle; `None` without samples or without an obstacle.
    pub touching: Option<f64>,
    /// Comparison of the spread by linear propagation with that of sampled flights; `None` without samples or if the
    /// linear covariance is singular.
    pub agreement: Option<Agreement>,
}

/// Comparison of two computations of the spread of the landings: linear propagation of the scatter, and sampling.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// Mahalanobis distance between the mean landing of the sampled flights and that of the linear propagation, with
    /// the covariance of the linear propagation; dimensionless.
    pub shift: f64,
    /// Ratio of the standard deviation of the sampled landings to that of the linear propagation, in the horizontal
    /// directions in which this ratio is smallest and largest.
    pub ratios: (f64, f64),
    /// Sampling standard errors: of `shift`, and of each ratio in `ratios`.
    pub errors: (f64, f64),
    /// Whether the linear and the sampled spread agree: `shift` differs from 0, and both `ratios` differ from 1, by at
    /// most [`TOLERATED`] or three of their standard errors, whichever is larger.
    pub agrees: bool,
}

/// Tolerance for agreement of the spread by linear propagation with that of sampled flights: maximum distance between
/// their means, in standard deviations, and maximum relative difference of their standard deviations.
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
    let sampled = match options.count {
        0 => None,
        _ => sampled::sampled(
            flights,
            throw,
            (linear.mean, aims),
            scattered,
            options,
            &settings,
        ),
    };
    // Draws without a flight count as outside the circle.
    let share = |count: usize, sampled: &Sampled| {
        count as f64 / (sampled.points.len() + sampled.failed) as f64
    };
    let inside = sampled.as_ref().map(|sampled| {
        let near = |point: &&Vector2<f64>| (**point - aims.landing).norm() <= aims.circle;
        share(sampled.points.iter().filter(near).count(), sampled)
    });
    let near_target = sampled.as_ref().filter(|_| aims.target.is_some());
    let near_target = near_target.map(|sampled| share(sampled.near_target, sampled));
    let touching = sampled.as_ref().filter(|_| aims.obstacle.is_some());
    let touching =
        touching.map(|sampled| sampled.touching as f64 / sampled.points.len().max(1) as f64);
    let agreement = sampled
        .as_ref()
        .and_then(|sampled| compare(&linear, &sampled.landings, sampled.points.len()));
    Ok(Spread {
        linear,
        sampled,
        inside,
        near_target,
        touching,
        agreement,
    })
}

/// Compares the landing distribution by linear propagation with that of `count` sampled landings; `None` if the linear
/// covariance is singular.
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
