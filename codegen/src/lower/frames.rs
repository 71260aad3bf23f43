//! Symbolic 3-vectors, and rotations between frames along the tree of frames.

use crate::functions::MathFunction;
use crate::graph::{ExprGraph, NodeId, Symbol};
use crate::number::Number;
use model_spec::model::{FrameKind, Model};

/// Frames of a model, with the nodes of the angles that turn some of them.
pub(crate) struct Frames<'a> {
    pub model: &'a Model,
    /// Nodes of [`Model::constant_angles`].
    pub constant_angles: Vec<NodeId>,
}

/// Graph nodes of the three components of a vector in one coordinate frame.
pub type Vector = [NodeId; 3];

pub fn add(graph: &mut ExprGraph, a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| graph.add(a[k], b[k]))
}

pub fn sub(graph: &mut ExprGraph, a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| graph.sub(a[k], b[k]))
}

/// Vector `a` multiplied by the scalar `s`.
pub fn scale(graph: &mut ExprGraph, s: NodeId, a: Vector) -> Vector {
    if graph.is_one(s) {
        a
    } else {
        a.map(|component| graph.mul(s, component))
    }
}

pub fn dot(graph: &mut ExprGraph, a: Vector, b: Vector) -> NodeId {
    let terms = [0, 1, 2].map(|k| (Number::ONE, graph.mul(a[k], b[k])));
    graph.sum(terms.to_vec(), Number::ZERO)
}

pub fn cross(graph: &mut ExprGraph, a: Vector, b: Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
        let (first, second) = (graph.mul(a[i], b[j]), graph.mul(a[j], b[i]));
        graph.sub(first, second)
    })
}

/// Vector whose three components are the constant 0.
pub fn zero(graph: &mut ExprGraph) -> Vector {
    let zero = graph.whole(0);
    [zero; 3]
}

pub fn axis(graph: &mut ExprGraph, axis: u8) -> Vector {
    [1, 2, 3].map(|k| graph.whole(i64::from(k == axis)))
}

/// Indices of the frames from the inertial frame down to `frame`, both included.
pub fn path(model: &Model, frame: usize) -> Vec<usize> {
    let mut path = vec![frame];
    let mut at = frame;
    while let Some(above) = model.frames[at].kind.parent() {
        path.push(above);
        at = above;
    }
    path.reverse();
    path
}

/// Transforms the components of a vector from frame `from` to frame `to`.
pub fn reexpress(
    graph: &mut ExprGraph,
    frames: &Frames<'_>,
    vector: Vector,
    from: usize,
    to: usize,
) -> Vector {
    let (up, down) = (path(frames.model, from), path(frames.model, to));
    let common = up.iter().zip(&down).take_while(|(a, b)| a == b).count();
    let mut vector = vector;
    for &frame in up[common..].iter().rev() {
        vector = turn(graph, frames, vector, frame, true);
    }
    for &frame in &down[common..] {
        vector = turn(graph, frames, vector, frame, false);
    }
    vector
}

/// Transforms the components `v` of a vector from `frame` to its parent if `up`, else from the parent to `frame`.
pub fn turn(
    graph: &mut ExprGraph,
    frames: &Frames<'_>,
    v: Vector,
    frame: usize,
    up: bool,
) -> Vector {
    match frames.model.frames[frame].kind {
        FrameKind::Inertial => v,
        FrameKind::Turned { axis, .. } | FrameKind::Fixed { axis, .. } => {
            let angle = angle(graph, frames, frame);
            let (sin, cos) = (
                graph.call(MathFunction::Sin, angle),
                graph.call(MathFunction::Cos, angle),
            );
            let (i, j) = [(1, 2), (2, 0), (0, 1)][usize::from(axis) - 1];
            let mut turned = v;
            let (ci, cj) = (graph.mul(cos, v[i]), graph.mul(cos, v[j]));
            let (si, sj) = (graph.mul(sin, v[i]), graph.mul(sin, v[j]));
            if up {
                turned[i] = graph.sub(ci, sj);
                turned[j] = graph.add(si, cj);
            } else {
                turned[i] = graph.add(ci, sj);
                turned[j] = graph.sub(cj, si);
            }
            turned
        }
        FrameKind::Quaternion { states, .. } => {
            let matrix = quaternion_matrix(graph, states);
            [0, 1, 2].map(|row| {
                let line = if up {
                    matrix[row]
                } else {
                    [matrix[0][row], matrix[1][row], matrix[2][row]]
                };
                dot(graph, line, v)
            })
        }
    }
}

/// Angle, rad, by which a frame is turned about an axis of its parent; 0 for other frames.
fn angle(graph: &mut ExprGraph, frames: &Frames<'_>, frame: usize) -> NodeId {
    match frames.model.frames[frame].kind {
        FrameKind::Turned { angle, .. } => graph.symbol(Symbol::State(angle as u32)),
        FrameKind::Fixed { angle, .. } => frames.constant_angles[angle],
        FrameKind::Inertial | FrameKind::Quaternion { .. } => graph.whole(0),
    }
}

/// Rotation matrix, by row, of a unit quaternion, to the parent frame.
fn quaternion_matrix(graph: &mut ExprGraph, states: [usize; 4]) -> [Vector; 3] {
    let q = states.map(|state| graph.symbol(Symbol::State(state as u32)));
    let two = Number::whole(2);
    let mut diagonal = |i: usize, j: usize| {
        let (ii, jj) = (graph.power(q[i], 4), graph.power(q[j], 4));
        graph.sum(
            vec![(two.opposite(), ii), (two.opposite(), jj)],
            Number::ONE,
        )
    };
    let (xx, yy, zz) = (diagonal(2, 3), diagonal(1, 3), diagonal(1, 2));
    let mut mixed = |i: usize, j: usize, k: usize, sign: Number| {
        let (a, b) = (graph.mul(q[i], q[j]), graph.mul(q[0], q[k]));
        graph.sum(vec![(two, a), (two.times(sign), b)], Number::ZERO)
    };
    let (plus, minus) = (Number::ONE, Number::MINUS_ONE);
    [
        [xx, mixed(1, 2, 3, minus), mixed(1, 3, 2, plus)],
        [mixed(1, 2, 3, plus), yy, mixed(2, 3, 1, minus)],
        [mixed(1, 3, 2, minus), mixed(2, 3, 1, plus), zz],
    ]
}

/// Angular velocity of frame `of` relative to the inertial frame, rad/s; components in frame `within`.
pub fn angular_velocity(
    graph: &mut ExprGraph,
    frames: &Frames<'_>,
    of: usize,
    within: usize,
) -> Vector {
    let model = frames.model;
    let chain = path(model, of);
    // with a quaternion attitude, the angular velocity is a state
    if let Some(rotation) = model.rotation()
        && let Some((states, frame)) = rotation.angular_velocity
    {
        let spin = states.map(|state| graph.symbol(Symbol::State(state as u32)));
        let mut spin = reexpress(graph, frames, spin, frame, within);
        let body_chain = path(model, rotation.body_frame);
        let shared = chain
            .iter()
            .zip(&body_chain)
            .take_while(|(a, b)| a == b)
            .count();
        let through = |part: &[usize]| {
            part.iter()
                .any(|&f| matches!(model.frames[f].kind, FrameKind::Quaternion { .. }))
        };
        if through(&chain[..shared]) {
            for &frame in &body_chain[shared..] {
                let relative = turning(graph, frames, frame, within);
                spin = sub(graph, spin, relative);
            }
            for &frame in &chain[shared..] {
                let relative = turning(graph, frames, frame, within);
                spin = add(graph, spin, relative);
            }
            return spin;
        }
    }
    let mut total = zero(graph);
    let mut at = chain[0];
    let mut passed = at == within;
    // from the inertial frame down, each rate is added along a coordinate axis
    for &frame in &chain[1..] {
        if passed {
            let relative = turning(graph, frames, frame, within);
            total = add(graph, total, relative);
            continue;
        }
        let relative = turning(graph, frames, frame, at);
        total = add(graph, total, relative);
        total = turn(graph, frames, total, frame, false);
        at = frame;
        passed = at == within;
    }
    if passed {
        total
    } else {
        reexpress(graph, frames, total, at, within)
    }
}

/// Angular velocity, rad/s, of a frame relative to its parent, in `within`; zero if its rate is no state.
fn turning(graph: &mut ExprGraph, frames: &Frames<'_>, frame: usize, within: usize) -> Vector {
    match frames.model.frames[frame].kind {
        FrameKind::Turned {
            parent,
            rate: Some(rate),
            axis: k,
            ..
        } => {
            let rate = graph.symbol(Symbol::State(rate as u32));
            let unit = axis(graph, k);
            let along = scale(graph, rate, unit);
            reexpress(graph, frames, along, parent, within)
        }
        _ => zero(graph),
    }
}
