//! Certificate of a verification: the texts and code that were checked, the options, and the results.
//!
//! A certificate contains no time and no absolute paths, so the same verification gives the same bytes. It covers the
//! texts of the models and effects, the schedule and the Rust code that the compiler generates from them, the results
//! of the tape at pseudo-random points, the version of the program, and its built-in effects. [`Certificate::changes`]
//! compares only these; [`Certificate::changes_again`] repeats the checks too.

mod change;
mod fingerprint;
mod origin;
mod read;
mod status;

pub use change::Change;
pub use fingerprint::{Fingerprint, Hash, HashError, HashedSource};
pub use origin::{Origin, folder_of};
pub use read::{CertificateError, MAX_BYTES};
pub use status::Status;

use crate::Options;
use crate::report::{Measure, Outcome, Report, Row, Verdict};
use crate::same_motion::SameMotion;
use model_spec::load::Loaded;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Name and version of the file format of certificates (records of verifications).
pub const SCHEMA: &str = "hyzer.certificate/1";

/// Record of a verification of one or more models.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Certificate {
    /// Name and version of the file format; always [`SCHEMA`].
    pub schema: String,
    /// Version of the program that carried out the checks.
    pub program: Program,
    /// Options with which the checks were carried out.
    pub options: CertifiedOptions,
    /// Worst outcome of all models and of the comparisons between models; from best to worst: verified, not verified,
    /// refuted.
    pub outcome: Outcome,
    /// Records of the verified models.
    pub models: Vec<CertifiedModel>,
    /// Results of the comparisons of every two models that describe the same motion.
    pub same_motion: Vec<CertifiedCheck>,
}

/// Version of the program that carried out the checks, and hash of its built-in effects (optional model extensions).
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Program {
    /// Version of the program that carried out the checks.
    pub version: String,
    /// Hash of the names and texts of the built-in effects (optional model extensions), with which the checks also test
    /// the models.
    pub effects: Hash,
}

/// Options of the checks, as recorded in a certificate (record of a verification).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CertifiedOptions {
    /// Seed of all random numbers of the verification.
    pub seed: u64,
    /// Number of random points at which each check evaluates the model.
    pub cases: usize,
    /// Whether mutation testing was run: the checks are repeated on models with one deliberate change each.
    pub mutants: bool,
}

/// Record of the verification of one model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CertifiedModel {
    /// Name of the model, as specified in its file.
    pub model: String,
    /// File or name from which the model is loaded.
    pub from: Origin,
    /// Files or names of the effects (optional model extensions) that were added to the model, in the order of
    /// addition.
    pub with: Vec<Origin>,
    /// Hashes of the model's texts and of the code generated from them.
    pub covers: Fingerprint,
    /// Combined outcome of the model's checks: verified, not verified or refuted.
    pub outcome: Outcome,
    /// Results of the checks, in the order in which they were carried out.
    pub checks: Vec<CertifiedCheck>,
}

/// Result of one check, as recorded in a certificate (record of a verification).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CertifiedCheck {
    /// Name of the check, as in the verification report.
    pub check: String,
    /// Verdict of the check, such as holds or refuted.
    pub verdict: Verdict,
    /// Number of tested items: random points, flights, check cases of the model file or others, depending on the check.
    pub cases: usize,
    /// Maximum error found by the check, in the unit given by `measure`; `None` if it is not finite.
    pub worst: Option<f64>,
    /// Maximum error that is allowed, in the unit given by `measure`.
    pub allowed: f64,
    /// Unit of `worst` and `allowed`.
    pub measure: Measure,
    /// Description of the point or item with the maximum error, or the reason why the check was not carried out.
    pub detail: String,
    /// Limitation of the check (what it does not cover for this model); `None` if there is none.
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
    /// Version of the running program, and hash of its built-in effects (optional model extensions).
    pub fn present() -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            effects: Hash::of_built_in_effects(),
        }
    }
}

impl CertifiedOptions {
    /// Converts the options recorded in a certificate (record of a verification) to options of a new verification.
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
    /// Creates the record of a verified model. `folder` is the folder of the certificate; `name` and `with` are the
    /// model and the effects (optional model extensions) that were passed to the loader. `None` if the language checker
    /// refused the text of the model.
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
    /// Creates the certificate, that is, the record of the verification, of the given models.
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

    /// Text of the certificate (record of a verification) in JSON, with a final line feed.
    pub fn text(&self) -> String {
        // The certificate consists of numbers, texts and lists, so the serialisation cannot fail.
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }

    /// One-line summary of the models with their outcomes, for example `kite: verified`.
    pub fn summary(&self) -> String {
        let models = self.models.iter();
        let each: Vec<String> = models
            .map(|m| format!("{}: {}", m.model, m.outcome.words()))
            .collect();
        each.join(", ")
    }
}

/// Combined outcome of models and of the comparisons between them: the worst outcome, in the order verified, not
/// verified, refuted.
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

/// Results of the comparisons of each pair of models that describe the same motion. Accelerations that could not be
/// compared count as refuted.
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
