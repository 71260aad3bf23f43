//! Header of a flight's table: column indices of the time, the marker coordinates and the sensor channels.

use std::collections::{BTreeMap, BTreeSet};

use super::AXES;
use super::inputs::InputColumns;
use super::lines::Lines;
use super::sensor::{Sensor, channels};
use super::words::{listed, meant, shown};
use crate::input_error::InputError;

/// Column indices of the time, of the coordinates of each marker and of the sensor channels, one after another.
pub(super) struct Header {
    pub width: usize,
    pub time: usize,
    pub columns: Vec<[usize; 3]>,
    pub channels: Vec<Vec<usize>>,
    /// Columns that belong to no marker and no sensor: inputs, with their indices.
    pub inputs: Vec<(String, usize)>,
}

impl Header {
    /// Reads the header, which is the current row.
    pub fn new(
        lines: &Lines<'_>,
        markers: &[&str],
        sensors: &[Sensor],
    ) -> Result<Self, InputError> {
        let axis = |axis| markers.iter().map(move |marker| format!("{marker}_{axis}"));
        let of_sensors = channels(sensors).flat_map(|(sensor, endings)| {
            let endings = endings.iter();
            endings.map(move |ending| format!("{}{ending}", sensor.name))
        });
        let names = std::iter::once("t".to_owned()).chain(AXES.into_iter().flat_map(axis));
        let names: Vec<String> = names.chain(of_sensors).collect();
        let places: BTreeMap<&str, usize> = names.iter().map(String::as_str).zip(0..).collect();
        let mut found = vec![None; names.len()];
        let mut others: Vec<(String, usize)> = Vec::new();
        for (index, name) in lines.sheet.cells().iter().enumerate() {
            let Some(&place) = places.get(name.as_str()) else {
                others.push((name.clone(), index));
                continue;
            };
            if found[place].replace(index).is_some() {
                let found = format!("a second column {}", shown(name));
                return Err(lines.fault(index, found, "each column once"));
            }
        }
        let is_complete = found.iter().all(Option::is_some);
        let devices: Vec<&str> = markers
            .iter()
            .copied()
            .chain(sensors.iter().map(|own| &*own.name))
            .collect();
        let is_input = |name: &str| is_complete && InputColumns::may_be(name, &devices);
        if let Some((name, index)) = others.iter().find(|(name, _)| !is_input(name)) {
            let expected = expected_instead_of(name, markers, &names);
            return Err(lines.fault(*index, format!("the column {}", shown(name)), expected));
        }
        let mut seen = BTreeSet::new();
        if let Some((name, index)) = others.iter().find(|(name, _)| !seen.insert(name)) {
            let found = format!("a second column {}", shown(name));
            return Err(lines.fault(*index, found, "each column once"));
        }
        let count = markers.len();
        let first_of_sensors = 1 + 3 * count;
        if let Some(missing) = found.iter().position(Option::is_none) {
            let expected = match missing {
                0 => "the time of each row, s, in a column t",
                _ if missing < first_of_sensors => "x, y and z of every marker",
                _ => "every column of every sensor",
            };
            return Err(lines.fault(0, format!("no column {}", names[missing]), expected));
        }
        let found: Vec<usize> = found.into_iter().flatten().collect();
        let mut of_sensors = found[first_of_sensors..].iter().copied();
        Ok(Self {
            width: found.len() + others.len(),
            time: found[0],
            columns: (1..=count)
                .map(|marker| [0, 1, 2].map(|axis| found[axis * count + marker]))
                .collect(),
            channels: channels(sensors)
                .map(|(_, endings)| of_sensors.by_ref().take(endings.len()).collect())
                .collect(),
            inputs: others,
        })
    }
}

/// Valid columns instead of `name`; `names` are those of all columns, the first is that of the time.
fn expected_instead_of(name: &str, markers: &[&str], names: &[String]) -> String {
    let all = names[1..].iter().chain(&names[..1]);
    let near = meant(name, all.map(String::as_str));
    if names.len() > 1 + 3 * markers.len() {
        return format!("t, or {}{near}", listed(&names[1..]));
    }
    let known = listed(markers);
    format!("t, or _x, _y, _z of a declared marker: {known}{near}")
}
