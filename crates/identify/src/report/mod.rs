//! What a fit found: [`FitReport`] is `report.json`, [`FlightEvidence`] is what figures are drawn from.

mod evidence;
pub(crate) mod residuals;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

pub use evidence::{AxisResiduals, FlightEvidence};

use crate::dataset::Role;

/// `report.json` of a fit, schema `hyzer.fit/1`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FitReport {
    /// `hyzer.fit/1`.
    pub schema: String,
    /// Name of the model.
    pub model: String,
    /// Effects that were switched on.
    pub effects: Vec<String>,
    /// Root of the mean squared residual of one coordinate over the fitted flights, outliers left out, m.
    pub rms_m: f64,
    /// What was found of the noise.
    pub noise: NoiseReport,
    /// What was estimated for all flights together, by name: the coefficients, and parameters that were freed.
    pub coefficients: BTreeMap<String, Coefficient>,
    /// Their correlations, by name and name.
    pub correlations: BTreeMap<String, BTreeMap<String, f64>>,
    /// Every flight, in the dataset's order.
    pub flights: Vec<FlightReport>,
    /// Coefficients and combinations of them that the flights do not determine, the least determined first.
    pub undetermined: Vec<NonIdentifiable>,
    /// Profiles of the likelihood, where they were asked for.
    pub profiles: Vec<Profile>,
    /// Residuals along each axis: `x`, `y`, `z`.
    pub residuals: BTreeMap<String, AxisResiduals>,
    /// Steps of the iteration, and whether it converged.
    pub iterations: Iterations,
    /// Time taken, s, by what it was taken for; `total` is all of it.
    pub seconds: BTreeMap<String, f64>,
}

/// The noise of the measured coordinates: along each axis a stationary first-order process.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NoiseReport {
    /// Standard deviation of one coordinate, over all axes, m: given by the dataset, or estimated.
    pub sigma_m: f64,
    /// First-order correlation between neighbouring samples, over all axes.
    pub ar1: f64,
    /// Whether `sigma_m` was estimated.
    pub estimated: bool,
    /// Each axis: `x`, `y`, `z`.
    pub axes: BTreeMap<String, AxisNoise>,
    /// The time between neighbouring samples that `ar1` holds for, s.
    pub interval_s: f64,
    /// Points (of a marker, at a time) that were measured in the fitted flights.
    pub points: usize,
    /// Points among them that were taken for outliers and left out.
    pub outliers: usize,
    /// `outliers / points`.
    pub outlier_fraction: f64,
    /// Points that were not seen.
    pub dropouts: usize,
}

/// The noise along one axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct AxisNoise {
    /// Standard deviation, m.
    pub sigma_m: f64,
    /// First-order correlation between neighbouring samples.
    pub ar1: f64,
}

/// One coefficient, or a parameter that was freed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Coefficient {
    /// Its value, SI.
    pub value: f64,
    /// Its standard error under the noise that was found, SI; 0 where it was held.
    pub std_error: f64,
    /// Its standard error from the scatter of the flights alone, whatever their noise; none for fewer than 8 flights.
    pub std_error_clustered: Option<f64>,
    /// Interval that holds the true value with a probability of 95 %, SI.
    pub interval: [f64; 2],
    /// Its unit.
    pub unit: String,
    /// Whether it rests on a bound.
    pub at_bound: bool,
    /// Whether it was held at its value.
    pub held: bool,
    /// What the model's file says, SI.
    pub model_value: f64,
    /// Value and standard deviation of the prior, SI, where one was given.
    pub prior: Option<[f64; 2]>,
}

/// One flight.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FlightReport {
    /// Its file.
    pub file: String,
    /// Whether it was fitted or held out.
    pub role: Role,
    /// Samples in its table.
    pub samples: usize,
    /// Root of the mean squared residual of one coordinate, m; for a held-out flight with its initial state
    /// fitted on the first 30 % of its samples, over the rest.
    pub rms_m: f64,
    /// Points of it that were taken for outliers.
    pub outliers: usize,
    /// Its initial state, by name.
    pub initial: BTreeMap<String, Estimate>,
    /// Where its table was cut, and why.
    pub cut: Option<Truncation>,
    /// What else has to be said of it: why it was left out, how its fit was recovered.
    pub notes: Vec<String>,
}

impl FitReport {
    /// The flights of a role that were not left out, in the dataset's order.
    pub fn used(&self, role: Role) -> impl Iterator<Item = &FlightReport> {
        let flights = self.flights.iter();
        flights.filter(move |flight| flight.role == role && flight.is_used())
    }

    /// The flights that were left out, in the dataset's order.
    pub fn left_out(&self) -> impl Iterator<Item = &FlightReport> {
        self.flights.iter().filter(|flight| !flight.is_used())
    }
}

impl FlightReport {
    /// Whether it was fitted, or predicted where it was held out, and not left out.
    pub fn is_used(&self) -> bool {
        !self.initial.is_empty()
    }
}

/// The end of a flight before the end of its table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Truncation {
    /// Time of the last sample that was used, s, as in the table.
    pub t: f64,
    /// Samples that were not used.
    pub samples: usize,
    /// What the data show there.
    pub why: String,
}

/// A number with its standard error.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// Value, SI.
    pub value: f64,
    /// Standard error, SI; 0 where the value was known.
    pub std_error: f64,
}

/// What the flights do not determine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NonIdentifiable {
    /// Which coefficients.
    pub combination: Vec<String>,
    /// Their parts in the direction that is not determined, each over the size that is usual for it.
    pub weights: BTreeMap<String, f64>,
    /// Standard error along that direction, over the usual size.
    pub relative_error: f64,
    /// Why, in words.
    pub why: String,
}

/// How the likelihood falls off as one coefficient is held and all else is fitted again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Profile {
    /// The coefficient.
    pub name: String,
    /// Value (SI) and deviance: twice the logarithm of the likelihood's ratio to its greatest.
    pub points: Vec<[f64; 2]>,
    /// Where the deviance is 3.84, on either side: the interval of 95 %; none where it was not reached.
    pub interval: [Option<f64>; 2],
}

/// How the iteration went.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Iterations {
    /// Steps tried.
    pub steps: usize,
    /// How often the noise was estimated anew.
    pub rounds: usize,
    /// Whether the last steps were negligible.
    pub converged: bool,
}
