//! Tolerances of the integration, derived from the noise of a measured coordinate.

use model_spec::model::Model;

/// Integration tolerance, in units of the initial noise estimate `sigma0`, for computing the whitened residuals of any
/// number of flights. The integration error of a disc after one second is then far below 1/1000 of the noise; that of a
/// fast-spinning body whose attitude is a quaternion is below 1/50.
pub const FINE_TOLERANCE: f64 = 0.007;

/// Integration tolerance, in units of the initial noise estimate `sigma0`, for computing the whitened residuals of at
/// most [`FEW_FLIGHTS`] flights, of a model whose state contains no quaternion. Integration errors then shift the
/// estimates of a disc by at most about 1/40 of their standard errors.
const FEW_FLIGHTS_TOLERANCE: f64 = 0.032;

/// Number of flights up to which [`FEW_FLIGHTS_TOLERANCE`] applies. For more flights, the tolerance decreases as the
/// inverse square root of their number, as the standard errors do.
const FEW_FLIGHTS: usize = 80;

/// Integration tolerance, in units of the initial noise estimate `sigma0`, if residuals are computed without their
/// derivatives.
pub const RESIDUAL_TOLERANCE: f64 = 0.02;

/// Integration tolerance for robust losses, in units of the initial noise estimate `sigma0`; or in units of the scale
/// of the loss if that exceeds [`LARGE_SCALE`] × `sigma0`. Integration errors stay below a quarter of the noise.
const ROBUST_TOLERANCE: f64 = 0.08;

/// Scale of a robust loss, in units of the initial noise estimate `sigma0`, above which the integration tolerance is
/// proportional to that scale.
const LARGE_SCALE: f64 = 2.0;

/// Integration tolerance for computing the whitened residuals of the given number of flights, in units of the initial
/// noise estimate `sigma0`.
pub fn whitened(model: &Model, flights: usize) -> f64 {
    if model.quaternions().next().is_some() {
        return FINE_TOLERANCE;
    }
    let part = FEW_FLIGHTS as f64 / flights.max(FEW_FLIGHTS) as f64;
    (FEW_FLIGHTS_TOLERANCE * part.sqrt()).max(FINE_TOLERANCE)
}

/// Integration tolerance, m, for residuals under a robust loss. `scale` is the scale of the loss and `sigma0` the
/// initial noise estimate, m.
pub fn robust(scale: f64, sigma0: f64) -> f64 {
    match scale > LARGE_SCALE * sigma0 {
        true => ROBUST_TOLERANCE * scale,
        false => ROBUST_TOLERANCE * sigma0,
    }
}
