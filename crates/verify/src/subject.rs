//! Subject of a verification: a model, and its equations of motion as functions that can be evaluated.

use crate::balance_rank;
use crate::options::TOLERANCE;
use crate::pairing::Pairing;
use crate::row::Row;
use model_spec::Layout;
use model_spec::model::{Body, Model};
use nalgebra::Vector3;
use oracle::scalar::{Dual, ErrorBound, Field, Real};
use oracle::{
    Balance, BindError, Chart, ClaimedBody, MassProperties, Point, Reference, Tree, Unsupported,
    derivatives, derivatives_of, inertia_in_n, moving,
};

/// Equations of motion that can be evaluated at a point, independent of the backend.
pub trait Equations: Sync {
    /// Derivative of every state with respect to recorded time, in state order.
    fn rates(&self, point: &Point<f64>) -> Vec<f64>;
    /// Observation (marker position) in inertial components; `None` if the model has no observation.
    fn observation(&self, point: &Point<f64>) -> Option<Vector3<f64>>;
    /// Magnitude of the terms of every state derivative and component of the observation; empty if unknown.
    fn magnitudes(&self, _point: &Point<f64>) -> Vec<f64> {
        Vec::new()
    }
    /// State derivatives and observation in 256 bits, if a number on the way to them is beyond the range of `f64`; `None`
    /// also if unknown.
    fn overflowing(&self, _point: &Point<f64>) -> Option<Vec<f64>> {
        None
    }
}

/// A model to be checked, its equations of motion, and its reference law.
pub struct Subject<'a> {
    /// The checked model.
    pub model: &'a Model,
    /// Equations of motion under test.
    pub equations: &'a dyn Equations,
    /// Reference law that the model names; `None` if it names none or cannot be bound.
    pub reference: Option<Reference>,
    /// Why the reference law cannot be bound to the model.
    pub unbound: Option<BindError>,
    /// Chart of the reference law, else of the declared body.
    pub chart: Option<Chart>,
}

impl<'a> Subject<'a> {
    /// Binds a model to its equations, its reference law and its chart.
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

    /// Seconds of flight per second of recorded time, at a point.
    pub fn clock(&self, point: &Point<f64>) -> f64 {
        match &self.model.clock {
            Some(_) => Tree::new(self.model, point).clock(),
            None => 1.0,
        }
    }

    /// Derivative of every state with respect to true time.
    pub fn flight_rates(&self, point: &Point<f64>) -> Vec<f64> {
        let pace = self.clock(point);
        let rates = self.equations.rates(point);
        rates.into_iter().map(|rate| rate / pace).collect()
    }

    /// The point of the model `other` with the same time, marker and physical state; other values are copied by name
    /// where both models have it. `None` without charts, or if the attitude cannot be represented.
    pub fn corresponding_point(
        &self,
        other: &Subject<'_>,
        here: &Point<f64>,
    ) -> Option<Point<f64>> {
        let physical = self.chart.as_ref()?.physical(&here.states);
        let mut states = other.chart.as_ref()?.states(&physical)?;
        let pairing = Pairing::of(&Layout::new(self.model), &Layout::new(other.model));
        let carried = pairing.carry(here, &Point::defaults(other.model));
        for state in other.model.added_states() {
            states[state] = carried.states[state];
        }
        Some(Point { states, ..carried })
    }

    /// Index and null value of each coefficient that the reference law lacks or, without one, of each effect.
    pub fn extras(&self) -> Vec<(usize, f64)> {
        match &self.reference {
            Some(reference) => reference.null_values(self.model),
            None => self.of_effects().collect(),
        }
    }

    /// Index and null value of the coefficients of all effects.
    fn of_effects(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let coefficients = self.model.effects.iter().flat_map(|e| &e.coefficients);
        coefficients.map(|c| (c.index, c.null_value))
    }

    /// Coefficients that neither the reference law nor an effect contains; empty without a reference law.
    pub fn own_coefficients(&self) -> Vec<usize> {
        let of_effects: Vec<usize> = self.of_effects().map(|(index, _)| index).collect();
        let extras = self.extras().into_iter().map(|(index, _)| index);
        extras.filter(|i| !of_effects.contains(i)).collect()
    }

    /// Whether only the `claim` statement relates the states to a body.
    pub fn is_known_by_claim(&self) -> bool {
        self.chart.is_none() && self.model.claim.is_some()
    }

    /// The point with effects and added states at their null and default values.
    pub fn without_effects(&self, point: Point<f64>) -> Point<f64> {
        self.of_body_alone(point, self.of_effects())
    }

    /// Skips a check that requires a reference law if a declared or claimed body makes up for it, else unverified.
    pub fn without_reference(&self, check: &'static str) -> Row {
        if self.model.body.is_some() {
            return Row::skipped(check, "the model claims no reference");
        }
        if self.model.claim.is_some() || !self.model.balances.is_empty() {
            let why = "the model claims no reference; the body that it claims holds its equations";
            return Row::skipped(check, why);
        }
        let why = "its equations are stated, and it claims neither a reference nor a body";
        Row::unverified(check, why)
    }

    /// Result of a check that needs the meaning of the states, for a model where it is unknown: skipped if claimed
    /// balances determine every equation, else unverified.
    pub fn without_meaning(&self, check: &'static str) -> Row {
        if self.model.balances.is_empty() {
            return Row::unverified(check, "which state stands for what is not known");
        }
        if balance_rank::determine_all_rates(self.model) {
            return Row::skipped(check, "the claimed balances determine every equation");
        }
        let why = "the claimed balances do not determine the rate of every state: claim further ones, such as of \
                   positions by velocities and of the angular momentum";
        Row::unverified(check, why)
    }

    /// The point with the coefficients of [`Self::extras`] and added states at their null and default values.
    pub fn without_extras(&self, point: Point<f64>) -> Point<f64> {
        self.of_body_alone(point, self.extras())
    }

    /// The point with the coefficients set to the given values (index, value) and added states at their defaults.
    fn of_body_alone(
        &self,
        mut point: Point<f64>,
        coefficients: impl IntoIterator<Item = (usize, f64)>,
    ) -> Point<f64> {
        for (index, value) in coefficients {
            point.coefficients[index] = value;
        }
        // Other bodies are no additions: they may hang on this one.
        let of_others = self.model.states_of_further_bodies();
        let mut added = self.model.added_states();
        added.retain(|state| !of_others.contains(state));
        for state in added {
            point.states[state] = self.model.states[state].value;
        }
        crate::constrained::project(self.model, &mut point);
        point
    }
}

/// Mass properties of a declared body, with the inertia in the body frame.
pub(crate) fn body_properties<T: Real>(tree: &Tree<'_, T>, body: &Body) -> MassProperties<T> {
    let mut properties = tree.mass_properties(body);
    if let (Some(rotation), Some(inertia)) = (&body.rotation, properties.inertia) {
        let turn = tree.frames[rotation.body_frame].axes.transpose()
            * tree.frames[rotation.inertia_frame].axes;
        properties.inertia = Some(inertia_in_n(&turn, &inertia));
    }
    properties
}

/// Equations of motion evaluated by the oracle from the vector expressions.
pub struct Interpreted<'a>(&'a Model);

impl<'a> Interpreted<'a> {
    /// The equations of a model; [`Unsupported`] if the oracle cannot derive them.
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

/// A value and its derivative with respect to true time, with bounds of the rounding error.
pub type Bounded = Dual<ErrorBound>;

/// The claimed body moving as by [`moving_as_stated`]; `None` without a claim or equations.
pub fn along(subject: &Subject<'_>, point: &Point<f64>) -> Option<ClaimedBody<Bounded>> {
    subject.model.claim.as_ref()?;
    let point = moving_as_stated(subject, point)?;
    ClaimedBody::of(&Tree::new(subject.model, &point))
}

/// The point moving as the equations under test state, with bounds of the vector tree; `None` without equations.
pub fn moving_as_stated(subject: &Subject<'_>, point: &Point<f64>) -> Option<Point<Bounded>> {
    let lifted = point.lift::<ErrorBound>();
    let tree = Tree::new(subject.model, &lifted);
    let pace = tree.clock();
    let bounds = derivatives_of(&tree).ok()?;
    let rates = subject.equations.rates(point);
    if rates.len() != bounds.len() {
        return None;
    }
    let rates: Vec<ErrorBound> = rates
        .into_iter()
        .zip(bounds)
        .map(|(value, bound)| {
            let magnitude = bound.magnitude.max(value.abs());
            ErrorBound { value, magnitude } / pace
        })
        .collect();
    Some(moving(&lifted, &rates, ErrorBound::integer(1) / pace))
}

/// Difference between both sides of a law, by component, relative to the magnitudes of the terms.
pub fn errors(balance: &Balance<ErrorBound>) -> [f64; 3] {
    let difference = balance.change - balance.cause;
    difference.map(|d| d.relative_error(0.0)).into()
}

/// Whether a relative error is too large to be due to rounding, or NaN.
pub fn is_fault(error: f64) -> bool {
    error.is_nan() || error > TOLERANCE
}
