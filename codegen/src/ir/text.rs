//! Text of JSON: strings, numbers, lists and objects.

use std::fmt::Write;

/// Value that JSON cannot hold, and the place where it was found.
pub(super) struct NotFinite {
    pub(super) place: String,
    pub(super) value: f64,
}

/// Key of an object, and the JSON of its value.
pub(super) type Field = (&'static str, String);

/// Quoted string.
pub(super) fn string(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c < ' ' => {
                // Writing to a string cannot fail.
                let _ = write!(quoted, "\\u{:04x}", u32::from(c));
            }
            c => quoted.push(c),
        }
    }
    quoted + "\""
}

/// Number that is read back to the same bits.
pub(super) fn number(value: f64, place: &str) -> Result<String, NotFinite> {
    if value.is_finite() {
        return Ok(format!("{value:?}"));
    }
    let place = place.to_owned();
    Err(NotFinite { place, value })
}

/// List of numbers.
pub(super) fn numbers(values: &[f64], place: &str) -> Result<String, NotFinite> {
    let values = values.iter().map(|&value| number(value, place));
    Ok(row(values.collect::<Result<Vec<_>, _>>()?))
}

/// List on one line.
pub(super) fn row(items: impl IntoIterator<Item = String>) -> String {
    let items: Vec<String> = items.into_iter().collect();
    format!("[{}]", items.join(","))
}

/// List with an item per line.
pub(super) fn lines(items: impl IntoIterator<Item = String>) -> String {
    let items: Vec<String> = items.into_iter().collect();
    match items.is_empty() {
        true => "[]".into(),
        false => format!("[\n{}\n]", items.join(",\n")),
    }
}

/// Object whose fields are separated by `gap`: a line break or nothing.
pub(super) fn object(fields: &[Field], gap: &str) -> String {
    let fields = fields.iter();
    let fields: Vec<String> = fields
        .map(|(key, value)| format!("{}:{value}", string(key)))
        .collect();
    format!("{{{gap}{}{gap}}}", fields.join(&format!(",{gap}")))
}
