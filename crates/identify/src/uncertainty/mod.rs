//! What the estimates are worth.

mod non_identifiability;
mod profile;

use nalgebra::{DMatrix, DVector, SymmetricEigen};

pub use non_identifiability::{ExcitationRange, non_identifiable};
pub use profile::profile;

use crate::least_squares::ReducedSystem;
use crate::problem::GlobalParameter;

/// Half the interval of 95 %, over the standard error.
const WIDE: f64 = 1.959_963_984_540_054;

/// The interval that holds the true value with a probability of 95 %, by an estimate and its standard error.
pub fn interval(value: f64, std_error: f64) -> [f64; 2] {
    [value - WIDE * std_error, value + WIDE * std_error]
}

/// The covariance of the shared unknowns.
#[derive(Clone, Debug, PartialEq)]
pub struct Covariance {
    /// By the noise that was found.
    pub model: DMatrix<f64>,
    /// By the scatter of the flights alone; none for fewer than 8.
    pub clustered: Option<DMatrix<f64>>,
}

/// Flights below which their scatter says little of a standard error.
const CLUSTERS: usize = 8;

/// The least part of a direction's information that is believed to be any: what is below it is rounding.
const ROUNDING: f64 = 1e-13;

impl Covariance {
    /// The covariance by an eliminated system of whitened residuals and the priors.
    pub fn new(system: &ReducedSystem<'_>, flights: usize, global: &[GlobalParameter]) -> Self {
        let mut information = system.reduced.clone();
        for (i, unknown) in global.iter().enumerate() {
            if let Some((_, sigma)) = unknown.constraint.prior {
                information[(i, i)] += sigma.powi(-2);
            }
        }
        let model = inverse(&information);
        let clustered = (flights >= CLUSTERS && !global.is_empty()).then(|| {
            let mut scatter = DMatrix::zeros(global.len(), global.len());
            let mean = &system.gradient / flights as f64;
            for flight in 0..flights {
                let score = system.score(flight) - &mean;
                scatter.ger(1.0, &score, &score, 1.0);
            }
            let few = flights as f64 / (flights as f64 - 1.0);
            &model * scatter * &model * few
        });
        Self { model, clustered }
    }

    /// Standard errors.
    pub fn errors(&self) -> DVector<f64> {
        self.model
            .diagonal()
            .map(|variance| variance.max(0.0).sqrt())
    }

    /// Standard errors by the scatter of the flights.
    pub fn clustered_errors(&self) -> Option<DVector<f64>> {
        let clustered = self.clustered.as_ref()?;
        Some(
            clustered
                .diagonal()
                .map(|variance| variance.max(0.0).sqrt()),
        )
    }

    /// Correlations.
    pub fn correlations(&self) -> DMatrix<f64> {
        let errors = self.errors();
        DMatrix::from_fn(errors.len(), errors.len(), |i, j| {
            let product = errors[i] * errors[j];
            if i == j {
                1.0
            } else if product > 0.0 {
                (self.model[(i, j)] / product).clamp(-1.0, 1.0)
            } else {
                0.0
            }
        })
    }
}

/// The inverse of an information matrix, where directions that carry none come out as uncertain as rounding lets
/// them.
fn inverse(information: &DMatrix<f64>) -> DMatrix<f64> {
    let size = information.nrows();
    if size == 0 {
        return DMatrix::zeros(0, 0);
    }
    let scale = information.diagonal().map(|value| {
        let root = value.max(0.0).sqrt();
        // An unknown that nothing depends on: as uncertain as can be written.
        if root > 1e-100 { 1.0 / root } else { 1e6 }
    });
    let scaled = DMatrix::from_fn(size, size, |i, j| information[(i, j)] * scale[i] * scale[j]);
    let eigen = SymmetricEigen::new(scaled);
    let mut inverse = DMatrix::zeros(size, size);
    for (value, vector) in eigen
        .eigenvalues
        .iter()
        .zip(eigen.eigenvectors.column_iter())
    {
        inverse.ger(1.0 / value.max(ROUNDING), &vector, &vector, 1.0);
    }
    DMatrix::from_fn(size, size, |i, j| inverse[(i, j)] * scale[i] * scale[j])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_of_a_regular_matrix() {
        let matrix = DMatrix::from_row_slice(2, 2, &[4e10, 1e3, 1e3, 1e-2]);
        let expected = matrix.clone().try_inverse().unwrap();
        let found = inverse(&matrix);
        for (a, b) in found.iter().zip(expected.iter()) {
            assert!((a / b - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn a_direction_without_information_is_uncertain() {
        // Only the sum of the two is known.
        let matrix = DMatrix::from_element(2, 2, 100.0);
        let found = inverse(&matrix);
        assert!(found[(0, 0)] > 1e9);
        let sum = found[(0, 0)] + 2.0 * found[(0, 1)] + found[(1, 1)];
        assert!(sum < 1e-2 * found[(0, 0)]);
    }
}
