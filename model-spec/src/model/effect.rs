//! Effects of a checked model: those that are switched on, and those that could be.

#[cfg(doc)]
use crate::model::Model;
use crate::source::Span;

/// An effect that has been switched on.
#[derive(Clone, Debug)]
pub struct AppliedEffect {
    /// Name, with underscores.
    pub name: String,
    /// Its `///` lines.
    pub doc: String,
    /// Where it acts: lift, drag, side, roll, pitch, spin, wind, …
    pub site: String,
    /// On what it depends, in words of [`VARIABLES`](crate::VARIABLES); empty where it does not say.
    pub variables: Vec<String>,
    /// Where it is described, as the effect cites it; empty where it cites nothing.
    pub citation: String,
    /// Its coefficients, by index into [`Model::coefficients`].
    pub coefficients: Vec<EffectUnknown>,
    /// Its states, by index into [`Model::states`]; their initial values differ from flight to flight.
    pub states: Vec<EffectUnknown>,
}

/// An effect that can be switched on by its name.
#[derive(Clone, Debug)]
pub struct OfferedEffect {
    /// Name, with underscores.
    pub name: String,
    /// Its `///` lines.
    pub doc: String,
    /// Place of the declaration.
    pub span: Span,
}

/// A coefficient, or the initial value of a state, by which an effect is switched on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EffectUnknown {
    /// Index into the model's coefficients or states.
    pub index: usize,
    /// Value at which the effect is absent, SI: the default.
    pub null_value: f64,
    /// Smallest distance from the null value that matters in practice, SI; none if the effect states none.
    pub smallest_of_interest: Option<f64>,
}
