//! Normal equations of many flights. The local parameters of a flight occur only in its own residuals; their
//! elimination, flight by flight, leaves a system of the size of the global parameters.

use nalgebra::{DMatrix, DVector};

use super::scaled_cholesky::ScaledCholesky;

/// Normal equations of one flight: JᵀJ and Jᵀr of its residuals r, in blocks of local parameters and global parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct NormalBlock {
    /// Block of JᵀJ: local × local parameters.
    pub local: DMatrix<f64>,
    /// Block of JᵀJ: local × global parameters.
    pub cross: DMatrix<f64>,
    /// Block of JᵀJ: global × global parameters.
    pub global: DMatrix<f64>,
    /// Block of the gradient Jᵀr: local parameters.
    pub local_gradient: DVector<f64>,
    /// Block of the gradient Jᵀr: global parameters.
    pub global_gradient: DVector<f64>,
    /// Sum of the squared residuals of the flight.
    pub squares: f64,
    /// Number of residuals of the flight; a vector counts as one residual per component.
    pub count: usize,
}

impl NormalBlock {
    /// Creates zero normal equations for the given numbers of local and global parameters.
    pub fn zero(local: usize, global: usize) -> Self {
        Self {
            local: DMatrix::zeros(local, local),
            cross: DMatrix::zeros(local, global),
            global: DMatrix::zeros(global, global),
            local_gradient: DVector::zeros(local),
            global_gradient: DVector::zeros(global),
            squares: 0.0,
            count: 0,
        }
    }

    /// Adds one residual, given with its derivatives with respect to the local and the global parameters.
    pub fn add(&mut self, residual: f64, by_local: &DVector<f64>, by_global: &DVector<f64>) {
        self.local.ger(1.0, by_local, by_local, 1.0);
        self.cross.ger(1.0, by_local, by_global, 1.0);
        self.global.ger(1.0, by_global, by_global, 1.0);
        self.local_gradient.axpy(residual, by_local, 1.0);
        self.global_gradient.axpy(residual, by_global, 1.0);
        self.squares += residual * residual;
        self.count += 1;
    }

    /// Adds the residuals of `other`, normal equations of the same unknowns.
    pub fn join(&mut self, other: &Self) {
        self.local += &other.local;
        self.cross += &other.cross;
        self.global += &other.global;
        self.local_gradient += &other.local_gradient;
        self.global_gradient += &other.global_gradient;
        self.squares += other.squares;
        self.count += other.count;
    }

    /// Whether the residuals determine the local parameters at fixed global parameters.
    pub fn determines_local(&self) -> bool {
        ScaledCholesky::independent(&self.local, 0.0).is_some()
    }

    /// Normal equations if only the listed unknowns are estimated, in the given order and as local or global ones. Places
    /// count the local parameters, then the global ones.
    pub fn select(&self, local: &[usize], global: &[usize]) -> NormalBlock {
        let locals = self.local.nrows();
        let at = |i: usize, j: usize| match (i.checked_sub(locals), j.checked_sub(locals)) {
            (None, None) => self.local[(i, j)],
            (None, Some(j)) => self.cross[(i, j)],
            (Some(i), None) => self.cross[(j, i)],
            (Some(i), Some(j)) => self.global[(i, j)],
        };
        let gradient = |i: usize| match i.checked_sub(locals) {
            None => self.local_gradient[i],
            Some(i) => self.global_gradient[i],
        };
        let (l, g) = (local.len(), global.len());
        NormalBlock {
            local: DMatrix::from_fn(l, l, |i, j| at(local[i], local[j])),
            cross: DMatrix::from_fn(l, g, |i, j| at(local[i], global[j])),
            global: DMatrix::from_fn(g, g, |i, j| at(global[i], global[j])),
            local_gradient: DVector::from_fn(l, |i, _| gradient(local[i])),
            global_gradient: DVector::from_fn(g, |i, _| gradient(global[i])),
            ..*self
        }
    }
}

/// Parameters that are not estimated but tested, at the values that they have: products of their derivatives with those
/// by the unknowns and with the residual.
#[derive(Clone, Debug)]
pub(crate) struct TestedParameters {
    /// Local parameters × tested parameters; none once they are eliminated.
    pub by_local: DMatrix<f64>,
    /// Global parameters × tested parameters.
    pub by_global: DMatrix<f64>,
    /// Gradient Jᵀr.
    pub score: DVector<f64>,
    /// Diagonal of JᵀJ.
    pub information: DVector<f64>,
}

/// A flight whose samples do not determine its local parameters; contains its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the samples of flight {0} do not determine its initial state")]
pub struct UndeterminedFlight(pub usize);

/// Schur complement of a flight after elimination of its local parameters, with the factor for back-substitution.
pub(crate) struct SchurComplement {
    factor: ScaledCholesky,
    /// JᵀJ of the global parameters, reduced.
    pub reduced: DMatrix<f64>,
    /// Gradient Jᵀr of the global parameters, reduced.
    pub gradient: DVector<f64>,
}

impl SchurComplement {
    /// Eliminates the local parameters, with damping relative to the diagonal; `None` if they are not determined.
    pub fn new(block: &NormalBlock, damping: f64) -> Option<Self> {
        let factor = ScaledCholesky::independent(&block.local, damping)?;
        let through = block.cross.tr_mul(&factor.solve_matrix(&block.cross));
        let gradient = reduced_gradient(block, &factor);
        Some(Self {
            factor,
            reduced: &block.global - through,
            gradient,
        })
    }
}

impl SchurComplement {
    /// The products of `tested` after elimination of the local parameters of `block`.
    pub fn tested(&self, block: &NormalBlock, mut tested: TestedParameters) -> TestedParameters {
        let through = self.factor.solve_matrix(&tested.by_local);
        tested.by_global -= block.cross.tr_mul(&through);
        tested.score -= through.tr_mul(&block.local_gradient);
        for (k, own) in tested.information.iter_mut().enumerate() {
            *own -= through.column(k).dot(&tested.by_local.column(k));
        }
        tested.by_local = DMatrix::zeros(0, tested.score.len());
        tested
    }
}

/// Normal equations of the global parameters after elimination of all local ones, with the factors for
/// back-substitution.
pub struct ReducedSystem<'a> {
    blocks: &'a [NormalBlock],
    factors: Vec<ScaledCholesky>,
    /// Sum of the Schur complements of all flights: reduced JᵀJ of the global parameters.
    pub reduced: DMatrix<f64>,
    /// Gradient Jᵀr of the global parameters after elimination of the local parameters.
    pub gradient: DVector<f64>,
}

/// Eliminates the local parameters of every flight, with damping relative to the diagonal of JᵀJ.
///
/// # Errors
/// [`UndeterminedFlight`] if the residuals of a flight do not determine its local parameters.
pub fn eliminate(
    blocks: &[NormalBlock],
    damping: f64,
) -> Result<ReducedSystem<'_>, UndeterminedFlight> {
    let complements = blocks
        .iter()
        .map(|block| SchurComplement::new(block, damping));
    ReducedSystem::new(blocks, complements)
}

impl<'a> ReducedSystem<'a> {
    /// Sums the Schur complements of `blocks`.
    ///
    /// # Errors
    /// [`UndeterminedFlight`] with the first flight that has none.
    pub(crate) fn new(
        blocks: &'a [NormalBlock],
        complements: impl IntoIterator<Item = Option<SchurComplement>>,
    ) -> Result<Self, UndeterminedFlight> {
        let size = blocks.first().map_or(0, |block| block.global.nrows());
        let mut reduced = DMatrix::zeros(size, size);
        let mut gradient = DVector::zeros(size);
        let mut factors = Vec::with_capacity(blocks.len());
        for (index, complement) in complements.into_iter().enumerate() {
            let complement = complement.ok_or(UndeterminedFlight(index))?;
            reduced += complement.reduced;
            gradient += complement.gradient;
            factors.push(complement.factor);
        }
        Ok(Self {
            blocks,
            factors,
            reduced,
            gradient,
        })
    }
}

impl ReducedSystem<'_> {
    /// Steps of the local parameters (initial state) of each flight, given the step of the global parameters.
    pub fn back_substitute(&self, global: &DVector<f64>) -> Vec<DVector<f64>> {
        let blocks = self.blocks.iter().zip(&self.factors);
        blocks
            .map(|(block, factor)| -factor.solve(&(&block.local_gradient + &block.cross * global)))
            .collect()
    }

    /// Decrease of the sum of squares that the quadratic model predicts for a step of the global and local parameters.
    pub fn predicted_reduction(&self, global: &DVector<f64>, local: &[DVector<f64>]) -> f64 {
        let each = self.blocks.iter().zip(local).map(|(block, local)| {
            let slope = block.local_gradient.dot(local) + block.global_gradient.dot(global);
            let curvature = local.dot(&(&block.local * local))
                + 2.0 * local.dot(&(&block.cross * global))
                + global.dot(&(&block.global * global));
            -2.0 * slope - curvature
        });
        each.sum()
    }

    /// Covariance of a flight's local parameters for residuals of variance 1, given that of the global ones.
    pub fn local_covariance(&self, flight: usize, global: &DMatrix<f64>) -> DMatrix<f64> {
        let factor = &self.factors[flight];
        let through = factor.solve_matrix(&self.blocks[flight].cross);
        factor.inverse() + &through * global * through.transpose()
    }

    /// Gradient of one flight by the global parameters, local ones eliminated: its effective score.
    pub fn score(&self, flight: usize) -> DVector<f64> {
        reduced_gradient(&self.blocks[flight], &self.factors[flight])
    }
}

/// Gradient Jᵀr of a flight with respect to the global parameters, after elimination of its local parameters.
fn reduced_gradient(block: &NormalBlock, factor: &ScaledCholesky) -> DVector<f64> {
    let local = factor.solve(&block.local_gradient);
    &block.global_gradient - block.cross.tr_mul(&local)
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha12Rng;

    use super::*;

    /// Normal equations of three flights with pseudo-random rows, and the corresponding dense Jacobian and residuals.
    fn example() -> (Vec<NormalBlock>, DMatrix<f64>, DVector<f64>) {
        let (flights, local, global, rows) = (3, 2, 2, 9);
        let size = global + flights * local;
        let mut matrix = DMatrix::zeros(flights * rows, size);
        let mut residuals = DVector::zeros(flights * rows);
        let mut random = ChaCha12Rng::seed_from_u64(1);
        let mut next = || random.random::<f64>() - 0.5;
        let mut blocks = vec![NormalBlock::zero(local, global); flights];
        for (flight, block) in blocks.iter_mut().enumerate() {
            for row in 0..rows {
                let by_local =
                    DVector::from_fn(local, |i, _| next() * if i == 0 { 1e-5 } else { 1e2 });
                let by_global = DVector::from_fn(global, |_, _| next());
                let residual = next();
                block.add(residual, &by_local, &by_global);
                let at = flight * rows + row;
                matrix
                    .view_mut((at, 0), (1, global))
                    .tr_copy_from(&by_global);
                matrix
                    .view_mut((at, global + flight * local), (1, local))
                    .tr_copy_from(&by_local);
                residuals[at] = residual;
            }
        }
        (blocks, matrix, residuals)
    }

    #[test]
    fn elimination_agrees_with_the_dense_solution() {
        let (blocks, matrix, residuals) = example();
        let dense = -matrix
            .clone()
            .svd(true, true)
            .solve(&residuals, 0.0)
            .unwrap();
        let eliminated = eliminate(&blocks, 0.0).unwrap();
        let factor = eliminated.reduced.clone().cholesky().unwrap();
        let global = -factor.solve(&eliminated.gradient);
        let local = eliminated.back_substitute(&global);
        let mut together = global.as_slice().to_vec();
        together.extend(local.iter().flat_map(|step| step.as_slice().to_vec()));
        approx_eq(&together, dense.as_slice());

        let inverse = matrix.pseudo_inverse(0.0).unwrap();
        let inverse = &inverse * inverse.transpose();
        let covariance = factor.inverse();
        approx_eq(
            covariance.as_slice(),
            inverse.view((0, 0), (2, 2)).clone_owned().as_slice(),
        );
        approx_eq(
            eliminated.local_covariance(1, &covariance).as_slice(),
            inverse.view((4, 4), (2, 2)).clone_owned().as_slice(),
        );
    }

    #[test]
    fn scores_add_up_to_the_gradient() {
        let (blocks, _, _) = example();
        let eliminated = eliminate(&blocks, 0.0).unwrap();
        let sum: DVector<f64> = (0..3).map(|flight| eliminated.score(flight)).sum();
        approx_eq(sum.as_slice(), eliminated.gradient.as_slice());
    }

    #[test]
    fn selection_gives_the_blocks_of_the_same_rows() {
        let (blocks, ..) = example();
        let selected = blocks[0].select(&[1], &[3, 2]);
        assert_eq!(selected.local[(0, 0)], blocks[0].local[(1, 1)]);
        assert_eq!(selected.cross[(0, 0)], blocks[0].cross[(1, 1)]);
        assert_eq!(selected.global[(0, 1)], blocks[0].global[(1, 0)]);
    }

    #[test]
    fn a_flight_without_samples_is_named() {
        let (mut blocks, _, _) = example();
        blocks[1] = NormalBlock::zero(2, 2);
        assert_eq!(eliminate(&blocks, 0.0).err(), Some(UndeterminedFlight(1)));
        assert!(blocks[0].determines_local() && !blocks[1].determines_local());
    }

    fn approx_eq(left: &[f64], right: &[f64]) {
        for (a, b) in left.iter().zip(right) {
            assert!(
                (a - b).abs() <= 1e-8 * (1e-3 + b.abs()),
                "{left:?} against {right:?}"
            );
        }
    }
}
