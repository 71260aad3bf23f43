//! Reader of CSV tables of Vicon Nexus: sections that consist of a name, a rate, labels, column names, units and rows.

use crate::takes::error::{Fault, Location};
use crate::takes::format::Format;
use crate::takes::layout::{Clock, Layout};
use crate::takes::options::ReadOptions;
use crate::takes::sheet::{Sheet, separator};
use crate::takes::take::Take;
use crate::takes::unit::LengthUnit;
use crate::takes::words::{listed, shown};

/// Name of the section of a Vicon file with the trajectories of points, the only section that is read.
const SECTION: &str = "Trajectories";
/// Number of columns of a Vicon table before those of the first point: frame and sub-frame.
const FIXED: usize = 2;

pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Take, Fault> {
    let header = text.lines().take(20).find(|line| line.starts_with("Frame"));
    let mut sheet = Sheet::new(text, separator(header.unwrap_or(",")));
    let mut notes = Vec::new();
    find_section(&mut sheet, &mut notes)?;
    let at = |sheet: &Sheet<'_>| Location::Line(sheet.line());
    let next = |sheet: &mut Sheet<'_>, what: &str| match sheet.advance()? {
        true => Ok(()),
        false => {
            let found = "the end of the file";
            Err(Fault::new(at(sheet), found, what))
        }
    };
    next(&mut sheet, "the frames per second of the section")?;
    let stated = sheet.needed(0, "the frames per second of the section")?;
    let rate = options.rate(Some(stated), at(&sheet), &mut notes)?;
    if !sheet.advance_line()? {
        let found = "the end of the file";
        return Err(Fault::new(at(&sheet), found, "the labels of the points"));
    }
    let labels = sheet.cells();
    let labels_line = sheet.line();
    next(&mut sheet, "the names of the columns, from Frame on")?;
    if !sheet.cell(0).eq_ignore_ascii_case("frame") {
        let found = shown(sheet.cell(0));
        return Err(sheet.fault(0, found, "the names of the columns, from Frame on"));
    }
    let names = sheet.cells();
    let points = points(&sheet, &labels, labels_line, &names, &mut notes)?;
    let width = sheet.filled();
    next(&mut sheet, "a row of units, or the first sample")?;
    let unit = units(&sheet, &points)?;
    let length = options.length(unit, at(&sheet), &mut notes)?;
    if sheet.cell(0).is_empty() {
        next(&mut sheet, "the first sample")?;
    }
    let layout = Layout {
        format: Format::Vicon,
        clock: Clock::Frame(0, rate),
        length,
        points,
        bodies: Vec::new(),
        width,
        zero_is_gap: false,
        notes,
        stated: None,
    };
    // Another section may follow; its first cell is a name, not a number.
    let starts_section = |sheet: &Sheet<'_>| {
        sheet.filled() == 1 && sheet.cell(0).starts_with(|c: char| c.is_ascii_alphabetic())
    };
    layout.samples(&mut sheet, starts_section)
}

/// Advances to the section of a Vicon file with the trajectories of points; adds a note that lists the sections before
/// it.
fn find_section(sheet: &mut Sheet<'_>, notes: &mut Vec<String>) -> Result<(), Fault> {
    let mut skipped: Vec<String> = Vec::new();
    while sheet.advance()? {
        let name = sheet.cell(0);
        if name == SECTION {
            if !skipped.is_empty() {
                notes.push(format!("sections that are not read: {}", listed(&skipped)));
            }
            return Ok(());
        }
        if sheet.filled() == 1 && name.starts_with(|c: char| c.is_ascii_alphabetic()) {
            skipped.push(shown(name));
        }
    }
    let found = match skipped.is_empty() {
        true => "no section".to_owned(),
        false => format!("the sections {}", listed(&skipped)),
    };
    let location = Location::Line(sheet.line());
    Err(Fault::new(
        location,
        found,
        format!("the section {SECTION}: export the trajectories of the markers"),
    ))
}

/// Labels and column indices of the points in a Vicon table. A subject name with which all labels begin is removed from
/// the labels.
fn points(
    sheet: &Sheet<'_>,
    labels: &[String],
    labels_line: usize,
    names: &[String],
    notes: &mut Vec<String>,
) -> Result<Vec<(String, [usize; 3])>, Fault> {
    let mut found: Vec<(String, [usize; 3])> = Vec::new();
    for (index, label) in labels.iter().enumerate() {
        if label.is_empty() {
            continue;
        }
        let name = |offset: usize| names.get(index + offset).map_or("", String::as_str);
        let axes = [name(0), name(1), name(2)];
        if index < FIXED || axes.map(str::to_ascii_uppercase) != ["X", "Y", "Z"] {
            let found = format!("the columns {} under {}", axes.join(", "), shown(label));
            return Err(sheet.fault(index, found, "X, Y, Z under each label"));
        }
        found.push((label.clone(), [index, index + 1, index + 2]));
    }
    let columns = |name: &&String| matches!(name.as_str(), "X" | "Y" | "Z");
    let unlabelled = names
        .iter()
        .filter(columns)
        .count()
        .saturating_sub(3 * found.len());
    if found.is_empty() {
        let location = Location::Line(labels_line);
        return Err(Fault::new(
            location,
            "no labels",
            "a label over each X, Y, Z",
        ));
    }
    if unlabelled > 0 {
        notes.push(format!(
            "{unlabelled} columns without a label were left out"
        ));
    }
    let subject = found[0]
        .0
        .split_once(':')
        .map(|(subject, _)| subject.to_owned());
    if let Some(subject) = subject {
        let prefix = format!("{subject}:");
        if found
            .iter()
            .all(|(label, _)| label.len() > prefix.len() && label.starts_with(&prefix))
        {
            for (label, _) in &mut found {
                label.drain(..prefix.len());
            }
            notes.push(format!(
                "the subject {} is left out of the labels",
                shown(&subject)
            ));
        }
    }
    Ok(found)
}

/// Unit of the points' coordinates from the current row of a Vicon table; `None` if this row is not a row of units.
fn units(sheet: &Sheet<'_>, points: &[(String, [usize; 3])]) -> Result<Option<LengthUnit>, Fault> {
    if !sheet.cell(0).is_empty() {
        return Ok(None);
    }
    let mut unit = None;
    for &index in points.iter().flat_map(|(_, columns)| columns) {
        let text = sheet.cell(index);
        let Some(found) = LengthUnit::parse(text) else {
            return Err(sheet.fault(index, shown(text), "a unit of length, such as mm"));
        };
        if unit.is_some_and(|unit| unit != found) {
            return Err(sheet.fault(index, shown(text), "one unit of length"));
        }
        unit = Some(found);
    }
    Ok(unit)
}
