//! Syntax of a claim.

use super::{BodyClass, Expr, Inertia, Name};
use crate::source::Span;

/// Statement `claim body NAME { … }` or `claim point NAME { … }`: the body that stated equations describe.
#[derive(Clone, Debug, PartialEq)]
pub struct Claim {
    /// Whether the body that the equations are declared to describe is rigid or a point mass.
    pub class: BodyClass,
    /// Name of the body that the equations are declared to describe.
    pub name: Name,
    /// Statements of the `claim` block, in order.
    pub parts: Vec<ClaimPart>,
}

/// A statement in a `claim` block.
#[derive(Clone, Debug, PartialEq)]
pub struct ClaimPart {
    /// Keywords with which the statement begins: one of [`ClaimPart::WORDS`].
    pub words: &'static str,
    /// Content of the statement.
    pub kind: ClaimPartKind,
    /// Source span of the statement.
    pub span: Span,
}

/// Content of a statement in a `claim` block.
#[derive(Clone, Debug, PartialEq)]
pub enum ClaimPartKind {
    /// `inertia … in FRAME;`: inertia tensor, kg m².
    Inertia(Box<Inertia>),
    /// `fixed in FRAME;`: the body-fixed frame.
    Fixed(Name),
    /// All other statements: the quantity that the keywords name.
    Value(Expr),
}

impl ClaimPart {
    /// Keywords of the statements: `axis` is the axis of revolution of a body to which no declared frame is fixed;
    /// `force` and `moment` are the sums of all loads including the weight.
    pub const WORDS: [&str; 9] = [
        "mass",
        "position",
        "velocity",
        "force",
        "inertia",
        "fixed in",
        "axis",
        "angular velocity",
        "moment",
    ];

    /// Expressions of the statement, in order; empty for `fixed in`.
    pub fn expressions(&self) -> Vec<&Expr> {
        match &self.kind {
            ClaimPartKind::Fixed(_) => Vec::new(),
            ClaimPartKind::Inertia(inertia) => inertia.rows.iter().flatten().flatten().collect(),
            ClaimPartKind::Value(e) => vec![e],
        }
    }
}
