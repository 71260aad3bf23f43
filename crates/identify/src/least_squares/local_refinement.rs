//! Refinement of local parameters at given global parameters. If a step of all unknowns is too long, it is often right
//! in the global parameters and wrong only in the local ones, which depend on the global ones nonlinearly.

use std::sync::{Mutex, PoisonError};

use flight::parallel;
use nalgebra::DVector;

use super::{Constraint, Iterate, LeastSquaresProblem, NormalBlock, SolveError, Unknowns};
use crate::error::FlightError;

/// Schedule of attempts to refine the local parameters after rejected steps: with each successive failure, the number
/// of rejected steps before the next attempt doubles.
#[derive(Clone, Copy, Debug, Default)]
pub struct Backoff {
    /// Number of further rejected steps until the next attempt to refine the local parameters.
    wait: usize,
    /// Number of rejected steps to wait after the last failed attempt to refine the local parameters; 0 before the
    /// first failure.
    pause: usize,
}

impl Backoff {
    /// Whether to try a refinement of the local parameters after this rejected step. Call it once per rejected step.
    pub fn is_due(&mut self) -> bool {
        let is_due = self.wait == 0;
        self.wait = self.wait.saturating_sub(1);
        is_due
    }

    /// Records that a refinement of the local parameters decreased the sum of squares. The next rejected step is then
    /// followed by another attempt.
    pub fn succeeded(&mut self) {
        *self = Self::default();
    }

    /// Records that a refinement of the local parameters did not decrease the sum of squares. Doubles the number of
    /// rejected steps before the next attempt; after the first failure, this number is 1.
    pub fn failed(&mut self) {
        self.pause = (2 * self.pause).max(1);
        self.wait = self.pause;
    }
}

/// Sum of squared residuals of one flight, as a function of its local parameters (initial state) at fixed global
/// parameters.
pub struct OneFlight<'a> {
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

    fn constraints(&self) -> &[Constraint] {
        &[]
    }

    fn is_cancelled(&self) -> bool {
        self.problem.is_cancelled()
    }

    fn is_past_deadline(&self) -> bool {
        self.problem.is_past_deadline()
    }
}

/// Fits the local parameters of each flight at the global parameters of `candidate`, starting from the local parameters
/// of `candidate`, or from those of `before` if the flight cannot be predicted from the former. `None` if a flight
/// cannot be predicted from either, or if the sum of squares of all flights exceeds `limit`. `solve` minimises the sum
/// of squares of one flight and returns its local parameters and the minimum.
///
/// # Errors
/// [`SolveError::Cancelled`] if the work is cancelled.
pub fn with_refined_locals(
    problem: &dyn LeastSquaresProblem,
    candidate: &Iterate,
    before: &Iterate,
    limit: f64,
    solve: impl Fn(&OneFlight<'_>, Iterate) -> Option<(DVector<f64>, f64)> + Sync,
) -> Result<Option<Iterate>, SolveError> {
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
            solve(&one, start)
        };
        if *left.lock().unwrap_or_else(PoisonError::into_inner) > limit {
            return None;
        }
        let refined = from(&candidate.local[flight]).or_else(|| from(&before.local[flight]));
        let (local, squares) = refined?;
        *left.lock().unwrap_or_else(PoisonError::into_inner) += squares;
        Some(local)
    });
    if problem.is_cancelled() {
        return Err(SolveError::Cancelled);
    }
    if left.into_inner().unwrap_or_else(PoisonError::into_inner) > limit {
        return Ok(None);
    }
    let local: Option<Vec<DVector<f64>>> = refined.into_iter().collect();
    Ok(local.map(|local| Iterate {
        global: candidate.global.clone(),
        local,
    }))
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
