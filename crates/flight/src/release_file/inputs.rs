//! Parser of the table `[inputs]` of a release file: scalar inputs, constant or over time.

use std::path::PathBuf;

use toml::de::DeTable;

use crate::files::bounded_text;
use crate::initial_conditions::Vocabulary;
use crate::inputs::{END_TOLERANCE, read_inputs};
use crate::toml_reader::{Reader, Value, suggestion};
use crate::{InputInterpolation, InputSeries};

/// Maximum size of a table of inputs, bytes.
const MAX_TABLE_BYTES: u64 = 1 << 28;

/// Inputs of a release: constant ones with their values, SI, and those over time.
pub(super) type Inputs = (Vec<(String, f64)>, Vec<(String, InputSeries)>);

impl<'t> Reader<'t> {
    /// Parses the table `[inputs]`: a number, `{ t = […], value = […] }` or `{ file = "…", column = "…" }` for each.
    pub(super) fn inputs(&mut self, document: &DeTable<'t>, vocabulary: &Vocabulary) -> Inputs {
        let names = &vocabulary.scalar_inputs;
        let (mut constant, mut over_time) = (Vec::new(), Vec::new());
        for (name, span, value) in self.table(document, "inputs") {
            let Some(known) = names.iter().find(|own| own.name == name) else {
                let hint = suggestion(name, names.iter().map(|own| &*own.name));
                let message = match vocabulary.inputs.iter().any(|own| own == name) {
                    true => format!("{name} is a vector; expected it in [known], or in [wind]"),
                    false => format!("the model has no scalar input {name:?}{hint}"),
                };
                self.fault(span, message);
                continue;
            };
            let parameters = document
                .get("parameters")
                .and_then(|own| own.get_ref().as_table());
            if parameters.is_some_and(|own| own.contains_key(name)) {
                let message = format!("{name} is in [parameters] too; expected it only here");
                self.fault(span, message);
            }
            if let Some(table) = value.get_ref().as_table() {
                let series = self.series(name, value, table);
                if let Some((begin, end)) = series.as_ref().map(InputSeries::span)
                    && begin > END_TOLERANCE
                {
                    let message = format!(
                        "{name} is given from {begin} to {end} s, and the flight begins at 0 s; expected values from there on"
                    );
                    self.fault(value.span(), message);
                }
                let samples = series.iter().flat_map(InputSeries::samples);
                let outside = samples.filter_map(|(t, own)| {
                    let expected = known.expected_instead_of(own)?;
                    Some(format!("{name} is {own} at {t} s; expected {expected}"))
                });
                if let Some(message) = outside.take(1).next() {
                    self.fault(value.span(), message);
                }
                over_time.extend(series.map(|series| (name.to_owned(), series)));
            } else if let Some(number) = self.number(value, name) {
                if let Some(expected) = known.expected_instead_of(number) {
                    self.fault(
                        value.span(),
                        format!("{name} is {number}; expected {expected}"),
                    );
                }
                constant.push((name.to_owned(), number));
            }
        }
        (constant, over_time)
    }

    fn series(
        &mut self,
        name: &str,
        value: &Value<'t>,
        table: &DeTable<'t>,
    ) -> Option<InputSeries> {
        let keys = ["t", "value", "file", "column", "interpolation"];
        self.known_keys(table, &format!(" in {name}"), keys.into_iter());
        let interpolation = self.interpolation(table)?;
        match (table.get("t"), table.get("value"), table.get("file")) {
            (Some(times), Some(values), None) => {
                let (times, values) = (self.numbers(times, "t")?, self.numbers(values, "value")?);
                if times.len() != values.len() || times.is_empty() {
                    let message = format!(
                        "{name} has {} times and {} values; expected as many of both, at least one",
                        times.len(),
                        values.len()
                    );
                    return self.refuse(value.span(), message);
                }
                if let Some(pair) = times.windows(2).find(|pair| pair[1] <= pair[0]) {
                    let message = format!(
                        "the times of {name} have {} after {}; expected increasing ones",
                        pair[1], pair[0]
                    );
                    return self.refuse(value.span(), message);
                }
                let samples: Vec<(f64, f64)> = times.into_iter().zip(values).collect();
                Some(InputSeries::new(&samples, interpolation))
            }
            (None, None, Some(file)) => self.column_of_file(name, file, table, interpolation),
            _ => {
                let expected = "{ t = […], value = […] } or { file = \"…\", column = \"…\" }";
                self.refuse(
                    value.span(),
                    format!("{name} is incomplete; expected {expected}"),
                )
            }
        }
    }

    fn interpolation(&mut self, table: &DeTable<'t>) -> Option<InputInterpolation> {
        let Some(value) = table.get("interpolation") else {
            return Some(InputInterpolation::default());
        };
        let names = InputInterpolation::NAMES.iter();
        let word = value.get_ref().as_str();
        let known = names.clone().find(|(own, _)| Some(*own) == word);
        if known.is_none() {
            let words: Vec<&str> = names.map(|(own, _)| *own).collect();
            self.wrong_type(value, "interpolation", &words.join(", "));
        }
        known.map(|(_, interpolation)| *interpolation)
    }

    fn numbers(&mut self, value: &Value<'t>, name: &str) -> Option<Vec<f64>> {
        let Some(items) = value.get_ref().as_array() else {
            return self.refuse_type(value, name, "a list of numbers");
        };
        items.iter().map(|item| self.number(item, name)).collect()
    }

    /// Reads a column of a table, whose path is relative to the release file.
    fn column_of_file(
        &mut self,
        name: &str,
        value: &Value<'t>,
        table: &DeTable<'t>,
        interpolation: InputInterpolation,
    ) -> Option<InputSeries> {
        let Some(file) = value.get_ref().as_str() else {
            return self.refuse_type(value, "file", "the path of a table in quotes");
        };
        let column = table
            .get("column")
            .map_or(Some(name), |own| own.get_ref().as_str());
        let Some(column) = column else {
            return self.refuse(
                value.span(),
                format!("the column of {name} is no text; expected a name"),
            );
        };
        let path = self
            .folder
            .as_ref()
            .map_or_else(|| PathBuf::from(file), |own| own.join(file));
        let place = path.display();
        let text = match bounded_text(&path, MAX_TABLE_BYTES, "a table of inputs") {
            Ok(text) => text,
            Err(error) => {
                return self.refuse(value.span(), format!("{place}: {error}"));
            }
        };
        let inputs = match read_inputs(&text, interpolation, |time| time) {
            Ok(inputs) => inputs,
            Err(fault) => {
                let ((line, cell), found) = (fault.location.place(), fault.found);
                let expected = fault.expected;
                let message = format!("{place}:{line}:{cell}: found {found}; expected {expected}");
                return self.refuse(value.span(), message);
            }
        };
        let hint = suggestion(column, inputs.iter().map(|(own, _)| &**own));
        let found = inputs.into_iter().find(|(own, _)| own == column);
        if found.is_none() {
            self.fault(
                value.span(),
                format!("{place} has no column {column:?}{hint}"),
            );
        }
        found.map(|(_, series)| series)
    }
}
