//! Reader of tables with one header line that names every column: points, poses, and files of DLTdv8.

use crate::takes::clock_time;
use crate::takes::columns::Quantity;
use crate::takes::neighbours::{columns_of, euler};
use crate::takes::{
    Attitude, Clock, Fault, Format, Layout, LengthUnit, Location, ReadOptions, Sheet, Take,
    TimeUnit, TrackColumns, Tracks, is_digitised, listed, separator, shown,
};

/// Label used for a point or body whose column names contain no label.
const UNNAMED: &str = "body";

/// Columns of a table of motion-capture data, as its header line names them.
#[derive(Default)]
struct Header {
    /// Columns of each recorded point or body by its label.
    tracks: Tracks<String>,
    time: Option<(usize, Option<TimeUnit>)>,
    frame: Option<usize>,
    length: Option<LengthUnit>,
    others: Vec<String>,
}

pub(super) fn read(text: &str, format: Format, options: &ReadOptions) -> Result<Take, Fault> {
    let mut sheet = Sheet::new(text, separator(text));
    if !sheet.advance()? {
        let expected = "a header that names the columns";
        return Err(Fault::new(Location::Line(1), "no header", expected));
    }
    let (header, width) = (Header::new(&sheet)?, sheet.filled());
    let line = Location::Line(sheet.line());
    if format == Format::Dltdv {
        // Every name must be one that DLTdv8 writes.
        let cells = sheet.cells();
        let mut foreign = cells
            .iter()
            .enumerate()
            .filter(|(_, name)| !is_digitised(name));
        if let Some((index, name)) = foreign.next() {
            let expected = "columns such as pt1_X, pt1_Y, pt1_Z of DLTdv8";
            return Err(sheet.fault(index, shown(name), expected));
        }
    }
    let mut notes = Vec::new();
    sheet.require("a header and no rows", "at least one sample")?;
    let clock = header.clock((&sheet, line), options, &mut notes)?;
    let length = options.length(header.length, line, &mut notes)?;
    if !header.others.is_empty() {
        let names = listed(&header.others);
        notes.push(format!("columns that are not read: {names}"));
    }
    let mut layout = Layout::new(format, clock, length, width);
    layout.notes = notes;
    for (label, track) in header.tracks.list {
        let label = Some(label).filter(|label| !label.is_empty());
        let label = label.unwrap_or_else(|| UNNAMED.to_owned());
        let incomplete = |what: String| {
            let expected = "x, y and z of every point, and qw, qx, qy and qz of every pose";
            Fault::new(line, what, expected)
        };
        let [Some(x), Some(y), Some(z)] = track.position else {
            let missing = track.position.iter().position(Option::is_none);
            let axis = ["x", "y", "z"][missing.unwrap_or(0)];
            return Err(incomplete(format!("no {axis} of {}", shown(&label))));
        };
        let attitude = match track.quaternion {
            [None, None, None, None] => None,
            [Some(a), Some(b), Some(c), Some(d)] => Some(Attitude::Quaternion([a, b, c, d])),
            _ => {
                let found = format!("a quaternion of {} with a part missing", shown(&label));
                return Err(incomplete(found));
            }
        };
        layout.add(label, [x, y, z], attitude);
    }
    if layout.has_bodies() {
        let note =
            "the quaternions are read as rotations from the body's axes to those of the room";
        layout.notes.push(note.into());
    } else if format == Format::Poses {
        let expected = "columns qw, qx, qy and qz of at least one pose";
        return Err(Fault::new(line, "no quaternion", expected));
    }
    layout.samples(&mut sheet, |_| false)
}

impl Header {
    fn new(sheet: &Sheet<'_>) -> Result<Self, Fault> {
        let mut header = Self::default();
        let mut names = sheet.cells();
        names.truncate(sheet.filled());
        let columns = columns_of(&names);
        for (index, (name, column)) in names.iter().zip(columns).enumerate() {
            let twice = |before: Option<usize>| {
                let found = || format!("a second column {}", shown(name));
                let fault = |_| Err(sheet.fault(index, found(), "each column once"));
                before.map_or(Ok(()), fault)
            };
            match column.quantity {
                Quantity::Time(unit) => {
                    twice(header.time.map(|(index, _)| index))?;
                    header.time = Some((index, unit));
                }
                Quantity::Frame => twice(header.frame.replace(index))?,
                Quantity::Coordinate(axis, unit) => {
                    let track = header.tracks.entry(column.label);
                    twice(track.position[axis].replace(index))?;
                    match (header.length, unit) {
                        (Some(a), Some(b)) if a != b => {
                            let found = format!("lengths in {a} and in {b}");
                            return Err(sheet.fault(index, found, "one unit of length"));
                        }
                        _ => header.length = header.length.or(unit),
                    }
                }
                Quantity::Quaternion(component) => {
                    let track = header.tracks.entry(column.label);
                    twice(track.quaternion[component].replace(index))?;
                }
                Quantity::Other => header.others.push(shown(name)),
            }
        }
        header.refuse_euler(sheet, &names)?;
        Ok(header)
    }

    /// An error if the attitude of a body is given by Euler angles alone: their order and their axes are not stated.
    fn refuse_euler(&self, sheet: &Sheet<'_>, names: &[String]) -> Result<(), Fault> {
        let tracks = &self.tracks.list;
        let has_quaternion =
            |(_, track): &(String, TrackColumns)| track.quaternion.iter().any(Option::is_some);
        if tracks.iter().any(has_quaternion) {
            return Ok(());
        }
        for (index, name) in names.iter().enumerate() {
            let Some(body) = euler(name) else {
                continue;
            };
            let is_own = |(label, _): &(String, TrackColumns)| label.eq_ignore_ascii_case(&body);
            if tracks.len() == 1 || tracks.iter().any(is_own) {
                let found = format!("the Euler angle {}", shown(name));
                let expected = "quaternions, as columns qw, qx, qy and qz: export quaternions, as the order of Euler angles differs between programs";
                return Err(sheet.fault(index, found, expected));
            }
        }
        Ok(())
    }

    /// Source of the times. `sheet` is at the first row, `line` is that of the header.
    fn clock(
        &self,
        (sheet, line): (&Sheet<'_>, Location),
        options: &ReadOptions,
        notes: &mut Vec<String>,
    ) -> Result<Clock, Fault> {
        match (self.time, self.frame) {
            (Some((index, _)), _) if clock_time::seconds(sheet.cell(index)).is_some() => {
                Ok(Clock::Column(index, TimeUnit::Second.seconds()))
            }
            (Some((index, unit)), _) => match options.time.or(unit) {
                Some(chosen) => {
                    if unit.is_some_and(|unit| unit != chosen) {
                        let note = "the unit of the times was set by the option --time";
                        notes.push(note.into());
                    }
                    Ok(Clock::Column(index, chosen.seconds()))
                }
                None => Err(Fault::new(
                    line,
                    "times without a unit",
                    "a unit in the column's name, as in t_s, or the option --time s or ms",
                )),
            },
            (None, Some(index)) => Ok(Clock::Frame(index, options.rate(None, line, notes)?)),
            (None, None) if options.rate.is_none() && !self.others.is_empty() => {
                let found = format!("no times; not read is {}", listed(&self.others));
                let expected = "a column t or time with its unit, as in t_s, a column frame, or the option --rate with the frames per second";
                Err(Fault::new(line, found, expected))
            }
            (None, None) => Ok(Clock::Count(options.rate(None, line, notes)?)),
        }
    }
}
