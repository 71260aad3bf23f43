//! Text of the tables of summaries, and of their entries in `dataset.toml`.

use std::fmt::Write as _;

use crate::sensor::channels;
use crate::toml_text::{known_text, list, quoted};
use crate::{Dataset, Flight, Role, Sensor, SensorKind};

/// Table and line of a flight that is a row of a table of summaries; `None` for another flight.
fn table_of<'f>(flight: &'f Flight, sensors: &[Sensor]) -> Option<(&'f str, usize)> {
    let (file, line) = flight.file.rsplit_once(':')?;
    let line = line.parse().ok()?;
    is_of(flight, sensors).then_some((file, line))
}

/// Whether a flight is a row of a table of summaries.
pub(crate) fn is_of(flight: &Flight, sensors: &[Sensor]) -> bool {
    let [row] = flight.readings.as_slice() else {
        return false;
    };
    let pairs = channels(sensors).zip(row);
    let is_summary = |sensor: &Sensor| matches!(sensor.kind, SensorKind::Summary(_));
    pairs
        .into_iter()
        .any(|((sensor, _), reading)| is_summary(sensor) && reading.is_some())
}

/// A table of summaries of a dataset: its name, the indices of its flights, and those of its columns among the channels.
struct Table<'d> {
    file: &'d str,
    rows: Vec<(usize, &'d Flight)>,
    columns: Vec<(usize, &'d Sensor)>,
}

fn of_dataset(dataset: &Dataset) -> Vec<Table<'_>> {
    let mut tables: Vec<Table<'_>> = Vec::new();
    for flight in &dataset.flights {
        let Some((file, line)) = table_of(flight, &dataset.sensors) else {
            continue;
        };
        let row = (line, flight);
        match tables.iter_mut().find(|table| table.file == file) {
            Some(table) => table.rows.push(row),
            None => tables.push(Table {
                file,
                rows: vec![row],
                columns: Vec::new(),
            }),
        }
    }
    for table in &mut tables {
        table.rows.sort_by_key(|(line, _)| *line);
        let used = |channel: usize| {
            let values = |flight: &Flight| flight.readings[0].get(channel).copied().flatten();
            table
                .rows
                .iter()
                .any(|(_, flight)| values(flight).is_some())
        };
        let all = channels(&dataset.sensors).enumerate();
        let own = all.filter(|(channel, (sensor, _))| {
            matches!(sensor.kind, SensorKind::Summary(_)) && used(*channel)
        });
        table.columns = own
            .map(|(channel, (sensor, _))| (channel, sensor))
            .collect();
    }
    tables
}

/// Names and texts of the tables of summaries of a dataset. Lines without a flight are blank.
pub(crate) fn tables(dataset: &Dataset) -> Vec<(String, String)> {
    let each = of_dataset(dataset).into_iter().map(|table| {
        let headers = table.columns.iter();
        let mut text = header_line(headers.map(|(_, sensor)| sensor.name.as_str()));
        let mut line = 1;
        for (at, flight) in &table.rows {
            while line < *at {
                text.push('\n');
                line += 1;
            }
            let values = table.columns.iter().map(|(channel, _)| {
                let reading = flight.readings[0][*channel];
                reading.map_or_else(String::new, |reading| reading[0].to_string())
            });
            text += &values.collect::<Vec<_>>().join(",");
        }
        text.push('\n');
        (table.file.to_owned(), text)
    });
    each.collect()
}

/// First line of a table with these headers. A header alone is in quotes if spaces would make several of it.
pub(crate) fn header_line<'h>(headers: impl Iterator<Item = &'h str>) -> String {
    let cells: Vec<String> = headers.map(cell).collect();
    match cells.as_slice() {
        [one] if one.contains(' ') && !one.starts_with('"') => format!("\"{one}\""),
        _ => cells.join(","),
    }
}

/// A header as a field of a line of a table.
fn cell(header: &str) -> String {
    match header.contains([',', '"', ';', '\t']) {
        true => format!("\"{}\"", header.replace('"', "\"\"")),
        false => header.to_owned(),
    }
}

/// Entries of `[[summaries]]` in `dataset.toml`.
pub(crate) fn manifest_text(dataset: &Dataset) -> String {
    let (mut text, mut notes) = (String::new(), &dataset.notes[..]);
    for table in of_dataset(dataset) {
        let _ = writeln!(text, "\n[[summaries]]\nfile = {}", quoted(table.file));
        let held = table
            .rows
            .iter()
            .filter(|(_, flight)| flight.role == Role::HeldOut);
        let held: Vec<String> = held.map(|(line, _)| line.to_string()).collect();
        if !held.is_empty() {
            let _ = writeln!(text, "held_out = [{}]", held.join(", "));
        }
        if !std::mem::take(&mut notes).is_empty() {
            let _ = writeln!(text, "notes = {}", list(&dataset.notes).unwrap_or_default());
        }
        if let Some((_, first)) = table.rows.first() {
            text += &known_text(first);
            if let Some(names) = list(&first.unknown) {
                let _ = writeln!(text, "unknown = {names}");
            }
        }
        text += &columns(table.columns.iter().map(|(_, sensor)| *sensor));
    }
    text
}

/// The table `[summaries.columns]` of an entry.
pub(crate) fn columns<'s>(sensors: impl IntoIterator<Item = &'s Sensor>) -> String {
    let mut text = String::from("[summaries.columns]\n");
    for sensor in sensors {
        let _ = writeln!(text, "{} = {}", quoted(&sensor.name), column(sensor));
    }
    text
}

fn column(sensor: &Sensor) -> String {
    let SensorKind::Summary(own) = sensor.kind else {
        return String::new();
    };
    let mut text = format!(
        "{{ is = \"{}\", unit = \"{}\"",
        own.quantity.name(),
        own.unit.name()
    );
    if let Some(sigma) = sensor.sigma {
        let _ = write!(text, ", sigma = {sigma:?}");
    }
    if let Some(right) = own.quantity.is_positive_right() {
        let side = if right == own.is_mirrored {
            "left"
        } else {
            "right"
        };
        let _ = write!(text, ", positive = \"{side}\"");
    }
    text + " }"
}
