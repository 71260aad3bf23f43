//! Parts of TOML texts that datasets are written as.

use super::{Flight, KnownValue};

/// The line with the known values of a flight in `dataset.toml`; empty without any.
pub(crate) fn known_text(flight: &Flight) -> String {
    let each = flight.known.iter().map(|(name, value)| match value {
        KnownValue::Scalar(value) => format!("{} = {value:?}", key(name)),
        KnownValue::Vector(value) => format!("{} = {value:?}", key(name)),
    });
    let all: Vec<String> = each.collect();
    match all.is_empty() {
        true => String::new(),
        false => format!("known = {{ {} }}\n", all.join(", ")),
    }
}

/// TOML list of names; `None` without names.
pub(crate) fn list(names: &[String]) -> Option<String> {
    let names: Vec<String> = names.iter().map(|name| quoted(name)).collect();
    (!names.is_empty()).then(|| format!("[{}]", names.join(", ")))
}

pub(crate) fn quoted(text: &str) -> String {
    toml::Value::from(text).to_string()
}

pub(crate) fn key(name: &str) -> String {
    let bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !name.is_empty() && name.chars().all(bare) {
        name.to_owned()
    } else {
        quoted(name)
    }
}
