//! Levenberg–Marquardt iteration over all flights, with bounds.

use std::sync::{Mutex, PoisonError};

use flight::parallel;
use nalgebra::DVector;

use super::linearization::{Evaluated, Step, squares_at};
use super::{
    Constraint, Iterate, LeastSquaresProblem, NormalBlock, SolveError, StopReason,
    StoppingCriteria, Unknowns,
};
use crate::error::FlightError;

/// Result of a least-squares iteration.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The last accepted iterate.
    pub iterate: Iterate,
    /// Normal equations of each flight at the last accepted iterate whose residuals were evaluated.
    pub blocks: Vec<NormalBlock>,
    /// Sum of squares including the priors; predicted if the residuals after the last step were not evaluated.
    pub squares: f64,
    /// Number of least-squares steps tried.
    pub iterations: usize,
    /// Reason why the iteration stopped.
    pub stop_reason: StopReason,
    /// Predicted reduction of the sum of squares by the last step that damping did not shorten.
    pub predicted_reduction: Option<f64>,
}

impl Solution {
    /// Whether the iteration converged, because the last step was negligible.
    pub fn converged(&self) -> bool {
        self.stop_reason == StopReason::Converged
    }

    /// Whether the last step, whose residuals were not evaluated, changes nothing according to `criteria`.
    pub(crate) fn last_step_is_negligible(&self, criteria: StoppingCriteria) -> bool {
        let negligible = |reduction| criteria.is_negligible(reduction, self.squares);
        self.converged() && self.predicted_reduction.is_some_and(negligible)
    }
}

/// Initial Levenberg–Marquardt damping, relative to the diagonal of JᵀJ.
const INITIAL_DAMPING: f64 = 1e-9;

/// Maximum Levenberg–Marquardt damping, relative to the diagonal of JᵀJ, at which a step is tried.
const MAX_DAMPING: f64 = 1e8;

/// Maximum damping at which a step has practically the length of a Gauss–Newton step.
const NEGLIGIBLE_DAMPING: f64 = 1e-6;

/// Minimum Levenberg–Marquardt damping, relative to the diagonal of JᵀJ; lower values have no further effect.
const MIN_DAMPING: f64 = 1e-12;

/// Number of steps, after a rejected one, whose residuals are computed alone first: along a curved valley every second or
/// third step is rejected, and derivatives, which take most of the time, would be lost.
const WARY: usize = 3;

/// Minimises the sum of squares of `problem` from `start` by the Levenberg–Marquardt method.
///
/// # Errors
/// [`SolveError`] with every flight that cannot be predicted at `start`.
pub fn solve(
    problem: &dyn LeastSquaresProblem,
    start: Iterate,
    criteria: StoppingCriteria,
) -> Result<Solution, SolveError> {
    solve_after(problem, start, criteria, None)
}

/// [`solve`] as the continuation of the iteration of a nearly equal problem, whose last step was to reduce the sum of
/// squares by `previous`.
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
    Ok(descend(problem, start, criteria, previous))
}

/// Minimises from an iterate that is evaluated. `previous` is the predicted reduction of the step that led to it.
fn descend(
    problem: &dyn LeastSquaresProblem,
    start: Evaluated,
    criteria: StoppingCriteria,
    mut previous: Option<f64>,
) -> Solution {
    let mut at = start;
    let mut damping = INITIAL_DAMPING;
    let (mut iterations, mut rejections) = (0, 0);
    // Number of steps accepted one after the other since the last rejected one.
    let mut accepted = WARY;
    let mut refinement = Backoff::default();
    let mut stop_reason = StopReason::MaxSteps;
    while iterations < criteria.max_steps {
        if problem.is_past_deadline() {
            stop_reason = StopReason::Deadline;
            break;
        }
        iterations += 1;
        let Some(Step {
            candidate,
            predicted_reduction,
        }) = at.step(problem, damping)
        else {
            if damping >= MAX_DAMPING {
                stop_reason = StopReason::NoDescent;
                break;
            }
            damping *= 10.0;
            continue;
        };
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
        let is_worse = accepted < WARY && squares_at(problem, &candidate) >= at.squares;
        let evaluated = match is_worse {
            true => None,
            false => Evaluated::new(problem, candidate.clone(), less_damping).ok(),
        };
        if let Some(evaluated) = evaluated.filter(|evaluated| evaluated.squares < at.squares) {
            at = evaluated;
            accepted += 1;
            // Damped steps are no evidence of the rate of convergence.
            previous = (damping <= NEGLIGIBLE_DAMPING).then_some(predicted_reduction);
            // Less damping than at the last rejected step would lead to another rejection.
            if rejections == 0 {
                damping = less_damping;
            }
            rejections = 0;
            continue;
        }
        accepted = 0;
        // Optimal local parameters depend nonlinearly on the global ones, and a linear step leaves this curve.
        if rejections == 0 && !at.iterate.global.is_empty() && refinement.is_due() {
            iterations += 1;
            if let Some(candidate) =
                with_refined_locals(problem, &candidate, &at.iterate, at.squares)
                && let Ok(evaluated) = Evaluated::new(problem, candidate, less_damping)
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
    Solution {
        iterate: at.iterate,
        blocks: at.blocks,
        squares: at.squares,
        iterations,
        stop_reason,
        predicted_reduction: previous,
    }
}

// Refinement of local parameters at given global ones. A step that is too long is often right in the global parameters
// and wrong in the local ones, which depend on them nonlinearly.

/// Schedule of refinements after rejected steps: each failure doubles the number of steps before the next.
#[derive(Clone, Copy, Debug, Default)]
struct Backoff {
    /// Number of further rejected steps until the next attempt to refine the local parameters.
    wait: usize,
    /// Number of steps to wait after the last failure; 0 before the first.
    pause: usize,
}

impl Backoff {
    /// Whether to try a refinement of the local parameters after this rejected step. Call it once per rejected step.
    fn is_due(&mut self) -> bool {
        let is_due = self.wait == 0;
        self.wait = self.wait.saturating_sub(1);
        is_due
    }

    /// Records that a refinement decreased the sum of squares; the next rejected step is followed by another.
    fn succeeded(&mut self) {
        *self = Self::default();
    }

    /// Records that a refinement did not decrease the sum of squares.
    fn failed(&mut self) {
        self.pause = (2 * self.pause).max(1);
        self.wait = self.pause;
    }
}

/// Sum of squares of one flight as a function of its local parameters.
struct OneFlight<'a> {
    problem: &'a dyn LeastSquaresProblem,
    flight: usize,
    global: &'a DVector<f64>,
}

impl LeastSquaresProblem for OneFlight<'_> {
    fn flights(&self) -> usize {
        1
    }

    fn linearise(
        &self,
        _: usize,
        (_, local): (&DVector<f64>, &DVector<f64>),
        _: Unknowns,
    ) -> Result<NormalBlock, FlightError> {
        let unknowns = (self.global, local);
        self.problem
            .linearise(self.flight, unknowns, Unknowns::Local)
    }

    fn plus(&self, _: usize, local: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        self.problem.plus(self.flight, local, step)
    }

    fn squares(
        &self,
        _: usize,
        (_, local): (&DVector<f64>, &DVector<f64>),
    ) -> Result<f64, FlightError> {
        self.problem.squares(self.flight, (self.global, local))
    }

    fn constraints(&self) -> &[Constraint] {
        &[]
    }

    fn is_past_deadline(&self) -> bool {
        self.problem.is_past_deadline()
    }
}

/// Fits the local parameters of each flight at the global ones of `candidate`, from its local ones, or else from those
/// of `before`. `None` if a flight cannot be predicted from either, or the sum of squares exceeds `limit`.
fn with_refined_locals(
    problem: &dyn LeastSquaresProblem,
    candidate: &Iterate,
    before: &Iterate,
    limit: f64,
) -> Option<Iterate> {
    // If some flights exceed the limit, all flights do, so that the result does not depend on the order of the flights.
    let left = Mutex::new(0.0);
    let refined = parallel::each_on(problem.threads(), problem.flights(), |flight| {
        let one = OneFlight {
            problem,
            flight,
            global: &candidate.global,
        };
        let from = |local: &DVector<f64>| {
            let start = Iterate {
                global: DVector::zeros(0),
                local: vec![local.clone()],
            };
            let solution = solve(&one, start, StoppingCriteria::REFINEMENT).ok()?;
            Some((solution.iterate.local.into_iter().next()?, solution.squares))
        };
        if *left.lock().unwrap_or_else(PoisonError::into_inner) > limit {
            return None;
        }
        let refined = from(&candidate.local[flight]).or_else(|| from(&before.local[flight]));
        let (local, squares) = refined?;
        *left.lock().unwrap_or_else(PoisonError::into_inner) += squares;
        Some(local)
    });
    if left.into_inner().unwrap_or_else(PoisonError::into_inner) > limit {
        return None;
    }
    Some(Iterate {
        global: candidate.global.clone(),
        local: refined.into_iter().collect::<Option<_>>()?,
    })
}

// Watchdog technique: first steps of an iteration that may increase the sum of squares.

/// Maximum number of undamped steps after which the sum of squares must be less than at the start.
const MAX_UNDAMPED_STEPS: usize = 4;

/// [`solve`] with first steps that may increase the sum of squares: with a new parameter, the minimum may
/// lie along a curved valley, which undamped steps cross. If none of them reaches a smaller sum of squares, the
/// iteration begins again at `start`, with monotone steps.
///
/// # Errors
/// The errors of [`solve`].
pub fn solve_with_watchdog(
    problem: &dyn LeastSquaresProblem,
    start: Iterate,
    criteria: StoppingCriteria,
) -> Result<Solution, SolveError> {
    let mut start = Evaluated::new(problem, start, INITIAL_DAMPING)?;
    let (reached, steps) = undamped_steps(problem, &mut start, criteria);
    let remaining = StoppingCriteria {
        max_steps: criteria.max_steps.saturating_sub(steps),
        ..criteria
    };
    let solution = descend(problem, reached.unwrap_or(start), remaining, None);
    Ok(Solution {
        iterations: solution.iterations + steps,
        ..solution
    })
}

/// First iterate, by undamped steps, with a smaller sum of squares than `start`, and the number of steps tried.
fn undamped_steps(
    problem: &dyn LeastSquaresProblem,
    start: &mut Evaluated,
    criteria: StoppingCriteria,
) -> (Option<Evaluated>, usize) {
    let squares_at_start = start.squares;
    let mut reached: Option<Evaluated> = None;
    for steps in 0..MAX_UNDAMPED_STEPS {
        if problem.is_past_deadline() {
            return (None, steps);
        }
        let at = reached.as_mut().unwrap_or(start);
        let Some(Step {
            candidate,
            predicted_reduction,
        }) = at.step(problem, INITIAL_DAMPING)
        else {
            return (None, steps);
        };
        let is_at_minimum = criteria.is_reached(predicted_reduction, None, at.squares);
        if is_at_minimum || at.squares - predicted_reduction >= squares_at_start {
            return (None, steps);
        }
        let Ok(evaluated) = Evaluated::new(problem, candidate, INITIAL_DAMPING) else {
            return (None, steps + 1);
        };
        if evaluated.squares < squares_at_start {
            return (Some(evaluated), steps + 1);
        }
        reached = Some(evaluated);
    }
    (None, MAX_UNDAMPED_STEPS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refinement_waits_for_twice_as_many_steps_after_each_failure_in_a_row() {
        let mut refinement = Backoff::default();
        let mut waited = |outcome: fn(&mut Backoff)| {
            let waited = (0..).take_while(|_| !refinement.is_due()).count();
            outcome(&mut refinement);
            waited
        };
        assert_eq!(waited(Backoff::failed), 0);
        assert_eq!(waited(Backoff::failed), 1);
        assert_eq!(waited(Backoff::failed), 2);
        assert_eq!(waited(Backoff::succeeded), 4);
        assert_eq!(waited(Backoff::failed), 0);
        assert_eq!(waited(Backoff::failed), 1);
    }
}
