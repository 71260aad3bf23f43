//! Headers of two or three lines: names over units, or names of points over axes, as motion-capture programs write them.

use std::borrow::Cow;
use std::ops::Range;

use crate::takes::columns::{Column, Quantity, without_unit};
use crate::takes::unit::LengthUnit;
use crate::takes::{clock_time, separator};

/// Maximum number of lines below the first one that belong to a header: axes and units.
const MAX_LINES: usize = 2;

/// The text with one header line in place of lines that name points, axes and units below each other. Every row of data
/// stays in its line.
pub(super) fn joined(mut text: Cow<'_, str>) -> Cow<'_, str> {
    for _ in 0..MAX_LINES {
        let Some((lines, header)) = join(&text) else {
            break;
        };
        // An empty line takes the place of the first one.
        text.to_mut().replace_range(lines, &format!("\n{header}"));
    }
    text
}

/// Range of the first two lines, and the header that they are together; `None` if they are no such header.
fn join(text: &str) -> Option<(Range<usize>, String)> {
    let mark = separator(text);
    let mut start = 0;
    let lines = text.split_inclusive('\n').map(|line| {
        let own = start..start + line.trim_end_matches(['\n', '\r']).len();
        start += line.len();
        own
    });
    let is_filled = |line: &Range<usize>| {
        let line = text[line.clone()].trim();
        !line.trim_matches(mark).is_empty() && !line.starts_with('#')
    };
    let mut lines = lines.filter(is_filled);
    let (first, second, third) = (lines.next()?, lines.next()?, lines.next()?);
    let cells = |line: &Range<usize>| -> Vec<&str> {
        let cells = text[line.clone()].split(mark);
        cells.map(|cell| cell.trim().trim_matches('"')).collect()
    };
    let (names, below) = (cells(&first), cells(&second));
    let is_number =
        |cell: &&str| cell.parse::<f64>().is_ok() || clock_time::seconds(cell).is_some();
    if names.iter().chain(&below).any(is_number) || below.len() > names.len() {
        return None;
    }
    let below: Vec<&str> = (0..names.len())
        .map(|k| below.get(k).copied().unwrap_or(""))
        .collect();
    // A third line of a header has units.
    let next = cells(&third);
    let joined = match are_units(&below) {
        true if next.iter().any(is_number) => with_units(&names, &below),
        false if are_axes(&below) => with_axes(&names, &below),
        _ => return None,
    };
    Some((first.start..second.end, joined.join(&mark.to_string())))
}

/// Unit in a cell, without brackets.
fn unit(cell: &str) -> &str {
    let bare = cell.trim_start_matches(['(', '[']);
    bare.trim_end_matches([')', ']']).trim()
}

fn are_units(cells: &[&str]) -> bool {
    let is_axis = |cell: &&str| Column::parse(cell).quantity != Quantity::Other;
    cells
        .iter()
        .any(|cell| LengthUnit::is_whole_name(unit(cell)))
        && !cells.iter().any(is_axis)
}

fn with_units(names: &[&str], units: &[&str]) -> Vec<String> {
    let pairs = names.iter().zip(units);
    let each = pairs.map(|(name, cell)| match (unit(cell), without_unit(name).1) {
        ("" | "-", _) | (_, Some(_)) => (*name).to_owned(),
        (unit, None) => format!("{name} [{unit}]"),
    });
    each.collect()
}

/// Whether cells name at least the three axes of a point, and nothing but axes, times and units.
fn are_axes(cells: &[&str]) -> bool {
    let columns = cells.iter().map(|cell| (cell, Column::parse(cell)));
    let mut axes = 0;
    for (cell, column) in columns {
        match column.quantity {
            Quantity::Coordinate(..) if column.label.is_empty() => axes += 1,
            Quantity::Quaternion(_) if column.label.is_empty() => {}
            Quantity::Time(_) | Quantity::Frame => {}
            _ if cell.is_empty() || cell.starts_with(['(', '[']) => {}
            _ => return false,
        }
    }
    axes >= 3
}

/// Names of axes with the names of their points, each of which stands above its first axis or above all.
fn with_axes(names: &[&str], axes: &[&str]) -> Vec<String> {
    let mut point = "";
    let pairs = names.iter().zip(axes);
    let each = pairs.map(|(name, axis)| match Column::parse(axis).quantity {
        Quantity::Coordinate(..) | Quantity::Quaternion(_) => {
            if !name.is_empty() {
                point = name;
            }
            format!("{point}_{axis}")
        }
        Quantity::Time(_) | Quantity::Frame => (*axis).to_owned(),
        Quantity::Other => format!("{name} {axis}").trim().to_owned(),
    });
    each.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_of_a_header_are_joined_and_rows_stay_in_their_lines() {
        let of = |text: &str| joined(text.into()).into_owned();
        assert_eq!(
            of("t,m1_x,m1_y,m1_z\ns,mm,mm,mm\n0,1,2,3\n"),
            "\nt [s],m1_x [mm],m1_y [mm],m1_z [mm]\n0,1,2,3\n"
        );
        assert_eq!(
            of("\"\",m1,,,m2,,\r\nTime (s),X,Y,Z,X,Y,Z\r\n0,1,2,3,4,5,6\r\n"),
            "\nTime (s),m1_X,m1_Y,m1_Z,m2_X,m2_Y,m2_Z\r\n0,1,2,3,4,5,6\r\n"
        );
        assert_eq!(
            of("time;disc;disc;disc\n;x;y;z\n[s];[mm];[mm];[mm]\n0;1;2;3\n"),
            "\n\ntime [s];disc_x [mm];disc_y [mm];disc_z [mm]\n0;1;2;3\n"
        );
    }

    #[test]
    fn other_tables_stay() {
        for text in [
            "t,x,y,z\n0,1,2,3\n1,1,2,3\n",
            "t,x,y,z\nNA,NA,NA,NA\n0,1,2,3\n",
            "Trajectories\n100\n,m1,,\nFrame,X,Y,Z\n1,1,2,3\n",
            "t,x,y,z\ns,mm,mm,mm\n",
            "",
        ] {
            assert_eq!(joined(text.into()), text);
        }
    }
}
