//! Reader of a flight's table: columns `t,m1_x,m1_y,m1_z,…` separated by commas, semicolons, tabs or spaces.

use std::path::Path;

use super::AXES;
use super::even_times::space_evenly;
use super::header::Header;
use super::inputs::InputColumns;
use super::lines::Lines;
use super::recording::Recording;
use super::samples;
use super::sensor::{Reading, Sensor};
use crate::input_error::InputError;

#[derive(Debug, Default, PartialEq)]
pub(super) struct Table {
    pub times: Vec<f64>,
    pub positions: Vec<Vec<Option<[f64; 3]>>>,
    pub readings: Vec<Vec<Option<Reading>>>,
    pub inputs: InputColumns,
    /// Unit of the last decimal place, s, of times that were rounded and are those of evenly spaced frames.
    pub rounded: Option<f64>,
}

pub(super) fn parse(
    file: &Path,
    text: &str,
    (markers, sensors): (&[&str], &[Sensor]),
    recording: &Recording,
) -> Result<Table, InputError> {
    let mut lines = Lines::new(file, text);
    if !lines.next()? {
        let first = markers.first().copied();
        let first = first.or_else(|| Some(sensors.first()?.name.as_str()));
        let expected = format!("a header such as t,{}_x,…", first.unwrap_or_default());
        return Err(InputError::at(file, (1, 1), "no header", expected));
    }
    let mut header = Header::new(&lines, markers, sensors)?;
    let mut table = Table {
        inputs: InputColumns::new(std::mem::take(&mut header.inputs)),
        ..Table::default()
    };
    while lines.next()? {
        row(&lines, &header, (markers, recording), &mut table)?;
    }
    if table.times.is_empty() {
        let place = lines.sheet.end();
        let found = "a header and no rows";
        return Err(InputError::at(file, place, found, "at least one sample"));
    }
    table.rounded = space_evenly(&mut table.times);
    Ok(table)
}

fn row(
    lines: &Lines<'_>,
    header: &Header,
    (markers, recording): (&[&str], &Recording),
    table: &mut Table,
) -> Result<(), InputError> {
    let width = lines.sheet.width();
    if width != header.width {
        let hint = match lines.sheet.separator() {
            ',' if width > header.width => " (decimal points, not commas?)",
            ' ' if width < header.width => " (NA for a missing value)",
            _ => "",
        };
        let expected = format!("{} as in the header{hint}", header.width);
        return Err(lines.fault(width.min(header.width), format!("{width} cells"), expected));
    }
    let fault = |index, (found, expected): samples::Unexpected| lines.fault(index, found, expected);
    let read = |index: usize| lines.number(index);
    let Some(time) = read(header.time)? else {
        return Err(lines.fault(header.time, "no time", "the time of the sample, s"));
    };
    let time = recording.seconds(time);
    samples::check_time(table.times.first(), table.times.last(), time)
        .map_err(|unexpected| fault(header.time, unexpected))?;
    let mut positions = Vec::with_capacity(markers.len());
    for (axes, marker) in header.columns.iter().zip(markers) {
        let mut point = [None; 3];
        for ((slot, &index), axis) in point.iter_mut().zip(axes).zip(AXES) {
            *slot = read(index)?.map(|value| recording.metres(value));
            if let Some(value) = *slot {
                samples::check_coordinate(&format_args!("{marker}_{axis}"), value)
                    .map_err(|unexpected| fault(index, unexpected))?;
            }
        }
        // A marker with a missing coordinate counts as not seen: two coordinates do not define a point.
        let [x, y, z] = point;
        positions.push(x.zip(y).zip(z).map(|((x, y), z)| [x, y, z]));
    }
    let readings = header
        .channels
        .iter()
        .map(|columns| reading(lines, columns, read));
    let readings = readings.collect::<Result<Vec<_>, InputError>>()?;
    table.inputs.row(lines, time)?;
    let most = samples::max_samples(markers.len() + header.channels.len() + table.inputs.len());
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

const MAX_NORM_ERROR: f64 = 0.02;

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
