//! Equations that determine their unknowns together.

use super::Expr;
use crate::location::Span;

/// Equations of a block `solve { … }`, linear in their unknowns and as many.
#[derive(Clone, Debug)]
pub struct LinearSystem {
    /// The block as messages call it, such as `` `solve rod` ``.
    pub title: String,
    /// Unknowns: derivatives of states, and components of the quantities that the block declares.
    pub unknowns: Vec<Unknown>,
    /// Left-hand side minus right-hand side of each equation, which are zero; a vector is three equations.
    pub equations: Vec<Expr>,
    /// Deviations of the states from the block's constraints, and the derivatives of these that have no unknowns.
    pub constraints: Vec<Expr>,
    /// Source span of the block.
    pub span: Span,
}

/// An unknown of a [`LinearSystem`].
#[derive(Clone, Debug)]
pub struct Unknown {
    /// Name as in messages, such as `der(vx)`, `T` or `F.1`.
    pub name: String,
    /// Index into [`Model::states`](super::Model::states) of the state whose derivative it is, if any.
    pub state: Option<usize>,
}

/// A change of a quantity along the motion, such as of the energy, that the model claims for `hyzer verify`.
#[derive(Clone, Debug)]
pub struct Balance {
    /// Number or vector that changes, made of states.
    pub quantity: Expr,
    /// Its derivative by the time of the flight.
    pub change: Expr,
    /// Source span of the statement.
    pub span: Span,
}
