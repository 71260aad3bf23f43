//! Initial guesses of a flight's state from its samples alone.
//!
//! The poses of the first samples determine the rigid-body motion at the first sample. The state with this motion is
//! found by numerical inversion of the model's measurement equation, so that the method does not depend on the choice
//! of states.

mod instruments;
mod observation_inverse;
mod rigid_motion;

use nalgebra::DVector;

pub use observation_inverse::state_for_motion;
pub use rigid_motion::{RigidMotion, sigma0};

use crate::error::FlightError;
use crate::observations::Observations;
use crate::problem::FitProblem;

/// An initial guess of the state of a flight at its first sample.
#[derive(Clone, Debug, PartialEq)]
pub struct InitialGuess {
    /// State at the first sample, SI.
    pub state: DVector<f64>,
    /// Number of turns per sampling interval added to the slowest spin that is compatible with the samples.
    pub turns: i32,
    /// Index of the speed from which the guess was made, among those that were tried; 0 if positions are measured.
    pub speed: usize,
}

/// Maximum spin of an additional initial guess that has whole turns per sampling interval added (aliasing), rad/s.
/// Strong throws reach about 160 rad/s.
const MAX_SPIN: f64 = 400.0;

/// Returns initial guesses of a flight, the most probable one first. There are several if the samples are too far apart
/// to determine the number of turns between them (aliasing).
///
/// # Errors
/// [`FlightError::TooFewPoses`], [`FlightError::TooFewPositions`] or [`FlightError::NoNeighbouringPoses`] if the
/// samples do not determine the motion; [`FlightError::NoMatchingState`] if no state of the model has this motion.
pub fn initial_guesses(
    problem: &FitProblem,
    observations: &Observations,
) -> Result<Vec<InitialGuess>, FlightError> {
    if !problem.sees_positions() {
        return instrument_guesses(problem, observations);
    }
    let motion = rigid_motion::first_motion(problem, observations)?;
    let whole = observations
        .interval()
        .map_or(f64::INFINITY, |dt| std::f64::consts::TAU / dt);
    let spin = motion.rates.map_or(0.0, |rates| rates.norm());
    let aliases = if spin == 0.0 {
        &[0][..]
    } else {
        &[0, -1, 1][..]
    };
    let mut guesses = Vec::new();
    let mut failure = FlightError::NoMatchingState;
    for &turns in aliases {
        let motion = motion.with_turns(turns, whole);
        if turns != 0 && motion.rates.is_none_or(|rates| rates.norm() > MAX_SPIN) {
            continue;
        }
        match state_for_motion(problem, observations, &motion) {
            Ok(state) => guesses.push(InitialGuess {
                state,
                turns,
                speed: 0,
            }),
            Err(reason) => failure = reason,
        }
    }
    if guesses.is_empty() {
        Err(failure)
    } else {
        Ok(guesses)
    }
}

/// Initial guesses of a flight without measured positions: one for each of several motions that are compatible with the
/// readings of the instruments. The caller selects among them by fits to the samples.
fn instrument_guesses(
    problem: &FitProblem,
    observations: &Observations,
) -> Result<Vec<InitialGuess>, FlightError> {
    let motions = instruments::motions(problem, observations)?;
    let states = motions.iter().filter_map(|(speed, motion)| {
        let state = state_for_motion(problem, observations, motion).ok()?;
        Some(InitialGuess {
            state,
            turns: 0,
            speed: *speed,
        })
    });
    let guesses: Vec<InitialGuess> = states.collect();
    match guesses.is_empty() {
        true => Err(FlightError::NoMatchingState),
        false => Ok(guesses),
    }
}
