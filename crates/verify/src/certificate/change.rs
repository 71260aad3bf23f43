//! Compares what a certificate covers with the present state of models and program.

use super::{Certificate, CertifiedCheck, CertifiedModel, Fingerprint, Program, pairs};
use crate::certificate::origin::OriginError;
use crate::report::{Report, Verdict};
use model_spec::load::{Loaded, inspect};
use model_spec::model::Model;
use serde::Serialize;
use std::fmt;
use std::path::Path;

/// A difference between the current state of an item covered by a certificate (model source, generated code, program
/// version, verdict of a check) and its state when the certificate was created.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Change {
    /// Name of the model that changed; `None` for a change of the verifying program or of a comparison between models.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<String>,
    /// Description of the change, such as `generated Rust code changed`.
    pub what: String,
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.model {
            Some(model) => write!(f, "{model}: {}", self.what),
            None => f.write_str(&self.what),
        }
    }
}

impl Certificate {
    /// Lists the changes of the verifying program and of the models since the certificate (record of a verification)
    /// was created, as found by comparing hashes. `folder` is the folder of the certificate.
    pub fn changes(&self, folder: &Path) -> Vec<Change> {
        let mut changes = self.program.changes();
        for model in &self.models {
            changes.extend(model.changes(folder, self.options.seed));
        }
        changes
    }

    /// Lists the changes since the certificate (record of a verification) was created, as found by comparing hashes and
    /// by repeating the checks. `folder` is the folder of the certificate. Models for which `same` returns true
    /// describe the same motion and are compared with each other.
    pub fn changes_again(&self, folder: &Path, same: impl Fn(&Model) -> bool) -> Vec<Change> {
        let mut changes = self.changes(folder);
        let options = self.options.options();
        let mut models = Vec::new();
        for certified in &self.models {
            let Ok(loaded) = certified.load(folder) else {
                continue;
            };
            let report: Report = crate::run(&loaded, &options);
            let checks: Vec<CertifiedCheck> = report.rows.iter().map(Into::into).collect();
            let name = Some(certified.model.as_str());
            changes.extend(verdicts(name, &certified.checks, &checks));
            models.extend(loaded.model.filter(|model| same(model)));
        }
        let again = (models.len() > 1).then(|| crate::same_motion(&models, &options));
        changes.extend(verdicts(None, &self.same_motion, &pairs(again.as_ref())));
        changes
    }
}

impl Program {
    pub(super) fn changes(&self) -> Vec<Change> {
        let present = Self::present();
        let mut changes = Vec::new();
        let mut change = |what: String| changes.push(Change { model: None, what });
        if self.version != present.version {
            change(format!(
                "program version: {}, now {}",
                self.version, present.version
            ));
        }
        if self.effects != present.effects {
            change(String::from("built-in effects of the program changed"));
        }
        changes
    }
}

impl CertifiedModel {
    pub(super) fn changes(&self, folder: &Path, seed: u64) -> Vec<Change> {
        let change = |what: String| Change {
            model: Some(self.model.clone()),
            what,
        };
        let loaded = match self.load(folder) {
            Ok(loaded) => loaded,
            Err(why) => return vec![change(why.to_string())],
        };
        let Some(model) = &loaded.model else {
            return vec![change(String::from("its text is refused by the checker"))];
        };
        let now = Fingerprint::of(model, &loaded.sources, folder, seed);
        self.covers
            .differences(&now)
            .into_iter()
            .map(change)
            .collect()
    }

    fn load(&self, folder: &Path) -> Result<Loaded, OriginError> {
        let name = self.from.found(folder)?;
        let effects = self.with.iter().map(|origin| origin.found(folder));
        let effects = effects.collect::<Result<Vec<String>, OriginError>>()?;
        let effects: Vec<&str> = effects.iter().map(String::as_str).collect();
        Ok(inspect(&name, &effects)?)
    }
}

impl Fingerprint {
    /// Describes each change from these recorded hashes to the current hashes `now`, for example `source kite.hyz
    /// changed`.
    fn differences(&self, now: &Self) -> Vec<String> {
        let mut changes = Vec::new();
        for source in &self.sources {
            match now.sources.iter().find(|other| other.name == source.name) {
                Some(other) if other.sha256 == source.sha256 => {}
                Some(_) => changes.push(format!("source {} changed", source.name)),
                None => changes.push(format!("source {} is no part of it now", source.name)),
            }
        }
        for source in &now.sources {
            if !self.sources.iter().any(|other| other.name == source.name) {
                changes.push(format!("source {} is new", source.name));
            }
        }
        if changes.is_empty() && self.sources != now.sources {
            changes.push(String::from("sources are in another order"));
        }
        let code = [
            ("schedule", &self.schedule, &now.schedule),
            ("generated Rust code", &self.rust, &now.rust),
            ("results of the tape", &self.results, &now.results),
        ];
        for (name, before, after) in code {
            if before != after {
                changes.push(format!("{name} changed"));
            }
        }
        changes
    }
}

/// Changes from the recorded checks `before` to the repeated checks `after`: differing verdicts, and checks that only
/// one of the two lists contains.
fn verdicts(
    model: Option<&str>,
    before: &[CertifiedCheck],
    after: &[CertifiedCheck],
) -> Vec<Change> {
    let change = |what: String| Change {
        model: model.map(str::to_owned),
        what,
    };
    let word = |verdict: Verdict| match verdict {
        Verdict::Holds => "holds",
        Verdict::Refuted => "refuted",
        Verdict::Skipped => "skipped",
        Verdict::Unverified => "not verified",
    };
    let mut changes = Vec::new();
    for old in before {
        match after.iter().find(|new| new.check == old.check) {
            Some(new) if new.verdict == old.verdict => {}
            Some(new) => changes.push(change(format!(
                "check `{}`: {}, now {}",
                old.check,
                word(old.verdict),
                word(new.verdict)
            ))),
            None => changes.push(change(format!("check `{}` is not made now", old.check))),
        }
    }
    for new in after {
        if !before.iter().any(|old| old.check == new.check) {
            changes.push(change(format!("check `{}` is new", new.check)));
        }
    }
    changes
}
