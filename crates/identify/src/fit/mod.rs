//! Output-error fit of the global parameters to all flights, together with the initial state of each flight.
//!
//! Stages: initial guesses; horizon continuation, for each alias of the spin or from several guesses; restarts after a
//! wrong minimum of all or of single flights; contacts by the fitted model; reweighting, which estimates noise and
//! outliers together with the unknowns; and samples at the ends of flights that are left out.

mod contact_refinement;
mod ends;
mod error_trial;
mod filtered;
mod finished;
mod held_out;
mod horizon_continuation;
mod initial_guess;
mod marker_distances;
mod marker_noise;
mod open_side;
mod outcome;
mod output_error;
mod pose_offset;
mod post_fit;
mod predicted_changes;
mod reading_axes;
mod residual_cache;
mod restarts;
mod reweighting;
mod single_flights;
mod spin_aliases;
mod starts;
mod state;
mod summaries;
mod summary_noise;
#[cfg(test)]
pub(crate) mod tests;
mod trial;

use std::borrow::Borrow;
use std::collections::BTreeMap;
use std::time::Instant;

use flight::parallel;
use model_spec::model::Model;
use nalgebra::DVector;

use self::residual_cache::ResidualCache;
use self::reweighting::Reweighted;
use self::state::State;
use self::summaries::Summaries;
use crate::channel::MARKER;
use crate::error::{ExcludedFlight, FitError, FlightError};
use crate::ids::FlightId;
use crate::least_squares::SolveError;
use crate::noise::{NoiseModel, overall};
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::predict::FlightAt;
use crate::problem::{FitProblem, whitened_tolerance};
use crate::report::{FitReport, FlightEvidence, FlightOutcome, FlightReport, far_constants};
use crate::{inputs, screening, vertical};
use dataset::contact::ContactSearch;
use dataset::{DataFault, FaultKind};
use dataset::{Dataset, Flight, Role};
pub use finished::fit_observations;
pub use held_out::CONDITIONING_FRACTION;
#[cfg(test)]
pub(crate) use output_error::FixedGlobal;

/// Result of a fit: report, estimates, noise model, and the flights with their initial states.
pub struct Fit {
    /// Report with estimates, uncertainties and residual diagnostics.
    pub report: FitReport,
    problem: FitProblem,
    /// Fitted and held-out flights, indexed by [`FlightId`]; `None` for excluded flights.
    flights: Vec<Option<FittedFlight>>,
    global: DVector<f64>,
    noise: NoiseModel,
    /// Noise floor along each axis, m; `None` if it was not determined.
    noise_floor: Option<[f64; 3]>,
    excluded: Vec<ExcludedFlight>,
}

/// Observations and estimated initial state of a fitted or held-out flight.
#[derive(Clone)]
struct FittedFlight {
    observations: Observations,
    state: DVector<f64>,
}

/// Fits a model as [`fit`](fn@crate::fit) does, where sensor positions, origin and vertical are known.
///
/// # Errors
/// The errors of [`fit`](fn@crate::fit).
pub fn fit(model: &Model, dataset: &Dataset, options: &FitOptions<'_>) -> Result<Fit, FitError> {
    let task = Task {
        model,
        dataset,
        options,
    };
    fit_after(task, None)
}

/// Fits a model from the estimates of an earlier fit of the same dataset; parameters of other names start at the
/// model's values. If the earlier fit cannot be continued, for example because the states differ, the fit starts from
/// the samples.
///
/// # Errors
/// The errors of [`fit`](fn@crate::fit).
pub fn refit(
    model: &Model,
    dataset: &Dataset,
    options: &FitOptions<'_>,
    earlier: &Fit,
) -> Result<Fit, FitError> {
    let task = Task {
        model,
        dataset,
        options,
    };
    fit_after(task, Some(earlier))
}

/// A model that is to be fitted to a dataset, with options.
#[derive(Clone, Copy)]
struct Task<'a> {
    model: &'a Model,
    dataset: &'a Dataset,
    options: &'a FitOptions<'a>,
}

fn fit_after(task: Task<'_>, earlier: Option<&Fit>) -> Result<Fit, FitError> {
    let options = task.options;
    options.validate()?;
    parallel::within(options.threads(), || {
        let found = task.fit(earlier);
        options.check_cancelled()?;
        let mut faults = task.other_unit(&found);
        if faults.is_empty() {
            faults = task.frames_of_poses(&found);
        }
        options.check_cancelled()?;
        if !faults.is_empty() {
            return Err(FitError::FaultyData(faults));
        }
        let mut fit = found?;
        // The fits of a diagnosis, whose faults are known, hold what its first fit held.
        if options.known_faults.is_none() && !options.fixed.is_empty() {
            let conflicts = task.conflicts(&fit);
            options.check_cancelled()?;
            fit.report.contradicted.extend(conflicts);
            fit.report.assess();
        }
        Ok(fit)
    })
}

impl Task<'_> {
    fn fit(self, earlier: Option<&Fit>) -> Result<Fit, FitError> {
        let Task {
            model,
            dataset,
            options,
        } = self;
        let clock = Instant::now();
        let mut problem = FitProblem::new(model, dataset, options)?;
        let mut fitted = flights_of(dataset, Role::Fit);
        if fitted.is_empty() {
            return Err(FitError::NothingToFit);
        }
        let mut held_out = flights_of(dataset, Role::HeldOut);
        let (mut data_faults, contacts) = match options.known_faults {
            Some(known) => (known.to_vec(), Vec::new()),
            None => dataset::screening::screen(&problem, dataset, options.threads()),
        };
        if vertical::is_in(model) {
            data_faults.retain(|fault| fault.fault != FaultKind::Axes);
        }
        self.remove_refuted(&mut data_faults);
        if data_faults.is_empty() {
            data_faults = self.mirrored(&problem);
        }
        options.check_cancelled()?;
        let faulty = screening::excluded(dataset, &data_faults, options);
        let is_faulty =
            |flight: &FlightId| faulty.iter().any(|excluded| excluded.flight == *flight);
        fitted.retain(|flight| !is_faulty(flight));
        held_out.retain(|flight| !is_faulty(flight));
        if fitted.is_empty() {
            return Err(FitError::FaultyData(data_faults));
        }
        problem.tolerance = whitened_tolerance(model, fitted.len());
        // Times that seem to have another unit may be the effect of loads that the model contains.
        let (doubtful, faulty): (Vec<_>, Vec<_>) = faulty.into_iter().partition(|excluded| {
            single_flights::may_come_back(excluded)
                && dataset.flights[excluded.flight.index()].role == Role::Fit
        });
        let mut screened = Screened {
            dataset,
            earlier,
            data_faults,
            contacts,
            held_out,
            faulty,
            clock,
        };
        if let Some(earlier) = earlier {
            problem.take_scales(&earlier.problem);
            if let Some((mut state, cache)) =
                residual_cache::continued(&problem, dataset, &fitted, earlier, options)
            {
                state.excluded.extend(doubtful);
                let positions = earlier.report.position_noise();
                let floors = (earlier.noise_floor, positions.and_then(|noise| noise.floor));
                let reweighted = reweighting::reweight(&mut state, cache, None)?;
                return screened.finish(state, reweighted, floors, clock.elapsed().as_secs_f64());
            }
        }
        let summaries = Summaries::take(&problem, dataset, &mut fitted);
        let contacts = &mut screened.contacts;
        let observed = initial_guess::observe(&problem, dataset, &fitted, contacts, options);
        let flights = (dataset, &fitted[..]);
        let observed =
            predicted_changes::without_predicted(&problem, flights, contacts, observed, options);
        initial_guess::set_noise(&mut problem, &observed, summaries.observations());
        let noise_floor = observed.noise_floor;
        let floor_m = noise_floor.map(overall).or(observed.sigma0);
        let guesses = match fitted.is_empty() {
            true => None,
            false => Some(initial_guess::from_guesses(
                &problem, dataset, observed, options,
            )?),
        };
        let started = clock.elapsed().as_secs_f64();
        let (mut state, (mut cache, mut predicted_reduction)) = match guesses {
            None => (
                State::new(&problem, options, problem.model_values(), 1.0),
                (ResidualCache::default(), None),
            ),
            Some(guesses) => from_guesses(dataset, guesses, doubtful)?,
        };
        if !summaries.is_empty() {
            (cache, predicted_reduction) = (summaries.join(&mut state)?, None);
        }
        let reweighted = reweighting::reweight(&mut state, cache, predicted_reduction)?;
        let reweighted = ends::leave_out_ends(&mut state, reweighted)?;
        screened.finish(state, reweighted, (noise_floor, floor_m), started)
    }
}

/// Dataset whose recordings were screened for mistakes, with the faults found and the flights concerned.
struct Screened<'a> {
    dataset: &'a Dataset,
    /// Fit from whose estimates this one starts.
    earlier: Option<&'a Fit>,
    data_faults: Vec<DataFault>,
    /// Searches for contacts, by index of the flight; empty if the fit did not screen the data.
    contacts: Vec<Option<ContactSearch>>,
    held_out: Vec<FlightId>,
    faulty: Vec<ExcludedFlight>,
    clock: Instant,
}

impl Screened<'_> {
    /// Takes flights back, predicts the held-out flights, and creates the report. `noise_floor` is that along each
    /// axis, `floor_m` that of the report, m. `started` is the time, s, at which the initial guesses were known.
    fn finish(
        mut self,
        mut state: State<'_>,
        reweighted: Reweighted,
        (noise_floor, floor_m): (Option<[f64; 3]>, Option<f64>),
        started: f64,
    ) -> Result<Fit, FitError> {
        let (dataset, problem, options) = (self.dataset, state.problem, state.options);
        options.check_cancelled()?;
        let reweighted = single_flights::take_back(dataset, &mut state, reweighted)?;
        let solved = self.clock.elapsed().as_secs_f64();
        let names: Vec<String> = dataset.markers.iter().map(|m| m.name.clone()).collect();
        let marker_distances = marker_distances::wrong_distances(
            problem,
            &state.flights,
            &reweighted.cache,
            &names,
            floor_m.unwrap_or(reweighted.noise.overall()),
        );
        let (mut report, reports) = outcome::reports(&state, &reweighted)?;
        report.misread = reading_axes::exchanged(&state, &reweighted.cache);
        let offsets = pose_offset::offsets(&state, &reweighted.cache);
        report.doubts.extend(offsets);
        let Reweighted {
            noise, solution, ..
        } = reweighted;
        let flights = (dataset, &self.contacts[..]);
        let population = held_out::population(problem, &state.flights, &solution.iterate.local);
        let at = state.fixed_global();
        let start = |flight: FlightId| self.earlier?.flight(flight);
        let predicted =
            held_out::held_out(at, flights, (&self.held_out, &start), &noise, &population);
        let mut results: BTreeMap<FlightId, FlightResult> = BTreeMap::new();
        for excluded in state.excluded.iter().chain(&self.faulty) {
            let flight = &dataset.flights[excluded.flight.index()];
            results.insert(excluded.flight, left_out(flight, &excluded.reason));
        }
        let states = state.flights.into_iter().zip(solution.iterate.local);
        let fitted = states.map(|(observations, state)| {
            Some(FittedFlight {
                observations,
                state,
            })
        });
        results.extend(state.ids.into_iter().zip(reports.into_iter().zip(fitted)));
        results.extend(self.held_out.into_iter().zip(predicted));
        let (reports, flights): (_, Vec<Option<FittedFlight>>) = results.into_values().unzip();
        report.flights = reports;
        let is_excluded =
            |fault: &DataFault| report.excluded().any(|flight| flight.file == fault.file);
        self.data_faults
            .retain(|fault| options.trust_data || is_excluded(fault));
        report.data_faults = self.data_faults;
        if let Some(noise) = report.noise.get_mut(MARKER) {
            noise.floor = floor_m;
        }
        report.marker_distances = marker_distances;
        report.notes = summaries::notes(problem, dataset);
        let rows = flights.iter().flatten().map(|own| &own.observations);
        let rows = rows.filter(|own| own.is_summary);
        report.notes.extend(summaries::assumptions(problem, rows));
        report.notes.extend(inputs::notes(problem, dataset));
        report.notes.extend(marker_noise::notes(problem, &noise));
        report.far_constants = far_constants(problem, dataset);
        report.assess();
        let total = self.clock.elapsed().as_secs_f64();
        let seconds = [started, solved - started, total];
        report.seconds = ["start", "fit", "total"]
            .map(str::to_owned)
            .into_iter()
            .zip(seconds)
            .collect();
        Ok(Fit {
            report,
            global: solution.iterate.global,
            problem: problem.clone(),
            noise,
            noise_floor,
            excluded: state.excluded,
            flights,
        })
    }
}

/// Stages of a fit from the initial guesses up to the estimation of the noise. `doubtful` are flights that may be
/// included again. Returns the fit at the minimum or near it, its residuals, and the predicted reduction of the sum of
/// squares by the last step, if its residuals were weighted by their noise.
fn from_guesses<'a>(
    dataset: &Dataset,
    guesses: State<'a>,
    doubtful: Vec<ExcludedFlight>,
) -> Result<(State<'a>, (ResidualCache, Option<f64>)), FitError> {
    let (mut state, cache) = converged(guesses, doubtful)?;
    let last = contact_refinement::refine_contacts(dataset, &mut state, cache)?;
    Ok((state, last))
}

/// The stages of [`from_guesses`] that leave the ends of the flights as they are, with the residuals.
fn converged(
    mut guesses: State<'_>,
    doubtful: Vec<ExcludedFlight>,
) -> Result<(State<'_>, ResidualCache), FitError> {
    guesses.excluded.extend(doubtful);
    let (mut state, cache) = match guesses.problem.sees_positions() {
        true => spin_aliases::resolve(guesses)?,
        false => starts::best_of_several(guesses)?,
    };
    let cache = residual_cache::bound_global_errors(&mut state, cache);
    let cache = restarts::restart(&mut state, cache)?;
    let cache = single_flights::multistart(&mut state, cache)?;
    let cache = single_flights::exclude_unlike_flights(&mut state, cache)?;
    // The residuals are smaller now, and ask for more accuracy.
    let cache = residual_cache::bound_global_errors(&mut state, cache);
    Ok((state, cache))
}

fn flights_of(dataset: &Dataset, role: Role) -> Vec<FlightId> {
    let flights = dataset.flights.iter().enumerate();
    let of_role = flights.filter(|(_, flight)| flight.role == role);
    of_role.map(|(index, _)| FlightId::new(index)).collect()
}

/// Report of one flight of the dataset, and its observations and initial state if it was not excluded.
type FlightResult = (FlightReport, Option<FittedFlight>);

fn left_out(flight: &Flight, reason: &FlightError) -> FlightResult {
    let reason = reason.to_string();
    let report = FlightReport {
        file: flight.file.clone(),
        role: flight.role,
        samples: flight.times.len(),
        notes: vec![format!("left out: {reason}")],
        outcome: FlightOutcome::Excluded { reason },
        ..FlightReport::default()
    };
    (report, None)
}

impl Fit {
    /// The estimation problem that was solved.
    pub fn problem(&self) -> &FitProblem {
        &self.problem
    }

    /// Estimated global parameters, in the order of [`FitProblem::globals`], SI.
    pub fn global(&self) -> &DVector<f64> {
        &self.global
    }

    /// Noise model of the measured values, by which the fit weighted their residuals.
    pub fn noise(&self) -> &NoiseModel {
        &self.noise
    }

    /// The fitted flights, without held-out and excluded ones, in the order of the dataset.
    fn fitted(&self) -> impl Iterator<Item = &FittedFlight> {
        let flights = self.flights.iter().flatten();
        flights.filter(|flight| flight.observations.role == Role::Fit)
    }

    /// Observations and estimated initial state of a flight; `None` if the flight is excluded.
    pub fn flight(&self, flight: FlightId) -> Option<(&Observations, &DVector<f64>)> {
        let fitted = self.flights.get(flight.index())?.as_ref()?;
        Some((&fitted.observations, &fitted.state))
    }

    /// Measured and predicted values of a flight; `None` if it is excluded or cannot be integrated.
    pub fn evidence(&self, flight: FlightId) -> Option<FlightEvidence> {
        post_fit::evidence(self.at(flight)?)
    }

    /// A flight at the estimates; `None` if it is excluded.
    pub fn at(&self, flight: FlightId) -> Option<FlightAt<'_>> {
        let (observations, local) = self.flight(flight)?;
        Some(FlightAt::new(
            &self.problem,
            observations,
            (&self.global, local),
        ))
    }
}

/// Converts an error of the solver, whose indices refer to `flights`.
fn solve_error(error: SolveError, flights: &[impl Borrow<Observations>]) -> FitError {
    match error.0.into_iter().next() {
        Some((flight, reason)) => flight_error(flights[flight].borrow(), reason),
        None => FitError::NothingToFit,
    }
}

/// Error of a fit whose flight cannot be predicted.
pub(crate) fn flight_error(flight: &Observations, reason: FlightError) -> FitError {
    FitError::Flight {
        file: flight.file.clone(),
        reason,
    }
}
