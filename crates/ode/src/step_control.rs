//! Step-size control: the PI controller and the initial step size.

use crate::method::tableau::Tableau;
use crate::method::{ErrorTolerance, combine};
use crate::rhs::OdeRhs;

/// Safety factor on the predicted step size, so that the next step rarely fails the error test.
const SAFETY: f64 = 0.9;

/// Lower bound on the error norm of an accepted step that the controller stores for the next update of the step size.
/// Without this bound, a nearly zero error norm would make the updated step size too small.
const MIN_REMEMBERED_ERROR: f64 = 1e-4;

/// Constants of a proportional-integral step-size controller (Hairer & Wanner, IV.2).
#[derive(Clone, Copy)]
pub(crate) struct PiGains {
    proportional_exponent: f64,
    integral_exponent: f64,
    factor_bounds: (f64, f64),
}

/// State that the step-size controller carries from one step to the next.
#[derive(Clone, Copy)]
pub(crate) struct PiMemory {
    pub log2_last_error: f64,
    /// Maximum ratio of the next step size to the current: 1 after a rejected step, else the bound of the method.
    pub max_factor: f64,
}

impl PiGains {
    pub(crate) fn new(tableau: &Tableau) -> PiGains {
        PiGains {
            proportional_exponent: 1.0 / f64::from(tableau.error_order) - 0.75 * tableau.pi_beta,
            integral_exponent: tableau.pi_beta,
            factor_bounds: tableau.step_factor_bounds,
        }
    }

    /// Returns the controller state before the first step.
    pub(crate) fn start(&self) -> PiMemory {
        PiMemory {
            log2_last_error: approx_log2(MIN_REMEMBERED_ERROR),
            max_factor: self.factor_bounds.1,
        }
    }

    /// Returns the ratio of the next step size to the current one after a step accepted with error norm `error` (at
    /// most 1), and the new controller state. The code has no branches, so that loops over lanes become vector
    /// instructions.
    #[inline(always)]
    pub(crate) fn after_accepted(&self, last: PiMemory, error: f64) -> (f64, PiMemory) {
        let log2_error = approx_log2(error.max(1e-10));
        let exponent =
            self.integral_exponent * last.log2_last_error - self.proportional_exponent * log2_error;
        let factor = SAFETY * approx_exp2(exponent);
        let memory = PiMemory {
            log2_last_error: log2_error.max(approx_log2(MIN_REMEMBERED_ERROR)),
            max_factor: self.factor_bounds.1,
        };
        let factor = factor.max(self.factor_bounds.0).min(last.max_factor);
        (factor, memory)
    }

    /// Returns the ratio of the retried step size to the rejected one, and limits the step after the retry to the size
    /// of the retried step. `error` is the error norm of the rejected step, above 1 or not finite.
    #[cold]
    pub(crate) fn after_rejected(&self, memory: &mut PiMemory, error: f64) -> f64 {
        memory.max_factor = 1.0;
        if error.is_finite() {
            (SAFETY * error.powf(-self.proportional_exponent)).max(self.factor_bounds.0)
        } else {
            0.1
        }
    }
}

/// Initial step size by estimates of the first two derivatives (Hairer, Nørsett & Wanner, II.4), up to `max_step`.
pub(crate) fn initial_step<D: OdeRhs>(
    rhs: &mut D,
    t: f64,
    (start, rate): (&D::State, &D::State),
    order: i32,
    tolerance: &ErrorTolerance,
    max_step: f64,
) -> f64 {
    let (x, dx) = (start.as_ref(), rate.as_ref());
    let n = x.len().min(tolerance.controlled_len);
    let norm = |of: &dyn Fn(usize) -> f64| {
        let square = |i: usize| (of(i) / tolerance.scale(x[i], x[i])).powi(2);
        ((0..n).map(square).sum::<f64>() / n as f64).sqrt()
    };
    let state_norm = norm(&|i| x[i]);
    let rate_norm = norm(&|i| dx[i]);
    let euler_step = first_step(state_norm, rate_norm, max_step);

    let (mut euler_state, mut euler_rate) = (start.clone(), rate.clone());
    let k = std::slice::from_ref(rate);
    combine(&mut euler_state, start, euler_step, &[(0, 1.0)], k);
    rhs.derivative(t + euler_step, &euler_state, &mut euler_rate);
    let euler_rate = euler_rate.as_ref();
    let second_derivative_norm = norm(&|i| euler_rate[i] - dx[i]) / euler_step;
    second_step(
        euler_step,
        rate_norm,
        second_derivative_norm,
        order,
        max_step,
    )
}

/// Size of the trial Euler step after which the second derivative of the state is estimated: 0.01 times the ratio of
/// the state norm to the derivative norm, or 1e-6 if either norm is below 1e-5; limited to `max_step`.
#[inline(always)]
pub(crate) fn first_step(state_norm: f64, rate_norm: f64, max_step: f64) -> f64 {
    if state_norm < 1e-5 || rate_norm < 1e-5 {
        1e-6
    } else {
        0.01 * state_norm / rate_norm
    }
    .min(max_step)
}

/// Initial step size from norms of the first two derivatives, up to 100 times the Euler step and `max_step`.
#[inline(always)]
pub(crate) fn second_step(
    euler_step: f64,
    first_derivative: f64,
    second_derivative: f64,
    order: i32,
    max_step: f64,
) -> f64 {
    let derivative_norm = first_derivative.max(second_derivative);
    let step = if derivative_norm <= 1e-15 {
        (euler_step * 1e-3).max(1e-6)
    } else {
        (0.01 / derivative_norm).powf(1.0 / f64::from(order))
    };
    // A derivative that is not finite one Euler step ahead gives no information on the second derivative.
    if step.is_finite() {
        step.min(100.0 * euler_step).min(max_step)
    } else {
        euler_step
    }
}

/// 1.5 · 2^52: adding it rounds a number below 2^51 to an integer, whose bits are the low bits of the sum.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// Base-2 logarithm of a positive number with an absolute error below 0.01, which suffices for a step size.
#[inline(always)]
fn approx_log2(x: f64) -> f64 {
    let bits = x.to_bits();
    // The exponent as the low bits of a number just above 2^52: vectors of integers need not be converted.
    let exponent = f64::from_bits(bits >> 52 | 1075 << 52) - (4_503_599_627_370_496.0 + 1023.0);
    let m = f64::from_bits(bits & ((1 << 52) - 1) | 1023 << 52) - 1.0;
    exponent + m * (1.0 + (1.0 - m) * 0.3431)
}

/// 2^y with a relative error below 1 %; y is clamped to ±1000.
// `clamp` may panic, a branch that keeps loops from becoming vector instructions.
#[allow(clippy::manual_clamp)]
#[inline(always)]
fn approx_exp2(y: f64) -> f64 {
    let y = y.max(-1000.0).min(1000.0);
    let rounded = (y - 0.5) + ROUND;
    let part = y - (rounded - ROUND);
    let power = f64::from_bits(rounded.to_bits().wrapping_add(1023) << 52);
    power * (1.0 + part * (1.0 - 0.3431 * (1.0 - part)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn approximate_powers_are_within_their_bounds() {
        for i in 1..2000 {
            let x = 1.013_f64.powi(i - 1000);
            assert!((approx_log2(x) - x.log2()).abs() < 0.01, "{x}");
            let y = f64::from(i - 1000) * 0.01;
            assert!((approx_exp2(y) / y.exp2() - 1.0).abs() < 0.01, "{y}");
        }
    }
}
