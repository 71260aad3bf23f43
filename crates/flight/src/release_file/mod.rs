//! Parser of release files; it reports all faults of a file at once.

mod inputs;
mod throw;

use crate::initial_conditions::{Release, Stop, Vocabulary, built_in, own_wind, quaternion_fault};
use crate::toml_reader::{
    MAX_FILE_BYTES, Name, Reader, ReleaseError, Value, read_text, suggestion,
};
use crate::wind::WindField;
use model_spec::load::LoadError;
use model_spec::syntax::spelling::joined;
use std::ops::Range;
use std::path::Path;
use toml::de::DeTable;

/// Reads and parses a release file, the TOML file with the initial conditions of a flight; otherwise as [`read`].
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

/// Reads the release file `name`, or else the built-in one, as [`read`] or, `in_wind`, as [`read_in_wind`].
pub fn read_named(
    name: &str,
    in_wind: bool,
    vocabulary: impl FnOnce(&str) -> Result<Vocabulary, LoadError>,
) -> Result<(Release, Vocabulary), ReleaseError> {
    let path = Path::new(name);
    match built_in(name).filter(|_| !path.is_file()) {
        Some(text) => parse(name, text, &[], in_wind, vocabulary),
        None => read_text(path, "a release", MAX_FILE_BYTES, |file, text| {
            parse(file, text, &[], in_wind, vocabulary)
        }),
    }
}

/// Parses the text of a release file.
///
/// `file` is the name in messages; paths in the text are relative to its folder. `vocabulary` returns the names that a
/// model, given by name or path, defines; its error becomes a fault there. Winds by height and gusts, which change the
/// model, are rejected; [`read_in_wind`] accepts them.
///
/// # Errors
/// [`ReleaseError`] with all faults of the file.
pub fn read(
    file: &str,
    text: &str,
    vocabulary: impl FnOnce(&str) -> Result<Vocabulary, LoadError>,
) -> Result<Release, ReleaseError> {
    Ok(parse(file, text, &[], false, vocabulary)?.0)
}

/// Parses a release file that may specify winds by height and gusts; top-level keys `own_keys` are ignored. Also
/// returns the names of the model with the wind, [`Vocabulary::model`], which is the one to simulate.
///
/// # Errors
/// [`ReleaseError`] with all faults of the file.
pub fn read_in_wind(
    file: &str,
    text: &str,
    own_keys: &[&str],
    vocabulary: impl FnOnce(&str) -> Result<Vocabulary, LoadError>,
) -> Result<(Release, Vocabulary), ReleaseError> {
    parse(file, text, own_keys, true, vocabulary)
}

fn parse(
    file: &str,
    text: &str,
    own_keys: &[&str],
    in_wind: bool,
    vocabulary: impl FnOnce(&str) -> Result<Vocabulary, LoadError>,
) -> Result<(Release, Vocabulary), ReleaseError> {
    let mut reader = Reader::new(text);
    reader.folder = Path::new(file).parent().map(Path::to_path_buf);
    let release = reader.release(own_keys, in_wind, vocabulary);
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
        const KEYS: [&str; 10] = [
            "model",
            "duration",
            "until",
            "parameters",
            "coefficients",
            "initial",
            "throw",
            "wind",
            "known",
            "inputs",
        ];
        let keys = KEYS.iter().chain(own_keys).copied();
        self.known_keys(document, "", keys);

        let stop = self.stop(document);
        let Some(name) = document.get("model") else {
            self.missing("found no model; expected one, as in model = \"disc\"");
            return None;
        };
        let Some(model_name) = name.get_ref().as_str() else {
            return self.refuse_type(name, "model", "a name or a path, as in model = \"disc\"");
        };
        let of_file = self.beside(model_name);
        let mut vocabulary = match vocabulary(&of_file) {
            Ok(vocabulary) => vocabulary,
            Err(why) => return self.refuse(name.span(), why.to_string()),
        };
        let (mut wind, wind_field) = self.wind(document);
        if !document.contains_key("wind") {
            wind = vocabulary.model.as_deref().map_or(wind, own_wind);
        }
        if let (true, Some(table)) = (wind != [0.0; 3], document.get("wind"))
            && !vocabulary.inputs.iter().any(|input| input == "wind")
        {
            let found = format!("found a constant wind, but {model_name} has no input `wind`");
            return self.refuse(table.span(), found);
        }
        if let (Some(field), Some(table)) = (&wind_field, document.get("wind")) {
            if !in_wind {
                let message = "found a wind by height or gusts; expected only a constant wind here";
                return self.refuse(table.span(), message);
            }
            match vocabulary.in_wind(field) {
                Ok(composed) => vocabulary = composed,
                Err(why) => return self.refuse(table.span(), why),
            }
            self.stated_twice(document, field);
        }
        let (parameters, coefficients) = (&vocabulary.parameters, &vocabulary.coefficients);
        let [parameters, coefficients] = [
            self.constants(
                document,
                "parameters",
                &vocabulary,
                [parameters, coefficients],
            ),
            self.constants(
                document,
                "coefficients",
                &vocabulary,
                [coefficients, parameters],
            ),
        ];
        let is_throw = document.contains_key("throw");
        let initial = match is_throw {
            true => Vec::new(),
            false => self.initial(document, &vocabulary),
        };
        let known = self.known(document, &vocabulary);
        let (constant, inputs) = self.inputs(document, &vocabulary);
        let parameters = parameters.into_iter().chain(constant).collect();
        let mut release = Release {
            model: of_file,
            stop: stop?,
            parameters,
            coefficients,
            initial,
            wind,
            wind_field,
            known,
            inputs,
        };
        let model = vocabulary.model.as_deref();
        if let Some(fault) = model.and_then(|model| release.inertia_fault(model)) {
            let stated = ["parameters", "coefficients"].map(|key| document.get(key));
            let place = stated.into_iter().flatten().next();
            self.fault(place.map_or(name.span(), toml::Spanned::span), fault);
        } else if is_throw {
            self.throw(document, &vocabulary, &mut release);
        }
        Some((release, vocabulary))
    }

    /// Path of a model beside the file if there is such a model, else the name itself.
    fn beside(&self, model: &str) -> String {
        let path = self.folder.as_ref().map(|folder| folder.join(model));
        match path.filter(|path| path.is_file()) {
            Some(path) => path.display().to_string(),
            None => model.to_owned(),
        }
    }

    /// Records a fault for each entry of the table `[parameters]` that sets a parameter of the wind `field`.
    fn stated_twice(&mut self, document: &DeTable<'t>, field: &WindField) {
        let of_wind = field.parameters();
        for (name, span, _) in self.table(document, "parameters") {
            if of_wind.iter().any(|(own, _)| own == name) {
                let message = format!("{name} follows from [wind]; expected it only there");
                self.fault(span, message);
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
                let message = "found both until and duration; expected one of the two";
                self.refuse(until.span(), message)
            }
            (Some(value), None) => {
                let duration = self.number(value, "duration")?;
                let most = Release::MAX_DURATION;
                if !(duration > 0.0 && duration <= most) {
                    let message = format!(
                        "duration is {duration}; expected a time above 0 s and up to {most} s"
                    );
                    self.fault(value.span(), message);
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

    /// Entries of the table `key` by the names of the model; records a fault for a name that stands there twice.
    fn named<'d>(
        &mut self,
        document: &'d DeTable<'t>,
        key: &str,
    ) -> Vec<(String, Range<usize>, &'d Value<'t>)> {
        let mut found: Vec<(String, Range<usize>, &Value<'t>)> = Vec::new();
        for (written, span, value) in self.table(document, key) {
            let name = joined(written);
            if found.iter().any(|own| own.0 == name) {
                self.fault(span, format!("{name} is there twice, in two spellings"));
            } else {
                found.push((name, span, value));
            }
        }
        found
    }

    /// Parses the table `key` of the document, either `parameters` or `coefficients`, and returns its names and values.
    fn constants(
        &mut self,
        document: &DeTable<'t>,
        key: &str,
        vocabulary: &Vocabulary,
        [names, others]: [&[Name]; 2],
    ) -> Vec<(String, f64)> {
        let mut found = Vec::new();
        for (name, span, value) in self.named(document, key) {
            let name = name.as_str();
            let Some(known) = names.iter().find(|n| n.name == name) else {
                let message = if others.iter().any(|n| n.name == name) {
                    let other = match key {
                        "parameters" => "coefficients",
                        _ => "parameters",
                    };
                    format!("{name} is one of the model's {other}; expected it in [{other}]")
                } else if vocabulary.is_computed(name) {
                    format!("{name} is computed from other parameters; expected those")
                } else {
                    let hint = suggestion(name, names.iter().map(|n| &*n.name));
                    format!("the model has no {name:?} among its {key}{hint}")
                };
                self.fault(span, message);
                continue;
            };
            let Some(number) = self.number(value, name) else {
                continue;
            };
            if let Some(expected) = known.expected_instead_of(number) {
                let message = format!("{name} is {number}; expected {expected}");
                self.fault(value.span(), message);
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
        for (name, span, value) in self.named(document, "initial") {
            let Some(i) = states.iter().position(|s| *s == name) else {
                let hint = suggestion(&name, states.iter().map(|s| &**s));
                self.fault(span, format!("the model has no state {name:?}{hint}"));
                continue;
            };
            // An invalid number has its own fault; NaN prevents a second fault for a missing state.
            values[i] = Some(self.number(value, &name).unwrap_or(f64::NAN));
        }
        let absent = states
            .iter()
            .zip(&values)
            .filter(|(_, value)| value.is_none());
        let absent: Vec<&str> = absent.map(|(state, _)| &**state).collect();
        let table = document.get("initial");
        if !absent.is_empty() && table.is_none_or(|table| table.get_ref().is_table()) {
            let message = format!(
                "found no {} in [initial]; expected every state of the model",
                absent.join(", ")
            );
            match table {
                Some(table) => self.fault(table.span(), message),
                None => self.missing(message),
            }
        }
        let values = values.into_iter().map(|value| value.unwrap_or(f64::NAN));
        let initial: Vec<(String, f64)> = states.iter().cloned().zip(values).collect();
        if let Some(fault) = quaternion_fault(&initial, vocabulary.quaternions.iter().copied()) {
            self.fault(table.map_or(0..0, toml::Spanned::span), fault);
        }
        initial
    }

    fn known(
        &mut self,
        document: &DeTable<'t>,
        vocabulary: &Vocabulary,
    ) -> Vec<(String, [f64; 3])> {
        let inputs = vocabulary.inputs.iter().map(|input| &**input);
        let inputs = inputs.filter(|input| *input != "wind");
        let mut found = Vec::new();
        for (name, span, value) in self.named(document, "known") {
            if inputs.clone().any(|input| input == name) {
                found.extend(self.vector(value, &name).map(|v| (name, v)));
            } else {
                let mut scalars = vocabulary.scalar_inputs.iter();
                let message = if scalars.any(|own| own.name == name) {
                    format!("{name} is a scalar; expected it in [inputs]")
                } else if name == "wind" {
                    "wind stands here; expected it in [wind], as in constant = [3.0, 0.0, 0.0]"
                        .into()
                } else {
                    let hint = suggestion(&name, inputs.clone());
                    format!("the model has no input {name:?}{hint}")
                };
                self.fault(span, message);
            }
        }
        found
    }
}
