//! Curve of the quantity that an effect changes, over the variable on which the effect depends.

use dataset::Role;
use dataset::statistics::median;
use diagnose::{identifier, intervals};
use identify::{Fit, FlightId};
use model_spec::model::{Expr, ExprKind, Model, Shape};
use model_spec::sort_by_number;
use nalgebra::{DMatrix, DVector};

use super::super::Fits;
use crate::angle::{is_angle, is_angle_state};
use crate::bands::covariance;
use crate::figures::axis::range;

/// Number of intervals of the abscissa.
const INTERVALS: usize = 32;
/// Minimum number of samples in an interval for a point, and maximum number at which the quantity is evaluated.
const SAMPLES: (usize, usize) = (4, 7);
const MAX_SAMPLES: usize = 20_000;
/// Minimum change along a curve that is drawn, relative to the largest value.
const FLAT: f64 = 1e-6;

/// Unit of angles on the abscissa.
const DEGREE: &str = "°";

/// Curve of a quantity of the extended model over a variable, and the same in the model under test at the same states.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Curve {
    pub(in super::super) quantity: Variable,
    pub(in super::super) over: Variable,
    /// In ascending order of the variable.
    pub(in super::super) points: Vec<Point>,
}

/// Variable of a curve.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Variable {
    pub(in super::super) name: String,
    /// Documentation, of the abscissa up to the first comma; may be empty.
    pub(in super::super) doc: String,
    /// SI, or `°` for an angle on the abscissa.
    pub(in super::super) unit: String,
}

/// Point of a curve: medians over the samples within one interval of the abscissa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in super::super) struct Point {
    /// Variable on the abscissa.
    pub(in super::super) x: f64,
    /// Quantity in the model under test; NaN if it lacks the quantity.
    pub(in super::super) before: f64,
    /// Quantity in the extended model.
    pub(in super::super) after: f64,
    /// Its standard error.
    pub(in super::super) error: f64,
    /// Number of samples in the interval.
    pub(in super::super) samples: usize,
}

/// Where the values of a variable are in the data of a flight.
#[derive(Clone, Copy)]
enum Column {
    State(usize),
    /// Among the quantities of the compiled model.
    Quantity(usize),
    Time,
}

/// Curve of the first scalar quantity of these effects that is not constant, over a variable on which it depends.
pub(super) fn of<'n>(fits: &Fits<'_>, effects: impl IntoIterator<Item = &'n str>) -> Option<Curve> {
    let after = fits.after?;
    let model = &after.problem().model;
    effects.into_iter().find_map(|name| {
        let mut known = model.effects.iter();
        let index = known.position(|e| e.name == identifier(name))?;
        let own = model.aux_variables.iter().enumerate();
        let own = own.filter(|(_, v)| v.effect == Some(index) && v.value.shape == Shape::Scalar);
        let mut own = own.map(|(at, _)| at);
        own.find_map(|at| curve(fits.before, after, at, abscissa(after, at, index)?))
    })
}

/// Scalar variable on which the auxiliary variable `at` depends, preferably one that the effect declares.
fn abscissa(after: &Fit, at: usize, effect: usize) -> Option<(Variable, Column)> {
    let model = &after.problem().model;
    let mut found = Vec::new();
    collect(model, &model.aux_variables[at].value, effect, &mut found);
    let layout = after.problem().body.layout();
    let of = |name: &str, doc: &str, is_angle: bool, unit: String| Variable {
        name: name.to_owned(),
        doc: doc.split(',').next().unwrap_or_default().to_owned(),
        unit: if is_angle { DEGREE.to_owned() } else { unit },
    };
    let usable = found.into_iter().filter_map(|kind| match kind {
        ExprKind::State(k) => {
            let own = &model.states[*k];
            let variable = of(&own.name, "", is_angle_state(own), own.unit.to_string());
            Some((variable, Column::State(*k)))
        }
        ExprKind::Time => Some((of("time", "", false, "s".to_owned()), Column::Time)),
        ExprKind::AuxVariable(k) => {
            let own = &model.aux_variables[*k];
            let unit = own.value.unit.to_string();
            let variable = of(&own.name, &own.doc, is_angle(&own.value), unit);
            let column = layout.quantity(&own.name)?.index();
            Some((variable, Column::Quantity(column)))
        }
        _ => None,
    });
    let mut usable: Vec<(Variable, Column)> = usable.collect();
    let named = &model.effects[effect].variables;
    let first = usable.iter().position(|(own, _)| named.contains(&own.name));
    (!usable.is_empty()).then(|| usable.swap_remove(first.unwrap_or(0)))
}

/// Appends the scalar variables that `expr` reads; one that the effect defines is replaced by those in its definition.
fn collect<'m>(model: &'m Model, expr: &'m Expr, effect: usize, found: &mut Vec<&'m ExprKind>) {
    match &expr.kind {
        ExprKind::AuxVariable(k) if model.aux_variables[*k].effect == Some(effect) => {
            collect(model, &model.aux_variables[*k].value, effect, found);
        }
        kind @ (ExprKind::AuxVariable(_) | ExprKind::State(_) | ExprKind::Time)
            if expr.shape == Shape::Scalar =>
        {
            found.push(kind);
        }
        _ => {
            for child in expr.children() {
                collect(model, child, effect, found);
            }
        }
    }
}

/// Sample of a fitted flight: flight, time, state, and value of the abscissa.
struct Sample<'f> {
    flight: FlightId,
    t: f64,
    state: &'f [f64],
    x: f64,
}

fn curve(
    before: &Fit,
    after: &Fit,
    at: usize,
    (over, column): (Variable, Column),
) -> Option<Curve> {
    let variable = &after.problem().model.aux_variables[at];
    let models = Models::new(before, after, &variable.name);
    let flights = after.report.flights.iter().enumerate();
    let fitted = flights.filter(|(_, flight)| flight.role == Role::Fit);
    let fitted = fitted.map(|(index, _)| FlightId::new(index));
    let evidence: Vec<_> = fitted
        .filter_map(|id| Some((id, after.evidence(id)?)))
        .collect();
    let all: usize = evidence.iter().map(|(_, f)| f.times.len()).sum();
    let step = all.div_ceil(MAX_SAMPLES).max(1);
    let mut samples = Vec::new();
    for (flight, found) in &evidence {
        for i in (0..found.times.len()).step_by(step) {
            let x = match column {
                Column::State(k) => found.states[i][k],
                Column::Quantity(k) => found.quantities[i][k],
                Column::Time => found.times[i],
            };
            let is_angle = over.unit == DEGREE;
            samples.push(Sample {
                flight: *flight,
                t: found.times[i],
                state: &found.states[i],
                x: if is_angle { x.to_degrees() } else { x },
            });
        }
    }
    samples.retain(|s| s.x.is_finite());
    sort_by_number(&mut samples, |sample| sample.x);
    let points = points(&samples, &models);
    let (low, high) = range(points.iter().map(|p| p.after));
    let is_drawn = points.len() >= 3 && high - low > FLAT * low.abs().max(high.abs());
    is_drawn.then(|| Curve {
        quantity: Variable {
            name: variable.name.clone(),
            doc: variable.doc.clone(),
            unit: variable.value.unit.to_string(),
        },
        over,
        points,
    })
}

/// A point for each interval of the abscissa with enough samples, which are sorted by the abscissa.
fn points(samples: &[Sample<'_>], models: &Models<'_>) -> Vec<Point> {
    let interval = |(from, step): (f64, f64)| {
        let below = |x: f64| samples.partition_point(|s| s.x < x);
        let inside = &samples[below(from)..below(from + step)];
        if inside.len() < SAMPLES.0 {
            return None;
        }
        let every = inside.len().div_ceil(SAMPLES.1);
        let chosen: Vec<&Sample<'_>> = inside.iter().skip(every / 2).step_by(every).collect();
        let values: Vec<[f64; 3]> = chosen.iter().map(|sample| models.values(sample)).collect();
        let middle = |of: usize| median(&mut values.iter().map(|v| v[of]).collect::<Vec<_>>());
        Some(Point {
            x: median(&mut chosen.iter().map(|s| s.x).collect::<Vec<_>>()),
            before: middle(0),
            after: middle(1),
            error: middle(2),
            samples: inside.len(),
        })
    };
    let all: Vec<f64> = samples.iter().map(|s| s.x).collect();
    intervals(&all, INTERVALS).filter_map(interval).collect()
}

/// Fits with which the quantity and its standard error are evaluated.
struct Models<'f> {
    before: &'f Fit,
    after: &'f Fit,
    quantity: &'f str,
    /// Finite-difference step of each common parameter: its standard error, or 0.
    steps: Vec<f64>,
    /// Correlation matrix of these parameters.
    correlations: DMatrix<f64>,
}

impl<'f> Models<'f> {
    fn new(before: &'f Fit, after: &'f Fit, quantity: &'f str) -> Models<'f> {
        let globals = after.problem().globals.iter();
        let names: Vec<&str> = globals.map(|g| g.name.as_str()).collect();
        let covariance = covariance(&after.report, &names);
        let steps: Vec<f64> = covariance.diagonal().iter().map(|v| v.sqrt()).collect();
        let of = |i: usize| if steps[i] > 0.0 { 1.0 / steps[i] } else { 0.0 };
        Models {
            before,
            after,
            quantity,
            correlations: covariance.map_with_location(|i, j, c| c * of(i) * of(j)),
            steps,
        }
    }

    /// Value in both models, and the standard error in the extended one; NaN if it is not known.
    fn values(&self, sample: &Sample<'_>) -> [f64; 3] {
        let value = |fit: &Fit, global: &DVector<f64>| {
            value(fit, self.quantity, sample, global).unwrap_or(f64::NAN)
        };
        let global = self.after.global();
        let slopes = self.steps.iter().enumerate().map(|(i, &step)| {
            let moved = |by: f64| {
                let mut moved = global.clone();
                moved[i] += by;
                value(self.after, &moved)
            };
            let difference = || 0.5 * (moved(step) - moved(-step));
            if step > 0.0 { difference() } else { 0.0 }
        });
        let slopes = DVector::from_iterator(self.steps.len(), slopes);
        let variance = slopes.dot(&(&self.correlations * &slopes));
        [
            value(self.before, self.before.global()),
            value(self.after, global),
            variance.max(0.0).sqrt(),
        ]
    }
}

/// Value of a quantity at a sample with the estimates `global`.
fn value(fit: &Fit, quantity: &str, sample: &Sample<'_>, global: &DVector<f64>) -> Option<f64> {
    let problem = fit.problem();
    let layout = problem.body.layout();
    let at = layout.quantity(quantity)?.index();
    let (observations, _) = fit.flight(sample.flight)?;
    let bound = problem.body.bind(observations.parameters(problem, global));
    // The extended model may have states that the model under test lacks, after those that both have.
    let state = &sample.state[..layout.states.len().min(sample.state.len())];
    Some(bound.observer().quantities(sample.t, state)[at])
}
