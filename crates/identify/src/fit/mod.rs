//! Output-error fit of the global parameters to all flights, together with the initial state of each flight.
//!
//! Stages: initial guesses; horizon continuation for each possible alias of the spin or, without measured positions, from
//! several initial guesses; restarts if this may have ended
//! in a wrong minimum; multistart of single flights in a wrong minimum; refinement of ground contacts with the fitted
//! model; reweighting, which estimates the noise (scale and lag-1 correlation along each axis, outliers) together
//! with the unknowns; and samples at the ends of flights that are left out.

mod bootstrap;
mod channel_scales;
mod contact_refinement;
mod continued;
mod ends;
mod exclusion;
mod filtered;
mod fitted_text;
mod global_error;
mod held_out;
mod held_values;
mod horizon_continuation;
mod initial_guess;
mod marker_distances;
mod multiple_shooting;
mod multistart;
mod one_flight;
mod outcome;
mod output_error;
mod post_fit;
mod residual_cache;
mod reweighting;
mod rigidity;
mod several_starts;
mod spin_aliases;
mod state;
mod taking_back;
#[cfg(test)]
pub(crate) mod tests;
mod trial;
mod undistorted;
mod unlike_flights;
mod warm_start;
mod wrong_minimum;

use std::borrow::Borrow;
use std::collections::BTreeMap;
use std::time::Instant;

use flight::parallel;
use model_spec::model::Model;
use nalgebra::DVector;

use self::initial_guess::InitialGuesses;
use self::residual_cache::ResidualCache;
use self::reweighting::Reweighted;
use self::state::State;
use crate::data_fault::{DataFault, FaultKind};
use crate::error::{ExcludedFlight, FitError, FlightError};
use crate::ground_contact::ContactSearch;
use crate::ids::FlightId;
use crate::least_squares::SolveError;
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::problem::FitProblem;
use crate::report::{FitReport, FlightEvidence, FlightOutcome, FlightReport, MARKER};
use crate::screening::{self, Screening};
use crate::tolerance;
use crate::vertical;
use dataset::{Dataset, Flight, Role};
pub use held_out::CONDITIONING_FRACTION;
#[cfg(test)]
pub(crate) use one_flight::FixedGlobal;

/// Result of a fit of a model to measured flights: report, estimates, noise model, and the flights with their initial
/// states.
pub struct Fit {
    /// Report with estimates, uncertainties and residual diagnostics.
    pub report: FitReport,
    problem: FitProblem,
    /// Fitted and held-out flights, indexed by [`FlightId`]; `None` for excluded flights.
    flights: Vec<Option<FittedFlight>>,
    global: DVector<f64>,
    noise: NoiseModel,
    /// Noise floor: standard deviation along each axis of the noise of one coordinate, estimated by a smoother, m;
    /// `None` if it was not determined.
    noise_floor: Option<[f64; 3]>,
    /// Flights that the fit excluded, with the reasons.
    excluded: Vec<ExcludedFlight>,
}

/// Observations and estimated initial state of a fitted or held-out flight.
#[derive(Clone)]
struct FittedFlight {
    observations: Observations,
    /// Estimated initial state of the flight, SI.
    state: DVector<f64>,
}

/// Fits a model to the flights of a dataset as [`fit`](fn@crate::fit) does, but requires that the sensor positions, the
/// origin and the vertical direction are known.
///
/// # Errors
/// The errors of [`fit`](fn@crate::fit).
pub fn fit(model: &Model, dataset: &Dataset, options: &FitOptions<'_>) -> Result<Fit, FitError> {
    fit_after(model, dataset, options, None)
}

/// Fits a model as [`fit`](fn@crate::fit) does, but starts at the estimates of an earlier fit of the same dataset.
/// Parameters of the same name start at their estimates, other parameters at the model's values, and each flight at its
/// initial state. This is much faster if the models are similar. If the earlier fit cannot be continued, for example
/// because the states differ, the fit starts from the samples.
///
/// # Errors
/// The errors of [`fit`](fn@crate::fit).
pub fn refit(
    model: &Model,
    dataset: &Dataset,
    options: &FitOptions<'_>,
    earlier: &Fit,
) -> Result<Fit, FitError> {
    fit_after(model, dataset, options, Some(earlier))
}

fn fit_after(
    model: &Model,
    dataset: &Dataset,
    options: &FitOptions<'_>,
    earlier: Option<&Fit>,
) -> Result<Fit, FitError> {
    options.validate()?;
    parallel::within(options.threads(), || {
        let mut fit = fit_within(model, dataset, options, earlier)?;
        // The fits of a diagnosis, whose faults are known, hold what its first fit held.
        if options.known_faults.is_none() && !options.fixed.is_empty() {
            let conflicts = held_values::conflicts(model, dataset, options, &fit)?;
            fit.report.contradicted.extend(conflicts);
            fit.report.assess();
        }
        Ok(fit)
    })
}

fn fit_within(
    model: &Model,
    dataset: &Dataset,
    options: &FitOptions<'_>,
    earlier: Option<&Fit>,
) -> Result<Fit, FitError> {
    let clock = Instant::now();
    let mut problem = FitProblem::new(model, dataset, options)?;
    let mut fitted = flights_of(dataset, Role::Fit);
    if fitted.is_empty() {
        return Err(FitError::NothingToFit);
    }
    let mut held_out = flights_of(dataset, Role::HeldOut);
    let Screening {
        faults: mut data_faults,
        contacts,
    } = match options.known_faults {
        Some(known) => Screening {
            faults: known.to_vec(),
            ..Screening::default()
        },
        None => screening::screen(&problem, dataset, options.threads()),
    };
    if vertical::is_in(model) {
        data_faults.retain(|fault| fault.fault != FaultKind::Axes);
    }
    trial::remove_refuted(model, dataset, options, &mut data_faults)?;
    let faulty = screening::excluded(dataset, &data_faults, options);
    let is_faulty = |flight: &FlightId| faulty.iter().any(|excluded| excluded.flight == *flight);
    fitted.retain(|flight| !is_faulty(flight));
    held_out.retain(|flight| !is_faulty(flight));
    if fitted.is_empty() {
        return Err(FitError::FaultyData(data_faults));
    }
    problem.tolerance = tolerance::whitened(model, fitted.len());
    // Times that seem to have another unit may be the effect of loads that the model contains.
    let (doubtful, faulty): (Vec<_>, Vec<_>) = faulty.into_iter().partition(|excluded| {
        taking_back::may_come_back(excluded)
            && dataset.flights[excluded.flight.index()].role == Role::Fit
    });
    let screened = Screened {
        dataset,
        data_faults,
        contacts,
        held_out,
        faulty,
        clock,
    };
    if let Some(earlier) = earlier {
        problem.take_scales(&earlier.problem);
        if let Some((mut state, cache)) =
            continued::continued(&problem, dataset, &fitted, earlier, options)
        {
            state.excluded.extend(doubtful);
            let floors = (
                earlier.noise_floor,
                earlier
                    .report
                    .position_noise()
                    .and_then(|noise| noise.floor),
            );
            let reweighted = reweighting::reweight(&mut state, cache, None)?;
            return screened.finish(state, reweighted, floors, clock.elapsed().as_secs_f64());
        }
    }
    let observed = initial_guess::observe(&problem, dataset, &fitted, &screened.contacts, options);
    problem.sigma0 = observed.sigma0.unwrap_or(problem.sigma0);
    let flights = observed.usable.iter().map(|(_, observations)| observations);
    channel_scales::set_scales(&mut problem, flights);
    let noise_floor = observed.noise_floor;
    let floor_m = noise_floor.map(initial_guess::overall).or(observed.sigma0);
    let guesses = initial_guess::initial_guesses(&problem, dataset, observed, options)?;
    let started = clock.elapsed().as_secs_f64();
    let (mut state, (cache, predicted_reduction)) = from_guesses(dataset, guesses, doubtful)?;
    let reweighted = reweighting::reweight(&mut state, cache, predicted_reduction)?;
    let reweighted = ends::leave_out_ends(&mut state, reweighted)?;
    screened.finish(state, reweighted, (noise_floor, floor_m), started)
}

/// Dataset whose recordings were screened for mistakes, with the faults found and the flights concerned.
struct Screened<'a> {
    dataset: &'a Dataset,
    data_faults: Vec<DataFault>,
    /// Results of the search for ground contacts, by index of the flight in the dataset; empty if the fit did not
    /// screen the data.
    contacts: Vec<Option<ContactSearch>>,
    /// Indices of the held-out flights that have no data faults.
    held_out: Vec<FlightId>,
    /// Flights excluded from the fit because screening found faults in their data.
    faulty: Vec<ExcludedFlight>,
    /// Time at which the fit started, from which computing times are measured.
    clock: Instant,
}

impl Screened<'_> {
    /// Last stages of a fit: takes flights back, predicts the held-out flights, and creates the report. `noise_floor` is
    /// the noise floor along each axis, m. `floor_m` is the noise that the report states as its floor, m: one value for
    /// all axes. `started` is the time, s after the start of the fit, at which the initial guesses were known.
    fn finish(
        mut self,
        mut state: State<'_>,
        reweighted: Reweighted,
        (noise_floor, floor_m): (Option<[f64; 3]>, Option<f64>),
        started: f64,
    ) -> Result<Fit, FitError> {
        let (dataset, problem, options) = (self.dataset, state.problem, state.options);
        let reweighted = taking_back::take_back(dataset, &mut state, reweighted)?;
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
        let Reweighted {
            noise, solution, ..
        } = reweighted;
        let flights = (dataset, &self.contacts[..]);
        let predicted = held_out::held_out(state.fixed_global(), flights, &self.held_out, &noise)?;
        let mut results: Vec<FlightResult> = Vec::with_capacity(dataset.flights.len());
        results.resize_with(dataset.flights.len(), FlightResult::default);
        for excluded in state.excluded.iter().chain(&self.faulty) {
            let index = excluded.flight.index();
            results[index] = FlightResult::excluded(&dataset.flights[index], &excluded.reason);
        }
        let states = state.flights.into_iter().zip(solution.iterate.local);
        for ((flight, report), (observations, state)) in
            state.ids.into_iter().zip(reports).zip(states)
        {
            let fitted = FittedFlight {
                observations,
                state,
            };
            results[flight.index()] = FlightResult {
                report: Some(report),
                fitted: Some(fitted),
            };
        }
        for (flight, predicted) in self.held_out.into_iter().zip(predicted) {
            results[flight.index()] = predicted;
        }
        let (reports, flights): (Vec<_>, Vec<_>) = results
            .into_iter()
            .map(|result| (result.report, result.fitted))
            .unzip();
        report.flights = reports.into_iter().flatten().collect();
        let is_excluded =
            |fault: &DataFault| report.excluded().any(|flight| flight.file == fault.file);
        self.data_faults
            .retain(|fault| options.trust_data || is_excluded(fault));
        report.data_faults = self.data_faults;
        if let Some(noise) = report.noise.get_mut(MARKER) {
            noise.floor = floor_m;
        }
        report.marker_distances = marker_distances;
        report.assess();
        let total = self.clock.elapsed().as_secs_f64();
        let seconds = [
            ("start", started),
            ("fit", solved - started),
            ("total", total),
        ];
        report.seconds = seconds.map(|(name, value)| (name.to_owned(), value)).into();
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

/// Performs the stages of a fit from the initial guesses up to the estimation of the noise. `doubtful` contains flights
/// excluded for a suspected fault, which later stages may include again. Returns the fit in progress, at the minimum or
/// near it, its residuals, and the predicted reduction of the sum of squares by the last step, if its residuals were
/// weighted by their noise.
fn from_guesses<'a>(
    dataset: &Dataset,
    guesses: InitialGuesses<'a>,
    doubtful: Vec<ExcludedFlight>,
) -> Result<(State<'a>, (ResidualCache, Option<f64>)), FitError> {
    let (mut state, alternatives) = (guesses.state, &guesses.alternatives);
    state.excluded.extend(doubtful);
    let (mut state, cache) = if state.problem.sees_positions() {
        spin_aliases::resolve_spin_aliases(state, alternatives)?
    } else {
        several_starts::best_of_several(state, alternatives)?
    };
    let cache = global_error::bound_global_errors(&mut state, cache);
    let cache = wrong_minimum::start_undistorted(&mut state, cache)?;
    let cache = multiple_shooting::shoot_again(&mut state, cache)?;
    let cache = multistart::multistart(&mut state, cache)?;
    let cache = unlike_flights::exclude_unlike_flights(&mut state, cache)?;
    // The residuals are smaller now, and ask for more accuracy.
    let cache = global_error::bound_global_errors(&mut state, cache);
    let last = contact_refinement::refine_contacts(dataset, &mut state, cache)?;
    Ok((state, last))
}

fn flights_of(dataset: &Dataset, role: Role) -> Vec<FlightId> {
    let flights = dataset.flights.iter().enumerate();
    let of_role = flights.filter(|(_, flight)| flight.role == role);
    of_role.map(|(index, _)| FlightId::new(index)).collect()
}

/// Result of a fit for one flight of the dataset: its report, and its observations if it was not excluded.
#[derive(Default)]
struct FlightResult {
    report: Option<FlightReport>,
    /// Observations of the flight and its estimated initial state; `None` if the flight is excluded.
    fitted: Option<FittedFlight>,
}

impl FlightResult {
    fn excluded(flight: &Flight, reason: &FlightError) -> Self {
        let reason = reason.to_string();
        let report = FlightReport {
            file: flight.file.clone(),
            role: flight.role,
            samples: flight.times.len(),
            residual_rms: BTreeMap::new(),
            outliers: 0,
            initial: BTreeMap::new(),
            cut: None,
            notes: vec![format!("left out: {reason}")],
            outcome: FlightOutcome::Excluded { reason },
        };
        Self {
            report: Some(report),
            fitted: None,
        }
    }
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

    /// Measured and predicted values of a flight, for figures; `None` if the flight is excluded or cannot be
    /// integrated.
    pub fn evidence(&self, flight: FlightId) -> Option<FlightEvidence> {
        let (observations, local) = self.flight(flight)?;
        let unknowns = (&self.global, local);
        post_fit::evidence(&self.problem, observations, unknowns)
    }
}

/// Converts an error of the least-squares solver to an error of the fit. `flights` are the flights to which the flight
/// indices in the solver's error refer.
fn solve_error(error: SolveError, flights: &[impl Borrow<Observations>]) -> FitError {
    match error {
        SolveError::Start(failures) => match failures.into_iter().next() {
            Some((flight, reason)) => flight_error(flights[flight].borrow(), reason),
            None => FitError::NothingToFit,
        },
        SolveError::Cancelled => FitError::Interrupted,
    }
}

fn flight_error(flight: &Observations, reason: FlightError) -> FitError {
    FitError::Flight {
        file: flight.file.clone(),
        reason,
    }
}
