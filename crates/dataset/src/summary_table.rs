//! Reader of a table of summaries: a header, where the file has one a row of units, and a row per flight.

use std::path::Path;

use crate::input_error::InputError;
use crate::lines::Lines;
use crate::summary::SummaryUnit;
use crate::summary_columns::SummariesEntry;
use crate::words::{meant, shown};
use crate::{Sensor, SensorKind};

/// Maximum number of rows, each of which is a flight.
const MAX_ROWS: usize = 100_000;

/// Line of each row, and its values in the order of the columns.
pub(crate) type SummaryRows = Vec<(usize, Vec<Option<f64>>)>;

/// Reads the columns that `entry` states.
pub(crate) fn parse(
    file: &Path,
    text: &str,
    entry: &SummariesEntry,
) -> Result<SummaryRows, InputError> {
    let mut lines = Lines::new(file, text);
    if !lines.next()? {
        let expected = "a header with the columns of dataset.toml";
        return Err(InputError::at(file, (1, 1), "no header", expected));
    }
    let places = places(&lines, &entry.columns)?;
    let width = lines.sheet.width();
    let mut rows = SummaryRows::new();
    while lines.next()? {
        if rows.is_empty() && is_units(&lines) {
            check_units(&lines, &entry.columns, &places)?;
            continue;
        }
        if lines.sheet.width() != width {
            let found = format!("{} cells", lines.sheet.width());
            let expected = format!("{width} as in the header");
            return Err(lines.fault(lines.sheet.width().min(width), found, expected));
        }
        if rows.len() == MAX_ROWS {
            return Err(lines.fault(0, "a row more", format!("at most {MAX_ROWS} rows")));
        }
        let (line, _) = lines.sheet.place(0);
        let values = entry.columns.iter().zip(&places);
        let values = values.map(|(column, place)| value(&lines, column, *place));
        let values: Vec<Option<f64>> = values.collect::<Result<_, _>>()?;
        if values.iter().all(Option::is_none) {
            return Err(lines.fault(0, "a row without a value", "a flight in each row"));
        }
        rows.push((line, values));
    }
    if rows.is_empty() {
        let place = lines.sheet.end();
        return Err(InputError::at(
            file,
            place,
            "no rows",
            "a row for each flight",
        ));
    }
    let has = |line: &usize| rows.iter().any(|(own, _)| own == line);
    if let Some(line) = entry.held_out.iter().find(|line| !has(line)) {
        let found = format!("no flight at line {line}, which held_out names");
        return Err(InputError::of_file(
            file,
            found,
            "lines of rows of this table",
        ));
    }
    Ok(rows)
}

/// Index of each column in the header.
fn places(lines: &Lines<'_>, columns: &[Sensor]) -> Result<Vec<usize>, InputError> {
    let headers = lines.sheet.cells();
    let each = columns.iter().map(|column| {
        let mut all = headers.iter().enumerate();
        let mut own = all.by_ref().filter(|(_, header)| **header == column.name);
        match (own.next(), own.next()) {
            (Some((place, _)), None) => Ok(place),
            (Some(_), Some((second, _))) => {
                let found = format!("a second column {}", shown(&column.name));
                Err(lines.fault(second, found, "each header once"))
            }
            (None, _) => {
                let found = format!("no column {}", shown(&column.name));
                let near = meant(&column.name, headers.iter().map(String::as_str));
                let expected = format!("a header that dataset.toml names{near}");
                Err(lines.fault(0, found, expected))
            }
        }
    });
    each.collect()
}

/// Whether the current row has units in brackets, and nothing else.
fn is_units(lines: &Lines<'_>) -> bool {
    let cells = lines.sheet.cells();
    let is_unit = |cell: &String| in_brackets(cell).is_some();
    cells.iter().any(is_unit) && cells.iter().all(|cell| cell.is_empty() || is_unit(cell))
}

/// Text of a cell that is in brackets, as those of a row of units.
pub(crate) fn in_brackets(cell: &str) -> Option<&str> {
    cell.strip_prefix('[')?.strip_suffix(']')
}

/// Compares the units in the file with those that dataset.toml states.
fn check_units(lines: &Lines<'_>, columns: &[Sensor], places: &[usize]) -> Result<(), InputError> {
    for (column, &place) in columns.iter().zip(places) {
        let SensorKind::Summary(own) = column.kind else {
            continue;
        };
        let cell = lines.sheet.cell(place);
        let unit = cell.trim_matches(['[', ']']);
        if !unit.is_empty() && SummaryUnit::parse(unit) != Some(own.unit) {
            let expected = format!("[{}] as dataset.toml states", own.unit.name());
            return Err(lines.fault(place, shown(cell), expected));
        }
    }
    Ok(())
}

fn value(lines: &Lines<'_>, column: &Sensor, place: usize) -> Result<Option<f64>, InputError> {
    let (Some(value), SensorKind::Summary(own)) = (lines.number(place)?, column.kind) else {
        return Ok(None);
    };
    let (low, high) = own.quantity.range();
    let si = value * own.to_si();
    if (low..=high).contains(&si) {
        return Ok(Some(value));
    }
    let unit = own.quantity.si_unit();
    let found = format!("{} = {value} {}", shown(&column.name), own.unit.name());
    let expected = format!("{} from {low} to {high} {unit}", own.quantity.name());
    Err(lines.fault(place, found, expected))
}
