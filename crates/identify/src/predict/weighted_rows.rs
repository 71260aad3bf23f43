//! Weighting or whitening of the Jacobian rows of residuals, and their summation to normal equations.

use super::Loss;
use crate::channel::Channel;
use crate::least_squares::GramAccumulator;
use crate::noise::{AxesNoise, HUBER_LIMIT};

/// Accumulates normal equations from rows of derivatives and residuals, which it weights according to the loss. It
/// stores the previous row of each channel for the AR(1) innovations.
pub(super) struct WeightedRows<'a> {
    /// Accumulator to which the weighted rows are added, and which gives the normal equations.
    pub accumulator: GramAccumulator,
    loss: Loss<'a>,
    channels: &'a [Channel],
    /// For each channel and axis: autocorrelation of the noise over one sampling interval, and weight of the innovation
    /// (residual minus its prediction from the previous one), 1/m. Empty for a robust loss.
    one_interval: Vec<[(f64, f64); 3]>,
    /// Time (s) of the previous measured value of each channel, and its Jacobian rows, one per axis: derivatives of the
    /// residual, and the residual itself in the column `accumulator.residual()`. `None` before the first value.
    previous: Vec<Option<(f64, [Vec<f64>; 3])>>,
}

impl<'a> WeightedRows<'a> {
    pub fn new(accumulator: GramAccumulator, channels: &'a [Channel], loss: Loss<'a>) -> Self {
        let one_interval = match loss {
            Loss::Huber(_) => Vec::new(),
            Loss::Whitened(noise) => (0..channels.len())
                .map(|channel| innovations(noise.of(channel), noise.of(channel).interval))
                .collect(),
        };
        Self {
            accumulator,
            loss,
            channels,
            one_interval,
            previous: vec![None; channels.len()],
        }
    }

    /// Adds the residual (m) of a channel at the time `time` (s). `now` contains the derivatives of the residual, one
    /// row per axis, and may be overwritten.
    pub fn add(&mut self, channel: usize, time: f64, now: &mut [Vec<f64>; 3], residual: [f64; 3]) {
        let at = self.accumulator.residual();
        let components = self.channels[channel].components;
        for (row, residual) in now.iter_mut().zip(residual) {
            row[at] = residual;
        }
        match self.loss {
            Loss::Huber(scale) => {
                // The loss is a function of the vector's magnitude, not of each component.
                let residual = &residual[..components];
                let size = residual.iter().map(|r| r * r).sum::<f64>().sqrt() / scale;
                let limit = HUBER_LIMIT * (components as f64).sqrt();
                let weight = if size > limit { limit / size } else { 1.0 };
                // Difference between the loss and the weighted sum of squares.
                let extra = (weight * size * size - limit * limit).max(0.0);
                for (axis, row) in now.iter().take(components).enumerate() {
                    let extra = if axis == 0 { extra } else { 0.0 };
                    self.accumulator
                        .add(row, None, weight.sqrt() / scale, extra);
                }
            }
            Loss::Whitened(noise) => match &mut self.previous[channel] {
                Some((earlier, before)) => {
                    let gap = time - *earlier;
                    let noise = noise.of(channel);
                    let innovations = match noise.is_one_interval(gap) {
                        true => self.one_interval[channel],
                        false => innovations(noise, gap),
                    };
                    let pairs = now.iter().zip(&*before).take(components);
                    for ((now, before), (kept, weight)) in pairs.zip(innovations) {
                        self.accumulator.add(now, Some((kept, before)), weight, 0.0);
                    }
                    // The rows of the previous sample will be overwritten by the next residual.
                    *earlier = time;
                    std::mem::swap(before, now);
                }
                none => {
                    for (now, sigma) in now.iter().zip(noise.of(channel).sigma).take(components) {
                        self.accumulator.add(now, None, 1.0 / sigma, 0.0);
                    }
                    *none = Some((time, now.clone()));
                }
            },
        }
    }
}

/// Autocorrelation of the noise over the time difference `gap` (s), and weight of the innovation (1/m), along each
/// axis.
fn innovations(noise: &AxesNoise, gap: f64) -> [(f64, f64); 3] {
    [0, 1, 2].map(|axis| {
        let (phi, sigma) = noise.innovation(axis, gap);
        (phi, 1.0 / sigma)
    })
}
