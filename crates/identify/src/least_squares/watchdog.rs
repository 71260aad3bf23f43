//! Watchdog technique: first steps of an iteration that may increase the sum of squares.

use super::levenberg_marquardt::{INITIAL_DAMPING, descend};
use super::linearization::{Evaluated, Step};
use super::{Iterate, LeastSquaresProblem, Solution, SolveError, StoppingCriteria};

/// Maximum number of undamped steps after which the sum of squares must be less than at the start.
const MAX_UNDAMPED_STEPS: usize = 4;

/// Minimises the sum of squares as [`solve`](super::solve) does, except that the first steps may increase it. With a
/// parameter that was not estimated before, the minimum may lie along a curved valley, which the damped steps of a
/// monotone iteration follow slowly, whereas undamped steps cross it.
///
/// The iteration begins with undamped steps, as long as the quadratic model predicts a smaller sum of squares than at
/// the start. If none of them reaches one, the iteration begins again at `start`, with monotone steps.
///
/// # Errors
/// The errors of [`solve`](super::solve).
pub fn solve_with_watchdog(
    problem: &dyn LeastSquaresProblem,
    start: Iterate,
    criteria: StoppingCriteria,
) -> Result<Solution, SolveError> {
    let mut start = Evaluated::new(problem, start, INITIAL_DAMPING)?;
    let (reached, steps) = undamped_steps(problem, &mut start, criteria)?;
    let remaining = StoppingCriteria {
        max_steps: criteria.max_steps.saturating_sub(steps),
        ..criteria
    };
    let solution = descend(problem, reached.unwrap_or(start), remaining, None)?;
    Ok(Solution {
        iterations: solution.iterations + steps,
        ..solution
    })
}

/// The first iterate, reached from `start` by undamped steps, whose sum of squares is smaller than at `start`; `None`
/// if there is none. Also returns the number of steps tried.
fn undamped_steps(
    problem: &dyn LeastSquaresProblem,
    start: &mut Evaluated,
    criteria: StoppingCriteria,
) -> Result<(Option<Evaluated>, usize), SolveError> {
    let squares_at_start = start.squares;
    let mut reached: Option<Evaluated> = None;
    for steps in 0..MAX_UNDAMPED_STEPS {
        if problem.is_past_deadline() {
            return Ok((None, steps));
        }
        let at = reached.as_mut().unwrap_or(start);
        let Some(step) = at.step(problem, INITIAL_DAMPING) else {
            return Ok((None, steps));
        };
        let Step {
            candidate,
            predicted_reduction,
        } = step;
        let is_at_minimum = criteria.is_reached(predicted_reduction, None, at.squares);
        if is_at_minimum || at.squares - predicted_reduction >= squares_at_start {
            return Ok((None, steps));
        }
        let Some(evaluated) = Evaluated::candidate(problem, &candidate, INITIAL_DAMPING)? else {
            return Ok((None, steps + 1));
        };
        if evaluated.squares < squares_at_start {
            return Ok((Some(evaluated), steps + 1));
        }
        reached = Some(evaluated);
    }
    Ok((None, MAX_UNDAMPED_STEPS))
}
