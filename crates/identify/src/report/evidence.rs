//! What figures are drawn from: the samples of each flight with what is predicted of them.

use serde::{Deserialize, Serialize};

use crate::dataset::Role;

/// A flight as measured and as predicted.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FlightEvidence {
    /// Its file.
    pub file: String,
    /// Whether it was fitted or held out.
    pub role: Role,
    /// Names of the markers.
    pub markers: Vec<String>,
    /// Times of the samples, s, from the first.
    pub times: Vec<f64>,
    /// `measured[sample][marker]`, m; `None` where it was not seen.
    pub measured: Vec<Vec<Option<[f64; 3]>>>,
    /// `outlier[sample][marker]`: measured, and taken for an outlier.
    pub outlier: Vec<Vec<bool>>,
    /// `predicted[sample][marker]`, m.
    pub predicted: Vec<Vec<[f64; 3]>>,
    /// Names of the states.
    pub state_names: Vec<String>,
    /// `states[sample][state]`, SI.
    pub states: Vec<Vec<f64>>,
    /// Names of the model's quantities, vectors by component.
    pub quantity_names: Vec<String>,
    /// `quantities[sample][quantity]`, SI.
    pub quantities: Vec<Vec<f64>>,
}

impl FlightEvidence {
    /// Measured less predicted, m; `None` where nothing was seen or it was taken for an outlier.
    pub fn residual(&self, sample: usize, marker: usize) -> Option<[f64; 3]> {
        let seen = self.measured[sample][marker].filter(|_| !self.outlier[sample][marker])?;
        let predicted = self.predicted[sample][marker];
        Some([0, 1, 2].map(|axis| seen[axis] - predicted[axis]))
    }
}

/// The residuals along one axis, over all fitted flights and markers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AxisResiduals {
    /// Autocorrelation of the residuals at lags of 0, 1, 2 … samples.
    pub autocorrelation: Vec<f64>,
    /// The same once the noise's own correlation is taken out: within ±`band` of 0 where nothing is left.
    pub whitened_autocorrelation: Vec<f64>,
    /// 1.96 over the root of the number of residuals.
    pub band: f64,
    /// Quantiles of the whitened residuals over their standard deviation: what a normal distribution has, what was found.
    pub quantiles: Vec<[f64; 2]>,
}
