//! Measured and predicted samples of a flight, from which figures are drawn.

use serde::{Deserialize, Serialize};

use crate::dataset::Role;

/// Measured and predicted samples of one flight.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FlightEvidence {
    /// File name of the flight.
    pub file: String,
    /// Whether the flight was fitted or held out.
    pub role: Role,
    /// Names of the markers and pose sensors.
    pub markers: Vec<String>,
    /// Times of the samples, s, from the first.
    pub times: Vec<f64>,
    /// `measured[sample][marker]`, m; `None` for a missing value.
    pub measured: Vec<Vec<Option<[f64; 3]>>>,
    /// `outlier[sample][marker]`: whether a measured point is excluded as an outlier.
    pub outlier: Vec<Vec<bool>>,
    /// `predicted[sample][marker]`: predicted position, m, inertial frame.
    pub predicted: Vec<Vec<[f64; 3]>>,
    /// Channels that are no positions.
    #[serde(default)]
    pub sensors: Vec<SensorEvidence>,
    /// Names of the states.
    pub state_names: Vec<String>,
    /// `states[sample][state]`, SI.
    pub states: Vec<Vec<f64>>,
    /// Names of the model's auxiliary quantities, vectors by component.
    pub quantity_names: Vec<String>,
    /// `quantities[sample][quantity]`, SI.
    pub quantities: Vec<Vec<f64>>,
}

/// Measured values and residuals of one channel that is no position, in its own unit.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SensorEvidence {
    /// Name of the sensor.
    pub name: String,
    /// Index among the channels of the problem.
    pub channel: usize,
    /// Unit of a component: `rad` of an attitude, else that of the instrument.
    pub unit: String,
    /// Number of components; a single number stands there three times.
    pub components: usize,
    /// Measured value by sample, of an attitude its rotation vector; `None` for a missing one.
    pub measured: Vec<Option<[f64; 3]>>,
    /// Whether a measured value is excluded as an outlier, by sample.
    pub outlier: Vec<bool>,
    /// Residual by sample, measured − predicted; of an attitude the rotation vector between them, in the inertial frame.
    pub residuals: Vec<Option<[f64; 3]>>,
}

impl FlightEvidence {
    /// Residual, measured − predicted, m; `None` for a missing value or an outlier.
    pub fn residual(&self, sample: usize, marker: usize) -> Option<[f64; 3]> {
        let seen = self.measured[sample][marker].filter(|_| !self.outlier[sample][marker])?;
        let predicted = self.predicted[sample][marker];
        Some([0, 1, 2].map(|axis| seen[axis] - predicted[axis]))
    }
}

/// Residual diagnostics along one axis, over all fitted flights and markers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AxisResiduals {
    /// Autocorrelation of the residuals at lags of 0, 1, 2 … samples.
    pub autocorrelation: Vec<f64>,
    /// Autocorrelation of the whitened residuals at lags of 0, 1, 2 … samples: within ±`band` of 0 if they are white.
    pub whitened_autocorrelation: Vec<f64>,
    /// 95 % band of the autocorrelation of white residuals: 1.96 over the root of their number.
    pub band: f64,
    /// Pairs (normal quantile, quantile of the whitened residuals over their standard deviation).
    pub quantiles: Vec<[f64; 2]>,
}
