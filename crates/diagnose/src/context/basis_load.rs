//! Loads multiplied by basis functions of time and state, and the sensitivities to their coefficients.

use std::borrow::Cow;

use flight::{BoundModel, ModelRhs};
use model_spec::layout::ParamId;
use ode::DifferentiableRhs;

/// Equations of motion whose parameters are those of a model, followed by one coefficient for each basis function.
///
/// Each additional parameter is the coefficient `c` of a force or moment component `c · basis(t, x) · load`. At
/// `c = 0`, the derivative of the right-hand side with respect to `c` is its derivative with respect to the coefficient
/// of `load`, times `basis(t, x)`.
pub(crate) struct BasisLoads<'a, B> {
    motion: ModelRhs<'a>,
    pattern: Vec<(usize, usize)>,
    /// For each nonzero entry that the basis functions add to the parameter Jacobian: position in `pattern` of the
    /// model's entry that is the derivative with respect to the load coefficient, and index of the basis function by
    /// which this entry is multiplied.
    sources: Vec<(usize, usize)>,
    own_entries: usize,
    basis: B,
    values: Vec<f64>,
}

impl<'a, B: FnMut(f64, &[f64], &mut [f64])> BasisLoads<'a, B> {
    /// Extends the equations of motion `conditions` by one parameter for each load coefficient (of a force or moment
    /// component) in `loads`, with indices from `first` on. `basis` is called with the time in s and the state, and
    /// writes one basis function value for each of `loads`.
    pub fn new(conditions: &'a BoundModel<'a>, loads: &[ParamId], first: usize, basis: B) -> Self {
        let motion = conditions.rhs();
        let mut pattern = motion.parameter_jacobian_pattern().to_vec();
        let own_entries = pattern.len();
        let mut sources = Vec::new();
        for (index, load) in loads.iter().enumerate() {
            for entry in 0..own_entries {
                let (row, column) = pattern[entry];
                if column == load.index() {
                    pattern.push((row, first + index));
                    sources.push((entry, index));
                }
            }
        }
        Self {
            motion,
            pattern,
            sources,
            own_entries,
            basis,
            values: vec![0.0; loads.len()],
        }
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

    fn state_name(&self, state: usize) -> Cow<'_, str> {
        self.motion.state_name(state)
    }
}
