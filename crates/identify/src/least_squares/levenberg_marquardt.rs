//! Levenberg–Marquardt iteration over all flights, with bounds.

use flight::batch;
use nalgebra::DVector;

use super::local_refinement::{Backoff, OneFlight, with_refined_locals};
use super::{
    Iterate, LeastSquaresProblem, NormalBlock, ReducedSystem, SchurComplement, SolveError,
    StopReason, StoppingCriteria, Unknowns, constrained_step,
};
use crate::error::FlightError;

/// Result of a least-squares iteration.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The last accepted iterate.
    pub iterate: Iterate,
    /// Normal equations of each flight at the last iterate whose residuals were evaluated.
    pub blocks: Vec<NormalBlock>,
    /// Sum of squares including the priors; after an unevaluated last step, its predicted value.
    pub squares: f64,
    /// Number of steps tried.
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

/// Initial damping, relative to the diagonal of JᵀJ.
const INITIAL_DAMPING: f64 = 1e-9;

/// Maximum damping at which a step is tried.
const MAX_DAMPING: f64 = 1e8;

/// Maximum damping at which a step has practically its full length.
const NEGLIGIBLE_DAMPING: f64 = 1e-6;

/// Minimum damping; lower values have no further effect.
const MIN_DAMPING: f64 = 1e-12;

/// Minimises the sum of squares from the iterate `start`.
///
/// # Errors
/// [`SolveError::Start`] with every flight that cannot be predicted at `start`; [`SolveError::Cancelled`] if the
/// iteration is cancelled.
pub fn solve(
    problem: &impl LeastSquaresProblem,
    start: Iterate,
    criteria: StoppingCriteria,
) -> Result<Solution, SolveError> {
    solve_after(problem, start, criteria, None)
}

/// Minimises the sum of squares as [`solve`] does, as a continuation of the iteration of a nearly equal problem.
/// `previous` is the predicted reduction of the last step of that iteration.
///
/// # Errors
/// The errors of [`solve`].
pub fn solve_after(
    problem: &impl LeastSquaresProblem,
    start: Iterate,
    criteria: StoppingCriteria,
    mut previous: Option<f64>,
) -> Result<Solution, SolveError> {
    let mut iterate = start;
    let mut damping = INITIAL_DAMPING;
    let mut linearization = Linearization::new(problem, &iterate, damping)?;
    let mut squares = linearization.squares(problem, &iterate);
    let (mut iterations, mut rejections) = (0, 0);
    let mut refinement = Backoff::default();
    let mut stop_reason = StopReason::MaxSteps;
    while iterations < criteria.max_steps {
        if problem.is_past_deadline() {
            stop_reason = StopReason::Deadline;
            break;
        }
        iterations += 1;
        let Some(step) = linearization.step(problem, &iterate, damping) else {
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
        if criteria.is_reached(predicted_reduction, previous, squares) {
            iterate = candidate;
            squares -= predicted_reduction;
            previous = Some(predicted_reduction);
            stop_reason = StopReason::Converged;
            break;
        }
        if criteria.is_hopeless(iterations, predicted_reduction, squares) {
            stop_reason = StopReason::GivenUp;
            break;
        }
        let less_damping = (damping * 0.1).max(MIN_DAMPING);
        let evaluated = evaluate(problem, &candidate, less_damping)?;
        if let Some((at_candidate, after)) = evaluated
            && after < squares
        {
            (iterate, linearization, squares) = (candidate, at_candidate, after);
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
        if rejections == 0 && !iterate.global.is_empty() && refinement.is_due() {
            iterations += 1;
            if let Some(candidate) =
                with_refined_locals(problem, &candidate, &iterate, squares, refine)?
                && let Some((at_candidate, after)) = evaluate(problem, &candidate, less_damping)?
                && after < squares
            {
                (iterate, linearization, squares) = (candidate, at_candidate, after);
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
        iterate,
        blocks: linearization.blocks,
        squares,
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

/// Normal equations and sum of squares at a candidate iterate; `None` if a flight cannot be predicted there.
fn evaluate(
    problem: &impl LeastSquaresProblem,
    candidate: &Iterate,
    damping: f64,
) -> Result<Option<(Linearization, f64)>, SolveError> {
    match Linearization::new(problem, candidate, damping) {
        Ok(linearization) => {
            let squares = linearization.squares(problem, candidate);
            Ok(Some((linearization, squares)))
        }
        Err(SolveError::Cancelled) => Err(SolveError::Cancelled),
        Err(_) => Ok(None),
    }
}

/// Normal equations of all flights at an iterate.
struct Linearization {
    blocks: Vec<NormalBlock>,
    /// A damping, and the Schur complements of all flights that were computed for it in advance. The first step with
    /// this damping uses the complements and replaces them by `None`.
    complements: (f64, Option<Vec<Option<SchurComplement>>>),
}

/// A candidate step whose residuals are not evaluated yet.
struct Step {
    candidate: Iterate,
    /// Decrease of the sum of squares that the quadratic model predicts.
    predicted_reduction: f64,
}

impl Linearization {
    fn new(
        problem: &impl LeastSquaresProblem,
        iterate: &Iterate,
        damping: f64,
    ) -> Result<Self, SolveError> {
        let each = batch::each_on(problem.threads(), problem.flights(), |flight| {
            if problem.is_cancelled() {
                return Err(FlightError::Interrupted);
            }
            let block = problem.linearise(
                flight,
                (&iterate.global, &iterate.local[flight]),
                Unknowns::All,
            )?;
            let complement = SchurComplement::new(&block, damping);
            Ok((block, complement))
        });
        if problem.is_cancelled() {
            return Err(SolveError::Cancelled);
        }
        let (mut blocks, mut complements) = (Vec::new(), Vec::new());
        let mut failures = Vec::new();
        for (flight, found) in each.into_iter().enumerate() {
            match found {
                Ok((block, complement)) => {
                    blocks.push(block);
                    complements.push(complement);
                }
                Err(reason) => failures.push((flight, reason)),
            }
        }
        if !failures.is_empty() {
            return Err(SolveError::Start(failures));
        }
        Ok(Self {
            blocks,
            complements: (damping, Some(complements)),
        })
    }

    /// Sum of squares including the priors; NaN is replaced by infinity.
    fn squares(&self, problem: &impl LeastSquaresProblem, iterate: &Iterate) -> f64 {
        let constraints = problem.constraints().iter().zip(iterate.global.iter());
        let priors: f64 = constraints
            .map(|(constraint, &value)| constraint.squares(value))
            .sum();
        let sum = self.blocks.iter().map(|block| block.squares).sum::<f64>() + priors;
        if sum.is_nan() { f64::INFINITY } else { sum }
    }

    /// Computes a damped step; `None` if the normal equations are singular at this damping.
    fn step(
        &mut self,
        problem: &impl LeastSquaresProblem,
        iterate: &Iterate,
        damping: f64,
    ) -> Option<Step> {
        let computed = self
            .complements
            .1
            .take_if(|_| self.complements.0 == damping);
        let complements = computed.unwrap_or_else(|| {
            let blocks = self.blocks.iter();
            blocks
                .map(|block| SchurComplement::new(block, damping))
                .collect()
        });
        let system = ReducedSystem::new(&self.blocks, complements).ok()?;
        let constraints = problem.constraints();
        let (global_step, prior_reduction) = constrained_step(
            &system.reduced,
            &system.gradient,
            &iterate.global,
            constraints,
            damping,
        )?;
        let local_steps = system.back_substitute(&global_step);
        let predicted = system.predicted_reduction(&global_step, &local_steps);
        let steps = local_steps.iter().zip(&iterate.local).enumerate();
        let local = steps
            .map(|(flight, (step, local))| problem.plus(flight, local, step))
            .collect();
        let global = &iterate.global + global_step;
        Some(Step {
            candidate: Iterate { global, local },
            predicted_reduction: predicted + prior_reduction,
        })
    }
}
