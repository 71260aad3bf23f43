//! How long the next step is.

use crate::dynamics::Dynamics;
use crate::method::{Start, Tolerance, combine};

const SAFETY: f64 = 0.9;

/// Chooses steps by the last two errors (proportional and integral control, Hairer & Wanner IV.2).
pub(crate) struct Control {
    exponent: f64,
    memory: f64,
    factors: (f64, f64),
    /// log2 of the last accepted error.
    last: f64,
    rejected: bool,
}

impl Control {
    pub(crate) fn new(order: i32, memory: f64, factors: (f64, f64)) -> Control {
        let exponent = 1.0 / f64::from(order) - 0.75 * memory;
        Control {
            exponent,
            memory,
            factors,
            last: rough_log2(1e-4),
            rejected: false,
        }
    }

    /// Factor for the next step after one that was accepted with this error.
    #[inline(always)]
    pub(crate) fn accepted(&mut self, error: f64) -> f64 {
        let error = rough_log2(error.max(1e-10));
        let factor = SAFETY * rough_exp2(self.memory * self.last - self.exponent * error);
        self.last = error.max(rough_log2(1e-4));
        let greatest = if std::mem::take(&mut self.rejected) {
            1.0
        } else {
            self.factors.1
        };
        factor.clamp(self.factors.0, greatest)
    }

    /// Factor for another trial after one with this error.
    #[cold]
    pub(crate) fn rejected(&mut self, error: f64) -> f64 {
        self.rejected = true;
        if error.is_finite() {
            (SAFETY * error.powf(-self.exponent)).max(self.factors.0)
        } else {
            0.1
        }
    }
}

/// A first step by the size of the first and second derivatives (Hairer, Nørsett & Wanner II.4).
pub(crate) fn first_step<D: Dynamics>(
    d: &mut D,
    start: &Start<'_, D::State>,
    order: i32,
    within: &Tolerance,
    longest: f64,
) -> f64 {
    let (x, dx) = (start.x.as_ref(), start.dx.as_ref());
    let n = x.len().min(within.controlled);
    let norm = |of: &dyn Fn(usize) -> f64| {
        let square = |i: usize| (of(i) / within.scale(x[i], x[i])).powi(2);
        ((0..n).map(square).sum::<f64>() / n as f64).sqrt()
    };
    let size = norm(&|i| x[i]);
    let slope = norm(&|i| dx[i]);
    let trial = if size < 1e-5 || slope < 1e-5 {
        1e-6
    } else {
        0.01 * size / slope
    }
    .min(longest);

    let (mut ahead, mut rate) = (start.x.clone(), start.dx.clone());
    combine(&mut ahead, start.x, trial, [1.0], [start.dx]);
    d.derivative(start.t + trial, &ahead, &mut rate);
    let rate = rate.as_ref();
    let bend = norm(&|i| rate[i] - dx[i]) / trial;
    let greater = slope.max(bend);
    let step = if greater <= 1e-15 {
        (trial * 1e-3).max(1e-6)
    } else {
        (0.01 / greater).powf(1.0 / f64::from(order))
    };
    // Where the model has no answer a little ahead, the trial is as good a guess as any.
    if step.is_finite() {
        step.min(100.0 * trial).min(longest)
    } else {
        trial
    }
}

/// log2 of a positive number, within 0.01: all that the choice of a step needs.
#[inline(always)]
fn rough_log2(x: f64) -> f64 {
    let bits = x.to_bits();
    let exponent = (bits >> 52) as i32 - 1023;
    let m = f64::from_bits(bits & ((1 << 52) - 1) | 1023 << 52) - 1.0;
    f64::from(exponent) + m * (1.0 + (1.0 - m) * 0.3431)
}

/// 2 to a power within ±1000, within 1 %.
#[inline(always)]
fn rough_exp2(y: f64) -> f64 {
    let y = y.clamp(-1000.0, 1000.0);
    let whole = (y + 1000.0) as i64 - 1000;
    let part = y - whole as f64;
    let power = f64::from_bits(((whole + 1023) as u64) << 52);
    power * (1.0 + part * (1.0 - 0.3431 * (1.0 - part)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rough_powers_are_near_enough() {
        for i in 1..2000 {
            let x = 1.013_f64.powi(i - 1000);
            assert!((rough_log2(x) - x.log2()).abs() < 0.01, "{x}");
            let y = f64::from(i - 1000) * 0.01;
            assert!((rough_exp2(y) / y.exp2() - 1.0).abs() < 0.01, "{y}");
        }
    }
}
