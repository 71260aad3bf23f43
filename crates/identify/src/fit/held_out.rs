//! Held-out flights: the initial state is fitted to the conditioning segment, and the rest is predicted.

use model_spec::layout::StateId;
use nalgebra::{DMatrix, DVector};

use super::initial_guess::{observations_and_poses, refined_guesses};
use super::outcome::{flight_report, initial_state_report, seen};
use super::output_error::{FixedGlobal, FlightAlone};
use super::post_fit::{channel_sums, square_sums};
use super::summaries::initial_state;
use super::{FittedFlight, FlightResult, left_out};
use crate::error::FlightError;
use crate::ids::FlightId;
use crate::least_squares::{Solution, StoppingCriteria, eliminate};
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::outliers;
use crate::predict::{FlightAt, Loss, Residuals};
use crate::problem::{FitProblem, StatePrior};
use crate::report::{FlightOutcome, FlightReport};
use crate::summary;
use dataset::contact::ContactSearch;
use dataset::levels::MIN_POPULATION;
use dataset::{Dataset, Flight, SummaryEvent};

/// Fraction of the samples of a held-out flight to which its initial state is fitted; the rest is predicted.
pub const CONDITIONING_FRACTION: f64 = 0.3;

/// Priors of the states that effects add or that stand for unknown quantities, by their values in the fitted flights:
/// the first samples of a flight may not determine them. Those of effects are about their null values, so that an
/// effect of each flight does not predict what all flights have in common.
pub fn population(
    problem: &FitProblem,
    flights: &[Observations],
    locals: &[DVector<f64>],
) -> Vec<StatePrior> {
    let unknown = problem.model.unknown_states();
    let prior = |state: usize| {
        let is_free = |flight: &Observations| {
            flight
                .known_states
                .iter()
                .all(|(id, _)| id.index() != state)
        };
        let free = flights
            .iter()
            .zip(locals)
            .filter(|(flight, _)| is_free(flight));
        let values: Vec<f64> = free.map(|(_, local)| local[state]).collect();
        let count = values.len() as f64;
        let is_unknown = unknown.iter().any(|(_, own)| *own == state);
        let (mean, freedom) = match is_unknown {
            true => (values.iter().sum::<f64>() / count, count - 1.0),
            false => (problem.model.states[state].value, count),
        };
        let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
        // The variance of a further value about the mean of the others.
        let sigma = (squares / freedom * (1.0 + 1.0 / count)).sqrt();
        (values.len() >= MIN_POPULATION && sigma > 0.0).then_some(StatePrior {
            state: StateId::new(state),
            mean,
            sigma,
            is_measured: false,
        })
    };
    problem
        .model
        .added_states()
        .into_iter()
        .filter_map(prior)
        .collect()
}

/// Observations and initial state of a flight in an earlier fit, from which the search for its initial state starts;
/// `None` if it starts from the samples.
type Start<'a> = Option<(&'a Observations, &'a DVector<f64>)>;

/// Predicts held-out flights; `contacts` contains earlier searches for contacts by index of the flight, or is empty.
/// `start` says where the search for a flight's initial state starts. `population` are priors of states by their values
/// in the fitted flights. Returns one result for each of `flights`; one that cannot be predicted is excluded.
pub fn held_out<'a>(
    at: FixedGlobal<'_>,
    (dataset, contacts): (&Dataset, &[Option<ContactSearch>]),
    (flights, start): (&[FlightId], &(dyn Fn(FlightId) -> Start<'a> + Sync)),
    noise: &NoiseModel,
    population: &[StatePrior],
) -> Vec<FlightResult> {
    let options = at.options;
    if flights.is_empty() {
        return Vec::new();
    }
    options.each_flight("held-out flights", flights.len(), |index| {
        let start = start(flights[index]);
        let flight = flights[index].index();
        let search = contacts.get(flight).and_then(Option::as_ref);
        let flight = &dataset.flights[flight];
        let found = match options.is_past_deadline() {
            true => Err(FlightError::Deadline),
            false => predict(at, (flight, search), start, noise, population),
        };
        found.unwrap_or_else(|reason| left_out(flight, &reason))
    })
}

fn predict(
    at: FixedGlobal<'_>,
    (flight, search): (&Flight, Option<&ContactSearch>),
    start: Start<'_>,
    noise: &NoiseModel,
    population: &[StatePrior],
) -> Result<FlightResult, FlightError> {
    let (problem, global) = (at.problem, at.global);
    if problem.summary.is_some() {
        let observations = Observations::new(problem, flight)?;
        if observations.is_summary {
            return predict_summary(at, observations, noise, population);
        }
    }
    let (mut observations, _) = observations_and_poses(problem, flight, search)?;
    observations.adopt(population);
    let all = observations.times.len();
    let samples = ((all as f64 * CONDITIONING_FRACTION).ceil() as usize).clamp(1, all);
    if samples == all {
        return Err(FlightError::NothingToPredict { samples });
    }
    let segment = observations.first_samples(samples);
    let local = conditioned(at.flight(&segment), start)?;
    let mask = outlier_mask(FlightAt::new(problem, &observations, (global, &local)))?;
    observations.outlier = mask;
    // Autocorrelation of few residuals may be model error; white noise is the safest assumption.
    let white = noise.uncorrelated();
    let (loss, criteria) = (Loss::Whitened(&white), StoppingCriteria::COARSE);
    let first = at.flight(&observations).first(samples);
    let (local, solution) = first.solve(local, loss, criteria)?;
    let residuals = FlightAt::new(problem, &observations, (global, &local)).residuals()?;
    predicted(
        problem,
        observations,
        (local, &solution),
        &residuals,
        samples,
    )
}

/// Result of a flight whose initial state `local` was fitted to the first `samples` samples, and whose others are predicted.
fn predicted(
    problem: &FitProblem,
    observations: Observations,
    (local, solution): (DVector<f64>, &Solution),
    residuals: &Residuals,
    samples: usize,
) -> Result<FlightResult, FlightError> {
    let system = eliminate(&solution.blocks, 0.0);
    let system = system.map_err(|_| FlightError::SingularInitialState)?;
    let covariance = system.local_covariance(0, &DMatrix::zeros(0, 0));
    let sums = channel_sums(problem, &observations, residuals, samples);
    let residual_rms = square_sums(problem, &sums).rms();
    if residual_rms.is_empty() {
        return Err(FlightError::NothingMeasuredToPredict);
    }
    let initial = initial_state_report(problem, &observations, &local, &covariance);
    let outcome = FlightOutcome::HeldOut;
    let report = flight_report(problem, &observations, outcome, residual_rms, initial);
    let fitted = FittedFlight {
        observations,
        state: local,
    };
    Ok((report, Some(fitted)))
}

/// Initial state of a conditioning segment, fitted from `start`, or else from the best of the guesses by the samples.
fn conditioned(segment: FlightAlone<'_>, start: Start<'_>) -> Result<DVector<f64>, FlightError> {
    let fitted = |state: DVector<f64>| segment.fit(state).map(|(_, state)| state);
    let observations = segment.observations;
    let start = start.filter(|(before, state)| {
        before.origin == observations.origin && state.len() == observations.manifold.states()
    });
    if let Some(known) = start.and_then(|(_, state)| fitted(state.clone()).ok()) {
        return Ok(known);
    }
    let guesses = refined_guesses(segment)?;
    let best = guesses.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
    let (_, guess) = best.ok_or(FlightError::NoMatchingState)?;
    fitted(guess.state)
}

/// Predicts what was seen of a flight from the release in its summary.
fn predict_summary(
    at: FixedGlobal<'_>,
    mut observations: Observations,
    noise: &NoiseModel,
    population: &[StatePrior],
) -> Result<FlightResult, FlightError> {
    let (problem, global) = (at.problem, at.global);
    observations.adopt(population);
    let mut release = observations.clone();
    for (value, own) in release.measured.iter_mut().zip(&problem.channels) {
        if summary::event(own.kind) != Some(SummaryEvent::Release) {
            *value = None;
        }
    }
    let start = initial_state(problem, &observations)?;
    let (loss, criteria) = (Loss::Whitened(noise), StoppingCriteria::COARSE);
    let (local, solution) = at.flight(&release).solve(start, loss, criteria)?;
    let mut residuals = FlightAt::new(problem, &observations, (global, &local)).residuals()?;
    for (series, at_release) in residuals.iter_mut().zip(&release.measured) {
        if at_release.is_some() {
            series[0] = None;
        }
    }
    let seen = seen(problem, &observations, &residuals, noise);
    let (report, fitted) = predicted(problem, observations, (local, &solution), &residuals, 0)?;
    Ok((FlightReport { seen, ..report }, fitted))
}

/// Outliers by their distance from the line through the neighbouring residuals, so that a smooth prediction error is none.
fn outlier_mask(at: FlightAt<'_>) -> Result<Vec<bool>, FlightError> {
    let residuals = at.residuals()?;
    let (times, groups) = (&at.observations.times, at.problem.noise_groups());
    let rounding = at.problem.rounding_of_groups();
    Ok(outliers::outlier_mask(
        times, &residuals, &groups, &rounding,
    ))
}
