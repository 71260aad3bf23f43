//! The body that a model with stated equations claims, and the laws of motion that its quantities obey: the position
//! changes by the velocity, the attitude by the angular velocity, the momentum by the force and the angular momentum by
//! the moment. Everything in inertial components.

use crate::attitude::{Quaternion, unit};
use crate::physical::Physical;
use crate::point::Point;
use crate::rigid::inertia_in_n;
use crate::scalar::{Dual, Real};
use crate::tree::Tree;
use model_spec::model::{ClaimedAttitude, ClaimedRotation};
use nalgebra::{Matrix3, Vector3};

/// Quantities of a claimed body at a point, in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClaimedBody<T> {
    /// Mass, kg.
    pub mass: T,
    /// Position of the mass centre, m.
    pub position: Vector3<T>,
    /// Velocity of the mass centre, m/s.
    pub velocity: Vector3<T>,
    /// Sum of the forces, N.
    pub force: Vector3<T>,
    /// Rotational motion; `None` for a point mass.
    pub turning: Option<Turning<T>>,
}

/// Rotational motion of a claimed body at a point, in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turning<T> {
    /// Axes, as columns, of the body-fixed frame, or of the frame of the axis of revolution.
    pub axes: Matrix3<T>,
    /// Number of the axis of revolution (1, 2 or 3) if that alone turns with the body; `None` if the frame does.
    pub axis: Option<u8>,
    /// Inertia tensor, kg·m².
    pub inertia: Matrix3<T>,
    /// Angular velocity, rad/s.
    pub angular_velocity: Vector3<T>,
    /// Sum of the moments about the mass centre, N·m.
    pub moment: Vector3<T>,
}

/// A law that a claimed body obeys.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum BalanceLaw {
    /// The position changes by the velocity.
    Position,
    /// The body-fixed frame, or the axis of revolution, turns with the angular velocity.
    Attitude,
    /// The momentum changes by the force.
    Momentum,
    /// The angular momentum changes by the moment.
    AngularMomentum,
}

impl BalanceLaw {
    /// Formula of the law.
    pub fn formula(self) -> &'static str {
        match self {
            Self::Position => "d(position)/dt = velocity",
            Self::Attitude => "d(axes)/dt = angular velocity × axes",
            Self::Momentum => "d(mass*velocity)/dt = force",
            Self::AngularMomentum => "d(inertia*angular velocity)/dt = moment",
        }
    }
}

/// Both sides of a law at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Balance<T> {
    /// The law.
    pub law: BalanceLaw,
    /// Rate of change, left-hand side.
    pub change: Vector3<T>,
    /// Cause of the change, right-hand side.
    pub cause: Vector3<T>,
}

impl<T: Real> ClaimedBody<T> {
    /// Quantities of the claimed body, from an evaluated vector tree; `None` if the model claims none.
    pub fn of(tree: &Tree<'_, T>) -> Option<Self> {
        let claim = tree.model.claim.as_ref()?;
        Some(Self {
            mass: tree.scalar(&claim.mass),
            position: tree.vector(&claim.position),
            velocity: tree.vector(&claim.velocity),
            force: tree.vector(&claim.force),
            turning: claim.rotation.as_ref().map(|r| Turning::of(tree, r)),
        })
    }

    /// Momentum, kg·m/s.
    pub fn momentum(&self) -> Vector3<T> {
        self.velocity * self.mass
    }

    /// Angular momentum about the mass centre, kg·m²/s; zero for a point mass.
    pub fn angular_momentum(&self) -> Vector3<T> {
        let turning = self.turning.as_ref();
        turning.map_or_else(Vector3::zeros, |t| t.inertia * t.angular_velocity)
    }

    /// Kinetic energy, J.
    pub fn kinetic_energy(&self) -> T {
        let mut twice = self.momentum().dot(&self.velocity);
        if let Some(turning) = &self.turning {
            twice += self.angular_momentum().dot(&turning.angular_velocity);
        }
        twice / T::integer(2)
    }

    /// Power of the force and the moment, W.
    pub fn power(&self) -> T {
        let of_moment = self
            .turning
            .as_ref()
            .map_or_else(T::zero, |t| t.moment.dot(&t.angular_velocity));
        self.force.dot(&self.velocity) + of_moment
    }
}

impl<T: Real> Turning<T> {
    fn of(tree: &Tree<'_, T>, rotation: &ClaimedRotation) -> Self {
        let (frame, axis) = match rotation.attitude {
            ClaimedAttitude::Frame(frame) => (frame, None),
            ClaimedAttitude::Axis(frame, axis) => (frame, Some(axis)),
        };
        let entries = Matrix3::from_fn(|i, j| tree.scalar(&rotation.inertia[i][j]));
        Self {
            axes: tree.frames[frame].axes,
            axis,
            inertia: inertia_in_n(&tree.frames[rotation.inertia_frame].axes, &entries),
            angular_velocity: tree.vector(&rotation.angular_velocity),
            moment: tree.vector(&rotation.moment),
        }
    }

    /// Numbers of the axes of [`Turning::axes`] that turn with the body.
    pub fn turning_axes(&self) -> Vec<u8> {
        self.axis.map_or_else(|| vec![1, 2, 3], |axis| vec![axis])
    }
}

impl ClaimedBody<f64> {
    /// The physical state. The spin angle of a body of revolution without a fixed frame is that of its frame.
    pub fn physical(&self) -> Physical<f64> {
        Physical {
            position: self.position,
            velocity: self.velocity,
            attitude: self
                .turning
                .as_ref()
                .map_or_else(Quaternion::identity, |t| Quaternion::from_matrix(&t.axes)),
            angular_velocity: self
                .turning
                .as_ref()
                .map_or_else(Vector3::zeros, |t| t.angular_velocity),
        }
    }
}

impl<T: Real> ClaimedBody<Dual<T>> {
    /// Both sides of every law, the derivatives of the dual numbers being those with respect to time.
    pub fn balances(&self) -> Vec<Balance<T>> {
        let derivative = |v: &Vector3<Dual<T>>| v.map(|d| d.derivative);
        let value = |v: &Vector3<Dual<T>>| v.map(|d| d.value);
        let balance = |law, changing: &Vector3<Dual<T>>, cause: Vector3<T>| Balance {
            law,
            change: derivative(changing),
            cause,
        };
        let mut out = vec![
            balance(BalanceLaw::Position, &self.position, value(&self.velocity)),
            balance(BalanceLaw::Momentum, &self.momentum(), value(&self.force)),
        ];
        if let Some(turning) = &self.turning {
            let omega = value(&turning.angular_velocity);
            for axis in turning.turning_axes() {
                let along = turning.axes * unit::<Dual<T>>(axis);
                let cause = omega.cross(&value(&along));
                out.push(balance(BalanceLaw::Attitude, &along, cause));
            }
            out.push(balance(
                BalanceLaw::AngularMomentum,
                &self.angular_momentum(),
                value(&turning.moment),
            ));
        }
        out
    }
}

/// A point that moves: states with given rates, and the time of the measuring clock with its rate against the time of
/// flight. Everything else stays.
pub fn moving<T: Real>(point: &Point<T>, rates: &[T], time_rate: T) -> Point<Dual<T>> {
    let mut out = point.map(Dual::constant);
    out.time.derivative = time_rate;
    for (state, rate) in out.states.iter_mut().zip(rates) {
        state.derivative = *rate;
    }
    out
}
