//! Syntax tree of the declaration of a rigid body or a point mass.

use super::{Expr, Name};
use crate::source::Span;

/// Whether a body is rigid or a point mass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyClass {
    /// Rigid body with mass and inertia (`body`).
    Rigid,
    /// Point mass (`point`).
    Point,
}

impl BodyClass {
    /// Keyword of the class.
    pub(crate) fn keyword(self) -> &'static str {
        match self {
            BodyClass::Rigid => "body",
            BodyClass::Point => "point",
        }
    }
}

/// Declaration of a rigid body or a point mass.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Whether the body is rigid or a point mass.
    pub class: BodyClass,
    /// Name of the body.
    pub name: Name,
    /// Statements between the braces of the declaration, in order.
    pub parts: Vec<BodyPart>,
}

/// A statement in a block `body NAME { … }` or `point NAME { … }`, such as `mass EXPR;`.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyPart {
    /// Kind of statement, with its content.
    pub kind: BodyPartKind,
    /// Source span of the statement.
    pub span: Span,
}

/// Kinds of statement in a block `body NAME { … }` or `point NAME { … }`, with their content.
#[derive(Clone, Debug, PartialEq)]
pub enum BodyPartKind {
    /// `mass EXPR;`: mass, kg.
    Mass(Expr),
    /// `inertia … in FRAME;`: inertia tensor, kg m².
    Inertia(Box<Inertia>),
    /// `fixed in FRAME;`: the body-fixed frame.
    Fixed(Name),
    /// `position (x, y, z) in FRAME;`: names of the position states of the centre of mass, and their frame.
    Position([Name; 3], Name),
    /// `velocity (u, v, w) in FRAME;`: names of the velocity states of the centre of mass, and their frame.
    Velocity([Name; 3], Name),
    /// `angular velocity (p, q, r) in FRAME;`: names of the angular-velocity states, and their frame.
    AngularVelocity([Name; 3], Name),
    /// `angular velocity in FRAME;`: frame of the components of `angular_velocity`.
    AngularVelocityIn(Name),
}

/// Inertia tensor about the centre of mass, kg m², with off-diagonal entries such as `-∫ x y dm`.
#[derive(Clone, Debug, PartialEq)]
pub struct Inertia {
    /// Entries of the tensor, row by row; `None` for the off-diagonal entries of `diag(…)`.
    pub rows: [[Option<Expr>; 3]; 3],
    /// Name of the frame of the tensor's components.
    pub frame: Name,
}
