//! What a fit found, as `report.json` has it.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::dataset::Role;

/// `report.json` of a fit, schema `hyzer.fit/1`.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// `hyzer.fit/1`.
    pub schema: &'static str,
    /// Name of the model.
    pub model: String,
    /// Root of the mean squared residual of one coordinate over the fitted flights, m.
    pub rms_m: f64,
    /// What is assumed of the noise.
    pub noise: Noise,
    /// The coefficients, by name.
    pub coefficients: BTreeMap<String, Coefficient>,
    /// Correlations of the coefficients, by name and name.
    pub correlations: BTreeMap<String, BTreeMap<String, f64>>,
    /// Every flight, in the dataset's order.
    pub flights: Vec<FlightReport>,
    /// Combinations of coefficients that the flights do not determine.
    pub undetermined: Vec<Undetermined>,
    /// Steps of the iteration, and whether it converged.
    pub iterations: Iterations,
    /// Time taken, s.
    pub seconds: BTreeMap<String, f64>,
}

/// What is assumed of the noise: here, that it is white and the same in every coordinate.
#[derive(Clone, Debug, Serialize)]
pub struct Noise {
    /// Standard deviation of one coordinate, m: given by the dataset, or estimated from the residuals.
    pub sigma_m: f64,
    /// Whether it was estimated.
    pub estimated: bool,
    /// `white`.
    pub kind: &'static str,
}

/// One coefficient.
#[derive(Clone, Debug, Serialize)]
pub struct Coefficient {
    /// Its value, SI.
    pub value: f64,
    /// Its standard error under the noise assumed, SI.
    pub std_error: f64,
    /// Its unit.
    pub unit: String,
    /// Whether it rests on a bound.
    pub at_bound: bool,
}

/// One flight.
#[derive(Clone, Debug, Serialize)]
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
    /// Its initial state, by name.
    pub initial: BTreeMap<String, Estimate>,
}

/// A number with its standard error.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Estimate {
    /// Value, SI.
    pub value: f64,
    /// Standard error, SI.
    pub std_error: f64,
}

/// What the flights do not determine.
#[derive(Clone, Debug, Serialize)]
pub struct Undetermined {
    /// Which coefficients.
    pub combination: Vec<String>,
    /// Why.
    pub why: String,
}

/// How the iteration went.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Iterations {
    /// Steps tried.
    pub steps: usize,
    /// Whether the last ones were negligible.
    pub converged: bool,
}
