//! Parsing of numbers and vectors in release files, and valid ranges of constants.

use super::{Reader, Value};
use toml::de::{DeTable, DeValue};

/// Name of a parameter or coefficient, with its bounds.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// Name of the parameter or coefficient in the model.
    pub name: String,
    /// Minimum and maximum value, SI; `None` if the model declares no bounds.
    pub bounds: Option<(f64, f64)>,
}

const POSITIVE_PARAMETERS: [&str; 6] = ["m", "I_a", "I_d", "d", "A", "radius"];
const NON_NEGATIVE_PARAMETERS: [&str; 2] = ["rho", "g"];

impl<'t> Reader<'t> {
    /// Parses an array of three finite numbers; records a fault and returns `None` for anything else.
    pub fn vector(&mut self, value: &Value<'t>, name: &str) -> Option<[f64; 3]> {
        let items: Vec<&Value<'t>> = value
            .get_ref()
            .as_array()
            .map(|a| a.iter().collect())
            .unwrap_or_default();
        let [x, y, z] = items[..] else {
            return self.refuse_type(value, name, "three numbers, as in [0.0, 0.0, 0.0]");
        };
        let numbers = [x, y, z].map(|item| self.number(item, name));
        Some([numbers[0]?, numbers[1]?, numbers[2]?])
    }

    /// Parses a finite number; records a fault and returns `None` for anything else.
    pub fn number(&mut self, value: &Value<'t>, name: &str) -> Option<f64> {
        match number_of(value) {
            Some(number) if number.is_finite() => return Some(number),
            Some(number) => {
                let message = format!("{name} is {number}; expected a finite number");
                self.fault(value.span(), message);
            }
            None => self.wrong_type(value, name, "a number"),
        }
        None
    }

    /// Parses a whole number within bounds that `f64` represents exactly; records a fault and returns `None` for anything else.
    pub fn whole(
        &mut self,
        value: &Value<'t>,
        name: &str,
        (least, greatest): (u64, u64),
    ) -> Option<u64> {
        let number = self.number(value, name)?;
        if number.fract() == 0.0 && number >= least as f64 && number <= greatest as f64 {
            return Some(number as u64);
        }
        let message =
            format!("{name} is {number}; expected a whole number from {least} to {greatest}");
        self.refuse(value.span(), message)
    }

    /// The table that `value` holds, the value of the key `name`; records a fault and returns `None` for anything else.
    pub fn as_table<'d>(&mut self, value: &'d Value<'t>, name: &str) -> Option<&'d DeTable<'t>> {
        let table = value.get_ref().as_table();
        if table.is_none() {
            self.wrong_type(value, name, &format!("a table, as in [{name}]"));
        }
        table
    }

    /// As [`wrong_type`](Self::wrong_type); returns `None`.
    pub fn refuse_type<V>(&mut self, value: &Value<'t>, name: &str, expected: &str) -> Option<V> {
        self.wrong_type(value, name, expected);
        None
    }

    /// Records a fault for the value of the key `name` of a wrong type; `expected` describes the valid values.
    pub fn wrong_type(&mut self, value: &Value<'t>, name: &str, expected: &str) {
        let found = match value.get_ref() {
            DeValue::String(text) if text.len() <= 40 => format!("the text {text:?}"),
            DeValue::Integer(number) => number.to_string(),
            DeValue::Float(number) => number.to_string(),
            DeValue::Boolean(b) => b.to_string(),
            DeValue::Array(items) => format!("a list of {}", items.len()),
            other => format!("a {}", other.type_str()),
        };
        self.fault(
            value.span(),
            format!("{name} is {found}; expected {expected}"),
        );
    }
}

/// Converts a TOML value to a number, finite or not; `None` if it is not numeric.
pub fn number_of(value: &Value<'_>) -> Option<f64> {
    match value.get_ref() {
        DeValue::Float(float) => float.as_str().parse::<f64>().ok(),
        DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix())
            .map(|i| i as f64)
            // Integers of more than 64 bits.
            .or_else(|_| integer.as_str().parse())
            .ok(),
        _ => None,
    }
}

impl Name {
    /// Description of the valid values of this parameter or coefficient if `value` is invalid; otherwise `None`.
    pub fn expected_instead_of(&self, value: f64) -> Option<String> {
        let named = |names: &[&str]| names.contains(&&*self.name);
        match self.bounds {
            Some((least, greatest)) if value < least || value > greatest => {
                Some(format!("a number from {least} to {greatest}"))
            }
            _ if named(&POSITIVE_PARAMETERS) && value <= 0.0 => Some("a number above 0".into()),
            _ if named(&NON_NEGATIVE_PARAMETERS) && value < 0.0 => {
                Some("0 or a number above".into())
            }
            _ => None,
        }
    }
}
