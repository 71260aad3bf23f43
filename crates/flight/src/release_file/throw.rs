//! Parser of the table `[throw]` of a release file.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::de::DeTable;

use crate::initial_conditions::{Release, Vocabulary};
use crate::throw::{FIELDS, Throw, ThrowError, ThrownModel};
use crate::toml_reader::{Reader, suggestion};

impl<'t> Reader<'t> {
    pub(super) fn throw(
        &mut self,
        document: &DeTable<'t>,
        vocabulary: &Vocabulary,
        release: &mut Release,
    ) {
        let table = document.get("throw").map_or(0..0, toml::Spanned::span);
        if document.contains_key("initial") {
            self.fault(
                table.clone(),
                "found both [throw] and [initial]; expected one of the two",
            );
            return;
        }
        let faults = self.faults_count();
        let mut throw = Throw::at_speed(f64::NAN);
        let mut places: BTreeMap<&str, Range<usize>> = BTreeMap::new();
        let names = FIELDS.iter().map(|(name, ..)| *name);
        for (name, span, value) in self.table(document, "throw") {
            if !names.clone().any(|known| known == name) {
                let hint = suggestion(name, names.clone());
                self.fault(span, format!("unknown key {name:?} in [throw]{hint}"));
            } else if let Some(number) = self.number(value, name) {
                places.insert(name, value.span());
                throw.set(name, number);
                // Ranges are checked one by one, so that all faults are reported.
                if let Err(fault) = Throw::check_field(name, number) {
                    self.fault(value.span(), fault.to_string());
                }
            }
        }
        if self.faults_count() > faults {
            return;
        }
        if throw.speed.is_nan() {
            self.fault(
                table,
                "found no speed in [throw]; expected one, as in speed = 20.0 (m/s)",
            );
            return;
        }
        match initial(&throw, vocabulary, release) {
            Ok(initial) => release.initial = initial,
            Err(fault) => {
                let span = fault.field().and_then(|field| places.get(field).cloned());
                self.fault(span.unwrap_or(table), fault.to_string());
            }
        }
    }
}

fn initial(
    throw: &Throw,
    vocabulary: &Vocabulary,
    release: &Release,
) -> Result<Vec<(String, f64)>, ThrowError> {
    let model = vocabulary
        .model
        .as_ref()
        .ok_or_else(|| ThrowError::NoBody(release.model.clone()))?;
    let thrown = ThrownModel::new(model)?;
    let parameters = thrown.release_parameters(release);
    let state = thrown.state(throw, [0.0; 2], &parameters)?;
    Ok(vocabulary.states.iter().cloned().zip(state).collect())
}
