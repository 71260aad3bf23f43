//! Initial guesses of a flight's state from its samples alone: the poses of the first samples give the rigid-body
//! motion, and the state with this motion is found by inversion of the model's measurement equation, whatever the
//! states are.

mod instruments;
mod observation_inverse;
mod rigid_motion;

use nalgebra::DVector;

use dataset::pose::RigidMotion;
pub use observation_inverse::state_for_motion;
pub use rigid_motion::sigma0;

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

/// Maximum spin of a guess with additional turns per sampling interval, rad/s; strong throws reach about 160.
const MAX_SPIN: f64 = 400.0;

/// Returns initial guesses of a flight, the most probable one first; several if samples are too far apart to determine
/// the number of turns between them.
///
/// # Errors
/// [`FlightError::TooFewPoses`], [`FlightError::TooFewPositions`] or [`FlightError::NoNeighbouringPoses`] if the
/// samples do not determine the motion; [`FlightError::NoMatchingState`] if no state of the model has it.
pub fn initial_guesses(
    problem: &FitProblem,
    observations: &Observations,
) -> Result<Vec<InitialGuess>, FlightError> {
    let motions = match problem.sees_positions() {
        true => motions_with_turns(problem, observations)?,
        false => instruments::motions(problem, observations)?,
    };
    let mut guesses = Vec::new();
    let mut failure = FlightError::NoMatchingState;
    for (speed, turns, motion) in motions {
        match state_for_motion(problem, observations, &motion) {
            Ok(state) => guesses.push(InitialGuess {
                state,
                turns,
                speed,
            }),
            Err(reason) => failure = reason,
        }
    }
    match guesses.is_empty() {
        true => Err(failure),
        false => Ok(guesses),
    }
}

/// Index of a speed, number of additional turns, and motion at the first sample.
type TriedMotion = (usize, i32, RigidMotion);

/// Motions that the samples show, with additional turns between samples.
fn motions_with_turns(
    problem: &FitProblem,
    observations: &Observations,
) -> Result<Vec<TriedMotion>, FlightError> {
    let motion = rigid_motion::first_motion(problem, observations)?;
    let interval = observations.interval();
    let whole = interval.map_or(f64::INFINITY, |dt| std::f64::consts::TAU / dt);
    let spin = |motion: &RigidMotion| motion.rates.map_or(0.0, |rates| rates.norm());
    let turns: &[i32] = if spin(&motion) == 0.0 {
        &[0]
    } else {
        &[0, -1, 1]
    };
    let each = turns
        .iter()
        .map(|&turns| (0, turns, motion.with_turns(turns, whole)));
    let is_possible = |(_, turns, motion): &TriedMotion| *turns == 0 || spin(motion) <= MAX_SPIN;
    Ok(each.filter(is_possible).collect())
}
