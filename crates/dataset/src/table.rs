//! Reader of a flight's table: columns `t,m1_x,m1_y,m1_z,…` separated by commas, semicolons or tabs.

use std::path::Path;

use crate::takes::number::number;
use csv::{ReaderBuilder, StringRecord};

use super::AXES;
use super::header::{Header, separator};
use super::lines::Lines;
use super::place::CellLocations;
use super::recording::Recording;
use super::samples;
use super::sensor::{Reading, Sensor};
use super::words::shown;
use crate::input_error::InputError;

#[derive(Debug, Default, PartialEq)]
pub(super) struct Table {
    pub times: Vec<f64>,
    pub positions: Vec<Vec<Option<[f64; 3]>>>,
    pub readings: Vec<Vec<Option<Reading>>>,
}

pub(super) fn parse(
    file: &Path,
    text: &str,
    (markers, sensors): (&[&str], &[Sensor]),
    recording: &Recording,
) -> Result<Table, InputError> {
    let separator = separator(text);
    let mut reader = ReaderBuilder::new()
        .delimiter(separator as u8)
        .comment(Some(b'#'))
        .has_headers(false)
        .flexible(true)
        .from_reader(text.as_bytes());
    let mut lines = Lines {
        file,
        places: CellLocations { text, separator },
        quotes: text.contains('"'),
        start: 0,
    };
    let mut record = StringRecord::new();
    if !lines.next(&mut reader, &mut record)? {
        let first = markers.first().copied();
        let first = first.or_else(|| Some(sensors.first()?.name.as_str()));
        let expected = format!("a header such as t,{}_x,…", first.unwrap_or_default());
        return Err(InputError::at(file, (1, 1), "no header", expected));
    }
    let header = Header::new(&lines, &record, markers, sensors)?;
    let mut table = Table::default();
    while lines.next(&mut reader, &mut record)? {
        row(&lines, &record, &header, (markers, recording), &mut table)?;
    }
    if table.times.is_empty() {
        let place = lines.places.cell(text.len(), 0);
        return Err(InputError::at(
            file,
            place,
            "a header and no rows",
            "at least one sample",
        ));
    }
    Ok(table)
}

fn row(
    lines: &Lines<'_>,
    record: &StringRecord,
    header: &Header,
    (markers, recording): (&[&str], &Recording),
    table: &mut Table,
) -> Result<(), InputError> {
    if record.len() != header.width {
        let hint = if record.len() > header.width && lines.places.separator == ',' {
            " (decimal points, not commas?)"
        } else {
            ""
        };
        let expected = format!("{} as in the header{hint}", header.width);
        let found = format!("{} cells", record.len());
        return Err(lines.fault(record.len().min(header.width), found, expected));
    }
    let read = |index: usize| {
        let cell = record.get(index).unwrap_or_default().trim();
        number(cell).map_err(|expected| lines.fault(index, shown(cell), expected))
    };
    let Some(time) = read(header.time)? else {
        return Err(lines.fault(header.time, "no time", "the time of the sample, s"));
    };
    let time = recording.seconds(time);
    samples::check_time(table.times.first(), table.times.last(), time)
        .map_err(|(found, expected)| lines.fault(header.time, found, expected))?;
    let mut positions = Vec::with_capacity(markers.len());
    for (axes, marker) in header.columns.iter().zip(markers) {
        let mut point = [None; 3];
        for ((slot, &index), axis) in point.iter_mut().zip(axes).zip(AXES) {
            *slot = read(index)?.map(|value| recording.metres(value));
            if let Some(value) = *slot {
                samples::check_coordinate(&format_args!("{marker}_{axis}"), value)
                    .map_err(|(found, expected)| lines.fault(index, found, expected))?;
            }
        }
        // A marker with a missing coordinate counts as not seen: two coordinates do not define a point.
        positions.push(match point {
            [Some(x), Some(y), Some(z)] => Some([x, y, z]),
            _ => None,
        });
    }
    let mut readings = Vec::with_capacity(header.channels.len());
    for columns in &header.channels {
        readings.push(reading(lines, columns, read)?);
    }
    let most = samples::max_samples(markers.len() + header.channels.len());
    if table.times.len() >= most {
        let expected = format!("at most {most} samples");
        return Err(lines.fault(0, "a sample more", expected));
    }
    table.times.push(time);
    table.positions.push(positions);
    if !readings.is_empty() {
        table.readings.push(readings);
    }
    Ok(())
}

/// Maximum deviation of the norm of a measured quaternion from 1.
const MAX_NORM_ERROR: f64 = 0.02;

/// Reads one channel of a sensor from the cells in `columns`; `None` if a cell is empty, an error for a quaternion that
/// is not normalized.
fn reading(
    lines: &Lines<'_>,
    columns: &[usize],
    read: impl Fn(usize) -> Result<Option<f64>, InputError>,
) -> Result<Option<Reading>, InputError> {
    let mut reading: Reading = [0.0; 4];
    let mut is_complete = true;
    for (part, &index) in reading.iter_mut().zip(columns) {
        match read(index)? {
            Some(value) => *part = value,
            None => is_complete = false,
        }
    }
    if is_complete && columns.len() == 4 {
        let norm = reading.iter().map(|part| part * part).sum::<f64>().sqrt();
        if (norm - 1.0).abs() > MAX_NORM_ERROR {
            let found = format!("a quaternion of norm {norm:.3}");
            let expected = "a unit quaternion, scalar part first, body to inertial";
            return Err(lines.fault(columns[0], found, expected));
        }
    }
    Ok(is_complete.then_some(reading))
}
