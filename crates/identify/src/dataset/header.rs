//! Header of a flight's table: column indices of the time and the marker coordinates.

use std::collections::BTreeMap;

use csv::StringRecord;

use super::lines::Lines;
use super::words::{listed, meant, shown};
use crate::input_error::InputError;

/// Column indices of each marker's coordinates.
pub(super) struct Header {
    pub width: usize,
    pub time: usize,
    pub columns: Vec<[usize; 3]>,
}

/// Cell separator of a table: a semicolon or a tab if the header contains one, otherwise a comma.
pub(super) fn separator(text: &str) -> char {
    let header = text
        .split(['\n', '\r'])
        .map(str::trim)
        .find(|line| !line.is_empty() && !line.starts_with('#'));
    let mut quoted = false;
    let mut bare = header.unwrap_or_default().to_owned();
    bare.retain(|c| {
        quoted ^= c == '"';
        !quoted
    });
    [';', '\t']
        .into_iter()
        .find(|&separator| bare.contains(separator))
        .unwrap_or(',')
}

impl Header {
    pub fn new(
        lines: &Lines<'_>,
        record: &StringRecord,
        markers: &[&str],
    ) -> Result<Self, InputError> {
        let places: BTreeMap<&str, usize> = markers.iter().copied().zip(0..).collect();
        let mut time = None;
        let mut columns = vec![[usize::MAX; 3]; markers.len()];
        for (index, name) in record.iter().map(str::trim).enumerate() {
            let before = if name == "t" {
                time.replace(index)
            } else {
                let Some((marker, axis)) = split(name, &places) else {
                    let expected = expected_instead_of(name, markers);
                    return Err(lines.fault(
                        index,
                        format!("the column {}", shown(name)),
                        expected,
                    ));
                };
                let slot = &mut columns[marker][axis];
                let before = (*slot != usize::MAX).then_some(*slot);
                *slot = index;
                before
            };
            if before.is_some() {
                let found = format!("a second column {}", shown(name));
                return Err(lines.fault(index, found, "each column once"));
            }
        }
        let Some(time) = time else {
            let expected = "the time of each row, s, in a column t";
            return Err(lines.fault(0, "no column t", expected));
        };
        for (marker, axes) in markers.iter().zip(&columns) {
            if let Some(axis) = axes.iter().position(|&index| index == usize::MAX) {
                let found = format!("no column {marker}_{}", ["x", "y", "z"][axis]);
                return Err(lines.fault(0, found, "x, y and z of every marker"));
            }
        }
        Ok(Self {
            width: record.len(),
            time,
            columns,
        })
    }
}

fn split(name: &str, places: &BTreeMap<&str, usize>) -> Option<(usize, usize)> {
    let (marker, axis) = name.rsplit_once('_')?;
    let axis = ["x", "y", "z"].iter().position(|&known| known == axis)?;
    Some((*places.get(marker)?, axis))
}

fn expected_instead_of(name: &str, markers: &[&str]) -> String {
    let columns: Vec<String> = ["x", "y", "z"]
        .iter()
        .flat_map(|axis| markers.iter().map(move |marker| format!("{marker}_{axis}")))
        .collect();
    let near = meant(name, columns.iter().map(String::as_str).chain(["t"]));
    let known = listed(markers.iter().copied());
    format!("t, or _x, _y, _z of a declared marker: {known}{near}")
}
