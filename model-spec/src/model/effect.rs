//! Effects of a checked model: those that are switched on, and those that could be.

use crate::diagnostic::Span;
#[cfg(doc)]
use crate::model::Model;

/// An effect that has been switched on.
#[derive(Clone, Debug)]
pub struct AppliedEffect {
    /// Name, with underscores.
    pub name: String,
    /// Its `///` lines.
    pub doc: String,
    /// Where it acts: lift, drag, side, roll, pitch, spin, wind, …
    pub site: String,
    /// On what it depends, in words of [`VARIABLES`](crate::effect::VARIABLES); empty where it does not say.
    pub variables: Vec<String>,
    /// Where it is described, as the effect cites it; empty where it cites nothing.
    pub citation: String,
    /// Its coefficients, with the value of each at which the effect vanishes and the size below which
    /// it does not matter in practice.
    pub coefficients: Vec<EffectCoefficient>,
    /// Its states, indices into [`Model::states`]: the effect is absent where each starts at its default and
    /// stays there. They differ from flight to flight.
    pub states: Vec<usize>,
    /// Which of its states do not matter in practice within what distance of their defaults, SI.
    pub negligible_states: Vec<(usize, f64)>,
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

/// A coefficient of an effect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EffectCoefficient {
    /// Index into [`Model::coefficients`].
    pub index: usize,
    /// The effect is absent at this value, SI.
    pub vanishes_at: f64,
    /// A departure smaller than this does not matter in practice, SI.
    pub negligible: Option<f64>,
}
