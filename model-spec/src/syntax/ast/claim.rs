//! Syntax of a claim: which expressions are the mass, motion and loads of a body, in a model whose file writes the
//! differential equations explicitly.

use super::{BodyClass, Expr, Inertia, Name};
use crate::source::Span;

/// Statement `claim body NAME { … }` or `claim point NAME { … }`: declares which expressions of a model with explicit
/// equations `der(STATE) = …` are the mass, motion and loads of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Claim {
    /// Whether the body that the equations are declared to describe is rigid or a point mass.
    pub class: BodyClass,
    /// Name of the body that the equations are declared to describe.
    pub name: Name,
    /// Statements of the `claim` block, in order.
    pub parts: Vec<ClaimPart>,
}

/// A statement in a `claim` block, which declares the physical meaning of a model's equations.
#[derive(Clone, Debug, PartialEq)]
pub struct ClaimPart {
    /// Kind of statement, with its content.
    pub kind: ClaimPartKind,
    /// Source span of the statement.
    pub span: Span,
}

/// Kinds of statement in a `claim` block, which declares the physical meaning of a model's equations.
#[derive(Clone, Debug, PartialEq)]
pub enum ClaimPartKind {
    /// `mass EXPR;`: mass, kg.
    Mass(Expr),
    /// `inertia … in FRAME;`: inertia tensor, kg m².
    Inertia(Box<Inertia>),
    /// `fixed in FRAME;`: the body-fixed frame.
    Fixed(Name),
    /// `axis FRAME.k;`: the axis of revolution of a body to which no declared frame is fixed.
    Axis(Expr),
    /// `position EXPR;`: position of the centre of mass relative to the origin of the inertial frame, m; a vector with
    /// components in any frame.
    Position(Expr),
    /// `velocity EXPR;`: velocity of the centre of mass relative to the inertial frame, m/s.
    Velocity(Expr),
    /// `angular velocity EXPR;`: angular velocity of the body relative to the inertial frame, rad/s.
    AngularVelocity(Expr),
    /// `force EXPR;`: sum of all forces including the weight, N.
    Force(Expr),
    /// `moment EXPR;`: sum of all moments about the centre of mass, N m.
    Moment(Expr),
}

impl ClaimPartKind {
    /// Keywords with which the statement begins, such as `angular velocity`.
    pub fn words(&self) -> &'static str {
        match self {
            ClaimPartKind::Mass(_) => "mass",
            ClaimPartKind::Inertia(_) => "inertia",
            ClaimPartKind::Fixed(_) => "fixed in",
            ClaimPartKind::Axis(_) => "axis",
            ClaimPartKind::Position(_) => "position",
            ClaimPartKind::Velocity(_) => "velocity",
            ClaimPartKind::AngularVelocity(_) => "angular velocity",
            ClaimPartKind::Force(_) => "force",
            ClaimPartKind::Moment(_) => "moment",
        }
    }

    /// Expressions of the statement, in order; empty for `fixed in`.
    pub fn expressions(&self) -> Vec<&Expr> {
        match self {
            ClaimPartKind::Fixed(_) => Vec::new(),
            ClaimPartKind::Inertia(inertia) => inertia.rows.iter().flatten().flatten().collect(),
            ClaimPartKind::Mass(e)
            | ClaimPartKind::Axis(e)
            | ClaimPartKind::Position(e)
            | ClaimPartKind::Velocity(e)
            | ClaimPartKind::AngularVelocity(e)
            | ClaimPartKind::Force(e)
            | ClaimPartKind::Moment(e) => vec![e],
        }
    }
}
