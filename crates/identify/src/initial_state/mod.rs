//! Where a fit starts, from the samples alone.
//!
//! The markers' poses, frame by frame, give where the body is and how it moves at its first sample; the state that
//! shows its markers so is found by the model's own observation, whatever its states are.

mod observation_inverse;
mod rigid_motion;

use nalgebra::DVector;

pub use rigid_motion::{RigidMotion, sigma0};

use crate::observations::Observations;
use crate::problem::FitProblem;

/// A start with how it was made.
#[derive(Clone, Debug, PartialEq)]
pub struct InitialGuess {
    /// The state at the first sample.
    pub state: DVector<f64>,
    /// Whole turns between samples that were added to the least spin.
    pub turns: i32,
}

/// Spins beyond this are not believed, rad/s: a strong arm reaches about 160.
const FASTEST: f64 = 400.0;

/// The state in which a body moves so, at the beginning of a track whose samples need not show anything.
///
/// # Errors
/// In words, where the model has no such state.
pub fn state_for_motion(
    problem: &FitProblem,
    observations: &Observations,
    motion: &RigidMotion,
) -> Result<DVector<f64>, String> {
    observation_inverse::state(problem, observations, motion)
}

/// Starts for a track, the likeliest first: more than one where the samples are too far apart to tell by how many
/// turns the body spun between them.
///
/// # Errors
/// In words, where the samples do not show how the body moves, or the model cannot move so.
pub fn initial_guesses(
    problem: &FitProblem,
    observations: &Observations,
) -> Result<Vec<InitialGuess>, String> {
    let motion = rigid_motion::of(problem, observations)?;
    let whole = observations
        .interval()
        .map_or(f64::INFINITY, |dt| std::f64::consts::TAU / dt);
    let spin = motion.rates.map_or(0.0, |rates| rates.norm());
    let aliases = if spin == 0.0 {
        &[0][..]
    } else {
        &[0, -1, 1][..]
    };
    let mut starts = Vec::new();
    let mut refused = String::new();
    for &turns in aliases {
        let motion = motion.with_turns(turns, whole);
        if turns != 0 && motion.rates.is_none_or(|rates| rates.norm() > FASTEST) {
            continue;
        }
        match observation_inverse::state(problem, observations, &motion) {
            Ok(state) => starts.push(InitialGuess { state, turns }),
            Err(reason) => refused = reason,
        }
    }
    if starts.is_empty() {
        Err(refused)
    } else {
        Ok(starts)
    }
}
