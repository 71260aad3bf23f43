//! Status of a model with respect to a certificate.

use super::origin::folder_of;
use super::{Certificate, Change};
use crate::report::Outcome;
use model_spec::model::Model;
use std::path::Path;

/// Outcome that a certificate (record of a verification) states for a model, and whether it is still valid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Status {
    /// Recorded outcome of the model; `None` if the certificate does not cover the model.
    pub outcome: Option<Outcome>,
    /// Changes of the verifying program and of the model since the certificate was created, or a note that the
    /// certificate does not cover the model; empty if the certificate is still valid.
    pub changes: Vec<Change>,
}

impl Certificate {
    /// Determines the outcome that the certificate records for a model, and the changes of the verifying program and of
    /// the model since the certificate was created. `path` is the file of the certificate.
    pub fn status(&self, path: &Path, model: &Model) -> Status {
        let folder = folder_of(path);
        let same_text = |m: &&super::CertifiedModel| m.covers.has_texts(&model.sources);
        let mut changes = self.program.changes();
        let covered = self.models.iter().find(same_text);
        let mut same_name = self.models.iter().filter(|m| m.model == model.name);
        let certified = covered.or_else(|| same_name.next());
        let own = certified.map(|m| m.changes(&folder, self.options.seed));
        let what = match &own {
            None => Some("it does not cover this model"),
            Some(own) if covered.is_none() && own.is_empty() => {
                Some("it covers other effects or another text")
            }
            Some(_) => None,
        };
        changes.extend(what.map(|what| Change {
            model: Some(model.name.clone()),
            what: what.to_owned(),
        }));
        changes.extend(own.into_iter().flatten());
        Status {
            outcome: covered.map(|certified| certified.outcome),
            changes,
        }
    }
}
