//! The table of one flight: `t,m1_x,m1_y,m1_z,…` with comma, semicolon or tab.

use std::path::Path;

use crate::error::{InputError, utf8};

/// Largest table that is read, bytes.
const LARGEST: u64 = 1 << 30;

#[derive(Debug)]
pub(super) struct Table {
    pub times: Vec<f64>,
    pub positions: Vec<Vec<Option<[f64; 3]>>>,
}

pub(super) fn read(file: &Path, markers: &[&str]) -> Result<Table, InputError> {
    let unreadable =
        |error: std::io::Error| InputError::of_file(file, error.to_string(), "a readable table");
    let size = std::fs::metadata(file).map_err(unreadable)?.len();
    if size > LARGEST {
        return Err(InputError::of_file(
            file,
            format!("{size} bytes"),
            format!("a table of at most {LARGEST} bytes"),
        ));
    }
    let bytes = std::fs::read(file).map_err(unreadable)?;
    parse(file, utf8(file, &bytes)?, markers)
}

/// Where the columns of each marker are.
struct Header {
    separator: char,
    width: usize,
    time: usize,
    columns: Vec<[usize; 3]>,
}

fn parse(file: &Path, text: &str, markers: &[&str]) -> Result<Table, InputError> {
    let mut lines = text
        .lines()
        .enumerate()
        .map(|(index, line)| (index + 1, line.trim_end_matches('\r')))
        .filter(|(_, line)| !line.trim().is_empty() && !line.trim_start().starts_with('#'));
    let Some((first, line)) = lines.next() else {
        return Err(InputError::of_file(
            file,
            "no header",
            format!("a header such as t,{}_x,…", markers[0]),
        ));
    };
    let header = header(file, first, line, markers)?;
    let mut table = Table {
        times: Vec::new(),
        positions: Vec::new(),
    };
    for (number, line) in lines {
        row(file, number, line, &header, markers, &mut table)?;
    }
    if table.times.is_empty() {
        return Err(InputError::of_file(
            file,
            "a header and no rows",
            "at least one sample",
        ));
    }
    Ok(table)
}

fn header(file: &Path, number: usize, line: &str, markers: &[&str]) -> Result<Header, InputError> {
    let separator = [';', '\t', ',']
        .into_iter()
        .find(|&c| line.contains(c))
        .unwrap_or(',');
    let names: Vec<&str> = line.split(separator).map(str::trim).collect();
    let mut time = None;
    let mut columns = vec![[usize::MAX; 3]; markers.len()];
    for (index, &name) in names.iter().enumerate() {
        let refuse = |found: String, expected: &str| {
            Err(InputError::at(
                file,
                (number, column(line, separator, index)),
                found,
                expected,
            ))
        };
        let slot = if name == "t" {
            time.replace(index).map(|_| ())
        } else {
            let Some((marker, axis)) = split(name, markers) else {
                let expected = format!(
                    "t or a declared marker's column ({}_x, …)",
                    markers.join("_x, ")
                );
                return refuse(format!("the column {name:?}"), &expected);
            };
            let slot = &mut columns[marker][axis];
            let before = *slot;
            *slot = index;
            (before != usize::MAX).then_some(())
        };
        if slot.is_some() {
            return refuse(format!("a second column {name:?}"), "each column once");
        }
    }
    let Some(time) = time else {
        return Err(InputError::at(
            file,
            (number, 1),
            "no column t",
            "the time of each row, s, in a column t",
        ));
    };
    for (marker, axes) in markers.iter().zip(&columns) {
        if let Some(axis) = axes.iter().position(|&index| index == usize::MAX) {
            let name = format!("{marker}_{}", ["x", "y", "z"][axis]);
            return Err(InputError::at(
                file,
                (number, 1),
                format!("no column {name}"),
                "x, y and z of every marker",
            ));
        }
    }
    Ok(Header {
        separator,
        width: names.len(),
        time,
        columns,
    })
}

fn split(name: &str, markers: &[&str]) -> Option<(usize, usize)> {
    let (marker, axis) = name.rsplit_once('_')?;
    let axis = ["x", "y", "z"].iter().position(|&known| known == axis)?;
    Some((markers.iter().position(|&known| known == marker)?, axis))
}

/// Column (from 1, in characters) where cell `index` begins.
fn column(line: &str, separator: char, index: usize) -> usize {
    line.split(separator)
        .take(index)
        .map(|cell| cell.chars().count() + 1)
        .sum::<usize>()
        + 1
}

fn row(
    file: &Path,
    number: usize,
    line: &str,
    header: &Header,
    markers: &[&str],
    table: &mut Table,
) -> Result<(), InputError> {
    let cells: Vec<&str> = line.split(header.separator).map(str::trim).collect();
    if cells.len() != header.width {
        let expected = format!("{} as in the header", header.width);
        return Err(InputError::at(
            file,
            (number, 1),
            format!("{} cells", cells.len()),
            expected,
        ));
    }
    let place = |index| (number, column(line, header.separator, index));
    let read = |index: usize| -> Result<Option<f64>, InputError> {
        match cells[index] {
            "" => Ok(None),
            cell => match cell.parse::<f64>() {
                Ok(value) if value.is_nan() => Ok(None),
                Ok(value) if value.is_finite() => Ok(Some(value)),
                _ => Err(InputError::at(
                    file,
                    place(index),
                    format!("{cell:?}"),
                    "a finite number, or nothing for a dropout",
                )),
            },
        }
    };
    let Some(time) = read(header.time)? else {
        return Err(InputError::at(
            file,
            place(header.time),
            "no time",
            "the time of the sample, s",
        ));
    };
    if let Some(&before) = table.times.last()
        && time <= before
    {
        let expected = format!("a time after {before} s");
        return Err(InputError::at(
            file,
            place(header.time),
            format!("t = {time}"),
            expected,
        ));
    }
    let mut positions = Vec::with_capacity(markers.len());
    for axes in &header.columns {
        let [x, y, z] = [read(axes[0])?, read(axes[1])?, read(axes[2])?];
        // A marker with a coordinate missing was not seen: two coordinates alone are no point.
        positions.push(match (x, y, z) {
            (Some(x), Some(y), Some(z)) => Some([x, y, z]),
            _ => None,
        });
    }
    table.times.push(time);
    table.positions.push(positions);
    Ok(())
}
