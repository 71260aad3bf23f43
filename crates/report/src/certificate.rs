//! Statement of a report about the verification certificate of its model.

use serde::Serialize;

/// Verification status of the model of a report, according to its certificate.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct CertificateNote {
    /// File name of the certificate; `None` if the model has no certificate.
    pub file: Option<String>,
    /// Whether the certificate is valid: it covers the model, and none of the inputs that it records (such as model
    /// source, options and versions) has changed since it was written.
    pub stands: bool,
    /// Outcome of the verification that the certificate records for the model: `verified`, `not verified` or `refuted`;
    /// `None` if the certificate does not cover the model.
    pub outcome: Option<String>,
    /// Descriptions of the reasons why the certificate is not valid, such as `generated Rust code changed`: changes of
    /// the model or of the verifying program since it was written, a model that it does not cover, or an unreadable
    /// file. Empty if the certificate is valid.
    pub changes: Vec<String>,
}

/// Maximum number of reasons for an invalid certificate that [`CertificateNote::sentence`] lists.
const LISTED: usize = 3;

impl CertificateNote {
    /// Note for a model that has no certificate.
    pub fn none() -> Self {
        Self::default()
    }

    /// Note for a certificate that is valid. `outcome` is the outcome of the verification that it records: `verified`,
    /// `not verified` or `refuted`.
    pub fn stands(file: String, outcome: String) -> Self {
        Self {
            file: Some(file),
            stands: true,
            outcome: Some(outcome),
            changes: Vec::new(),
        }
    }

    /// Note for a certificate that is not valid; `changes` describes the reasons, such as `generated Rust code
    /// changed`. `outcome` is the outcome of the verification that it records: `verified`, `not verified` or `refuted`;
    /// `None` if the certificate does not cover the model or is unreadable.
    pub fn changed(file: String, outcome: Option<String>, changes: Vec<String>) -> Self {
        Self {
            file: Some(file),
            stands: false,
            outcome,
            changes,
        }
    }

    /// Sentence for a report: the outcome of the verification, or the reason why the certificate is not valid.
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

    /// Whether the certificate is valid and records the model as verified.
    pub fn is_verified(&self) -> bool {
        self.stands && self.outcome.as_deref() == Some("verified")
    }
}

/// A report and the verification status of its model, serialized together as one JSON object.
#[derive(Debug, Serialize)]
pub struct WithCertificate<'a, R> {
    /// The report; its fields become fields of the JSON object, beside `certificate`.
    #[serde(flatten)]
    pub report: &'a R,
    /// Verification status of the report's model according to its certificate.
    pub certificate: &'a CertificateNote,
}
