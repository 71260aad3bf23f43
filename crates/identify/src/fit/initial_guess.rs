//! Tracks and starts of the flights, each on its own: which can be fitted, and from where.

use flight::batch;
use nalgebra::DVector;

use super::horizon_continuation::fit_initial_state;
use super::{FitError, State};
use crate::dataset::{Dataset, Flight};
use crate::impact_detection;
use crate::initial_state::{self, InitialGuess};
use crate::noise::median;
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::pose::Pose;
use crate::problem::FitProblem;

/// The first part of a flight that its start is judged on, s and samples.
pub const FIRST: (f64, usize) = (0.15, 12);

/// The least that is believed of noise, m: as much as a table of rounded numbers has.
const LEAST_FLOOR: f64 = 1e-7;

/// What the flights begin with.
pub struct InitialGuesses {
    /// The flights that can be fitted, with their starts.
    pub state: State,
    /// Their indices in the dataset.
    pub flights: Vec<usize>,
    /// Every start of each: more than one where the samples are too far apart to tell its spin.
    pub alternatives: Vec<Vec<InitialGuess>>,
    /// Flights that cannot, and why.
    pub left_out: Vec<(usize, String)>,
}

/// Tracks of flights by index, and the flights that have none, with why.
pub type Tracks = (Vec<(usize, Observations)>, Vec<(usize, String)>);

/// Makes tracks of these flights, and a first estimate of their noise, m.
pub fn observation_sets(
    problem: &FitProblem,
    dataset: &Dataset,
    flights: &[usize],
    options: &FitOptions<'_>,
) -> (Tracks, f64) {
    let made = batch::each_on(options.threads(), flights.len(), |index| {
        let (observations, poses) = track_and_poses(problem, &dataset.flights[flights[index]])?;
        let sigma0 = initial_state::sigma0(problem, &observations, &poses);
        Ok((observations, sigma0))
    });
    let (mut observation_sets, mut left_out) = (Vec::with_capacity(flights.len()), Vec::new());
    let mut floors = Vec::with_capacity(flights.len());
    for (&flight, made) in flights.iter().zip(made) {
        match made {
            Ok((observations, sigma0)) => {
                observation_sets.push((flight, observations));
                floors.extend(sigma0);
            }
            Err(reason) => left_out.push((flight, reason)),
        }
    }
    let sigma0 = match floors.is_empty() {
        true => problem.sigma0,
        false => median(&mut floors).max(LEAST_FLOOR),
    };
    ((observation_sets, left_out), sigma0)
}

/// Finds starts of these flights.
///
/// # Errors
/// Where none of them can be fitted.
pub fn initial_guesses(
    problem: &FitProblem,
    dataset: &Dataset,
    (observation_sets, mut left_out): Tracks,
    options: &FitOptions<'_>,
) -> Result<InitialGuesses, FitError> {
    options.begins("starts", observation_sets.len());
    let mut intervals: Vec<f64> = observation_sets
        .iter()
        .filter_map(|(_, observations)| observations.interval())
        .collect();
    let global = DVector::from_iterator(
        problem.globals.len(),
        problem.globals.iter().map(|global| global.model_value),
    );
    let found = batch::each_on(options.threads(), observation_sets.len(), |index| {
        if options.is_stopped() {
            return Err("interrupted".to_owned());
        }
        let found = fitted_guesses(problem, &observation_sets[index].1, &global, options);
        options.part_done();
        found
    });
    if options.is_stopped() {
        return Err(FitError::Interrupted);
    }
    let mut state = State {
        observation_sets: Vec::with_capacity(observation_sets.len()),
        global,
        local: Vec::with_capacity(observation_sets.len()),
        interval: if intervals.is_empty() {
            1.0
        } else {
            median(&mut intervals)
        },
        steps: 0,
        rounds: 0,
    };
    let mut usable = Vec::with_capacity(observation_sets.len());
    let mut alternatives = Vec::with_capacity(observation_sets.len());
    for ((flight, observations), found) in observation_sets.into_iter().zip(found) {
        match found {
            Ok(starts) => {
                let starts: Vec<InitialGuess> =
                    starts.into_iter().map(|(_, start)| start).collect();
                usable.push(flight);
                state.local.push(starts[0].state.clone());
                state.observation_sets.push(observations);
                alternatives.push(starts);
            }
            Err(reason) => left_out.push((flight, reason)),
        }
    }
    if usable.is_empty() {
        left_out.sort_unstable();
        let each = left_out.iter().take(10);
        let reasons: Vec<String> = each
            .map(|(flight, reason)| format!("  {}: {reason}", dataset.flights[*flight].file))
            .collect();
        return Err(FitError::NoFlight(reasons.join("\n")));
    }
    Ok(InitialGuesses {
        state,
        alternatives,
        flights: usable,
        left_out,
    })
}

/// What is said of a flight whose spin was not the least that its samples allow.
pub fn spin_note(turns: i32) -> String {
    format!(
        "between samples it makes whole turns ({turns:+}) beside what neighbouring samples show"
    )
}

/// A track of a flight, cut at the ground.
pub fn observations(problem: &FitProblem, flight: &Flight) -> Result<Observations, String> {
    Ok(track_and_poses(problem, flight)?.0)
}

/// The same with the poses in its samples, of a body that turns.
fn track_and_poses(
    problem: &FitProblem,
    flight: &Flight,
) -> Result<(Observations, Vec<Option<Pose>>), String> {
    let mut observations = Observations::new(problem, flight)?;
    let poses = impact_detection::truncate_at_impact(problem, &mut observations);
    let points = observations.measured.iter().flatten().count();
    let unknowns = observations.manifold.dimension();
    if 3 * points < unknowns {
        let measured = 3 * points;
        return Err(format!(
            "{measured} measured coordinates do not determine the {unknowns} unknowns of its initial state"
        ));
    }
    Ok((observations, poses))
}

/// Starts whose first samples were fitted with the shared unknowns held, the one of least spin first; and how well each
/// met them.
pub fn fitted_guesses(
    problem: &FitProblem,
    observations: &Observations,
    global: &DVector<f64>,
    options: &FitOptions<'_>,
) -> Result<Vec<(f64, InitialGuess)>, String> {
    let samples = observations
        .samples_until(FIRST.0)
        .max(FIRST.1)
        .min(observations.times.len());
    let mut fitted = Vec::new();
    let mut refused = String::new();
    for InitialGuess { state, turns } in initial_state::initial_guesses(problem, observations)? {
        match fit_initial_state(problem, observations, samples, global, state, options) {
            Ok((squares, state)) => fitted.push((squares, InitialGuess { state, turns })),
            Err(reason) => refused = reason,
        }
    }
    if fitted.is_empty() {
        Err(refused)
    } else {
        Ok(fitted)
    }
}
