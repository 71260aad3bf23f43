//! The report of a fit. [`FitReport`] is the content of `report.json`; figures are drawn from [`FlightEvidence`].

mod evidence;
mod lack_of_fit;
mod outcome;
mod reliability;
mod residuals;
mod stated;

use std::collections::BTreeMap;
use std::sync::LazyLock;

use serde::{Deserialize, Deserializer, Serialize};

use crate::channel::MARKER;
use crate::observations::Truncation;
use dataset::DataFault;
use dataset::Role;
pub use evidence::{AxisResiduals, FlightEvidence, SensorEvidence};
pub use lack_of_fit::{InputNoise, LackOfFit, MissingTerm, SmoothMisfit};
pub use outcome::Rms;
pub(crate) use outcome::SquareSums;
pub use outcome::{FitStatus, FlightOutcome, Iterations};
pub(crate) use reliability::LACK_OF_FIT_LEVEL;
pub use reliability::{MAX_PRIOR_CONFLICT, convergence_caution, exclusion_caution, input_noise};
pub(crate) use residuals::ResidualPool;
pub use stated::{FarConstant, far_constants};

/// Content of `report.json` of a fit, schema `hyzer.fit/2`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FitReport {
    /// Schema identifier, `hyzer.fit/2`.
    pub schema: String,
    /// Name of the model.
    pub model: String,
    /// Name of the dataset; empty if the caller does not state it.
    pub dataset: String,
    /// Names of the effects that the model includes.
    pub effects: Vec<String>,
    /// Whether the estimates and their standard errors are reliable: no reason in `cautions`.
    pub reliable: bool,
    /// Reasons why the fit is not reliable; empty if it is.
    pub cautions: Vec<String>,
    /// Root mean square residual of one component over the fitted flights by kind of sensor, without outliers: `marker`
    /// for positions, `attitude`, `gyroscope`, `accelerometer`, `speed`.
    pub residual_rms: BTreeMap<String, Rms>,
    /// Measurement noise by kind of sensor, with the keys of `residual_rms`.
    pub noise: BTreeMap<String, NoiseReport>,
    /// Coefficients and other global parameters, keyed by their names.
    pub coefficients: BTreeMap<String, Coefficient>,
    /// Correlation matrix of the estimated global parameters, indexed by the names of two parameters.
    pub correlations: BTreeMap<String, BTreeMap<String, f64>>,
    /// Reports of all flights, in the order of the dataset.
    pub flights: Vec<FlightReport>,
    /// Faults in the data of the flights, in the order of the dataset.
    pub data_faults: Vec<DataFault>,
    /// Pairs of markers whose measured distance differs significantly from the predicted one.
    pub marker_distances: Vec<MarkerDistance>,
    /// Residuals and noise of sensor channels other than markers.
    pub sensors: Vec<SensorReport>,
    /// What the dataset says of its recordings, and what is taken as exact, one sentence each.
    #[doc(hidden)]
    #[serde(default)]
    pub notes: Vec<String>,
    /// Lack-of-fit test of the residuals; `None` if it was not made, or the residuals are too few for it.
    pub lack_of_fit: Option<LackOfFit>,
    /// Combinations of coefficients that are not identifiable, the largest standard error first.
    pub not_identifiable: Vec<NonIdentifiable>,
    /// Sentence that the residuals exceed the noise that the distances between the markers show; `None` if they do not.
    #[serde(skip)]
    #[doc(hidden)]
    pub excess: Option<String>,
    /// Why the recordings leave open which side of the body is up, and what to check; `None` if they show it.
    #[serde(skip)]
    #[doc(hidden)]
    pub open_side: Option<String>,
    /// What the user states and the data contradict, one sentence each.
    #[serde(skip)]
    #[doc(hidden)]
    pub contradicted: Vec<String>,
    /// Instruments whose readings follow the motion only along other axes or at other times, one sentence each.
    #[serde(skip)]
    #[doc(hidden)]
    pub misread: Vec<String>,
    /// Constants that are stated far from the model's values.
    #[serde(skip)]
    #[doc(hidden)]
    pub far_constants: Vec<FarConstant>,
    /// What the fit found against its estimates, one sentence each.
    #[serde(skip)]
    #[doc(hidden)]
    pub doubts: Vec<String>,
    /// Why the rows of summaries leave a doubt whether the model fits them.
    #[serde(skip)]
    #[doc(hidden)]
    pub doubt_of_summaries: Option<String>,
    /// Profile likelihoods that the options request.
    pub profiles: Vec<Profile>,
    /// Residual diagnostics along each axis of the inertial frame, keyed by the names `x`, `y` and `z`.
    pub residuals: BTreeMap<String, AxisResiduals>,
    /// Number of steps and convergence status of the least-squares iterations of the fit.
    pub iterations: Iterations,
    /// Computing times, s: `start` up to the initial guesses, `fit`, `lack_of_fit` of the tests, and `total`.
    pub seconds: BTreeMap<String, f64>,
}

/// Two markers of a rigid body whose measured distance differs from the predicted one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MarkerDistance {
    /// Names of the two markers.
    pub markers: [String; 2],
    /// Measured − predicted distance, mean over the samples of all flights, m.
    pub difference_m: f64,
    /// Standard error of `difference_m`, m.
    pub std_error_m: f64,
}

/// Residuals and noise of one channel of a sensor, in the unit of the channel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SensorReport {
    /// Name of the sensor.
    pub name: String,
    /// Quantity that the channel measures: `position`, `attitude`, `gyroscope`, `accelerometer` or `speed`.
    pub measures: String,
    /// Unit of one component of the measured quantity.
    pub unit: String,
    /// Root mean square residual of one component over the fitted flights, without outliers, in `unit`.
    pub rms: f64,
    /// Root mean square of the noise standard deviations, in `unit`; given or estimated.
    pub sigma: f64,
    /// Lag-1 autocorrelation of the noise, mean over the components.
    pub lag1_autocorrelation: f64,
    /// Number of measured values in the fitted flights, including outliers.
    pub points: usize,
    /// Number of measured values in the fitted flights that are excluded as outliers.
    pub outliers: usize,
}

/// Noise of the measurements of one kind of sensor: a stationary AR(1) process along each axis.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct NoiseReport {
    /// Root mean square of the standard deviations along the axes, in `unit`; given by the dataset or estimated.
    pub sigma: f64,
    /// Unit of the measured quantity.
    pub unit: String,
    /// Lag-1 autocorrelation of the noise, mean over the axes.
    pub lag1_autocorrelation: f64,
    /// Whether `sigma` was estimated; `false` if the dataset gives it.
    pub estimated: bool,
    /// Noise along each axis, keyed by the names `x`, `y` and `z`; empty for sensors other than markers and poses.
    pub axes: BTreeMap<String, AxisNoise>,
    /// Time between samples to which `lag1_autocorrelation` refers, s.
    pub interval_s: f64,
    /// Number of measured values (for markers: positions) in the fitted flights, including outliers.
    pub points: usize,
    /// Number of measured values in the fitted flights that are excluded as outliers.
    pub outliers: usize,
    /// Fraction of measured values excluded as outliers: `outliers / points`.
    pub outlier_fraction: f64,
    /// Number of missing values (for markers: positions) in the fitted flights.
    pub missing: usize,
    /// Root mean square over the axes of the noise that is estimated without a model, m: from the scatter about smooth
    /// curves, an underestimate of correlated noise, or from rigidity. `None` if the samples do not determine it.
    pub floor: Option<f64>,
}

/// Measurement noise along one axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct AxisNoise {
    /// Standard deviation of the noise, in the unit of the measured quantity.
    pub sigma: f64,
    /// Lag-1 autocorrelation of the noise.
    pub lag1_autocorrelation: f64,
}

/// Estimate of a coefficient or another global parameter.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Coefficient {
    /// Estimated value, or the fixed value if `fixed`, SI.
    pub value: f64,
    /// Cramér–Rao standard error, SI; 0 if fixed, NaN (`null` in JSON) at a bound.
    #[serde(deserialize_with = "number_or_null")]
    pub std_error: f64,
    /// Cluster-robust standard error by flight, SI; `None` for fewer than 8 flights or a fixed parameter.
    pub std_error_cluster_robust: Option<f64>,
    /// 95 % confidence interval (lower, upper limit), SI; NaN without a standard error.
    #[serde(deserialize_with = "numbers_or_null")]
    pub interval: [f64; 2],
    /// Unit as written in the model.
    pub unit: String,
    /// Whether the estimate is at a bound of the parameter.
    pub at_bound: bool,
    /// Whether the parameter is fixed and not estimated.
    pub fixed: bool,
    /// Initial value of the parameter in the fit, SI: from the prior, the dataset or the model.
    pub model_value: f64,
    /// Mean and standard deviation of the prior, SI; `None` without a prior.
    pub prior: Option<[f64; 2]>,
}

/// Results of a fit for one flight: residuals, initial state, truncation and remarks.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FlightReport {
    /// File name of the flight.
    pub file: String,
    /// Whether the dataset assigns the flight to the fit or to the held-out flights.
    pub role: Role,
    /// Whether the flight was fitted, predicted or excluded.
    #[serde(flatten)]
    pub outcome: FlightOutcome,
    /// Number of samples in the table of the flight, not counting those after the truncation `cut`.
    pub samples: usize,
    /// Root mean square residual by kind of sensor, as in [`FitReport::residual_rms`]; for a held-out flight, of the
    /// samples after its conditioning segment. Empty if the flight is excluded.
    pub residual_rms: BTreeMap<String, Rms>,
    /// Number of measured values of the flight that are excluded as outliers.
    pub outliers: usize,
    /// Estimated initial state, keyed by the names of the states; empty if the flight is excluded.
    pub initial: BTreeMap<String, Estimate>,
    /// Time and reason of the truncation of the flight; `None` if it was not truncated.
    pub cut: Option<Truncation>,
    /// Remarks on the flight, such as the reason for its exclusion or a repeated fit.
    pub notes: Vec<String>,
    /// Whether the flight is a summary.
    #[doc(hidden)]
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub is_summary: bool,
    /// For a summary, what was seen of the flight beside what the model predicts; of a held-out one, after the release.
    #[doc(hidden)]
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub seen: Vec<SeenValue>,
}

/// A value of a summary beside its prediction.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SeenValue {
    /// Header of the column.
    pub name: String,
    /// Quantity, such as `carry`.
    pub measures: String,
    /// Unit of the values.
    pub unit: String,
    /// Measured value, in `unit`.
    pub measured: f64,
    /// Predicted value, in `unit`.
    pub predicted: f64,
    /// Standard deviation of the noise, in `unit`; given or estimated.
    pub sigma: f64,
}

/// Noise of the measured positions among the kinds of sensors of `noise`; without positions, that of the first kind.
pub fn leading_noise(noise: &BTreeMap<String, NoiseReport>) -> &NoiseReport {
    static NONE: LazyLock<NoiseReport> = LazyLock::new(|| NoiseReport {
        sigma: f64::NAN,
        lag1_autocorrelation: f64::NAN,
        interval_s: f64::NAN,
        ..NoiseReport::default()
    });
    outcome::leading(noise).unwrap_or(&NONE)
}

/// Reads a number, or `null` as NaN, which JSON does not have.
fn number_or_null<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    Ok(Option::deserialize(from)?.unwrap_or(f64::NAN))
}

fn numbers_or_null<'de, D: Deserializer<'de>>(from: D) -> Result<[f64; 2], D::Error> {
    let numbers = <[Option<f64>; 2]>::deserialize(from)?;
    Ok(numbers.map(|number| number.unwrap_or(f64::NAN)))
}

impl FitReport {
    /// Root mean square residual of a position coordinate, m; without positions, of the first kind of sensor.
    pub fn rms(&self) -> f64 {
        outcome::leading(&self.residual_rms).map_or(f64::NAN, |rms| rms.value)
    }

    /// [`rms`](Self::rms) with its unit, in words; `–` if there is none.
    #[doc(hidden)]
    pub fn rms_text(&self) -> String {
        outcome::text(&self.residual_rms)
    }

    /// Root mean square residual of a coordinate of the measured positions, m; `None` where no positions are measured.
    pub(crate) fn position_rms(&self) -> Option<f64> {
        self.residual_rms.get(MARKER).map(|rms| rms.value)
    }

    /// Noise of the measured positions; without positions, that of the first kind of sensor in `noise`.
    #[doc(hidden)]
    pub fn leading_noise(&self) -> &NoiseReport {
        leading_noise(&self.noise)
    }

    /// Noise of the measured positions; `None` where no positions are measured.
    #[doc(hidden)]
    pub fn position_noise(&self) -> Option<&NoiseReport> {
        self.noise.get(MARKER)
    }

    /// Flights with the role `role` (to be fitted, or held out) that are not excluded, in the order of the dataset.
    pub fn used(&self, role: Role) -> impl Iterator<Item = &FlightReport> {
        let flights = self.flights.iter();
        flights.filter(move |flight| flight.role == role && flight.is_used())
    }

    /// Excluded flights, in the order of the dataset.
    pub fn excluded(&self) -> impl Iterator<Item = &FlightReport> {
        self.flights.iter().filter(|flight| !flight.is_used())
    }
}

impl FlightReport {
    /// Whether the flight was fitted or predicted; `false` if it was excluded.
    pub fn is_used(&self) -> bool {
        !matches!(self.outcome, FlightOutcome::Excluded { .. })
    }

    /// Root mean square residual of a position coordinate, m; `None` without positions or if excluded.
    pub fn position_rms(&self) -> Option<f64> {
        self.residual_rms.get(MARKER).map(|rms| rms.value)
    }

    /// Root mean square residual of a position coordinate, m, or of the first kind of sensor; NaN if excluded.
    pub fn rms(&self) -> f64 {
        outcome::leading(&self.residual_rms).map_or(f64::NAN, |rms| rms.value)
    }

    /// [`rms`](Self::rms), or of a summary the root mean square residual in units of the noise.
    pub(crate) fn misfit(&self) -> f64 {
        self.mean_square_by_noise_of(self)
            .map_or_else(|| self.rms(), f64::sqrt)
    }

    /// Mean squared residual of a summary, each value in units of the noise that it has in `other`, a report of the same
    /// flight; `None` for a track.
    #[doc(hidden)]
    pub fn mean_square_by_noise_of(&self, other: &FlightReport) -> Option<f64> {
        let pairs = self.seen.iter().filter_map(|own| {
            let same = other.seen.iter().find(|same| same.name == own.name)?;
            Some(((own.predicted - own.measured) / same.sigma).powi(2))
        });
        let squares: Vec<f64> = pairs.collect();
        (!squares.is_empty()).then(|| squares.iter().sum::<f64>() / squares.len() as f64)
    }

    /// [`rms`](Self::rms) with its unit, in words; `–` if there is none.
    #[doc(hidden)]
    pub fn rms_text(&self) -> String {
        outcome::text(&self.residual_rms)
    }
}

/// Estimated value with its standard error.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// Estimated value, SI.
    pub value: f64,
    /// Standard error, SI; 0 if the value is known.
    pub std_error: f64,
}

/// A direction in the space of the global parameters along which the data practically do not determine the estimates.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NonIdentifiable {
    /// Names of the parameters with large components, the largest first.
    pub combination: Vec<String>,
    /// Large components, in units of the parameter's typical magnitude, by name.
    pub weights: BTreeMap<String, f64>,
    /// Standard error along the non-identifiable direction, in units of the parameters' typical magnitudes.
    pub relative_error: f64,
    /// Explanation of the non-identifiability, as text.
    pub reason: String,
}

/// Profile likelihood of one global parameter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Profile {
    /// Name of the parameter.
    pub name: String,
    /// Points (value in SI, deviance): twice the log ratio of the maximum to the profile likelihood.
    pub points: Vec<[f64; 2]>,
    /// 95 % interval, SI; `None` on a side where the deviance does not reach 3.84.
    pub interval: [Option<f64>; 2],
}
