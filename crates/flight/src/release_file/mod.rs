//! Parser of release files; it reports all faults of a file at once.

mod throw;

use crate::initial_conditions::{Release, Stop, Vocabulary, quaternion_fault};
use crate::toml_reader::{MAX_FILE_BYTES, Name, Reader, ReleaseError, read_text, suggestion};
use crate::wind::WindField;
use model_spec::load::LoadError;
use std::path::Path;
use toml::de::DeTable;

/// Reads and parses a release file, the TOML file with the initial conditions of a flight. `vocabulary` returns the
/// names defined by a model, given the model's name or path. Winds by height and gusts are rejected.
///
/// # Errors
/// [`ReleaseError`] with all faults of the file, also if it cannot be read or is larger than 1 MiB.
pub fn read_file(
    path: &Path,
    vocabulary: impl FnOnce(&str) -> Result<Vocabulary, LoadError>,
) -> Result<Release, ReleaseError> {
    read_text(path, "a release", MAX_FILE_BYTES, |file, text| {
        read(file, text, vocabulary)
    })
}

/// Reads and parses a release file, the TOML file with the initial conditions of a flight. Winds by height and gusts
/// are accepted. Also returns the names that the model defines after the wind has been added to it.
///
/// # Errors
/// [`ReleaseError`] as for [`read_file`].
pub fn read_file_in_wind(
    path: &Path,
    vocabulary: impl FnOnce(&str) -> Result<Vocabulary, LoadError>,
) -> Result<(Release, Vocabulary), ReleaseError> {
    read_text(path, "a release", MAX_FILE_BYTES, |file, text| {
        read_in_wind(file, text, &[], vocabulary)
    })
}

/// Parses the text of a release file.
///
/// `file` is the file name in error messages. `vocabulary` returns the names defined by a model, given the model's name
/// or path; an error of `vocabulary` becomes a fault at the location of that name. Winds by height and gusts, which
/// change the model, are rejected; [`read_in_wind`] accepts them.
///
/// # Errors
/// [`ReleaseError`] with all faults of the file.
pub fn read(
    file: &str,
    text: &str,
    vocabulary: impl FnOnce(&str) -> Result<Vocabulary, LoadError>,
) -> Result<Release, ReleaseError> {
    let mut reader = Reader::new(text);
    let release = reader.release(&[], false, vocabulary);
    let release = release.map(|(release, _)| release);
    reader.finish(file, release)
}

/// Parses the text of a release file, which may specify winds by height and gusts. The top-level keys `own_keys` are
/// allowed, but their values are ignored. Also returns the names defined by the model after the wind has been added to
/// it; the flight must be simulated with the model in [`Vocabulary::model`].
///
/// # Errors
/// [`ReleaseError`] with all faults of the file.
pub fn read_in_wind(
    file: &str,
    text: &str,
    own_keys: &[&str],
    vocabulary: impl FnOnce(&str) -> Result<Vocabulary, LoadError>,
) -> Result<(Release, Vocabulary), ReleaseError> {
    let mut reader = Reader::new(text);
    let release = reader.release(own_keys, true, vocabulary);
    reader.finish(file, release)
}

impl<'t> Reader<'t> {
    fn release(
        &mut self,
        own_keys: &[&str],
        in_wind: bool,
        vocabulary: impl FnOnce(&str) -> Result<Vocabulary, LoadError>,
    ) -> Option<(Release, Vocabulary)> {
        let document = self.document()?;
        let document = document.get_ref();
        const KEYS: [&str; 9] = [
            "model",
            "duration",
            "until",
            "parameters",
            "coefficients",
            "initial",
            "throw",
            "wind",
            "known",
        ];
        let keys = KEYS.iter().chain(own_keys).copied();
        self.known_keys(document, "", keys);

        let stop = self.stop(document);
        let Some(name) = document.get("model") else {
            self.missing("found no model; expected one, as in model = \"disc\"");
            return None;
        };
        let Some(model_name) = name.get_ref().as_str() else {
            self.wrong_type(name, "model", "a name or a path, as in model = \"disc\"");
            return None;
        };
        let mut vocabulary = match vocabulary(model_name) {
            Ok(vocabulary) => vocabulary,
            Err(why) => {
                self.fault(name.span(), why.to_string());
                return None;
            }
        };
        let (wind, wind_field) = self.wind(document);
        if let (true, Some(table)) = (wind != [0.0; 3], document.get("wind"))
            && !vocabulary.inputs.iter().any(|input| input == "wind")
        {
            let found = format!("found a constant wind, but {model_name} has no input `wind`");
            self.fault(table.span(), found);
            return None;
        }
        if let (Some(field), Some(table)) = (&wind_field, document.get("wind")) {
            if !in_wind {
                self.fault(
                    table.span(),
                    "found a wind by height or gusts; expected a constant wind alone here",
                );
                return None;
            }
            match vocabulary.in_wind(field) {
                Ok(composed) => vocabulary = composed,
                Err(why) => {
                    self.fault(table.span(), why.to_string());
                    return None;
                }
            }
            self.stated_twice(document, field);
        }
        let parameters = self.constants(
            document,
            "parameters",
            &vocabulary.parameters,
            &vocabulary.coefficients,
        );
        let coefficients = self.constants(
            document,
            "coefficients",
            &vocabulary.coefficients,
            &vocabulary.parameters,
        );
        let is_throw = document.contains_key("throw");
        let initial = match is_throw {
            true => Vec::new(),
            false => self.initial(document, &vocabulary),
        };
        let known = self.known(document, &vocabulary);
        let mut release = Release {
            model: model_name.into(),
            stop: stop?,
            parameters,
            coefficients,
            initial,
            wind,
            wind_field,
            known,
        };
        if is_throw {
            self.throw(document, &vocabulary, &mut release);
        }
        Some((release, vocabulary))
    }

    /// Records a fault for each entry of the table `[parameters]` that sets a parameter of the wind `field`; its value
    /// is determined by the table `[wind]`.
    fn stated_twice(&mut self, document: &DeTable<'t>, field: &WindField) {
        let of_wind = field.parameters();
        for (name, span, _) in self.table(document, "parameters") {
            if of_wind.iter().any(|(own, _)| own == name) {
                self.fault(
                    span,
                    format!("{name} follows from [wind]; expected it there alone"),
                );
            }
        }
    }

    fn stop(&mut self, document: &DeTable<'t>) -> Option<Stop> {
        match (document.get("duration"), document.get("until")) {
            (None, None) => {
                self.missing("found no end; expected duration = … (s) or until = \"ground\"");
                None
            }
            (Some(_), Some(until)) => {
                self.fault(
                    until.span(),
                    "found both until and duration; expected one of the two",
                );
                None
            }
            (Some(value), None) => {
                let duration = self.number(value, "duration")?;
                if !(duration > 0.0 && duration <= Release::MAX_DURATION) {
                    self.fault(
                        value.span(),
                        format!(
                            "duration is {duration}; expected a time above 0 s and up to {} s",
                            Release::MAX_DURATION
                        ),
                    );
                }
                Some(Stop::Duration(duration))
            }
            (None, Some(value)) => {
                if value.get_ref().as_str() != Some("ground") {
                    self.wrong_type(value, "until", "\"ground\"");
                }
                Some(Stop::Ground)
            }
        }
    }

    /// Parses the table `key` of the document, either `parameters` or `coefficients`, and returns its names and values.
    /// `names` are the names that are valid in this table. `others` are the names that are valid in the other of the
    /// two tables; the error message on such a name refers to that table.
    fn constants(
        &mut self,
        document: &DeTable<'t>,
        key: &str,
        names: &[Name],
        others: &[Name],
    ) -> Vec<(String, f64)> {
        let mut found = Vec::new();
        for (name, span, value) in self.table(document, key) {
            let Some(known) = names.iter().find(|n| n.name == name) else {
                if others.iter().any(|n| n.name == name) {
                    let other = if key == "parameters" {
                        "coefficients"
                    } else {
                        "parameters"
                    };
                    self.fault(
                        span,
                        format!("{name} is one of the model's {other}; expected it in [{other}]"),
                    );
                } else {
                    let hint = suggestion(name, names.iter().map(|n| &*n.name));
                    self.fault(
                        span,
                        format!("the model has no {name:?} among its {key}{hint}"),
                    );
                }
                continue;
            };
            let Some(number) = self.number(value, name) else {
                continue;
            };
            if let Some(expected) = known.expected_instead_of(number) {
                self.fault(
                    value.span(),
                    format!("{name} is {number}; expected {expected}"),
                );
            }
            found.push((name.to_string(), number));
        }
        found
    }

    fn initial(&mut self, document: &DeTable<'t>, vocabulary: &Vocabulary) -> Vec<(String, f64)> {
        let states = &vocabulary.states;
        let mut values = vec![None; states.len()];
        for &(state, value) in &vocabulary.optional {
            values[state] = Some(value);
        }
        for (name, span, value) in self.table(document, "initial") {
            let Some(i) = states.iter().position(|s| s == name) else {
                let hint = suggestion(name, states.iter().map(|s| &**s));
                self.fault(span, format!("the model has no state {name:?}{hint}"));
                continue;
            };
            // An invalid number has its own fault; NaN prevents a second fault for a missing state.
            values[i] = Some(self.number(value, name).unwrap_or(f64::NAN));
        }
        let absent: Vec<&str> = states
            .iter()
            .zip(&values)
            .filter(|(_, v)| v.is_none())
            .map(|(s, _)| &**s)
            .collect();
        let is_table = document
            .get("initial")
            .is_none_or(|t| t.get_ref().is_table());
        if !absent.is_empty() && is_table {
            let message = format!(
                "found no {} in [initial]; expected every state of the model",
                absent.join(", ")
            );
            match document.get("initial") {
                Some(table) => self.fault(table.span(), message),
                None => self.missing(message),
            }
        }
        let initial: Vec<(String, f64)> = states
            .iter()
            .zip(values)
            .map(|(name, v)| (name.clone(), v.unwrap_or(f64::NAN)))
            .collect();
        if let Some(fault) = quaternion_fault(&initial, vocabulary.quaternions.iter().copied()) {
            let span = document.get("initial").map_or(0..0, toml::Spanned::span);
            self.fault(span, fault);
        }
        initial
    }

    fn known(
        &mut self,
        document: &DeTable<'t>,
        vocabulary: &Vocabulary,
    ) -> Vec<(String, [f64; 3])> {
        let mut found = Vec::new();
        for (name, span, value) in self.table(document, "known") {
            let inputs = vocabulary
                .inputs
                .iter()
                .map(|i| &**i)
                .filter(|i| *i != "wind");
            if inputs.clone().any(|input| input == name) {
                found.extend(self.vector(value, name).map(|v| (name.to_string(), v)));
            } else {
                self.fault(
                    span,
                    format!(
                        "the model has no input {name:?}{}",
                        suggestion(name, inputs)
                    ),
                );
            }
        }
        found
    }
}
