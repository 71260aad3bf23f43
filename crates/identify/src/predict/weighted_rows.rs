//! Jacobian rows of residuals, whitened or weighted, and summed to normal equations.

use super::Loss;
use crate::least_squares::GramAccumulator;
use crate::noise::{HUBER_LIMIT, NoiseModel};

/// Accumulator of normal equations from weighted rows; stores each marker's previous row for the AR(1) innovations.
pub(super) struct WeightedRows<'a> {
    /// Accumulated normal equations.
    pub accumulator: GramAccumulator,
    loss: Loss<'a>,
    /// Autocorrelation over one sampling interval and weight of the innovation (1/m), along each axis.
    one_interval: [(f64, f64); 3],
    /// Time and rows of the previous measured sample of each marker.
    previous: Vec<Option<(f64, [Vec<f64>; 3])>>,
}

impl<'a> WeightedRows<'a> {
    pub fn new(accumulator: GramAccumulator, markers: usize, loss: Loss<'a>) -> Self {
        let one_interval = match loss {
            Loss::Huber(_) => [(0.0, 0.0); 3],
            Loss::Whitened(noise) => innovations(noise, noise.interval),
        };
        Self {
            accumulator,
            loss,
            one_interval,
            previous: vec![None; markers],
        }
    }

    /// Adds the residual (m) of a marker at a time (s), with its derivatives.
    pub fn add(&mut self, marker: usize, time: f64, now: &mut [Vec<f64>; 3], residual: [f64; 3]) {
        let at = self.accumulator.residual();
        for (row, residual) in now.iter_mut().zip(residual) {
            row[at] = residual;
        }
        match self.loss {
            Loss::Huber(scale) => {
                // The loss is of a point's distance, not of each axis.
                let size = residual.iter().map(|r| r * r).sum::<f64>().sqrt() / scale;
                let limit = HUBER_LIMIT * 3.0_f64.sqrt();
                let weight = if size > limit { limit / size } else { 1.0 };
                // Difference between the loss and the weighted square.
                let extra = (weight * size * size - limit * limit).max(0.0);
                for (axis, row) in now.iter().enumerate() {
                    let extra = if axis == 0 { extra } else { 0.0 };
                    self.accumulator
                        .add(row, None, weight.sqrt() / scale, extra);
                }
            }
            Loss::Whitened(noise) => match &mut self.previous[marker] {
                Some((earlier, before)) => {
                    let gap = time - *earlier;
                    let innovations = match noise.is_one_interval(gap) {
                        true => self.one_interval,
                        false => innovations(noise, gap),
                    };
                    for ((now, before), (kept, weight)) in now.iter().zip(&*before).zip(innovations)
                    {
                        self.accumulator.add(now, Some((kept, before)), weight, 0.0);
                    }
                    // The rows of the previous sample are overwritten by the next residual.
                    *earlier = time;
                    std::mem::swap(before, now);
                }
                none => {
                    for (now, sigma) in now.iter().zip(noise.sigma) {
                        self.accumulator.add(now, None, 1.0 / sigma, 0.0);
                    }
                    *none = Some((time, now.clone()));
                }
            },
        }
    }
}

/// Autocorrelation over a gap (s) and weight of the innovation (1/m), along each axis.
fn innovations(noise: &NoiseModel, gap: f64) -> [(f64, f64); 3] {
    [0, 1, 2].map(|axis| {
        let (phi, sigma) = noise.innovation(axis, gap);
        (phi, 1.0 / sigma)
    })
}
