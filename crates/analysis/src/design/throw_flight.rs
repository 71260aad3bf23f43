//! Bodies that can be thrown, and the data for integrating their flights with derivatives with respect to the
//! quantities of the throw and to parameters.

use flight::release::Release;
use flight::throw::{FIELDS, Throw, ThrowError, ThrownModel};
use flight::{BoundModel, CompiledModel, FlightParameters};
use model_spec::model::Model;
use nalgebra::{Vector2, Vector3};
use ode::{
    DifferentiableRhs, Event, IntegrationError, IntegrationOptions, SensitivityLayout, Trajectory,
};

/// Reason why the flight of a throw cannot be computed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ThrowFlightError {
    /// No state of the model has the motion of the throw.
    #[error(transparent)]
    Throw(#[from] ThrowError),
    /// The flight cannot be computed, leaves the model's limits or does not end.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// The position of the mass centre is not given by three states of the model, so no landing can be detected.
    #[error(
        "the position of the body of the model {0} is not three of its states; expected a model whose body states \
         `position (x, y, z)`"
    )]
    NoPosition(String),
}

/// Quantity with respect to which a path is differentiated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// A quantity of the throw, by its index in [`FIELDS`].
    Throw(usize),
    /// A parameter, coefficient or component of an input, by its index among the parameters of the compiled model.
    Parameter(usize),
}

/// A compiled model of a body that can be thrown, with the conversion between throws and its states.
pub struct ThrownBody {
    /// The model.
    pub model: Model,
    /// Its compiled functions.
    pub compiled: CompiledModel,
    /// Conversion between throws and states.
    pub thrown: ThrownModel,
    /// Indices of the states that are the position x, y, z of the mass centre, m.
    pub(crate) position: [usize; 3],
}

impl ThrownBody {
    /// Compiles a model.
    ///
    /// # Errors
    /// [`ThrowFlightError::Throw`] if the model has no body; [`ThrowFlightError::NoPosition`] if the coordinates of the
    /// mass centre are not states of the model.
    pub fn new(model: Model) -> Result<ThrownBody, ThrowFlightError> {
        let (compiled, thrown) = (CompiledModel::new(&model), ThrownModel::new(&model)?);
        let layout = compiled.layout();
        let (state, parameters) = (layout.default_states(), layout.default_parameters());
        let jacobian = thrown.bind(&parameters).jacobian(&state);
        // A state is a coordinate if its entry of the Jacobian row is 1 and all others are 0.
        let coordinate = |row: usize| {
            let is_one = |column: usize| (jacobian[(row, column)] - 1.0).abs() < 1e-9;
            let alone = |c: &usize| {
                let mut others = (0..state.len()).filter(|k| k != c);
                others.all(|k| jacobian[(row, k)].abs() < 1e-9)
            };
            (0..state.len()).filter(|c| is_one(*c)).find(alone)
        };
        match [coordinate(0), coordinate(1), coordinate(2)] {
            [Some(x), Some(y), Some(z)] => Ok(ThrownBody {
                position: [x, y, z],
                compiled,
                thrown,
                model,
            }),
            _ => Err(ThrowFlightError::NoPosition(model.name.clone())),
        }
    }

    /// Prepares flights of the body with the parameters of a release; the initial states of the release are not used.
    pub fn with(&self, release: &Release) -> ThrowFlights<'_> {
        self.with_parameters(self.compiled.release_parameters(release))
    }

    /// Prepares flights with values of the parameters, in the order of the compiled model, and inputs over time.
    pub fn with_parameters(&self, parameters: impl Into<FlightParameters>) -> ThrowFlights<'_> {
        let parameters = parameters.into();
        ThrowFlights {
            body: self,
            bound: self.compiled.bind(parameters.clone()),
            parameters: parameters.constants,
        }
    }

    /// Indices in [`FIELDS`] of the quantities that a throw of this body can have; a point mass has no attitude.
    pub fn fields(&self) -> Vec<usize> {
        let has_attitude = self.thrown.has_attitude();
        let of_point = ["speed", "heading", "launch", "height"];
        let all = 0..FIELDS.len();
        all.filter(|k| has_attitude || of_point.contains(&FIELDS[*k].0))
            .collect()
    }
}

/// Flights of a body with given parameters, from above the origin to where the height of the mass centre falls to 0.
pub struct ThrowFlights<'b> {
    /// The body that flies.
    pub body: &'b ThrownBody,
    pub(crate) bound: BoundModel<'b>,
    /// Parameter values, in the order of the compiled model.
    pub parameters: Vec<f64>,
}

impl ThrowFlights<'_> {
    /// State at release for which the body has the motion of the throw. `near` is that of a similar throw, or none.
    ///
    /// # Errors
    /// [`ThrowError`] if no state has the motion of the throw.
    pub fn state(&self, throw: &Throw, near: Option<&[f64]>) -> Result<Vec<f64>, ThrowError> {
        let thrown = &self.body.thrown;
        match near {
            Some(near) => thrown.state_near(throw, [0.0; 2], &self.parameters, near),
            None => thrown.state(throw, [0.0; 2], &self.parameters),
        }
    }

    /// Integrates the flight from a state at release to the ground, without derivatives.
    ///
    /// # Errors
    /// [`IntegrationError`] if the integration fails, or the flight leaves the model's limits or does not end.
    pub fn trajectory(
        &self,
        state: &[f64],
        options: &IntegrationOptions,
    ) -> Result<Trajectory, IntegrationError> {
        flight::cancellation::stop_if_cancelled();
        let mut events = self.bound.limits();
        events.push(Event::falls_to("ground", self.body.position[2], 0.0).terminal());
        let start: Box<[f64]> = state.into();
        let end = Release::MAX_DURATION;
        self.bound
            .integrate_to_event((0.0, &start), end, options, &mut events)
    }

    /// Derivative of the state at release of a throw with respect to a parameter, by central differences. It is 0 unless
    /// the throw has a wobble or the parameter affects how the state determines the motion.
    pub(crate) fn state_by_parameter(
        &self,
        throw: &Throw,
        state: &[f64],
        parameter: usize,
    ) -> Vec<f64> {
        let thrown = &self.body.thrown;
        let own = self.parameters[parameter];
        let step = 1e-4 * own.abs().max(1e-6);
        let at = |value: f64| {
            let mut parameters = self.parameters.clone();
            parameters[parameter] = value;
            thrown.state_near(throw, [0.0; 2], &parameters, state).ok()
        };
        let still = vec![0.0; state.len()];
        let mut moved = self.parameters.clone();
        moved[parameter] = own + step;
        let wobbles = throw.wobble.is_some_and(|wobble| wobble != 0.0);
        let depends = thrown.motion(state, &moved) != thrown.motion(state, &self.parameters);
        if !wobbles && !depends {
            return still;
        }
        match (at(own + step), at(own - step)) {
            (Some(up), Some(down)) => {
                let both = up.iter().zip(&down);
                both.map(|(up, down)| (up - down) / (2.0 * step)).collect()
            }
            _ => still,
        }
    }

    /// Motion of the mass centre at the states `x`, which the sensitivity matrix S follows in the layout that `s` gives;
    /// with its derivatives for the columns of S that `s` lists.
    pub(crate) fn point(
        &self,
        t: f64,
        x: &[f64],
        s: Option<(SensitivityLayout, &[usize])>,
    ) -> Point {
        let mut rhs = self.bound.rhs();
        let states = self.body.compiled.layout().states.len();
        let mut dx = vec![0.0; states];
        let mut jacobian = vec![0.0; rhs.jacobian_pattern().len()];
        let mut by_parameter = vec![0.0; rhs.parameter_jacobian_pattern().len()];
        rhs.derivative_with_jacobians(t, &x[..states], &mut dx, &mut jacobian, &mut by_parameter);
        let vector = |of: &dyn Fn(usize) -> f64| Vector3::from(self.body.position.map(of));
        let row = |state: usize, of: &dyn Fn(usize) -> f64| -> f64 {
            let entries = rhs.jacobian_pattern().iter().zip(&jacobian);
            let own = entries.filter(|((row, _), _)| *row == state);
            own.map(|((_, column), value)| value * of(*column)).sum()
        };
        let mut point = Point {
            t,
            position: vector(&|state| x[state]),
            velocity: vector(&|state| dx[state]),
            acceleration: vector(&|state| row(state, &|k| dx[k])),
            position_by: Vec::new(),
            velocity_by: Vec::new(),
        };
        let Some((layout, columns)) = s else {
            return point;
        };
        for &column in columns {
            let entry = |state: usize| layout.padded_row(x, state)[column];
            point.position_by.push(vector(&entry));
            point.velocity_by.push(vector(&|state| row(state, &entry)));
        }
        point
    }

    /// Position of the mass centre at a state, m.
    pub(crate) fn place(&self, x: &[f64]) -> Vector3<f64> {
        Vector3::from(self.body.position.map(|state| x[state]))
    }
}

/// Motion of the mass centre at a point of its path, SI units, inertial frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Time since release, s.
    pub t: f64,
    /// Position of the mass centre in the inertial frame, m.
    pub position: Vector3<f64>,
    /// Velocity of the mass centre in the inertial frame, m/s.
    pub velocity: Vector3<f64>,
    /// Acceleration of the mass centre in the inertial frame, m/s².
    pub acceleration: Vector3<f64>,
    /// Derivatives of the position at fixed time, m per unit of each quantity by which the path is differentiated.
    pub position_by: Vec<Vector3<f64>>,
    /// Derivatives of the velocity at fixed time, m/s per unit of each quantity.
    pub velocity_by: Vec<Vector3<f64>>,
}

impl Point {
    /// Derivatives of the time of the nearest point `self` of the path to `to`, s per unit of each quantity.
    pub fn nearest_time_by(&self, to: Vector3<f64>) -> Vec<f64> {
        let away = self.position - to;
        let slope = self.velocity.norm_squared() + away.dot(&self.acceleration);
        let both = self.position_by.iter().zip(&self.velocity_by);
        both.map(|(p, v)| -(p.dot(&self.velocity) + away.dot(v)) / slope)
            .collect()
    }

    /// Horizontal unit vector to the left of the path, x and y.
    pub fn left(&self) -> Vector2<f64> {
        let along = self.velocity.normalize();
        let left = Vector3::z().cross(&along);
        match left.norm() {
            size if size > 1e-9 => (left / size).xy(),
            _ => Vector2::y(),
        }
    }
}
