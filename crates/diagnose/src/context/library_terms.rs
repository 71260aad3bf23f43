//! The terms of a term library in a model: each product of variables on each load channel. A term is tested without a
//! model that contains it: at its null value, its sensitivity is that to the load coefficient, times its product.

use std::borrow::Cow;
use std::sync::Arc;

use flight::{BoundModel, ModelRhs};
use model_spec::compose::EffectTree;
use model_spec::index::IndexVec;
use model_spec::layout::{Layout, ParamId, QuantityId};
use model_spec::term_library::{ChannelId, Term, TermLibrary, VariableId};
use ode::{DifferentiableRhs, Projection};

use super::columns::TermId;

/// All terms of a term library, with the model's indices of their load coefficients and variables.
#[derive(Clone, Debug)]
pub(crate) struct LibraryTerms {
    /// The term library: variables, products of their powers, and the quantities to which the products can be added.
    library: Arc<TermLibrary>,
    /// The terms by load channel: all products for the first, then all for the second, and so on.
    pub terms: IndexVec<TermId, Term>,
    /// For each load channel: index of the parameter that scales the load in the model.
    pub loads: IndexVec<ChannelId, ParamId>,
    /// Quantity index of each variable; variables are auxiliary quantities of the model.
    variables: IndexVec<VariableId, QuantityId>,
}

impl LibraryTerms {
    /// Terms of `library` for a model; `None` if it lacks a load coefficient or a variable.
    pub fn new(library: Arc<TermLibrary>, layout: &Layout) -> Option<Self> {
        let loads = library.channels.iter();
        let loads = loads.map(|channel| layout.parameter(&channel.coefficient));
        let variables = library.variables.iter();
        let variables = variables.map(|variable| layout.quantity(&variable.quantity));
        Some(Self {
            loads: loads.collect::<Option<Vec<_>>>()?.into(),
            variables: variables.collect::<Option<Vec<_>>>()?.into(),
            terms: library.terms().collect(),
            library,
        })
    }

    /// Equations of motion with one more parameter for each term, with indices from `first` on.
    pub fn motion<'a>(
        &'a self,
        conditions: &'a BoundModel<'a>,
        first: usize,
    ) -> impl DifferentiableRhs + use<'a> {
        let terms = self.terms.iter();
        let loads: Vec<ParamId> = terms.map(|term| self.loads[term.channel]).collect();
        let factors: Vec<Vec<(usize, i32)>> = self.terms.iter().map(|t| self.factors(*t)).collect();
        let mut observer = conditions.observer();
        let mut values = vec![0.0; self.variables.len()];
        BasisLoads::new(
            conditions,
            &loads,
            first,
            move |t, x, products: &mut [f64]| {
                let quantities = observer.quantities(t, x);
                for (value, variable) in values.iter_mut().zip(self.variables.iter()) {
                    *value = quantities[variable.index()];
                }
                for (product, factors) in products.iter_mut().zip(&factors) {
                    let each = factors.iter();
                    *product = each.map(|&(v, power)| values[v].powi(power)).product();
                }
            },
        )
    }

    fn factors(&self, term: Term) -> Vec<(usize, i32)> {
        let factors = self.library.factors(term).iter();
        factors
            .map(|factor| (factor.variable.index(), factor.power))
            .collect()
    }

    pub fn sites(&self) -> impl Iterator<Item = (ChannelId, &str)> {
        let channels = self.library.channels.iter_enumerated();
        channels.map(|(id, channel)| (id, channel.site.as_str()))
    }

    /// Site of a library term: the name of the load (such as lift) to which the term is added.
    pub fn site(&self, term: TermId) -> &str {
        &self.library.channels[self.terms[term].channel].site
    }

    pub fn formula(&self, term: TermId) -> String {
        self.library.formula(self.terms[term])
    }

    /// Display name of a library term, such as `lift-by-alpha-squared`.
    pub fn name(&self, term: TermId) -> String {
        self.library.name(self.terms[term])
    }

    /// The effect that adds a term with one coefficient to the model; `doc` is its doc comment.
    pub fn effect(&self, term: TermId, doc: &str) -> EffectTree {
        self.library.effect(self.terms[term], doc)
    }
}

// Loads multiplied by basis functions of time and state, and the sensitivities to their coefficients.

/// Equations of motion with one more parameter for each basis function: the coefficient `c` of a load `c · basis(t, x)
/// · load`. At `c = 0`, the derivative by `c` is that by the coefficient of `load`, times `basis(t, x)`.
pub(crate) struct BasisLoads<'a, B> {
    motion: ModelRhs<'a>,
    pattern: Vec<(usize, usize)>,
    /// For each further entry of the parameter Jacobian: position in `pattern` of the derivative by the load
    /// coefficient, and the index of its basis function.
    sources: Vec<(usize, usize)>,
    own_entries: usize,
    basis: B,
    values: Vec<f64>,
}

impl<'a, B: FnMut(f64, &[f64], &mut [f64])> BasisLoads<'a, B> {
    /// Adds one parameter for each load coefficient in `loads`, with indices from `first` on. `basis` writes one value
    /// for each, from time (s) and state.
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

    fn projection(&self) -> Option<Projection> {
        DifferentiableRhs::projection(&self.motion)
    }

    fn state_name(&self, state: usize) -> Cow<'_, str> {
        self.motion.state_name(state)
    }
}
