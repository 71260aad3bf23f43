//! What a certificate says of a model that is used.

use super::origin::folder_of;
use super::{Certificate, Change};
use crate::report::Outcome;
use model_spec::model::Model;
use std::path::Path;

/// What a certificate says of a model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Status {
    /// Outcome that the certificate records for the model; `None` where it does not cover the model.
    pub outcome: Option<Outcome>,
    /// What has changed since; empty for a certificate that stands.
    pub changes: Vec<Change>,
}

impl Certificate {
    /// What the certificate in the file `path` says of a model: whether it covers the model's texts, those of its effects
    /// included, and whether these and the code made of them are as they were.
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
