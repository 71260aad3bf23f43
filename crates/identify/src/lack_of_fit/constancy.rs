//! Constancy of the coefficients: score tests of whether the residuals fit better if a coefficient changes with a
//! quantity of the flight. A force or moment that the model lacks is one that its coefficients, as constants, absorb.
//!
//! The fit takes whatever constants absorb best, so that residuals alone may pass as noise while estimates are far off.

use std::ops::Range;

use flight::parallel;
use model_spec::model::Shape;
use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, StudentsT};
use statrs::statistics::Statistics;

use super::{FittedFlight, INTEGRATION_ERROR};
use crate::error::FitError;
use crate::fit::{Fit, flight_error};
use crate::least_squares::{NormalBlock, SchurComplement, pseudo_inverse};
use crate::noise::NoiseModel;
use crate::predict::linearise_by_spans;
use crate::report::CoefficientChange;

/// Number of spans of a flight, in each of which a coefficient is constant, and least number of samples of one.
const SPANS: (usize, usize) = (6, 4);

/// Largest deviation of a quantity from its mean, in its standard deviations, that counts: a ratio may have poles.
const MAX_DEVIATION: f64 = 3.0;

/// Correlation over all spans above which two quantities are one.
const SAME: f64 = 0.99;

/// Part of a change's information beyond that of the constants, below which it is not tested.
const MIN_TOLERANCE: f64 = 1e-8;

/// A flight by its spans.
struct Spanned {
    /// Normal equations of the coefficients as they act from the start of each span on, without the local parameters.
    matrix: DMatrix<f64>,
    gradient: DVector<f64>,
    /// Number of residuals.
    count: usize,
    /// Mean of each quantity in each span.
    quantities: Vec<Vec<f64>>,
}

impl CoefficientChange {
    /// The most significant change of a coefficient of `fit`; `None` if none can be tested.
    ///
    /// # Errors
    /// [`FitError::Flight`] if a trajectory cannot be integrated.
    pub(super) fn of_fit(
        fit: &Fit,
        flights: &[FittedFlight<'_>],
        threads: usize,
    ) -> Result<Option<Self>, FitError> {
        let (names, noise) = (names(fit), fit.noise());
        let flights = parallel::each_on(threads, flights.len(), |index| {
            Spanned::new(fit, &flights[index], noise, &names)
        });
        let flights: Vec<Option<Spanned>> = flights.into_iter().collect::<Result<_, _>>()?;
        let flights: Vec<Spanned> = flights.into_iter().flatten().collect();
        Ok(most_significant(fit, &flights, &names).map(|found| {
            let count: usize = flights.iter().map(|flight| flight.count).sum();
            let by_integration = INTEGRATION_ERROR * fit.problem().sigma0 / noise.overall();
            let score = found.chi2.sqrt() / by_integration.max(1.0);
            let p_value =
                StudentsT::new(0.0, 1.0, count as f64).map_or(1.0, |by| 2.0 * by.sf(score));
            Self {
                coefficient: fit.problem().globals[found.parameter].name.clone(),
                changes_with: names[found.quantity].clone(),
                tests: found.tests,
                p_value: (found.tests as f64 * p_value).min(1.0),
            }
        }))
    }
}

/// Names of the quantities with which a coefficient may change: the time, the model's scalar quantities, its states.
fn names(fit: &Fit) -> Vec<String> {
    let model = &fit.problem().model;
    let scalars = model.aux_variables.iter();
    let scalars = scalars.filter(|own| own.value.shape == Shape::Scalar);
    let names = scalars.map(|own| &own.name);
    let states = model.states.iter().map(|state| &state.name);
    std::iter::once("time".to_owned())
        .chain(names.chain(states).cloned())
        .collect()
}

impl Spanned {
    /// `None` if the flight has too few samples, or its initial state is not free.
    fn new(
        fit: &Fit,
        flight: &FittedFlight<'_>,
        noise: &NoiseModel,
        names: &[String],
    ) -> Result<Option<Self>, FitError> {
        let spans = spans(flight.observed.times.len());
        let of = (fit.flight(flight.id), fit.evidence(flight.id));
        let (Some((observed, local)), Some(evidence)) = of else {
            return Ok(None);
        };
        let (problem, unknowns) = (fit.problem(), (fit.global(), local));
        let block = linearise_by_spans(problem, observed, unknowns, noise, &spans);
        let block = block.map_err(|reason| flight_error(observed, reason))?;
        let reduced = block
            .as_ref()
            .and_then(|block: &NormalBlock| Some((block.count, SchurComplement::new(block, 0.0)?)));
        let Some((count, reduced)) = reduced else {
            return Ok(None);
        };
        let quantities = names.iter().map(|name| {
            let of = |names: &[String], values: &[Vec<f64>]| -> Option<Vec<f64>> {
                let place = names.iter().position(|own| own == name)?;
                values.iter().map(|row| row.get(place).copied()).collect()
            };
            let values = of(&evidence.quantity_names, &evidence.quantities)
                .or_else(|| of(&evidence.state_names, &evidence.states))
                .unwrap_or_else(|| evidence.times.clone());
            let means = spans.iter().map(|span| values[span.clone()].iter().mean());
            means.collect()
        });
        Ok(Some(Self {
            quantities: quantities.collect(),
            matrix: reduced.reduced,
            gradient: reduced.gradient,
            count,
        }))
    }
}

/// Spans of equal numbers of samples.
fn spans(samples: usize) -> Vec<Range<usize>> {
    let count = SPANS.0.min(samples / SPANS.1).max(1);
    let start = |k: usize| k * samples / count;
    (0..count).map(|k| start(k)..start(k + 1)).collect()
}

/// The largest score of a change, its parameter and quantity, and how many were tested.
struct Found {
    chi2: f64,
    parameter: usize,
    quantity: usize,
    tests: usize,
}

fn most_significant(fit: &Fit, flights: &[Spanned], names: &[String]) -> Option<Found> {
    let globals = &fit.problem().globals;
    let count = globals.len();
    let mut constant = DMatrix::zeros(count, count);
    let mut gradient = DVector::zeros(count);
    for flight in flights {
        let spans = flight.gradient.len() / count.max(1);
        for i in 0..count {
            gradient[i] += flight.gradient[i * spans];
            for j in 0..count {
                constant[(i, j)] += flight.matrix[(i * spans, j * spans)];
            }
        }
    }
    for (i, global) in globals.iter().enumerate() {
        if let Some((mean, sigma)) = global.constraint.prior {
            constant[(i, i)] += sigma.powi(-2);
            gradient[i] += (fit.global()[i] - mean) / (sigma * sigma);
        }
    }
    let inverse = pseudo_inverse(&constant)?;
    let mut found = Found {
        chi2: 0.0,
        parameter: 0,
        quantity: 0,
        tests: 0,
    };
    for (quantity, weights) in distinct(flights, names.len()) {
        for parameter in 0..count {
            let mut cross = DVector::zeros(count);
            let (mut information, mut score) = (0.0, 0.0);
            for (flight, weights) in flights.iter().zip(&weights) {
                let own = parameter * weights.len();
                for (m, weight) in weights.iter().enumerate() {
                    score += weight * flight.gradient[own + m];
                    for (n, other) in weights.iter().enumerate() {
                        information += weight * other * flight.matrix[(own + m, own + n)];
                    }
                    for i in 0..count {
                        cross[i] += weight * flight.matrix[(own + m, i * weights.len())];
                    }
                }
            }
            let through = &inverse * &cross;
            let left = information - through.dot(&cross);
            if left.is_nan() || left <= MIN_TOLERANCE * information {
                continue;
            }
            found.tests += 1;
            let chi2 = (score - through.dot(&gradient)).powi(2) / left;
            if chi2 > found.chi2 {
                (found.chi2, found.parameter, found.quantity) = (chi2, parameter, quantity);
            }
        }
    }
    (found.tests > 0).then_some(found)
}

/// Quantities that differ between spans and from each other: for each, the changes of a coefficient that follows it, at
/// the start of each span of each flight.
fn distinct(flights: &[Spanned], quantities: usize) -> Vec<(usize, Vec<Vec<f64>>)> {
    let mut kept: Vec<(usize, Vec<f64>)> = Vec::new();
    for quantity in 0..quantities {
        let values = flights
            .iter()
            .flat_map(|flight| &flight.quantities[quantity]);
        let values: Vec<f64> = values.copied().collect();
        let (mean, deviation) = (values.iter().mean(), values.iter().std_dev());
        if !(deviation.is_finite() && deviation > f64::EPSILON.sqrt() * mean.abs()) {
            continue;
        }
        let scaled = values.iter().map(|value| (value - mean) / deviation);
        let scaled: Vec<f64> = scaled
            .map(|value| value.clamp(-MAX_DEVIATION, MAX_DEVIATION))
            .collect();
        let norm = |own: &[f64]| own.iter().map(|x| x * x).sum::<f64>().sqrt();
        let is_same = kept.iter().any(|(_, other)| {
            let product: f64 = other.iter().zip(&scaled).map(|(a, b)| a * b).sum();
            product.abs() > SAME * norm(other) * norm(&scaled)
        });
        if !is_same {
            kept.push((quantity, scaled));
        }
    }
    let by_flight = |values: Vec<f64>| {
        let mut values = values.into_iter();
        let flights = flights.iter().map(|flight| {
            let count = flight.quantities.first().map_or(0, Vec::len);
            let mut before = 0.0;
            let own = values.by_ref().take(count);
            own.map(|value| value - std::mem::replace(&mut before, value))
                .collect()
        });
        flights.collect()
    };
    let kept = kept.into_iter();
    kept.map(|(quantity, values)| (quantity, by_flight(values)))
        .collect()
}
