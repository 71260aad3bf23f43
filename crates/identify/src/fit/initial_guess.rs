//! Observations and initial guesses of single flights, and exclusion of unusable flights.

use flight::parallel;

use super::FitError;
use super::one_flight::FixedGlobal;
use super::state::State;
use crate::error::{ExcludedFlight, FlightError};
use crate::ground_contact::{self, ContactSearch};
use crate::ids::FlightId;
use crate::initial_state::{self, InitialGuess};
use crate::noise_floor::{median_noise_floor, noise_floor};
use crate::observations::{Observations, median_interval};
use crate::options::FitOptions;
use crate::problem::FitProblem;
use crate::vertical;
use dataset::pose::Pose;
use dataset::statistics::median_of;
use dataset::{Dataset, Flight};
use model_spec::sort_by_number;

/// Duration of the first segment of a flight, to which the guess of its initial state is fitted, s.
const FIRST_SEGMENT: f64 = 0.15;

/// Minimum number of samples in the first segment of a flight, to which the guess of its initial state is fitted. For a
/// flight with fewer samples, the segment is the whole flight.
const MIN_FIRST_SAMPLES: usize = 12;

/// Minimum initial estimate of the noise of one coordinate, m, to which smaller estimates are raised. It is about the
/// rounding error of recorded coordinates.
const MIN_SIGMA0: f64 = 1e-7;

/// Ratio of the noise floor (scatter about smooth paths) to the noise estimated from the rigidity of the markers, below
/// which the noise floor is used instead. The deviations of the markers from a rigid body are then due to wrong marker
/// positions or sampling times. Correlated noise also lowers the ratio, but less.
const MAX_FLOOR_RATIO: f64 = 0.2;

/// Number of initial guesses of each speed that are kept for a flight.
const KEPT: usize = 5;

/// Relative difference of sums of squares, and of states, below which two guesses are refined to the same one.
const SAME_GUESS: f64 = 1e-3;

/// Noise of a coordinate averaged over the axes: root mean square of the standard deviations `sigma` along the three
/// axes.
pub fn overall(sigma: [f64; 3]) -> f64 {
    (sigma.iter().map(|sigma| sigma * sigma).sum::<f64>() / 3.0).sqrt()
}

/// Flights that can be fitted, each with one or more initial guesses of its initial state.
pub struct InitialGuesses<'a> {
    /// Usable flights, each with its best initial guess, and excluded flights.
    pub state: State<'a>,
    /// All initial guesses of each flight. There are several if the sampling interval is too long to determine the
    /// spin.
    pub alternatives: Vec<Vec<InitialGuess>>,
}

/// Observations of the flights that can be fitted, excluded flights, and noise estimates.
pub struct ObservedFlights {
    /// Flights that can be fitted, each with its observations.
    pub usable: Vec<(FlightId, Observations)>,
    /// Flights that cannot be used, with the reasons.
    pub excluded: Vec<ExcludedFlight>,
    /// Initial estimate of the noise of one coordinate, m, from deviations of the markers from a rigid body; `None` if
    /// the samples do not determine it.
    pub sigma0: Option<f64>,
    /// Noise floor: standard deviation along each axis of the noise of one coordinate, estimated by a smoother, m;
    /// `None` if the samples do not determine it.
    pub noise_floor: Option<[f64; 3]>,
}

/// Number of samples in the first segment of a flight, to which the guess of its initial state is fitted.
pub fn first_segment(observations: &Observations) -> usize {
    let samples = observations.samples_until(FIRST_SEGMENT);
    samples.max(MIN_FIRST_SAMPLES).min(observations.times.len())
}

/// Extracts the observations of the flights `flights` of a dataset and estimates their noise. `contacts` contains, by
/// index of the flight in the dataset, the results of an earlier search for ground contacts; empty if there was none.
pub fn observe(
    problem: &FitProblem,
    dataset: &Dataset,
    flights: &[FlightId],
    contacts: &[Option<ContactSearch>],
    options: &FitOptions<'_>,
) -> ObservedFlights {
    let each = parallel::each_on(options.threads(), flights.len(), |index| {
        let flight = flights[index].index();
        let search = contacts.get(flight).and_then(Option::as_ref);
        let flight = &dataset.flights[flight];
        let (observations, poses) = observations_and_poses(problem, flight, search)?;
        let sigma0 = initial_state::sigma0(problem, &observations, &poses);
        let floor = noise_floor(problem, &observations, &poses);
        Ok((observations, sigma0, floor))
    });
    let (mut usable, mut excluded) = (Vec::with_capacity(flights.len()), Vec::new());
    let (mut estimates, mut floors) = (Vec::with_capacity(flights.len()), Vec::new());
    for (&flight, found) in flights.iter().zip(each) {
        match found {
            Ok((observations, sigma0, floor)) => {
                usable.push((flight, observations));
                estimates.extend(sigma0);
                floors.extend(floor);
            }
            Err(reason) => excluded.push(exclude(dataset, flight, reason)),
        }
    }
    let mut sigma0 = median_of(estimates).map(|sigma0| sigma0.max(MIN_SIGMA0));
    let noise_floor = median_noise_floor(&floors);
    if let (Some(sigma0), Some(floor)) = (&mut sigma0, noise_floor) {
        let floor = overall(floor);
        if floor < MAX_FLOOR_RATIO * *sigma0 {
            *sigma0 = floor.max(MIN_SIGMA0);
        }
    }
    ObservedFlights {
        usable,
        excluded,
        sigma0,
        noise_floor,
    }
}

fn exclude(dataset: &Dataset, flight: FlightId, reason: FlightError) -> ExcludedFlight {
    ExcludedFlight {
        flight,
        file: dataset.flights[flight.index()].file.clone(),
        reason,
    }
}

/// Determines initial guesses of the initial states of the flights, with the global parameters at their initial values.
///
/// # Errors
/// [`FitError::NoUsableFlight`] if no flight has an initial guess; [`FitError::Interrupted`] if the work is cancelled.
pub fn initial_guesses<'a>(
    problem: &'a FitProblem,
    dataset: &Dataset,
    observed: ObservedFlights,
    options: &'a FitOptions<'a>,
) -> Result<InitialGuesses<'a>, FitError> {
    let ObservedFlights {
        usable,
        mut excluded,
        ..
    } = observed;
    options.stage_started("starts", usable.len());
    let interval = median_interval(usable.iter().map(|(_, observations)| observations));
    let mut state = State::new(problem, options, problem.model_values(), interval);
    let at = state.fixed_global();
    let found = parallel::each_on(options.threads(), usable.len(), |index| {
        if options.is_cancelled() {
            return Err(FlightError::Interrupted);
        }
        let found = refined_guesses(at, &usable[index].1);
        options.flight_done();
        found
    });
    if options.is_cancelled() {
        return Err(FitError::Interrupted);
    }
    let mut alternatives = Vec::new();
    for ((flight, observations), found) in usable.into_iter().zip(found) {
        match found {
            Ok(guesses) => {
                let guesses: Vec<_> = guesses.into_iter().map(|(_, guess)| guess).collect();
                state.push(flight, observations, guesses[0].state.clone());
                alternatives.push(guesses);
            }
            Err(reason) => excluded.push(exclude(dataset, flight, reason)),
        }
    }
    state.excluded = excluded;
    state.exclude(Vec::new())?;
    Ok(InitialGuesses {
        state,
        alternatives,
    })
}

/// Note for the report of a flight whose spin is not the slowest one compatible with its samples. `turns` is the number
/// of additional turns between successive samples.
pub fn spin_note(turns: i32) -> String {
    format!(
        "between samples it makes whole turns ({turns:+}) beyond what neighbouring samples show"
    )
}

/// Observations of a flight, truncated at its first ground contact, with the pose in each sample if the body has an
/// attitude. The contact is searched for unless `search` contains the result of an earlier search; without such a
/// result, the flight is not truncated if the vertical is unknown.
///
/// # Errors
/// The errors of [`Observations::new`]; [`FlightError::TooFewCoordinates`] if the samples do not determine the initial
/// state.
pub fn observations_and_poses(
    problem: &FitProblem,
    flight: &Flight,
    search: Option<&ContactSearch>,
) -> Result<(Observations, Vec<Option<Pose>>), FlightError> {
    let mut observations = Observations::new(problem, flight)?;
    let unseen = flight
        .times
        .partition_point(|time| *time < observations.origin);
    let search = match search {
        Some(search) => Some(search.of_part(unseen, observations.times.len())),
        // The effect of a contact with the ground is not known if the vertical is not known.
        None => vertical::is_in(&problem.model).then(ContactSearch::default),
    };
    let poses = ground_contact::truncate_at_contact(problem, &mut observations, search);
    let measured = 3 * observations.measured.iter().flatten().count();
    let unknowns = observations.manifold.dimension();
    if measured < unknowns {
        return Err(FlightError::TooFewCoordinates { measured, unknowns });
    }
    Ok((observations, poses))
}

/// Returns guesses of the initial state of a flight, refined by a fit to the first segment of the flight, each with its
/// sum of squares after the fit; the guess with the slowest spin is first. If no positions are measured, returns the
/// best guesses of each speed, the smallest sum of squares first. After the deadline set in the fit options, guesses are returned without
/// refinement, with an infinite sum of squares.
///
/// # Errors
/// [`FlightError`] if no guess can be found or refined.
pub fn refined_guesses(
    at: FixedGlobal<'_>,
    observations: &Observations,
) -> Result<Vec<(f64, InitialGuess)>, FlightError> {
    let problem = at.problem;
    let samples = first_segment(observations);
    let mut refined = Vec::new();
    let mut failure = FlightError::NoMatchingState;
    for guess in initial_state::initial_guesses(problem, observations)? {
        if at.options.is_past_deadline() {
            refined.push((f64::INFINITY, guess));
            continue;
        }
        match at.fit_initial_state(observations, samples, guess.state.clone()) {
            Ok((squares, state)) => refined.push((squares, InitialGuess { state, ..guess })),
            Err(reason) => failure = reason,
        }
    }
    if !problem.sees_positions() {
        keep_best(&mut refined);
    }
    match refined.is_empty() {
        true => Err(failure),
        false => Ok(refined),
    }
}

/// Keeps the best guesses of each speed, each with its sum of squares, the smallest sum of squares first. Short first
/// segments look alike at different speeds.
fn keep_best(guesses: &mut Vec<(f64, InitialGuess)>) {
    sort_by_number(guesses, |(squares, _)| *squares);
    let mut kept: Vec<(f64, InitialGuess)> = Vec::new();
    for (squares, guess) in guesses.drain(..) {
        let of_speed = kept.iter().filter(|(_, other)| other.speed == guess.speed);
        let is_known = of_speed.clone().any(|(least, other)| {
            squares - least <= SAME_GUESS * least
                && (&guess.state - &other.state).norm() < SAME_GUESS * other.state.norm()
        });
        if !is_known && of_speed.count() < KEPT {
            kept.push((squares, guess));
        }
    }
    *guesses = kept;
}
