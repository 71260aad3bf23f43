//! Status of a model with respect to a certificate.

use super::origin::folder_of;
use super::{Certificate, Change};
use crate::report::Outcome;
use model_spec::model::Model;
use std::path::Path;

/// Outcome that a certificate records for a model, and whether it is still valid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Status {
    /// Recorded outcome of the model; `None` if the certificate does not cover the model.
    pub outcome: Option<Outcome>,
    /// Changes of program and model since the certificate was created, or a note that the certificate does not cover
    /// the model; empty if the certificate is still valid.
    pub changes: Vec<Change>,
}

impl Certificate {
    /// Determines the outcome that the certificate records for a model, and the changes of program and model since the
    /// certificate was created. `path` is the file of the certificate.
    pub fn status(&self, path: &Path, model: &Model) -> Status {
        let folder = folder_of(path);
        let same_text = |m: &&super::CertifiedModel| m.covers.has_texts(&model.sources);
        let mut changes = self.program.changes();
        match self.models.iter().find(same_text) {
            Some(certified) => {
                changes.extend(certified.changes(&folder, self.options.seed));
                Status {
                    outcome: Some(certified.outcome),
                    changes,
                }
            }
            None => {
                match self.models.iter().find(|m| m.model == model.name) {
                    Some(certified) => {
                        let own = certified.changes(&folder, self.options.seed);
                        if own.is_empty() {
                            changes.push(Change {
                                model: Some(model.name.clone()),
                                what: String::from("it covers other effects or another text"),
                            });
                        }
                        changes.extend(own);
                    }
                    None => changes.push(Change {
                        model: Some(model.name.clone()),
                        what: String::from("it does not cover this model"),
                    }),
                }
                Status {
                    outcome: None,
                    changes,
                }
            }
        }
    }
}
