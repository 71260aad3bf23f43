//! Syntax of a claim: which expressions are the quantities of a body whose equations are stated.

use super::{BodyClass, Expr, Inertia, Name};
use crate::source::Span;

/// Declaration of what the stated equations are about: `claim body NAME { … }` or `claim point NAME { … }`.
#[derive(Clone, Debug, PartialEq)]
pub struct Claim {
    /// Rigid body or point mass.
    pub class: BodyClass,
    /// Name of the claimed body.
    pub name: Name,
    /// Statements of the claim's block, in order.
    pub parts: Vec<ClaimPart>,
}

/// A statement in the block of a claim.
#[derive(Clone, Debug, PartialEq)]
pub struct ClaimPart {
    /// Kind of statement, with its content.
    pub kind: ClaimPartKind,
    /// Source span of the statement.
    pub span: Span,
}

/// Kinds of statement in the block of a claim.
#[derive(Clone, Debug, PartialEq)]
pub enum ClaimPartKind {
    /// `mass EXPR;`: mass, kg.
    Mass(Expr),
    /// `inertia … in FRAME;`: inertia tensor, kg m².
    Inertia(Box<Inertia>),
    /// `fixed in FRAME;`: the body-fixed frame.
    Fixed(Name),
    /// `axis FRAME.k;`: the axis of revolution, of a body in which no declared frame is fixed.
    Axis(Expr),
    /// `position EXPR;`: position of the centre of mass, m.
    Position(Expr),
    /// `velocity EXPR;`: velocity of the centre of mass against the inertial frame, m/s.
    Velocity(Expr),
    /// `angular velocity EXPR;`: angular velocity of the body against the inertial frame, rad/s.
    AngularVelocity(Expr),
    /// `force EXPR;`: sum of all forces, with the weight, N.
    Force(Expr),
    /// `moment EXPR;`: sum of all moments about the centre of mass, N m.
    Moment(Expr),
}

impl ClaimPartKind {
    /// Words by which the statement begins.
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

    /// Expressions of the statement, in order.
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
