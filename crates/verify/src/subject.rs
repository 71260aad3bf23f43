//! What is checked: a model, and its equations in a form that can be evaluated.

use model_spec::model::Model;
use nalgebra::Vector3;
use oracle::{BindError, Chart, Point, Reference, Tree, Unsupported, derivatives};

/// Equations of motion that can be evaluated, however that is done.
pub trait Equations: Sync {
    /// The derivative of every state.
    fn rates(&self, point: &Point<f64>) -> Vec<f64>;
    /// What is observed, in inertial components.
    fn observation(&self, point: &Point<f64>) -> Option<Vector3<f64>>;
}

/// A model and its equations.
pub struct Subject<'a> {
    /// The model.
    pub model: &'a Model,
    /// Its equations.
    pub equations: &'a dyn Equations,
    /// The law that it claims, tied to its names.
    pub reference: Option<Reference>,
    /// Why its reference implementation cannot be bound.
    pub unbound: Option<BindError>,
    /// Which state stands for what: by the names of the reference, else by the body's declaration.
    pub chart: Option<Chart>,
}

impl<'a> Subject<'a> {
    /// Ties a model to its equations and its reference.
    pub fn new(model: &'a Model, equations: &'a dyn Equations) -> Self {
        let (reference, unbound) = match Reference::bind(model) {
            Some(Ok(reference)) => (Some(reference), None),
            Some(Err(why)) => (None, Some(why)),
            None => (None, None),
        };
        let chart = reference
            .as_ref()
            .map(|r| r.chart.clone())
            .or_else(|| Chart::declared(model));
        Self {
            model,
            equations,
            reference,
            unbound,
            chart,
        }
    }

    /// Seconds of flight that pass in a second of the clock, at a point.
    pub fn clock(&self, point: &Point<f64>) -> f64 {
        match &self.model.clock {
            Some(_) => Tree::new(self.model, point).clock(),
            None => 1.0,
        }
    }

    /// The derivative of every state by the flight's own time, which the laws of motion speak of.
    pub fn flight_rates(&self, point: &Point<f64>) -> Vec<f64> {
        let pace = self.clock(point);
        let rates = self.equations.rates(point);
        rates.into_iter().map(|rate| rate / pace).collect()
    }

    /// The point of another model with the same physical state, time, marker, and constants and inputs of equal names;
    /// `None` if a chart is missing or cannot represent the attitude.
    pub fn corresponding_point(
        &self,
        other: &Subject<'_>,
        here: &Point<f64>,
    ) -> Option<Point<f64>> {
        let physical = self.chart.as_ref()?.physical(&here.states);
        let mut there = Point::defaults(other.model);
        there.states = other.chart.as_ref()?.states(&physical)?;
        for state in other.model.added_states() {
            let name = &other.model.states[state].name;
            if let Some(same) = self.model.states.iter().position(|s| s.name == *name) {
                there.states[state] = here.states[same];
            }
        }
        there.time = here.time;
        there.marker = here.marker;
        let value = |name: &str| {
            let param = self
                .model
                .params
                .iter()
                .position(|c| c.name == name)
                .map(|i| here.params[i]);
            let coefficient = self.model.coefficients.iter().position(|c| c.name == name);
            param.or_else(|| coefficient.map(|i| here.coefficients[i]))
        };
        for (constant, to) in other.model.params.iter().zip(&mut there.params) {
            *to = value(&constant.name).unwrap_or(*to);
        }
        for (constant, to) in other.model.coefficients.iter().zip(&mut there.coefficients) {
            *to = value(&constant.name).unwrap_or(*to);
        }
        for (input, to) in other.model.inputs.iter().zip(&mut there.inputs) {
            *to = self
                .model
                .inputs
                .iter()
                .position(|i| i.name == input.name)
                .map_or(*to, |i| here.inputs[i]);
        }
        Some(there)
    }

    /// Coefficients that the reference does not know, or those of effects where there is no reference,
    /// each with the value at which it leaves the law as it is.
    pub fn extras(&self) -> Vec<(usize, f64)> {
        match &self.reference {
            Some(reference) => reference.null_values(self.model),
            None => {
                let of_effects = self.model.effects.iter().flat_map(|e| &e.coefficients);
                of_effects.map(|c| (c.index, c.null_value)).collect()
            }
        }
    }

    /// The point with those coefficients at that value, and added states at their defaults.
    pub fn without_extras(&self, mut point: Point<f64>) -> Point<f64> {
        for (index, value) in self.extras() {
            point.coefficients[index] = value;
        }
        for state in self.model.added_states() {
            point.states[state] = self.model.states[state].value;
        }
        point
    }
}

/// A model's equations by the tree oracle.
pub struct Interpreted<'a>(&'a Model);

impl<'a> Interpreted<'a> {
    /// Takes a model whose equations the tree oracle can derive.
    pub fn new(model: &'a Model) -> Result<Self, Unsupported> {
        derivatives(model, &Point::defaults(model)).map(|_| Self(model))
    }
}

impl Equations for Interpreted<'_> {
    fn rates(&self, point: &Point<f64>) -> Vec<f64> {
        derivatives(self.0, point).unwrap_or_default()
    }

    fn observation(&self, point: &Point<f64>) -> Option<Vector3<f64>> {
        let seen = self.0.observation.as_ref()?;
        Some(Tree::new(self.0, point).vector(&seen.value))
    }
}

/// Equations with their Jacobians.
pub trait Differentiable: Equations {
    /// Everything at once, zeros included.
    fn derivatives(&self, point: &Point<f64>) -> Derivatives;
    /// By the states alone, of the states alone, as the shorter function for it gives them.
    fn by_state(&self, point: &Point<f64>) -> Derivatives;
}

/// Values and Jacobians; rows are the states' derivatives, then the observation's components; columns
/// the states, then parameters, coefficients and components of inputs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Derivatives {
    /// Values of the rows.
    pub values: Vec<f64>,
    /// Entries row by row.
    pub entries: Vec<Vec<f64>>,
}

impl Derivatives {
    /// One column.
    pub fn column(&self, j: usize) -> Vec<f64> {
        self.entries.iter().map(|row| row[j]).collect()
    }

    /// Whether every number is one.
    pub fn finite(&self) -> bool {
        self.values
            .iter()
            .chain(self.entries.iter().flatten())
            .all(|v| v.is_finite())
    }
}
