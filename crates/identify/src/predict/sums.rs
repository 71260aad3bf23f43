//! Rows of residuals, weighed by the noise, on their way to the sums.

use super::Loss;
use crate::noise::HUBER;
use crate::rows::Rows;

/// Rows being summed, with the last row of each marker.
pub(super) struct Sums<'a> {
    /// What was summed.
    pub rows: Rows,
    loss: Loss<'a>,
    /// Time and rows of the last time that each marker was seen.
    before: Vec<Option<(f64, [Vec<f64>; 3])>>,
}

impl<'a> Sums<'a> {
    pub fn new(rows: Rows, markers: usize, loss: Loss<'a>) -> Self {
        Self {
            rows,
            loss,
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
            Loss::Whitened(noise) => {
                for (axis, row) in now.iter().enumerate() {
                    match &self.before[marker] {
                        Some((earlier, before)) => {
                            let (kept, fresh) = noise.innovation(axis, time - earlier);
                            let before = Some((kept, before[axis].as_slice()));
                            self.rows.add(row, before, 1.0 / fresh, 0.0);
                        }
                        None => self.rows.add(row, None, 1.0 / noise.sigma[axis], 0.0),
                    }
                }
                match &mut self.before[marker] {
                    Some((earlier, before)) => {
                        *earlier = time;
                        for (before, now) in before.iter_mut().zip(now.iter()) {
                            before.copy_from_slice(now);
                        }
                    }
                    none => *none = Some((time, now.clone())),
                }
            }
        }
    }
}
