//! Result of the lack-of-fit test.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::noise::NoiseModel;
use crate::numbers::{millimetres, probability, significant};

/// Result of the lack-of-fit test, which compares residuals with noise: changes too fast for any smooth motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LackOfFit {
    /// Familywise p-value of the joint test of all flights and the tests of the single flights.
    pub p_value: f64,
    /// p-value of the lack-of-fit test of each fitted flight, by file name.
    pub flights: BTreeMap<String, f64>,
    /// Largest smooth deviation of the most significant flights, smallest p-value first; empty if the test passes.
    pub largest_misfits: Vec<SmoothMisfit>,
    /// Most significant term that a coefficient or an equation of motion lacks; `None` if the residuals are not noise, or
    /// no term can be tested.
    pub missing_term: Option<MissingTerm>,
    /// Noise of a recorded input that may be what the residuals show; `None` if the test passes, or no input is that noisy.
    pub input_noise: Option<InputNoise>,
    /// Standard deviation of the noise of one coordinate, m, estimated from changes that no smooth motion can follow.
    pub noise_m: f64,
    /// Root mean square of the residuals in excess of the noise, m; 0 if they are smaller.
    pub beyond_noise_m: f64,
    /// Sum of squares that splines remove from the residuals over the noise variance, less its expectation for noise:
    /// the larger of those for slow and for fast deviations, at least 0.
    #[doc(hidden)]
    #[serde(skip)]
    pub excess_chi2: f64,
    /// Whether positions alone are measured. Other residuals have no length, and are stated relative to the noise.
    #[doc(hidden)]
    #[serde(skip)]
    pub has_length: bool,
    /// Estimated noise model: the noise floor of the residuals.
    #[doc(hidden)]
    #[serde(skip, default = "no_noise")]
    pub noise: NoiseModel,
}

fn no_noise() -> NoiseModel {
    NoiseModel::white(0.0, 1.0)
}

/// Noise of a recorded input, which no weight of a residual and no standard error counts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct InputNoise {
    /// Name of the input.
    pub input: String,
    /// Standard deviation of the noise by the differences of the samples, in the unit of the input.
    pub sigma: f64,
    /// Root mean square of what it adds to the residuals, in units of the noise of the measurements.
    pub effect: f64,
}

impl InputNoise {
    /// Sentence on the noise and its effect.
    pub fn sentence(&self) -> String {
        format!(
            "the recorded input {} has noise of {}, which moves the predictions by {} times the noise of the measurements: what the model lacks cannot be told from that",
            self.input,
            significant(self.sigma, 2),
            significant(self.effect, 2)
        )
    }
}

/// Test whether the residuals fit better with a further term of a coefficient or an equation of motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MissingTerm {
    /// Name of the coefficient that is not constant, or `der(x)` for the rate of a state x that has a further term.
    pub target: String,
    /// Name of the quantity that the term follows: a scalar quantity or a state of the model, or `time` since the start of
    /// the flight; `None` for a constant term of a rate.
    pub changes_with: Option<String>,
    /// Number of terms that were tested.
    pub tests: usize,
    /// p-value of all score tests together.
    pub p_value: f64,
}

impl MissingTerm {
    /// Sentence on the result of the test.
    pub fn sentence(&self) -> String {
        let target = &self.target;
        let is_rate = target.starts_with("der(");
        let finding = match &self.changes_with {
            None => format!("{target} lacks a constant term"),
            Some(quantity) if is_rate => {
                format!("{target} lacks a term that changes with {quantity}")
            }
            Some(quantity) => format!("{target} is not constant: it changes with {quantity}"),
        };
        format!(
            "{finding} (score tests of {} terms, p = {}).",
            self.tests,
            probability(self.p_value)
        )
    }
}

/// The largest smooth deviation of a flight's measurements from the fitted model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SmoothMisfit {
    /// File name of the flight.
    pub file: String,
    /// Measured coordinate, as the column name of the flight's table: marker or sensor and axis, such as `m1_z`.
    pub coordinate: String,
    /// Start of the interval in which the deviation exceeds half its maximum, s after the first sample.
    pub from_s: f64,
    /// End of the interval in which the deviation exceeds half its maximum, s after the first sample.
    pub to_s: f64,
    /// Maximum of the smooth deviation, measured − predicted, with sign, in `unit`.
    pub size_m: f64,
    /// Unit of the deviation; `m` for positions.
    pub unit: String,
    /// p-value of the lack-of-fit test of this flight alone.
    pub p_value: f64,
}

impl LackOfFit {
    /// Whether the residuals are not noise, at the significance level `alpha`.
    pub fn fails(&self, alpha: f64) -> bool {
        self.p_value < alpha
    }

    /// Sentence on the result of the test.
    pub fn sentence(&self) -> String {
        let p = probability(self.p_value);
        if !self.largest_misfits.is_empty() {
            let beyond = self.beyond_noise();
            return format!(
                "The residuals are not noise (lack-of-fit test, p = {p}): {beyond} remain."
            );
        }
        let noise = if self.has_length {
            format!("noise of {}", millimetres(self.noise_m))
        } else {
            "the noise".to_owned()
        };
        format!("The residuals are compatible with {noise} (lack-of-fit test, p = {p}).")
    }

    /// The residuals in excess of the noise, in words.
    #[doc(hidden)]
    pub fn beyond_noise(&self) -> String {
        if self.has_length {
            let [beyond, noise] = [self.beyond_noise_m, self.noise_m].map(millimetres);
            format!("{beyond} rms beyond the noise of {noise}")
        } else {
            let ratio = self.beyond_noise_m / self.noise_m;
            format!(
                "rms residuals of {} times the noise, beyond it,",
                significant(ratio, 2)
            )
        }
    }
}
