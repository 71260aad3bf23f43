//! Tolerances of the integration, relative to the noise of a measured coordinate.

use model_spec::model::Model;

/// Tolerance over `sigma0` for whitened residuals of any number of flights. The integration error of a disc after a
/// second is then far below 1/1000 of the noise; that of a fast-spinning body with a quaternion below 1/50.
pub const FINE_TOLERANCE: f64 = 0.007;

/// Tolerance over `sigma0` for whitened residuals of up to [`FEW_FLIGHTS`] flights without a quaternion: errors stay
/// below 1/1000 of the noise. Summed over many flights they would exceed the gain of the last steps.
const FEW_FLIGHTS_TOLERANCE: f64 = 0.02;

/// Number of flights up to which [`FEW_FLIGHTS_TOLERANCE`] applies; it falls with the root of their number beyond.
const FEW_FLIGHTS: usize = 200;

/// Tolerance over `sigma0` for residuals without derivatives.
pub const RESIDUAL_TOLERANCE: f64 = 0.02;

/// Tolerance for robust losses, over the greater of `sigma0` and, beyond [`LARGE_SCALE`], the scale of the loss:
/// errors stay below a quarter of the noise.
const ROBUST_TOLERANCE: f64 = 0.08;

/// Scale of a robust loss over `sigma0` beyond which that scale sets the tolerance.
const LARGE_SCALE: f64 = 2.0;

/// Tolerance over `sigma0` for whitened residuals of this number of flights.
pub fn whitened(model: &Model, flights: usize) -> f64 {
    if model.quaternions().next().is_some() {
        return FINE_TOLERANCE;
    }
    let part = FEW_FLIGHTS as f64 / flights.max(FEW_FLIGHTS) as f64;
    (FEW_FLIGHTS_TOLERANCE * part.sqrt()).max(FINE_TOLERANCE)
}

/// Tolerance for residuals under a robust loss of a scale, m.
pub fn robust(scale: f64, sigma0: f64) -> f64 {
    match scale > LARGE_SCALE * sigma0 {
        true => ROBUST_TOLERANCE * scale,
        false => ROBUST_TOLERANCE * sigma0,
    }
}
