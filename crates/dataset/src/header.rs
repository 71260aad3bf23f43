//! Header of a flight's table: column indices of the time, the marker coordinates and the sensor channels.

use std::collections::BTreeMap;

use csv::StringRecord;

use super::AXES;
use super::lines::Lines;
use super::sensor::{Sensor, channels};
use super::words::{listed, meant, shown};
use crate::input_error::InputError;

/// Indices of the columns of a flight's table that hold the time, the coordinates of each marker and the sensor
/// readings, and the total number of columns.
pub(super) struct Header {
    pub width: usize,
    pub time: usize,
    pub columns: Vec<[usize; 3]>,
    /// Column indices of each sensor channel; the channels of all sensors follow one another.
    pub channels: Vec<Vec<usize>>,
}

/// Cell separator of the text of a flight's table: a semicolon or a tab if the header contains one, otherwise a comma.
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
        sensors: &[Sensor],
    ) -> Result<Self, InputError> {
        let endings = channels(sensors).map(|(_, endings)| endings.len());
        let mut channels: Vec<_> = endings.map(|count| vec![None; count]).collect();
        let of_sensor = names_of_sensors(sensors);
        let places: BTreeMap<&str, usize> = markers.iter().copied().zip(0..).collect();
        let mut time = None;
        let mut columns = vec![[None; 3]; markers.len()];
        for (index, name) in record.iter().map(str::trim).enumerate() {
            let slot: &mut Option<usize> = if name == "t" {
                &mut time
            } else if let Some(&(channel, part)) = of_sensor.get(name) {
                &mut channels[channel][part]
            } else {
                let Some((marker, axis)) = split(name, &places) else {
                    let expected = expected_instead_of(name, markers, &of_sensor);
                    return Err(lines.fault(
                        index,
                        format!("the column {}", shown(name)),
                        expected,
                    ));
                };
                &mut columns[marker][axis]
            };
            if slot.replace(index).is_some() {
                let found = format!("a second column {}", shown(name));
                return Err(lines.fault(index, found, "each column once"));
            }
        }
        let time = time.ok_or_else(|| {
            let expected = "the time of each row, s, in a column t";
            lines.fault(0, "no column t", expected)
        })?;
        let of_markers = markers.iter().zip(&columns).map(|(marker, found)| {
            let column = |axis: usize| {
                found[axis].ok_or_else(|| {
                    let missing = format!("no column {marker}_{}", AXES[axis]);
                    lines.fault(0, missing, "x, y and z of every marker")
                })
            };
            Ok([column(0)?, column(1)?, column(2)?])
        });
        let columns = of_markers.collect::<Result<_, InputError>>()?;
        let mut names = of_sensor.iter();
        if let Some((name, _)) = names.find(|(_, (c, part))| channels[*c][*part].is_none()) {
            let found = format!("no column {name}");
            return Err(lines.fault(0, found, "every column of every sensor"));
        }
        let channels = channels
            .into_iter()
            .map(|parts| parts.into_iter().flatten().collect())
            .collect();
        Ok(Self {
            width: record.len(),
            time,
            columns,
            channels,
        })
    }
}

/// Maps the name of each sensor column to the index of its channel (measured quantity) among the channels of all
/// sensors, and the index of the column within the channel.
fn names_of_sensors(sensors: &[Sensor]) -> BTreeMap<String, (usize, usize)> {
    let all = channels(sensors).enumerate();
    let each = all.flat_map(|(channel, (sensor, endings))| {
        let parts = endings.iter().enumerate();
        parts.map(move |(part, ending)| (format!("{}{ending}", sensor.name), (channel, part)))
    });
    each.collect()
}

fn split(name: &str, places: &BTreeMap<&str, usize>) -> Option<(usize, usize)> {
    let (marker, axis) = name.rsplit_once('_')?;
    let axis = AXES.iter().position(|&known| known == axis)?;
    Some((*places.get(marker)?, axis))
}

fn expected_instead_of(
    name: &str,
    markers: &[&str],
    of_sensor: &BTreeMap<String, (usize, usize)>,
) -> String {
    let columns: Vec<String> = AXES
        .iter()
        .flat_map(|axis| markers.iter().map(move |marker| format!("{marker}_{axis}")))
        .collect();
    let of_sensor: Vec<&str> = of_sensor.keys().map(String::as_str).collect();
    let all = columns
        .iter()
        .map(String::as_str)
        .chain(of_sensor.iter().copied());
    let near = meant(name, all.chain(["t"]));
    if !of_sensor.is_empty() {
        let known = columns.iter().map(String::as_str).chain(of_sensor);
        return format!("t, or {}{near}", listed(known));
    }
    let known = listed(markers);
    format!("t, or _x, _y, _z of a declared marker: {known}{near}")
}
