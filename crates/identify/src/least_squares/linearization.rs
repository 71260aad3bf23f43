//! Normal equations of all flights at an iterate, and the damped steps that follow from them.

use flight::parallel;

use super::{
    Iterate, LeastSquaresProblem, NormalBlock, ReducedSystem, SchurComplement, SolveError,
    Unknowns, constrained_step,
};

/// An iterate with its normal equations and its sum of squares.
pub(super) struct Evaluated {
    pub(super) iterate: Iterate,
    pub(super) blocks: Vec<NormalBlock>,
    /// Sum of squares including the priors; infinite if it is not a number.
    pub(super) squares: f64,
    /// Damping, and the Schur complements computed for it in advance; the first step uses them.
    complements: (f64, Option<Vec<Option<SchurComplement>>>),
}

/// A candidate step whose residuals are not evaluated yet.
pub(super) struct Step {
    pub(super) candidate: Iterate,
    /// Decrease of the sum of squares by this step that the quadratic model predicts.
    pub(super) predicted_reduction: f64,
}

impl Evaluated {
    /// Evaluates an iterate. The Schur complements are computed for a next step with `damping`.
    pub(super) fn new(
        problem: &dyn LeastSquaresProblem,
        iterate: Iterate,
        damping: f64,
    ) -> Result<Self, SolveError> {
        let each = parallel::each_on(problem.threads(), problem.flights(), |flight| {
            let block = problem.linearise(
                flight,
                (&iterate.global, &iterate.local[flight]),
                Unknowns::All,
            )?;
            let complement = SchurComplement::new(&block, damping);
            Ok((block, complement))
        });
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
            return Err(SolveError(failures));
        }
        let each = blocks.iter().map(|block| block.squares);
        Ok(Self {
            squares: with_priors(problem, &iterate, each),
            iterate,
            blocks,
            complements: (damping, Some(complements)),
        })
    }

    /// Levenberg–Marquardt step; `None` if the normal equations are singular at this damping.
    pub(super) fn step(&mut self, problem: &dyn LeastSquaresProblem, damping: f64) -> Option<Step> {
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
            &self.iterate.global,
            constraints,
            damping,
        )?;
        let local_steps = system.back_substitute(&global_step);
        let predicted = system.predicted_reduction(&global_step, &local_steps);
        let steps = local_steps.iter().zip(&self.iterate.local).enumerate();
        let local = steps
            .map(|(flight, (step, local))| problem.plus(flight, local, step))
            .collect();
        let global = &self.iterate.global + global_step;
        Some(Step {
            candidate: Iterate { global, local },
            predicted_reduction: predicted + prior_reduction,
        })
    }
}

/// Sum of squares of a candidate, without derivatives; infinite if a flight cannot be predicted there.
pub(super) fn squares_at(problem: &dyn LeastSquaresProblem, iterate: &Iterate) -> f64 {
    let each = parallel::each_on(problem.threads(), problem.flights(), |flight| {
        let unknowns = (&iterate.global, &iterate.local[flight]);
        problem.squares(flight, unknowns).unwrap_or(f64::INFINITY)
    });
    with_priors(problem, iterate, each.into_iter())
}

/// Sum of the squares of all flights and of the priors of the global parameters; infinite if it is not a number.
fn with_priors(
    problem: &dyn LeastSquaresProblem,
    iterate: &Iterate,
    flights: impl Iterator<Item = f64>,
) -> f64 {
    let constraints = problem.constraints().iter().zip(iterate.global.iter());
    let priors = constraints.map(|(constraint, &value)| constraint.squares(value));
    let squares = flights.sum::<f64>() + priors.sum::<f64>();
    if squares.is_nan() {
        f64::INFINITY
    } else {
        squares
    }
}
