//! Moments of inertia that are constant in one frame, seen from another.
//!
//! They are split in two: a part that is symmetric about the axis of the turn between the frames, and is the same in
//! both, and the rest, which turns. Where the rest is 0 nothing of the turn is left in the equations.

use super::Lowering;
use super::frames::{self, Vector};
use model_spec::model::{FrameKind, Model, Rotation};

/// A symmetric matrix, row by row.
type Matrix = [Vector; 3];

/// Moments of inertia in the frame in which the angular velocity is seen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turned {
    /// All of them.
    pub whole: Matrix,
    /// The part that turns.
    rest: Matrix,
    /// Angular velocity of the frame in which they are constant, relative to this one.
    relative: Vector,
}

impl Lowering<'_> {
    /// Moments of inertia seen from the frame of the angular velocity.
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
        // R K Rᵀ: its columns are turned, then its rows.
        let columns = transpose(rest).map(|v| frames::reexpress(graph, model, v, from, to));
        let rest = transpose(columns).map(|v| frames::reexpress(graph, model, v, from, to));
        let own = frames::angular_velocity(graph, model, from, to);
        let other = frames::angular_velocity(graph, model, to, to);
        Turned {
            whole: [0, 1, 2].map(|i| frames::add(graph, steady[i], rest[i])),
            rest,
            relative: frames::sub(graph, own, other),
        }
    }

    /// `σ × K ω - K (σ × ω)`: how fast the part K that turns at σ changes the angular momentum.
    pub(super) fn drift(&mut self, turned: &Turned, spin: Vector) -> Vector {
        let graph = &mut self.graph;
        let momentum = turned.rest.map(|row| frames::dot(graph, row, spin));
        let carried = frames::cross(graph, turned.relative, momentum);
        let moved = frames::cross(graph, turned.relative, spin);
        let seen = turned.rest.map(|row| frames::dot(graph, row, moved));
        frames::sub(graph, carried, seen)
    }
}

/// The axis, 0 to 2, of the single turn that lies between two frames.
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
