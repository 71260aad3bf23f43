//! Reader of CSV tables of OptiTrack Motive: a line of properties; header lines with the type, name, kind and axis of
//! each column; data rows.

use std::collections::BTreeMap;

use crate::takes::{
    Attitude, Clock, Fault, Format, Layout, LengthUnit, Location, ReadOptions, Sheet, Take, Tracks,
    listed, separator, shown,
};

/// Number of columns of an OptiTrack table before those of points and bodies: frame and time.
const FIXED: usize = 2;
/// Maximum number of header lines after the line of properties, up to the line of the axes.
const MAX_HEADER_LINES: usize = 12;

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
    let stated = property("Length Units").map(|text| {
        let found = format!("the unit {}", shown(text));
        let fault = || Fault::new(line, found, "Meters, Centimeters or Millimeters");
        LengthUnit::parse(text).ok_or_else(fault)
    });
    let mut notes = Vec::new();
    let length = options.length(stated.transpose()?, line, &mut notes)?;
    let rows = property("Total Exported Frames").map(|text| {
        let fault = |_| Fault::new(line, shown(text), "a number of frames");
        text.parse().map_err(fault)
    });
    let rows = rows.transpose()?;
    let heads = heads(&mut sheet)?;
    // The last column, an error, may have no axis.
    let kinds = heads.kinds.iter().rposition(|kind| !kind.is_empty());
    let width = sheet.filled().max(kinds.map_or(0, |last| last + 1));
    let tracks = tracks(&heads, &sheet)?;
    let mut layout = Layout::new(Format::OptiTrack, Clock::Column(1, 1.0), length, width);
    (layout.notes, layout.stated) = (notes, rows);
    fill(&mut layout, &tracks, property("Rotation Type"), &sheet)?;
    sheet.require("no rows", "at least one sample")?;
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
    let pairs = cells
        .chunks_exact(2)
        .map(|pair| (pair[0].clone(), pair[1].clone()));
    Ok(pairs.collect())
}

/// Reads the header lines above the columns, up to and including the line that names the axis of each column.
fn heads(sheet: &mut Sheet<'_>) -> Result<Heads, Fault> {
    const EXPECTED: &str = "the line of the axes, from Frame on";
    let is_axis = |cell: &String| matches!(cell.as_str(), "X" | "Y" | "Z" | "W");
    let is_kind = |cell: &String| cell == "Position" || cell == "Rotation";
    let is_type = |cell: &String| cell == "Marker" || cell == "Rigid Body";
    let mut heads = Heads::default();
    for _ in 0..MAX_HEADER_LINES {
        sheet.require("the end of the file", EXPECTED)?;
        let cells = sheet.cells();
        // Old exports do not name the columns of frame and time.
        let is_unnamed = sheet.cell(0).is_empty() && sheet.cell(1).is_empty();
        if sheet.cell(0).eq_ignore_ascii_case("frame")
            || is_unnamed && cells.iter().skip(FIXED).all(is_axis)
        {
            let time = sheet.cell(1).to_ascii_lowercase();
            if !(is_unnamed || time == "time" || time.starts_with("time (s")) {
                return Err(sheet.fault(1, shown(sheet.cell(1)), "a column Time (Seconds)"));
            }
            heads.axes = cells;
            let lines = [
                (&heads.types, "Type"),
                (&heads.names, "Name"),
                (&heads.kinds, "of Position and Rotation"),
            ];
            return match lines.iter().find(|(line, _)| line.is_empty()) {
                None => Ok(heads),
                Some((_, what)) => {
                    let expected = format!("a line {what} above the axes");
                    Err(sheet.line_fault(format!("no line {what}"), expected))
                }
            };
        }
        match sheet.cell(1) {
            "Type" => heads.types = cells,
            "Name" => heads.names = cells,
            _ if cells.iter().skip(FIXED).any(is_kind) => heads.kinds = cells,
            "" if heads.types.is_empty() && cells.iter().any(is_type) => heads.types = cells,
            "" if heads.names.is_empty() && !heads.types.is_empty() => heads.names = cells,
            _ => {}
        }
    }
    Err(sheet.fault(0, shown(sheet.cell(0)), EXPECTED))
}

fn tracks(heads: &Heads, sheet: &Sheet<'_>) -> Result<Tracks<(String, String)>, Fault> {
    let mut tracks = Tracks::default();
    let at = |row: &[String], index: usize| row.get(index).cloned().unwrap_or_default();
    for (index, axis) in heads.axes.iter().enumerate().skip(FIXED) {
        let (kind, name) = (at(&heads.kinds, index), at(&heads.names, index));
        if kind != "Position" && kind != "Rotation" {
            continue;
        }
        let track = tracks.entry((at(&heads.types, index), name.clone()));
        let component = ["W", "X", "Y", "Z"].iter().position(|known| known == axis);
        let slot = match component {
            Some(component) if kind == "Rotation" => &mut track.quaternion[component],
            Some(component @ 1..) => &mut track.position[component - 1],
            _ => {
                let expected = "an axis X, Y, Z, or W of a rotation";
                return Err(sheet.fault(index, shown(axis), expected));
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
    let names = || tracks.list.iter().map(|(key, _)| key);
    let is_measured = |name: &str| names().any(|(kind, own)| kind == "Marker" && own == name);
    let is_unlabelled = |name: &str| name.is_empty() || name.starts_with("Unlabeled");
    let mut left_out = Vec::new();
    for ((kind, name), track) in &tracks.list {
        let is_body = matches!(kind.as_str(), "Rigid Body" | "Bone");
        let is_solved = matches!(kind.as_str(), "Rigid Body Marker" | "Bone Marker");
        let is_known = is_body || is_solved || kind == "Marker";
        if !is_known || is_unlabelled(name) || is_solved && is_measured(name) {
            left_out.push(format!("{kind} {}", shown(name)));
            continue;
        }
        let [Some(x), Some(y), Some(z)] = track.position else {
            let found = format!("no position of {}", shown(name));
            return Err(sheet.line_fault(found, "X, Y and Z of each position"));
        };
        if is_solved {
            let note = format!("{} is as solved for, not as measured", shown(name));
            layout.notes.push(note);
        }
        let attitude = match track.quaternion {
            [Some(w), Some(a), Some(b), Some(c)] if is_body => {
                Some(Attitude::Quaternion([w, a, b, c]))
            }
            [None, None, None, None] => None,
            _ if !is_body => None,
            _ => {
                let kind = shown(rotation.unwrap_or("another type"));
                let found = format!("rotations of {} as {kind}", shown(name));
                let expected = "an export with Rotation Type Quaternion";
                return Err(sheet.line_fault(found, expected));
            }
        };
        layout.add(name.clone(), [x, y, z], attitude);
    }
    if layout.is_empty() && names().any(|(_, name)| is_unlabelled(name)) {
        return Err(sheet.line_fault(
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
