//! Tolerances of the integration, derived from the noise of a measured coordinate.

use model_spec::model::Model;

use dataset::levels::ROUGHLY_NOISE;

/// Tolerance for whitened residuals of any number of flights: the error of a disc after one second is far below 1/1000
/// of the noise, of a fast-spinning body with a quaternion below 1/50.
pub const FINE_TOLERANCE: f64 = 0.007;

/// Tolerance for a model without quaternion, and the number of flights up to which it applies; beyond, it decreases as
/// standard errors do. It shifts the estimates of a disc by at most about 1/40 standard error.
const FEW: (f64, usize) = (0.032, 80);

/// Tolerance for residuals without derivatives.
pub const RESIDUAL_TOLERANCE: f64 = 0.02;

/// Tolerance for robust losses, in units of their scale if it is above the noise.
const ROBUST_TOLERANCE: f64 = 0.08;

/// Tolerance for whitened residuals of the given number of flights.
pub fn whitened_tolerance(model: &Model, flights: usize) -> f64 {
    if model.quaternions().next().is_some() {
        return FINE_TOLERANCE;
    }
    let part = FEW.1 as f64 / flights.max(FEW.1) as f64;
    (FEW.0 * part.sqrt()).max(FINE_TOLERANCE)
}

/// Tolerance, m, under a robust loss of scale `scale`, m.
pub fn robust_tolerance(scale: f64, sigma0: f64) -> f64 {
    let is_large = scale > ROUGHLY_NOISE * sigma0;
    ROBUST_TOLERANCE * if is_large { scale } else { sigma0 }
}
