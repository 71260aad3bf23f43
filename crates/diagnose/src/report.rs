//! What a diagnosis found: [`Report`] is `report.json`.

use std::collections::BTreeMap;

use identify::dataset::Role;
use serde::{Deserialize, Serialize};

/// `report.json` of a diagnosis, schema `hyzer.diagnosis/1`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// `hyzer.diagnosis/1`.
    pub schema: String,
    /// The dataset's folder, as it was named.
    pub dataset: String,
    /// Name of the model.
    pub model: String,
    /// Effects that were switched on from the beginning.
    pub effects: Vec<String>,
    /// What was found, in a word.
    pub verdict: Verdict,
    /// What is wrong, in a paragraph of plain words.
    pub summary: String,
    /// Every explanation that the data do not reject, the best first.
    pub causes: Vec<Cause>,
    /// The noise of the measured coordinates.
    pub noise: Noise,
    /// What the extension gains on flights that it has not seen; none where nothing is extended or no flight is held out.
    pub gain: Option<Gain>,
    /// The coefficients of the extended model, or of the model where nothing is extended.
    pub coefficients: BTreeMap<String, Coefficient>,
    /// Effects that these flights cannot show, and what absorbs them.
    pub undetectable: Vec<Undetectable>,
    /// The smallest size at which each effect would be found in these flights, nine times in ten.
    pub smallest_detectable: Vec<Detectable>,
    /// The throw that would best tell the remaining causes apart.
    pub next_throw: Option<NextThrow>,
    /// The model file that was written, beside the report.
    pub extended_model: Option<String>,
    /// Time taken, s; `total` is all of it.
    pub seconds: BTreeMap<String, f64>,
    /// Every effect that was looked for, the most significant first.
    pub candidates: Vec<CandidateScore>,
    /// What an alarm takes.
    pub threshold: Threshold,
    /// How alike the candidates' effects look in these flights.
    pub alike: Alike,
    /// Root mean square of the residuals of each flight before and after.
    pub flights: Vec<FlightGain>,
    /// Curves of the model's coefficients before and after.
    pub curves: Vec<Curve>,
    /// What was found outside the catalogue.
    pub outside: Option<Outside>,
    /// Where the causes do not explain all, how far the flights agree on them.
    pub agreement: Option<Agreement>,
    /// What the checks say of the extended model.
    pub verified: Option<Verified>,
    /// Noteworthy circumstances.
    pub notes: Vec<String>,
}

/// What a diagnosis says in a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Nothing is found that is not noise.
    None,
    /// One cause.
    Named,
    /// Several that these flights cannot tell apart.
    Ambiguous,
    /// Something that no effect of the catalogue explains.
    Outside,
    /// Something real, but too small to matter.
    Immaterial,
}

/// One explanation: an effect, or several that act together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cause {
    /// Its effects.
    pub effects: Vec<CauseEffect>,
    /// By how much the weighted sum of squares falls with it.
    pub gain: f64,
    /// The other effect that would explain most of what is left, and how likely it is that chance does as much.
    pub rival: Option<Rival>,
}

/// What comes next once a cause is allowed for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rival {
    /// The effect.
    pub name: String,
    /// Its probability by chance.
    pub p: f64,
}

/// An effect of an explanation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CauseEffect {
    /// Its name: of the catalogue, or of the effect that was written.
    pub name: String,
    /// What it says.
    pub doc: String,
    /// Where it acts.
    pub site: String,
    /// What it depends on.
    pub variables: Vec<String>,
    /// Its coefficients; for a state of each flight the root mean square over flights.
    pub estimates: BTreeMap<String, Estimate>,
    /// Its own statistic before anything was allowed for: chi squared.
    pub statistic: f64,
    /// Whether all of its estimates are too small to matter.
    pub immaterial: bool,
}

/// A number with its standard error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// Value, SI.
    pub value: f64,
    /// Standard error, SI.
    pub std_error: f64,
    /// Unit.
    pub unit: String,
    /// Size below which it does not matter in practice, SI.
    pub negligible: Option<f64>,
}

/// The noise of the measured coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Noise {
    /// Standard deviation of one coordinate, m.
    pub sigma_m: f64,
    /// First-order correlation between neighbouring samples.
    pub ar1: f64,
    /// Part of the points that were taken for outliers.
    pub outlier_fraction: f64,
}

/// Errors of prediction on held-out flights, whose initial state was fitted on their first 30 %.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Gain {
    /// Root mean square error before, m.
    pub held_out_rms_before_m: f64,
    /// And with the extended model, m.
    pub held_out_rms_after_m: f64,
    /// Standard error of the difference, over flights, m.
    pub standard_error_m: f64,
    /// The noise of one coordinate: no model can do better, m.
    pub noise_floor_m: f64,
    /// Flights that were held out, or each in turn where the dataset holds none out.
    pub flights: usize,
    /// Flights among them whose first part, on which their initial state is fitted, contradicts causes that not all flights go with:
    /// they are predicted without the extension.
    #[serde(default)]
    pub without: usize,
    /// Whether flights were held out by the dataset; else every flight was predicted by a fit to the others.
    pub held_out_by_dataset: bool,
}

/// A coefficient after and before.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Coefficient {
    /// Its value, SI.
    pub value: f64,
    /// Its standard error, SI.
    pub std_error: f64,
    /// Its unit.
    pub unit: String,
    /// Its value without the extension, SI; none for those that the extension adds.
    pub before: Option<f64>,
}

/// An effect that these flights cannot show.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Undetectable {
    /// Its name.
    pub name: String,
    /// What takes it up: coefficients, or `initial states`; empty where it does nothing at all here.
    pub absorbed_by: Vec<String>,
}

/// The smallest size of an effect that would be found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Detectable {
    /// The effect.
    pub name: String,
    /// Its coefficient.
    pub coefficient: String,
    /// Size, SI.
    pub value: f64,
    /// Unit.
    pub unit: String,
}

/// A release that would tell causes apart.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NextThrow {
    /// In words.
    pub says: String,
    /// Speed, m/s.
    pub speed: f64,
    /// Climb of the path, rad.
    pub climb: f64,
    /// Angle between path and disc, nose up, rad.
    pub nose: f64,
    /// Lean of the disc about the path, rad.
    pub hyzer: f64,
    /// Spin about the axis, rad/s; a right-hand backhand's is negative.
    pub spin: f64,
    /// Heading in the horizontal plane from the x axis, rad.
    pub heading: f64,
    /// The least separation of two causes that is expected after it, in standard deviations.
    pub separation: f64,
    /// The same without it.
    pub separation_now: f64,
}

/// What was asked of one effect.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CandidateScore {
    /// Its name.
    pub name: String,
    /// What it says.
    pub doc: String,
    /// Where it acts.
    pub site: String,
    /// By how much the weighted sum of squares would fall: chi squared of `freedom` where it is absent.
    pub statistic: f64,
    /// Directions of it that these flights show.
    pub freedom: usize,
    /// Natural logarithm of the probability that chance does as much.
    pub ln_p: f64,
    /// The statistic as the size of a standard normal number of the same probability.
    pub sigmas: f64,
    /// Whether that raises an alarm.
    pub significant: bool,
    /// Part of its squared effect on what is seen that nothing else absorbs.
    pub visible: f64,
    /// What the scores expect its coefficients to be, the other effects being absent.
    pub expected: BTreeMap<String, Estimate>,
}

/// What an alarm takes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Threshold {
    /// The probability that chance alone raises an alarm, over all effects.
    pub false_alarms: f64,
    /// The logarithm of the probability that a single effect must fall below for it.
    pub ln_p: f64,
    /// The same as the size of a standard normal number.
    pub sigmas: f64,
}

/// Correlations of what effects do in these flights, once initial states and the model's coefficients are allowed for.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Alike {
    /// Coefficients of the effects.
    pub names: Vec<String>,
    /// Correlations, row by row.
    pub matrix: Vec<Vec<f64>>,
}

/// A flight before and after.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FlightGain {
    /// Its file.
    pub file: String,
    /// Whether it was fitted or held out.
    pub role: Role,
    /// Root mean square of its residuals without the extension, m.
    pub rms_before_m: f64,
    /// And with it, m.
    pub rms_after_m: Option<f64>,
}

/// A named quantity of the model along another, before and after.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Curve {
    /// The quantity, such as `C_D`.
    pub quantity: String,
    /// What it is drawn over, such as `alpha`.
    pub over: String,
    /// Unit of that.
    pub unit: String,
    /// Points along it; medians of the flights' samples within each interval.
    pub x: Vec<f64>,
    /// The quantity without the extension.
    pub before: Vec<f64>,
    /// And with it.
    pub after: Vec<f64>,
    /// How many samples lie in each interval.
    pub support: Vec<usize>,
}

/// What was found outside the catalogue.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Outside {
    /// Where the error sits, in words.
    pub says: String,
    /// The loads by which the flights differ from the model, channel by channel.
    pub channels: Vec<Channel>,
    /// Terms that were tried, the most significant first.
    pub terms: Vec<Term>,
}

/// How far flights agree on causes that leave more than noise: what is left differs from flight to flight, and has no law that they
/// share.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Agreement {
    /// Fitted flights that go with the causes.
    pub flights: usize,
    /// The part of what is more than noise that the first cause explains of these flights: weighted squares. None where it leaves
    /// noise alone.
    pub part: Option<f64>,
    /// The probability that all fitted flights agree as well by chance, over everything that was looked for.
    pub chance: f64,
    /// Files of fitted flights that contradict: with the causes at the size that the others ask for they are predicted worse. They are
    /// left out of everything else in the report.
    pub contradicting: Vec<String>,
}

/// What one load would have to be besides what the model says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Channel {
    /// lift, drag, side, roll, pitch or spin; along and across the stream for a ball.
    pub site: String,
    /// Part of the chi squared that this channel alone would explain.
    pub explains: f64,
    /// Histories of its coefficient over flights: by flight, time (s), value and standard error.
    pub histories: Vec<History>,
}

/// A coefficient that one flight asks for, in time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct History {
    /// The flight's file.
    pub file: String,
    /// Times, s.
    pub t: Vec<f64>,
    /// Values.
    pub value: Vec<f64>,
    /// Standard errors.
    pub std_error: Vec<f64>,
}

/// A term of the grammar.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Term {
    /// Its name, as that of the effect that is written for it.
    pub name: String,
    /// Where it acts.
    pub site: String,
    /// In the model's notation.
    pub formula: String,
    /// Chi squared that it explains.
    pub statistic: f64,
    /// Its coefficient.
    pub value: f64,
    /// Standard error.
    pub std_error: f64,
    /// Whether it was taken into the extension.
    pub taken: bool,
}

/// What the independent checks say of the extended model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Verified {
    /// Whether none refutes it.
    pub holds: bool,
    /// Each check with its verdict.
    pub checks: Vec<(String, String)>,
}
