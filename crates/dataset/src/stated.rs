//! What an entry of `dataset.toml` states of quantities in its flights: each quantity is stated once.

use std::ops::Range;

use flight::InputSeries;
use toml::de::DeTable;

use crate::KnownValue;
use crate::fields::Fields;
use crate::input_error::InputError;

/// What is expected instead of a value that a table states too.
pub(crate) const ONCE: &str = "each quantity of a flight once: take one of the two out";

/// A quantity that is known or unknown by an entry.
#[derive(Debug, PartialEq)]
pub(crate) struct Stated {
    name: String,
    /// Whether it is known, and not unknown.
    pub is_known: bool,
    /// Its place, as an error that does not say yet what is wrong.
    place: InputError,
}

impl Fields<'_> {
    /// The quantities that are known or unknown by an entry.
    ///
    /// # Errors
    /// [`InputError`] for one that is both, unless the standard deviation of the known value is stated.
    pub(crate) fn stated(&self, entry: &DeTable<'_>) -> Result<Vec<Stated>, InputError> {
        let stated = |is_known, name: &str, span: Range<usize>| Stated {
            name: name.to_owned(),
            is_known,
            place: self.fault(span, "", ""),
        };
        let known = self.table(entry, "known")?.into_iter().flatten();
        let known = known.map(|(name, _)| stated(true, name.get_ref(), name.span()));
        let mut all: Vec<Stated> = known.collect();
        let unknown = entry
            .get("unknown")
            .and_then(|value| value.get_ref().as_array());
        for item in unknown.into_iter().flatten() {
            let name = item.get_ref().as_str().unwrap_or_default();
            let sigma = format!("{name}{}", KnownValue::SIGMA);
            let own = stated(false, name, item.span());
            if all.iter().all(|own| own.name != sigma) {
                let line = own.place.place.map_or(0, |(line, _)| line);
                let known = all.iter().filter(|own| own.is_known);
                let expected = format!("one of the two; {sigma} makes the known value a prior");
                check(
                    known,
                    name,
                    &format!("under unknown in line {line}"),
                    &expected,
                )?;
            }
            all.push(own);
        }
        Ok(all)
    }
}

/// An error if one of `stated` is an input over time of the table `file`.
pub(crate) fn check_inputs(
    stated: &[Stated],
    file: &str,
    inputs: &[(String, InputSeries)],
) -> Result<(), InputError> {
    let also = format!("as a column of {file}");
    let mut each = inputs.iter();
    each.try_for_each(|(name, _)| check(stated, name, &also, ONCE))
}

/// An error if one of `stated` is `name`, which stands elsewhere too, as `also` says.
pub(crate) fn check<'s>(
    stated: impl IntoIterator<Item = &'s Stated>,
    name: &str,
    also: &str,
    expected: &str,
) -> Result<(), InputError> {
    let Some(own) = stated.into_iter().find(|own| own.name == name) else {
        return Ok(());
    };
    let key = if own.is_known { "known" } else { "unknown" };
    Err(InputError {
        found: format!("{name} under {key}, and {also}"),
        expected: expected.to_owned(),
        ..own.place.clone()
    })
}
