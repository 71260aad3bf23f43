//! Reader of CSV tables of Vicon Nexus: sections that consist of a name, a rate, labels, column names, units and rows.

use crate::takes::{
    Clock, Fault, Format, Layout, LengthUnit, Location, ReadOptions, Sheet, Take, listed,
    separator, shown,
};

const SECTION: &str = "Trajectories";
/// Number of columns of a Vicon table before those of the first point: frame and sub-frame.
const FIXED: usize = 2;
const END: &str = "the end of the file";

pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Take, Fault> {
    const COLUMNS: &str = "the names of the columns, from Frame on";
    let header = text.lines().take(20).find(|line| line.starts_with("Frame"));
    let mut sheet = Sheet::new(text, separator(header.unwrap_or(",")));
    let mut notes = Vec::new();
    find_section(&mut sheet, &mut notes)?;
    let at = |sheet: &Sheet<'_>| Location::Line(sheet.line());
    sheet.require(END, "the frames per second of the section")?;
    let stated = sheet.needed(0, "the frames per second of the section")?;
    let rate = options.rate(Some(stated), at(&sheet), &mut notes)?;
    if !sheet.advance_line()? {
        return Err(sheet.line_fault(END, "the labels of the points"));
    }
    let (labels, labels_at) = (sheet.cells(), at(&sheet));
    sheet.require(END, COLUMNS)?;
    if !sheet.cell(0).eq_ignore_ascii_case("frame") {
        return Err(sheet.fault(0, shown(sheet.cell(0)), COLUMNS));
    }
    let points = points(&sheet, &labels, labels_at, &mut notes)?;
    let width = sheet.filled();
    sheet.require(END, "a row of units, or the first sample")?;
    let unit = units(&sheet, &points)?;
    let length = options.length(unit, at(&sheet), &mut notes)?;
    if sheet.cell(0).is_empty() {
        sheet.require(END, "the first sample")?;
    }
    let mut layout = Layout::new(Format::Vicon, Clock::Frame(0, rate), length, width);
    layout.notes = notes;
    for (label, position) in points {
        layout.add(label, position, None);
    }
    // Another section may follow; its first cell is a name, not a number.
    layout.samples(&mut sheet, is_name)
}

fn is_name(sheet: &Sheet<'_>) -> bool {
    sheet.filled() == 1 && sheet.cell(0).starts_with(|c: char| c.is_ascii_alphabetic())
}

/// Advances to the section with the trajectories of points; adds a note that lists the sections before it.
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
        if is_name(sheet) {
            skipped.push(shown(name));
        }
    }
    let found = if skipped.is_empty() {
        "no section".to_owned()
    } else {
        format!("the sections {}", listed(&skipped))
    };
    let expected = format!("the section {SECTION}: export the trajectories of the markers");
    Err(sheet.line_fault(found, expected))
}

/// Labels and column indices of the points; the current row names the columns.
fn points(
    sheet: &Sheet<'_>,
    labels: &[String],
    labels_at: Location,
    notes: &mut Vec<String>,
) -> Result<Vec<(String, [usize; 3])>, Fault> {
    let mut found: Vec<(String, [usize; 3])> = Vec::new();
    for (index, label) in labels.iter().enumerate() {
        if label.is_empty() {
            continue;
        }
        let columns = [index, index + 1, index + 2];
        let axes = columns.map(|column| sheet.cell(column));
        if index < FIXED || axes.map(str::to_ascii_uppercase) != ["X", "Y", "Z"] {
            let found = format!("the columns {} under {}", axes.join(", "), shown(label));
            return Err(sheet.fault(index, found, "X, Y, Z under each label"));
        }
        found.push((label.clone(), columns));
    }
    let Some((first, _)) = found.first() else {
        return Err(Fault::new(
            labels_at,
            "no labels",
            "a label over each X, Y, Z",
        ));
    };
    let names = sheet.cells();
    let axes = names
        .iter()
        .filter(|name| matches!(name.as_str(), "X" | "Y" | "Z"));
    let unlabelled = axes.count().saturating_sub(3 * found.len());
    if unlabelled > 0 {
        notes.push(format!(
            "{unlabelled} columns without a label were left out"
        ));
    }
    if let Some((subject, _)) = first.split_once(':') {
        let subject = subject.to_owned();
        let prefix = format!("{subject}:");
        let has_prefix = |label: &str| label.len() > prefix.len() && label.starts_with(&prefix);
        if found.iter().all(|(label, _)| has_prefix(label)) {
            for (label, _) in &mut found {
                label.drain(..prefix.len());
            }
            let subject = shown(&subject);
            notes.push(format!("the subject {subject} is left out of the labels"));
        }
    }
    Ok(found)
}

fn units(sheet: &Sheet<'_>, points: &[(String, [usize; 3])]) -> Result<Option<LengthUnit>, Fault> {
    let mut unit = None;
    if !sheet.cell(0).is_empty() {
        return Ok(unit);
    }
    for &index in points.iter().flat_map(|(_, columns)| columns) {
        let fault = |expected| Err(sheet.fault(index, shown(sheet.cell(index)), expected));
        match (LengthUnit::parse(sheet.cell(index)), unit) {
            (None, _) => return fault("a unit of length, such as mm"),
            (Some(found), Some(unit)) if found != unit => return fault("one unit of length"),
            (found, _) => unit = found,
        }
    }
    Ok(unit)
}
