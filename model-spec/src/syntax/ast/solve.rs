//! Syntax tree of the block `solve { … }`, whose equations determine its unknowns together.

use super::{Expr, Name, Quantity, Type};
use crate::location::Span;

/// Block `solve NAME { unknown …; LEFT = RIGHT; }`: equations in which derivatives and other unknowns stand linearly.
#[derive(Clone, Debug, PartialEq)]
pub struct Solve {
    /// Name of the block, for messages; `None` if it has none.
    pub name: Option<Name>,
    /// Unknowns that the block declares, in order. Derivatives are unknowns without a declaration.
    pub unknowns: Vec<UnknownQuantity>,
    /// Equations, in order.
    pub equations: Vec<ImplicitEquation>,
}

/// Declaration of an unknown, such as a reaction force: `unknown NAME: TYPE;`
#[derive(Clone, Debug, PartialEq)]
pub struct UnknownQuantity {
    /// Name of the quantity, which the whole model may use.
    pub name: Name,
    /// Documentation: the `///` lines before the declaration.
    pub doc: String,
    /// Unit, and frame of a vector.
    pub of: Type,
}

/// Equation `LEFT = RIGHT;` that is not solved for anything, or a constraint.
#[derive(Clone, Debug, PartialEq)]
pub struct ImplicitEquation {
    /// Left-hand side, a number or a vector.
    pub left: Expr,
    /// Right-hand side, with the shape, frame and unit of the left-hand side.
    pub right: Expr,
    /// Of a constraint on positions or velocities, `constraint LEFT = RIGHT within TOLERANCE;`, by how much the sides may
    /// differ; `None` for an equation that holds as it stands.
    pub within: Option<Quantity>,
    /// Source span of the equation.
    pub span: Span,
}

impl Solve {
    /// Both sides of all equations, in order.
    pub fn sides(&self) -> impl Iterator<Item = &Expr> {
        let equations = self.equations.iter();
        equations.flat_map(|own| [&own.left, &own.right])
    }

    /// The block as messages call it.
    pub fn title(&self) -> String {
        match &self.name {
            Some(name) => format!("`solve {}`", name.text),
            None => "`solve`".to_owned(),
        }
    }
}

/// Claim `claim der(QUANTITY) = CHANGE;` that a quantity, such as the energy or the momentum, changes by what is stated.
#[derive(Clone, Debug, PartialEq)]
pub struct Balance {
    /// Number or vector that changes.
    pub quantity: Expr,
    /// Its derivative by the time of the flight.
    pub change: Expr,
}
