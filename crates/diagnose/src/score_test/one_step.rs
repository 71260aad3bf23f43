//! One-step estimate of all significant directions at once.

use nalgebra::{DVector, SymmetricEigen};

use super::score_tests::{MIN_TOLERANCE, ScoreTests};

impl ScoreTests {
    /// Gauss–Newton step of all global unknowns (parameters and library-term coefficients). The tested unknowns move
    /// only along those eigenvectors of their effective information whose score exceeds `limit` standard deviations;
    /// the nuisance parameters are re-estimated. Also returns the number of these eigenvectors.
    pub fn one_step_along_significant(&self, limit: f64) -> (DVector<f64>, usize) {
        let tested = &self.partition.tested;
        let mut along = DVector::zeros(tested.len());
        let mut directions = 0;
        if !tested.is_empty() {
            let eigen = SymmetricEigen::new(self.information.clone());
            let vectors = eigen.eigenvectors.column_iter();
            for (value, vector) in eigen.eigenvalues.iter().zip(vectors) {
                if *value > MIN_TOLERANCE {
                    let score = vector.dot(&self.score) / value.sqrt();
                    if score.abs() > limit {
                        along.axpy(score / value.sqrt(), &vector, 1.0);
                        directions += 1;
                    }
                }
            }
        }
        let nuisance = &self.nuisance_step - &self.nuisance_projection * &along;
        let mut step = DVector::zeros(tested.len() + nuisance.len());
        for (column, value) in self.partition.nuisance.iter().zip(nuisance.iter()) {
            step[column.index()] = *value;
        }
        for ((column, value), scale) in tested.iter().zip(along.iter()).zip(&self.scale) {
            step[column.index()] = value * scale;
        }
        (step, directions)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_support::fixture;

    #[test]
    fn only_significant_directions_are_stepped_along() {
        let fixture = fixture();
        let model = &fixture.model;
        let noise = fixture.fit.noise();
        let blocks = model.normal_equations(&model.problem, &fixture.iterate, noise);
        let blocks = blocks.unwrap();
        let tests = ScoreTests::new(model, &blocks, &[], &fixture.iterate.global).unwrap();
        let (_, none) = tests.one_step_along_significant(f64::INFINITY);
        let (step, few) = tests.one_step_along_significant(4.0);
        let (_, all) = tests.one_step_along_significant(0.0);
        assert!(none == 0 && 0 < few && few < all, "{few} of {all}");
        assert_eq!(step.len(), model.global_columns());
    }
}
