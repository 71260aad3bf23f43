//! Reader of CSV tables of OptiTrack Motive: a line of properties; header lines with the type, name, kind and axis of
//! each column; data rows.

use std::collections::BTreeMap;

use crate::takes::error::{Fault, Location};
use crate::takes::format::Format;
use crate::takes::layout::{Attitude, Clock, Layout, Tracks};
use crate::takes::options::ReadOptions;
use crate::takes::sheet::{Sheet, separator};
use crate::takes::take::Take;
use crate::takes::unit::LengthUnit;
use crate::takes::words::{listed, shown};

/// Number of columns of an OptiTrack table before those of points and bodies: frame and time.
const FIXED: usize = 2;
/// Maximum number of header lines of an OptiTrack table after the first line, which contains the file's properties. The
/// line that names the axis of each column is included.
const MAX_HEADER_LINES: usize = 12;

/// Header lines of an OptiTrack table above the columns, with one text per column.
#[derive(Default)]
struct Heads {
    types: Vec<String>,
    names: Vec<String>,
    kinds: Vec<String>,
    axes: Vec<String>,
}

pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Take, Fault> {
    let mut sheet = Sheet::new(text, separator(text.lines().next().unwrap_or_default()));
    let properties = properties(&mut sheet)?;
    let line = Location::Line(1);
    let property = |name: &str| properties.get(name).map(String::as_str);
    if let Some(space) = property("Coordinate Space")
        && !space.eq_ignore_ascii_case("global")
    {
        let found = format!("the coordinate space {}", shown(space));
        return Err(Fault::new(line, found, "Global"));
    }
    let mut notes = Vec::new();
    let stated = match property("Length Units") {
        None => None,
        Some(text) => match LengthUnit::parse(text) {
            Some(unit) => Some(unit),
            None => {
                let found = format!("the unit {}", shown(text));
                return Err(Fault::new(
                    line,
                    found,
                    "Meters, Centimeters or Millimeters",
                ));
            }
        },
    };
    let length = options.length(stated, line, &mut notes)?;
    let stated_rows = match property("Total Exported Frames") {
        None => None,
        Some(text) => match text.parse() {
            Ok(count) => Some(count),
            Err(_) => return Err(Fault::new(line, shown(text), "a number of frames")),
        },
    };
    let heads = heads(&mut sheet)?;
    // The last column, an error, may have no axis.
    let kinds = heads.kinds.iter().rposition(|kind| !kind.is_empty());
    let width = sheet.filled().max(kinds.map_or(0, |last| last + 1));
    let tracks = tracks(&heads, &sheet)?;
    let mut layout = Layout {
        format: Format::OptiTrack,
        clock: Clock::Column(1, 1.0),
        length,
        points: Vec::new(),
        bodies: Vec::new(),
        width,
        zero_is_gap: false,
        notes,
        stated: stated_rows,
    };
    fill(&mut layout, &tracks, property("Rotation Type"), &sheet)?;
    if !sheet.advance()? {
        let location = Location::Line(sheet.line());
        return Err(Fault::new(location, "no rows", "at least one sample"));
    }
    let mut take = layout.samples(&mut sheet, |_| false)?;
    take.left_handed = Some(false);
    Ok(take)
}

/// Properties in the first line of an OptiTrack file, such as the unit of length, by name.
fn properties(sheet: &mut Sheet<'_>) -> Result<BTreeMap<String, String>, Fault> {
    if !sheet.advance()? || sheet.cell(0) != "Format Version" {
        let found = shown(sheet.cell(0));
        let expected = "the line of properties, from Format Version on";
        return Err(Fault::new(Location::Line(1), found, expected));
    }
    let cells = sheet.cells();
    let pairs = cells.chunks_exact(2);
    Ok(pairs
        .map(|pair| (pair[0].clone(), pair[1].clone()))
        .collect())
}

/// Reads the header lines of an OptiTrack table above the columns, up to and including the line that names the axis of
/// each column.
fn heads(sheet: &mut Sheet<'_>) -> Result<Heads, Fault> {
    const EXPECTED: &str = "the line of the axes, from Frame on";
    let mut heads = Heads::default();
    for _ in 0..MAX_HEADER_LINES {
        if !sheet.advance()? {
            let location = Location::Line(sheet.line());
            return Err(Fault::new(location, "the end of the file", EXPECTED));
        }
        let is_axis = |cell: &String| matches!(cell.as_str(), "X" | "Y" | "Z" | "W");
        // Old exports do not name the columns of frame and time.
        let is_unnamed = sheet.cell(0).is_empty() && sheet.cell(1).is_empty();
        if sheet.cell(0).eq_ignore_ascii_case("frame")
            || is_unnamed && sheet.cells().iter().skip(FIXED).all(is_axis)
        {
            let time = sheet.cell(1).to_ascii_lowercase();
            if !(is_unnamed || time == "time" || time.starts_with("time (s")) {
                let found = shown(sheet.cell(1));
                return Err(sheet.fault(1, found, "a column Time (Seconds)"));
            }
            heads.axes = sheet.cells();
            let missing = |what: &str| {
                let expected = format!("a line {what} above the axes");
                Fault::new(
                    Location::Line(sheet.line()),
                    format!("no line {what}"),
                    expected,
                )
            };
            return match (
                heads.types.is_empty(),
                heads.names.is_empty(),
                heads.kinds.is_empty(),
            ) {
                (true, ..) => Err(missing("Type")),
                (_, true, _) => Err(missing("Name")),
                (.., true) => Err(missing("of Position and Rotation")),
                _ => Ok(heads),
            };
        }
        let is_kinds = |cell: &String| cell == "Position" || cell == "Rotation";
        let is_type = |cell: &String| cell == "Marker" || cell == "Rigid Body";
        match sheet.cell(1) {
            "Type" => heads.types = sheet.cells(),
            "Name" => heads.names = sheet.cells(),
            _ if sheet.cells().iter().skip(FIXED).any(is_kinds) => heads.kinds = sheet.cells(),
            "" if heads.types.is_empty() && sheet.cells().iter().any(is_type) => {
                heads.types = sheet.cells();
            }
            "" if heads.names.is_empty() && !heads.types.is_empty() => {
                heads.names = sheet.cells();
            }
            _ => {}
        }
    }
    Err(sheet.fault(0, shown(sheet.cell(0)), EXPECTED))
}

/// Columns of each recorded point or body by its type and name.
fn tracks(heads: &Heads, sheet: &Sheet<'_>) -> Result<Tracks<(String, String)>, Fault> {
    let mut tracks = Tracks::default();
    let at = |row: &[String], index: usize| row.get(index).cloned().unwrap_or_default();
    for index in FIXED..heads.axes.len() {
        let (kind, axis) = (at(&heads.kinds, index), at(&heads.axes, index));
        let name = at(&heads.names, index);
        let is_rotation = kind == "Rotation";
        if !is_rotation && kind != "Position" {
            continue;
        }
        let track = tracks.entry((at(&heads.types, index), name.clone()));
        let slot = match (is_rotation, axis.as_str()) {
            (false, "X" | "Y" | "Z") => {
                let axis = ["X", "Y", "Z"].iter().position(|name| *name == axis);
                &mut track.position[axis.unwrap_or(0)]
            }
            (true, "W" | "X" | "Y" | "Z") => {
                let component = ["W", "X", "Y", "Z"].iter().position(|name| *name == axis);
                &mut track.quaternion[component.unwrap_or(0)]
            }
            _ => {
                return Err(sheet.fault(
                    index,
                    shown(&axis),
                    "an axis X, Y, Z, or W of a rotation",
                ));
            }
        };
        if slot.replace(index).is_some() {
            let found = format!("a second {axis} of {}", shown(&name));
            return Err(sheet.fault(index, found, "each axis once"));
        }
    }
    Ok(tracks)
}

/// Adds the columns of the points and bodies in `tracks` to the layout. Measured positions of a rigid body's markers
/// are preferred; positions that Motive solved for are used only for markers without measured ones.
fn fill(
    layout: &mut Layout,
    tracks: &Tracks<(String, String)>,
    rotation: Option<&str>,
    sheet: &Sheet<'_>,
) -> Result<(), Fault> {
    let measured = |name: &str| {
        tracks
            .list
            .iter()
            .any(|((kind, other), _)| kind == "Marker" && other == name)
    };
    let is_unlabelled = |name: &str| name.is_empty() || name.starts_with("Unlabeled");
    let mut left_out = Vec::new();
    for ((kind, name), track) in &tracks.list {
        let is_body = matches!(kind.as_str(), "Rigid Body" | "Bone");
        let is_solved = matches!(kind.as_str(), "Rigid Body Marker" | "Bone Marker");
        let is_named = !is_unlabelled(name);
        if !(is_body || is_solved || kind == "Marker") || !is_named || is_solved && measured(name) {
            left_out.push(format!("{kind} {}", shown(name)));
            continue;
        }
        let [Some(x), Some(y), Some(z)] = track.position else {
            let found = format!("no position of {}", shown(name));
            let location = Location::Line(sheet.line());
            return Err(Fault::new(location, found, "X, Y and Z of each position"));
        };
        if is_solved {
            let name = shown(name);
            layout
                .notes
                .push(format!("{name} is as solved for, not as measured"));
        }
        if !is_body {
            layout.points.push((name.clone(), [x, y, z]));
            continue;
        }
        let attitude = match track.quaternion {
            [Some(w), Some(a), Some(b), Some(c)] => Attitude::Quaternion([w, a, b, c]),
            [None, None, None, None] => {
                layout.points.push((name.clone(), [x, y, z]));
                continue;
            }
            _ => {
                let kind = rotation.unwrap_or("another type");
                let found = format!("rotations of {} as {}", shown(name), shown(kind));
                let location = Location::Line(sheet.line());
                return Err(Fault::new(
                    location,
                    found,
                    "an export with Rotation Type Quaternion",
                ));
            }
        };
        layout.bodies.push((name.clone(), [x, y, z], attitude));
    }
    let mut names = tracks.list.iter().map(|((_, name), _)| name);
    if layout.points.is_empty() && layout.bodies.is_empty() && names.any(|n| is_unlabelled(n)) {
        return Err(Fault::new(
            Location::Line(sheet.line()),
            "markers without labels only",
            "labelled markers or a rigid body: label them in Motive, and export again",
        ));
    }
    if !left_out.is_empty() {
        let names = listed(&left_out);
        layout
            .notes
            .push(format!("columns that are not read: {names}"));
    }
    Ok(())
}
