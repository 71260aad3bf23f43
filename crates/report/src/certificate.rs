//! What a report says of the certificate of its model.

use serde::Serialize;

/// What a certificate of a verification says of the model of a report.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct CertificateNote {
    /// File name of the certificate; `None` without one.
    pub file: Option<String>,
    /// Whether the certificate covers the model and nothing that it covers has changed.
    pub stands: bool,
    /// Outcome that the certificate records for the model: `verified`, `not verified`, `refuted`; `None` where it does not
    /// cover the model.
    pub outcome: Option<String>,
    /// What has changed since the certificate was written, by name.
    pub changes: Vec<String>,
}

/// Maximum number of changes in the sentence.
const LISTED: usize = 3;

impl CertificateNote {
    /// Without a certificate.
    pub fn none() -> Self {
        Self::default()
    }

    /// A certificate that stands.
    pub fn stands(file: String, outcome: String) -> Self {
        Self {
            file: Some(file),
            stands: true,
            outcome: Some(outcome),
            changes: Vec::new(),
        }
    }

    /// A certificate that does not stand.
    pub fn changed(file: String, outcome: Option<String>, changes: Vec<String>) -> Self {
        Self {
            file: Some(file),
            stands: false,
            outcome,
            changes,
        }
    }

    /// The note as a sentence.
    pub fn sentence(&self) -> String {
        let Some(file) = &self.file else {
            return String::from("The model has no certificate of a verification.");
        };
        if self.stands {
            let outcome = self.outcome.as_deref().unwrap_or("not verified");
            return format!("Model {outcome}: the certificate {file} stands.");
        }
        let mut changes: Vec<&str> = self.changes.iter().map(String::as_str).collect();
        let more = changes.len().saturating_sub(LISTED);
        changes.truncate(LISTED);
        let more = match more {
            0 => String::new(),
            more => format!("; {more} more"),
        };
        format!(
            "The certificate {file} does not stand: {}{more}.",
            changes.join("; ")
        )
    }

    /// Whether the model is verified, by a certificate that stands.
    pub fn is_verified(&self) -> bool {
        self.stands && self.outcome.as_deref() == Some("verified")
    }
}

/// A report with the note on its model's certificate, as one JSON object.
#[derive(Debug, Serialize)]
pub struct WithCertificate<'a, R> {
    /// The report.
    #[serde(flatten)]
    pub report: &'a R,
    /// The note.
    pub certificate: &'a CertificateNote,
}
