//! Residuals with their derivatives, and the options by which flights are integrated for them.

use ode::{IntegrationOptions, Method};

/// Range of integration tolerances, m: rounding errors limit the accuracy.
const TOLERANCES: (f64, f64) = (1e-10, 1e-3);

/// Maximum number of integration steps, and of further steps per sample; a trajectory that needs more has diverged.
const STEPS: (usize, usize) = (1_000, 20);

/// Options for a flight of `samples` samples; `tolerance`, m, is clamped.
pub(crate) fn integration_options(tolerance: f64, samples: usize) -> IntegrationOptions {
    IntegrationOptions {
        method: Method::Tsit5,
        max_steps: STEPS.0 + STEPS.1 * samples,
        ..IntegrationOptions::with_tolerance(tolerance.clamp(TOLERANCES.0, TOLERANCES.1))
    }
}

/// Residual of one measured value, and derivatives of this residual, evaluated on the integrated trajectory.
pub(crate) struct ObservedPoint<'r> {
    pub channel: usize,
    pub sample: usize,
    pub time: f64,
    /// Predicted − measured, times the scale of the channel, m.
    pub residual: [f64; 3],
    /// Derivatives of the residual, one row per axis, in the columns of [`JacobianColumns`].
    pub rows: &'r mut [Vec<f64>; 3],
}

/// Residuals `[channel][sample]`, (predicted − measured) × scale of the channel, m, outliers included.
pub type Residuals = Vec<Vec<Option<[f64; 3]>>>;
