//! Claim of a model: the body that its stated equations describe.

use super::Expr;
use crate::source::Span;

/// Mass, motion and loads of a body that a `claim` block declares for the stated equations; `hyzer verify` checks
/// whether they agree.
#[derive(Clone, Debug)]
pub struct Claim {
    /// Name of the body that the equations of the model are declared to describe.
    pub name: String,
    /// Mass, kg; depends only on parameters and coefficients.
    pub mass: Expr,
    /// Position of the centre of mass, a vector in any frame, m.
    pub position: Expr,
    /// Velocity of the centre of mass relative to the inertial frame, a vector in any frame, m/s.
    pub velocity: Expr,
    /// Sum of all forces including the weight, a vector in any frame, N.
    pub force: Expr,
    /// Rotational motion; `None` for a point mass.
    pub rotation: Option<ClaimedRotation>,
    /// Source span of the name of the body in the `claim` block.
    pub span: Span,
}

/// Rotational motion of a claimed body.
#[derive(Clone, Debug)]
pub struct ClaimedRotation {
    /// Body-fixed frame, or axis of revolution, that gives the orientation of the body.
    pub attitude: ClaimedAttitude,
    /// Index into [`Model::frames`](super::Model::frames) of the frame in which the inertia tensor is constant.
    pub inertia_frame: usize,
    /// Inertia tensor about the centre of mass, kg m², in [`ClaimedRotation::inertia_frame`], see
    /// [`Rotation`](super::Rotation).
    pub inertia: [[Expr; 3]; 3],
    /// Angular velocity of the body relative to the inertial frame, a vector in any frame, rad/s.
    pub angular_velocity: Expr,
    /// Sum of all moments about the centre of mass, a vector in any frame, N m.
    pub moment: Expr,
}

/// How a [`Claim`] specifies the orientation of the body: by a body-fixed frame, or by the axis of revolution alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClaimedAttitude {
    /// The body-fixed frame, by index into [`Model::frames`](super::Model::frames).
    Frame(usize),
    /// The axis of revolution: frame, which does not spin with the body, and number of its axis (1 to 3).
    Axis(usize, u8),
}

/// Function body of [`Claim::expressions`] and [`Claim::expressions_mut`], which differ only in the kind of reference.
macro_rules! expressions {
    ($claim:expr, $iter:ident $(, $mutable:tt)?) => {{
        let Claim { mass, position, velocity, force, rotation, .. } = $claim;
        let mut all = vec![mass, position, velocity, force];
        for rotation in rotation.$iter() {
            all.extend(rotation.inertia.$iter().flatten());
            all.push(&$($mutable)? rotation.angular_velocity);
            all.push(&$($mutable)? rotation.moment);
        }
        all
    }};
}

impl Claim {
    /// References to all expressions of the `claim` block.
    pub fn expressions(&self) -> Vec<&Expr> {
        expressions!(self, iter)
    }

    /// Mutable references to all expressions of the `claim` block.
    pub fn expressions_mut(&mut self) -> Vec<&mut Expr> {
        expressions!(self, iter_mut, mut)
    }
}
