//! Observations and initial guesses of the flights, one by one, and which flights are excluded.

use flight::batch;
use nalgebra::DVector;

use super::horizon_continuation::fit_initial_state;
use super::{FitError, State};
use crate::dataset::{Dataset, Flight};
use crate::error::{ExcludedFlight, FlightError};
use crate::ids::FlightId;
use crate::impact_detection;
use crate::initial_state::{self, InitialGuess};
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::pose::Pose;
use crate::problem::FitProblem;
use crate::statistics::median;

/// Length of the first segment of a flight, on which its initial guess is refined, s.
const FIRST_SEGMENT: f64 = 0.15;

/// Least number of samples in the first segment of a flight.
const MIN_FIRST_SAMPLES: usize = 12;

/// Least initial estimate of the noise of one coordinate, m, at the level of rounding in tables.
const MIN_SIGMA0: f64 = 1e-7;

/// Flights that can be fitted, with their initial guesses.
pub struct InitialGuesses {
    /// Observations of the usable flights, each with its best initial guess.
    pub state: State,
    /// Indices of the usable flights in the dataset.
    pub flights: Vec<FlightId>,
    /// All initial guesses of each flight: several where the sampling interval is too long to determine the spin.
    pub alternatives: Vec<Vec<InitialGuess>>,
    /// Flights that cannot be fitted.
    pub excluded: Vec<ExcludedFlight>,
}

/// Observations of the usable flights, and the excluded flights.
pub struct ObservedFlights {
    /// Usable flights.
    pub usable: Vec<(FlightId, Observations)>,
    /// Flights that cannot be used.
    pub excluded: Vec<ExcludedFlight>,
    /// Initial estimate of the noise of one coordinate, m; `None` if the samples do not determine it.
    pub sigma0: Option<f64>,
}

/// Number of samples in the first segment of a flight.
pub fn first_segment(observations: &Observations) -> usize {
    let samples = observations.samples_until(FIRST_SEGMENT);
    samples.max(MIN_FIRST_SAMPLES).min(observations.times.len())
}

/// Extracts the observations of the given flights and estimates their noise.
pub fn observe(
    problem: &FitProblem,
    dataset: &Dataset,
    flights: &[FlightId],
    options: &FitOptions<'_>,
) -> ObservedFlights {
    let each = batch::each_on(options.threads(), flights.len(), |index| {
        let flight = &dataset.flights[flights[index].index()];
        let (observations, poses) = observations_and_poses(problem, flight)?;
        let sigma0 = initial_state::sigma0(problem, &observations, &poses);
        Ok((observations, sigma0))
    });
    let (mut usable, mut excluded) = (Vec::with_capacity(flights.len()), Vec::new());
    let mut estimates = Vec::with_capacity(flights.len());
    for (&flight, found) in flights.iter().zip(each) {
        match found {
            Ok((observations, sigma0)) => {
                usable.push((flight, observations));
                estimates.extend(sigma0);
            }
            Err(reason) => excluded.push(exclude(dataset, flight, reason)),
        }
    }
    let sigma0 = (!estimates.is_empty()).then(|| median(&mut estimates).max(MIN_SIGMA0));
    ObservedFlights {
        usable,
        excluded,
        sigma0,
    }
}

fn exclude(dataset: &Dataset, flight: FlightId, reason: FlightError) -> ExcludedFlight {
    ExcludedFlight {
        flight,
        file: dataset.flights[flight.index()].file.clone(),
        reason,
    }
}

/// Finds initial guesses of the flights.
///
/// # Errors
/// [`FitError::NoUsableFlight`] if no flight has one; [`FitError::Interrupted`].
pub fn initial_guesses(
    problem: &FitProblem,
    dataset: &Dataset,
    observed: ObservedFlights,
    options: &FitOptions<'_>,
) -> Result<InitialGuesses, FitError> {
    let ObservedFlights {
        usable,
        mut excluded,
        ..
    } = observed;
    options.stage_started("starts", usable.len());
    let intervals = usable.iter();
    let mut intervals: Vec<f64> = intervals.filter_map(|(_, o)| o.interval()).collect();
    let values = problem.globals.iter().map(|global| global.model_value);
    let global = DVector::from_iterator(problem.globals.len(), values);
    let found = batch::each_on(options.threads(), usable.len(), |index| {
        if options.is_cancelled() {
            return Err(FlightError::Interrupted);
        }
        let found = refined_guesses(problem, &usable[index].1, &global, options);
        options.flight_done();
        found
    });
    if options.is_cancelled() {
        return Err(FitError::Interrupted);
    }
    let interval = if intervals.is_empty() {
        1.0
    } else {
        median(&mut intervals)
    };
    let mut state = State::new(global, interval);
    let (mut flights, mut alternatives) = (Vec::new(), Vec::new());
    for ((flight, observations), found) in usable.into_iter().zip(found) {
        match found {
            Ok(guesses) => {
                let guesses: Vec<_> = guesses.into_iter().map(|(_, guess)| guess).collect();
                flights.push(flight);
                state.local.push(guesses[0].state.clone());
                state.flights.push(observations);
                alternatives.push(guesses);
            }
            Err(reason) => excluded.push(exclude(dataset, flight, reason)),
        }
    }
    if flights.is_empty() {
        excluded.sort_unstable_by_key(|excluded| excluded.flight);
        return Err(FitError::NoUsableFlight(excluded));
    }
    Ok(InitialGuesses {
        state,
        alternatives,
        flights,
        excluded,
    })
}

/// Note for the report of a flight whose spin is not the slowest that its samples allow.
pub fn spin_note(turns: i32) -> String {
    format!(
        "between samples it makes whole turns ({turns:+}) beyond what neighbouring samples show"
    )
}

/// Observations of a flight, truncated at an impact.
///
/// # Errors
/// As [`Observations::new`]; [`FlightError::TooFewCoordinates`].
pub fn observations(problem: &FitProblem, flight: &Flight) -> Result<Observations, FlightError> {
    Ok(observations_and_poses(problem, flight)?.0)
}

/// Observations of a flight, truncated at an impact, with the pose in each sample of a body that has an attitude.
///
/// # Errors
/// Those of [`Observations::new`]; [`FlightError::TooFewCoordinates`].
fn observations_and_poses(
    problem: &FitProblem,
    flight: &Flight,
) -> Result<(Observations, Vec<Option<Pose>>), FlightError> {
    let mut observations = Observations::new(problem, flight)?;
    let poses = impact_detection::truncate_at_impact(problem, &mut observations);
    let measured = 3 * observations.measured.iter().flatten().count();
    let unknowns = observations.manifold.dimension();
    if measured < unknowns {
        return Err(FlightError::TooFewCoordinates { measured, unknowns });
    }
    Ok((observations, poses))
}

/// Initial guesses refined by a fit to the first segment with the global parameters fixed, each with its sum of squares;
/// the guess of slowest spin first.
///
/// # Errors
/// [`FlightError`] if no guess can be found or refined.
pub fn refined_guesses(
    problem: &FitProblem,
    observations: &Observations,
    global: &DVector<f64>,
    options: &FitOptions<'_>,
) -> Result<Vec<(f64, InitialGuess)>, FlightError> {
    let samples = first_segment(observations);
    let mut refined = Vec::new();
    let mut failure = FlightError::NoMatchingState;
    for InitialGuess { state, turns } in initial_state::initial_guesses(problem, observations)? {
        match fit_initial_state(problem, observations, samples, global, state, options) {
            Ok((squares, state)) => refined.push((squares, InitialGuess { state, turns })),
            Err(reason) => failure = reason,
        }
    }
    match refined.is_empty() {
        true => Err(failure),
        false => Ok(refined),
    }
}
