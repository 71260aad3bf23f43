//! Levenberg–Marquardt over all flights at once, within bounds.

use flight::batch;
use nalgebra::DVector;

use super::{NormalBlock, ReducedSystem, SchurComplement, UndeterminedFlight, constrained_step};

/// A sum of squares with unknowns shared by all flights and unknowns of each flight.
pub trait LeastSquaresProblem: Sync {
    /// How many flights there are.
    fn flights(&self) -> usize;

    /// Residuals of a flight and their derivatives, as normal equations.
    ///
    /// # Errors
    /// In words, where the flight cannot be predicted from these values.
    fn linearise(
        &self,
        flight: usize,
        global: &DVector<f64>,
        local: &DVector<f64>,
    ) -> Result<NormalBlock, String>;

    /// A flight's own unknowns after a step.
    fn plus(&self, flight: usize, local: &DVector<f64>, step: &DVector<f64>) -> DVector<f64>;

    /// What is known of each shared unknown beforehand.
    fn constraints(&self) -> &[Constraint];

    /// How many flights may be worked on at once.
    fn threads(&self) -> usize {
        1
    }

    /// Whether the work is to be given up.
    fn is_stopped(&self) -> bool {
        false
    }
}

/// What is known of a shared unknown beforehand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constraint {
    /// Least and greatest value.
    pub bounds: (f64, f64),
    /// Value and standard deviation of a normal prior.
    pub prior: Option<(f64, f64)>,
}

impl Constraint {
    /// Nothing.
    pub const NONE: Constraint = Constraint {
        bounds: (f64::NEG_INFINITY, f64::INFINITY),
        prior: None,
    };

    /// What the prior adds to the sum of squares.
    pub(super) fn squares(&self, value: f64) -> f64 {
        self.prior
            .map_or(0.0, |(centre, sigma)| ((value - centre) / sigma).powi(2))
    }
}

/// Values of all unknowns.
#[derive(Clone, Debug, PartialEq)]
pub struct Iterate {
    /// Shared by all flights.
    pub global: DVector<f64>,
    /// Each flight's own.
    pub local: Vec<DVector<f64>>,
}

/// Where the iteration ended.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The unknowns.
    pub iterate: Iterate,
    /// Normal equations there, but for a negligible last step.
    pub blocks: Vec<NormalBlock>,
    /// The sum of squares with that of the priors; of a last step that nobody saw, as it promised.
    pub squares: f64,
    /// Steps that were tried.
    pub iterations: usize,
    /// Whether the steps had become negligible.
    pub converged: bool,
    /// By how much the last step that was not held back was to decrease the sum of squares.
    pub predicted_reduction: Option<f64>,
}

impl Solution {
    /// Whether the last step, which nobody saw, was negligible in itself.
    pub fn is_there(&self, criteria: StoppingCriteria) -> bool {
        let negligible =
            |predicted_reduction| criteria.is_negligible(predicted_reduction, self.squares);
        self.converged && self.predicted_reduction.is_some_and(negligible)
    }
}

/// Why there is no solution.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SolveError {
    /// A flight cannot be predicted from its starting values.
    #[error("flight {flight} cannot be predicted from its starting values: {reason}")]
    InitialGuess {
        /// Index of the flight.
        flight: usize,
        /// In words.
        reason: String,
    },
    /// A flight's own unknowns are not determined.
    #[error(transparent)]
    UndeterminedFlight(#[from] UndeterminedFlight),
    /// It was told to stop.
    #[error("interrupted")]
    Stopped,
}

/// When the iteration ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoppingCriteria {
    /// A step that promises no more of the sum of squares is negligible.
    pub ftol_abs: f64,
    /// A step that promises no more than this part of it is negligible.
    pub ftol_rel: f64,
    /// A step that promises up to so many times more is taken unseen where the next would be negligible.
    pub accept_unevaluated: f64,
    /// Steps after which the iteration is given up.
    pub max_steps: usize,
}

impl StoppingCriteria {
    /// Whitened residuals: the step that is then taken unseen is a standard error at most, and what it leaves a thirtieth.
    pub const CONVERGED: StoppingCriteria = StoppingCriteria {
        ftol_abs: 1e-3,
        ftol_rel: 1e-11,
        accept_unevaluated: 1e3,
        max_steps: 100,
    };
    /// On the way, where the weights will change anyway.
    pub const COARSE: StoppingCriteria = StoppingCriteria {
        ftol_abs: 1e-2,
        ftol_rel: 1e-3,
        accept_unevaluated: 1e3,
        max_steps: 30,
    };
    /// On the way to longer flights, which will tell more than is left here.
    pub const HORIZON: StoppingCriteria = StoppingCriteria {
        ftol_rel: 1e-2,
        accept_unevaluated: f64::INFINITY,
        ..StoppingCriteria::COARSE
    };
    /// After one step, unseen.
    pub const SINGLE_STEP: StoppingCriteria = StoppingCriteria {
        ftol_abs: f64::INFINITY,
        max_steps: 1,
        ..StoppingCriteria::COARSE
    };

    /// Whether a step promises so little of what is left that it is negligible.
    fn is_negligible(&self, predicted_reduction: f64, squares: f64) -> bool {
        predicted_reduction <= self.ftol_abs.max(self.ftol_rel * squares)
    }

    /// Whether a step need not be seen: it is negligible, or the next will be, as the promises shrink from the one `before`.
    fn is_reached(&self, predicted_reduction: f64, before: Option<f64>, squares: f64) -> bool {
        let next = before.map_or(f64::INFINITY, |before| {
            predicted_reduction * (predicted_reduction / before)
        });
        self.is_negligible(predicted_reduction, squares)
            || self.is_negligible(predicted_reduction / self.accept_unevaluated, squares)
                && self.is_negligible(next, squares)
    }
}

/// Damping at which no step is tried any more.
const MOST_DAMPING: f64 = 1e8;

/// Damping up to which a step is as long as it would be without.
const FREE_DAMPING: f64 = 1e-6;

/// Damping below which it makes no difference.
const LEAST_DAMPING: f64 = 1e-12;

/// Minimises the sum of squares from a starting point.
///
/// # Errors
/// See [`SolveError`].
pub fn solve(
    problem: &impl LeastSquaresProblem,
    start: Iterate,
    criteria: StoppingCriteria,
) -> Result<Solution, SolveError> {
    solve_after(problem, start, criteria, None)
}

/// The same from where another iteration ended, by what its last step had promised of nearly the same sum of squares.
///
/// # Errors
/// See [`SolveError`].
pub fn solve_after(
    problem: &impl LeastSquaresProblem,
    start: Iterate,
    criteria: StoppingCriteria,
    mut last_promised: Option<f64>,
) -> Result<Solution, SolveError> {
    let mut point = start;
    let mut damping = 1e-9;
    let mut linearization = linearise_all(problem, &point, damping)?;
    let mut before = squares(problem, &point, &linearization.blocks);
    let mut iterations = 0;
    let mut converged = false;
    while iterations < criteria.max_steps {
        iterations += 1;
        let Some((candidate, predicted_reduction)) =
            stepped(problem, &point, &mut linearization, damping)
        else {
            if damping >= MOST_DAMPING {
                break;
            }
            damping *= 10.0;
            continue;
        };
        // A negligible step is taken, and is not worth the look that it would cost.
        if criteria.is_reached(predicted_reduction, last_promised, before) {
            point = candidate;
            before -= predicted_reduction;
            last_promised = Some(predicted_reduction);
            converged = true;
            break;
        }
        let less = (damping * 0.1).max(LEAST_DAMPING);
        let there = match linearise_all(problem, &candidate, less) {
            Ok(there) => Some(there),
            Err(SolveError::Stopped) => return Err(SolveError::Stopped),
            Err(_) => None,
        };
        let after = there.as_ref().map_or(f64::INFINITY, |there| {
            squares(problem, &candidate, &there.blocks)
        });
        match there {
            Some(there) if after < before => {
                (point, linearization, before) = (candidate, there, after);
                // Where steps are held back, how they shrink says nothing of what is left.
                last_promised = Some(predicted_reduction).filter(|_| damping <= FREE_DAMPING);
                damping = less;
            }
            _ if damping < MOST_DAMPING => damping = (damping * 10.0).max(1e-6),
            _ => break,
        }
    }
    Ok(Solution {
        iterate: point,
        blocks: linearization.blocks,
        squares: before,
        iterations,
        converged,
        predicted_reduction: last_promised,
    })
}

/// The flights at a point.
struct Linearization {
    blocks: Vec<NormalBlock>,
    /// What is left of each once its own unknowns are eliminated, by this damping; taken by the first who steps.
    complements: (f64, Option<Vec<Option<SchurComplement>>>),
}

fn linearise_all(
    problem: &impl LeastSquaresProblem,
    point: &Iterate,
    damping: f64,
) -> Result<Linearization, SolveError> {
    let each = batch::each_on(problem.threads(), problem.flights(), |flight| {
        if problem.is_stopped() {
            return Err(SolveError::Stopped);
        }
        let block = problem.linearise(flight, &point.global, &point.local[flight]);
        let block = block.map_err(|reason| SolveError::InitialGuess { flight, reason })?;
        let complement = SchurComplement::new(&block, damping);
        Ok((block, complement))
    });
    let (blocks, complements) = each.into_iter().collect::<Result<_, _>>()?;
    Ok(Linearization {
        blocks,
        complements: (damping, Some(complements)),
    })
}

fn squares(problem: &impl LeastSquaresProblem, point: &Iterate, blocks: &[NormalBlock]) -> f64 {
    let constraints = problem.constraints().iter().zip(point.global.iter());
    let priors: f64 = constraints
        .map(|(constraint, &value)| constraint.squares(value))
        .sum();
    let sum = blocks.iter().map(|block| block.squares).sum::<f64>() + priors;
    if sum.is_nan() { f64::INFINITY } else { sum }
}

/// The point after a step, and the decrease of the squares that the step promises; none where the damping is too
/// small for there to be a step.
fn stepped(
    problem: &impl LeastSquaresProblem,
    point: &Iterate,
    linearization: &mut Linearization,
    damping: f64,
) -> Option<(Iterate, f64)> {
    let made = linearization
        .complements
        .1
        .take_if(|_| linearization.complements.0 == damping);
    let anew = || {
        let each = linearization.blocks.iter();
        each.map(|block| SchurComplement::new(block, damping))
            .collect()
    };
    let system = ReducedSystem::new(&linearization.blocks, made.unwrap_or_else(anew)).ok()?;
    let (step, prior_gain) = constrained_step(
        &system.reduced,
        &system.gradient,
        &point.global,
        problem.constraints(),
        damping,
    )?;
    let back_substitute = system.back_substitute(&step);
    let predicted_reduction = system.predicted_reduction(&step, &back_substitute) + prior_gain;
    let steps = back_substitute.iter().zip(&point.local).enumerate();
    let local = steps
        .map(|(flight, (step, local))| problem.plus(flight, local, step))
        .collect();
    let global = &point.global + step;
    Some((Iterate { global, local }, predicted_reduction))
}
