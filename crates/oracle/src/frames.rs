//! Where the frames of a model stand: their axes as columns in inertial components, and how they turn.

use crate::attitude::{Quaternion, unit};
use crate::scalar::{Field, Real};
use model_spec::model::{FrameKind, Model};
use nalgebra::{Matrix3, Vector3};

/// A frame at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed<T> {
    /// Its axes as columns, in inertial components.
    pub axes: Matrix3<T>,
    /// Its angular velocity in inertial components, where the model has one for it.
    pub turning: Option<Vector3<T>>,
}

/// A turn of a frame relative to its parent, as seen from the inertial frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn<T> {
    /// Axis of the turn.
    pub axis: Vector3<T>,
    /// Angular velocity of the parent, which carries the axis.
    pub carried: Vector3<T>,
    /// State that holds the rate.
    pub rate: usize,
}

/// All frames of a model, where `circle` gives the sine and cosine of a state.
pub fn place<T: Field>(
    model: &Model,
    states: &[T],
    circle: impl Fn(usize) -> (T, T),
) -> Vec<Placed<T>> {
    let mut placed: Vec<Placed<T>> = Vec::with_capacity(model.frames.len());
    for (index, frame) in model.frames.iter().enumerate() {
        placed.push(match frame.kind {
            FrameKind::Inertial => Placed {
                axes: Matrix3::identity(),
                turning: Some(Vector3::zeros()),
            },
            FrameKind::Turned {
                parent,
                angle,
                rate,
                axis,
            } => {
                let parent = placed[parent];
                let (s, c) = circle(angle);
                let turning = parent.turning.zip(rate);
                Placed {
                    axes: parent.axes * turned(axis, s, c),
                    turning: turning
                        .map(|(w, rate)| w + parent.axes * unit::<T>(axis) * states[rate]),
                }
            }
            FrameKind::Quaternion { parent, states: q } => {
                let axes =
                    placed[parent].axes * Quaternion::from_parts(q.map(|i| states[i])).matrix();
                Placed {
                    axes,
                    turning: None,
                }
            }
        });
        let given = model.body.as_ref().and_then(|b| b.rotation.as_ref());
        if let Some((rotation, (components, frame))) =
            given.and_then(|r| Some((r, r.angular_velocity?)))
            && rotation.body_frame == index
        {
            // The components may be those of this very frame, which stands by now.
            placed[index].turning =
                Some(placed[frame].axes * Vector3::from(components.map(|i| states[i])));
        }
    }
    placed
}

/// All frames of a model at a state.
pub fn place_real<T: Real>(model: &Model, states: &[T]) -> Vec<Placed<T>> {
    place(model, states, |i| (states[i].sin(), states[i].cos()))
}

/// The turns that lead from the inertial frame to `frame`, outermost first; none if one of them is a quaternion.
pub fn turns<T: Field>(model: &Model, placed: &[Placed<T>], frame: usize) -> Option<Vec<Turn<T>>> {
    match model.frames[frame].kind {
        FrameKind::Inertial => Some(Vec::new()),
        FrameKind::Quaternion { .. } => None,
        FrameKind::Turned {
            parent, rate, axis, ..
        } => {
            let mut chain = turns(model, placed, parent)?;
            let axis = placed[parent].axes * unit::<T>(axis);
            chain.push(Turn {
                axis,
                carried: placed[parent].turning?,
                rate: rate?,
            });
            Some(chain)
        }
    }
}

/// Columns: the axes of a frame turned about `axis`, in the frame that was turned.
fn turned<T: Field>(axis: u8, s: T, c: T) -> Matrix3<T> {
    let (o, l) = (T::zero(), T::one());
    match axis {
        1 => Matrix3::new(l, o, o, o, c, -s, o, s, c),
        2 => Matrix3::new(c, o, s, o, l, o, -s, o, c),
        _ => Matrix3::new(c, -s, o, s, c, o, o, o, l),
    }
}
