//! Flights of throws to the ground, with the derivatives of their paths by the numbers of the throw and by parameters.

use flight::release::Release;
use flight::throw::{FIELDS, Throw, ThrowError, ThrownModel};
use flight::{BoundModel, CompiledModel, DifferentiableModelRhs};
use model_spec::model::Model;
use nalgebra::Vector3;
use ode::{
    DifferentiableRhs, Event, IntegrationError, IntegrationOptions, Sensitivities,
    SensitivityLayout, Trajectory, integrate_to_event,
};

use crate::point::Point;

/// Reason why a throw has no flight.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ThrowFlightError {
    /// No state of the model has the motion of the throw.
    #[error(transparent)]
    Throw(#[from] ThrowError),
    /// The flight cannot be computed, or leaves the model's limits.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// The position of the mass centre is no part of the state.
    #[error(
        "the position of the body of the model {model} is not three of its states; expected a model whose body states \
         `position (x, y, z)`"
    )]
    NoPosition {
        /// Name of the model.
        model: String,
    },
}

/// What a path is differentiated by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// A number of the throw, by its index in [`FIELDS`].
    Throw(usize),
    /// A parameter, coefficient or component of an input, by its index in the model's layout.
    Parameter(usize),
}

/// A model that can be thrown, compiled.
pub struct ThrownBody {
    /// The model.
    pub model: Model,
    /// Its functions.
    pub compiled: CompiledModel,
    /// The motion of its body.
    pub thrown: ThrownModel,
    /// States that are the position of the mass centre, m.
    pub(crate) position: [usize; 3],
}

impl ThrownBody {
    /// Compiles a model.
    ///
    /// # Errors
    /// [`ThrowFlightError::Throw`] for a model without a body, [`ThrowFlightError::NoPosition`].
    pub fn new(model: Model) -> Result<ThrownBody, ThrowFlightError> {
        let (compiled, thrown) = (CompiledModel::new(&model), ThrownModel::new(&model)?);
        let layout = compiled.layout();
        let (state, parameters) = (layout.default_states(), layout.default_parameters());
        let jacobian = thrown.motion_jacobian(&state, &parameters);
        // A state is a coordinate where its column is 1 there and nothing else depends on it.
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
            _ => Err(ThrowFlightError::NoPosition {
                model: model.name.clone(),
            }),
        }
    }

    /// The body with the parameters of a release, whose initial states are not used.
    pub fn with(&self, release: &Release) -> ThrowFlights<'_> {
        self.with_parameters(self.compiled.release_parameters(release))
    }

    /// The body with values of its parameters, in the order of the model's layout.
    pub fn with_parameters(&self, parameters: Vec<f64>) -> ThrowFlights<'_> {
        ThrowFlights {
            body: self,
            bound: self.compiled.bind(parameters.clone()),
            parameters,
        }
    }

    /// Index in [`FIELDS`] of each number that a throw of this body can have.
    pub fn fields(&self) -> Vec<usize> {
        let has_attitude = self.thrown.has_attitude();
        let of_point = ["speed", "heading", "launch", "height"];
        let all = 0..FIELDS.len();
        all.filter(|k| has_attitude || of_point.contains(&FIELDS[*k].0))
            .collect()
    }
}

/// Flights of a body with given parameters. All start above the origin and end where the height of the mass centre falls to 0.
pub struct ThrowFlights<'b> {
    /// The body.
    pub body: &'b ThrownBody,
    pub(crate) bound: BoundModel<'b>,
    /// Parameters in the order of the model's layout.
    pub parameters: Vec<f64>,
}

impl ThrowFlights<'_> {
    /// State at release; `near` is the state of a similar throw, from which it is found sooner.
    ///
    /// # Errors
    /// [`ThrowError`]
    pub fn state(&self, throw: &Throw, near: Option<&[f64]>) -> Result<Vec<f64>, ThrowError> {
        let thrown = &self.body.thrown;
        match near {
            Some(near) => thrown.state_near(throw, [0.0; 2], &self.parameters, near),
            None => thrown.state(throw, [0.0; 2], &self.parameters),
        }
    }

    /// Flies from a state to the ground.
    ///
    /// # Errors
    /// [`IntegrationError`]
    pub fn trajectory(
        &self,
        state: &[f64],
        options: &IntegrationOptions,
    ) -> Result<Trajectory, IntegrationError> {
        let mut events = self.bound.limits();
        events.push(Event::falls_to("ground", self.body.position[2], 0.0).terminal());
        let start: Box<[f64]> = state.into();
        let end = Release::MAX_DURATION;
        integrate_to_event(
            &mut self.bound.rhs(),
            (0.0, &start),
            end,
            options,
            &mut events,
        )
    }

    pub(crate) fn sensitivities(
        &self,
        of_throw: usize,
        of_parameters: &[usize],
    ) -> Sensitivities<DifferentiableModelRhs<'_>> {
        let rhs = self.bound.differentiable_rhs();
        // Which states the first columns are named after is of no account: they start along directions of the throw.
        Sensitivities::new(rhs, &vec![0; of_throw], of_parameters)
    }

    /// Derivative of the state at release by a parameter: where the wobble turns on the moments of inertia, or what a claimed
    /// body's motion depends on.
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

    /// Position (m), velocity and acceleration of the mass centre at a state, and the derivatives of the first two along the
    /// columns of S, `None` where there is none.
    pub(crate) fn point(
        &self,
        t: f64,
        x: &[f64],
        s: Option<(SensitivityLayout, &[usize])>,
    ) -> Point {
        let mut rhs = self.bound.differentiable_rhs();
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

    /// Name of a parameter by its index in the model's layout.
    pub fn parameter_name(&self, index: usize) -> &str {
        &self.body.compiled.layout().parameters[index]
    }
}
