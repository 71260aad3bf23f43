//! Levenberg–Marquardt iteration over all flights, with bounds.

use nalgebra::DVector;

use super::linearization::{Evaluated, Step};
use super::local_refinement::{Backoff, OneFlight, with_refined_locals};
use super::{Iterate, LeastSquaresProblem, NormalBlock, SolveError, StopReason, StoppingCriteria};

/// Result of a least-squares iteration.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The last accepted iterate.
    pub iterate: Iterate,
    /// Normal equations of each flight at the last accepted iterate whose residuals were evaluated.
    pub blocks: Vec<NormalBlock>,
    /// Sum of squares including the priors. If the residuals after the last step were not evaluated, it is the
    /// predicted value.
    pub squares: f64,
    /// Number of least-squares steps tried.
    pub iterations: usize,
    /// Reason why the iteration stopped.
    pub stop_reason: StopReason,
    /// Predicted reduction of the sum of squares by the last step that damping did not shorten; `None` if there is no
    /// such step.
    pub predicted_reduction: Option<f64>,
}

impl Solution {
    /// Whether the iteration converged, because the last step was negligible.
    pub fn converged(&self) -> bool {
        self.stop_reason == StopReason::Converged
    }

    /// Whether the predicted reduction of the sum of squares by the last step is negligible according to `criteria`, so
    /// that another iteration would change nothing. The residuals after that step were not evaluated.
    pub(crate) fn last_step_is_negligible(&self, criteria: StoppingCriteria) -> bool {
        let negligible = |reduction| criteria.is_negligible(reduction, self.squares);
        self.converged() && self.predicted_reduction.is_some_and(negligible)
    }
}

/// Initial Levenberg–Marquardt damping, relative to the diagonal of JᵀJ.
pub(super) const INITIAL_DAMPING: f64 = 1e-9;

/// Maximum Levenberg–Marquardt damping, relative to the diagonal of JᵀJ, at which a step is tried.
const MAX_DAMPING: f64 = 1e8;

/// Maximum Levenberg–Marquardt damping, relative to the diagonal of JᵀJ, at which a step has practically the length of
/// a Gauss–Newton step.
const NEGLIGIBLE_DAMPING: f64 = 1e-6;

/// Minimum Levenberg–Marquardt damping, relative to the diagonal of JᵀJ; lower values have no further effect.
const MIN_DAMPING: f64 = 1e-12;

/// Minimises the sum of squares of `problem` from the iterate `start` by the Levenberg–Marquardt method.
///
/// # Errors
/// [`SolveError::Start`] with every flight that cannot be predicted at `start`; [`SolveError::Cancelled`] if the
/// iteration is cancelled.
pub fn solve(
    problem: &dyn LeastSquaresProblem,
    start: Iterate,
    criteria: StoppingCriteria,
) -> Result<Solution, SolveError> {
    solve_after(problem, start, criteria, None)
}

/// Minimises the sum of squares of `problem` from the iterate `start`, as a continuation of the iteration of a nearly
/// equal problem. `previous` is the reduction of the sum of squares that was predicted for the last step of that
/// iteration.
///
/// # Errors
/// The errors of [`solve`].
pub fn solve_after(
    problem: &dyn LeastSquaresProblem,
    start: Iterate,
    criteria: StoppingCriteria,
    previous: Option<f64>,
) -> Result<Solution, SolveError> {
    let start = Evaluated::new(problem, start, INITIAL_DAMPING)?;
    descend(problem, start, criteria, previous)
}

/// Minimises the sum of squares of `problem` from an iterate that is already evaluated. `previous` is the reduction of
/// the sum of squares that was predicted for the step that led to this iterate; `None` if there was no such step, or if
/// damping shortened it.
///
/// # Errors
/// [`SolveError::Cancelled`] if the iteration is cancelled.
pub(super) fn descend(
    problem: &dyn LeastSquaresProblem,
    start: Evaluated,
    criteria: StoppingCriteria,
    mut previous: Option<f64>,
) -> Result<Solution, SolveError> {
    let mut at = start;
    let mut damping = INITIAL_DAMPING;
    let (mut iterations, mut rejections) = (0, 0);
    let mut refinement = Backoff::default();
    let mut stop_reason = StopReason::MaxSteps;
    while iterations < criteria.max_steps {
        if problem.is_past_deadline() {
            stop_reason = StopReason::Deadline;
            break;
        }
        iterations += 1;
        let Some(step) = at.step(problem, damping) else {
            if damping >= MAX_DAMPING {
                stop_reason = StopReason::NoDescent;
                break;
            }
            damping *= 10.0;
            continue;
        };
        let Step {
            candidate,
            predicted_reduction,
        } = step;
        if criteria.is_reached(predicted_reduction, previous, at.squares) {
            at.iterate = candidate;
            at.squares -= predicted_reduction;
            previous = Some(predicted_reduction);
            stop_reason = StopReason::Converged;
            break;
        }
        if criteria.is_hopeless(iterations, predicted_reduction, at.squares) {
            stop_reason = StopReason::GivenUp;
            break;
        }
        let less_damping = (damping * 0.1).max(MIN_DAMPING);
        let evaluated = Evaluated::candidate(problem, &candidate, less_damping)?;
        if let Some(evaluated) = evaluated.filter(|evaluated| evaluated.squares < at.squares) {
            at = evaluated;
            // Damped steps are no evidence of the rate of convergence.
            previous = (damping <= NEGLIGIBLE_DAMPING).then_some(predicted_reduction);
            // Less damping than at the last rejected step would lead to another rejection.
            if rejections == 0 {
                damping = less_damping;
            }
            rejections = 0;
            continue;
        }
        // Optimal local parameters depend nonlinearly on the global ones, and a linear step leaves this curve.
        if rejections == 0 && !at.iterate.global.is_empty() && refinement.is_due() {
            iterations += 1;
            if let Some(candidate) =
                with_refined_locals(problem, &candidate, &at.iterate, at.squares, refine)?
                && let Some(evaluated) = Evaluated::candidate(problem, &candidate, less_damping)?
                && evaluated.squares < at.squares
            {
                at = evaluated;
                (previous, damping) = (None, less_damping);
                refinement.succeeded();
                continue;
            }
            refinement.failed();
        }
        if damping >= MAX_DAMPING {
            stop_reason = StopReason::NoDescent;
            break;
        }
        rejections += 1;
        // Low damping hardly shortens a step.
        let growth = if damping < 1e-2 && rejections > 1 {
            100.0
        } else {
            10.0
        };
        damping = (damping * growth).max(NEGLIGIBLE_DAMPING);
    }
    Ok(Solution {
        iterate: at.iterate,
        blocks: at.linearization.blocks,
        squares: at.squares,
        iterations,
        stop_reason,
        predicted_reduction: previous,
    })
}

fn refine(flight: &OneFlight<'_>, start: Iterate) -> Option<(DVector<f64>, f64)> {
    let solution = solve(flight, start, StoppingCriteria::REFINEMENT).ok()?;
    let local = solution.iterate.local.into_iter().next()?;
    Some((local, solution.squares))
}
