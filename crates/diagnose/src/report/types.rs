//! `report.json` of a diagnosis.

use std::collections::BTreeMap;

use identify::DataFault;
use identify::dataset::Role;
use serde::{Deserialize, Serialize};

use super::curves::CoefficientCurve;
use crate::lack_of_fit::LackOfFit;
use crate::noise::LoadHistory;
use crate::optimal_design::NextThrow;
use crate::power::{MinDetectableEffect, NotIdentifiable};
use crate::selection::StepwiseTerm;
use crate::validation::PredictiveGain;

/// `report.json` of a diagnosis, schema `hyzer.diagnosis/1`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// Schema identifier, `hyzer.diagnosis/1`.
    pub schema: String,
    /// Name of the dataset.
    pub dataset: String,
    /// Name of the model.
    pub model: String,
    /// Effects that were switched on in the model under test.
    pub effects: Vec<String>,
    /// Verdict of the diagnosis.
    pub verdict: Verdict,
    /// Summary in one paragraph.
    pub summary: String,
    /// Model confidence set: every explanation that the data do not reject, the best first.
    pub causes: Vec<Cause>,
    /// Noise of the measured coordinates.
    pub noise: NoiseSummary,
    /// Out-of-sample gain of the extension; none if nothing is extended or no flight can be predicted.
    pub gain: Option<PredictiveGain>,
    /// Coefficients of the extended model, or of the model if nothing is extended.
    pub coefficients: BTreeMap<String, Coefficient>,
    /// Candidate effects that these flights cannot identify.
    pub undetectable: Vec<NotIdentifiable>,
    /// Minimum detectable effects, power 0.9.
    pub smallest_detectable: Vec<MinDetectableEffect>,
    /// The throw that would best discriminate between the accepted explanations.
    pub next_throw: Option<NextThrow>,
    /// File of the extended model, in the folder of the report.
    pub extended_model: Option<String>,
    /// Computing time by stage, s; `total` is the sum.
    pub seconds: BTreeMap<String, f64>,
    /// Score test of each candidate effect, the least p-value first.
    pub candidates: Vec<CandidateTest>,
    /// Threshold of significance.
    pub threshold: Threshold,
    /// Correlations of the candidates' effective scores.
    #[serde(rename = "alike")]
    pub score_correlations: ScoreCorrelations,
    /// Mistakes in the data of the flights, in the dataset's order.
    #[serde(default)]
    pub data_faults: Vec<DataFault>,
    /// Residuals of each flight, without and with the extension.
    pub flights: Vec<FlightGain>,
    /// Coefficients of the model over angle of attack or speed, without and with the extension.
    pub curves: Vec<CoefficientCurve>,
    /// Lack of fit that no candidate effect explains.
    #[serde(rename = "outside")]
    pub unattributed: Option<Unattributed>,
    /// Agreement of the flights, where the causes do not explain all.
    #[serde(rename = "agreement")]
    pub consensus: Option<Consensus>,
    /// Test of the residuals of the answer; none if they are too few to tell noise from motion. A verdict
    /// [`Verdict::None`] needs it to pass.
    #[serde(default)]
    pub lack_of_fit: Option<LackOfFit>,
    /// Verification of the extended model.
    pub verified: Option<Verified>,
    /// Whether every fit converged.
    #[serde(default = "converged_by_default")]
    pub converged: bool,
    /// Whether the search was completed; otherwise this is the best answer until its time or its steps were used up.
    #[serde(default = "converged_by_default")]
    pub complete: bool,
    /// Messages on limitations of the result.
    pub notes: Vec<String>,
}

/// Reports written before `converged` and `complete` were added do not say that something failed to converge.
fn converged_by_default() -> bool {
    true
}

/// Answer of a diagnosis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// No model error is detected, and the residuals are noise.
    None,
    /// One explanation.
    Named,
    /// Several explanations that these flights cannot tell apart.
    Ambiguous,
    /// Lack of fit that no candidate effect explains.
    #[serde(rename = "outside")]
    Unattributed,
    /// A significant but negligible effect: all its estimates are below the smallest effect of interest.
    #[serde(rename = "immaterial")]
    Negligible,
}

/// One explanation: an effect, or several together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cause {
    /// Effects of the explanation.
    pub effects: Vec<CauseEffect>,
    /// Decrease of the weighted sum of squares, χ².
    #[serde(rename = "gain")]
    pub chi2_decrease: f64,
    /// Share of the weighted misfit that any smooth motion could take away, 0 … 1.
    #[serde(default)]
    pub explained: f64,
    /// Root mean square that is left beyond the noise, m.
    #[serde(default)]
    pub remaining_m: f64,
    /// The strongest remaining candidate effect, given this explanation.
    #[serde(rename = "rival")]
    pub strongest_remaining: Option<RemainingEffect>,
}

/// The strongest remaining candidate effect.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RemainingEffect {
    /// Name of the effect.
    pub name: String,
    /// p-value of the effect's score test.
    pub p: f64,
}

/// An effect of an explanation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CauseEffect {
    /// Name of a candidate effect, or of the effect that was written.
    pub name: String,
    /// Description of the effect.
    pub doc: String,
    /// Site of the effect: the load or equation that it changes.
    pub site: String,
    /// Variables on which the effect depends.
    pub variables: Vec<String>,
    /// Estimates of the effect's coefficients; for a state, the RMS over flights.
    pub estimates: BTreeMap<String, Estimate>,
    /// Score statistic of the effect given the model under test, χ².
    pub statistic: f64,
    /// Whether all estimates are below the smallest effect of interest.
    #[serde(rename = "immaterial")]
    pub negligible: bool,
}

/// An estimate with its standard error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// Value, SI.
    pub value: f64,
    /// Standard error, SI.
    pub std_error: f64,
    /// Unit.
    pub unit: String,
    /// Smallest effect size of interest, SI.
    #[serde(rename = "negligible")]
    pub smallest_of_interest: Option<f64>,
}

/// Noise of the measured coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct NoiseSummary {
    /// Standard deviation of one coordinate, m.
    pub sigma_m: f64,
    /// Lag-1 autocorrelation.
    pub ar1: f64,
    /// Fraction of the points that are outliers.
    pub outlier_fraction: f64,
}

/// A coefficient of the extended model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Coefficient {
    /// Value, SI.
    pub value: f64,
    /// Standard error, SI.
    pub std_error: f64,
    /// Unit.
    pub unit: String,
    /// Value without the extension, SI; none if the extension adds the coefficient.
    pub before: Option<f64>,
}

/// Score test of a candidate effect.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CandidateTest {
    /// Name of the effect.
    pub name: String,
    /// Description of the effect.
    pub doc: String,
    /// Site of the effect: the load or equation that it changes.
    pub site: String,
    /// Score statistic, χ² of `dof` under the null hypothesis.
    pub statistic: f64,
    /// Degrees of freedom.
    #[serde(rename = "freedom")]
    pub dof: usize,
    /// Natural logarithm of the p-value.
    pub ln_p: f64,
    /// Equivalent z: the two-sided normal quantile of the p-value.
    #[serde(rename = "sigmas")]
    pub z: f64,
    /// Whether the p-value is below the threshold.
    pub significant: bool,
    /// Tolerance 1 − R²: fraction of the effect's squared sensitivity that no other parameter explains.
    #[serde(rename = "visible")]
    pub tolerance: f64,
    /// One-step estimates of the effect's coefficients, the other effects being absent.
    #[serde(rename = "expected")]
    pub one_step: BTreeMap<String, Estimate>,
}

/// Threshold of significance.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Threshold {
    /// Familywise probability of a false alarm.
    #[serde(rename = "false_alarms")]
    pub alpha: f64,
    /// Greatest significant log p-value of a single test.
    pub ln_p: f64,
    /// Greatest significant p-value of a single test, as an equivalent z.
    #[serde(rename = "sigmas")]
    pub z: f64,
}

/// Correlations of the effective scores of the candidates' coefficients.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ScoreCorrelations {
    /// The coefficients.
    pub names: Vec<String>,
    /// Correlations, row by row.
    pub matrix: Vec<Vec<f64>>,
}

/// A flight without and with the extension.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FlightGain {
    /// File name of the flight.
    pub file: String,
    /// Role of the flight in the dataset.
    pub role: Role,
    /// Use of the flight: `fitted`, `held-out` or `excluded`.
    #[serde(default)]
    pub outcome: Option<String>,
    /// Reason for the exclusion.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// RMS residual of one coordinate without the extension, m; none if the flight was excluded.
    pub rms_before_m: Option<f64>,
    /// RMS residual of one coordinate with the extension, m; `None` if the flight was excluded or the model is not
    /// extended.
    pub rms_after_m: Option<f64>,
}

/// Lack of fit that no candidate effect explains.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Unattributed {
    /// Description of where the lack of fit lies.
    pub says: String,
    /// Loads that the model lacks, channel by channel.
    pub channels: Vec<LoadChannel>,
    /// Library terms, the most significant first.
    pub terms: Vec<StepwiseTerm>,
}

/// Agreement of the flights on causes that do not explain all; what remains differs from flight to flight.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Consensus {
    /// Number of fitted flights that agree.
    pub flights: usize,
    /// Fraction of the flights' excess χ² that the first cause explains; `None` if the cause explains all.
    #[serde(rename = "part")]
    pub explained: Option<f64>,
    /// p-value of the agreement, familywise over all candidates and terms.
    #[serde(rename = "chance")]
    pub p_value: f64,
    /// Files of the discordant fitted flights, which are left out of everything else in the report.
    #[serde(rename = "contradicting")]
    pub discordant: Vec<String>,
}

/// The load of one channel that the model lacks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LoadChannel {
    /// Site of the load: lift, drag, side, roll, pitch or spin.
    pub site: String,
    /// Fraction of the χ² of all terms that this channel's terms alone explain.
    #[serde(rename = "explains")]
    pub explained: f64,
    /// History of the load coefficient in each flight.
    pub histories: Vec<LoadHistory>,
}

/// Verification of the extended model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Verified {
    /// Whether no check refutes the extended model.
    pub holds: bool,
    /// Name and result of each check.
    pub checks: Vec<(String, String)>,
}
