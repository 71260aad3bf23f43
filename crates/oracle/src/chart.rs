//! How a model's states stand for a physical state, and back: with quaternions throughout, where the
//! [`frames`](crate::frames) use matrices.

use crate::attitude::{Quaternion, unit};
use crate::physical::{Motion, Physical};
use crate::rigid::solve;
use crate::scalar::{Dual, Real};
use model_spec::model::{FrameKind, Model};
use nalgebra::{Matrix3, Vector3};

/// One step from the inertial frame to the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// A turn about an axis by the state `angle`, whose rate is the state `rate`.
    Turn {
        /// 1, 2 or 3.
        axis: u8,
        /// State of the angle.
        angle: usize,
        /// State of its rate.
        rate: usize,
    },
    /// A unit quaternion, scalar part first.
    Quaternion([usize; 4]),
}

/// Which state stands for what.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// The default of every state, at which those stay that stand for no part of the motion.
    pub defaults: Vec<f64>,
    /// Position in inertial components.
    pub position: [usize; 3],
    /// Velocity's components.
    pub velocity: [usize; 3],
    /// In the frame after so many steps.
    pub velocity_after: usize,
    /// From the inertial frame to the body's.
    pub steps: Vec<Step>,
    /// Components of the angular velocity, and the frame after so many steps, where they are states.
    pub angular_velocity: Option<([usize; 3], usize)>,
}

/// How a physical state changes, as the derivatives of a model's states tell it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// Velocity, by the change of the position.
    pub velocity: Vector3<f64>,
    /// Acceleration of the mass centre.
    pub acceleration: Vector3<f64>,
    /// Angular velocity, by the change of the attitude.
    pub angular_velocity: Vector3<f64>,
    /// Angular acceleration.
    pub angular_acceleration: Vector3<f64>,
}

impl Chart {
    /// The chart that a model's body declares; none for a body that this oracle cannot place.
    pub fn declared(model: &Model) -> Option<Self> {
        let body = model.body.as_ref()?;
        let mut chart = Self {
            defaults: defaults(model),
            position: body.position,
            velocity: body.velocity,
            velocity_after: 0,
            steps: Vec::new(),
            angular_velocity: None,
        };
        let Some(rotation) = &body.rotation else {
            return (body.velocity_frame == 0).then_some(chart);
        };
        let chain = chain(model, rotation.body_frame);
        for &frame in &chain[1..] {
            chart.steps.push(match model.frames[frame].kind {
                FrameKind::Turned {
                    axis, angle, rate, ..
                } => Step::Turn {
                    axis,
                    angle,
                    rate: rate?,
                },
                FrameKind::Quaternion { states, .. } => Step::Quaternion(states),
                FrameKind::Inertial => return None,
            });
        }
        let after = |frame: usize| chain.iter().position(|&f| f == frame);
        chart.velocity_after = after(body.velocity_frame)?;
        if let Some((components, frame)) = rotation.angular_velocity {
            chart.angular_velocity = Some((components, after(frame)?));
        }
        chart.sound().then_some(chart)
    }

    /// Either three turns with rates, one quaternion with an angular velocity, or a point.
    fn sound(&self) -> bool {
        match self.steps.as_slice() {
            [] => true,
            [Step::Quaternion(_)] => self.angular_velocity.is_some(),
            [Step::Turn { .. }, Step::Turn { .. }, Step::Turn { .. }] => {
                self.angular_velocity.is_none()
            }
            _ => false,
        }
    }

    /// Whether the body turns.
    pub fn turns(&self) -> bool {
        !self.steps.is_empty()
    }

    /// The physical state.
    pub fn physical<T: Real>(&self, states: &[T]) -> Physical<T> {
        let placed = self.place(states);
        let pick = |i: [usize; 3]| Vector3::from(i.map(|i| states[i]));
        let (attitude, turning) = placed[placed.len() - 1];
        let angular_velocity = match self.angular_velocity {
            Some((components, after)) => placed[after].0.carry(pick(components)),
            None => turning,
        };
        Physical {
            position: pick(self.position),
            velocity: placed[self.velocity_after].0.carry(pick(self.velocity)),
            attitude,
            angular_velocity,
        }
    }

    /// The derivatives of the states under a motion; of states that stand for no part of it 0.
    pub fn derivatives<T: Real>(&self, states: &[T], motion: &Motion<T>) -> Vec<T> {
        let mut out = vec![T::zero(); self.defaults.len()];
        let mut put = |indices: [usize; 3], v: Vector3<T>| {
            for (i, value) in indices.into_iter().zip(v.iter()) {
                out[i] = *value;
            }
        };
        let placed = self.place(states);
        let physical = self.physical(states);
        let omega = physical.angular_velocity;
        // Angular velocity of the frame after so many steps: a quaternion's frame is the body's.
        let turning = |after: usize| {
            if after > 0 && self.angular_velocity.is_some() {
                omega
            } else {
                placed[after].1
            }
        };
        let seen_from = |after: usize, rate: Vector3<T>, v: Vector3<T>| {
            placed[after].0.bring_back(rate - turning(after).cross(&v))
        };
        put(self.position, physical.velocity);
        put(
            self.velocity,
            seen_from(self.velocity_after, motion.acceleration, physical.velocity),
        );
        if let Some((components, after)) = self.angular_velocity {
            put(
                components,
                seen_from(after, motion.angular_acceleration, omega),
            );
        }
        match self.steps.as_slice() {
            [Step::Quaternion(q)] => {
                let rate = Quaternion {
                    w: T::zero(),
                    v: omega,
                }
                .times(physical.attitude);
                for (i, part) in q.iter().zip(rate.parts()) {
                    out[*i] = part * T::lit(0.5);
                }
            }
            [
                Step::Turn { rate: r1, .. },
                Step::Turn { rate: r2, .. },
                Step::Turn { rate: r3, .. },
            ] => {
                let mut axes = Matrix3::zeros();
                let mut rest = motion.angular_acceleration;
                for (k, step) in self.steps.iter().enumerate() {
                    let Step::Turn { axis, rate, .. } = *step else {
                        continue;
                    };
                    let axis = placed[k].0.axis(axis);
                    rest -= placed[k].1.cross(&axis) * states[rate];
                    axes.set_column(k, &axis);
                }
                put([*r1, *r2, *r3], solve(&axes, &rest));
                for step in &self.steps {
                    if let Step::Turn { angle, rate, .. } = *step {
                        out[angle] = states[rate];
                    }
                }
            }
            _ => {}
        }
        out
    }

    /// How the physical state changes when the states change at these rates.
    pub fn change(&self, states: &[f64], rates: &[f64]) -> Change {
        let along: Vec<Dual<f64>> = states
            .iter()
            .zip(rates)
            .map(|(&value, &rate)| Dual::new(value, rate))
            .collect();
        let p = self.physical(&along);
        let rate = |v: Vector3<Dual<f64>>| v.map(|d| d.derivative);
        let q = Quaternion::from_parts(p.attitude.parts().map(|d| d.value));
        let q_rate = Quaternion::from_parts(p.attitude.parts().map(|d| d.derivative));
        Change {
            velocity: rate(p.position),
            acceleration: rate(p.velocity),
            // ω = 2 dq/dt q*
            angular_velocity: q_rate.times(q.conjugate()).v * 2.0,
            angular_acceleration: rate(p.angular_velocity),
        }
    }

    /// The states that stand for a physical state; none for turns other than about 1, 2 and 3.
    pub fn states(&self, physical: &Physical<f64>) -> Option<Vec<f64>> {
        let mut out = self.defaults.clone();
        match self.steps.as_slice() {
            [] => {}
            [Step::Quaternion(q)] => {
                for (i, part) in q.iter().zip(physical.attitude.parts()) {
                    out[*i] = part;
                }
            }
            [
                Step::Turn {
                    axis: 1,
                    angle: a1,
                    rate: r1,
                },
                Step::Turn {
                    axis: 2,
                    angle: a2,
                    rate: r2,
                },
                Step::Turn {
                    axis: 3,
                    angle: a3,
                    rate: r3,
                },
            ] => {
                let m = physical.attitude.matrix();
                out[*a1] = (-m[(1, 2)]).atan2(m[(2, 2)]);
                out[*a2] = m[(0, 2)].clamp(-1.0, 1.0).asin();
                out[*a3] = (-m[(0, 1)]).atan2(m[(0, 0)]);
                let placed = self.place(&out);
                let axes = Matrix3::from_columns(
                    &[1, 2, 3].map(|k: u8| placed[usize::from(k) - 1].0.axis(k)),
                );
                let rates = solve(&axes, &physical.angular_velocity);
                (out[*r1], out[*r2], out[*r3]) = (rates.x, rates.y, rates.z);
            }
            _ => return None,
        }
        let placed = self.place(&out);
        let mut put = |indices: [usize; 3], v: Vector3<f64>| {
            for (i, value) in indices.into_iter().zip(v.iter()) {
                out[i] = *value;
            }
        };
        put(self.position, physical.position);
        put(
            self.velocity,
            placed[self.velocity_after].0.bring_back(physical.velocity),
        );
        if let Some((components, after)) = self.angular_velocity {
            put(
                components,
                placed[after].0.bring_back(physical.angular_velocity),
            );
        }
        Some(out)
    }

    /// Attitude and angular velocity after 0, 1, … steps; a quaternion's own turning is left out.
    fn place<T: Real>(&self, states: &[T]) -> Vec<(Quaternion<T>, Vector3<T>)> {
        let mut placed = vec![(Quaternion::identity(), Vector3::zeros())];
        for (k, step) in self.steps.iter().enumerate() {
            let (attitude, turning) = placed[k];
            placed.push(match *step {
                Step::Turn { axis, angle, rate } => (
                    attitude.times(Quaternion::turn(axis, states[angle])),
                    turning + attitude.carry(unit::<T>(axis)) * states[rate],
                ),
                Step::Quaternion(q) => (
                    attitude.times(Quaternion::from_parts(q.map(|i| states[i]))),
                    turning,
                ),
            });
        }
        placed
    }
}

/// The default of every state of a model.
pub fn defaults(model: &Model) -> Vec<f64> {
    model.states.iter().map(|s| s.value).collect()
}

/// Frames from the inertial one to `frame`.
fn chain(model: &Model, frame: usize) -> Vec<usize> {
    match model.frames[frame].kind {
        FrameKind::Inertial => vec![frame],
        FrameKind::Turned { parent, .. } | FrameKind::Quaternion { parent, .. } => {
            let mut frames = chain(model, parent);
            frames.push(frame);
            frames
        }
    }
}
