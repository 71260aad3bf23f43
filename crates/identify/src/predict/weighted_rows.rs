//! Weighting or whitening of the Jacobian rows of residuals, and their summation to normal equations.

use model_spec::layout::StateId;
use nalgebra::DVector;

use super::{FlightAt, Loss};
use crate::channel::Channel;
use crate::least_squares::{GramAccumulator, NormalBlock};
use crate::noise::{AxesNoise, HUBER_LIMIT};
use crate::observations::Observations;
use crate::problem::{StatePrior, wide_deviation};

/// What weighted rows are added to.
pub(super) trait RowSum {
    /// Column index of the residual in a row.
    fn residual(&self) -> usize;
    /// As [`GramAccumulator::add`].
    fn add(&mut self, row: &[f64], before: Option<(f64, &[f64])>, scale: f64, extra: f64);
}

impl RowSum for GramAccumulator {
    fn residual(&self) -> usize {
        self.residual()
    }

    fn add(&mut self, row: &[f64], before: Option<(f64, &[f64])>, scale: f64, extra: f64) {
        self.add(row, before, scale, extra);
    }
}

/// Accumulates normal equations from rows that it weights by the loss; the previous rows serve AR(1) innovations.
pub(super) struct WeightedRows<'a, S = GramAccumulator> {
    /// What the weighted rows are added to, and which gives the normal equations.
    pub accumulator: S,
    loss: Loss<'a>,
    channels: &'a [Channel],
    /// Autocorrelation over one interval, and weight of the innovation, 1/m, by channel and axis.
    one_interval: Vec<[(f64, f64); 3]>,
    /// Time (s) and rows of the previous value of each channel; `None` before the first.
    previous: Vec<Option<(f64, [Vec<f64>; 3])>>,
}

impl<'a, S: RowSum> WeightedRows<'a, S> {
    pub fn new(accumulator: S, channels: &'a [Channel], loss: Loss<'a>) -> Self {
        let one_interval = match loss {
            Loss::Huber(_) => Vec::new(),
            Loss::Whitened(noise) => (0..channels.len())
                .map(|channel| innovations(noise.of(channel), Some(noise.of(channel).interval)))
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

    /// Adds the residual (m) of a channel at `time` (s); `now` contains its derivatives and may be overwritten.
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
            Loss::Whitened(noise) => {
                let (previous, noise) = (&mut self.previous[channel], noise.of(channel));
                let gap = previous.as_ref().map(|(earlier, _)| time - earlier);
                let innovations = match gap {
                    Some(gap) if noise.is_one_interval(gap) => self.one_interval[channel],
                    gap => innovations(noise, gap),
                };
                for (axis, (kept, weight)) in innovations.into_iter().enumerate().take(components) {
                    let before = previous.as_ref().map(|(_, rows)| (kept, &rows[axis][..]));
                    self.accumulator.add(&now[axis], before, weight, 0.0);
                }
                match previous {
                    // The rows of the previous sample will be overwritten by the next residual.
                    Some((earlier, before)) => {
                        *earlier = time;
                        std::mem::swap(before, now);
                    }
                    none => *none = Some((time, now.clone())),
                }
            }
        }
    }
}

/// Autocorrelation over the time difference `gap` (s), and weight of the innovation (1/m), along each axis.
fn innovations(noise: &AxesNoise, gap: Option<f64>) -> [(f64, f64); 3] {
    [0, 1, 2].map(|axis| {
        let (phi, sigma) = noise.innovation(axis, gap);
        (phi, 1.0 / sigma)
    })
}

// Weak priors of an initial state for flights without measured positions, which leave position and heading open.

/// Adds the priors of a flight's own unknowns to its normal equations: weak ones of the initial state where no positions
/// are measured, and those of unknown or measured states.
pub(super) fn add_priors(at: FlightAt<'_>, block: &mut NormalBlock) {
    if !at.problem.sees_positions() && !at.observations.is_summary {
        let states = at.problem.model.states.iter().enumerate();
        let weak = states.map(|(state, own)| StatePrior {
            state: StateId::new(state),
            mean: 0.0,
            sigma: wide_deviation(&own.unit_text),
            is_measured: false,
        });
        add_all(at.observations, at.local, block, weak);
    }
    add_state_priors(at.observations, at.local, block);
}

/// Adds the priors of the unknown or measured states of a flight to its normal equations.
pub(crate) fn add_state_priors(
    observations: &Observations,
    local: &DVector<f64>,
    block: &mut NormalBlock,
) {
    add_all(
        observations,
        local,
        block,
        observations.state_priors.iter().copied(),
    );
}

/// Adds priors, which do not count as residuals.
fn add_all(
    observations: &Observations,
    local: &DVector<f64>,
    block: &mut NormalBlock,
    priors: impl Iterator<Item = StatePrior>,
) {
    let tangent = observations.manifold.tangent(local.as_slice());
    let none = DVector::zeros(block.global.nrows());
    let count = block.count;
    for StatePrior {
        state, mean, sigma, ..
    } in priors
    {
        let state = state.index();
        let mut by_local = DVector::zeros(block.local.nrows());
        let own = tangent.iter().filter(|(of, ..)| *of == state);
        for &(_, direction, value) in own.clone() {
            // Without derivatives, the block has no local parameters.
            if let Some(by_local) = by_local.get_mut(direction) {
                *by_local = value / sigma;
            }
        }
        if own.clone().any(|(.., value)| *value != 0.0) {
            block.add((local[state] - mean) / sigma, &by_local, &none);
        }
    }
    block.count = count;
}
