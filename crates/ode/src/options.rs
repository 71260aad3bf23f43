//! Options of an integration and the statistics of its result.

use crate::method::{ErrorTolerance, Method};

/// Method, error tolerances and step bounds of an integration.
///
/// A step is accepted if the root mean square over the state components of error / (`atol` + `rtol` · |x|) is at most
/// 1.
#[derive(Clone, Debug, PartialEq)]
pub struct IntegrationOptions {
    /// Runge–Kutta method; default [`Method::Tsit5`].
    pub method: Method,
    /// Relative error tolerance per step; default 1e-6.
    pub rtol: f64,
    /// Absolute error tolerance per step, in the unit of each state component; default 1e-6.
    pub atol: f64,
    /// Maximum step size, in the time unit of the right-hand side; default infinity.
    pub max_step: f64,
    /// Initial step size, in the time unit of the right-hand side f. If `None` (the default), it is estimated from the
    /// values of f at the initial state and after a trial Euler step (Hairer, Nørsett & Wanner, II.4).
    pub first_step: Option<f64>,
    /// Maximum number of accepted and rejected steps together; default 100,000. Each break of time allows four more.
    pub max_steps: usize,
}

impl Default for IntegrationOptions {
    fn default() -> Self {
        IntegrationOptions {
            method: Method::Tsit5,
            rtol: 1e-6,
            atol: 1e-6,
            max_step: f64::INFINITY,
            first_step: None,
            max_steps: 100_000,
        }
    }
}

impl IntegrationOptions {
    /// Sets `rtol` and `atol` to `tolerance` and picks the more efficient method: DOP853 below 1e-8, else Tsit5.
    pub fn with_tolerance(tolerance: f64) -> IntegrationOptions {
        let method = if tolerance < 1e-8 {
            Method::Dop853
        } else {
            Method::Tsit5
        };
        IntegrationOptions {
            method,
            rtol: tolerance,
            atol: tolerance,
            ..IntegrationOptions::default()
        }
    }

    /// Tolerances that apply to the first `controlled_len` components of the state.
    pub(crate) fn tolerance(&self, controlled_len: usize) -> ErrorTolerance {
        ErrorTolerance {
            rtol: self.rtol,
            atol: self.atol,
            controlled_len,
        }
    }
}

/// Solver statistics: counts of steps and right-hand side evaluations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SolverStats {
    /// Number of accepted steps of the integration.
    pub steps: usize,
    /// Number of steps rejected by the error test or by a non-finite derivative.
    pub rejected: usize,
    /// Number of evaluations of the right-hand side by steps and dense output, without those of event location.
    pub evaluations: usize,
}
