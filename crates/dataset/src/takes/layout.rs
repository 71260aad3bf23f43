//! Reading of the rows of a table into a take, once the meaning of each column is known.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{Matrix3, Rotation3, UnitQuaternion};

use crate::even_times::space_evenly;
use crate::takes::{Body, Fault, Format, LengthUnit, Point, Pose, Sheet, Take, shown};
use crate::takes::{clock_time, unseen};

/// Maximum absolute value of a coordinate in a recording, m.
pub(crate) const MAX_COORDINATE: f64 = 1e4;
/// Maximum of the number of samples times the number of points and bodies, which bounds the memory used.
pub(crate) const MAX_POSITIONS: usize = 1 << 23;
/// Maximum number of points and bodies in a recording.
pub(crate) const MAX_LABELS: usize = 4096;
/// Maximum deviation from 1 of a quaternion's norm, and from 0 or 1 of the scalar products of a matrix's columns.
const ROTATION_TOLERANCE: f64 = 0.02;

/// Source of the time of each row in a table of motion-capture data.
pub(crate) enum Clock {
    /// Index of the column with the times, and their unit, s.
    Column(usize, f64),
    /// Index of the column with the frame numbers, and the frame rate, Hz.
    Frame(usize, f64),
    /// Frame rate, Hz, of a table without times and frame numbers: each row is a frame.
    Count(f64),
}

/// Indices of the table columns that contain the attitude of a body: the rotation from body to room.
pub(crate) enum Attitude {
    /// Unit quaternion w, x, y, z.
    Quaternion([usize; 4]),
    /// Rotation matrix, row by row.
    Matrix([usize; 9]),
}

/// Indices of the columns found so far for one point or body.
#[derive(Default)]
pub(crate) struct TrackColumns {
    pub position: [Option<usize>; 3],
    /// Components w, x, y, z of the attitude quaternion.
    pub quaternion: [Option<usize>; 4],
}

/// Columns of each point and body of a table, found by a key such as its label, in the order of the file.
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
    /// Columns of the point or body with the key `key`, which is added if it is new.
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
    points: Vec<(String, [usize; 3])>,
    bodies: Vec<(String, [usize; 3], Attitude)>,
    /// Number of cells in each row of the table.
    pub width: usize,
    /// Whether a position of exactly 0, 0, 0 stands for a missing measurement.
    pub zero_is_gap: bool,
    pub notes: Vec<String>,
    /// Number of data rows specified in the header of the file.
    pub stated: Option<usize>,
}

impl Layout {
    /// Layout without points and bodies.
    pub fn new(format: Format, clock: Clock, length: LengthUnit, width: usize) -> Self {
        Self {
            format,
            clock,
            length,
            points: Vec::new(),
            bodies: Vec::new(),
            width,
            zero_is_gap: false,
            notes: Vec::new(),
            stated: None,
        }
    }

    /// Adds a body or, without attitude, a point.
    pub fn add(&mut self, label: String, position: [usize; 3], attitude: Option<Attitude>) {
        match attitude {
            Some(attitude) => self.bodies.push((label, position, attitude)),
            None => self.points.push((label, position)),
        }
    }

    pub fn has_bodies(&self) -> bool {
        !self.bodies.is_empty()
    }

    pub fn is_empty(&self) -> bool {
        self.points.is_empty() && self.bodies.is_empty()
    }

    /// Reads the table from the current row to the end of the file, or to the first row for which `ends` is true.
    pub fn samples(
        self,
        sheet: &mut Sheet<'_>,
        ends: impl Fn(&Sheet<'_>) -> bool,
    ) -> Result<Take, Fault> {
        let labels = self.points.len() + self.bodies.len();
        if labels == 0 {
            return Err(sheet.line_fault("no points", "at least one tracked point"));
        }
        if labels > MAX_LABELS {
            let expected = format!("at most {MAX_LABELS}");
            return Err(sheet.line_fault(format!("{labels} points"), expected));
        }
        let points = self.points.iter().map(|(label, _)| Point {
            label: label.clone(),
            positions: Vec::new(),
        });
        let bodies = self.bodies.iter().map(|(label, ..)| Body {
            label: label.clone(),
            poses: Vec::new(),
        });
        let mut take = Take {
            format: self.format,
            times: Vec::new(),
            points: points.collect(),
            bodies: bodies.collect(),
            length: self.length,
            up: None,
            left_handed: None,
            notes: self.notes.clone(),
        };
        let (mut zeros, mut cut) = (0, None);
        let mut more = true;
        while more && !ends(sheet) {
            flight::cancellation::stop_if_cancelled();
            if !self.is_whole(sheet)? {
                cut = Some(sheet.line());
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
        let rows = take.times.len();
        if rows == 0 {
            return Err(sheet.line_fault("no rows", "at least one sample"));
        }
        let notes = [
            cut.map(|line| format!("the last row, in line {line}, is cut and was left out")),
            self.stated.filter(|&stated| stated != rows).map(|stated| {
                format!("the file states {stated} frames and holds {rows}: those were read")
            }),
            (zeros > 0)
                .then(|| format!("{zeros} positions of exactly 0, 0, 0 were read as not seen")),
        ];
        take.notes.extend(notes.into_iter().flatten());
        let unseen = unseen::leave_out(&mut take);
        take.notes.extend(unseen);
        if matches!(self.clock, Clock::Column(..))
            && let Some(unit) = space_evenly(&mut take.times)
        {
            take.notes.push(format!(
                "the times are rounded to {unit} s, and taken as those of evenly spaced frames"
            ));
        }
        unique(&mut take);
        Ok(take)
    }

    /// Whether the row has as many cells as columns; false if the last row is truncated, otherwise an error.
    fn is_whole(&self, sheet: &Sheet<'_>) -> Result<bool, Fault> {
        let (found, filled) = (sheet.width(), sheet.filled());
        let fault = |at, count| {
            let expected = format!("{} cells, as in the header", self.width);
            Err(sheet.fault(at, format!("{count} cells"), expected))
        };
        if found < self.width {
            return match sheet.is_cut() {
                true => Ok(false),
                false => fault(found, found),
            };
        }
        if filled > self.width {
            return fault(self.width, filled);
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
            Clock::Column(index, unit) => match clock_time::seconds(sheet.cell(index)) {
                Some(time) => (index, clock_time::after(time, before.last().copied())),
                None => (index, unit * sheet.needed(index, "the time of the sample")?),
            },
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
        let mut is_seen = true;
        for (value, index) in position.iter_mut().zip(axes) {
            // Qualisys may write NULL for a missing value.
            let number = match sheet.cell(index) {
                "NULL" => None,
                _ => sheet.number(index)?,
            };
            is_seen &= number.is_some();
            *value = number.unwrap_or(0.0) * self.length.metres();
            if value.abs() > MAX_COORDINATE {
                let found = format!("{} {}", sheet.cell(index), self.length);
                let expected = format!(
                    "a coordinate of {label:?} of at most {MAX_COORDINATE} m (another unit?)"
                );
                return Err(sheet.fault(index, found, expected));
            }
        }
        if is_seen && self.zero_is_gap && position == [0.0; 3] {
            *zeros += 1;
            return Ok(None);
        }
        Ok(is_seen.then_some(position))
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
                let Some(entries) = sheet.numbers(*columns)? else {
                    return Ok(None);
                };
                let matrix = Matrix3::from_row_slice(&entries);
                if !is_rotation(&matrix) {
                    let found = "a matrix that is no rotation";
                    let expected = "orthonormal columns of a right-handed frame";
                    return Err(sheet.fault(columns[0], found, expected));
                }
                let rotation = Rotation3::from_matrix_unchecked(matrix);
                let quaternion = UnitQuaternion::from_rotation_matrix(&rotation);
                let [x, y, z, w] = quaternion.coords.normalize().into();
                Ok(Some([w, x, y, z]))
            }
        }
    }
}

fn is_rotation(matrix: &Matrix3<f64>) -> bool {
    let products = matrix.tr_mul(matrix);
    let squares = [products[(0, 0)], products[(1, 1)], matrix.determinant()];
    let is_one = |value: &f64| (value - 1.0).abs() <= ROTATION_TOLERANCE;
    squares.iter().all(is_one) && products[(0, 1)].abs() <= ROTATION_TOLERANCE
}

/// Makes the labels of the points and bodies of a recording unique: a second `a` becomes `a#2`, and a note is added.
pub(crate) fn unique(take: &mut Take) {
    let mut seen = BTreeSet::new();
    let points = take.points.iter_mut().map(|point| &mut point.label);
    let bodies = take.bodies.iter_mut().map(|body| &mut body.label);
    for label in points.chain(bodies) {
        if seen.insert(label.clone()) {
            continue;
        }
        let mut numbered = (2..).map(|number| format!("{label}#{number}"));
        let other = numbered.find(|other| !seen.contains(other));
        let other = other.unwrap_or_else(|| label.clone());
        let note = format!("a second {} is called {other:?}", shown(label));
        take.notes.push(note);
        seen.insert(other.clone());
        *label = other;
    }
}
