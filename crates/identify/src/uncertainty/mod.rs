//! Uncertainty of the estimates: covariance, profile likelihood and practical non-identifiability.

mod non_identifiability;
mod profile;

use nalgebra::{DMatrix, DVector};

pub use non_identifiability::non_identifiable;
pub use profile::profile;

use crate::least_squares::{ReducedSystem, floored_inverse};
use crate::problem::GlobalParameter;
use dataset::levels::RANK;

const NORMAL_975: f64 = 1.959_963_984_540_054;

/// 95 % confidence interval of an estimate with a normally distributed error.
pub fn interval(value: f64, std_error: f64) -> [f64; 2] {
    [
        value - NORMAL_975 * std_error,
        value + NORMAL_975 * std_error,
    ]
}

/// Covariance matrices of the estimated global parameters, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Covariance {
    /// Inverse of the information matrix under the estimated noise (Cramér–Rao bound).
    pub model: DMatrix<f64>,
    /// Cluster-robust (sandwich) covariance with flights as clusters; `None` for fewer than 8 flights.
    pub clustered: Option<DMatrix<f64>>,
}

fn standard_errors(covariance: &DMatrix<f64>) -> DVector<f64> {
    let variances = covariance.diagonal();
    variances.map(|variance| variance.max(0.0).sqrt())
}

/// Minimum number of flights for a cluster-robust covariance.
const MIN_CLUSTERS: usize = 8;

impl Covariance {
    /// Covariance from the reduced normal equations of whitened residuals and the priors.
    pub fn new(system: &ReducedSystem<'_>, flights: usize, global: &[GlobalParameter]) -> Self {
        let mut information = system.reduced.clone();
        for (i, unknown) in global.iter().enumerate() {
            if let Some((_, sigma)) = unknown.constraint.prior {
                information[(i, i)] += sigma.powi(-2);
            }
        }
        let model = floored_inverse(&information, RANK);
        let clustered = (flights >= MIN_CLUSTERS && !global.is_empty()).then(|| {
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

    /// Cramér–Rao standard errors, in the order of the global parameters, SI.
    pub fn errors(&self) -> DVector<f64> {
        standard_errors(&self.model)
    }

    /// Cluster-robust standard errors, in the order of the global parameters, SI; `None` for fewer than 8 flights.
    pub fn clustered_errors(&self) -> Option<DVector<f64>> {
        self.clustered.as_ref().map(standard_errors)
    }

    /// Correlations by the Cramér–Rao covariance; 0 with a parameter of zero variance.
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
