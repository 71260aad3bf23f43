//! Typed access to TOML values with source locations; a value of the wrong type is an error that states what was
//! found.

use std::fmt::Display;
use std::ops::Range;
use std::path::Path;

pub(super) use flight::release::Value;
use flight::release::number_of;
use model_spec::location::line_and_column;
use toml::de::{DeTable, DeValue};

use super::words::{listed, meant, shown};
use crate::input_error::InputError;

/// One of several tables of a TOML document, with its byte range.
pub(super) type Entry<'d, 't> = (Range<usize>, &'d DeTable<'t>);

/// Path and text of a TOML document, used for the locations of errors.
pub(super) struct Fields<'a> {
    pub file: &'a Path,
    pub text: &'a str,
}

impl Fields<'_> {
    pub fn fault(
        &self,
        span: Range<usize>,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> InputError {
        let place = line_and_column(self.text, span.start);
        InputError::at(self.file, place, found, expected)
    }

    /// Error for the value of a key, shown as `found`.
    pub fn refused(
        &self,
        value: &Value<'_>,
        key: &str,
        found: impl Display,
        expected: impl Into<String>,
    ) -> InputError {
        self.fault(value.span(), format!("{key} = {found}"), expected)
    }

    fn wrong_kind(&self, value: &Value<'_>, key: &str, expected: &str) -> InputError {
        let found = match value.get_ref() {
            DeValue::String(text) => format!("the text {}", shown(text)),
            DeValue::Integer(number) => number.to_string(),
            DeValue::Float(number) => number.to_string(),
            DeValue::Boolean(truth) => truth.to_string(),
            DeValue::Array(items) => format!("a list of {}", items.len()),
            other => format!("a {}", other.type_str()),
        };
        self.refused(value, key, found, expected)
    }

    /// An error if the TOML table has a key not in `known`; `of` names the table in the message, as in ` in [noise]`.
    pub fn keys(&self, table: &DeTable<'_>, of: &str, known: &[&str]) -> Result<(), InputError> {
        let mut keys = table.keys();
        let Some(key) = keys.find(|key| !known.contains(&key.get_ref().as_ref())) else {
            return Ok(());
        };
        let name = key.get_ref();
        let found = format!("the key {}{of}", shown(name));
        let near = meant(name, known.iter().copied());
        Err(self.fault(key.span(), found, format!("{}{near}", listed(known))))
    }

    pub fn text(&self, value: &Value<'_>, key: &str, expected: &str) -> Result<String, InputError> {
        match value.get_ref() {
            DeValue::String(text) => Ok(text.to_string()),
            _ => Err(self.wrong_kind(value, key, expected)),
        }
    }

    /// Reads a boolean from the TOML value `value`; an error, which names `key`, for a value of another type.
    pub fn truth(&self, value: &Value<'_>, key: &str) -> Result<bool, InputError> {
        match value.get_ref() {
            DeValue::Boolean(truth) => Ok(*truth),
            _ => Err(self.wrong_kind(value, key, "true or false")),
        }
    }

    /// Reads a finite number from a TOML value; integers are accepted. An error, which names `key`, for other values.
    pub fn number(&self, value: &Value<'_>, key: &str) -> Result<f64, InputError> {
        match number_of(value) {
            Some(number) if number.is_finite() => Ok(number),
            Some(_) => Err(self.wrong_kind(value, key, "a finite number")),
            None => Err(self.wrong_kind(value, key, "a number")),
        }
    }

    pub fn vector(&self, value: &Value<'_>, key: &str) -> Result<[f64; 3], InputError> {
        let items = value.get_ref().as_array().map(|items| &items[..]);
        let Some([x, y, z]) = items else {
            return Err(self.wrong_kind(value, key, "three numbers, as in [0.0, 0.0, 0.0]"));
        };
        Ok([
            self.number(x, key)?,
            self.number(y, key)?,
            self.number(z, key)?,
        ])
    }

    /// The TOML table under a key of the document; `None` if the key is absent, an error if its value is not a table.
    pub fn table<'d, 't>(
        &self,
        document: &'d DeTable<'t>,
        key: &str,
    ) -> Result<Option<&'d DeTable<'t>>, InputError> {
        let expected = || format!("a table, as in [{key}]");
        let table = |value: &'d Value<'t>| {
            let table = value.get_ref().as_table();
            table.ok_or_else(|| self.wrong_kind(value, key, &expected()))
        };
        document.get(key).map(table).transpose()
    }

    /// The TOML array of tables under a key of the document, each with its byte range; empty if the key is absent.
    pub fn tables<'d, 't>(
        &self,
        document: &'d DeTable<'t>,
        key: &str,
    ) -> Result<Vec<Entry<'d, 't>>, InputError> {
        let Some(value) = document.get(key) else {
            return Ok(Vec::new());
        };
        let wrong = |value| self.wrong_kind(value, key, &format!("tables, as in [[{key}]]"));
        let Some(items) = value.get_ref().as_array() else {
            return Err(wrong(value));
        };
        let table = |item: &'d Value<'t>| match item.get_ref().as_table() {
            Some(table) => Ok((item.span(), table)),
            None => Err(wrong(item)),
        };
        items.iter().map(table).collect()
    }

    /// Items of the list `key` of a table; none without it.
    pub fn items<'d, 't>(
        &self,
        table: &'d DeTable<'t>,
        key: &str,
        expected: &str,
    ) -> Result<&'d [Value<'t>], InputError> {
        let Some(value) = table.get(key) else {
            return Ok(&[]);
        };
        let items = value.get_ref().as_array().map(|items| &items[..]);
        items.ok_or_else(|| self.refused(value, key, "no list", expected))
    }

    /// The value under the required key `key` of an entry. `expected` describes the value in the error for its absence.
    pub fn needed<'d, 't>(
        &self,
        (span, table): &Entry<'d, 't>,
        key: &str,
        expected: &str,
    ) -> Result<&'d Value<'t>, InputError> {
        let absent = || self.fault(span.clone(), format!("no {key}"), expected);
        table.get(key).ok_or_else(absent)
    }
}
