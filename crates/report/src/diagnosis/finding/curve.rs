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

/// Number of intervals into which the range of a curve's abscissa is divided.
const INTERVALS: usize = 32;
/// Minimum number of samples in an interval of the abscissa for the curve to have a point there, and maximum number of
/// samples of an interval at which the plotted quantity is evaluated.
const SAMPLES: (usize, usize) = (4, 7);
/// Maximum number of samples, over all flights, from which the curve is computed.
const MAX_SAMPLES: usize = 20_000;
/// Minimum change of the plotted quantity along the curve, relative to its largest absolute value, for the curve to be
/// drawn.
const FLAT: f64 = 1e-6;

/// Unit of angles on the abscissa.
const DEGREE: &str = "°";

/// Curve of a quantity of the extended model over a variable, and the same quantity of the
/// model under test at the same states.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Curve {
    /// Name, in the model, of the quantity that the curve shows.
    pub(in super::super) quantity: String,
    /// Description of the plotted quantity, from its documentation; empty if it has none.
    pub(in super::super) doc: String,
    /// SI unit of the plotted quantity, as text.
    pub(in super::super) unit: String,
    /// Name of the variable on the abscissa.
    pub(in super::super) over: String,
    /// Documentation of the variable on the abscissa, up to the first comma; empty if it has no documentation.
    pub(in super::super) over_doc: String,
    /// Unit of the variable on the abscissa, as text: `°` for angles, otherwise SI.
    pub(in super::super) over_unit: String,
    /// Points of the curve in ascending order of the variable.
    pub(in super::super) points: Vec<Point>,
}

/// Point of a curve: medians, over the samples within one interval of the abscissa, of the variable and of the plotted
/// quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in super::super) struct Point {
    /// Value of the variable on the abscissa, in degrees for angles, otherwise SI.
    pub(in super::super) x: f64,
    /// Value of the plotted quantity in the model under test, SI; NaN if this model lacks the quantity.
    pub(in super::super) before: f64,
    /// Value of the plotted quantity in the extended model, SI.
    pub(in super::super) after: f64,
    /// Standard error of the plotted quantity in the extended model, SI.
    pub(in super::super) error: f64,
    /// Number of samples in the interval of the abscissa, including those at which the quantity was not evaluated.
    pub(in super::super) samples: usize,
}

/// Variable on the abscissa of a curve.
struct Abscissa<'m> {
    name: &'m str,
    /// Unit of the variable, as text: `°` for angles, otherwise SI.
    unit: String,
    /// Documentation of the variable if it is an auxiliary variable; empty for a state and for the time.
    doc: &'m str,
    column: Column,
}

/// Location of the values of a variable in the data of a flight.
#[derive(Clone, Copy)]
enum Column {
    State(usize),
    /// Index of an auxiliary variable among the quantities of the compiled model.
    Quantity(usize),
    Time,
}

/// Searches the scalar auxiliary variables that the effects named in `effects` add or replace. Returns the curve of the
/// first one that is not constant, over another variable on which it depends; `None` if there is none.
pub(super) fn of<'n>(fits: &Fits<'_>, effects: impl IntoIterator<Item = &'n str>) -> Option<Curve> {
    let after = fits.after?;
    let model = &after.problem().model;
    effects.into_iter().find_map(|name| {
        let index = model
            .effects
            .iter()
            .position(|e| e.name == identifier(name))?;
        let own = model.aux_variables.iter().enumerate();
        let own = own.filter(|(_, v)| v.effect == Some(index) && v.value.shape == Shape::Scalar);
        let mut own = own.map(|(at, _)| at);
        own.find_map(|at| curve(fits.before, after, at, &abscissa(after, at, index)?))
    })
}

/// Scalar variable on which an auxiliary variable of the extended model depends;
/// `None` if there is none. `at` is the index of the dependent variable in `Model::aux_variables`; `effect` is the
/// index in `Model::effects` of the effect that adds or replaces it. Of several variables, the first is returned, but
/// one that the effect lists in its declaration is preferred.
fn abscissa(after: &Fit, at: usize, effect: usize) -> Option<Abscissa<'_>> {
    let model = &after.problem().model;
    let mut found = Vec::new();
    collect(model, &model.aux_variables[at].value, effect, &mut found);
    let layout = after.problem().body.layout();
    let named = |name: &str| model.effects[effect].variables.iter().any(|v| v == name);
    let of = |name, doc, unit: String, column| Abscissa {
        name,
        unit,
        doc,
        column,
    };
    let unit_of = |is_angle: bool, unit: String| if is_angle { DEGREE.to_owned() } else { unit };
    let usable = found.into_iter().filter_map(|kind| match kind {
        ExprKind::State(k) => {
            let state = &model.states[*k];
            let column = Column::State(*k);
            let unit = unit_of(is_angle_state(state), state.unit.to_string());
            Some(of(&*state.name, "", unit, column))
        }
        ExprKind::Time => Some(of("time", "", "s".to_owned(), Column::Time)),
        ExprKind::AuxVariable(k) => {
            let own = &model.aux_variables[*k];
            let column = Column::Quantity(layout.quantity(&own.name)?.index());
            let unit = unit_of(is_angle(&own.value), own.value.unit.to_string());
            Some(of(&*own.name, &*own.doc, unit, column))
        }
        _ => None,
    });
    let mut usable: Vec<Abscissa<'_>> = usable.collect();
    let first = usable.iter().position(|variable| named(variable.name));
    (!usable.is_empty()).then(|| usable.swap_remove(first.unwrap_or(0)))
}

/// Appends to `found` the scalar variables that the expression `expr` reads. A variable that is defined by the effect
/// with index `effect`, among those active in `model`, is replaced by the variables in its definition.
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
        _ => expr.children(&mut |child| collect(model, child, effect, found)),
    }
}

/// Sample of a fitted flight: flight, time, state, and value of the abscissa.
struct Sample<'f> {
    flight: FlightId,
    t: f64,
    state: &'f [f64],
    x: f64,
}

fn curve(before: &Fit, after: &Fit, at: usize, over: &Abscissa<'_>) -> Option<Curve> {
    let variable = &after.problem().model.aux_variables[at];
    let models = Models::new(before, after, &variable.name);
    let flights = after.report.flights.iter().enumerate();
    let fitted = flights.filter(|(_, flight)| flight.role == Role::Fit);
    let fitted = fitted.map(|(index, _)| FlightId::new(index));
    let evidence = fitted.filter_map(|id| Some((id, after.evidence(id)?)));
    let evidence: Vec<_> = evidence.collect();
    let all: usize = evidence.iter().map(|(_, f)| f.times.len()).sum();
    let step = all.div_ceil(MAX_SAMPLES).max(1);
    let mut samples = Vec::new();
    for (flight, found) in &evidence {
        for i in (0..found.times.len()).step_by(step) {
            let x = match over.column {
                Column::State(k) => found.states[i][k],
                Column::Quantity(k) => found.quantities[i][k],
                Column::Time => found.times[i],
            };
            samples.push(Sample {
                flight: *flight,
                t: found.times[i],
                state: &found.states[i],
                x: if over.unit == DEGREE {
                    x.to_degrees()
                } else {
                    x
                },
            });
        }
    }
    samples.retain(|s| s.x.is_finite());
    sort_by_number(&mut samples, |sample| sample.x);
    let points = points(&samples, &models);
    let (low, high) = range(points.iter().map(|p| p.after));
    let is_drawn = points.len() >= 3 && high - low > FLAT * low.abs().max(high.abs());
    is_drawn.then(|| Curve {
        quantity: variable.name.clone(),
        doc: variable.doc.clone(),
        unit: variable.value.unit.to_string(),
        over: over.name.to_owned(),
        over_doc: over.doc.split(',').next().unwrap_or_default().to_owned(),
        over_unit: over.unit.clone(),
        points,
    })
}

/// Computes one point of the curve for each interval of the abscissa with enough samples; `samples` are sorted by the
/// abscissa.
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

/// Fits of the model under test and of the extended model, with which the drawn quantity is evaluated at a sample. The
/// standard error of the quantity follows from the covariance matrix of the extended model's coefficients.
struct Models<'f> {
    before: &'f Fit,
    after: &'f Fit,
    quantity: &'f str,
    /// Finite-difference step for the derivative with respect to each parameter common to all flights, in the order of
    /// the fit of the extended model: the standard error of the parameter in this fit, SI; 0 if it has none.
    steps: Vec<f64>,
    /// Correlation matrix of the estimates of the parameters common to all flights in the fit of the extended model, in
    /// the order of `steps`; 0 for parameters without a standard error.
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

    /// At a sample: value of the drawn quantity in the model under test, value in the extended model, and standard
    /// error of the value in the extended model, SI. NaN if the model lacks the quantity or its fit lacks the flight.
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
            if step > 0.0 {
                0.5 * (moved(step) - moved(-step))
            } else {
                0.0
            }
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

/// Value of a quantity of the model at a sample with the estimates `global`; `None` if the model lacks the quantity or
/// its fit lacks the flight.
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
