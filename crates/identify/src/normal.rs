//! Normal equations of many flights, with each flight's own unknowns eliminated.
//!
//! Every flight has unknowns of its own (its initial state) and all share the coefficients. Eliminating the
//! former flight by flight leaves a system as small as the coefficients, so that the work grows with the
//! number of flights and no faster.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// The normal equations of one flight: second derivatives and gradient of half the sum of squares.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Own by own.
    pub own: DMatrix<f64>,
    /// Own by shared.
    pub cross: DMatrix<f64>,
    /// Shared by shared.
    pub shared: DMatrix<f64>,
    /// Gradient for the flight's own unknowns.
    pub own_gradient: DVector<f64>,
    /// Gradient for the shared unknowns.
    pub shared_gradient: DVector<f64>,
    /// Sum of squared residuals.
    pub squares: f64,
    /// How many residuals were summed.
    pub count: usize,
}

impl Block {
    /// No residuals yet, of `own` and `shared` unknowns.
    pub fn zero(own: usize, shared: usize) -> Self {
        Self {
            own: DMatrix::zeros(own, own),
            cross: DMatrix::zeros(own, shared),
            shared: DMatrix::zeros(shared, shared),
            own_gradient: DVector::zeros(own),
            shared_gradient: DVector::zeros(shared),
            squares: 0.0,
            count: 0,
        }
    }

    /// Adds one residual with its derivatives.
    pub fn add(&mut self, residual: f64, by_own: &DVector<f64>, by_shared: &DVector<f64>) {
        self.own.ger(1.0, by_own, by_own, 1.0);
        self.cross.ger(1.0, by_own, by_shared, 1.0);
        self.shared.ger(1.0, by_shared, by_shared, 1.0);
        self.own_gradient.axpy(residual, by_own, 1.0);
        self.shared_gradient.axpy(residual, by_shared, 1.0);
        self.squares += residual * residual;
        self.count += 1;
    }
}

/// Why a step could not be computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Singular {
    /// The flight's own unknowns are not determined by its samples.
    #[error("the samples of flight {0} do not determine its initial state")]
    Own(usize),
    /// The shared unknowns are not determined.
    #[error("these flights do not determine the coefficients")]
    Shared,
}

/// The eliminated system, kept for the back-substitution.
pub struct Eliminated<'a> {
    blocks: &'a [Block],
    factors: Vec<Cholesky<f64, Dyn>>,
    reduced: Option<Cholesky<f64, Dyn>>,
    gradient: DVector<f64>,
}

/// Adds `damping` times the diagonal to the diagonal, with a floor so that a zero column does not stay singular.
fn damped(mut matrix: DMatrix<f64>, damping: f64) -> DMatrix<f64> {
    if damping > 0.0 {
        for i in 0..matrix.nrows() {
            matrix[(i, i)] += damping * matrix[(i, i)].max(1e-12);
        }
    }
    matrix
}

/// Eliminates every flight's own unknowns, with Levenberg's damping relative to the diagonal.
///
/// # Errors
/// [`Singular`] where a block is not positive definite.
pub fn eliminate(blocks: &[Block], damping: f64) -> Result<Eliminated<'_>, Singular> {
    let size = blocks.first().map_or(0, |block| block.shared.nrows());
    let mut reduced = DMatrix::zeros(size, size);
    let mut gradient = DVector::zeros(size);
    let mut diagonal = DVector::zeros(size);
    let mut factors = Vec::with_capacity(blocks.len());
    for (index, block) in blocks.iter().enumerate() {
        let factor = damped(block.own.clone(), damping)
            .cholesky()
            .ok_or(Singular::Own(index))?;
        reduced += &block.shared - block.cross.tr_mul(&factor.solve(&block.cross));
        gradient += &block.shared_gradient - block.cross.tr_mul(&factor.solve(&block.own_gradient));
        diagonal += block.shared.diagonal();
        factors.push(factor);
    }
    for i in 0..size {
        reduced[(i, i)] += damping * diagonal[i].max(1e-12);
    }
    let reduced = if size == 0 {
        None
    } else {
        Some(reduced.cholesky().ok_or(Singular::Shared)?)
    };
    Ok(Eliminated {
        blocks,
        factors,
        reduced,
        gradient,
    })
}

impl Eliminated<'_> {
    /// The step for the shared unknowns, and for each flight's own.
    pub fn step(&self) -> (DVector<f64>, Vec<DVector<f64>>) {
        let shared = match &self.reduced {
            Some(reduced) => -reduced.solve(&self.gradient),
            None => DVector::zeros(0),
        };
        let own = self.own_steps(&shared);
        (shared, own)
    }

    /// The steps of each flight's own unknowns for a given step of the shared ones.
    pub fn own_steps(&self, shared: &DVector<f64>) -> Vec<DVector<f64>> {
        let blocks = self.blocks.iter().zip(&self.factors);
        blocks
            .map(|(block, factor)| -factor.solve(&(&block.own_gradient + &block.cross * shared)))
            .collect()
    }

    /// By how much a step decreases the sum of squares, to the second order.
    pub fn promised(&self, shared: &DVector<f64>, own: &[DVector<f64>]) -> f64 {
        let each = self.blocks.iter().zip(own).map(|(block, own)| {
            let slope = block.own_gradient.dot(own) + block.shared_gradient.dot(shared);
            let curvature = own.dot(&(&block.own * own))
                + 2.0 * own.dot(&(&block.cross * shared))
                + shared.dot(&(&block.shared * shared));
            -2.0 * slope - curvature
        });
        each.sum()
    }

    /// Inverse of the reduced matrix: the covariance of the shared unknowns for residuals of variance 1.
    pub fn shared_covariance(&self) -> DMatrix<f64> {
        self.reduced
            .as_ref()
            .map_or_else(|| DMatrix::zeros(0, 0), Cholesky::inverse)
    }

    /// The covariance of one flight's own unknowns for residuals of variance 1.
    pub fn own_covariance(&self, flight: usize) -> DMatrix<f64> {
        let factor = &self.factors[flight];
        let through = factor.solve(&self.blocks[flight].cross);
        factor.inverse() + &through * self.shared_covariance() * through.transpose()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Blocks of pseudo-random rows, and the same rows as one dense system.
    fn example() -> (Vec<Block>, DMatrix<f64>, DVector<f64>) {
        let (flights, own, shared, rows) = (3, 2, 2, 9);
        let size = shared + flights * own;
        let mut matrix = DMatrix::zeros(flights * rows, size);
        let mut residuals = DVector::zeros(flights * rows);
        let mut seed = 1_u64;
        let mut next = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        let mut blocks = vec![Block::zero(own, shared); flights];
        for (flight, block) in blocks.iter_mut().enumerate() {
            for row in 0..rows {
                let by_own = DVector::from_fn(own, |_, _| next());
                let by_shared = DVector::from_fn(shared, |_, _| next());
                let residual = next();
                block.add(residual, &by_own, &by_shared);
                let at = flight * rows + row;
                matrix
                    .view_mut((at, 0), (1, shared))
                    .tr_copy_from(&by_shared);
                matrix
                    .view_mut((at, shared + flight * own), (1, own))
                    .tr_copy_from(&by_own);
                residuals[at] = residual;
            }
        }
        (blocks, matrix, residuals)
    }

    #[test]
    fn elimination_agrees_with_the_dense_solution() {
        let (blocks, matrix, residuals) = example();
        let normal = matrix.tr_mul(&matrix);
        let dense = -normal
            .clone()
            .cholesky()
            .unwrap()
            .solve(&matrix.tr_mul(&residuals));
        let eliminated = eliminate(&blocks, 0.0).unwrap();
        let (shared, own) = eliminated.step();
        let mut together = shared.as_slice().to_vec();
        together.extend(own.iter().flat_map(|step| step.as_slice().to_vec()));
        approx_eq(&together, dense.as_slice());

        let inverse = normal.try_inverse().unwrap();
        approx_eq(
            eliminated.shared_covariance().as_slice(),
            inverse.view((0, 0), (2, 2)).clone_owned().as_slice(),
        );
        approx_eq(
            eliminated.own_covariance(1).as_slice(),
            inverse.view((4, 4), (2, 2)).clone_owned().as_slice(),
        );
    }

    #[test]
    fn a_flight_without_samples_is_named() {
        let (mut blocks, _, _) = example();
        blocks[1] = Block::zero(2, 2);
        assert_eq!(eliminate(&blocks, 0.0).err(), Some(Singular::Own(1)));
    }

    fn approx_eq(left: &[f64], right: &[f64]) {
        for (a, b) in left.iter().zip(right) {
            assert!(
                (a - b).abs() <= 1e-12 * (1.0 + b.abs()),
                "{left:?} against {right:?}"
            );
        }
    }
}
