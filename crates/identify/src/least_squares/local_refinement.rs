//! Local parameters at given global ones: a step of both that goes too far is often right in the global parameters, and wrong
//! only in the local ones, which depend on them along a curve.

use flight::batch;
use nalgebra::DVector;

use super::{Constraint, Iterate, LeastSquaresProblem, NormalBlock, SolveError, Unknowns};
use crate::error::FlightError;

/// Sum of squares of one flight, as a function of its local parameters.
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

/// The candidate with the local parameters of each flight fitted anew, starting from its own, or from those `before` where they
/// cannot be predicted; `None` if a flight cannot be predicted from either. `solve` minimises the sum of squares of one flight.
///
/// # Errors
/// [`SolveError::Cancelled`].
pub fn with_refined_locals(
    problem: &dyn LeastSquaresProblem,
    candidate: &Iterate,
    before: &Iterate,
    solve: impl Fn(&OneFlight<'_>, Iterate) -> Option<Iterate> + Sync,
) -> Result<Option<Iterate>, SolveError> {
    let refined = batch::each_on(problem.threads(), problem.flights(), |flight| {
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
            solve(&one, start)?.local.into_iter().next()
        };
        from(&candidate.local[flight]).or_else(|| from(&before.local[flight]))
    });
    if problem.is_cancelled() {
        return Err(SolveError::Cancelled);
    }
    let local: Option<Vec<DVector<f64>>> = refined.into_iter().collect();
    Ok(local.map(|local| Iterate {
        global: candidate.global.clone(),
        local,
    }))
}
