//! Flights that are kept to judge predictions: their initial state is fitted on their first part with the
//! coefficients held, and the rest is predicted.

use flight::batch;
use nalgebra::DVector;

use super::horizon_continuation::{fit_initial_state, solve_local};
use super::initial_guess::{fitted_guesses, observations};
use super::outcome::{initial, left_out};
use super::{FitError, State};
use crate::dataset::Dataset;
use crate::least_squares::eliminate;
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::outliers;
use crate::predict::{Loss, residuals};
use crate::problem::FitProblem;
use crate::report::FlightReport;

/// The part of a held-out flight's samples that its initial state is fitted on.
pub const CONDITIONING_FRACTION: f64 = 0.3;

/// A held-out flight.
pub struct HeldOut {
    /// What is reported of it.
    pub report: FlightReport,
    /// Its samples and its initial state; none where it was left out.
    pub observations: Option<(Observations, DVector<f64>)>,
}

/// Fits and predicts these flights.
///
/// # Errors
/// [`FitError::Interrupted`].
pub fn held_out(
    problem: &FitProblem,
    dataset: &Dataset,
    flights: &[usize],
    state: &State,
    noise: &NoiseModel,
    options: &FitOptions<'_>,
) -> Result<Vec<HeldOut>, FitError> {
    if !flights.is_empty() {
        options.begins("held-out flights", flights.len());
    }
    let found = batch::each_on(options.threads(), flights.len(), |index| {
        let flight = &dataset.flights[flights[index]];
        let found = one(problem, flight, state, noise, options);
        options.part_done();
        found.unwrap_or_else(|reason| HeldOut {
            report: left_out(flight, reason),
            observations: None,
        })
    });
    if options.is_stopped() {
        return Err(FitError::Interrupted);
    }
    Ok(found)
}

fn one(
    problem: &FitProblem,
    flight: &crate::dataset::Flight,
    state: &State,
    noise: &NoiseModel,
    options: &FitOptions<'_>,
) -> Result<HeldOut, String> {
    let mut observations = observations(problem, flight)?;
    let all = observations.times.len();
    let first = ((all as f64 * CONDITIONING_FRACTION).ceil() as usize).clamp(1, all);
    if first == all {
        return Err("too short for a part of it to be predicted".into());
    }
    let head = observations.first_samples(first);
    let global = &state.global;
    let starts = fitted_guesses(problem, &head, global, options)?;
    let best = starts.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
    let (_, start) = best.ok_or("it has no start")?;
    let (_, local) = fit_initial_state(problem, &head, first, global, start.state, options)?;
    mark(problem, &mut observations, global, &local)?;
    // Few samples, whose correlation may be the model's own error: as white, which misleads least.
    let white = NoiseModel {
        ar1: [0.0; 3],
        ..*noise
    };
    let loss = Loss::Whitened(&white);
    let (local, solution) =
        solve_local(problem, &observations, first, global, local, loss, options)?;
    let system = eliminate(&solution.blocks, 0.0).map_err(|flight| flight.to_string())?;
    let covariance = system.local_covariance(0, &nalgebra::DMatrix::zeros(0, 0));
    let rest = residuals(problem, &observations, (global, &local), all)?;
    let (mut squares, mut count) = (0.0, 0_usize);
    for (marker, series) in rest.iter().enumerate() {
        for (sample, residual) in series.iter().enumerate().skip(first) {
            let Some(residual) = residual else { continue };
            if !observations.outlier[sample * observations.markers + marker] {
                squares += residual.iter().map(|r| r * r).sum::<f64>();
                count += 3;
            }
        }
    }
    if count == 0 {
        return Err("nothing was seen of the part that is to be predicted".into());
    }
    let initial = initial(problem, &observations, &local, &covariance);
    let report = FlightReport {
        file: observations.file.clone(),
        role: observations.role,
        samples: observations.samples,
        rms_m: (squares / count as f64).sqrt(),
        outliers: observations
            .outlier
            .iter()
            .filter(|outlier| **outlier)
            .count(),
        initial,
        cut: observations.truncation.clone(),
        notes: observations.notes.clone(),
    };
    Ok(HeldOut {
        report,
        observations: Some((observations, local)),
    })
}

/// Marks the outliers: by how they stand out from their neighbours, so that a wrong prediction is not taken for them.
fn mark(
    problem: &FitProblem,
    observations: &mut Observations,
    global: &DVector<f64>,
    local: &DVector<f64>,
) -> Result<(), String> {
    let residuals = residuals(
        problem,
        observations,
        (global, local),
        observations.times.len(),
    )?;
    let local_residuals = outliers::local_residuals(&observations.times, &residuals);
    observations.outlier =
        outliers::outlier_mask(&local_residuals, outliers::scale(&local_residuals));
    Ok(())
}
