//! Elimination of each flight's local parameters from its normal equations.

use identify::{LocalId, NormalBlock, add_priors, eliminate};
use model_spec::index::IndexVec;
use nalgebra::{DMatrix, DVector};

use crate::context::{CandidateId, ScoreTestModel, select, select_vector};
use crate::error::DiagnosisError;

/// Normal equations of the global parameters, with the local parameters (initial states) eliminated.
#[derive(Clone, Debug)]
pub(crate) struct GlobalEquations {
    /// Gauss–Newton Hessian of half the weighted sum of squares with respect to the global parameters.
    pub matrix: DMatrix<f64>,
    /// Gradient of half the weighted sum of squares with respect to the global parameters.
    pub gradient: DVector<f64>,
}

/// Normal equations after also eliminating the states of one tested candidate.
#[derive(Clone, Debug)]
pub(super) struct PerFlightCandidate {
    pub equations: GlobalEquations,
    pub decrease: f64,
    /// Number of the states of the candidate effect, over all flights, that the samples determine.
    pub degrees_of_freedom: usize,
}

/// Normal equations of the global unknowns, summed over the flights, local parameters eliminated.
#[derive(Clone, Debug)]
pub(super) struct LocalElimination {
    /// Normal equations under the null hypothesis: the states of all tested candidates are fixed at their null values.
    pub null: GlobalEquations,
    /// For each tested candidate with states: normal equations in which these are estimated.
    pub candidates: IndexVec<CandidateId, Option<PerFlightCandidate>>,
}

impl GlobalEquations {
    fn zero(size: usize) -> Self {
        Self {
            matrix: DMatrix::zeros(size, size),
            gradient: DVector::zeros(size),
        }
    }

    /// Adds the priors of the global parameters, linearized at `values`.
    pub fn with_priors(&self, model: &ScoreTestModel<'_>, values: &DVector<f64>) -> Self {
        let mut sum = self.clone();
        let constraints = model.problem.globals.iter().map(|own| &own.constraint);
        add_priors((&mut sum.matrix, &mut sum.gradient), values, constraints);
        sum
    }
}

impl LocalElimination {
    /// Eliminates the local parameters of every flight, including the states of the candidates in `conditioned_on`.
    pub fn new(
        model: &ScoreTestModel<'_>,
        blocks: &[NormalBlock],
        conditioned_on: &[CandidateId],
    ) -> Result<Self, DiagnosisError> {
        let size = blocks.first().map_or(0, |block| block.global.nrows());
        let candidates = model.candidates().map(|(id, candidate)| {
            let is_tested = candidate.is_per_flight() && !conditioned_on.contains(&id);
            is_tested.then(|| PerFlightCandidate {
                equations: GlobalEquations::zero(size),
                decrease: 0.0,
                degrees_of_freedom: 0,
            })
        });
        let mut total = Self {
            null: GlobalEquations::zero(size),
            candidates: candidates.collect(),
        };
        for (flight, block) in blocks.iter().enumerate() {
            total.add(model, flight, block, conditioned_on)?;
        }
        Ok(total)
    }

    fn add(
        &mut self,
        model: &ScoreTestModel<'_>,
        flight: usize,
        block: &NormalBlock,
        conditioned_on: &[CandidateId],
    ) -> Result<(), DiagnosisError> {
        let (null, local) = model.local_partition(flight, conditioned_on);
        // States at their null value are put before the global columns while the others are eliminated.
        let promoted = promote_directions(block, &local, &null);
        let reduced = eliminate_locals(model, flight, &promoted)?;
        let (first, size) = (null.len(), self.null.gradient.len());
        self.null.matrix += reduced.matrix.view((first, first), (size, size));
        self.null.gradient += reduced.gradient.rows(first, size);
        let manifold = &model.flights[flight].manifold;
        for (total, (_, candidate)) in self.candidates.iter_mut().zip(model.candidates()) {
            let Some(total) = total else { continue };
            let is_its_state = |direction: LocalId| {
                let state = manifold.direct_state(direction);
                let mut states = candidate.states.iter();
                state.is_some_and(|state| states.any(|own| own.id == state))
            };
            let rows = (0..first).filter(|&row| is_its_state(null[row]));
            let rows: Vec<LocalId> = rows.map(LocalId::new).collect();
            total.add(&reduced, &rows, first);
        }
        Ok(())
    }
}

impl PerFlightCandidate {
    /// Adds one flight. `states` are the candidate's rows in `reduced`, whose first global column is `first`.
    fn add(&mut self, reduced: &GlobalEquations, states: &[LocalId], first: usize) {
        let size = self.equations.gradient.len();
        let globals: Vec<LocalId> = (first..first + size).map(LocalId::new).collect();
        let blocks = [NormalBlock {
            local: select(&reduced.matrix, states, states),
            cross: select(&reduced.matrix, states, &globals),
            global: select(&reduced.matrix, &globals, &globals),
            local_gradient: select_vector(&reduced.gradient, states),
            global_gradient: select_vector(&reduced.gradient, &globals),
            squares: 0.0,
            count: 0,
        }];
        match eliminate(&blocks, 0.0) {
            Ok(next) => {
                let step = &next.back_substitute(&DVector::zeros(size))[0];
                self.decrease -= blocks[0].local_gradient.dot(step);
                self.equations.matrix += &next.reduced;
                self.equations.gradient += &next.gradient;
                self.degrees_of_freedom += states.len();
            }
            // The flight does not determine these states: they stay at their null value.
            Err(_) => {
                self.equations.matrix += &blocks[0].global;
                self.equations.gradient += &blocks[0].global_gradient;
            }
        }
    }
}

/// Schur complement of one flight's normal equations, with all local parameters eliminated.
pub(crate) fn eliminate_locals(
    model: &ScoreTestModel<'_>,
    flight: usize,
    block: &NormalBlock,
) -> Result<GlobalEquations, DiagnosisError> {
    let blocks = std::slice::from_ref(block);
    let system = eliminate(blocks, 0.0).map_err(|_| {
        let file = model.flights[flight].file.clone();
        DiagnosisError::UndeterminedInitialState { file }
    })?;
    Ok(GlobalEquations {
        matrix: system.reduced,
        gradient: system.gradient,
    })
}

/// Restricts normal equations to the directions in `local`; the others remain fixed.
pub(crate) fn keep_directions(block: &NormalBlock, local: &[LocalId]) -> NormalBlock {
    promote_directions(block, local, &[])
}

/// Restricts normal equations to `local` and `promoted`, which become the first global columns.
fn promote_directions(block: &NormalBlock, local: &[LocalId], promoted: &[LocalId]) -> NormalBlock {
    let (locals, globals) = (block.local.nrows(), block.global.nrows());
    let indices = |ids: &[LocalId]| ids.iter().map(|id| id.index()).collect::<Vec<_>>();
    let (local, mut global) = (indices(local), indices(promoted));
    global.extend(locals..locals + globals);
    block.select(&local, &global)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn promoted_directions_come_first_and_keep_the_quadratic_form() {
        let symmetric = |i: usize, j: usize| ((i.min(j) * 5 + i.max(j)) as f64).cos();
        let block = NormalBlock {
            local: DMatrix::from_fn(3, 3, symmetric),
            cross: DMatrix::from_fn(3, 2, |i, j| symmetric(i, 3 + j)),
            global: DMatrix::from_fn(2, 2, |i, j| symmetric(3 + i, 3 + j)),
            local_gradient: DVector::from_fn(3, |i, _| i as f64),
            global_gradient: DVector::from_fn(2, |i, _| 3.0 + i as f64),
            squares: 7.0,
            count: 9,
        };
        let [local, promoted] =
            [vec![2, 0], vec![1]].map(|ids| ids.into_iter().map(LocalId::new).collect::<Vec<_>>());
        let moved = promote_directions(&block, &local, &promoted);
        let order = [1, 3, 4];
        for (i, &a) in order.iter().enumerate() {
            assert_eq!(moved.global_gradient[i], a as f64);
            for (j, &b) in order.iter().enumerate() {
                assert_eq!(moved.global[(i, j)], symmetric(a, b));
            }
            for (row, &a_local) in [2, 0].iter().enumerate() {
                assert_eq!(moved.cross[(row, i)], symmetric(a_local, a));
            }
        }
        assert_eq!(moved.local[(0, 1)], symmetric(2, 0));
        assert_eq!(moved.local_gradient.as_slice(), [2.0, 0.0]);
        assert_eq!((moved.squares, moved.count), (7.0, 9));
    }
}
