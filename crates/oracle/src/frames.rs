//! Frames of a model at a state: axes and angular velocities in inertial components.

use crate::attitude::{Quaternion, unit};
use crate::point::Point;
use crate::scalar::{Field, Real};
use model_spec::model::{FrameKind, Model};
use nalgebra::{Matrix3, Vector3};

/// Axes and angular velocity of a coordinate frame at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedFrame<T> {
    /// Rotation matrix to inertial components: the axes as columns.
    pub axes: Matrix3<T>,
    /// Angular velocity in inertial components, rad/s; `None` if the model does not define it.
    pub angular_velocity: Option<Vector3<T>>,
}

/// Rotation of a frame about one axis of its parent frame; vectors are in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElementaryRotation<T> {
    /// Axis of rotation, a unit vector in inertial components.
    pub axis: Vector3<T>,
    /// Angular velocity of the parent frame in inertial components, rad/s.
    pub parent_angular_velocity: Vector3<T>,
    /// Index of the state that is the rate of the rotation angle, rad/s.
    pub rate: usize,
}

/// Computes the axes and angular velocities of all frames of a model; `constant_angles` are the values of
/// [`Model::constant_angles`], rad.
pub fn place_frames<T: Real>(
    model: &Model,
    point: &Point<T>,
    constant_angles: &[T],
) -> Vec<PlacedFrame<T>> {
    let states = &point.states;
    let mut placed: Vec<PlacedFrame<T>> = Vec::with_capacity(model.frames.len());
    for (index, frame) in model.frames.iter().enumerate() {
        placed.push(match frame.kind {
            FrameKind::Inertial => PlacedFrame {
                axes: Matrix3::identity(),
                angular_velocity: Some(Vector3::zeros()),
            },
            FrameKind::Turned {
                parent,
                angle,
                rate,
                axis,
            } => {
                let parent = placed[parent];
                let (s, c) = (states[angle].sin(), states[angle].cos());
                let rates = parent.angular_velocity.zip(rate);
                PlacedFrame {
                    axes: parent.axes * rotated(axis, s, c),
                    angular_velocity: rates
                        .map(|(w, rate)| w + parent.axes * unit::<T>(axis) * states[rate]),
                }
            }
            FrameKind::Fixed {
                parent,
                angle,
                axis,
            } => {
                let angle = constant_angles[angle];
                let parent = placed[parent];
                PlacedFrame {
                    axes: parent.axes * rotated(axis, angle.sin(), angle.cos()),
                    ..parent
                }
            }
            FrameKind::Quaternion { parent, states: q } => {
                let axes =
                    placed[parent].axes * Quaternion::from_parts(q.map(|i| states[i])).matrix();
                PlacedFrame {
                    axes,
                    angular_velocity: None,
                }
            }
        });
        let declared = model.rotation();
        if let Some((rotation, (components, frame))) =
            declared.and_then(|r| Some((r, r.angular_velocity?)))
            && rotation.body_frame == index
        {
            // The angular velocity components may refer to this frame, whose axes are now known.
            placed[index].angular_velocity =
                Some(placed[frame].axes * Vector3::from(components.map(|i| states[i])));
        }
    }
    placed
}

/// Elementary rotations that lead from the inertial frame to `frame`, in this order; `placed` contains the axes and
/// angular velocities of all frames of the model. `None` if one of the rotations is given by a quaternion, or the rate
/// of its angle or the angular velocity of a parent frame is undefined.
pub fn elementary_rotations<T: Field>(
    model: &Model,
    placed: &[PlacedFrame<T>],
    frame: usize,
) -> Option<Vec<ElementaryRotation<T>>> {
    match model.frames[frame].kind {
        FrameKind::Inertial => Some(Vec::new()),
        FrameKind::Quaternion { .. } => None,
        FrameKind::Fixed { parent, .. } => elementary_rotations(model, placed, parent),
        FrameKind::Turned {
            parent, rate, axis, ..
        } => {
            let mut chain = elementary_rotations(model, placed, parent)?;
            let axis = placed[parent].axes * unit::<T>(axis);
            chain.push(ElementaryRotation {
                axis,
                parent_angular_velocity: placed[parent].angular_velocity?,
                rate: rate?,
            });
            Some(chain)
        }
    }
}

/// Axes, as columns in the parent frame, of a frame rotated about an axis; `s` and `c`: sine and cosine of the angle.
fn rotated<T: Field>(axis: u8, s: T, c: T) -> Matrix3<T> {
    let (o, l) = (T::zero(), T::one());
    match axis {
        1 => Matrix3::new(l, o, o, o, c, -s, o, s, c),
        2 => Matrix3::new(c, o, s, o, l, o, -s, o, c),
        _ => Matrix3::new(c, -s, o, s, c, o, o, o, l),
    }
}
