//! The terms of a term library in a model: each product of variables on each load channel.
//!
//! A term is tested without compiling a model that contains it: at its null value, the sensitivity to its coefficient
//! is the sensitivity to its load coefficient, times the product of its variables along the trajectory.

use std::sync::Arc;

use flight::BoundModel;
use model_spec::compose::EffectTree;
use model_spec::index::IndexVec;
use model_spec::layout::{Layout, ParamId, QuantityId};
use model_spec::term_library::{ChannelId, Term, TermLibrary, VariableId};
use ode::DifferentiableRhs;

use super::basis_load::BasisLoads;
use super::ids::TermId;

/// All terms of a term library, with the model's indices of their load coefficients and variables.
#[derive(Clone, Debug)]
pub(crate) struct LibraryTerms {
    /// The term library: variables, products of their powers, and the quantities to which the products can be added.
    library: Arc<TermLibrary>,
    /// The terms, ordered by load channel, the force or moment component to which they contribute: all products of
    /// variables for the first component, then all products for the second, and so on.
    pub terms: IndexVec<TermId, Term>,
    /// For each load channel: index of the parameter that scales the load in the model.
    pub loads: IndexVec<ChannelId, ParamId>,
    /// Quantity index of each variable; variables are auxiliary quantities of the model.
    variables: IndexVec<VariableId, QuantityId>,
}

impl LibraryTerms {
    /// Creates the terms of the library `library` for the model with the index layout `layout`; `None` if the model
    /// lacks a load coefficient or a variable of the library.
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

    /// Equations of motion under the conditions of one flight, extended by one parameter for the coefficient of each
    /// library term, with indices from `first` on.
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

    /// Factors of the product of variables of a library term: pairs of the index of a variable in the library and the
    /// exponent of the variable.
    fn factors(&self, term: Term) -> Vec<(usize, i32)> {
        let factors = self.library.factors(term).iter();
        factors
            .map(|factor| (factor.variable.index(), factor.power))
            .collect()
    }

    /// The load channels of the library, in the library's order. Each is returned with its site: the name of the load
    /// that is changed, such as lift.
    pub fn sites(&self) -> impl Iterator<Item = (ChannelId, &str)> {
        let channels = self.library.channels.iter_enumerated();
        channels.map(|(id, channel)| (id, channel.site.as_str()))
    }

    /// Site of a library term: the name of the load (such as lift) to which the term is added.
    pub fn site(&self, term: TermId) -> &str {
        &self.library.channels[self.terms[term].channel].site
    }

    /// Formula of the product of variables of a library term, in the model language.
    pub fn formula(&self, term: TermId) -> String {
        self.library.formula(self.terms[term])
    }

    /// Display name of a library term, such as `lift-by-alpha-squared`.
    pub fn name(&self, term: TermId) -> String {
        self.library.name(self.terms[term])
    }

    /// Creates the effect that adds a library term with one coefficient to the model; `doc` is the doc comment of the
    /// effect.
    pub fn effect(&self, term: TermId, doc: &str) -> EffectTree {
        self.library.effect(self.terms[term], doc)
    }
}
