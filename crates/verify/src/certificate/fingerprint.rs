//! Hashes of the texts and code that a certificate covers.

use super::origin::relative;
use crate::BACKEND_POINTS;
use crate::checks::backends;
use crate::random::Random;
use crate::sample;
use codegen::backend::Backend;
use codegen::rust::PlainRust;
use model_spec::load::{EFFECTS, GENERAL_EFFECTS};
use model_spec::model::{Model, Source};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::fmt::{self, Write};
use std::path::Path;

/// SHA-256 hash, as 64 lower-case hexadecimal digits.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String")]
pub struct Hash(String);

/// Error for a text that is not a SHA-256 hash in 64 lower-case hexadecimal digits.
#[derive(Clone, Copy, Debug, thiserror::Error)]
#[error("expected 64 hexadecimal digits of a SHA-256")]
pub struct HashError;

impl TryFrom<String> for Hash {
    type Error = HashError;

    fn try_from(text: String) -> Result<Self, HashError> {
        let is_digit = |b: u8| b.is_ascii_digit() || (b'a'..=b'f').contains(&b);
        if text.len() == 64 && text.bytes().all(is_digit) {
            Ok(Self(text))
        } else {
            Err(HashError)
        }
    }
}

impl fmt::Display for Hash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl Hash {
    /// SHA-256 hash of several texts. The length of each text is hashed too, so that the boundaries between texts
    /// matter.
    fn of<'a>(texts: impl IntoIterator<Item = &'a [u8]>) -> Self {
        let mut digest = Sha256::new();
        for text in texts {
            digest.update((text.len() as u64).to_le_bytes());
            digest.update(text);
        }
        Self::finished(digest)
    }

    /// SHA-256 hash of one text, identical to the output of the command `sha256sum`.
    pub fn of_text(text: &str) -> Self {
        Self::finished(Sha256::new_with_prefix(text))
    }

    fn finished(digest: Sha256) -> Self {
        let mut hex = String::new();
        for byte in digest.finalize() {
            // Writing to a string does not fail.
            let _ = write!(hex, "{byte:02x}");
        }
        Self(hex)
    }

    /// Hash of the names and texts of all built-in effects (optional model extensions).
    pub(super) fn of_built_in_effects() -> Self {
        let all = EFFECTS.iter().chain(GENERAL_EFFECTS);
        Self::of(all.flat_map(|(name, text)| [name.as_bytes(), text.as_bytes()]))
    }
}

/// Name and hash of a source text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HashedSource {
    /// Path relative to the folder of the certificate, or name of a built-in model or effect (optional model
    /// extension).
    pub name: String,
    /// SHA-256 hash of the source text.
    pub sha256: Hash,
}

/// Hashes of the texts of a model and of the code generated from them.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Fingerprint {
    /// Name and hash of the source text of the model, followed by those of its effects (optional model extensions).
    pub sources: Vec<HashedSource>,
    /// Hash of the lists of elementary operations of all compiled functions, in evaluation order. The backends
    /// (generated code, bytecode interpreter) print or interpret these lists.
    pub schedule: Hash,
    /// Hash of the Rust code generated from the model by the backend for `f64`, without SIMD types.
    pub rust: Hash,
    /// Hash of the bits of all results that the bytecode interpreter computes for the model at pseudo-random points,
    /// without fused multiply-add.
    pub results: Hash,
}

impl Fingerprint {
    /// Computes the hashes of a model. `folder` is the folder of the certificate, relative to which paths are recorded;
    /// `seed` determines the pseudo-random points at which results are computed for hashing.
    pub fn of(model: &Model, sources: &[Source], folder: &Path, seed: u64) -> Self {
        let compiled = codegen::compile(model);
        let schedule = compiled.functions().map(|f| format!("{f:?}"));
        let files = PlainRust.emit(model, &compiled);
        let mut random = Random::new(seed, "results in a certificate");
        let points = sample::points(model, BACKEND_POINTS, &mut random);
        let runs = backends::runs(model, &compiled, &points);
        let first = runs.first().into_iter().flat_map(|run| &run.results);
        let bits: Vec<[u8; 8]> = first
            .flatten()
            .map(|value| value.to_bits().to_le_bytes())
            .collect();
        Self {
            sources: hashed(sources, folder),
            schedule: Hash::of(schedule.iter().map(String::as_bytes)),
            rust: Hash::of(
                files
                    .iter()
                    .flat_map(|f| [f.path.as_bytes(), f.text.as_bytes()]),
            ),
            results: Hash::of(bits.iter().map(<[u8; 8]>::as_slice)),
        }
    }

    /// Whether the hashed texts are those of `sources`, in the same order. The names of the texts are not compared.
    pub(super) fn has_texts(&self, sources: &[Source]) -> bool {
        let own = self.sources.iter().map(|source| &source.sha256);
        let others: Vec<Hash> = sources.iter().map(|s| Hash::of_text(&s.text)).collect();
        own.eq(others.iter())
    }
}

fn hashed(sources: &[Source], folder: &Path) -> Vec<HashedSource> {
    let one = |source: &Source| HashedSource {
        name: match Path::new(&source.name) {
            path if path.is_file() => relative(path, folder),
            _ => source.name.clone(),
        },
        sha256: Hash::of_text(&source.text),
    };
    sources.iter().map(one).collect()
}
