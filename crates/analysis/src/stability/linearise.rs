//! Linearised motion of a body about a state, in coordinates that do not depend on those of the model: displacement,
//! change of velocity (both in inertial axes), small rotation φ and change of angular velocity.
//!
//! The model's states s have the motion y = Y(s). With ẏ = Y′(s) f(s), a change δs changes ẏ by (Y′ J + Y″ f) δs, where
//! J = ∂f/∂s is exact. This yields the rows of acceleration and angular acceleration; the kinematic rows are written
//! explicitly: δṗ = δv and φ̇ = ω × φ + δω. The same body has the same matrix, whatever chart its model uses.

use flight::throw::{Motion, ThrowError, ThrownModel};
use flight::{BoundModel, CompiledModel, FlightParameters};
use model_spec::model::Model;
use nalgebra::{DMatrix, Matrix3, Vector3};
use ode::{DifferentiableRhs, OdeRhs};

use super::state_space::StateSpace;

/// Time step of the sixth-order central differences along a flight, s.
const STEP: f64 = 1e-4;
/// Weights of the values 1, 2 and 3 time steps before and after the instant.
const WEIGHTS: [f64; 3] = [45.0 / 60.0, -9.0 / 60.0, 1.0 / 60.0];

/// Largest part of a unit change of the motion (m, m/s, rad, rad/s) that the states of a free rigid body may miss, by
/// rounding or because the length of a quaternion has drifted; a constraint takes away a whole direction.
const REACHED: f64 = 1e-2;

/// Difference of the moments of inertia about axes across that of the spin, over their sum, up to which it is rounding.
const ROUND: f64 = 1e-9;

/// Reason why the motion of a body cannot be linearised.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StabilityError {
    /// None of the states of the model has the requested motion.
    #[error(transparent)]
    Throw(#[from] ThrowError),
    /// The model has no body, or one without attitude.
    #[error(
        "the model {0} has no body that turns, whose modes could be found; expected a rigid one, by `body` or by a \
         `claim` of what its states stand for"
    )]
    NoRigidBody(String),
    /// The states do not reach every motion of a free rigid body near the state.
    #[error(
        "the motion of {0} is constrained: its states do not reach every small change of position, velocity, \
         attitude and angular velocity; expected a free rigid body"
    )]
    Constrained(String),
    /// The linearised motion is not finite at the state.
    #[error(
        "the linearised motion is not finite there; expected a state within the model's limits"
    )]
    NotFinite,
}

/// A rigid body with the compiled functions of its model.
pub struct Body {
    /// The model.
    pub model: Model,
    /// Its compiled functions.
    pub compiled: CompiledModel,
    /// Conversion between states and motion.
    pub thrown: ThrownModel,
}

impl Body {
    /// Compiles a model for linearisation.
    ///
    /// # Errors
    /// [`StabilityError::NoRigidBody`] if the model has no body, or one without attitude.
    pub fn new(model: Model) -> Result<Body, StabilityError> {
        let thrown = ThrownModel::new(&model).ok();
        let Some(thrown) = thrown.filter(ThrownModel::has_attitude) else {
            return Err(StabilityError::NoRigidBody(model.name));
        };
        let compiled = CompiledModel::new(&model);
        Ok(Body {
            model,
            compiled,
            thrown,
        })
    }

    /// Binds the body to parameter values, in the order of the compiled model, and to inputs over time.
    pub fn with_parameters(&self, parameters: impl Into<FlightParameters>) -> BoundBody<'_> {
        let parameters = parameters.into();
        BoundBody {
            body: self,
            parameters: parameters.constants.clone(),
            bound: self.compiled.bind(parameters),
        }
    }
}

/// A rigid body with values of its parameters.
pub struct BoundBody<'b> {
    /// The rigid body.
    pub body: &'b Body,
    bound: BoundModel<'b>,
    /// Parameter values, in the order of the compiled model.
    pub parameters: Vec<f64>,
}

/// Linearised motion of a body about a state, and the motion there; vectors are in inertial axes.
#[derive(Clone, Debug)]
pub struct Linearised {
    /// Motion at the state.
    pub motion: Motion,
    /// Axis of the spin of the body: [`Turning::axis`](flight::throw::Turning::axis).
    pub axis: Vector3<f64>,
    /// Angular velocity, rad/s.
    pub rates: Vector3<f64>,
    /// Acceleration of the mass centre, m/s².
    pub acceleration: Vector3<f64>,
    /// Angular acceleration, rad/s².
    pub angular_acceleration: Vector3<f64>,
    /// Moment of inertia about that axis, and mean of those about the axes normal to it, kg m².
    pub inertia: (f64, f64),
    /// Whether the moments of inertia about all axes normal to it are equal.
    pub is_round: bool,
    /// 12 × 12 matrix A of ẋ = A x with x = (displacement, change of velocity, small rotation, change of angular
    /// velocity), SI.
    pub matrix: DMatrix<f64>,
    /// Linearised equations of the model, in its own states.
    pub state_space: StateSpace,
}

impl BoundBody<'_> {
    /// Linearises the motion about a state of the model at time `t`, s.
    ///
    /// # Errors
    /// [`StabilityError::Constrained`] if the states of the model do not reach every motion near the state;
    /// [`StabilityError::NotFinite`] if the linearised motion is not finite there.
    pub fn linearise(&self, t: f64, state: &[f64]) -> Result<Linearised, StabilityError> {
        flight::cancellation::stop_if_cancelled();
        let thrown = &self.body.thrown;
        let n = state.len();
        let mut rhs = self.bound.rhs();
        let mut f = vec![0.0; n];
        let mut entries = vec![0.0; rhs.jacobian_pattern().len()];
        let mut by_parameter = vec![0.0; rhs.parameter_jacobian_pattern().len()];
        rhs.derivative_with_jacobians(t, state, &mut f, &mut entries, &mut by_parameter);
        let mut jacobian = DMatrix::zeros(n, n);
        for ((row, column), value) in rhs.jacobian_pattern().iter().zip(&entries) {
            jacobian[(*row, *column)] += value;
        }
        let places = rhs.parameter_jacobian_pattern().iter();
        let by_parameter = places
            .zip(by_parameter)
            .map(|(at, value)| (at.0, at.1, value));
        let Body {
            model, compiled, ..
        } = self.body;
        let state_space = StateSpace::new(model, compiled.layout(), jacobian.clone(), by_parameter);
        let by_state = thrown.bind(&self.parameters).jacobian(state);
        // Y″ f: change of Y′ along the flight.
        let along = |h: f64| {
            let moved: Vec<f64> = state.iter().zip(&f).map(|(x, f)| x + h * f).collect();
            thrown.bind(&self.parameters).jacobian(&moved)
        };
        let mut bend = DMatrix::zeros(by_state.nrows(), n);
        for (k, weight) in WEIGHTS.into_iter().enumerate() {
            let h = (k + 1) as f64 * STEP;
            bend += (along(h) - along(-h)) * (weight / STEP);
        }
        let rates_by_state = &by_state * &jacobian + bend;
        let motion = thrown.motion(state, &self.parameters);
        let turning = motion.turning.as_ref().ok_or(StabilityError::NotFinite)?;
        let (axes, rates) = (turning.axes, turning.rates);
        // Changes of the motion along the twelve coordinates, and the changes of the state that cause them.
        let mut changes = DMatrix::zeros(by_state.nrows(), 12);
        for k in 0..3 {
            changes[(k, k)] = 1.0;
            changes[(3 + k, 3 + k)] = 1.0;
            let about = Vector3::ith(k, 1.0);
            for axis in 0..3 {
                let turned = about.cross(&axes.column(axis).into_owned());
                changes
                    .fixed_view_mut::<3, 1>(6 + 3 * axis, 6 + k)
                    .copy_from(&turned);
            }
            changes[(15 + k, 9 + k)] = 1.0;
        }
        let states = thrown.bind(&self.parameters).states_moved(state, &changes);
        let missed = &by_state * &states - &changes;
        // The first two axes of a body of revolution need not be fixed in it.
        let rows = (0..6).chain(12..18);
        let missed = rows.map(|row| missed.row(row).amax());
        if missed.fold(0.0, f64::max) > REACHED {
            let model = self.body.model.name.clone();
            return Err(StabilityError::Constrained(model));
        }
        let moved = rates_by_state * states;
        let mut matrix = DMatrix::zeros(12, 12);
        matrix
            .view_mut((0, 3), (3, 3))
            .copy_from(&Matrix3::identity());
        matrix
            .view_mut((3, 0), (3, 12))
            .copy_from(&moved.view((3, 0), (3, 12)));
        matrix
            .view_mut((6, 6), (3, 3))
            .copy_from(&rates.cross_matrix());
        matrix
            .view_mut((6, 9), (3, 3))
            .copy_from(&Matrix3::identity());
        matrix
            .view_mut((9, 0), (3, 12))
            .copy_from(&moved.view((15, 0), (3, 12)));
        if matrix.iter().any(|v| !v.is_finite()) {
            return Err(StabilityError::NotFinite);
        }
        let change = &by_state * nalgebra::DVector::from_column_slice(&f);
        let part = |row: usize| Vector3::new(change[row], change[row + 1], change[row + 2]);
        let axis = turning.axis();
        let inertia = thrown
            .inertia(state, &self.parameters)
            .unwrap_or_else(Matrix3::identity);
        let about = axis.dot(&(inertia * axis));
        let across = any_normal(axis);
        let other = axis.cross(&across);
        let product = |a: Vector3<f64>, b: Vector3<f64>| a.dot(&(inertia * b));
        let uneven =
            (product(across, across) - product(other, other)).hypot(2.0 * product(across, other));
        Ok(Linearised {
            is_round: uneven < ROUND * inertia.trace(),
            axis,
            rates,
            acceleration: part(3),
            angular_acceleration: part(15),
            inertia: (about, 0.5 * (inertia.trace() - about)),
            matrix,
            motion,
            state_space,
        })
    }

    /// Acceleration (m/s²) and angular acceleration (rad/s²) in inertial axes at a state; `None` if not finite.
    pub fn accelerations(&self, state: &[f64]) -> Option<(Vector3<f64>, Vector3<f64>)> {
        let mut f: Box<[f64]> = vec![0.0; state.len()].into();
        self.bound.rhs().derivative(0.0, &state.into(), &mut f);
        let thrown = &self.body.thrown;
        // Differences of the motion along the flight; velocities and rates depend smoothly on the state.
        let at = |h: f64| {
            let moved: Vec<f64> = state.iter().zip(&f).map(|(x, f)| x + h * f).collect();
            thrown.motion(&moved, &self.parameters)
        };
        let (mut acceleration, mut angular) = (Vector3::zeros(), Vector3::zeros());
        for (k, weight) in WEIGHTS.into_iter().enumerate() {
            let h = (k + 1) as f64 * STEP;
            let (up, down) = (at(h), at(-h));
            acceleration += (up.velocity - down.velocity) * (weight / STEP);
            angular += (up.turning?.rates - down.turning?.rates) * (weight / STEP);
        }
        let mut all = acceleration.iter().chain(&angular);
        all.all(|v| v.is_finite())
            .then_some((acceleration, angular))
    }

    /// Compiled model with the parameter values.
    pub fn bound(&self) -> &BoundModel<'_> {
        &self.bound
    }
}

/// A unit vector normal to the unit vector `n`.
pub(super) fn any_normal(n: Vector3<f64>) -> Vector3<f64> {
    n.cross(&Vector3::ith(n.iamin(), 1.0)).normalize()
}
