//! Loads that no law gives, weighed along a flight: where a load vanishes, what it does to a flight is what its constant does,
//! times its weight at each moment.

use std::borrow::Cow;

use flight::{BoundModel, DifferentiableModelRhs};
use ode::DifferentiableRhs;

/// Equations of motion whose constants are those of a model, and behind them weighed ones.
pub struct Weighted<'a, W> {
    motion: DifferentiableModelRhs<'a>,
    pattern: Vec<(usize, usize)>,
    /// Entry of the load, and weight, of each entry behind the model's own.
    sources: Vec<(usize, usize)>,
    local: usize,
    weigh: W,
    weights: Vec<f64>,
}

impl<'a, W: FnMut(f64, &[f64], &mut [f64])> Weighted<'a, W> {
    /// The equations of motion of a body in the conditions of one flight. From `first` on its constants are those that `loads` names by
    /// their place in the layout, each weighed by what `weigh` writes for it at a time (s) and a state.
    pub fn new(conditions: &'a BoundModel<'a>, loads: &[usize], first: usize, weigh: W) -> Self {
        let motion = conditions.differentiable_rhs();
        let mut pattern = motion.parameter_jacobian_pattern().to_vec();
        let local = pattern.len();
        let mut sources = Vec::new();
        for (index, place) in loads.iter().enumerate() {
            for entry in 0..local {
                let (row, column) = pattern[entry];
                if column == *place {
                    pattern.push((row, first + index));
                    sources.push((entry, index));
                }
            }
        }
        Self {
            motion,
            pattern,
            sources,
            local,
            weigh,
            weights: vec![0.0; loads.len()],
        }
    }
}

impl<W: FnMut(f64, &[f64], &mut [f64])> DifferentiableRhs for Weighted<'_, W> {
    fn states(&self) -> usize {
        self.motion.states()
    }

    fn jacobian_pattern(&self) -> &[(usize, usize)] {
        self.motion.jacobian_pattern()
    }

    fn parameter_jacobian_pattern(&self) -> &[(usize, usize)] {
        &self.pattern
    }

    fn derivative_with_jacobians(
        &mut self,
        t: f64,
        x: &[f64],
        dx: &mut [f64],
        by_state: &mut [f64],
        by_constant: &mut [f64],
    ) {
        let (local, weighed) = by_constant.split_at_mut(self.local);
        self.motion
            .derivative_with_jacobians(t, x, dx, by_state, local);
        (self.weigh)(t, x, &mut self.weights);
        for (to, &(entry, index)) in weighed.iter_mut().zip(&self.sources) {
            *to = local[entry] * self.weights[index];
        }
    }

    fn state_name(&self, state: usize) -> Cow<'_, str> {
        self.motion.state_name(state)
    }
}
