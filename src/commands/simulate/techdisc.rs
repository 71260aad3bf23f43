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

/// Names of the columns of a TechDisc file with the speed, each with the factor that converts the value to m/s.
const SPEEDS: [(&str, f64); 2] = [("speedMph", 0.44704), ("speedKmh", 1.0 / 3.6)];
/// Columns of a TechDisc file other than those of the speed: name of the column, name of the quantity of a throw, and
/// whether the column is required.
const COLUMNS: [(&str, &str, bool); 5] = [
    ("spinRpm", "spin", true),
    ("launchAngle", "launch", true),
    ("noseAngle", "nose", true),
    ("hyzerAngle", "hyzer", true),
    ("wobbleAngle", "wobble", false),
];

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
    let file = std::fs::File::open(path).with_context(|| format!("{name}: cannot be read"))?;
    let mut bytes = Vec::new();
    file.take(MAX_BYTES + 1)
        .read_to_end(&mut bytes)
        .with_context(|| format!("{name}: cannot be read"))?;
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
    speeds: [Option<usize>; 2],
    others: [Option<usize>; 5],
}

impl Header {
    fn read(place: &str, record: &csv::StringRecord) -> anyhow::Result<Header> {
        if record.len() > MAX_COLUMNS {
            bail!(
                "{place}: found {} columns, expected at most {MAX_COLUMNS}",
                record.len()
            );
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
        let header = Header {
            columns: record.len(),
            id: column("id")?,
            speeds: [column(SPEEDS[0].0)?, column(SPEEDS[1].0)?],
            others: {
                let mut others = [None; 5];
                for (other, (name, _, is_needed)) in others.iter_mut().zip(COLUMNS) {
                    *other = column(name)?;
                    if is_needed && other.is_none() {
                        bail!(
                            "{place}: found no column {name}, expected a table of TechDisc with it"
                        );
                    }
                }
                others
            },
        };
        if header.speeds == [None, None] {
            bail!(
                "{place}: found no column speedMph or speedKmh, expected a table of TechDisc with one"
            );
        }
        Ok(header)
    }

    fn row(
        &self,
        place: &str,
        record: &csv::StringRecord,
        line: u64,
        number: usize,
    ) -> anyhow::Result<Row> {
        if record.len() != self.columns {
            bail!(
                "{place}: found {} cells, expected {} as in the header",
                record.len(),
                self.columns
            );
        }
        let cell = |at: usize, name: &str| {
            let text = record.get(at).unwrap_or_default();
            let value = text.parse::<f64>().ok().filter(|v| v.is_finite());
            value.with_context(|| {
                let text: String = text.chars().take(40).collect();
                format!(
                    "{place}: column {}: found {name} {text:?}, expected a number",
                    at + 1
                )
            })
        };
        let mut speed = None;
        for (at, (name, unit)) in self.speeds.iter().zip(SPEEDS) {
            let Some(at) = *at else {
                continue;
            };
            let value = cell(at, name)? * unit;
            match speed {
                Some(other) if f64::abs(value - other) > SPEED_DIFFERENCE * f64::abs(other) => {
                    bail!(
                        "{place}: column {}: found speeds of {other:.2} m/s and {value:.2} m/s, expected the same in both units",
                        at + 1
                    )
                }
                Some(_) => {}
                None => speed = Some(value),
            }
        }
        let mut throw = Throw::at_speed(speed.unwrap_or_default());
        for (at, (name, field, is_needed)) in self.others.iter().zip(COLUMNS) {
            let Some(at) = *at else {
                continue;
            };
            if is_needed || record.get(at).is_some_and(|text| !text.is_empty()) {
                throw.set(field, cell(at, name)?);
            }
        }
        let column = |field: Option<&str>| {
            let named = COLUMNS.iter().position(|(_, own, _)| Some(*own) == field);
            let at = match named {
                Some(k) => self.others[k],
                None => self.speeds[0].or(self.speeds[1]),
            };
            1 + at.unwrap_or_default()
        };
        if let Err(fault) = throw.check() {
            bail!("{place}: column {}: {fault}", column(fault.field()));
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
