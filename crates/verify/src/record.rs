//! Record of a verification, read back from its JSON: hashes of what was verified, and verdicts. Two records are
//! compared to find what has changed since.

use crate::report::Verdict;
use codegen::backend::Backend;
use codegen::rust::PlainRust;
use flight::files::{Unreadable, json};
use model_spec::model::{Model, Source};
use serde::Deserialize;
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;

/// Name and version of the JSON format of a verification.
pub const SCHEMA: &str = "hyzer.verification/1";

/// What is read, in messages.
pub const WHAT: &str = "the JSON that `hyzer verify MODEL --json > FILE` writes";

/// Size limit of the JSON of a verification, bytes.
pub const MAX_BYTES: u64 = 64_000_000;

/// What the JSON of a verification says of one or more models. Other fields of the JSON are ignored.
#[derive(Clone, Debug, Deserialize)]
pub struct Record {
    /// Seed of all random numbers of the verification.
    pub seed: u64,
    /// Number of random points at which each check evaluated the models.
    pub cases: usize,
    /// Whether mutation testing was run.
    pub mutants: bool,
    /// The verified models.
    pub models: Vec<RecordedModel>,
    /// Comparisons of models that describe the same motion.
    same_motion: Option<RecordedPairs>,
}

/// What the JSON of a verification says of one model.
#[derive(Clone, Debug, Deserialize)]
pub struct RecordedModel {
    /// Name of the model, as stated in its file.
    model: String,
    /// Name or path by which the model was loaded.
    pub source: String,
    /// Names or paths of the effects that were added to the model.
    pub with: Vec<String>,
    text_sha256: String,
    code_sha256: String,
    rows: Vec<RecordedCheck>,
}

#[derive(Clone, Debug, Deserialize)]
struct RecordedCheck {
    check: String,
    verdict: Verdict,
}

#[derive(Clone, Debug, Deserialize)]
struct RecordedPairs {
    pairs: Vec<RecordedPair>,
}

#[derive(Clone, Debug, Deserialize)]
struct RecordedPair {
    models: [String; 2],
    accelerations: RecordedCheck,
    flights: RecordedCheck,
}

/// Reason why a text is not the JSON of a verification.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RecordError {
    /// The text has more than [`MAX_BYTES`] bytes.
    #[error("found more than {MAX_BYTES} bytes; expected {WHAT}")]
    TooLong,
    /// The text is not the JSON of a verification: where, what was found, and what was expected.
    #[error("{0}")]
    Malformed(Unreadable),
    /// The format is another one than [`SCHEMA`]; contains the format found.
    #[error("schema: found {0}; expected {SCHEMA:?}, as in {WHAT}")]
    Schema(String),
}

impl Record {
    /// Parses the JSON of a verification.
    pub fn parse(text: &str) -> Result<Self, RecordError> {
        if text.len() as u64 > MAX_BYTES {
            return Err(RecordError::TooLong);
        }
        let value: Value = json(text, WHAT).map_err(RecordError::Malformed)?;
        match value.get("schema") {
            Some(schema) if schema == SCHEMA => {}
            Some(schema) => return Err(RecordError::Schema(schema.to_string())),
            None => return Err(RecordError::Schema("none".to_owned())),
        }
        json(text, WHAT).map_err(RecordError::Malformed)
    }

    /// Describes each hash and verdict that differs in `now`, and each model or check that only one record has.
    pub fn differences(&self, now: &Self) -> Vec<String> {
        let mut out = Vec::new();
        for model in &self.models {
            let is_same = |m: &&RecordedModel| m.source == model.source && m.with == model.with;
            match now.models.iter().find(is_same) {
                Some(later) => out.extend(model.differences(later)),
                None => out.push(format!(
                    "{}: the model can no longer be loaded",
                    model.model
                )),
            }
        }
        out.extend(changed_checks(&self.pairs(), &now.pairs()));
        out
    }

    fn pairs(&self) -> BTreeMap<String, Verdict> {
        let pairs = self.same_motion.iter().flat_map(|same| &same.pairs);
        let checks = pairs.flat_map(|pair| {
            let models = pair.models.join(" and ");
            [&pair.accelerations, &pair.flights]
                .map(|check| (format!("{models}: check {}", check.check), check.verdict))
        });
        checks.collect()
    }
}

impl RecordedModel {
    fn differences(&self, now: &Self) -> Vec<String> {
        let name = &self.model;
        let mut out = Vec::new();
        if self.text_sha256 != now.text_sha256 {
            out.push(format!("{name}: hash of the model's text changed"));
        }
        if self.code_sha256 != now.code_sha256 {
            out.push(format!("{name}: hash of the generated code changed"));
        }
        let checks = |of: &Self| -> BTreeMap<String, Verdict> {
            let rows = of.rows.iter();
            rows.map(|row| (format!("{name}: check {}", row.check), row.verdict))
                .collect()
        };
        out.extend(changed_checks(&checks(self), &checks(now)));
        out
    }
}

/// Describes each check whose verdict differs or that only one of two verifications has.
fn changed_checks(
    before: &BTreeMap<String, Verdict>,
    now: &BTreeMap<String, Verdict>,
) -> Vec<String> {
    let changed = before.iter().filter_map(|(name, was)| match now.get(name) {
        Some(is) if is == was => None,
        Some(is) => Some(format!("{name}: was {}, is {}", was.words(), is.words())),
        None => Some(format!("{name}: was {}, is not made", was.words())),
    });
    let added = now.iter().filter(|(name, _)| !before.contains_key(*name));
    let added = added.map(|(name, is)| format!("{name}: was not made, is {}", is.words()));
    changed.chain(added).collect()
}

/// SHA-256 of the text of a model followed by those of its effects, in hexadecimal digits.
pub fn text_hash(sources: &[Source]) -> String {
    hash(sources.iter().map(|source| source.text.as_str()))
}

/// SHA-256 of the Rust code that is generated from a model, in hexadecimal digits.
pub fn code_hash(model: &Model) -> String {
    let files = PlainRust.emit(model, &codegen::compile(model));
    hash(files.iter().map(|file| file.text.as_str()))
}

fn hash<'a>(texts: impl Iterator<Item = &'a str>) -> String {
    let mut digest = Sha256::new();
    texts.for_each(|text| digest.update(text));
    let bytes = digest.finalize();
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
