//! Claim of a model: which expressions are the mass, motion and loads of a body, if the model file writes the
//! differential equations explicitly.

use super::Expr;
use crate::source::Span;

/// Physical meaning that a model file declares, in a `claim` block, for its explicitly written equations `der(STATE) =
/// …`: expressions for the mass, motion and loads of a body. It does not change the equations; `hyzer verify` checks
/// whether they agree with it.
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

/// Rotational motion of the rigid body that a model's explicitly written equations are declared to describe, see
/// [`Claim`].
#[derive(Clone, Debug)]
pub struct ClaimedRotation {
    /// Body-fixed frame, or axis of revolution, that gives the orientation of the body.
    pub attitude: ClaimedAttitude,
    /// Index into [`Model::frames`](super::Model::frames) of the frame in which the inertia tensor is constant.
    pub inertia_frame: usize,
    /// Inertia tensor about the centre of mass, kg m², symmetric, with components in
    /// [`ClaimedRotation::inertia_frame`]. Off-diagonal entries are those of the tensor, such as -∫ x y dm. All entries
    /// depend on parameters and coefficients alone.
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
    /// The axis of revolution of the body, given as an axis of a frame that does not spin with the body: index into
    /// [`Model::frames`](super::Model::frames) of that frame, and number of the axis (1 to 3).
    Axis(usize, u8),
}

impl Claim {
    /// References to all expressions of the `claim` block.
    pub fn expressions(&self) -> Vec<&Expr> {
        let mut all = vec![&self.mass, &self.position, &self.velocity, &self.force];
        if let Some(rotation) = &self.rotation {
            all.extend(rotation.inertia.iter().flatten());
            all.extend([&rotation.angular_velocity, &rotation.moment]);
        }
        all
    }

    /// Mutable references to all expressions of the `claim` block.
    pub fn expressions_mut(&mut self) -> Vec<&mut Expr> {
        let mut all = vec![
            &mut self.mass,
            &mut self.position,
            &mut self.velocity,
            &mut self.force,
        ];
        if let Some(rotation) = &mut self.rotation {
            all.extend(rotation.inertia.iter_mut().flatten());
            all.extend([&mut rotation.angular_velocity, &mut rotation.moment]);
        }
        all
    }
}
