//! Term libraries (as in SINDy): candidate terms, each a product of flight variables that acts on one component of the
//! aerodynamic loads, for model errors that no known effect explains.
//!
//! A built-in library is a TOML file in `model-spec/term_libraries` with these keys:
//! - `loads`: an effect that declares one dimensionless coefficient per channel and one auxiliary variable per
//!   variable;
//! - `variables`: for each variable its `quantity`, its `name` as used in names of terms, and the word that states what
//!   an effect with this variable `depends_on`;
//! - `products`: for each product the list of the names of its factors; a power is a repeated name, and the constant 1
//!   is an empty list;
//! - `channels`: for each channel its `coefficient`, its `name` as used in names of terms, and the effect of a `term`,
//!   in which `NAME` and `TERM` are placeholders.
//!
//! For a model that is compatible with no built-in library, a library is generated from the model's own quantities.
//!
//! ```
//! use model_spec::compose::ModelTree;
//! use model_spec::term_library::TermLibrary;
//!
//! let disc = ModelTree::load("disc")?;
//! let (library, with_loads) = TermLibrary::for_model(&disc.check()?).expect("the disc has one");
//! assert_eq!(with_loads.check()?.effects[0].name, library.loads.name());
//!
//! let term = library.terms().find(|&term| library.name(term) == "drag-by-alpha").expect("a term");
//! let effect = library.effect(term, "Found.");
//! assert_eq!(disc.with(&effect)?.check()?.effects[0].site, "drag");
//! # Ok::<(), model_spec::LoadError>(())
//! ```

mod generated;

use std::sync::{Arc, LazyLock};

use serde::Deserialize;
use thiserror::Error;

use crate::compose::{EffectTree, ModelTree};
use crate::index::IndexVec;
use crate::index_type;
use crate::location::Span;
use crate::model::Model;
use crate::read::{LoadError, TERM_LIBRARIES};
use crate::syntax::ast::{
    BinaryOp, Effect, EffectPart, Expr, ExprKind, Item, ItemKind, Name, Parameter, ParameterClass,
    Quantity, UnitExpr,
};
use crate::syntax::of_kind;

/// Stands for the literature reference of a candidate term.
const FOUND_IN_FLIGHTS: &str = "found in measured flights";

index_type!(
    /// Index into [`TermLibrary::channels`], the quantities to which a term can be added.
    pub struct ChannelId;
);

index_type!(
    /// Index into [`TermLibrary::variables`], whose powers are the factors of terms.
    pub struct VariableId;
);

index_type!(
    /// Index into [`TermLibrary::products`], the products of powers of variables.
    pub struct ProductId;
);

/// Library of candidates for terms that a model lacks: a coefficient times a product, added to a channel.
#[derive(Clone, Debug)]
pub struct TermLibrary {
    /// Effect that adds a constant term to each channel, and declares variables that the model lacks.
    pub loads: EffectTree,
    /// Quantities to which a term can be added: components of forces and moments, or derivatives of states.
    pub channels: IndexVec<ChannelId, Channel>,
    /// Variables that describe the state of a flight, whose powers are the factors of the products.
    pub variables: IndexVec<VariableId, Variable>,
    /// Products of powers of variables; the empty product is the constant 1.
    pub products: IndexVec<ProductId, Vec<Factor>>,
}

/// Component of a force or moment (such as drag), or derivative of a state, to which a term can be added.
#[derive(Clone, Debug)]
pub struct Channel {
    /// Name of the coefficient of the constant term in [`TermLibrary::loads`].
    pub coefficient: String,
    /// Name of the quantity in names of terms, such as `drag` in `drag-by-alpha-squared`.
    pub name: String,
    /// Component of the model that a term added to this quantity changes: one of [`SITES`](crate::SITES).
    pub site: String,
    /// Effect that adds a term, with the placeholders `NAME` and `TERM`.
    template: Effect,
}

/// A variable that describes the state of a flight, such as the angle of attack.
#[derive(Clone, Debug)]
pub struct Variable {
    /// Name of the auxiliary variable or state that holds the value, in the model or in [`TermLibrary::loads`].
    pub quantity: String,
    /// Name of the variable in names of terms, such as `alpha` in `drag-by-alpha-squared`.
    pub name: String,
    /// Kind of quantity that the variable is, such as `speed`: one of [`VARIABLES`](crate::VARIABLES).
    pub depends_on: String,
    /// Definition of the variable as source text in the notation of model files.
    pub formula: String,
    /// Definition of the variable as syntax tree.
    value: Expr,
}

/// An integer power of a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Factor {
    /// Index of the variable that is raised to the power.
    pub variable: VariableId,
    /// Exponent, at least 1.
    pub power: i32,
}

/// Candidate for a missing term: coefficient times product of variables, added to a load or to a state's derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Term {
    /// Channel to which the term is added.
    pub channel: ChannelId,
    /// Index of the product of variables by which the coefficient is multiplied.
    pub product: ProductId,
}

/// Error of parsing a term library.
#[derive(Clone, Debug, Error)]
pub enum TermLibraryError {
    /// The text is not valid TOML or does not have the structure of a term library.
    #[error("{name}: {error}")]
    Form {
        /// Name of the library, as passed to [`TermLibrary::parse`].
        name: String,
        /// Error of the TOML reader.
        error: toml::de::Error,
    },
    /// An effect in the library has errors.
    #[error(transparent)]
    Effect(#[from] LoadError),
    /// A product has a factor that is not the name of a variable.
    #[error("{name}: a product has the factor `{factor}`, which is not the name of a variable")]
    UnknownVariable {
        /// Name of the library, as passed to [`TermLibrary::parse`].
        name: String,
        /// Name of the unknown factor.
        factor: String,
    },
}

/// Structure of a term-library file (TOML), which lists terms that a model may lack.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LibraryFile {
    loads: String,
    variables: Vec<VariableEntry>,
    products: Vec<Vec<String>>,
    channels: Vec<ChannelEntry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct VariableEntry {
    quantity: String,
    name: String,
    depends_on: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ChannelEntry {
    coefficient: String,
    name: String,
    term: String,
}

impl TermLibrary {
    /// Returns the built-in term libraries, which are parsed on the first call.
    pub fn built_in() -> &'static [Arc<TermLibrary>] {
        static BUILT_IN: LazyLock<Vec<Arc<TermLibrary>>> = LazyLock::new(|| {
            let parse = |(name, text): &(&str, &str)| TermLibrary::parse(name, text).map(Arc::new);
            let libraries: Result<_, _> = TERM_LIBRARIES.iter().map(parse).collect();
            libraries.expect("the built-in libraries are tested")
        });
        &BUILT_IN
    }

    /// Returns the first library that fits a model, or one generated for it, and the model with its
    /// [`TermLibrary::loads`]. `None` if no equation can take a term.
    pub fn for_model(model: &Model) -> Option<(Arc<TermLibrary>, ModelTree)> {
        let tree = ModelTree::of(model);
        let with_loads = |library: &TermLibrary| {
            let with_loads = tree.with(&library.loads).ok()?;
            with_loads.check().ok()?;
            Some(with_loads)
        };
        let mut built_in = TermLibrary::built_in().iter();
        let fitting =
            built_in.find_map(|library| Some((Arc::clone(library), with_loads(library)?)));
        fitting.or_else(|| {
            let file = generated::library(model)?;
            let library = TermLibrary::new("generated terms", file).ok()?;
            let with_loads = with_loads(&library)?;
            Some((Arc::new(library), with_loads))
        })
    }

    /// Parses a term library from TOML text; messages refer to the text as `name`.
    ///
    /// # Errors
    /// [`TermLibraryError`] if the structure is invalid, an effect has errors, or a product has an unknown factor.
    /// Whether the effects are compatible with a model is checked only when they are applied.
    pub fn parse(name: &str, text: &str) -> Result<TermLibrary, TermLibraryError> {
        let file: LibraryFile = toml::from_str(text).map_err(|error| TermLibraryError::Form {
            name: name.to_owned(),
            error,
        })?;
        TermLibrary::new(name, file)
    }

    fn new(name: &str, file: LibraryFile) -> Result<TermLibrary, TermLibraryError> {
        let loads = EffectTree::parse(name, &file.loads)?;
        let variables = file.variables.into_iter();
        let variables: IndexVec<VariableId, Variable> = variables
            .map(|entry| Variable::new(entry, &loads))
            .collect();
        let products = file.products.iter().map(|names| {
            let known = |factor: &String| {
                let found = variables.position(|variable| variable.name == *factor);
                found.ok_or_else(|| TermLibraryError::UnknownVariable {
                    name: name.to_owned(),
                    factor: factor.clone(),
                })
            };
            let ids: Result<Vec<VariableId>, TermLibraryError> = names.iter().map(known).collect();
            ids.map(|ids| powers(&ids))
        });
        let channels = file
            .channels
            .into_iter()
            .map(|entry| Channel::new(name, entry));
        Ok(TermLibrary {
            products: products.collect::<Result<Vec<_>, _>>()?.into(),
            channels: channels.collect::<Result<Vec<_>, _>>()?.into(),
            loads,
            variables,
        })
    }

    /// Iterates over all terms, channel by channel.
    pub fn terms(&self) -> impl Iterator<Item = Term> + '_ {
        self.channels.indices().flat_map(|channel| {
            let products = self.products.indices();
            products.map(move |product| Term { channel, product })
        })
    }

    /// Factors of a term's product; empty for the constant 1.
    pub fn factors(&self, term: Term) -> &[Factor] {
        &self.products[term.product]
    }

    /// Product of a term without its coefficient, as an expression in the notation of model files.
    pub fn formula(&self, term: Term) -> String {
        let factor = |factor: &Factor| {
            let formula = &self.variables[factor.variable].formula;
            match factor.power {
                1 => formula.clone(),
                power => format!("({formula})^{power}"),
            }
        };
        let factors: Vec<String> = self.factors(term).iter().map(factor).collect();
        if factors.is_empty() {
            "1".to_owned()
        } else {
            factors.join("*")
        }
    }

    /// Short name of a term for reports, such as `drag-by-alpha-squared`; never that of a built-in effect.
    pub fn name(&self, term: Term) -> String {
        let channel = &self.channels[term.channel].name;
        let factor = |factor: &Factor| {
            let variable = &self.variables[factor.variable].name;
            match factor.power {
                1 => variable.clone(),
                2 => format!("{variable}-squared"),
                3 => format!("{variable}-cubed"),
                power => format!("{variable}-to-the-{power}"),
            }
        };
        let factors: Vec<String> = self.factors(term).iter().map(factor).collect();
        let name = match factors.is_empty() {
            true => format!("constant-{channel}"),
            false => format!("{channel}-by-{}", factors.join("-and-")),
        };
        let identifier = name.replace('-', "_");
        match EffectTree::built_in()
            .iter()
            .any(|own| own.name() == identifier)
        {
            true => format!("{name}-term"),
            false => name,
        }
    }

    /// Kinds of variables of a term, from [`VARIABLES`](crate::VARIABLES), without duplicates.
    pub fn depends_on(&self, term: Term) -> Vec<&str> {
        let mut words: Vec<&str> = Vec::new();
        for factor in self.factors(term) {
            let word = self.variables[factor.variable].depends_on.as_str();
            if !words.contains(&word) {
                words.push(word);
            }
        }
        words
    }

    /// Effect `NAME` that adds a term with the coefficient `k_NAME`, documented by `doc`.
    pub fn effect(&self, term: Term, doc: &str) -> EffectTree {
        let name = self.name(term).replace('-', "_");
        let coefficient = format!("k_{name}");
        let mut value = expression(ExprKind::Name(coefficient.clone()));
        for factor in self.factors(term) {
            let variable = &self.variables[factor.variable].value;
            value = match factor.power {
                1 => times(value, variable),
                power => times(value, &raised(variable, power)),
            };
        }
        let mut words = self.depends_on(term);
        if words.is_empty() {
            words.push("none");
        }
        let words = words.into_iter().map(name_of).collect();
        let template = &self.channels[term.channel].template;
        let mut parts = vec![
            EffectPart::Citation(FOUND_IN_FLIGHTS.to_owned(), Span::default()),
            EffectPart::Variables(words, Span::default()),
            EffectPart::Add(Box::new(declaration(&coefficient))),
        ];
        parts.extend(
            template
                .parts
                .iter()
                .map(|part| filled(part, &name, &value)),
        );
        EffectTree::new(Effect {
            name: name_of(&name),
            doc: doc.to_owned(),
            on: Vec::new(),
            parts,
        })
    }
}

impl Variable {
    /// A variable, defined by a `let` in `loads`, else by its name in the model.
    fn new(entry: VariableEntry, loads: &EffectTree) -> Variable {
        let mut lets = of_kind!(loads.tree().added(), ItemKind::Let);
        let defined = lets.find(|binding| binding.name.text == entry.quantity);
        let (formula, value) = match defined.map(|binding| &binding.value) {
            Some(value) => (loads.text(value.span), value.clone()),
            None => {
                let name = ExprKind::Name(entry.quantity.clone());
                (entry.quantity.as_str(), expression(name))
            }
        };
        Variable {
            formula: formula.to_owned(),
            value,
            quantity: entry.quantity,
            name: entry.name,
            depends_on: entry.depends_on,
        }
    }
}

impl Channel {
    fn new(library: &str, entry: ChannelEntry) -> Result<Channel, LoadError> {
        let template = EffectTree::parse(library, &entry.term)?.tree().clone();
        let site = template.parts.iter().find_map(|part| match part {
            EffectPart::Site(name) => Some(name.text.clone()),
            _ => None,
        });
        Ok(Channel {
            coefficient: entry.coefficient,
            name: entry.name,
            site: site.unwrap_or_default(),
            template,
        })
    }
}

/// Converts a product, given as the list of its variables, to powers: adjacent equal variables become one factor.
fn powers(variables: &[VariableId]) -> Vec<Factor> {
    let runs = variables.chunk_by(|a, b| a == b);
    runs.map(|run| Factor {
        variable: run[0],
        power: i32::try_from(run.len()).unwrap_or(i32::MAX),
    })
    .collect()
}

fn filled(part: &EffectPart, name: &str, term: &Expr) -> EffectPart {
    let mut part = part.clone();
    if let EffectPart::Replace(item) | EffectPart::Add(item) = &mut part {
        if let ItemKind::Load(load) = &mut item.kind
            && load.name.text == "NAME"
        {
            name.clone_into(&mut load.name.text);
        }
        if let Some(value) = item.kind.value_mut() {
            substitute(value, term);
        }
    }
    part
}

/// Substitutes the expression `term` for each occurrence of the placeholder name `TERM` in `e`.
fn substitute(e: &mut Expr, term: &Expr) {
    if matches!(&e.kind, ExprKind::Name(name) if name == "TERM") {
        e.clone_from(term);
    } else {
        for child in e.children_mut() {
            substitute(child, term);
        }
    }
}

/// Product `a * b`. If `b` is a product or a quotient, the tree is left-associative, as parsed from the text `a*b`.
fn times(a: Expr, b: &Expr) -> Expr {
    match &b.kind {
        ExprKind::Binary(op @ (BinaryOp::Mul | BinaryOp::Div), left, right) => expression(
            ExprKind::Binary(*op, Box::new(times(a, left)), right.clone()),
        ),
        _ => binary(BinaryOp::Mul, a, b.clone()),
    }
}

fn raised(base: &Expr, power: i32) -> Expr {
    let exponent = Expr::number(power.to_string(), Span::default());
    binary(BinaryOp::Pow, base.clone(), exponent)
}

fn binary(op: BinaryOp, a: Expr, b: Expr) -> Expr {
    expression(ExprKind::Binary(op, Box::new(a), Box::new(b)))
}

/// An expression node without source span; [`EffectTree::new`] assigns the span.
fn expression(kind: ExprKind) -> Expr {
    let span = Span::default();
    Expr { kind, span }
}

fn name_of(text: &str) -> Name {
    Name::new(text, Span::default())
}

fn declaration(name: &str) -> Item {
    let span = Span::default();
    let one = UnitExpr {
        factors: Vec::new(),
        span,
    };
    let kind = ItemKind::Parameter(Parameter {
        class: ParameterClass::Coefficient,
        name: name_of(name),
        value: Quantity::new("0", Some(one), span),
        bounds: None,
    });
    Item::new(kind, FOUND_IN_FLIGHTS, span)
}

#[cfg(test)]
mod tests;
