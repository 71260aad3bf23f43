//! Exports of launch monitors: which column is what, in which unit, and what the device did not measure.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::path::Path;

use crate::input_error::InputError;
use crate::lines::Lines;
use crate::summary::{SummaryColumn, SummaryEvent, SummaryQuantity as Q, SummaryUnit};
use crate::summary_table::in_brackets;
use crate::summary_text::{cell, columns};
use crate::toml_text::{list, quoted};
use crate::words::{listed, shown};
use crate::{Dataset, Sensor, SensorKind, from_texts};
use flight::table::number;

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

/// Headers of launch monitors, without spaces, signs and units; those of a quantity with sides, to the right or left.
const HEADERS: [(Q, &str); 17] = [
    (Q::Speed, "ballspeed speed releasespeed throwspeed"),
    (
        Q::Launch,
        "launchangle launchang vla launch verticallaunchangle",
    ),
    (
        Q::Heading,
        "launchdirection launchdir hla horizontallaunchangle azimuth sideangle",
    ),
    (Q::Nose, "noseangle nose"),
    (Q::Hyzer, "hyzerangle hyzer"),
    (Q::Spin, "spinrate totalspin spin"),
    (Q::SpinAxis, "spinaxis spintiltaxis"),
    (Q::Height, "releaseheight launchheight"),
    (Q::Wobble, "wobble wobbleangle"),
    (
        Q::Carry,
        "carryflatlength carrylength carry carrydistance carrydist",
    ),
    (
        Q::Side,
        "carryflatside carryside side offline carryoffline carrydeviation",
    ),
    (
        Q::ApexHeight,
        "maxheightheight height maxheight peakheight apex apexheight",
    ),
    (Q::ApexDistance, "maxheightdist apexdistance"),
    (Q::HangTime, "carryflattime hangtime flighttime airtime"),
    (
        Q::LandingSpeed,
        "carryflatballspeed landingspeed carryballspeed",
    ),
    (
        Q::LandingAngle,
        "carryflatlandangle landangle landingangle descentangle carrylandangle",
    ),
    (Q::FinalSpin, "landingspin finalspin"),
];

/// Quantity of a header, as it is a key of [`HEADERS`].
fn known(key: &str) -> Option<Q> {
    let is_own = |(_, all): &&(Q, &str)| all.split(' ').any(|own| own == key);
    HEADERS.iter().find(is_own).map(|(quantity, _)| *quantity)
}

/// Ends of headers that are units, as in `speedMph`.
const ENDINGS: [(&str, &str); 8] = [
    ("mph", "mph"),
    ("kmh", "km/h"),
    ("mps", "m/s"),
    ("rpm", "rpm"),
    ("yds", "yd"),
    ("yards", "yd"),
    ("feet", "ft"),
    ("degrees", "deg"),
];

/// Header without unit, as the keys of [`HEADERS`], and the unit that it names in brackets or at its end.
fn read_header(header: &str) -> (String, Option<SummaryUnit>) {
    let mut unit = None;
    let mut bare = header.to_owned();
    if let Some((before, rest)) = header.split_once(['(', '['])
        && let Some((inside, after)) = rest.split_once([')', ']'])
        && let Some(own) = SummaryUnit::parse(inside)
    {
        (unit, bare) = (Some(own), format!("{before}{after}"));
    }
    let mut key: String = bare.chars().filter(|c| c.is_alphanumeric()).collect();
    key.make_ascii_lowercase();
    if unit.is_none() && known(&key).is_none() {
        let ending = ENDINGS.iter().find(|(end, _)| key.ends_with(end));
        if let Some((end, name)) = ending {
            key.truncate(key.len() - end.len());
            unit = SummaryUnit::parse(name);
        }
    }
    (key, unit)
}

/// A column that is used.
struct Used {
    place: usize,
    header: String,
    column: SummaryColumn,
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
    rows(file, &crate::file::table_text(file, &bytes)?)
}

fn rows(file: &Path, text: &str) -> Result<Vec<(usize, Vec<String>)>, InputError> {
    let mut lines = Lines::new(file, text);
    let mut rows = Vec::new();
    while lines.next()? {
        rows.push((lines.sheet.place(0).0, lines.sheet.cells()));
    }
    Ok(rows)
}

/// Reads the file of a launch monitor's export, as [`import_shots`].
///
/// # Errors
/// As [`import_shots`]; or if the file cannot be read, is no ordinary file or too long.
pub fn read_shots(file: &Path, options: &ShotOptions) -> Result<ImportedShots, InputError> {
    let bytes = crate::file::bytes(file, MAX_BYTES, "a table of shots")?;
    import_shots(file, &bytes, options)
}

/// Reads a launch monitor's export: a header, where there is one a row of units in brackets, and a row per shot.
///
/// # Errors
/// [`InputError`] if no column is recognised, a unit is not stated, or the table is faulty.
pub fn import_shots(
    file: &Path,
    bytes: &[u8],
    options: &ShotOptions,
) -> Result<ImportedShots, InputError> {
    let text = &*crate::file::table_text(file, bytes)?;
    let mut rows = rows(file, text)?;
    if rows.is_empty() {
        let expected = "a launch monitor's table";
        return Err(InputError::at(file, (1, 1), "no header", expected));
    }
    let (_, headers) = rows.remove(0);
    let mut units: Vec<String> = Vec::new();
    let is_units =
        |(_, cells): &(usize, Vec<String>)| cells.iter().any(|c| in_brackets(c).is_some());
    while rows.first().is_some_and(is_units) {
        units = rows.remove(0).1;
    }
    let used = used(file, &headers, &units, options)?;
    let mut decisions = Vec::new();
    for own in &used {
        let SummaryColumn { quantity, unit, .. } = own.column;
        let class = match quantity.event() {
            SummaryEvent::Release => "release",
            _ => "outcome",
        };
        let is = quantity.name();
        decisions.push(format!(
            "{}: {is}, {}, {class}",
            shown(&own.header),
            unit.name()
        ));
    }
    let mut table = used
        .iter()
        .map(|own| cell(&own.header))
        .collect::<Vec<_>>()
        .join(",");
    let (mut line, mut shots) = (1, 0);
    for (at, cells) in &rows {
        let get = |place: usize| cells.get(place).map_or("", String::as_str);
        let wrong = used.iter().find(|own| number(get(own.place)).is_err());
        let is_empty = used
            .iter()
            .all(|own| matches!(number(get(own.place)), Ok(None)));
        if wrong.is_some() || is_empty {
            let why = wrong.map_or("no value".to_owned(), |own| shown(get(own.place)));
            decisions.push(format!("line {at} left out: {why}"));
            continue;
        }
        table += &"\n".repeat(at - line);
        line = *at;
        let values = used.iter().map(|own| get(own.place));
        table += &values.collect::<Vec<_>>().join(",");
        shots += 1;
    }
    table.push('\n');
    if shots == 0 {
        let expected = "a row for each shot, with numbers";
        return Err(InputError::of_file(file, "no shot", expected));
    }
    let notes = notes(&headers, &rows);
    decisions.extend(notes.iter().map(|note| format!("note: {note}")));
    let manifest = manifest(&used, &notes, options);
    let tables = BTreeMap::from([("shots.csv".to_owned(), table)]);
    Ok(ImportedShots {
        dataset: from_texts(&manifest, &tables)?,
        decisions,
    })
}

/// Columns of the options and those that are recognised; of several of one quantity the first.
fn used(
    file: &Path,
    headers: &[String],
    units: &[String],
    options: &ShotOptions,
) -> Result<Vec<Used>, InputError> {
    let fault = |found: String, expected: String| Err(InputError::of_file(file, found, expected));
    let mut used: Vec<Used> = Vec::new();
    for (header, is, unit) in &options.columns {
        let Some(place) = headers.iter().position(|own| own == header) else {
            return fault(format!("no column {}", shown(header)), listed(headers));
        };
        let names = || Q::all().map(Q::name);
        let Some(quantity) = Q::named(is) else {
            return fault(shown(is), format!("one of {}", listed(names())));
        };
        let stated = unit.as_deref().map(SummaryUnit::parse);
        let unit = match stated {
            Some(unit) => unit,
            None => unit_of(units, place).or(read_header(header).1),
        };
        used.push(Used::new(file, (place, header), quantity, unit)?);
    }
    for (place, header) in headers.iter().enumerate() {
        let (key, by_header) = read_header(header);
        let Some(quantity) = known(&key) else {
            continue;
        };
        let is_taken = |other: &Used| other.place == place || other.column.quantity == quantity;
        if used.iter().any(is_taken) {
            continue;
        }
        let unit = unit_of(units, place).or(by_header);
        let unit = unit.or_else(|| usual_unit(quantity));
        used.push(Used::new(file, (place, header), quantity, unit)?);
    }
    let is_outcome = |own: &Used| own.column.quantity.event() != SummaryEvent::Release;
    if !used.iter().any(is_outcome) {
        let found = format!(
            "no column of what was seen after the release among {}",
            listed(headers)
        );
        let expected = "such as Carry or Max Height; --column \"HEADER=carry,yd\" names one";
        return fault(found, expected.to_owned());
    }
    used.sort_by_key(|own| own.column.quantity);
    Ok(used)
}

fn unit_of(units: &[String], place: usize) -> Option<SummaryUnit> {
    SummaryUnit::parse(units.get(place)?.trim_matches(['[', ']']))
}

/// Unit that angles and spins have in every export; lengths and speeds need theirs.
fn usual_unit(quantity: Q) -> Option<SummaryUnit> {
    match quantity.dimension().si() {
        "rad" => SummaryUnit::parse("deg"),
        "rad/s" => SummaryUnit::parse("rpm"),
        "s" => SummaryUnit::parse("s"),
        _ => None,
    }
}

impl Used {
    fn new(
        file: &Path,
        (place, header): (usize, &str),
        quantity: Q,
        unit: Option<SummaryUnit>,
    ) -> Result<Self, InputError> {
        let unit = unit.filter(|unit| unit.dimension() == quantity.dimension());
        let Some(unit) = unit else {
            let name = quantity.name();
            let found = format!(
                "no unit of the column {}, which is the {name}",
                shown(header)
            );
            let units = listed(SummaryUnit::of(quantity.dimension()));
            let expected =
                format!("a second row of units, or --column \"{header}={name},UNIT\" with {units}");
            return Err(InputError::of_file(file, found, expected));
        };
        // Launch monitors count what has sides positive to the right.
        let is_mirrored = quantity.is_positive_right() == Some(false);
        Ok(Self {
            place,
            header: header.to_owned(),
            column: SummaryColumn {
                quantity,
                unit,
                is_mirrored,
            },
        })
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
    text + &columns(&sensors.collect::<Vec<_>>())
}

/// What the device did not measure, by the other columns of its export.
fn notes(headers: &[String], rows: &[(usize, Vec<String>)]) -> Vec<String> {
    let place = |name: &str| {
        headers
            .iter()
            .position(|own| own.eq_ignore_ascii_case(name))
    };
    let values = |place: usize| rows.iter().filter_map(move |(_, cells)| cells.get(place));
    let mut notes = Vec::new();
    if let Some(length) = place("Last data Point - Length") {
        let mean = |place: Option<usize>| {
            let all = place.into_iter().flat_map(&values);
            let all: Vec<f64> = all.filter_map(|cell| cell.parse().ok()).collect();
            all.iter().sum::<f64>() / all.len() as f64
        };
        let (far, time) = (mean(Some(length)), mean(place("Last data Point - Time")));
        notes.push(format!(
            "the outcomes are the launch monitor's extrapolation from its last measured point, {far:.1} yd and {time:.2} s after launch: the fit describes the device's model"
        ));
    }
    if let Some(kind) = place("Spin Rate Type") {
        let all = values(kind).filter(|cell| !cell.trim().is_empty()).count();
        let estimated = values(kind).filter(|cell| cell.eq_ignore_ascii_case("estimated"));
        let count = estimated.count();
        if count > 0 {
            notes.push(format!(
                "the spin of {count} of {all} shots is estimated by the device, not measured"
            ));
        }
    }
    let flat = headers
        .iter()
        .any(|header| header.to_lowercase().contains("flat"));
    if flat {
        notes
            .push("the outcomes are normalised to flat ground at the height of the tee".to_owned());
    }
    let is_normalised = |header: &&String| header.to_lowercase().contains("normalized");
    let normalised: BTreeSet<&String> = headers.iter().filter(is_normalised).collect();
    if !normalised.is_empty() {
        let names = listed(normalised);
        notes.push(format!(
            "{names}: normalised by the device to a standard day"
        ));
    }
    notes
}
