//! Reads certificates, with bounded size and located errors.

use super::{Certificate, SCHEMA, outcome};
use crate::report::Outcome;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Maximum size of the file of a certificate (record of a verification), bytes.
pub const MAX_BYTES: u64 = 4_000_000;
/// Maximum number of models in a valid certificate (record of a verification).
const MAX_MODELS: usize = 1000;
/// Maximum number of random points per check in a valid certificate (record of a verification); equal to the maximum
/// that the command line accepts.
const MAX_CASES: usize = 100_000;

/// Reason why a file is not a valid certificate (record of a verification).
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CertificateError {
    /// The file cannot be read.
    #[error("cannot be read: {0}")]
    Unreadable(#[from] std::io::Error),
    /// The file has more than [`MAX_BYTES`] bytes.
    #[error("found more than {MAX_BYTES} bytes, expected a certificate")]
    TooLong,
    /// The file is not UTF-8; contains the offset of the first invalid byte.
    #[error("byte {0} begins no character of UTF-8")]
    NotUtf8(usize),
    /// The text is not JSON in the form of a certificate. The message ends with line and column.
    #[error("{0}")]
    Malformed(#[from] serde_json::Error),
    /// A value in the file is out of range or contradicts other values, such as an outcome that does not follow from
    /// the verdicts.
    #[error("{place}: found {found}, expected {expected}")]
    Invalid {
        /// Path of the value in the JSON document, such as `models[0].outcome`.
        place: String,
        /// The invalid value in the file, or a description of it, such as `0 models`.
        found: String,
        /// Description of the values that would be valid instead of the value found.
        expected: String,
    },
}

impl Certificate {
    /// Reads and validates a certificate (record of a verification) from a file.
    ///
    /// # Errors
    /// [`CertificateError`] if the file cannot be read or is not a valid certificate.
    pub fn read(path: &Path) -> Result<Self, CertificateError> {
        let mut bytes = Vec::new();
        File::open(path)?
            .take(MAX_BYTES + 1)
            .read_to_end(&mut bytes)?;
        if bytes.len() as u64 > MAX_BYTES {
            return Err(CertificateError::TooLong);
        }
        let text = String::from_utf8(bytes)
            .map_err(|error| CertificateError::NotUtf8(error.utf8_error().valid_up_to()))?;
        Self::parse(&text)
    }

    /// Parses and validates the JSON text of a certificate (record of a verification).
    ///
    /// # Errors
    /// [`CertificateError`] if the text is not a valid certificate.
    pub fn parse(text: &str) -> Result<Self, CertificateError> {
        if text.len() as u64 > MAX_BYTES {
            return Err(CertificateError::TooLong);
        }
        let certificate: Self = serde_json::from_str(text)?;
        certificate.validate()?;
        Ok(certificate)
    }

    fn validate(&self) -> Result<(), CertificateError> {
        let invalid = |place: String, found: String, expected: &str| {
            Err(CertificateError::Invalid {
                place,
                found,
                expected: expected.to_owned(),
            })
        };
        if self.schema != SCHEMA {
            return invalid("schema".into(), format!("{:?}", self.schema), SCHEMA);
        }
        let cases = self.options.cases;
        if cases == 0 || cases > MAX_CASES {
            return invalid("options.cases".into(), cases.to_string(), "1 to 100000");
        }
        let count = self.models.len();
        if count == 0 || count > MAX_MODELS {
            return invalid("models".into(), format!("{count} models"), "1 to 1000");
        }
        for (index, model) in self.models.iter().enumerate() {
            let expected = Outcome::of(model.checks.iter().map(|check| check.verdict));
            let found = model.outcome;
            if found != expected {
                let place = format!("models[{index}].outcome");
                return invalid(place, name(found), &(name(expected) + ", by its checks"));
            }
        }
        let (found, expected) = (self.outcome, outcome(&self.models, &self.same_motion));
        if found != expected {
            let expected = name(expected) + ", by the models";
            return invalid("outcome".into(), name(found), &expected);
        }
        Ok(())
    }
}

fn name(outcome: Outcome) -> String {
    outcome.words().to_lowercase()
}
