//! Held-out flights: the initial state is fitted to the conditioning segment with the global parameters fixed, and the
//! rest of the flight is predicted.

use flight::parallel;
use nalgebra::{DMatrix, DVector};

use super::initial_guess::{observations_and_poses, refined_guesses};
use super::one_flight::FixedGlobal;
use super::outcome::initial_state_report;
use super::post_fit::{channel_sums, square_sums};
use super::{FitError, FittedFlight, FlightResult};
use crate::error::FlightError;
use crate::ground_contact::ContactSearch;
use crate::ids::FlightId;
use crate::least_squares::{StoppingCriteria, eliminate};
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::outliers;
use crate::predict::{Loss, residuals};
use crate::problem::FitProblem;
use crate::report::{FlightOutcome, FlightReport};
use dataset::{Dataset, Flight};

/// Fraction of the samples of a held-out flight to which its initial state is fitted; the rest is predicted.
pub const CONDITIONING_FRACTION: f64 = 0.3;

/// Fits the initial states of held-out flights to their conditioning segments, and predicts the later samples.
/// `contacts` contains, by index of the flight in the dataset, the results of an earlier search for ground contacts;
/// empty if there was none. Returns one result for each of `flights`, in this order. A flight that cannot be predicted
/// is reported as excluded.
///
/// # Errors
/// [`FitError::Interrupted`] if the work is cancelled.
pub fn held_out(
    at: FixedGlobal<'_>,
    (dataset, contacts): (&Dataset, &[Option<ContactSearch>]),
    flights: &[FlightId],
    noise: &NoiseModel,
) -> Result<Vec<FlightResult>, FitError> {
    let options = at.options;
    if !flights.is_empty() {
        options.stage_started("held-out flights", flights.len());
    }
    let found = parallel::each_on(options.threads(), flights.len(), |index| {
        let flight = flights[index].index();
        let search = contacts.get(flight).and_then(Option::as_ref);
        let flight = &dataset.flights[flight];
        let found = match options.is_past_deadline() {
            true => Err(FlightError::Deadline),
            false => predict(at, (flight, search), noise),
        };
        options.flight_done();
        found.unwrap_or_else(|reason| FlightResult::excluded(flight, &reason))
    });
    match options.is_cancelled() {
        true => Err(FitError::Interrupted),
        false => Ok(found),
    }
}

fn predict(
    at: FixedGlobal<'_>,
    (flight, search): (&Flight, Option<&ContactSearch>),
    noise: &NoiseModel,
) -> Result<FlightResult, FlightError> {
    let (problem, global) = (at.problem, at.global);
    let (mut observations, _) = observations_and_poses(problem, flight, search)?;
    let all = observations.times.len();
    let samples = ((all as f64 * CONDITIONING_FRACTION).ceil() as usize).clamp(1, all);
    if samples == all {
        return Err(FlightError::NothingToPredict { samples });
    }
    let segment = observations.first_samples(samples);
    let guesses = refined_guesses(at, &segment)?;
    let best = guesses.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
    let (_, guess) = best.ok_or(FlightError::NoMatchingState)?;
    let (_, local) = at.fit_initial_state(&segment, samples, guess.state)?;
    mark_outliers(problem, &mut observations, global, &local)?;
    // Autocorrelation of few residuals may be model error; white noise is the safest assumption.
    let white = noise.uncorrelated();
    let (loss, criteria) = (Loss::Whitened(&white), StoppingCriteria::COARSE);
    let (local, solution) = at.solve(&observations, samples, local, loss, criteria)?;
    let system = eliminate(&solution.blocks, 0.0);
    let system = system.map_err(|_| FlightError::SingularInitialState)?;
    let covariance = system.local_covariance(0, &DMatrix::zeros(0, 0));
    let residuals = residuals(problem, &observations, (global, &local), all)?;
    let sums = channel_sums(problem, &observations, &residuals, samples);
    let residual_rms = square_sums(problem, &sums).rms();
    if residual_rms.is_empty() {
        return Err(FlightError::NothingMeasuredToPredict);
    }
    let report = FlightReport {
        file: observations.file.clone(),
        role: observations.role,
        outcome: FlightOutcome::HeldOut,
        samples: observations.samples,
        residual_rms,
        outliers: observations.outliers(),
        initial: initial_state_report(problem, &observations, &local, &covariance),
        cut: observations.truncation.clone(),
        notes: observations.notes.clone(),
    };
    let fitted = Some(FittedFlight {
        observations,
        state: local,
    });
    Ok(FlightResult {
        report: Some(report),
        fitted,
    })
}

/// Marks as outliers the values whose residuals deviate from the line through the neighbouring residuals, so that a
/// smooth prediction error is not mistaken for outliers. Returns an error if the trajectory cannot be computed.
fn mark_outliers(
    problem: &FitProblem,
    observations: &mut Observations,
    global: &DVector<f64>,
    local: &DVector<f64>,
) -> Result<(), FlightError> {
    let samples = observations.times.len();
    let residuals = residuals(problem, observations, (global, local), samples)?;
    let local_residuals = outliers::local_residuals(&observations.times, &residuals);
    let group_of = problem.noise_groups();
    let scales = outliers::group_scales(&local_residuals, &group_of);
    observations.outlier = outliers::outlier_mask(&local_residuals, &scales, &group_of);
    Ok(())
}
