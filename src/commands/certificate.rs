//! Certificates of models: checks whether a certificate is still valid, and makes the statement about it in reports
//! of fits and diagnoses.

use std::path::{Path, PathBuf};

use anyhow::Context;
use model_spec::model::Model;
use report::CertificateNote;
use verify::certificate::{Certificate, CertificateError, folder_of};
use verify::report::Outcome;

use crate::{Answer, output};

/// File extension of the certificate of a model, next to the model's file.
const ENDING: &str = "certificate.json";

/// Prints whether a certificate is still valid. Returns `Answer::No` if a certified item, such as the text of a model,
/// has changed since the certificate was written. If `again`, the certified checks are repeated; `same` selects the
/// models that must describe the same motion.
pub fn check(
    path: &Path,
    again: bool,
    json: bool,
    same: impl Fn(&Model) -> bool,
) -> anyhow::Result<Answer> {
    let shown = path.display();
    let certificate = Certificate::read(path).with_context(|| shown.to_string())?;
    let folder = folder_of(path);
    let changes = match again {
        true => certificate.changes_again(&folder, same),
        false => certificate.changes(&folder),
    };
    let stands = changes.is_empty();
    output::print(if json {
        let value = serde_json::json!({
            "stands": stands, "outcome": certificate.outcome, "changes": changes
        });
        serde_json::to_string_pretty(&value)? + "\n"
    } else if stands {
        format!("{shown} stands: {}\n", certificate.summary())
    } else {
        let lines: Vec<String> = changes.iter().map(|c| format!("  {c}\n")).collect();
        format!("{shown} does not stand:\n{}", lines.concat())
    })?;
    Ok(match stands {
        true => Answer::Yes,
        false => Answer::No,
    })
}

/// Certificate of a model that a report cites: path and content, or the reason why the content cannot be read. `None`
/// if there is no certificate.
pub struct Found(Option<(PathBuf, Result<Certificate, CertificateError>)>);

impl Found {
    /// Reads the certificate file `asked` (record of verification checks), or without one the certificate next to the
    /// file of the model `name_or_path`, if there is one. Returns an error only if `asked` cannot be read.
    pub fn read(asked: Option<&Path>, name_or_path: &str) -> anyhow::Result<Self> {
        if let Some(path) = asked {
            let read = Certificate::read(path)
                .with_context(|| format!("--certificate: {}", path.display()))?;
            return Ok(Self(Some((path.to_owned(), Ok(read)))));
        }
        let model = Path::new(name_or_path);
        let path = model.with_extension(ENDING);
        if !model.is_file() || !path.is_file() {
            return Ok(Self(None));
        }
        let read = Certificate::read(&path);
        Ok(Self(Some((path, read))))
    }

    /// Statement for a report on `model`: that the model has no certificate, that the certificate is still valid, or
    /// that something it covers has changed.
    pub fn note(&self, model: &Model) -> CertificateNote {
        let Some((path, read)) = &self.0 else {
            return CertificateNote::none();
        };
        let file = path.file_name().unwrap_or_default();
        let file = file.to_string_lossy().into_owned();
        let status = match read {
            Ok(certificate) => certificate.status(path, model),
            Err(why) => return CertificateNote::changed(file, None, vec![why.to_string()]),
        };
        let outcome = status.outcome.map(Outcome::words).map(str::to_lowercase);
        match outcome {
            Some(outcome) if status.changes.is_empty() => CertificateNote::stands(file, outcome),
            outcome => {
                let changes = status.changes.iter().map(ToString::to_string);
                CertificateNote::changed(file, outcome, changes.collect())
            }
        }
    }
}
