//! Conversion between the states of a model and a physical state. Attitudes are represented by quaternions here, and by
//! matrices in the vector tree.

use crate::attitude::{Quaternion, unit};
use crate::physical::{Motion, Physical, solve};
use crate::scalar::{Dual, Real};
use model_spec::model::{FrameKind, Model};
use nalgebra::{Matrix3, Vector3};

/// Rotation about an axis by an angle that is a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Turn {
    /// Axis of rotation: 1, 2 or 3.
    pub axis: u8,
    /// Index of the state that is the angle, rad.
    pub angle: usize,
    /// Index of the state that is the rate of the angle, rad/s.
    pub rate: usize,
}

/// States that are the attitude of a body: the rotations from the inertial frame to the body frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Attitude {
    /// None: a point mass.
    Point,
    /// Three rotations in sequence; their rates are the angular velocity.
    Turns([Turn; 3]),
    /// A unit quaternion: indices of its four states, scalar part first; and the state indices of the angular velocity
    /// components, with the number of rotations, 0 or 1, that lead from the inertial frame to the frame of these
    /// components.
    Quaternion([usize; 4], ([usize; 3], usize)),
}

/// Coordinate chart: physical meaning of each state of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// Default value of every state; states that describe neither position, velocity, attitude nor angular velocity
    /// have these values when a physical state is converted to states.
    pub defaults: Vec<f64>,
    /// State indices of the position components, in the inertial frame.
    pub position: [usize; 3],
    /// State indices of the velocity components. They are given in the frame to which the first `velocity_after`
    /// rotations of `attitude` lead from the inertial frame.
    pub velocity: [usize; 3],
    /// Number of rotations from the inertial frame to the frame of the velocity components.
    pub velocity_after: usize,
    /// States that are the attitude of the body.
    pub attitude: Attitude,
}

/// Rate of change of the physical state of a body, in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhysicalRate {
    /// Rate of the position, that is the velocity of the mass centre, in inertial components, m/s.
    pub velocity: Vector3<f64>,
    /// Acceleration of the mass centre in inertial components, m/s².
    pub acceleration: Vector3<f64>,
    /// Angular velocity computed from the rate of the attitude, in inertial components, rad/s.
    pub angular_velocity: Vector3<f64>,
    /// Angular acceleration of the body in inertial components, rad/s².
    pub angular_acceleration: Vector3<f64>,
}

impl Chart {
    /// Coordinate chart of the declared body; `None` without one or if its sequence of rotations is not supported.
    pub fn declared(model: &Model) -> Option<Self> {
        let body = model.body.as_ref()?;
        let mut chart = Self {
            defaults: defaults(model),
            position: body.position,
            velocity: body.velocity,
            velocity_after: 0,
            attitude: Attitude::Point,
        };
        let Some(rotation) = &body.rotation else {
            return (body.velocity_frame == 0).then_some(chart);
        };
        let chain = chain(model, rotation.body_frame);
        let after = |frame: usize| chain.iter().position(|&f| f == frame);
        let turn = |frame: &usize| match model.frames[*frame].kind {
            FrameKind::Turned {
                axis, angle, rate, ..
            } => Some(Turn {
                axis,
                angle,
                rate: rate?,
            }),
            _ => None,
        };
        chart.velocity_after = after(body.velocity_frame)?;
        chart.attitude = match (&chain[1..], rotation.angular_velocity) {
            ([frame], Some((components, of))) => match model.frames[*frame].kind {
                FrameKind::Quaternion { states, .. } => {
                    Attitude::Quaternion(states, (components, after(of)?))
                }
                _ => return None,
            },
            (frames, None) => {
                let turns = frames.iter().map(turn).collect::<Option<Vec<Turn>>>()?;
                Attitude::Turns(turns.try_into().ok()?)
            }
            _ => return None,
        };
        Some(chart)
    }

    /// Whether the states describe the attitude of a body; false for a point mass.
    pub fn has_attitude(&self) -> bool {
        self.attitude != Attitude::Point
    }

    /// Converts the states of a model to the physical state that they describe.
    pub fn physical<T: Real>(&self, states: &[T]) -> Physical<T> {
        let placed = self.attitudes_along(states);
        let pick = |i: [usize; 3]| Vector3::from(i.map(|i| states[i]));
        let (attitude, rate) = placed[placed.len() - 1];
        let angular_velocity = match self.attitude {
            Attitude::Quaternion(_, (components, after)) => placed[after].0.carry(pick(components)),
            _ => rate,
        };
        Physical {
            position: pick(self.position),
            velocity: placed[self.velocity_after].0.carry(pick(self.velocity)),
            attitude,
            angular_velocity,
        }
    }

    /// Time derivatives of the states for the accelerations in `motion`; 0 for states that describe neither position,
    /// velocity, attitude nor angular velocity.
    pub fn derivatives<T: Real>(&self, states: &[T], motion: &Motion<T>) -> Vec<T> {
        let mut out = vec![T::zero(); self.defaults.len()];
        let mut put = |indices: [usize; 3], v: Vector3<T>| {
            for (i, value) in indices.into_iter().zip(v.iter()) {
                out[i] = *value;
            }
        };
        let placed = self.attitudes_along(states);
        let physical = self.physical(states);
        let omega = physical.angular_velocity;
        // The frame of a quaternion is the body frame.
        let is_quaternion = matches!(self.attitude, Attitude::Quaternion(..));
        let component_rates = |after: usize, rate: Vector3<T>, v: Vector3<T>| {
            let (attitude, of_turns) = placed[after];
            let frame_rate = if after > 0 && is_quaternion {
                omega
            } else {
                of_turns
            };
            attitude.bring_back(rate - frame_rate.cross(&v))
        };
        put(self.position, physical.velocity);
        put(
            self.velocity,
            component_rates(self.velocity_after, motion.acceleration, physical.velocity),
        );
        match self.attitude {
            Attitude::Point => {}
            Attitude::Quaternion(q, (components, after)) => {
                let rates = component_rates(after, motion.angular_acceleration, omega);
                put(components, rates);
                let rate = Quaternion {
                    w: T::zero(),
                    v: omega,
                }
                .times(physical.attitude);
                for (i, part) in q.into_iter().zip(rate.parts()) {
                    out[i] = part * T::lit(0.5);
                }
            }
            Attitude::Turns(turns) => {
                let mut axes = Matrix3::zeros();
                let mut rest = motion.angular_acceleration;
                for (k, turn) in turns.iter().enumerate() {
                    let axis = placed[k].0.axis(turn.axis);
                    rest -= placed[k].1.cross(&axis) * states[turn.rate];
                    axes.set_column(k, &axis);
                }
                put(turns.map(|turn| turn.rate), solve(&axes, &rest));
                for turn in turns {
                    out[turn.angle] = states[turn.rate];
                }
            }
        }
        out
    }

    /// Converts time derivatives of the states to the rate of change of the physical state of the body.
    pub fn physical_rate(&self, states: &[f64], rates: &[f64]) -> PhysicalRate {
        let along: Vec<Dual<f64>> = states
            .iter()
            .zip(rates)
            .map(|(&value, &rate)| Dual::new(value, rate))
            .collect();
        let p = self.physical(&along);
        let rate = |v: Vector3<Dual<f64>>| v.map(|d| d.derivative);
        let q = Quaternion::from_parts(p.attitude.parts().map(|d| d.value));
        let q_rate = Quaternion::from_parts(p.attitude.parts().map(|d| d.derivative));
        PhysicalRate {
            velocity: rate(p.position),
            acceleration: rate(p.velocity),
            // ω = 2 dq/dt q*
            angular_velocity: q_rate.times(q.conjugate()).v * 2.0,
            angular_acceleration: rate(p.angular_velocity),
        }
    }

    /// Converts the physical state of a body to the states of a model. `None` if two consecutive rotations from the
    /// inertial frame to the body frame are about the same axis.
    pub fn states(&self, physical: &Physical<f64>) -> Option<Vec<f64>> {
        let mut out = self.defaults.clone();
        match self.attitude {
            Attitude::Point => {}
            Attitude::Quaternion(q, _) => {
                for (i, part) in q.into_iter().zip(physical.attitude.parts()) {
                    out[i] = part;
                }
            }
            Attitude::Turns(turns) => {
                let axes = turns.map(|turn| turn.axis);
                let angles = angles(&physical.attitude.matrix(), axes)?;
                for (turn, angle) in turns.iter().zip(angles) {
                    out[turn.angle] = angle;
                }
                let placed = self.attitudes_along(&out);
                let columns = [0, 1, 2].map(|k| placed[k].0.axis(axes[k]));
                let rates = solve(&Matrix3::from_columns(&columns), &physical.angular_velocity);
                for (turn, rate) in turns.iter().zip(rates.iter()) {
                    out[turn.rate] = *rate;
                }
            }
        }
        let placed = self.attitudes_along(&out);
        let mut put = |indices: [usize; 3], after: usize, v: Vector3<f64>| {
            let components = placed[after].0.bring_back(v);
            for (i, value) in indices.into_iter().zip(components.iter()) {
                out[i] = *value;
            }
        };
        put(self.position, 0, physical.position);
        put(self.velocity, self.velocity_after, physical.velocity);
        if let Attitude::Quaternion(_, (components, after)) = self.attitude {
            put(components, after, physical.angular_velocity);
        }
        Some(out)
    }

    /// Attitude and angular velocity of the frames reached from the inertial frame after 0, 1, … rotations of
    /// `attitude`; angular velocities are in inertial components, rad/s. Quaternion rotations add no angular velocity.
    fn attitudes_along<T: Real>(&self, states: &[T]) -> Vec<(Quaternion<T>, Vector3<T>)> {
        let mut placed = vec![(Quaternion::identity(), Vector3::zeros())];
        match self.attitude {
            Attitude::Point => {}
            Attitude::Quaternion(q, _) => {
                placed.push((
                    Quaternion::from_parts(q.map(|i| states[i])),
                    Vector3::zeros(),
                ));
            }
            Attitude::Turns(turns) => {
                for (k, turn) in turns.iter().enumerate() {
                    let (attitude, angular_velocity): (Quaternion<T>, Vector3<T>) = placed[k];
                    let axis = attitude.carry(unit::<T>(turn.axis));
                    placed.push((
                        attitude.times(Quaternion::turn(turn.axis, states[turn.angle])),
                        angular_velocity + axis * states[turn.rate],
                    ));
                }
            }
        }
        placed
    }
}

/// Angles of three consecutive rotations, each about the given axis of the frame rotated so far, from the rotation
/// matrix `m` to the inertial frame; `None` if two consecutive rotations are about the same axis.
fn angles(m: &Matrix3<f64>, axes: [u8; 3]) -> Option<[f64; 3]> {
    let [i, j, k] = axes.map(|axis| usize::from(axis) - 1);
    if i == j || j == k {
        return None;
    }
    let other = 3 - i - j;
    // 1 if (i, j, other) is an even permutation of the axes, otherwise -1.
    let sign = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
    Some(if i == k {
        [
            m[(j, i)].atan2(-sign * m[(other, i)]),
            m[(i, i)].clamp(-1.0, 1.0).acos(),
            m[(i, j)].atan2(sign * m[(i, other)]),
        ]
    } else {
        [
            (-sign * m[(j, k)]).atan2(m[(k, k)]),
            (sign * m[(i, k)]).clamp(-1.0, 1.0).asin(),
            (-sign * m[(i, j)]).atan2(m[(i, i)]),
        ]
    })
}

pub(crate) fn defaults(model: &Model) -> Vec<f64> {
    model.states.iter().map(|s| s.value).collect()
}

/// Indices of the frames from the inertial frame through the parents of `frame` to `frame`, both included.
fn chain(model: &Model, frame: usize) -> Vec<usize> {
    match model.frames[frame].kind {
        FrameKind::Inertial => vec![frame],
        FrameKind::Turned { parent, .. }
        | FrameKind::Fixed { parent, .. }
        | FrameKind::Quaternion { parent, .. } => {
            let mut frames = chain(model, parent);
            frames.push(frame);
            frames
        }
    }
}
