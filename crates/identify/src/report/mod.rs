//! The report of a fit: [`FitReport`] is `report.json`; figures are drawn from [`FlightEvidence`].

mod evidence;
mod outcome;
mod reliability;
mod residuals;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

pub use evidence::{AxisResiduals, FlightEvidence, SensorEvidence};
pub use outcome::{FitStatus, FlightOutcome, Iterations};
pub(crate) use reliability::reasons_against;
pub(crate) use residuals::ResidualPool;

use crate::dataset::Role;
use crate::screening::DataFault;

/// `report.json` of a fit, schema `hyzer.fit/1`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FitReport {
    /// Schema identifier, `hyzer.fit/1`.
    pub schema: String,
    /// Name of the model.
    pub model: String,
    /// Effects that the model includes.
    pub effects: Vec<String>,
    /// Whether the estimates and their standard errors can be relied on.
    pub reliable: bool,
    /// Reasons why they cannot; empty if they can.
    pub why: Vec<String>,
    /// Root mean square residual of one coordinate over the fitted flights, outliers excluded, m. Without measured positions:
    /// that of all sensors, each over its noise, times the millimetre.
    pub rms_m: f64,
    /// Whether positions of the body are measured, by markers or poses.
    #[serde(default = "yes")]
    pub sees_positions: bool,
    /// Estimated noise.
    pub noise: NoiseReport,
    /// Coefficients, and other global parameters, by name.
    pub coefficients: BTreeMap<String, Coefficient>,
    /// Correlations of the estimated global parameters, by name and name.
    pub correlations: BTreeMap<String, BTreeMap<String, f64>>,
    /// Every flight, in the dataset's order.
    pub flights: Vec<FlightReport>,
    /// Mistakes in the data of the flights, in the dataset's order.
    #[serde(default)]
    pub data_faults: Vec<DataFault>,
    /// Pairs of markers whose measured distance differs from the predicted one.
    #[serde(default)]
    pub marker_distances: Vec<MarkerDistance>,
    /// Channels of sensors other than markers.
    #[serde(default)]
    pub sensors: Vec<SensorReport>,
    /// Non-identifiable coefficients and combinations, the least determined first.
    pub undetermined: Vec<NonIdentifiable>,
    /// Profile likelihoods that the options ask for.
    pub profiles: Vec<Profile>,
    /// Residual diagnostics along each axis: `x`, `y`, `z`.
    pub residuals: BTreeMap<String, AxisResiduals>,
    /// Steps of the iteration and its status.
    pub iterations: Iterations,
    /// Computing time by stage, s; `total` is that of all stages.
    pub seconds: BTreeMap<String, f64>,
}

fn yes() -> bool {
    true
}

/// Distance between two markers of a rigid body, where it is not as predicted.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MarkerDistance {
    /// Names of the markers.
    pub markers: [String; 2],
    /// Mean measured less predicted distance, m.
    pub difference_m: f64,
    /// Standard error of `difference_m`, m.
    pub std_error_m: f64,
}

/// Residuals and noise of one channel of a sensor, in its own unit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SensorReport {
    /// Name of the sensor.
    pub name: String,
    /// What the channel measures: `position`, `attitude`, `gyroscope`, `accelerometer` or `speed`.
    pub measures: String,
    /// Unit of a component.
    pub unit: String,
    /// Root mean square residual of a component over the fitted flights, outliers excluded.
    pub rms: f64,
    /// Root mean square of the components' standard deviations: stated by the dataset, or estimated.
    pub sigma: f64,
    /// Lag-1 autocorrelation, mean of the components.
    pub ar1: f64,
    /// Number of values.
    pub points: usize,
    /// Number of values excluded as outliers.
    pub outliers: usize,
}

/// Noise of the measured coordinates: a stationary AR(1) process along each axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NoiseReport {
    /// Root mean square of the axes' standard deviations, m: given by the dataset, or estimated.
    pub sigma_m: f64,
    /// Lag-1 autocorrelation, mean of the axes.
    pub ar1: f64,
    /// Whether `sigma_m` was estimated.
    pub estimated: bool,
    /// Noise along each axis: `x`, `y`, `z`.
    pub axes: BTreeMap<String, AxisNoise>,
    /// Time between samples to which `ar1` refers, s.
    pub interval_s: f64,
    /// Number of measured points (marker positions) in the fitted flights.
    pub points: usize,
    /// Number of points excluded as outliers.
    pub outliers: usize,
    /// Fraction of points excluded as outliers: `outliers / points`.
    pub outlier_fraction: f64,
    /// Number of missing points.
    pub dropouts: usize,
    /// Root mean square of the axes' standard deviations by a smoother that knows no model, m; correlated noise lies above
    /// it. With too few samples for a smoother, by the rigidity of the markers. `None` if the samples do not determine it.
    pub floor_m: Option<f64>,
}

/// Noise along one axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct AxisNoise {
    /// Standard deviation, m.
    pub sigma_m: f64,
    /// Lag-1 autocorrelation.
    pub ar1: f64,
}

/// A coefficient or another global parameter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Coefficient {
    /// Estimate, or the value at which it is fixed, SI.
    pub value: f64,
    /// Cramér–Rao standard error under the estimated noise, SI; 0 if fixed.
    pub std_error: f64,
    /// Cluster-robust standard error by flight, SI; `None` for fewer than 8 flights.
    pub std_error_clustered: Option<f64>,
    /// 95 % confidence interval, SI.
    pub interval: [f64; 2],
    /// Unit as the model writes it.
    pub unit: String,
    /// Whether the estimate is at a bound.
    pub at_bound: bool,
    /// Whether the parameter is fixed instead of estimated.
    pub held: bool,
    /// Initial value, SI: from the prior, the dataset or the model.
    pub model_value: f64,
    /// Mean and standard deviation of the prior, SI.
    pub prior: Option<[f64; 2]>,
}

/// Report of one flight.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FlightReport {
    /// File name of the flight.
    pub file: String,
    /// Whether the dataset assigns it to the fit or holds it out.
    pub role: Role,
    /// Whether the flight was fitted, predicted or excluded.
    #[serde(flatten)]
    pub outcome: FlightOutcome,
    /// Number of samples in the flight's table, without those dropped by `cut`.
    pub samples: usize,
    /// Root mean square residual of one coordinate, m; for a held-out flight over the samples after the conditioning
    /// segment. None if excluded.
    pub rms_m: Option<f64>,
    /// Number of the flight's points that are excluded as outliers.
    pub outliers: usize,
    /// Initial state by name; empty if excluded.
    pub initial: BTreeMap<String, Estimate>,
    /// Where and why the flight's samples were truncated; `None` if they were not.
    pub cut: Option<Truncation>,
    /// Messages about the flight, such as the reason for its exclusion or a repeated fit.
    pub notes: Vec<String>,
}

impl FitReport {
    /// Flights of a role that are not excluded, in the dataset's order.
    pub fn used(&self, role: Role) -> impl Iterator<Item = &FlightReport> {
        let flights = self.flights.iter();
        flights.filter(move |flight| flight.role == role && flight.is_used())
    }

    /// Excluded flights, in the dataset's order.
    pub fn excluded(&self) -> impl Iterator<Item = &FlightReport> {
        self.flights.iter().filter(|flight| !flight.is_used())
    }
}

impl FlightReport {
    /// Whether the flight was fitted or predicted, and not excluded.
    pub fn is_used(&self) -> bool {
        !matches!(self.outcome, FlightOutcome::Excluded { .. })
    }

    /// Root mean square residual of one coordinate, m; not a number if the flight is excluded.
    pub fn rms(&self) -> f64 {
        self.rms_m.unwrap_or(f64::NAN)
    }
}

/// Truncation of a flight before the end of its table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Truncation {
    /// Time of the last sample that was used, s, as in the table.
    pub t: f64,
    /// Number of samples dropped after that time.
    pub samples: usize,
    /// Reason for the truncation.
    pub why: String,
}

/// An estimate with its standard error.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// Value, SI.
    pub value: f64,
    /// Standard error, SI; 0 if the value is known.
    pub std_error: f64,
}

/// A practically non-identifiable direction of the global parameters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NonIdentifiable {
    /// Names of the coefficients in the direction.
    pub combination: Vec<String>,
    /// Components of the direction by coefficient, each in units of its typical magnitude.
    pub weights: BTreeMap<String, f64>,
    /// Standard error along the direction, in units of the typical magnitudes.
    pub relative_error: f64,
    /// Explanation in words.
    pub why: String,
}

/// Profile likelihood of one coefficient.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Profile {
    /// The coefficient.
    pub name: String,
    /// Points (value, SI; deviance: twice the log of the ratio of the greatest likelihood to that at the value).
    pub points: Vec<[f64; 2]>,
    /// 95 % interval: values on either side where the deviance is 3.84, SI; `None` on a side where it is not reached.
    pub interval: [Option<f64>; 2],
}
