//! Accelerations of a body by Newton's and Euler's laws in inertial components, and the derivatives of its states.

use crate::attitude::Quaternion;
use crate::error::Unsupported;
use crate::frames::{ElementaryRotation, PlacedFrame, elementary_rotations};
use crate::physical::{MassProperties, Motion, angular_acceleration, inertia_in_n, solve};
use crate::scalar::Field;
use model_spec::model::{Body, FrameKind, Model, Rotation};
use nalgebra::{Matrix3, Vector3};

/// Accelerations of a body under a force at its mass centre, N, and a moment about it, N·m, by Newton's and Euler's
/// laws; all vectors are in inertial components.
pub fn newton_euler<T: Field>(
    body: &Body,
    frames: &[PlacedFrame<T>],
    properties: &MassProperties<T>,
    force: Vector3<T>,
    moment: Vector3<T>,
) -> Motion<T> {
    let rotating = body.rotation.as_ref().zip(properties.inertia.as_ref());
    let angular = rotating.and_then(|(rotation, inertia)| {
        let frame = &frames[rotation.inertia_frame];
        let inertia = inertia_in_n(&frame.axes, inertia);
        let omega = frames[rotation.body_frame].angular_velocity?;
        Some(angular_acceleration(
            &inertia,
            &frame.angular_velocity?,
            &omega,
            &moment,
        ))
    });
    Motion {
        force,
        moment,
        acceleration: force / properties.mass,
        angular_acceleration: angular.unwrap_or_else(Vector3::zeros),
    }
}

/// Time derivatives of a body's states for the accelerations in `motion`; 0 for states that do not describe the motion
/// of the body or of a frame.
pub fn state_derivatives<T: Field>(
    model: &Model,
    body: &Body,
    states: &[T],
    frames: &[PlacedFrame<T>],
    motion: &Motion<T>,
) -> Result<Vec<T>, Unsupported> {
    let mut out = vec![T::zero(); model.states.len()];
    let frame = &frames[body.velocity_frame];
    let velocity = frame.axes * Vector3::from(body.velocity.map(|i| states[i]));
    set(&mut out, body.position, velocity);
    let rate = component_rates(frame, velocity, motion.acceleration);
    let rate = rate.ok_or(Unsupported::FrameRate {
        vector: "the velocity",
    })?;
    set(&mut out, body.velocity, rate);
    if let Some(rotation) = &body.rotation {
        match rotation.angular_velocity {
            Some(components) => {
                quaternion_rates(
                    model, rotation, components, states, frames, motion, &mut out,
                )?;
            }
            None => angle_rates(model, rotation, states, frames, motion, &mut out)?,
        }
    }
    Ok(out)
}

fn set<T: Field>(out: &mut [T], indices: [usize; 3], v: Vector3<T>) {
    for (i, value) in indices.into_iter().zip(v.iter()) {
        out[i] = *value;
    }
}

/// Rates of the components of `vector` in a frame, from its rate of change `rate` in inertial components, by the
/// transport theorem. `None` if the angular velocity of the frame is undefined.
fn component_rates<T: Field>(
    frame: &PlacedFrame<T>,
    vector: Vector3<T>,
    rate: Vector3<T>,
) -> Option<Vector3<T>> {
    let transport = frame.angular_velocity?.cross(&vector);
    Some(frame.axes.transpose() * (rate - transport))
}

/// Writes the time derivatives of a body's attitude quaternion and angular velocity to `out`; `components` contains the
/// state indices of the angular velocity and the index of the frame of its components.
fn quaternion_rates<T: Field>(
    model: &Model,
    rotation: &Rotation,
    components: ([usize; 3], usize),
    states: &[T],
    frames: &[PlacedFrame<T>],
    motion: &Motion<T>,
    out: &mut [T],
) -> Result<(), Unsupported> {
    let omega = frames[rotation.body_frame]
        .angular_velocity
        .ok_or(Unsupported::FrameRate { vector: "the body" })?;
    let (components, frame) = components;
    let rate = component_rates(&frames[frame], omega, motion.angular_acceleration);
    let rate = rate.ok_or(Unsupported::FrameRate {
        vector: "the angular velocity",
    })?;
    set(out, components, rate);
    let FrameKind::Quaternion {
        parent: 0,
        states: q,
    } = model.frames[rotation.body_frame].kind
    else {
        return Err(Unsupported::Attitude);
    };
    let attitude = Quaternion::from_parts(q.map(|i| states[i]));
    // dq/dt = ω q / 2, ω in inertial components.
    let omega = Quaternion {
        w: T::zero(),
        v: omega,
    };
    for (i, part) in q.into_iter().zip(omega.times(attitude).parts()) {
        out[i] = part / T::integer(2);
    }
    Ok(())
}

/// Writes the time derivatives of all frame angles, and of the rates of the body's three angles, to `out`.
fn angle_rates<T: Field>(
    model: &Model,
    rotation: &Rotation,
    states: &[T],
    frames: &[PlacedFrame<T>],
    motion: &Motion<T>,
    out: &mut [T],
) -> Result<(), Unsupported> {
    let [first, second, third]: [ElementaryRotation<T>; 3] =
        elementary_rotations(model, frames, rotation.body_frame)
            .and_then(|rotations| rotations.try_into().ok())
            .ok_or(Unsupported::Rotations)?;
    // ω = Σ rate_i axis_i, so dω/dt = Σ (d rate_i/dt) axis_i + Σ rate_i (ω_parent,i × axis_i).
    let axes = Matrix3::from_columns(&[first.axis, second.axis, third.axis]);
    let drift = [&first, &second, &third]
        .iter()
        .fold(Vector3::zeros(), |sum, r| {
            sum + r.parent_angular_velocity.cross(&r.axis) * states[r.rate]
        });
    set(
        out,
        [first.rate, second.rate, third.rate],
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
    Ok(())
}
