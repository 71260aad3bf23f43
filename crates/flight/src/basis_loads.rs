//! Loads multiplied by basis functions of time and state, and the sensitivities to their coefficients.

use std::borrow::Cow;

use model_spec::layout::ParamId;
use ode::{DifferentiableRhs, Projection, RhsProperties};

use crate::{BoundModel, ModelRhs};

/// Equations of motion with further parameters, coefficients `c` of terms `c · basis(t, x)` that are added to a parameter
/// of the model. At `c = 0`, the derivative by `c` is that by the parameter, times `basis(t, x)`.
pub struct BasisLoads<'a, B> {
    motion: ModelRhs<'a>,
    pattern: Vec<(usize, usize)>,
    /// For each further entry of the parameter Jacobian: position in `pattern` of the derivative by the parameter, and
    /// the index of its basis function.
    sources: Vec<(usize, usize)>,
    own_entries: usize,
    basis: B,
    values: Vec<f64>,
    time_breaks: Vec<f64>,
}

impl<'a, B: FnMut(f64, &[f64], &mut [f64])> BasisLoads<'a, B> {
    /// Adds the terms of `loads`: the parameter that each is added to, and the index of its coefficient, which several
    /// terms may share. `basis` writes the factor of each term, from time (s) and state.
    pub fn new(conditions: &'a BoundModel<'a>, loads: &[(ParamId, usize)], basis: B) -> Self {
        let motion = conditions.rhs();
        let mut pattern = motion.parameter_jacobian_pattern().to_vec();
        let own_entries = pattern.len();
        let mut sources = Vec::new();
        for (index, (load, coefficient)) in loads.iter().enumerate() {
            for entry in 0..own_entries {
                let (row, column) = pattern[entry];
                if column == load.index() {
                    pattern.push((row, *coefficient));
                    sources.push((entry, index));
                }
            }
        }
        Self {
            time_breaks: motion.time_breaks().to_vec(),
            motion,
            pattern,
            sources,
            own_entries,
            basis,
            values: vec![0.0; loads.len()],
        }
    }

    /// Ends steps of the integration at further times, s, at which the basis functions are not smooth.
    #[must_use]
    pub fn with_breaks(mut self, times: impl IntoIterator<Item = f64>) -> Self {
        self.time_breaks.extend(times);
        self.time_breaks.sort_unstable_by(f64::total_cmp);
        self.time_breaks.dedup();
        self
    }
}

impl<B: FnMut(f64, &[f64], &mut [f64])> DifferentiableRhs for BasisLoads<'_, B> {
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
        let (own, basis) = by_constant.split_at_mut(self.own_entries);
        self.motion
            .derivative_with_jacobians(t, x, dx, by_state, own);
        (self.basis)(t, x, &mut self.values);
        for (to, &(entry, index)) in basis.iter_mut().zip(&self.sources) {
            *to = own[entry] * self.values[index];
        }
    }
}

impl<B> RhsProperties for BasisLoads<'_, B> {
    fn projection(&self) -> Option<Projection> {
        self.motion.projection()
    }

    fn time_breaks(&self) -> &[f64] {
        &self.time_breaks
    }

    fn state_name(&self, state: usize) -> Cow<'_, str> {
        self.motion.state_name(state)
    }
}
