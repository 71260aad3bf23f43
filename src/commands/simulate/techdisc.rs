//! Reads throws of the launch monitor TechDisc: a CSV file with a header, one throw per row.

use std::path::Path;

use anyhow::{Context, bail, ensure};
use flight::throw::Throw;

const MAX_BYTES: u64 = 4 << 20;
const MAX_ROWS: usize = 1000;
const MAX_COLUMNS: usize = 200;
/// Maximum relative difference between the speeds of one throw in mph and in km/h.
const SPEED_DIFFERENCE: f64 = 0.01;

/// Columns: name, quantity of a throw, factor to its unit, and whether the column is required. One of the speed's is.
const COLUMNS: [(&str, &str, f64, bool); 7] = [
    ("speedMph", SPEED, 0.44704, false),
    ("speedKmh", SPEED, 1.0 / 3.6, false),
    ("spinRpm", "spin", 1.0, true),
    ("launchAngle", "launch", 1.0, true),
    ("noseAngle", "nose", 1.0, true),
    ("hyzerAngle", "hyzer", 1.0, true),
    ("wobbleAngle", "wobble", 1.0, false),
];
/// The quantity that two columns state.
const SPEED: &str = "speed";

/// One throw of a launch monitor.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Text of the column `id`, or the number.
    pub id: String,
    /// Number in the file, from 1.
    pub number: usize,
    /// Line in the file, from 1.
    pub line: usize,
    /// The throw, with its heading along +x and the default height.
    pub throw: Throw,
}

/// Reads a table of throws of TechDisc.
///
/// # Errors
/// If the file cannot be read or has faults; the first one is reported.
pub fn read(path: &Path) -> anyhow::Result<Vec<Row>> {
    let file = path.display();
    let mut header: Option<Header> = None;
    let mut rows = Vec::new();
    for (line, cells) in dataset::table_rows(path, MAX_BYTES, "a table of throws")? {
        let place = format!("{file}:{line}");
        match &header {
            None => header = Some(Header::read(&place, &cells)?),
            Some(_) if cells.iter().all(String::is_empty) => {}
            Some(_) if rows.len() == MAX_ROWS => {
                bail!("{place}: found more than {MAX_ROWS} throws, expected at most that")
            }
            Some(header) => rows.push(header.row(&place, &cells, line, rows.len() + 1)?),
        }
    }
    ensure!(
        !rows.is_empty(),
        "{file}: found no throw, expected a header and at least one row"
    );
    Ok(rows)
}

/// Selects a throw by its id or else by its number.
///
/// # Errors
/// If there is no such throw, or if several throws have this id.
pub fn choose(rows: Vec<Row>, name: &str) -> anyhow::Result<Row> {
    let count = rows.iter().filter(|row| row.id == name).count();
    ensure!(
        count <= 1,
        "--row: found {count} throws of the id {name:?}, expected one; name it by its number"
    );
    let last = rows.len();
    let number = name.parse::<usize>().ok();
    let is_it = |row: &Row| match count {
        1 => row.id == name,
        _ => Some(row.number) == number,
    };
    rows.into_iter().find(is_it).with_context(|| {
        format!("--row: found {name:?}, expected the id of a throw or a number from 1 to {last}")
    })
}

/// Indices of the columns that are read.
struct Header {
    columns: usize,
    id: Option<usize>,
    /// Index of each of [`COLUMNS`].
    quantities: [Option<usize>; COLUMNS.len()],
}

impl Header {
    fn read(place: &str, cells: &[String]) -> anyhow::Result<Header> {
        let columns = cells.len();
        ensure!(
            columns <= MAX_COLUMNS,
            "{place}: found {columns} columns, expected at most {MAX_COLUMNS}"
        );
        let column = |name: &str| {
            let mut found = cells.iter().enumerate().filter(|(_, cell)| *cell == name);
            let first = found.next().map(|(at, _)| at);
            match found.next() {
                Some((again, _)) => bail!(
                    "{place}: column {}: found {name} again, expected each column once",
                    again + 1
                ),
                None => Ok(first),
            }
        };
        let id = column("id")?;
        let mut quantities = [None; COLUMNS.len()];
        for (at, (name, _, _, is_needed)) in quantities.iter_mut().zip(COLUMNS) {
            *at = column(name)?;
            if is_needed && at.is_none() {
                bail!("{place}: found no column {name}, expected a table of TechDisc with it");
            }
        }
        ensure!(
            quantities[..2] != [None, None],
            "{place}: found no column speedMph or speedKmh, expected a table of TechDisc with one"
        );
        Ok(Header {
            columns,
            id,
            quantities,
        })
    }

    fn row(
        &self,
        place: &str,
        cells: &[String],
        line: usize,
        number: usize,
    ) -> anyhow::Result<Row> {
        let (found, expected) = (cells.len(), self.columns);
        ensure!(
            found == expected,
            "{place}: found {found} cells, expected {expected} as in the header"
        );
        let mut throw = Throw::at_speed(0.0);
        let mut speed: Option<f64> = None;
        for (at, (name, field, factor, is_needed)) in self.quantities.iter().zip(COLUMNS) {
            let Some(at) = *at else {
                continue;
            };
            let text = &cells[at];
            let is_speed = field == SPEED;
            if text.is_empty() && !is_needed && !is_speed {
                continue;
            }
            let column = format!("{place}: column {}", at + 1);
            let value = text.parse::<f64>().ok().filter(|v| v.is_finite());
            let value = value.with_context(|| {
                let text: String = text.chars().take(40).collect();
                format!("{column}: found {name} {text:?}, expected a number")
            })?;
            let value = value * factor;
            if let (true, Some(other)) = (is_speed, speed) {
                if (value - other).abs() > SPEED_DIFFERENCE * other.abs() {
                    bail!(
                        "{column}: found speeds of {other:.2} m/s and {value:.2} m/s, expected the same in both units"
                    );
                }
                continue;
            }
            throw.set(field, value);
            speed = speed.or(Some(value).filter(|_| is_speed));
        }
        if let Err(fault) = throw.check() {
            let field = fault.field().unwrap_or(SPEED);
            let mut stated = self.quantities.iter().zip(COLUMNS);
            let at = stated.find_map(|(at, (_, own, ..))| at.filter(|_| own == field));
            bail!("{place}: column {}: {fault}", 1 + at.unwrap_or_default());
        }
        let id = self.id.map_or("", |at| &cells[at]);
        let id = match id.is_empty() {
            true => number.to_string(),
            false => id.chars().filter(|c| !c.is_control()).take(60).collect(),
        };
        Ok(Row {
            id,
            number,
            line,
            throw,
        })
    }
}
