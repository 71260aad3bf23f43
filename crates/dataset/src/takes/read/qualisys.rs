//! Reader of tables of Qualisys Track Manager: lines of a keyword and its values, then rows of points or of rigid
//! bodies.
//!
//! The columns of a body are position, three angles, residual, and rotation matrix column by column, from the body's
//! axes to those of the room (QTM manual, 6DOF tracking output). Lengths are in mm: the format fixes this, and the file
//! does not state it.

use std::collections::BTreeMap;
use std::str::FromStr;

use crate::takes::format::{Format, QUALISYS_HEADER as HEADER};
use crate::takes::{
    Attitude, Clock, Fault, Layout, LengthUnit, Location, ReadOptions, Sheet, Take, shown,
};

/// Number of columns per body in a Qualisys table: position (3), angles (3), residual (1), rotation matrix (9).
const BODY: usize = 16;
/// Index, within the columns of a body, of the first column of the rotation matrix.
const MATRIX: usize = 7;

pub(super) fn read(text: &str, format: Format, options: &ReadOptions) -> Result<Take, Fault> {
    let has_tabs = text.lines().take(HEADER).any(|line| line.contains('\t'));
    let mut sheet = Sheet::new(text, if has_tabs { '\t' } else { ',' });
    let has_bodies = format == Format::QualisysPoses;
    let head = Head::read(&mut sheet)?;
    let end = Location::Line(sheet.line());
    let (keyword, counted, parts) = if has_bodies {
        ("BODY_NAMES", "NO_OF_BODIES", BODY)
    } else {
        ("MARKER_NAMES", "NO_OF_MARKERS", 3)
    };
    let Some((line, labels)) = head.keywords.get(keyword) else {
        let found = format!("no line {keyword}");
        return Err(Fault::new(end, found, "the labels of the tracks"));
    };
    let named = labels.iter().rposition(|label| !label.is_empty());
    let labels = &labels[..named.map_or(0, |last| last + 1)];
    if let Some(at) = labels.iter().position(String::is_empty) {
        let location = Location::Cell(*line, at + 2);
        return Err(Fault::new(
            location,
            "an empty label",
            "a label of each track",
        ));
    }
    let count = |keyword| head.value::<usize>(keyword, "a count");
    if let Some(stated) = count(counted)?.filter(|stated| *stated != labels.len()) {
        let (found, expected) = (
            format!("{} labels", labels.len()),
            format!("{stated}, as stated above"),
        );
        return Err(Fault::new(Location::Line(*line), found, expected));
    }
    let stated = head.value("FREQUENCY", "the frames per second")?;
    let mut notes = Vec::new();
    let length = options.length(Some(LengthUnit::Millimetre), end, &mut notes)?;
    if options.length.is_none() {
        notes.push("lengths are in mm, as Qualisys writes them".into());
    }
    if !head.has_rows {
        return Err(Fault::new(end, "no rows", "at least one sample"));
    }
    let fixed = fixed_columns(&sheet, head.titles.as_deref(), parts * labels.len())?;
    let start = fixed.len();
    let clock = match fixed {
        [.., Fixed::Time] => Clock::Column(start - 1, 1.0),
        [.., Fixed::Frame] => Clock::Frame(0, options.rate(stated, end, &mut notes)?),
        [] => Clock::Count(options.rate(stated, end, &mut notes)?),
    };
    let mut layout = Layout::new(format, clock, length, start + parts * labels.len());
    layout.zero_is_gap = true;
    layout.notes = notes;
    layout.stated = count("NO_OF_FRAMES")?;
    for (i, label) in labels.iter().enumerate() {
        let first = start + parts * i;
        // The file contains the matrix column by column.
        let entries = [0, 3, 6, 1, 4, 7, 2, 5, 8].map(|entry| first + MATRIX + entry);
        let attitude = has_bodies.then_some(Attitude::Matrix(entries));
        layout.add(label.clone(), [first, first + 1, first + 2], attitude);
    }
    layout.samples(&mut sheet, |_| false)
}

struct Head {
    /// Line number and values of each header line, by its keyword.
    keywords: BTreeMap<String, (usize, Vec<String>)>,
    titles: Option<Vec<String>>,
    has_rows: bool,
}

impl Head {
    fn read(sheet: &mut Sheet<'_>) -> Result<Self, Fault> {
        let mut head = Self {
            keywords: BTreeMap::new(),
            titles: None,
            has_rows: false,
        };
        while sheet.advance()? {
            let first = sheet.cell(0).to_owned();
            let is_text = head.titles.is_none() && first != "NULL";
            let is_upper = |b: u8| b.is_ascii_uppercase() || b.is_ascii_digit() || b == b'_';
            let is_keyword = is_text
                && first.len() > 1
                && first.bytes().all(is_upper)
                && first.starts_with(|c: char| c.is_ascii_uppercase());
            if is_keyword && head.keywords.len() < HEADER {
                let values = sheet.cells().split_off(1);
                head.keywords.insert(first, (sheet.line(), values));
            } else if is_text && first.starts_with(|c: char| c.is_ascii_alphabetic()) {
                head.titles = Some(sheet.cells());
            } else {
                head.has_rows = true;
                break;
            }
        }
        Ok(head)
    }

    /// First value of the header line that begins with `keyword`; `None` if there is no such line.
    fn value<V: FromStr>(&self, keyword: &str, expected: &str) -> Result<Option<V>, Fault> {
        let Some((line, values)) = self.keywords.get(keyword) else {
            return Ok(None);
        };
        let text = values.first().map_or("", String::as_str);
        let fault = |_| Fault::new(Location::Cell(*line, 2), shown(text), expected);
        text.replace(',', ".").parse().map(Some).map_err(fault)
    }
}

enum Fixed {
    Frame,
    Time,
}

/// Contents, in order, of the columns that precede those of the first point or body, by the column titles or, without
/// them, by the number of cells in the current row; `tracks` is the number of columns of all points or bodies.
fn fixed_columns(
    sheet: &Sheet<'_>,
    titles: Option<&[String]>,
    tracks: usize,
) -> Result<&'static [Fixed], Fault> {
    if let Some(titles) = titles {
        let is = |index: usize, name: &str| {
            let title = titles.get(index).map_or("", String::as_str);
            title.to_ascii_lowercase().starts_with(name)
        };
        return Ok(match (is(0, "frame"), is(0, "time"), is(1, "time")) {
            (true, _, true) => &[Fixed::Frame, Fixed::Time],
            (true, _, false) => &[Fixed::Frame],
            (false, true, _) => &[Fixed::Time],
            _ => &[],
        });
    }
    match sheet.filled().max(tracks) - tracks {
        0 if sheet.width() >= tracks => Ok(&[]),
        2 => Ok(&[Fixed::Frame, Fixed::Time]),
        _ => {
            let found = format!("{} cells", sheet.filled());
            let expected = format!("{tracks}, or {} with frame and time", tracks + 2);
            Err(sheet.fault(0, found, expected))
        }
    }
}
