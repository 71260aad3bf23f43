//! The derivative of a model's state from its vector tree: stated equations taken at their word, and a
//! body's by Newton's and Euler's laws in inertial components.

use crate::attitude::Quaternion;
use crate::frames::{Placed, turns};
use crate::physical::Motion;
use crate::point::Point;
use crate::rigid::{angular_acceleration, inertia_in_n, solve};
use crate::scalar::{Field, Real};
use crate::tree::Tree;
use model_spec::model::{Body, FrameKind, Model};
use nalgebra::{Matrix3, Vector3};

/// Mass and inertia as numbers, the inertia in its own frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties<T> {
    /// Mass.
    pub mass: T,
    /// Moments of inertia; none for a point mass.
    pub inertia: Option<Matrix3<T>>,
}

/// Why the oracle cannot derive a model's equations.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unsupported(pub String);

/// The derivative of every state.
pub fn derivatives<T: Real>(model: &Model, point: &Point<T>) -> Result<Vec<T>, Unsupported> {
    derivatives_of(&Tree::new(model, point))
}

/// The derivative of every state by the time that is measured, where the tree has been evaluated already.
pub fn derivatives_of<T: Real>(tree: &Tree<'_, T>) -> Result<Vec<T>, Unsupported> {
    let model = tree.model;
    let mut out = match &model.body {
        None => vec![T::zero(); model.states.len()],
        Some(body) => {
            let (force, moment) = (tree.total(&model.forces), tree.total(&model.moments));
            let properties = mass_properties(tree, body);
            let motion = newton_euler(body, &tree.frames, &properties, force, moment);
            state_derivatives(model, body, &tree.point.states, &tree.frames, &motion)?
        }
    };
    for equation in &model.equations {
        out[equation.state] = tree.scalar(&equation.value);
    }
    if model.clock.is_some() {
        let pace = tree.clock();
        out.iter_mut().for_each(|rate| *rate *= pace);
    }
    Ok(out)
}

/// Mass and inertia of a body at a point.
pub fn mass_properties<T: Real>(tree: &Tree<'_, T>, body: &Body) -> MassProperties<T> {
    MassProperties {
        mass: tree.scalar(&body.mass),
        inertia: body
            .rotation
            .as_ref()
            .map(|r| Matrix3::from_fn(|row, column| tree.scalar(&r.inertia[row][column]))),
    }
}

/// How a body answers a force and a moment.
pub fn newton_euler<T: Field>(
    body: &Body,
    frames: &[Placed<T>],
    properties: &MassProperties<T>,
    force: Vector3<T>,
    moment: Vector3<T>,
) -> Motion<T> {
    let turning = body.rotation.as_ref().zip(properties.inertia.as_ref());
    let answer = turning.and_then(|(rotation, inertia)| {
        let frame = &frames[rotation.inertia_frame];
        let inertia = inertia_in_n(&frame.axes, inertia);
        let omega = frames[rotation.body_frame].turning?;
        Some(angular_acceleration(
            &inertia,
            &frame.turning?,
            &omega,
            &moment,
        ))
    });
    Motion {
        force,
        moment,
        acceleration: force / properties.mass,
        angular_acceleration: answer.unwrap_or_else(Vector3::zeros),
    }
}

/// The derivatives of a body's states under a motion; of states that are not the body's 0.
pub fn state_derivatives<T: Field>(
    model: &Model,
    body: &Body,
    states: &[T],
    frames: &[Placed<T>],
    motion: &Motion<T>,
) -> Result<Vec<T>, Unsupported> {
    let mut out = vec![T::zero(); model.states.len()];
    let mut put = |indices: [usize; 3], v: Vector3<T>| {
        for (i, value) in indices.into_iter().zip(v.iter()) {
            out[i] = *value;
        }
    };
    let fixed = |what: &str| {
        Unsupported(format!(
            "{what} is in a frame whose turning the model does not give"
        ))
    };

    let frame = &frames[body.velocity_frame];
    let velocity = frame.axes * Vector3::from(body.velocity.map(|i| states[i]));
    let carried = frame
        .turning
        .ok_or_else(|| fixed("the velocity"))?
        .cross(&velocity);
    put(body.position, velocity);
    put(
        body.velocity,
        frame.axes.transpose() * (motion.acceleration - carried),
    );

    let Some(rotation) = &body.rotation else {
        return Ok(out);
    };
    let omega = frames[rotation.body_frame]
        .turning
        .ok_or_else(|| fixed("the body"))?;
    if let Some((components, frame)) = rotation.angular_velocity {
        let frame = &frames[frame];
        let carried = frame
            .turning
            .ok_or_else(|| fixed("the angular velocity"))?
            .cross(&omega);
        put(
            components,
            frame.axes.transpose() * (motion.angular_acceleration - carried),
        );
        let FrameKind::Quaternion {
            parent: 0,
            states: q,
        } = model.frames[rotation.body_frame].kind
        else {
            return Err(Unsupported(
                "the body's frame is not a quaternion from the inertial frame".into(),
            ));
        };
        let attitude = Quaternion::from_parts(q.map(|i| states[i]));
        // dq/dt = ω q / 2, ω in inertial components.
        let rate = Quaternion {
            w: T::zero(),
            v: omega,
        }
        .times(attitude);
        for (i, part) in q.into_iter().zip(rate.parts()) {
            out[i] = part / T::integer(2);
        }
        return Ok(out);
    }
    let chain = turns(model, frames, rotation.body_frame)
        .filter(|chain| chain.len() == 3)
        .ok_or_else(|| {
            Unsupported("the body's attitude is not three turns with their rates".into())
        })?;
    // ω = Σ rate_i axis_i, so dω/dt = Σ (d rate_i/dt) axis_i + Σ rate_i (carrier_i × axis_i).
    let axes = Matrix3::from_columns(&[chain[0].axis, chain[1].axis, chain[2].axis]);
    let drift = chain.iter().fold(Vector3::zeros(), |sum, turn| {
        sum + turn.carried.cross(&turn.axis) * states[turn.rate]
    });
    put(
        [chain[0].rate, chain[1].rate, chain[2].rate],
        solve(&axes, &(motion.angular_acceleration - drift)),
    );
    for frame in &model.frames {
        if let FrameKind::Turned {
            angle,
            rate: Some(rate),
            ..
        } = frame.kind
        {
            out[angle] = states[rate];
        }
    }
    Ok(out)
}
