//! Measured and predicted values of a flight, for figures.

use serde::{Deserialize, Serialize};

use dataset::Role;

/// Measured and predicted values of one flight at its samples.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FlightEvidence {
    /// File name of the flight.
    pub file: String,
    /// Whether the flight was fitted or held out.
    pub role: Role,
    /// Names of the markers and pose sensors to which the positions in `measured` and `predicted` belong.
    pub markers: Vec<String>,
    /// Times of the samples relative to the first one, s.
    pub times: Vec<f64>,
    /// Measured positions as `measured[sample][marker]`, m, inertial frame; `None` for a missing value.
    pub measured: Vec<Vec<Option<[f64; 3]>>>,
    /// Whether a measured position is excluded as an outlier, as `outlier[sample][marker]`.
    pub outlier: Vec<Vec<bool>>,
    /// Predicted positions as `predicted[sample][marker]`, m, inertial frame.
    pub predicted: Vec<Vec<[f64; 3]>>,
    /// Channels that measure other quantities than positions.
    pub sensors: Vec<SensorEvidence>,
    /// Names of the model's states.
    pub state_names: Vec<String>,
    /// Values of the model's states as `states[sample][state]`, SI.
    pub states: Vec<Vec<f64>>,
    /// Names of the model's auxiliary variables; vectors are given by component.
    pub quantity_names: Vec<String>,
    /// Values of the model's auxiliary variables as `quantities[sample][quantity]`, SI.
    pub quantities: Vec<Vec<f64>>,
    /// Names of the inputs that vary during the flight.
    pub input_names: Vec<String>,
    /// Their units.
    pub input_units: Vec<String>,
    /// Their recorded values as `inputs[sample][input]`, SI.
    pub inputs: Vec<Vec<f64>>,
}

/// Measured values and residuals of one sensor channel, which does not measure a position, in the unit of the channel.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SensorEvidence {
    /// Name of the sensor.
    pub name: String,
    /// Index of the channel in the estimation problem.
    pub channel: usize,
    /// Unit of a component: `rad` for an attitude, otherwise the unit of the instrument.
    pub unit: String,
    /// Number of components of the measured quantity; the value of a scalar is repeated three times in the arrays.
    pub components: usize,
    /// Measured value by sample, in `unit`; for an attitude, the rotation vector from body to inertial components. A
    /// scalar is repeated three times.
    pub measured: Vec<Option<[f64; 3]>>,
    /// Whether the measured value is excluded as an outlier, by sample.
    pub outlier: Vec<bool>,
    /// Residual by sample, measured − predicted, in `unit`; for an attitude, the rotation vector from predicted to
    /// measured, inertial. Outliers are included.
    pub residuals: Vec<Option<[f64; 3]>>,
}

impl FlightEvidence {
    /// Residual of a position, measured − predicted, m; `None` if missing or an outlier. `marker` is an index into
    /// `markers`.
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
    /// Autocorrelation of the whitened residuals; if they are white, within ±`band` for lags above 0.
    pub whitened_autocorrelation: Vec<f64>,
    /// 95 % band of the autocorrelation of white residuals: 1.96 / √(number of residuals).
    pub band: f64,
    /// Points of a Q–Q plot: pairs (normal quantile, quantile of the normalised whitened residuals).
    pub quantiles: Vec<[f64; 2]>,
}
