//! Types of the file `report.json` of a diagnosis.

use std::collections::BTreeMap;

use dataset::Role;
use identify::{DataFault, FlightOutcome, NoiseReport, leading_noise};
use serde::{Deserialize, Serialize};

use super::curves::CoefficientCurve;
use crate::noise::LoadHistory;
use crate::optimal_design::ProposedThrow;
use crate::power::{MinDetectableEffect, NotIdentifiable};
use crate::selection::StepwiseTerm;
use crate::validation::PredictiveGain;
use identify::LackOfFit;

/// Contents of the file `report.json` of a diagnosis, schema `hyzer.diagnosis/2`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// Identifier of the schema: `hyzer.diagnosis/2`.
    pub schema: String,
    /// Name of the dataset of measured flights.
    pub dataset: String,
    /// Name of the model under test.
    pub model: String,
    /// Names of the effects that were switched on in the model under test.
    pub effects: Vec<String>,
    /// Whether the result is reliable: no reason in `cautions`.
    pub reliable: bool,
    /// Reasons why the result is not reliable; empty if it is.
    pub cautions: Vec<String>,
    /// Outcome of the diagnosis: whether the model has an error, and whether the missing effects are identified.
    pub verdict: Verdict,
    /// Summary of the result, one paragraph of text.
    pub summary: String,
    /// Model confidence set: every explanation that the data do not reject, the best fit first.
    pub explanations: Vec<Explanation>,
    /// Measurement noise by kind of sensor, as in [`FitReport::noise`](identify::FitReport::noise).
    pub noise: BTreeMap<String, NoiseReport>,
    /// Reduction of the out-of-sample prediction error; `None` if nothing is added or predicted.
    pub predictive_gain: Option<PredictiveGain>,
    /// Coefficients by name: those of the extended model, or of the model under test if it is not extended.
    pub coefficients: BTreeMap<String, Coefficient>,
    /// Candidate effects that these flights cannot identify.
    pub not_identifiable: Vec<NotIdentifiable>,
    /// Minimum detectable sizes of identifiable coefficients, for power 0.9.
    pub minimum_detectable_effects: Vec<MinDetectableEffect>,
    /// Throw that would best distinguish the accepted explanations (`explanations`); `None` if fewer than two are accepted.
    pub proposed_throw: Option<ProposedThrow>,
    /// File name of the extended model, in the folder of the report; `None` if the model is not extended.
    pub extended_model: Option<String>,
    /// Computing time, s, from the start to the end of `fit`, `search` and `total`.
    pub seconds: BTreeMap<String, f64>,
    /// Score test of each candidate effect, smallest p-value first.
    pub tests: Vec<CandidateTest>,
    /// Significance threshold of the score tests of the candidate effects.
    pub threshold: Threshold,
    /// Correlations between the effective scores of the coefficients of the candidate effects.
    pub score_correlations: ScoreCorrelations,
    /// Detected errors in the data of the flights, in the order of the dataset.
    pub data_faults: Vec<DataFault>,
    /// Residuals of each flight without and with the effects added to the model, in the order of the dataset.
    pub flights: Vec<FlightGain>,
    /// Coefficients over angle of attack or speed, without and with the added effects.
    pub curves: Vec<CoefficientCurve>,
    /// Lack of fit that no candidate effect explains; `None` if there is none.
    pub unattributed: Option<Unattributed>,
    /// Agreement of the flights on the explanations; `None` if these explain the entire misfit of every flight.
    pub consensus: Option<Consensus>,
    /// Lack-of-fit test of the final model. [`Verdict::Adequate`] requires that it is absent or not significant.
    pub lack_of_fit: Option<LackOfFit>,
    /// Result of verifying the extended model; `None` if it was not.
    pub verified: Option<Verified>,
    /// Whether every fit of the diagnosis converged.
    pub converged: bool,
    /// Whether the search was completed, before the deadline and the maximum number of steps.
    pub complete: bool,
    /// Messages on limitations of the result.
    pub notes: Vec<String>,
}

impl Report {
    /// Noise of the measured positions; without positions, that of the first kind of sensor in `noise`.
    pub fn leading_noise(&self) -> &NoiseReport {
        leading_noise(&self.noise)
    }
}

/// Outcome of a diagnosis: whether the model has an error, and whether the missing effects are identified.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// No error of the model is detected: no candidate effect is significant, and the residuals are noise.
    #[default]
    Adequate,
    /// Exactly one explanation is accepted, and its effects are not negligible.
    Identified,
    /// Several explanations are accepted, not all of them negligible, and these flights cannot distinguish them.
    Ambiguous,
    /// There is a significant lack of fit, and no candidate effect explains it.
    Unattributed,
    /// Every accepted explanation is below the smallest effect size of interest.
    Negligible,
}

/// One explanation of the misfit: a single effect that the model lacks, or several such effects together.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Explanation {
    /// The effects that the model lacks according to this explanation.
    pub effects: Vec<ExplanationEffect>,
    /// Decrease of the weighted sum of squares, χ², by the effects.
    pub chi2_decrease: f64,
    /// Fraction of the excess χ² of the lack-of-fit test, 0 … 1, that it accounts for; 0 without a test.
    pub explained_fraction: f64,
    /// Root mean square of the residuals in excess of the noise with the effects, m.
    pub remaining_rms_m: f64,
    /// Most significant further candidate, with the effects included; `None` if none can be tested.
    pub strongest_remaining: Option<RemainingEffect>,
}

/// The most significant candidate effect that an explanation does not include.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RemainingEffect {
    /// Display name of the effect: its identifier in the model language, with hyphens instead of underscores.
    pub name: String,
    /// p-value of the effect's score test in the model that includes the effects of the explanation.
    pub p_value: f64,
}

/// One effect of those that together explain the misfit, with the estimates of its coefficients.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ExplanationEffect {
    /// Display name, with hyphens, of the candidate effect or of the effect created from library terms.
    pub name: String,
    /// Description of the effect, by the sign of its first coefficient; of a created effect, its doc comment.
    pub description: String,
    /// Site of the effect: the load or the equation of the model that it changes.
    pub site: String,
    /// Names of the variables on which the effect depends.
    pub variables: Vec<String>,
    /// Estimates of coefficients and states by name; that of a state is the rms over the flights of its departure.
    pub estimates: BTreeMap<String, Estimate>,
    /// Score statistic at the fit of the model under test, χ²; 0 for a created effect.
    pub score_chi2: f64,
    /// Whether every estimate is below its smallest effect size of interest.
    pub negligible: bool,
}

/// Estimate of a coefficient, with its standard error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// Estimated value of the coefficient, SI.
    pub value: f64,
    /// Standard error of the estimate, SI.
    pub std_error: f64,
    /// SI unit of the value, as text.
    pub unit: String,
    /// Smallest effect size of interest, SI; `None` if the effect declares none.
    pub smallest_effect_of_interest: Option<f64>,
}

/// Fitted coefficient of the model, without and with the effects that the diagnosis adds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Coefficient {
    /// Fitted value, SI; with the added effects if the model is extended.
    pub value: f64,
    /// Standard error of the value, SI.
    pub std_error: f64,
    /// SI unit of the coefficient, as text.
    pub unit: String,
    /// Value without the added effects, SI; `None` if not extended, or of an added effect.
    pub before: Option<f64>,
}

/// Result of the score test of one candidate effect.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CandidateTest {
    /// Display name of the effect: its identifier in the model language, with hyphens instead of underscores.
    pub name: String,
    /// Description of the candidate effect: the doc comment of its declaration in the model language.
    pub description: String,
    /// Site of the effect: the load or the equation of the model that it changes.
    pub site: String,
    /// Score statistic; distributed as χ² with `degrees_of_freedom` degrees of freedom under the null hypothesis.
    pub score_chi2: f64,
    /// Number of degrees of freedom of the test.
    pub degrees_of_freedom: usize,
    /// Natural logarithm of the p-value.
    pub ln_p_value: f64,
    /// Equivalent z of the p-value: the two-sided standard normal quantile that has this p-value.
    pub z: f64,
    /// Whether the p-value is below the familywise threshold.
    pub significant: bool,
    /// Tolerance 1 − R² of the best determined direction: its part that nuisance parameters do not explain.
    pub tolerance: f64,
    /// One-step estimates of the effect's coefficients by name, with all other candidates at their null value.
    pub one_step_estimates: BTreeMap<String, Estimate>,
}

/// Significance threshold of the score tests, corrected for multiple testing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Threshold {
    /// Familywise probability of a false alarm: that any candidate effect is significant although the model is correct.
    pub alpha: f64,
    /// Natural logarithm of the p-value below which a single test is significant.
    pub ln_p_value: f64,
    /// Equivalent z of the threshold (two-sided standard normal quantile), above which a single test is significant.
    pub z: f64,
}

/// Correlation matrix of the effective scores of the candidate effects' coefficients.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ScoreCorrelations {
    /// Names of the coefficients to which the rows and columns of the correlation matrix belong, in their order.
    pub names: Vec<String>,
    /// Rows of the correlation matrix; the correlations are −1 … 1.
    pub matrix: Vec<Vec<f64>>,
}

/// RMS residuals of one flight in the model without and with the added effects.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FlightGain {
    /// File name of the flight.
    pub file: String,
    /// Role of the flight declared in the dataset: fitted or held out.
    pub role: Role,
    /// Whether the flight was fitted, predicted or excluded, and why.
    #[serde(flatten)]
    pub outcome: FlightOutcome,
    /// Root mean square residual of one coordinate without the added effects, m; `None` if the flight was excluded.
    pub rms_before_m: Option<f64>,
    /// The same with the added effects; `None` if excluded or not extended.
    pub rms_after_m: Option<f64>,
}

/// Lack of fit that no candidate explains, with loads and library terms that would reduce it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Unattributed {
    /// Sentences that state in which load channels the lack of fit lies.
    pub description: String,
    /// Estimated missing load of each load channel.
    pub channels: Vec<LoadChannel>,
    /// Tested library terms (products of variables added to one load), most significant first.
    pub terms: Vec<StepwiseTerm>,
}

/// Agreement of the flights on explanations that leave misfit, or without discordant flights.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Consensus {
    /// Number of fitted flights that agree, without discordant ones.
    pub flights: usize,
    /// Fraction of the excess χ², 0 … 1, of the first explanation; `None` if it accounts for all.
    pub explained_fraction: Option<f64>,
    /// Familywise p-value of the sign-flip test.
    pub p_value: f64,
    /// Files of the fitted flights that contradict the explanations and are excluded.
    pub discordant: Vec<String>,
}

/// Missing load in one load channel, as estimated from the residuals.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LoadChannel {
    /// Name of the load in which the force or moment is missing: lift, drag, side, roll, pitch or spin.
    pub site: String,
    /// χ² decrease by the terms of this load over that by all, 0 … 1.
    pub explained_fraction: f64,
    /// Time history, in each flight, of the coefficient of the missing load.
    pub histories: Vec<LoadHistory>,
}

/// Result of verifying the extended model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Verified {
    /// Whether no check refuted the extended model.
    pub holds: bool,
    /// Name and result, as text, of each check by which the extended model was verified.
    pub checks: Vec<(String, String)>,
}
