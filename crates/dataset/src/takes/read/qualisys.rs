//! Reader of tables of Qualisys Track Manager: lines of a keyword and its values, then rows of points or of rigid
//! bodies.
//!
//! The columns of a body are position, three angles, residual, and rotation matrix column by column, from the body's
//! axes to those of the room (QTM manual, 6DOF tracking output). Lengths are in mm: the format fixes this, and the file
//! does not state it.

use std::collections::BTreeMap;

use crate::takes::error::{Fault, Location};
use crate::takes::format::{Format, QUALISYS_HEADER as HEADER};
use crate::takes::layout::{Attitude, Clock, Layout};
use crate::takes::options::ReadOptions;
use crate::takes::sheet::Sheet;
use crate::takes::take::Take;
use crate::takes::unit::LengthUnit;
use crate::takes::words::shown;

/// Number of columns per body in a Qualisys table: position (3), angles (3), residual (1), rotation matrix (9).
const BODY: usize = 16;
/// Index, within the columns of a body, of the first column of the rotation matrix.
const MATRIX: usize = 7;

pub(super) fn read(text: &str, format: Format, options: &ReadOptions) -> Result<Take, Fault> {
    let tab = text.lines().take(HEADER).any(|line| line.contains('\t'));
    let mut sheet = Sheet::new(text, if tab { b'\t' } else { b',' });
    let has_bodies = format == Format::QualisysPoses;
    let Head {
        keywords,
        titles,
        has_rows,
    } = Head::read(&mut sheet)?;
    let end = Location::Line(sheet.line());
    let (keyword, parts) = match has_bodies {
        true => ("BODY_NAMES", BODY),
        false => ("MARKER_NAMES", 3),
    };
    let Some((line, labels)) = keywords.get(keyword) else {
        return Err(Fault::new(
            end,
            format!("no line {keyword}"),
            "the labels of the tracks",
        ));
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
    let mut notes = Vec::new();
    let count = |keyword: &str| count(&keywords, keyword);
    let tracks = count(if has_bodies {
        "NO_OF_BODIES"
    } else {
        "NO_OF_MARKERS"
    })?;
    if let Some(stated) = tracks
        && stated != labels.len()
    {
        let location = Location::Line(*line);
        let found = format!("{} labels", labels.len());
        return Err(Fault::new(
            location,
            found,
            format!("{stated}, as stated above"),
        ));
    }
    let stated = frequency(&keywords)?;
    let length = options.length(Some(LengthUnit::Millimetre), end, &mut notes)?;
    if options.length.is_none() {
        notes.push("lengths are in mm, as Qualisys writes them".into());
    }
    if !has_rows {
        return Err(Fault::new(end, "no rows", "at least one sample"));
    }
    let fixed = fixed_columns(&sheet, titles.as_deref(), parts * labels.len())?;
    let start = fixed.len();
    let clock = match fixed {
        [.., Fixed::Time] => Clock::Column(start - 1, 1.0),
        [.., Fixed::Frame] => Clock::Frame(0, options.rate(stated, end, &mut notes)?),
        [] => Clock::Count(options.rate(stated, end, &mut notes)?),
    };
    let axes = |i: usize| [0, 1, 2].map(|axis| start + parts * i + axis);
    // The file contains the matrix column by column.
    let matrix =
        |i: usize| [0, 3, 6, 1, 4, 7, 2, 5, 8].map(|entry| start + parts * i + MATRIX + entry);
    let mut layout = Layout {
        format,
        clock,
        length,
        points: Vec::new(),
        bodies: Vec::new(),
        width: start + parts * labels.len(),
        zero_is_gap: true,
        notes,
        stated: count("NO_OF_FRAMES")?,
    };
    for (i, label) in labels.iter().enumerate() {
        match has_bodies {
            true => {
                let body = (label.clone(), axes(i), Attitude::Matrix(matrix(i)));
                layout.bodies.push(body);
            }
            false => layout.points.push((label.clone(), axes(i))),
        }
    }
    layout.samples(&mut sheet, |_| false)
}

/// What stands above the rows of a table.
struct Head {
    keywords: Keywords,
    /// Titles of the columns; `None` in a table without them.
    titles: Option<Vec<String>>,
    has_rows: bool,
}

/// Line number and values of each header line, by its keyword.
type Keywords = BTreeMap<String, (usize, Vec<String>)>;

impl Head {
    /// Reads a sheet up to its first row.
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
}

/// Frames per second that the header states; `None` if it states none.
fn frequency(keywords: &Keywords) -> Result<Option<f64>, Fault> {
    let Some((line, values)) = keywords.get("FREQUENCY") else {
        return Ok(None);
    };
    let text = values.first().map_or("", String::as_str);
    let rate = text.replace(',', ".").parse::<f64>();
    let fault = |_| {
        Fault::new(
            Location::Cell(*line, 2),
            shown(text),
            "the frames per second",
        )
    };
    rate.map(Some).map_err(fault)
}

/// Count in the header line that begins with `keyword`; `None` if the header has no such line. `keywords` contains line
/// number and values of each header line, keyed by its keyword.
fn count(keywords: &Keywords, keyword: &str) -> Result<Option<usize>, Fault> {
    let Some((line, values)) = keywords.get(keyword) else {
        return Ok(None);
    };
    let text = values.first().map_or("", String::as_str);
    match text.parse() {
        Ok(count) => Ok(Some(count)),
        Err(_) => Err(Fault::new(Location::Cell(*line, 2), shown(text), "a count")),
    }
}

/// Content of a column of a Qualisys table that precedes those of the first point or body.
enum Fixed {
    Frame,
    Time,
}

/// Contents, in order, of the columns of a Qualisys table that precede those of the first point or body. They are taken
/// from the column titles `titles` or, if there are none, from the number of cells in the current row; `tracks` is the
/// number of columns of all points or bodies.
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
