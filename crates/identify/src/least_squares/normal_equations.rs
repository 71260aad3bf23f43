//! Normal equations of many flights, with each flight's own unknowns eliminated.
//!
//! Every flight has unknowns of its own (its initial state) and all share the coefficients. Eliminating the
//! former flight by flight leaves a system as small as the coefficients, so that the work grows with the
//! number of flights and no faster.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// The normal equations of one flight: second derivatives and gradient of half the sum of squares.
#[derive(Clone, Debug, PartialEq)]
pub struct NormalBlock {
    /// Own by own.
    pub local: DMatrix<f64>,
    /// Own by shared.
    pub cross: DMatrix<f64>,
    /// Shared by shared.
    pub global: DMatrix<f64>,
    /// Gradient for the flight's own unknowns.
    pub local_gradient: DVector<f64>,
    /// Gradient for the shared unknowns.
    pub global_gradient: DVector<f64>,
    /// Sum of squared residuals.
    pub squares: f64,
    /// How many residuals were summed.
    pub count: usize,
}

impl NormalBlock {
    /// No residuals yet, of `own` and `shared` unknowns.
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

    /// Adds one residual with its derivatives.
    pub fn add(&mut self, residual: f64, by_local: &DVector<f64>, by_global: &DVector<f64>) {
        self.local.ger(1.0, by_local, by_local, 1.0);
        self.cross.ger(1.0, by_local, by_global, 1.0);
        self.global.ger(1.0, by_global, by_global, 1.0);
        self.local_gradient.axpy(residual, by_local, 1.0);
        self.global_gradient.axpy(residual, by_global, 1.0);
        self.squares += residual * residual;
        self.count += 1;
    }

    /// Whether the flight determines its own unknowns where the shared ones are known.
    pub fn determines_local(&self) -> bool {
        factor(&self.local, 0.0).is_some()
    }
}

/// The flight whose own unknowns its samples do not determine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the samples of flight {0} do not determine its initial state")]
pub struct UndeterminedFlight(pub usize);

/// What is left of one flight's block once its own unknowns are eliminated.
pub struct SchurComplement {
    factor: ScaledCholesky,
    reduced: DMatrix<f64>,
    gradient: DVector<f64>,
}

impl SchurComplement {
    /// With Levenberg's damping relative to the diagonal; none where the block is not positive definite.
    pub fn new(block: &NormalBlock, damping: f64) -> Option<Self> {
        let factor = factor(&block.local, damping)?;
        let through = block.cross.tr_mul(&factor.solve_matrix(&block.cross));
        let gradient = score(block, &factor);
        Some(Self {
            factor,
            reduced: &block.global - through,
            gradient,
        })
    }
}

/// The eliminated system, kept for the back-substitution.
pub struct ReducedSystem<'a> {
    blocks: &'a [NormalBlock],
    factors: Vec<ScaledCholesky>,
    /// What is left for the shared unknowns: second derivatives of half the sum of squares.
    pub reduced: DMatrix<f64>,
    /// And its gradient.
    pub gradient: DVector<f64>,
}

/// The factor of a symmetric matrix whose diagonal was scaled to 1: unknowns have sizes from 1e-5 to 1e2.
struct ScaledCholesky {
    scale: DVector<f64>,
    cholesky: Cholesky<f64, Dyn>,
}

/// Parts of a squared column that are left of it once the others are allowed for, below which it is not determined.
const DEPENDENT: f64 = 1e-11;

fn factor(matrix: &DMatrix<f64>, damping: f64) -> Option<ScaledCholesky> {
    let scale = matrix.diagonal().map(|value| {
        let root = value.max(0.0).sqrt();
        if root > 1e-150 { 1.0 / root } else { 1.0 }
    });
    let size = matrix.nrows();
    let mut scaled = DMatrix::from_fn(size, size, |i, j| matrix[(i, j)] * scale[i] * scale[j]);
    for i in 0..size {
        scaled[(i, i)] += damping;
    }
    let cholesky = scaled.cholesky()?;
    let least = cholesky.l_dirty().diagonal().min();
    (size == 0 || least * least > DEPENDENT).then_some(ScaledCholesky { scale, cholesky })
}

impl ScaledCholesky {
    fn solve(&self, right: &DVector<f64>) -> DVector<f64> {
        let scaled = right.component_mul(&self.scale);
        self.cholesky.solve(&scaled).component_mul(&self.scale)
    }

    fn solve_matrix(&self, right: &DMatrix<f64>) -> DMatrix<f64> {
        let mut solved = right.clone();
        for (mut row, scale) in solved.row_iter_mut().zip(self.scale.iter()) {
            row *= *scale;
        }
        self.cholesky.solve_mut(&mut solved);
        for (mut row, scale) in solved.row_iter_mut().zip(self.scale.iter()) {
            row *= *scale;
        }
        solved
    }

    fn inverse(&self) -> DMatrix<f64> {
        let inverse = self.cholesky.inverse();
        let size = self.scale.len();
        DMatrix::from_fn(size, size, |i, j| {
            inverse[(i, j)] * self.scale[i] * self.scale[j]
        })
    }
}

/// Eliminates every flight's own unknowns, with Levenberg's damping relative to the diagonal.
///
/// # Errors
/// [`UndeterminedFlight`] where a flight's block is not positive definite.
pub fn eliminate(
    blocks: &[NormalBlock],
    damping: f64,
) -> Result<ReducedSystem<'_>, UndeterminedFlight> {
    let rests = blocks
        .iter()
        .map(|block| SchurComplement::new(block, damping));
    ReducedSystem::new(blocks, rests)
}

impl<'a> ReducedSystem<'a> {
    /// The same by what is left of each block.
    ///
    /// # Errors
    /// [`UndeterminedFlight`] where nothing is.
    pub fn new(
        blocks: &'a [NormalBlock],
        rests: impl IntoIterator<Item = Option<SchurComplement>>,
    ) -> Result<Self, UndeterminedFlight> {
        let size = blocks.first().map_or(0, |block| block.global.nrows());
        let mut reduced = DMatrix::zeros(size, size);
        let mut gradient = DVector::zeros(size);
        let mut factors = Vec::with_capacity(blocks.len());
        for (index, rest) in rests.into_iter().enumerate() {
            let rest = rest.ok_or(UndeterminedFlight(index))?;
            reduced += rest.reduced;
            gradient += rest.gradient;
            factors.push(rest.factor);
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
    /// The steps of each flight's own unknowns for a given step of the shared ones.
    pub fn back_substitute(&self, global: &DVector<f64>) -> Vec<DVector<f64>> {
        let blocks = self.blocks.iter().zip(&self.factors);
        blocks
            .map(|(block, factor)| -factor.solve(&(&block.local_gradient + &block.cross * global)))
            .collect()
    }

    /// By how much a step decreases the sum of squares, to the second order.
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

    /// The covariance of one flight's own unknowns for residuals of variance 1, where the shared ones have this one.
    pub fn local_covariance(&self, flight: usize, global: &DMatrix<f64>) -> DMatrix<f64> {
        let factor = &self.factors[flight];
        let through = factor.solve_matrix(&self.blocks[flight].cross);
        factor.inverse() + &through * global * through.transpose()
    }

    /// What one flight adds to the gradient of the shared unknowns.
    pub fn score(&self, flight: usize) -> DVector<f64> {
        score(&self.blocks[flight], &self.factors[flight])
    }
}

/// What a block adds to the gradient of the shared unknowns once its own are eliminated.
fn score(block: &NormalBlock, factor: &ScaledCholesky) -> DVector<f64> {
    let local = factor.solve(&block.local_gradient);
    &block.global_gradient - block.cross.tr_mul(&local)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Blocks of pseudo-random rows, and the same rows as one dense system.
    fn example() -> (Vec<NormalBlock>, DMatrix<f64>, DVector<f64>) {
        let (flights, local, global, rows) = (3, 2, 2, 9);
        let size = global + flights * local;
        let mut matrix = DMatrix::zeros(flights * rows, size);
        let mut residuals = DVector::zeros(flights * rows);
        let mut seed = 1_u64;
        let mut next = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
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
