//! Rows of residuals, weighed by the noise, on their way to the sums.

use super::Loss;
use crate::least_squares::GramAccumulator;
use crate::noise::{HUBER, NoiseModel};

/// Rows being summed, with the last row of each marker.
pub(super) struct WeightedRows<'a> {
    /// What was summed.
    pub rows: GramAccumulator,
    loss: Loss<'a>,
    /// What a residual keeps along each axis of one that is an interval earlier, and how its rest is weighed, 1/m.
    usual: [(f64, f64); 3],
    /// Time and rows of the last time that each marker was seen.
    before: Vec<Option<(f64, [Vec<f64>; 3])>>,
}

impl<'a> WeightedRows<'a> {
    pub fn new(rows: GramAccumulator, markers: usize, loss: Loss<'a>) -> Self {
        let usual = match loss {
            Loss::Huber(_) => [(0.0, 0.0); 3],
            Loss::Whitened(noise) => innovations(noise, noise.interval),
        };
        Self {
            rows,
            loss,
            usual,
            before: vec![None; markers],
        }
    }

    /// Adds the residual of a marker (m) with its derivatives, at a time (s).
    pub fn add(&mut self, marker: usize, time: f64, now: &mut [Vec<f64>; 3], residual: [f64; 3]) {
        let at = self.rows.residual();
        for (row, residual) in now.iter_mut().zip(residual) {
            row[at] = residual;
        }
        match self.loss {
            Loss::Huber(scale) => {
                // An outlier is one of a point, not of an axis.
                let size = residual.iter().map(|r| r * r).sum::<f64>().sqrt() / scale;
                let limit = HUBER * 3.0_f64.sqrt();
                let weight = if size > limit { limit / size } else { 1.0 };
                // What the loss has beyond the weighted square.
                let extra = (weight * size * size - limit * limit).max(0.0);
                for (axis, row) in now.iter().enumerate() {
                    let extra = if axis == 0 { extra } else { 0.0 };
                    self.rows.add(row, None, weight.sqrt() / scale, extra);
                }
            }
            Loss::Whitened(noise) => match &mut self.before[marker] {
                Some((earlier, before)) => {
                    let gap = time - *earlier;
                    let innovations = match noise.is_one_interval(gap) {
                        true => self.usual,
                        false => innovations(noise, gap),
                    };
                    for ((now, before), (kept, weight)) in now.iter().zip(&*before).zip(innovations)
                    {
                        self.rows.add(now, Some((kept, before)), weight, 0.0);
                    }
                    // The rows of before are written anew for the next residual.
                    *earlier = time;
                    std::mem::swap(before, now);
                }
                none => {
                    for (now, sigma) in now.iter().zip(noise.sigma) {
                        self.rows.add(now, None, 1.0 / sigma, 0.0);
                    }
                    *none = Some((time, now.clone()));
                }
            },
        }
    }
}

/// What a residual keeps along each axis of one that is so much earlier (s), and how its rest is weighed, 1/m.
fn innovations(noise: &NoiseModel, gap: f64) -> [(f64, f64); 3] {
    [0, 1, 2].map(|axis| {
        let (kept, fresh) = noise.innovation(axis, gap);
        (kept, 1.0 / fresh)
    })
}
