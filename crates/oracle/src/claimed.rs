//! The body that a model with stated equations claims to describe, and the laws of motion for its quantities: the
//! velocity changes the position, the angular velocity the attitude, the force the momentum, and the moment the angular
//! momentum. All vectors are in inertial components.

use crate::attitude::{Quaternion, unit};
use crate::physical::{Physical, inertia_in_n};
use crate::point::Point;
use crate::scalar::{Dual, Real};
use crate::tree::Tree;
use model_spec::model::{ClaimedAttitude, ClaimedRotation};
use nalgebra::{Matrix3, Vector3};

/// Mass, motion, force and moment of the body that a model claims to describe, for one set of values of states and
/// parameters. Such a model writes its equations of motion explicitly; they should satisfy the laws of motion of this
/// body. Vectors are in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClaimedBody<T> {
    /// Mass, kg.
    pub mass: T,
    /// Position of the mass centre in inertial components, m.
    pub position: Vector3<T>,
    /// Velocity of the mass centre in inertial components, m/s.
    pub velocity: Vector3<T>,
    /// Sum of the forces on the body in inertial components, N.
    pub force: Vector3<T>,
    /// Rotational motion; `None` for a point mass.
    pub turning: Option<Turning<T>>,
}

/// Rotational motion of the claimed body at a point, in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turning<T> {
    /// Axes, as columns, of the body-fixed frame or of a frame that contains the axis of revolution.
    pub axes: Matrix3<T>,
    /// Axis of revolution (1, 2 or 3) if only this axis moves with the body; `None` if the whole frame does.
    pub axis: Option<u8>,
    /// Inertia tensor about the mass centre in inertial components, kg·m².
    pub inertia: Matrix3<T>,
    /// Angular velocity of the body in inertial components, rad/s.
    pub angular_velocity: Vector3<T>,
    /// Sum of the moments on the body about its mass centre, in inertial components, N·m.
    pub moment: Vector3<T>,
}

/// A law of motion that must hold for the body that a model with explicitly written equations claims to describe.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum BalanceLaw {
    /// The rate of change of the position is the velocity.
    Position,
    /// The body-fixed frame, or the axis of revolution, rotates with the angular velocity.
    Attitude,
    /// The rate of change of the momentum is the force.
    Momentum,
    /// The rate of change of the angular momentum is the moment.
    AngularMomentum,
}

impl BalanceLaw {
    /// Formula of the law, as text.
    pub fn formula(self) -> &'static str {
        match self {
            Self::Position => "d(position)/dt = velocity",
            Self::Attitude => "d(axes)/dt = angular velocity × axes",
            Self::Momentum => "d(mass*velocity)/dt = force",
            Self::AngularMomentum => "d(inertia*angular velocity)/dt = moment",
        }
    }
}

/// Left- and right-hand side of a law of motion, for one set of values of states and parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Balance<T> {
    /// Law of motion whose sides are given.
    pub law: BalanceLaw,
    /// Left-hand side of the law: rate of change of the position, an axis, the momentum or the angular momentum, SI.
    pub change: Vector3<T>,
    /// Right-hand side of the law of motion: the cause of the change, such as the force, in SI units.
    pub cause: Vector3<T>,
}

impl<T: Real> ClaimedBody<T> {
    /// Evaluates the quantities of the claimed body; `tree` is the model at a point. `None` without a claim.
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

    /// Momentum of the body in inertial components, kg·m/s.
    pub fn momentum(&self) -> Vector3<T> {
        self.velocity * self.mass
    }

    /// Angular momentum about the mass centre in inertial components, kg·m²/s; zero for a point mass.
    pub fn angular_momentum(&self) -> Vector3<T> {
        let turning = self.turning.as_ref();
        turning.map_or_else(Vector3::zeros, |t| t.inertia * t.angular_velocity)
    }

    /// Kinetic energy of the body, translational and rotational, J.
    pub fn kinetic_energy(&self) -> T {
        let mut twice = self.momentum().dot(&self.velocity);
        if let Some(turning) = &self.turning {
            twice += self.angular_momentum().dot(&turning.angular_velocity);
        }
        twice / T::integer(2)
    }

    /// Power of the force and the moment on the body, W.
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

    /// Numbers (1, 2 or 3) of the axes in [`Turning::axes`] that move with the body.
    pub fn turning_axes(&self) -> Vec<u8> {
        self.axis.map_or_else(|| vec![1, 2, 3], |axis| vec![axis])
    }
}

impl ClaimedBody<f64> {
    /// Physical state of the body that the model claims to describe. For a body of revolution without a body-fixed
    /// frame, the attitude is that of the frame that contains the axis of revolution.
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
    /// Both sides of every law of motion of the body; the derivatives must be those by time.
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

/// Point with derivatives with respect to true time: the states change at the given rates, and [`Point::time`], which
/// is recorded time, at `time_rate`. All other values are constant.
pub fn moving<T: Real>(point: &Point<T>, rates: &[T], time_rate: T) -> Point<Dual<T>> {
    let mut out = point.map(Dual::constant);
    out.time.derivative = time_rate;
    for (state, rate) in out.states.iter_mut().zip(rates) {
        state.derivative = *rate;
    }
    out
}
