//! Reading of the rows of a table into a take, once the meaning of each column is known.

use std::collections::BTreeMap;

use crate::takes::error::{Fault, Location};
use crate::takes::format::Format;
use crate::takes::sheet::Sheet;
use crate::takes::take::{Body, Point, Pose, Take};
use crate::takes::unit::LengthUnit;

/// Maximum absolute value of a coordinate in a recording, m; a greater one is an error.
pub(crate) const MAX_COORDINATE: f64 = 1e4;
/// Maximum of the number of samples times the number of points and bodies; a larger recording is an error, which bounds
/// the memory used.
pub(crate) const MAX_POSITIONS: usize = 1 << 23;
/// Maximum number of points and bodies in a recording; a greater number is an error.
pub(crate) const MAX_LABELS: usize = 4096;
/// Maximum deviation of a quaternion's norm from 1. For a rotation matrix, maximum deviation of the scalar products of
/// its columns from 1 (column with itself) and 0.
const ROTATION_TOLERANCE: f64 = 0.02;

/// Source of the time of each row in a table of motion-capture data.
pub(crate) enum Clock {
    /// The times are in the column with this index; the second value is the length of their unit, s.
    Column(usize, f64),
    /// The frame numbers are in the column with this index; the second value is the number of frames per second.
    Frame(usize, f64),
    /// The table has neither times nor frame numbers: the time of a row is its index, from 0, divided by this frame
    /// rate, Hz.
    Count(f64),
}

/// Indices of the table columns that contain the attitude of a body.
pub(crate) enum Attitude {
    /// Indices of the columns with the unit quaternion w, x, y, z of the rotation from body to room.
    Quaternion([usize; 4]),
    /// Indices of the columns with the elements of the rotation matrix from body to room, row by row.
    Matrix([usize; 9]),
}

/// Indices of the table columns with the coordinates and the quaternion of one point or body; `None` for those that
/// were not found.
#[derive(Default)]
pub(crate) struct TrackColumns {
    pub position: [Option<usize>; 3],
    /// Indices of the columns with the components w, x, y, z of the attitude quaternion, in this order; `None` for a
    /// component without a column.
    pub quaternion: [Option<usize>; 4],
}

/// Columns of each point and body of a table of motion-capture data, found by a key such as its label, in the order of
/// the file.
pub(crate) struct Tracks<K> {
    pub list: Vec<(K, TrackColumns)>,
    indices: BTreeMap<K, usize>,
}

impl<K> Default for Tracks<K> {
    fn default() -> Self {
        Self {
            list: Vec::new(),
            indices: BTreeMap::new(),
        }
    }
}

impl<K: Ord + Clone> Tracks<K> {
    /// Columns of the point or body with the key `key`. If the key is new, an entry without columns is added.
    pub fn entry(&mut self, key: K) -> &mut TrackColumns {
        let list = &mut self.list;
        let index = *self.indices.entry(key).or_insert_with_key(|key| {
            list.push((key.clone(), TrackColumns::default()));
            list.len() - 1
        });
        &mut list[index].1
    }
}

/// Columns of a table of motion-capture data, and how their values are read.
pub(crate) struct Layout {
    pub format: Format,
    pub clock: Clock,
    pub length: LengthUnit,
    pub points: Vec<(String, [usize; 3])>,
    pub bodies: Vec<(String, [usize; 3], Attitude)>,
    /// Number of cells in each row of the table.
    pub width: usize,
    /// Whether a position of exactly 0, 0, 0 stands for a missing measurement.
    pub zero_is_gap: bool,
    pub notes: Vec<String>,
    /// Number of data rows specified in the header of the file; `None` if none is specified.
    pub stated: Option<usize>,
}

impl Layout {
    /// Reads the rows of the table into a recording, from the current row to the end of the file or to the first row
    /// for which `ends` returns true.
    pub fn samples(
        self,
        sheet: &mut Sheet<'_>,
        ends: impl Fn(&Sheet<'_>) -> bool,
    ) -> Result<Take, Fault> {
        let labels = self.points.len() + self.bodies.len();
        let location = Location::Line(sheet.line());
        if labels == 0 {
            return Err(Fault::new(
                location,
                "no points",
                "at least one tracked point",
            ));
        }
        if labels > MAX_LABELS {
            let expected = format!("at most {MAX_LABELS}");
            return Err(Fault::new(location, format!("{labels} points"), expected));
        }
        let point = |(label, _): &(String, [usize; 3])| Point {
            label: label.clone(),
            positions: Vec::new(),
        };
        let body = |(label, ..): &(String, [usize; 3], Attitude)| Body {
            label: label.clone(),
            poses: Vec::new(),
        };
        let mut take = Take {
            format: self.format,
            times: Vec::new(),
            points: self.points.iter().map(point).collect(),
            bodies: self.bodies.iter().map(body).collect(),
            length: self.length,
            up: None,
            left_handed: None,
            notes: Vec::new(),
        };
        let mut zeros = 0;
        let mut more = true;
        while more && !ends(sheet) {
            if !self.is_whole(sheet, &mut take.notes)? {
                break;
            }
            if take.times.len() >= MAX_POSITIONS / labels {
                let expected = format!("at most {} rows", MAX_POSITIONS / labels);
                return Err(sheet.fault(0, "a row more", expected));
            }
            self.row(sheet, &mut take, &mut zeros)?;
            // If the time is counted in rows, a row without any position counts too.
            more = match self.clock {
                Clock::Count(_) => sheet.advance_line()?,
                _ => sheet.advance()?,
            };
        }
        self.finish(take, zeros, sheet)
    }

    fn finish(self, mut take: Take, zeros: usize, sheet: &Sheet<'_>) -> Result<Take, Fault> {
        let rows = take.times.len();
        if rows == 0 {
            let location = Location::Line(sheet.line());
            return Err(Fault::new(location, "no rows", "at least one sample"));
        }
        if let Some(stated) = self.stated
            && stated != rows
        {
            take.notes.push(format!(
                "the file states {stated} frames and holds {rows}: those were read"
            ));
        }
        if zeros > 0 {
            take.notes.push(format!(
                "{zeros} positions of exactly 0, 0, 0 were read as not seen"
            ));
        }
        let mut notes = self.notes;
        notes.append(&mut take.notes);
        take.notes = notes;
        unique(&mut take);
        Ok(take)
    }

    /// Whether the current row has at least as many cells as the table has columns. Returns false and adds a note if
    /// the last row of the file is truncated; any other wrong number of cells is an error.
    fn is_whole(&self, sheet: &Sheet<'_>, notes: &mut Vec<String>) -> Result<bool, Fault> {
        let (found, filled) = (sheet.width(), sheet.filled());
        if found < self.width {
            if sheet.is_cut() {
                notes.push(format!(
                    "the last row, in line {}, is cut and was left out",
                    sheet.line()
                ));
                return Ok(false);
            }
            let expected = format!("{} cells, as in the header", self.width);
            return Err(sheet.fault(found, format!("{found} cells"), expected));
        }
        if filled > self.width {
            let expected = format!("{} cells, as in the header", self.width);
            return Err(sheet.fault(self.width, format!("{filled} cells"), expected));
        }
        Ok(true)
    }

    fn row(&self, sheet: &Sheet<'_>, take: &mut Take, zeros: &mut usize) -> Result<(), Fault> {
        take.times.push(self.time(sheet, &take.times)?);
        for ((label, axes), point) in self.points.iter().zip(&mut take.points) {
            let position = self.position(sheet, label, *axes, zeros)?;
            point.positions.push(position);
        }
        for ((label, axes, attitude), body) in self.bodies.iter().zip(&mut take.bodies) {
            let pose = match self.position(sheet, label, *axes, zeros)? {
                None => None,
                Some(position) => attitude.quaternion(sheet)?.map(|quaternion| Pose {
                    position,
                    quaternion,
                }),
            };
            body.poses.push(pose);
        }
        Ok(())
    }

    fn time(&self, sheet: &Sheet<'_>, before: &[f64]) -> Result<f64, Fault> {
        let (cell, time) = match self.clock {
            Clock::Count(rate) => (0, before.len() as f64 / rate),
            Clock::Column(index, unit) => {
                let time = sheet.needed(index, "the time of the sample")?;
                (index, time * unit)
            }
            Clock::Frame(index, rate) => {
                let frame = sheet.needed(index, "the number of the frame")?;
                if frame.fract() != 0.0 || !(0.0..=1e9).contains(&frame) {
                    let found = format!("the frame {frame}");
                    return Err(sheet.fault(index, found, "a whole number, not negative"));
                }
                (index, frame / rate)
            }
        };
        match before.last() {
            Some(&last) if time <= last => {
                let found = format!("the time {time} s");
                Err(sheet.fault(cell, found, format!("a time after {last} s")))
            }
            _ => Ok(time),
        }
    }

    fn position(
        &self,
        sheet: &Sheet<'_>,
        label: &str,
        axes: [usize; 3],
        zeros: &mut usize,
    ) -> Result<Option<[f64; 3]>, Fault> {
        let mut position = [0.0; 3];
        let mut seen = true;
        for (value, index) in position.iter_mut().zip(axes) {
            // Qualisys may write NULL for a missing value.
            match sheet.cell(index) {
                "NULL" => seen = false,
                _ => match sheet.number(index)? {
                    Some(number) => *value = number * self.length.metres(),
                    None => seen = false,
                },
            }
            if value.abs() > MAX_COORDINATE {
                let found = format!("{} {}", sheet.cell(index), self.length);
                let expected = format!(
                    "a coordinate of {label:?} of at most {MAX_COORDINATE} m (another unit?)"
                );
                return Err(sheet.fault(index, found, expected));
            }
        }
        if seen && self.zero_is_gap && position == [0.0; 3] {
            *zeros += 1;
            return Ok(None);
        }
        Ok(seen.then_some(position))
    }
}

impl Attitude {
    /// Unit quaternion of the attitude in the current row of the table; `None` if a component is missing.
    fn quaternion(&self, sheet: &Sheet<'_>) -> Result<Option<[f64; 4]>, Fault> {
        match self {
            Self::Quaternion(columns) => {
                let Some(q) = sheet.numbers(*columns)? else {
                    return Ok(None);
                };
                let norm = q.iter().map(|x| x * x).sum::<f64>().sqrt();
                if (norm - 1.0).abs() > ROTATION_TOLERANCE {
                    let found = format!("a quaternion of norm {norm:.4}");
                    return Err(sheet.fault(columns[0], found, "a norm of 1"));
                }
                Ok(Some(q.map(|x| x / norm)))
            }
            Self::Matrix(columns) => {
                let Some(m) = sheet.numbers(*columns)? else {
                    return Ok(None);
                };
                if !is_rotation(&m) {
                    let found = "a matrix that is no rotation";
                    let expected = "orthonormal columns of a right-handed frame";
                    return Err(sheet.fault(columns[0], found, expected));
                }
                Ok(Some(of_matrix(&m)))
            }
        }
    }
}

fn is_rotation(m: &[f64; 9]) -> bool {
    let column = |i: usize| [m[i], m[i + 3], m[i + 6]];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let (a, b, c) = (column(0), column(1), column(2));
    let near = |value: f64, wanted: f64| (value - wanted).abs() <= ROTATION_TOLERANCE;
    let cross = [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ];
    near(dot(a, a), 1.0) && near(dot(b, b), 1.0) && near(dot(a, b), 0.0) && near(dot(cross, c), 1.0)
}

/// Converts a rotation matrix, given row by row, to a unit quaternion w, x, y, z by way of the quaternion's largest
/// component.
fn of_matrix(m: &[f64; 9]) -> [f64; 4] {
    let squares = [
        1.0 + m[0] + m[4] + m[8],
        1.0 + m[0] - m[4] - m[8],
        1.0 - m[0] + m[4] - m[8],
        1.0 - m[0] - m[4] + m[8],
    ];
    let largest = (0..4).fold(
        0,
        |best, i| if squares[i] > squares[best] { i } else { best },
    );
    let (xy, xz, yz) = (m[1] + m[3], m[2] + m[6], m[5] + m[7]);
    let (wx, wy, wz) = (m[7] - m[5], m[2] - m[6], m[3] - m[1]);
    let q = match largest {
        0 => [squares[0], wx, wy, wz],
        1 => [wx, squares[1], xy, xz],
        2 => [wy, xy, squares[2], yz],
        _ => [wz, xz, yz, squares[3]],
    };
    let norm = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    q.map(|x| x / norm)
}

/// Makes the labels of the points and bodies of a recording unique: a second `a` becomes `a#2`, and a note is added.
pub(crate) fn unique(take: &mut Take) {
    let mut seen = std::collections::BTreeSet::new();
    let points = take.points.iter_mut().map(|point| &mut point.label);
    let bodies = take.bodies.iter_mut().map(|body| &mut body.label);
    for label in points.chain(bodies) {
        if seen.insert(label.clone()) {
            continue;
        }
        let mut number = 2;
        while seen.contains(&format!("{label}#{number}")) {
            number += 1;
        }
        let other = format!("{label}#{number}");
        take.notes.push(format!(
            "a second {} is called {other:?}",
            crate::takes::words::shown(label)
        ));
        seen.insert(other.clone());
        *label = other;
    }
}
