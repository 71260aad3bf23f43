//! Output-error fit of one set of global parameters to all flights, with the initial state of each flight.
//!
//! Stages: initial guesses, horizon continuation for each possible alias of the spin, multistart of flights in a wrong
//! minimum, contacts with the ground timed by the fitted model, and reweighting, which estimates the noise (scale and lag-1
//! correlation along each axis, outliers) together with the unknowns.

pub(crate) mod contact_refinement;
mod exclusion;
mod held_out;
mod horizon_continuation;
mod initial_guess;
mod multiple_shooting;
mod multistart;
mod outcome;
mod output_error;
mod post_fit;
mod residual_cache;
mod reweighting;
mod spin_aliases;
mod state;
mod taking_back;
mod undistorted;
mod unlike_flights;
mod warm_start;

use std::borrow::Borrow;
use std::time::Instant;

use model_spec::model::Model;
use nalgebra::DVector;

use self::outcome::Outcome;
use crate::dataset::{Dataset, Role};
use crate::error::{ExcludedFlight, FitError, FlightError};
use crate::ids::FlightId;
use crate::least_squares::SolveError;
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::problem::FitProblem;
use crate::report::{FitReport, FlightEvidence, FlightReport, reasons_against};
use crate::screening;
use crate::tolerance;
pub use held_out::CONDITIONING_FRACTION;
#[cfg(test)]
pub(crate) use horizon_continuation::fit_initial_state;

/// Result of a fit.
pub struct Fit {
    /// The report: estimates, uncertainties, residual diagnostics.
    pub report: FitReport,
    problem: FitProblem,
    marker_names: Vec<String>,
    /// Fitted flights by [`FlightId`]; `None` for excluded flights.
    flights: Vec<Option<FittedFlight>>,
    global: DVector<f64>,
    noise: NoiseModel,
}

/// A fitted or held-out flight.
#[derive(Clone)]
struct FittedFlight {
    observations: Observations,
    /// Estimated initial state of the flight, SI.
    state: DVector<f64>,
}

/// Fits a model to the flights of a dataset.
///
/// # Errors
/// [`FitError::InvalidOption`] for impossible options; [`FitError::UnknownName`], [`FitError::NotEstimated`],
/// [`FitError::NoObservation`] and [`FitError::AttitudeNotObservable`] if model, dataset and options do not match;
/// [`FitError::Flight`] if the known values of a flight do not match the model; [`FitError::NothingToFit`],
/// [`FitError::FaultyData`] and [`FitError::NoUsableFlight`] without usable flights; [`FitError::Interrupted`].
///
/// A flight that cannot be flown or fitted is excluded; its report says why.
pub fn fit(model: &Model, dataset: &Dataset, options: &FitOptions<'_>) -> Result<Fit, FitError> {
    let clock = Instant::now();
    options.validate()?;
    let mut problem = FitProblem::new(model, dataset, options)?;
    let mut fitted = flights_of(dataset, Role::Fit);
    if fitted.is_empty() {
        return Err(FitError::NothingToFit);
    }
    let mut held_out = flights_of(dataset, Role::HeldOut);
    let data_faults = match options.known_faults {
        Some(known) => known.to_vec(),
        None => screening::screen(&problem, dataset, options.threads()),
    };
    let faulty = screening::excluded(dataset, &data_faults, options);
    let is_faulty = |flight: &FlightId| faulty.iter().any(|excluded| excluded.flight == *flight);
    fitted.retain(|flight| !is_faulty(flight));
    held_out.retain(|flight| !is_faulty(flight));
    if fitted.is_empty() {
        return Err(FitError::FaultyData(data_faults));
    }
    let observed = initial_guess::observe(&problem, dataset, &fitted, options);
    problem.sigma0 = observed.sigma0.unwrap_or(problem.sigma0);
    let noise_floor = observed.noise_floor;
    problem.tolerance = tolerance::whitened(model, fitted.len());
    let guesses = initial_guess::initial_guesses(&problem, dataset, observed, options)?;
    let started = clock.elapsed().as_secs_f64();

    let (state, alternatives) = (guesses.state, &guesses.alternatives);
    let (mut state, cache) =
        spin_aliases::resolve_spin_aliases(&problem, state, alternatives, options)?;
    let cache = multiple_shooting::shoot_again(&problem, &mut state, cache, options)?;
    let cache = multistart::multistart(&problem, &mut state, cache, options)?;
    let cache = unlike_flights::exclude_unlike_flights(&problem, &mut state, cache, options)?;
    let cache = contact_refinement::refine_contacts(&problem, dataset, &mut state, cache, options)?;
    let reweighted = reweighting::reweight(&problem, &mut state, cache, options)?;
    let reweighted = taking_back::take_back(&problem, dataset, &mut state, reweighted, options)?;
    let solved = clock.elapsed().as_secs_f64();

    let outcome = Outcome::new(&problem, &state, &reweighted, options)?;
    let mut report = outcome.report();
    let reports: Vec<_> = (0..state.flights.len())
        .map(|i| outcome.flight(i))
        .collect();
    drop(outcome);
    let reweighting::Reweighted {
        noise, solution, ..
    } = reweighted;
    let predicted = held_out::held_out(&problem, dataset, &held_out, &state, &noise, options)?;
    let mut flights = FlightTable::new(dataset.flights.len());
    for excluded in state.excluded.iter().chain(&faulty) {
        flights.exclude(dataset, excluded);
    }
    let states = state.flights.into_iter().zip(solution.iterate.local);
    for ((flight, report), (observations, state)) in state.ids.into_iter().zip(reports).zip(states)
    {
        flights.set(
            flight,
            report,
            Some(FittedFlight {
                observations,
                state,
            }),
        );
    }
    for (&flight, predicted) in held_out.iter().zip(predicted) {
        flights.set(flight, predicted.report, predicted.fitted);
    }
    report.data_faults = data_faults;
    report.flights = flights.reports.into_iter().flatten().collect();
    report.noise.floor_m = noise_floor.map(initial_guess::overall);
    report.why = reasons_against(&report);
    report.reliable = report.why.is_empty();
    let total = clock.elapsed().as_secs_f64();
    let seconds = [
        ("start", started),
        ("fit", solved - started),
        ("total", total),
    ];
    report.seconds = seconds.map(|(name, value)| (name.to_owned(), value)).into();
    Ok(Fit {
        report,
        global: solution.iterate.global,
        problem,
        noise,
        marker_names: dataset.markers.iter().map(|m| m.name.clone()).collect(),
        flights: flights.fitted,
    })
}

fn flights_of(dataset: &Dataset, role: Role) -> Vec<FlightId> {
    let flights = dataset.flights.iter().enumerate();
    let of_role = flights.filter(|(_, flight)| flight.role == role);
    of_role.map(|(index, _)| FlightId::new(index)).collect()
}

/// Reports and fits of all flights, in the dataset's order.
struct FlightTable {
    reports: Vec<Option<FlightReport>>,
    fitted: Vec<Option<FittedFlight>>,
}

impl FlightTable {
    fn new(flights: usize) -> Self {
        Self {
            reports: vec![None; flights],
            fitted: vec![None; flights],
        }
    }

    fn set(&mut self, flight: FlightId, report: FlightReport, fitted: Option<FittedFlight>) {
        self.reports[flight.index()] = Some(report);
        self.fitted[flight.index()] = fitted;
    }

    fn exclude(&mut self, dataset: &Dataset, excluded: &ExcludedFlight) {
        let flight = &dataset.flights[excluded.flight.index()];
        let report = outcome::excluded_report(flight, &excluded.reason);
        self.set(excluded.flight, report, None);
    }
}

impl Fit {
    /// The estimation problem that was solved.
    pub fn problem(&self) -> &FitProblem {
        &self.problem
    }

    /// Names of the markers, in the order of the dataset.
    pub fn marker_names(&self) -> &[String] {
        &self.marker_names
    }

    /// Estimated global parameters, in the order of [`FitProblem::globals`], SI.
    pub fn global(&self) -> &DVector<f64> {
        &self.global
    }

    /// The noise by which residuals were weighted.
    pub fn noise(&self) -> &NoiseModel {
        &self.noise
    }

    /// Observations and initial state of a flight; `None` if the flight is excluded.
    pub fn flight(&self, flight: FlightId) -> Option<(&Observations, &DVector<f64>)> {
        let fitted = self.flights.get(flight.index())?.as_ref()?;
        Some((&fitted.observations, &fitted.state))
    }

    /// Measured and predicted values of a flight; `None` if the flight is excluded.
    pub fn evidence(&self, flight: FlightId) -> Option<FlightEvidence> {
        let (observations, local) = self.flight(flight)?;
        let unknowns = (&self.global, local);
        post_fit::evidence(&self.problem, &self.marker_names, observations, unknowns)
    }
}

/// Converts a least-squares error over these flights to a fit error.
fn solve_error(error: SolveError, flights: &[impl Borrow<Observations>]) -> FitError {
    let (flight, reason) = match error {
        SolveError::Start(failures) => match failures.into_iter().next() {
            Some(failure) => failure,
            None => return FitError::NothingToFit,
        },
        SolveError::Undetermined(undetermined) => {
            (undetermined.0, FlightError::SingularInitialState)
        }
        SolveError::Cancelled => return FitError::Interrupted,
    };
    FitError::Flight {
        file: flights[flight].borrow().file.clone(),
        reason,
    }
}
