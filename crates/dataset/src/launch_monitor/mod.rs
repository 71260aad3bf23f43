//! Exports of launch monitors: which column is what, in which unit, and what the device did not measure.

mod cells;
mod columns;
mod headers;
mod notes;
mod statistics;
mod unread;

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use cells::Numerals;
use columns::{Used, is_units, used};
use notes::notes;
use statistics::take_statistics;
use unread::unread;

use crate::input_error::InputError;
use crate::lines::Lines;
use crate::summary::{SummaryColumn, SummaryEvent, SummaryQuantity as Q};
use crate::summary_text::header_line;
use crate::toml_text::{list, quoted};
use crate::words::shown;
use crate::{Dataset, Sensor, SensorKind, from_texts};

/// Line and cells of a row.
type Row = (usize, Vec<String>);

/// Options of [`import_shots`].
#[derive(Clone, Debug, Default)]
pub struct ShotOptions {
    /// Model; by default `golf_ball`, or `disc` where nose, hyzer or wobble are columns.
    pub model: Option<String>,
    /// Columns by their headers, each with what it is and its unit; they win over what is recognised.
    pub columns: Vec<(String, String, Option<String>)>,
}

/// Dataset of the shots of a launch monitor.
#[derive(Clone, Debug)]
pub struct ImportedShots {
    /// The dataset.
    pub dataset: Dataset,
    /// What was decided, one line each.
    pub decisions: Vec<String>,
}

/// Maximum length of an export, bytes.
const MAX_BYTES: u64 = 256 << 20;

/// Rows of a table of at most `largest` bytes, each with its line, without blank lines and comments; `what` describes the
/// expected file in messages.
pub fn table_rows(
    file: &Path,
    largest: u64,
    what: &str,
) -> Result<Vec<(usize, Vec<String>)>, InputError> {
    let bytes = crate::file::bytes(file, largest, what)?;
    Ok(rows(file, &crate::file::table_text(file, &bytes)?)?.0)
}

/// Rows of a table, and the separator of their cells.
fn rows(file: &Path, text: &str) -> Result<(Vec<Row>, char), InputError> {
    let mut lines = Lines::new(file, text);
    let mut rows = Vec::new();
    while lines.next()? {
        rows.push((lines.sheet.place(0).0, lines.sheet.cells()));
    }
    Ok((rows, lines.sheet.separator()))
}

/// Reads the file of a launch monitor's export, as [`import_shots`].
///
/// # Errors
/// As [`import_shots`]; or if the file cannot be read, is no ordinary file or too long.
pub fn read_shots(file: &Path, options: &ShotOptions) -> Result<ImportedShots, InputError> {
    let bytes = crate::file::bytes(file, MAX_BYTES, "a table of shots")?;
    import_shots(file, &bytes, options)
}

/// Reads a launch monitor's export: a header, where there is one a row of units, and a row per shot.
///
/// # Errors
/// [`InputError`] if no column is recognised, a unit is not stated, or the table is faulty.
pub fn import_shots(
    file: &Path,
    bytes: &[u8],
    options: &ShotOptions,
) -> Result<ImportedShots, InputError> {
    let text = &*crate::file::table_text(file, bytes)?;
    let (mut rows, separator) = rows(file, text)?;
    if rows.is_empty() {
        let expected = "a launch monitor's table";
        return Err(InputError::at(file, (1, 1), "no header", expected));
    }
    let (_, headers) = rows.remove(0);
    let mut units: Vec<String> = Vec::new();
    while rows.first().is_some_and(|(_, cells)| is_units(cells)) {
        units = rows.remove(0).1;
    }
    let statistics = take_statistics(&mut rows);
    let used = used(file, (&headers, &units, &rows), options)?;
    let cells = rows.iter().flat_map(|(_, cells)| cells.iter().enumerate());
    let is_read = |place: usize| used.iter().any(|own| own.reads(place));
    let cells = cells.filter(|(place, _)| is_read(*place));
    let numerals = Numerals::of(cells.map(|(_, cell)| cell.as_str()), separator);
    let mut decisions: Vec<String> = used.iter().map(decision).collect();
    if numerals.decimal == ',' {
        decisions.push("the decimal mark of the numbers is a comma".to_owned());
    }
    decisions.extend(statistics);
    decisions.extend(unread(&headers, &units, &rows, &used, numerals));
    let mut table = header_line(used.iter().map(|own| own.header.as_str()));
    let (mut line, mut shots, mut first_reason) = (1, 0, None);
    for (at, cells) in &rows {
        let values = match values(&used, cells, numerals) {
            Ok(values) => values,
            Err(why) => {
                decisions.push(format!("line {at} left out: {why}"));
                first_reason.get_or_insert(format!("line {at} is left out: {why}"));
                continue;
            }
        };
        table += &"\n".repeat(at - line);
        line = *at;
        let texts = values
            .iter()
            .map(|value| value.map_or_else(String::new, |value| value.to_string()));
        table += &texts.collect::<Vec<_>>().join(",");
        shots += 1;
    }
    table.push('\n');
    if shots == 0 {
        let expected = "a row for each shot, with numbers";
        let why = first_reason.map_or_else(String::new, |why| format!(": {why}"));
        return Err(InputError::of_file(file, format!("no shot{why}"), expected));
    }
    let notes = notes(&headers, &rows, numerals);
    decisions.extend(notes.iter().map(|note| format!("note: {note}")));
    let manifest = manifest(&used, &notes, options);
    let tables = BTreeMap::from([("shots.csv".to_owned(), table)]);
    Ok(ImportedShots {
        dataset: from_texts(&manifest, &tables)?,
        decisions,
    })
}

/// Line that tells what a column is taken for.
fn decision(own: &Used) -> String {
    let SummaryColumn { quantity, unit, .. } = own.column;
    let class = match quantity.event() {
        SummaryEvent::Release => "release",
        _ => "outcome",
    };
    let (is, unit, from) = (quantity.name(), unit.name(), own.origin());
    format!("{}: {is}, {unit}, {class}{from}", shown(&own.header))
}

/// Values of a row in the units of the columns; the error is why the row is left out.
fn values(used: &[Used], cells: &[String], numerals: Numerals) -> Result<Vec<Option<f64>>, String> {
    let values = used.iter().map(|own| own.value(cells, numerals));
    let values: Vec<Option<f64>> = values.collect::<Result<_, _>>()?;
    match values.iter().all(Option::is_none) {
        true => Err("no value".to_owned()),
        false => Ok(values),
    }
}

fn manifest(used: &[Used], notes: &[String], options: &ShotOptions) -> String {
    let of_body = [Q::Nose, Q::Hyzer, Q::Wobble];
    let is_body = used
        .iter()
        .any(|own| of_body.contains(&own.column.quantity));
    let model = options.model.as_deref();
    let model = model.unwrap_or(if is_body { "disc" } else { "golf_ball" });
    let mut text = format!(
        "model = {}\n[[summaries]]\nfile = \"shots.csv\"\n",
        quoted(model)
    );
    if let Some(notes) = list(notes) {
        let _ = writeln!(text, "notes = {notes}");
    }
    let sensors = used.iter();
    let sensors =
        sensors.map(|own| Sensor::new(&own.header, SensorKind::Summary(own.column), [0.0; 3]));
    text + &crate::summary_text::columns(&sensors.collect::<Vec<_>>())
}
