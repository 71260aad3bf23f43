//! Certificate of a verification: what was checked, on which texts and code, with which options, and what was found.
//!
//! A certificate holds no time and no machine's paths: the same verification gives the same bytes. It covers the texts of
//! the models and effects, the schedule and the Rust code that the compiler makes of them, the results of the tape at
//! seeded points, the version of the program, and its built-in effects. [`Certificate::changes`] compares these alone;
//! [`Certificate::changes_again`] makes the checks again as well.

mod change;
mod fingerprint;
mod origin;
mod read;
mod status;

pub use change::Change;
pub use fingerprint::{Fingerprint, Hash, HashedSource};
pub use origin::{Origin, folder_of};
pub use read::{CertificateError, MAX_BYTES};
pub use status::Status;

use crate::Options;
use crate::report::{Measure, Outcome, Report, Row, Verdict};
use crate::same_motion::SameMotion;
use model_spec::load::Loaded;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Name and version of the format.
pub const SCHEMA: &str = "hyzer.certificate/1";

/// Record of a verification.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Certificate {
    /// [`SCHEMA`].
    pub schema: String,
    /// Program that made the checks.
    pub program: Program,
    /// Options of the checks.
    pub options: CertifiedOptions,
    /// Outcome of all models together.
    pub outcome: Outcome,
    /// The verified models.
    pub models: Vec<CertifiedModel>,
    /// Verdicts of the comparison of models that describe one motion.
    pub same_motion: Vec<CertifiedCheck>,
}

/// Program that made the checks.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Program {
    /// Version.
    pub version: String,
    /// Hash of the names and texts of the built-in effects, which the checks switch on.
    pub effects: Hash,
}

/// Options of the checks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CertifiedOptions {
    /// Seed of all random numbers.
    pub seed: u64,
    /// Number of random points per check.
    pub cases: usize,
    /// Whether mutants were tested.
    pub mutants: bool,
}

/// Record of one model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CertifiedModel {
    /// Name of the model.
    pub model: String,
    /// Where the model is found.
    pub from: Origin,
    /// Effects that were added, in order.
    pub with: Vec<Origin>,
    /// Hashes of texts and code.
    pub covers: Fingerprint,
    /// Outcome of the checks.
    pub outcome: Outcome,
    /// Result of each check, in order.
    pub checks: Vec<CertifiedCheck>,
}

/// Result of one check.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CertifiedCheck {
    /// Name of the check.
    pub check: String,
    /// Outcome.
    pub verdict: Verdict,
    /// Number of points or cases.
    pub cases: usize,
    /// Largest error, in units of `measure`; `None` if it is not finite.
    pub worst: Option<f64>,
    /// Largest error that is allowed.
    pub allowed: f64,
    /// Measure of both.
    pub measure: Measure,
    /// Place of the largest error, or why the check was not made.
    pub detail: String,
    /// What the check leaves out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub remark: Option<String>,
}

impl From<&Row> for CertifiedCheck {
    fn from(row: &Row) -> Self {
        Self {
            check: row.check.to_owned(),
            verdict: row.verdict,
            cases: row.cases,
            worst: row.worst.is_finite().then_some(row.worst),
            allowed: row.tolerance,
            measure: row.measure,
            detail: row.detail.clone(),
            remark: row.remark.clone(),
        }
    }
}

impl Program {
    /// The program that runs.
    pub fn present() -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            effects: Hash::of_built_in_effects(),
        }
    }
}

impl CertifiedOptions {
    /// The options as those of a verification.
    pub fn options(&self) -> Options {
        Options {
            seed: self.seed,
            cases: self.cases,
            mutants: self.mutants,
            ..Options::default()
        }
    }
}

impl From<&Options> for CertifiedOptions {
    fn from(options: &Options) -> Self {
        Self {
            seed: options.seed,
            cases: options.cases,
            mutants: options.mutants,
        }
    }
}

impl CertifiedModel {
    /// Record of a verified model; `folder` is that of the certificate, `name` and `with` as the model was loaded. `None`
    /// for a text that yields no model.
    pub fn new(
        folder: &Path,
        name: &str,
        with: &[&str],
        loaded: &Loaded,
        report: &Report,
    ) -> Option<Self> {
        let model = loaded.model.as_ref()?;
        Some(Self {
            model: report.model.clone(),
            from: Origin::of(name, folder),
            with: with.iter().map(|name| Origin::of(name, folder)).collect(),
            covers: Fingerprint::of(model, &loaded.sources, folder, report.seed),
            outcome: report.outcome(),
            checks: report.rows.iter().map(CertifiedCheck::from).collect(),
        })
    }
}

impl Certificate {
    /// Certificate of verified models.
    pub fn new(
        options: &Options,
        models: Vec<CertifiedModel>,
        same_motion: Option<&SameMotion>,
    ) -> Self {
        let same_motion = pairs(same_motion);
        Self {
            schema: SCHEMA.to_owned(),
            program: Program::present(),
            options: options.into(),
            outcome: outcome(&models, &same_motion),
            models,
            same_motion,
        }
    }

    /// Text of the certificate, JSON.
    pub fn text(&self) -> String {
        // Numbers, texts and lists alone: nothing that JSON cannot hold.
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }

    /// Models with their outcomes: `kite: verified`.
    pub fn summary(&self) -> String {
        let models = self.models.iter();
        let each: Vec<String> = models
            .map(|m| format!("{}: {}", m.model, m.outcome.words()))
            .collect();
        each.join(", ")
    }
}

/// Outcome of models and of the comparisons between them.
fn outcome(models: &[CertifiedModel], same_motion: &[CertifiedCheck]) -> Outcome {
    let of_models = models.iter().map(|model| model.outcome);
    let of_pairs = same_motion.iter().map(|pair| match pair.verdict {
        Verdict::Refuted => Outcome::Refuted,
        _ => Outcome::Verified,
    });
    of_models
        .chain(of_pairs)
        .max()
        .unwrap_or(Outcome::NotVerified)
}

/// Verdicts on each pair of models of one motion; accelerations that were not compared refute, as in the command.
fn pairs(same_motion: Option<&SameMotion>) -> Vec<CertifiedCheck> {
    let pairs = same_motion.into_iter().flat_map(|same| &same.pairs);
    pairs
        .flat_map(|pair| {
            let named = |row: &Row, must_hold: bool| {
                let mut check = CertifiedCheck::from(row);
                check.check = format!("{}: {}", pair.models.join(" and "), row.check);
                if must_hold && check.verdict != Verdict::Holds {
                    check.verdict = Verdict::Refuted;
                }
                check
            };
            [
                named(&pair.accelerations, true),
                named(&pair.flights, false),
            ]
        })
        .collect()
}
