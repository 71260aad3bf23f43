//! The terms of a term library in a model: each product of variables on each load.
//!
//! A term is tested without a model of its own: at its null value its sensitivity is that of its load, times the product of
//! its variables along the trajectory.

use flight::BoundModel;
use model_spec::index::IndexVec;
use model_spec::layout::{Layout, ParamId, QuantityId};
use ode::DifferentiableRhs;

use super::basis_load::BasisLoads;
use super::candidates::identifier;
use super::ids::TermId;
use super::term_library::TermLibrary;

/// A product of variables on a load.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Term {
    /// Index of its load in the library.
    pub load: usize,
    /// Its factors: index of the variable in the library, and power.
    pub product: &'static [(usize, i32)],
}

/// All terms of a library, with the parameters and quantities of a model that they are made of.
#[derive(Clone, Debug)]
pub(crate) struct LibraryTerms {
    /// The library.
    pub library: TermLibrary,
    /// The terms: all products on the first load, then on the second, ….
    pub terms: IndexVec<TermId, Term>,
    /// Coefficient of each load.
    pub loads: Vec<ParamId>,
    /// Auxiliary quantity of each variable.
    variables: Vec<QuantityId>,
}

impl LibraryTerms {
    /// The terms in a model that has the library's loads; none if its layout lacks one of their names.
    pub fn new(library: TermLibrary, layout: &Layout) -> Option<Self> {
        let loads = library.loads.iter();
        let variables = library.variables.iter();
        let terms = (0..library.loads.len()).flat_map(|load| {
            let products = library.products.iter();
            products.map(move |product| Term { load, product })
        });
        Some(Self {
            loads: loads
                .map(|(name, ..)| layout.parameter(name))
                .collect::<Option<_>>()?,
            variables: variables
                .map(|variable| layout.quantity(variable.quantity))
                .collect::<Option<_>>()?,
            terms: terms.collect(),
            library,
        })
    }

    /// Equations of motion under the conditions of one flight, with the terms' coefficients as parameters from `first` on.
    pub fn motion<'a>(
        &'a self,
        conditions: &'a BoundModel<'a>,
        first: usize,
    ) -> impl DifferentiableRhs + use<'a> {
        let loads: Vec<ParamId> = self.terms.iter().map(|t| self.loads[t.load]).collect();
        let mut observer = conditions.observer();
        let mut values = vec![0.0; self.variables.len()];
        BasisLoads::new(
            conditions,
            &loads,
            first,
            move |t, x, products: &mut [f64]| {
                let quantities = observer.quantities(t, x);
                for (value, variable) in values.iter_mut().zip(&self.variables) {
                    *value = quantities[variable.index()];
                }
                for (product, term) in products.iter_mut().zip(self.terms.iter()) {
                    let factors = term.product.iter();
                    *product = factors.map(|&(v, power)| values[v].powi(power)).product();
                }
            },
        )
    }

    /// Where each load acts, in the library's order.
    pub fn sites(&self) -> impl Iterator<Item = &'static str> {
        self.library.loads.iter().map(|(_, site, _)| *site)
    }

    /// Where a term acts.
    pub fn site(&self, term: TermId) -> &'static str {
        self.library.loads[self.terms[term].load].1
    }

    /// The product of a term in the model language.
    pub fn formula(&self, term: TermId) -> String {
        let factor = |&(variable, power): &(usize, i32)| {
            let formula = self.library.variables[variable].formula;
            match power {
                1 => formula.to_owned(),
                _ => format!("({formula})^{power}"),
            }
        };
        let factors: Vec<String> = self.terms[term].product.iter().map(factor).collect();
        match factors.is_empty() {
            true => "1".to_owned(),
            false => factors.join("*"),
        }
    }

    /// Names of what a term depends on, as in the `variables` of an effect.
    fn words(&self, term: TermId) -> Vec<&'static str> {
        let mut words: Vec<&str> = Vec::new();
        for (variable, _) in self.terms[term].product {
            let word = self.library.variables[*variable].word;
            if !words.contains(&word) {
                words.push(word);
            }
        }
        words
    }

    /// The display name of a term, such as `lift-by-alpha-squared`.
    pub fn name(&self, term: TermId) -> String {
        let of = |&(variable, power): &(usize, i32)| {
            let quantity = self.library.variables[variable].quantity;
            let short = quantity.trim_start_matches("on_").replace('_', "-");
            match power {
                1 => short,
                2 => format!("{short}-squared"),
                _ => format!("{short}-cubed"),
            }
        };
        let factors: Vec<String> = self.terms[term].product.iter().map(of).collect();
        let site = match self.library.loads[self.terms[term].load].0 {
            "X_spin" if self.library.loads.len() == 4 => "lift-across-spin",
            _ => self.site(term),
        };
        match factors.is_empty() {
            true => format!("constant-{site}"),
            false => format!("{site}-by-{}", factors.join("-and-")),
        }
    }

    /// The text of an effect with one coefficient for a term; `doc` is its doc comment.
    pub fn effect(&self, term: TermId, doc: &str) -> String {
        let name = identifier(&self.name(term));
        let (_, site, statement) = self.library.loads[self.terms[term].load];
        let coefficient = format!("k_{name}");
        let formula = self.formula(term);
        let value = match formula.as_str() {
            "1" => coefficient.clone(),
            _ => format!("{coefficient}*{formula}"),
        };
        let statement = statement.replace("TERM", &value).replace("NAME", &name);
        let words = self.words(term);
        let variables = match words.is_empty() {
            true => "none".to_owned(),
            false => words.join(", "),
        };
        let doc: String = doc.lines().map(|line| format!("/// {line}\n")).collect();
        format!(
            "{doc}effect {name} {{\n  source \"found in measured flights\";\n  site {site};\n  variables {variables};\n  \
             /// found in measured flights\n  coefficient {coefficient} = 0 [1];\n  {statement}\n}}\n"
        )
    }
}
