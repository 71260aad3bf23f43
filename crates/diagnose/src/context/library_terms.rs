//! The terms of a term library in a model: each product of variables on each load channel. A term is tested without a
//! model that contains it: at its null value, its sensitivity is that to the load coefficient, times its product.

use std::sync::Arc;

use flight::{BasisLoads, BoundModel};
use model_spec::compose::EffectTree;
use model_spec::index::IndexVec;
use model_spec::layout::{Layout, ParamId, QuantityId};
use model_spec::term_library::{ChannelId, Term, TermLibrary, VariableId};
use ode::DifferentiableRhs;

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
        let loads = terms.map(|term| self.loads[term.channel]).zip(first..);
        let loads: Vec<(ParamId, usize)> = loads.collect();
        let factors: Vec<Vec<(usize, i32)>> = self.terms.iter().map(|t| self.factors(*t)).collect();
        let mut observer = conditions.observer();
        let mut values = vec![0.0; self.variables.len()];
        BasisLoads::new(conditions, &loads, move |t, x, products: &mut [f64]| {
            let quantities = observer.quantities(t, x);
            for (value, variable) in values.iter_mut().zip(self.variables.iter()) {
                *value = quantities[variable.index()];
            }
            for (product, factors) in products.iter_mut().zip(&factors) {
                let each = factors.iter();
                *product = each.map(|&(v, power)| values[v].powi(power)).product();
            }
        })
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
