//! What the device of an export did not measure.

use std::collections::BTreeSet;

use super::cells::Numerals;
use crate::words::listed;

/// What the device did not measure, by the other columns of its export.
pub(super) fn notes(
    headers: &[String],
    rows: &[(usize, Vec<String>)],
    numerals: Numerals,
) -> Vec<String> {
    let place = |name: &str| {
        headers
            .iter()
            .position(|own| own.eq_ignore_ascii_case(name))
    };
    let values = |place: usize| rows.iter().filter_map(move |(_, cells)| cells.get(place));
    let mut notes = Vec::new();
    if let Some(length) = place("Last data Point - Length") {
        let mean = |place: Option<usize>| {
            let all = place.into_iter().flat_map(&values);
            let all: Vec<f64> = all.filter_map(|cell| numerals.number(cell)).collect();
            all.iter().sum::<f64>() / all.len() as f64
        };
        let (far, time) = (mean(Some(length)), mean(place("Last data Point - Time")));
        notes.push(format!(
            "the outcomes are the launch monitor's extrapolation from its last measured point, {far:.1} yd and {time:.2} s after launch: the fit describes the device's model"
        ));
    }
    if let Some(kind) = place("Spin Rate Type") {
        let all = values(kind).filter(|cell| !cell.trim().is_empty()).count();
        let estimated = values(kind).filter(|cell| cell.eq_ignore_ascii_case("estimated"));
        let count = estimated.count();
        if count > 0 {
            notes.push(format!(
                "the spin of {count} of {all} shots is estimated by the device, not measured"
            ));
        }
    }
    let flat = headers
        .iter()
        .any(|header| header.to_lowercase().contains("flat"));
    if flat {
        notes
            .push("the outcomes are normalised to flat ground at the height of the tee".to_owned());
    }
    let is_normalised = |header: &&String| header.to_lowercase().contains("normalized");
    let normalised: BTreeSet<&String> = headers.iter().filter(is_normalised).collect();
    if !normalised.is_empty() {
        let names = listed(normalised);
        notes.push(format!(
            "{names}: normalised by the device to a standard day"
        ));
    }
    notes
}
