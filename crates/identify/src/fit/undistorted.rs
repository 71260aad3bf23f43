//! Initial guesses from corrected samples. Estimated parameters of the measurement may distort the samples: markers
//! that are recorded late, a scale, misplaced markers. The poses of distorted samples show a motion that is not that of
//! the body.

use flight::parallel;
use nalgebra::DVector;

use super::initial_guess::first_segment;
use super::one_flight::FixedGlobal;
use super::state::State;
use crate::error::FlightError;
use crate::initial_state::{self, InitialGuess};
use crate::marker_observers::MarkerConditions;
use crate::observations::Observations;
use crate::predict::states;
use crate::problem::FitProblem;

/// Maximum number of iterations in which samples are corrected for distortions by the measurement, such as late
/// recording. Each computes the distortion at the present initial state, and estimates the initial state again from the
/// corrected samples, because the distortion depends on the motion.
const PASSES: usize = 4;

/// Maximum distortion that is neglected: displacement of a marker position by an error of the measurement such as late
/// recording, in units of the initial noise estimate `sigma0`.
const NEGLIGIBLE: f64 = 3.0;

/// Returns the initial guesses from the measured samples. If the global parameters of `at` predict that the measurement
/// distorts the samples noticeably, for example by late recording, a guess from corrected samples follows.
///
/// # Errors
/// The errors of [`initial_state::initial_guesses`].
pub fn initial_guesses(
    at: FixedGlobal<'_>,
    observations: &Observations,
) -> Result<Vec<InitialGuess>, FlightError> {
    let mut guesses = initial_state::initial_guesses(at.problem, observations)?;
    let found = undistorted_guess(at.problem, observations, at.global, &guesses[0].state);
    guesses.extend(found.map(|state| InitialGuess {
        state,
        turns: 0,
        speed: 0,
    }));
    Ok(guesses)
}

/// Initial guess from samples that are corrected for the distortion by the measurement, for example by late recording.
/// The distortion is predicted from the parameters `global` and the initial state `local`. `None` if it is negligible.
fn undistorted_guess(
    problem: &FitProblem,
    observations: &Observations,
    global: &DVector<f64>,
    local: &DVector<f64>,
) -> Option<DVector<f64>> {
    let first = observations.first_samples(first_segment(observations));
    let mut found: Option<DVector<f64>> = None;
    for _ in 0..PASSES {
        let local = found.as_ref().unwrap_or(local);
        let Some(undistorted) = without_distortion(problem, &first, (global, local)) else {
            break;
        };
        match initial_state::initial_guesses(problem, &undistorted) {
            Ok(again) => found = again.into_iter().next().map(|guess| guess.state),
            Err(_) => break,
        }
    }
    found
}

/// Initial values of all unknowns with which the fit is repeated. Parameters by which the measurement distorts the
/// samples, such as a recording delay, have their present values; other parameters have the model's values; initial
/// states are estimated from samples corrected for the distortion. `None` if no parameter distorts the samples
/// noticeably.
pub fn start<'a>(state: &State<'a>) -> Option<State<'a>> {
    let problem = state.problem;
    let mut global = problem.model_values();
    let (observations, local) = (state.flights.first()?, state.local.first()?);
    let first = observations.first_samples(first_segment(observations));
    let of_measurement = (0..global.len()).filter(|&index| {
        let mut changed = global.clone();
        changed[index] = state.global[index];
        without_distortion(problem, &first, (&changed, local)).is_some()
    });
    let of_measurement: Vec<usize> = of_measurement.collect();
    if of_measurement.is_empty() {
        return None;
    }
    for index in of_measurement {
        global[index] = state.global[index];
    }
    let at = FixedGlobal {
        global: &global,
        ..state.fixed_global()
    };
    let found = parallel::each_on(state.options.threads(), state.flights.len(), |flight| {
        let observations = &state.flights[flight];
        let guesses = initial_state::initial_guesses(problem, observations).ok()?;
        let as_seen = guesses.into_iter().next()?.state;
        let guess = undistorted_guess(problem, observations, &global, &as_seen)?;
        let first = first_segment(observations);
        Some(at.fit_initial_state(observations, first, guess).ok()?.1)
    });
    let mut started = state.clone();
    started.global = global;
    started.limits.fill(f64::INFINITY);
    for (local, found) in started.local.iter_mut().zip(found) {
        if let Some(found) = found {
            *local = found;
        }
    }
    Some(started)
}

/// Subtracts from the samples the distortion by the measurement, for example by late recording. The distortion is the
/// difference between the marker positions predicted with the parameters `global` and those predicted with the model's
/// initial parameter values on the same trajectory. `None` if it is negligible, if the flight cannot be integrated, or
/// if the pose is not determined by markers alone.
fn without_distortion(
    problem: &FitProblem,
    observations: &Observations,
    (global, local): (&DVector<f64>, &DVector<f64>),
) -> Option<Observations> {
    if !problem.is_shown_by_markers() {
        return None;
    }
    let samples = observations.times.len();
    let trajectory = states(problem, observations, (global, local), samples).ok()?;
    let bound = [global, &problem.model_values()].map(|global| {
        let parameters = observations.parameters(problem, global);
        MarkerConditions::new(&problem.body, &parameters, observations.markers)
    });
    let [mut distorted, mut plain] = bound.each_ref().map(MarkerConditions::observers);
    let mut found = observations.clone();
    let mut greatest: f64 = 0.0;
    let states = trajectory.chunks(observations.manifold.states());
    for (sample, state) in states.enumerate() {
        let time = observations.times[sample];
        for (marker, position) in problem.markers.iter().enumerate() {
            let Some(point) = &mut found.measured[sample * observations.channels + marker] else {
                continue;
            };
            let seen = distorted.position(time, state, (marker, position));
            let place = plain.position(time, state, (marker, position));
            for axis in 0..3 {
                let shift = seen[axis] - place[axis];
                point[axis] -= shift;
                greatest = greatest.max(shift.abs());
            }
        }
    }
    let is_distorted = greatest.is_finite() && greatest > NEGLIGIBLE * problem.sigma0;
    is_distorted.then_some(found)
}
