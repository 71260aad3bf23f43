//! Transformation of an inertia tensor that is constant in one frame to another, rotating frame.
//!
//! The tensor is split into a part that is symmetric about the rotation axis between the frames, and therefore equal in
//! both frames, and a remainder that rotates. If the remainder is 0, the equations do not depend on the rotation angle.

use super::Lowering;
use super::frames::{self, Vector};
use model_spec::model::{FrameKind, Model, Rotation};

type Matrix = [Vector; 3];

/// Inertia tensor in the frame of the angular velocity.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turned {
    /// Complete inertia tensor, kg m², in the frame of the components of the angular velocity.
    pub whole: Matrix,
    /// Part, kg m², that is not symmetric about the axis between the frames, and varies.
    rest: Matrix,
    /// Angular velocity, rad/s, of the inertia frame relative to that of the angular velocity.
    relative: Vector,
}

impl Lowering<'_> {
    /// Transforms the inertia tensor, kg m², to the frame of the angular velocity.
    pub(super) fn turned_inertia(&mut self, rotation: &Rotation, given: Matrix) -> Turned {
        let model = self.model;
        let (from, to) = (rotation.inertia_frame, rotation.angular_velocity_frame);
        let graph = &mut self.graph;
        let zero = graph.whole(0);
        let mut steady = [[zero; 3]; 3];
        if let Some(axis) = axis_between(model, from, to) {
            let [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
            steady[axis][axis] = given[axis][axis];
            (steady[i][i], steady[j][j]) = (given[j][j], given[j][j]);
        }
        let rest = [0, 1, 2].map(|i| frames::sub(graph, given[i], steady[i]));
        // R K Rᵀ: transforms the columns, then the rows.
        let columns = transpose(rest).map(|v| frames::reexpress(graph, &self.frames, v, from, to));
        let rest = transpose(columns).map(|v| frames::reexpress(graph, &self.frames, v, from, to));
        let own = frames::angular_velocity(graph, &self.frames, from, to);
        let other = frames::angular_velocity(graph, &self.frames, to, to);
        Turned {
            whole: [0, 1, 2].map(|i| frames::add(graph, steady[i], rest[i])),
            rest,
            relative: frames::sub(graph, own, other),
        }
    }

    /// Contribution of the varying part K of the inertia tensor to the rate of change of the angular momentum, N m:
    /// `σ × K ω - K (σ × ω)`. Here ω is the angular velocity `spin` of the body, and σ is the angular velocity of the
    /// frame in which the inertia tensor is constant, relative to the frame of ω ([`Turned::relative`]).
    pub(super) fn drift(&mut self, turned: &Turned, spin: Vector) -> Vector {
        let graph = &mut self.graph;
        let momentum = turned.rest.map(|row| frames::dot(graph, row, spin));
        let carried = frames::cross(graph, turned.relative, momentum);
        let moved = frames::cross(graph, turned.relative, spin);
        let seen = turned.rest.map(|row| frames::dot(graph, row, moved));
        frames::sub(graph, carried, seen)
    }
}

/// Axis (0 to 2) of the single rotation between a frame and its parent; `None` for others.
fn axis_between(model: &Model, a: usize, b: usize) -> Option<usize> {
    let turn = |child: usize, of: usize| match model.frames[child].kind {
        FrameKind::Turned { parent, axis, .. } if parent == of => Some(usize::from(axis) - 1),
        _ => None,
    };
    turn(a, b).or_else(|| turn(b, a))
}

fn transpose(m: Matrix) -> Matrix {
    [0, 1, 2].map(|i| m.map(|row| row[i]))
}
