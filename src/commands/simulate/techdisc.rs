//! Reads throws of the launch monitor TechDisc: a CSV file with a header, one throw per row.

use std::io::Read;
use std::path::Path;

use anyhow::{Context, bail};
use flight::throw::Throw;

/// Maximum size of a TechDisc file, bytes.
const MAX_BYTES: u64 = 4 << 20;
/// Maximum number of throws in a TechDisc file.
const MAX_ROWS: usize = 1000;
/// Maximum number of columns in a TechDisc file.
const MAX_COLUMNS: usize = 200;
/// Maximum relative difference between the two speeds of one throw in the file, one in mph and one in km/h.
const SPEED_DIFFERENCE: f64 = 0.01;

/// Columns of a TechDisc file: name of the column, name of the quantity of a throw, factor that converts the value to the
/// unit of the quantity, and whether the column is required. One of those of the speed is required.
const COLUMNS: [(&str, &str, f64, bool); 7] = [
    ("speedMph", SPEED, 0.44704, false),
    ("speedKmh", SPEED, 1.0 / 3.6, false),
    ("spinRpm", "spin", 1.0, true),
    ("launchAngle", "launch", 1.0, true),
    ("noseAngle", "nose", 1.0, true),
    ("hyzerAngle", "hyzer", 1.0, true),
    ("wobbleAngle", "wobble", 1.0, false),
];
/// Name of the quantity of a throw that two columns state.
const SPEED: &str = "speed";

/// One throw recorded by a launch monitor: a row of its CSV file.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Text of the column `id`; the number of the throw in the file if that column is empty or missing.
    pub id: String,
    /// Number of the throw in the file, from 1.
    pub number: usize,
    /// Line number in the file, from 1.
    pub line: u64,
    /// The recorded throw; its heading is along +x and its height is the default height.
    pub throw: Throw,
}

/// Reads a TechDisc file, a table of throws recorded by a launch monitor.
///
/// # Errors
/// If the file cannot be read, is too large or has faults; the first fault is reported, with its line and column.
pub fn read(path: &Path) -> anyhow::Result<Vec<Row>> {
    let name = path.display();
    let unreadable = || format!("{name}: cannot be read");
    let file = std::fs::File::open(path).with_context(unreadable)?;
    let mut bytes = Vec::new();
    let mut file = file.take(MAX_BYTES + 1);
    file.read_to_end(&mut bytes).with_context(unreadable)?;
    if bytes.len() as u64 > MAX_BYTES {
        bail!("{name}: found more than {MAX_BYTES} bytes, expected at most that");
    }
    parse(&name.to_string(), &bytes)
}

/// Parses the text of a TechDisc file, a table of throws recorded by a launch monitor; `file` is its name in messages.
///
/// # Errors
/// Those of [`read`], except for reading the file.
pub fn parse(file: &str, bytes: &[u8]) -> anyhow::Result<Vec<Row>> {
    let bytes = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .from_reader(bytes);
    let mut header: Option<Header> = None;
    let mut rows = Vec::new();
    let mut record = csv::StringRecord::new();
    while reader.read_record(&mut record).map_err(|e| {
        let line = e.position().map_or(1, csv::Position::line);
        anyhow::anyhow!("{file}:{line}: this is no table in UTF-8: {e}")
    })? {
        let line = record.position().map_or(1, csv::Position::line);
        let place = format!("{file}:{line}");
        match &header {
            None => header = Some(Header::read(&place, &record)?),
            Some(_) if record.iter().all(str::is_empty) => {}
            Some(_) if rows.len() == MAX_ROWS => {
                bail!("{place}: found more than {MAX_ROWS} throws, expected at most that")
            }
            Some(header) => rows.push(header.row(&place, &record, line, rows.len() + 1)?),
        }
    }
    if rows.is_empty() {
        bail!("{file}: found no throw, expected a header and at least one row");
    }
    Ok(rows)
}

/// Selects the throw that the option `--row` names, by its id or else by its number in the file.
///
/// # Errors
/// If there is no such throw, or if several throws have this id.
pub fn choose(rows: Vec<Row>, name: &str) -> anyhow::Result<Row> {
    let of_id = |row: &&Row| row.id == name;
    let count = rows.iter().filter(of_id).count();
    if count > 1 {
        bail!(
            "--row: found {count} throws of the id {name:?}, expected one; name it by its number"
        );
    }
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

/// Indices of the columns of a TechDisc file that are read, and the total number of columns.
struct Header {
    columns: usize,
    id: Option<usize>,
    /// Index of each of [`COLUMNS`].
    quantities: [Option<usize>; COLUMNS.len()],
}

impl Header {
    fn read(place: &str, record: &csv::StringRecord) -> anyhow::Result<Header> {
        let columns = record.len();
        if columns > MAX_COLUMNS {
            bail!("{place}: found {columns} columns, expected at most {MAX_COLUMNS}");
        }
        let column = |name: &str| {
            let mut found = record.iter().enumerate().filter(|(_, cell)| *cell == name);
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
        if quantities[..2] == [None, None] {
            bail!(
                "{place}: found no column speedMph or speedKmh, expected a table of TechDisc with one"
            );
        }
        Ok(Header {
            columns,
            id,
            quantities,
        })
    }

    fn row(
        &self,
        place: &str,
        record: &csv::StringRecord,
        line: u64,
        number: usize,
    ) -> anyhow::Result<Row> {
        let (found, expected) = (record.len(), self.columns);
        if found != expected {
            bail!("{place}: found {found} cells, expected {expected} as in the header");
        }
        let mut throw = Throw::at_speed(0.0);
        let mut speed: Option<f64> = None;
        for (at, (name, field, factor, is_needed)) in self.quantities.iter().zip(COLUMNS) {
            let Some(at) = *at else {
                continue;
            };
            let text = record.get(at).unwrap_or_default();
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
        let id = self.id.and_then(|at| record.get(at)).unwrap_or_default();
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
