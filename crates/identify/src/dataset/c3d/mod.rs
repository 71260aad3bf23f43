//! Reader of C3D files (motion capture): a header, parameters by group and name, and marker points frame by frame.
//!
//! The format is read without an external crate, since only a small part is needed and files may be malformed: every
//! count is checked against the file length before memory is allocated. Only marker points are read; analogue samples
//! are skipped, and labels that the dataset does not declare are ignored.

mod bytes;
mod parameters;

use std::fmt::Display;
use std::path::Path;

use self::bytes::{BLOCK, Bytes, Order};
use self::parameters::Parameters;
use super::samples;
use super::table::Table;
use super::words::{listed, shown};
use crate::input_error::InputError;

/// Greatest frame rate of a C3D file, Hz.
const FASTEST: f64 = 1e6;
/// Greatest frame number in the 16-bit header; as last frame it may stand for any greater number.
const LAST_OF_HEADER: u32 = 0xffff;

/// What was found and what was expected, in words.
type Wrong = (String, String);

fn wrong<T>(found: impl Display, expected: impl Display) -> Result<T, Wrong> {
    Err((found.to_string(), expected.to_string()))
}

pub(super) fn parse(file: &Path, bytes: &[u8], markers: &[&str]) -> Result<Table, InputError> {
    Trial::new(bytes)
        .and_then(|trial| trial.table(markers))
        .map_err(|(found, expected)| InputError::of_file(file, found, expected))
}

/// C3D file whose header, parameters and file length are consistent.
struct Trial<'a> {
    data: &'a [u8],
    order: Order,
    labels: Vec<String>,
    /// Length of the file's coordinate unit, m.
    unit: f64,
    rate: f64,
    first: u32,
    frames: usize,
    points: usize,
    frame_bytes: usize,
    storage: Storage,
}

/// Storage format of a coordinate.
#[derive(Clone, Copy)]
enum Storage {
    Float,
    /// 16-bit integer, multiplied by this scale factor to give a coordinate in the file's unit.
    Integer(f64),
}

impl<'a> Trial<'a> {
    fn new(bytes: &'a [u8]) -> Result<Self, Wrong> {
        if bytes.len() < 2 * BLOCK || bytes[1] != 0x50 {
            return wrong("no C3D header", "a C3D file, whose second byte is 0x50");
        }
        let start = usize::from(bytes[0]).wrapping_sub(1).saturating_mul(BLOCK);
        let Some(&processor) = bytes.get(start.saturating_add(3)).filter(|_| start > 0) else {
            return wrong(
                format!("the parameters in block {}", bytes[0]),
                "a block of the file after the first",
            );
        };
        let Some(order) = Order::of_processor(processor) else {
            return wrong(
                format!("the processor type {processor}"),
                "84 (Intel), 85 (DEC) or 86 (MIPS)",
            );
        };
        let header = Bytes {
            bytes: &bytes[..BLOCK],
            order,
        };
        let word = |number: usize| u32::from(header.u16(2 * (number - 1)));
        let data_start = (word(9) as usize).saturating_sub(1) * BLOCK;
        if data_start <= start || data_start > bytes.len() {
            return wrong(
                format!("the data in block {}", word(9)),
                "a block of the file after the parameters",
            );
        }
        let parameters = Parameters::read(&bytes[start..data_start], order)?;
        let (points, analog) = (word(2) as usize, word(3) as usize);
        if let Some(used) = parameters.number("POINT", "USED")?
            && used != points as f64
        {
            return wrong(
                format!("POINT:USED = {used} and {points} points in the header"),
                "one number",
            );
        }
        let storage = storage(&parameters, header.f32(12))?;
        let (first, frames) = frames(&parameters, word(4), word(5))?;
        // Each point has three coordinates and a residual.
        let width = match storage {
            Storage::Float => 4,
            Storage::Integer(_) => 2,
        };
        let frame_bytes = width * (4 * points + analog);
        let data = &bytes[data_start..];
        if points == 0
            || frame_bytes
                .checked_mul(frames)
                .is_none_or(|all| all > data.len())
        {
            return wrong(
                format!("{} bytes of data", data.len()),
                format!("{frames} frames of {points} points, {frame_bytes} bytes each"),
            );
        }
        Ok(Self {
            data,
            order,
            labels: parameters.labels(points)?,
            unit: unit(&parameters)?,
            rate: rate(&parameters, header.f32(20))?,
            first,
            frames,
            points,
            frame_bytes,
            storage,
        })
    }

    fn table(&self, markers: &[&str]) -> Result<Table, Wrong> {
        if self.frames > samples::most(markers.len()) {
            let expected = format!("at most {}", samples::most(markers.len()));
            return wrong(format!("{} frames", self.frames), expected);
        }
        let places = markers
            .iter()
            .map(|marker| self.place(marker))
            .collect::<Result<Vec<usize>, Wrong>>()?;
        let mut table = Table::default();
        for frame in 0..self.frames {
            let time = (f64::from(self.first) + frame as f64) / self.rate;
            samples::time(table.times.first(), table.times.last(), time)?;
            let start = frame * self.frame_bytes;
            let points = Bytes {
                bytes: &self.data[start..start + self.frame_bytes],
                order: self.order,
            };
            let row = places.iter().zip(markers);
            let row = row.map(|(&place, marker)| self.point(&points, place, marker, frame));
            table.positions.push(row.collect::<Result<_, Wrong>>()?);
            table.times.push(time);
        }
        Ok(table)
    }

    /// Index of a marker among the points of a frame, by its label.
    fn place(&self, marker: &str) -> Result<usize, Wrong> {
        let mut found =
            (0..self.points.min(self.labels.len())).filter(|&place| self.labels[place] == marker);
        match (found.next(), found.next()) {
            (Some(place), None) => Ok(place),
            (Some(_), Some(_)) => wrong(
                format!("two points {}", shown(marker)),
                "each declared marker once in POINT:LABELS",
            ),
            (None, _) => {
                let labels: Vec<String> = self.labels.iter().map(|label| shown(label)).collect();
                wrong(
                    format!("the labels {}", listed(labels.iter().map(String::as_str))),
                    format!("every declared marker among them, as {}", shown(marker)),
                )
            }
        }
    }

    fn point(
        &self,
        points: &Bytes<'_>,
        place: usize,
        marker: &str,
        frame: usize,
    ) -> Result<Option<[f64; 3]>, Wrong> {
        // The sign of the fourth word says whether the point was seen; its bytes are cameras and residual.
        let (raw, seen) = match self.storage {
            Storage::Float => {
                let word = |i: usize| f64::from(points.f32(16 * place + 4 * i));
                ([word(0), word(1), word(2)], word(3) >= 0.0)
            }
            Storage::Integer(scale) => {
                let word = |i: usize| f64::from(points.i16(8 * place + 2 * i));
                (
                    [word(0), word(1), word(2)].map(|x| x * scale),
                    word(3) >= 0.0,
                )
            }
        };
        if !seen || raw.iter().any(|x| x.is_nan()) {
            return Ok(None);
        }
        let position = raw.map(|x| x * self.unit);
        for (value, axis) in position.into_iter().zip(["x", "y", "z"]) {
            let number = u64::from(self.first) + frame as u64;
            let name = format_args!("{marker}_{axis} of frame {number}");
            samples::coordinate(&name, value)?;
        }
        Ok(Some(position))
    }
}

fn storage(parameters: &Parameters<'_>, in_header: f32) -> Result<Storage, Wrong> {
    let scale = agreed(
        "POINT:SCALE",
        parameters.number("POINT", "SCALE")?,
        f64::from(in_header),
        1e-5,
    )?;
    if !scale.is_finite() {
        wrong(format!("the scale {scale}"), "a finite number")
    } else if scale > 0.0 {
        Ok(Storage::Integer(scale))
    } else {
        Ok(Storage::Float)
    }
}

fn rate(parameters: &Parameters<'_>, in_header: f32) -> Result<f64, Wrong> {
    let rate = agreed(
        "POINT:RATE",
        parameters.number("POINT", "RATE")?,
        f64::from(in_header),
        1e-3,
    )?;
    if rate > 0.0 && rate <= FASTEST {
        Ok(rate)
    } else {
        wrong(
            format!("the rate {rate}"),
            format!("frames per second above 0, at most {FASTEST}"),
        )
    }
}

/// Value of a parameter or of the header. If both are given (0 in the header means absent), they must agree within
/// `within`.
fn agreed(name: &str, parameter: Option<f64>, header: f64, within: f64) -> Result<f64, Wrong> {
    let agrees = |value: f64| header == 0.0 || (value - header).abs() <= within * header.abs();
    match parameter {
        Some(value) if agrees(value) => Ok(value),
        Some(value) => wrong(
            format!("{name} = {value} and {header} in the header"),
            "one number",
        ),
        None => Ok(header),
    }
}

fn unit(parameters: &Parameters<'_>) -> Result<f64, Wrong> {
    const EXPECTED: &str = "m, cm or mm in POINT:UNITS";
    match parameters.text("POINT", "UNITS")? {
        None => wrong("no POINT:UNITS", EXPECTED),
        Some(unit) => match unit.to_ascii_lowercase().as_str() {
            "m" => Ok(1.0),
            "cm" => Ok(1e-2),
            "mm" => Ok(1e-3),
            _ => wrong(format!("the unit {}", shown(&unit)), EXPECTED),
        },
    }
}

/// Number of the first frame and number of frames; from the parameters if 16 bits in the header do not suffice.
fn frames(parameters: &Parameters<'_>, first: u32, last: u32) -> Result<(u32, usize), Wrong> {
    let start = parameters.long("TRIAL", "ACTUAL_START_FIELD")?;
    let end = parameters.long("TRIAL", "ACTUAL_END_FIELD")?;
    let (first, last) = match (start, end) {
        (Some(start), Some(end)) => (start, end),
        _ => {
            let long = match parameters.count("POINT", "LONG_FRAMES")? {
                None if last == LAST_OF_HEADER => parameters.count("POINT", "FRAMES")?,
                long => long,
            };
            let by_count = long.map(|count| (u64::from(first) + count).saturating_sub(1));
            let last = by_count.unwrap_or(u64::from(last));
            (first, u32::try_from(last).unwrap_or(u32::MAX))
        }
    };
    if last < first {
        return wrong(
            format!("the frames {first} to {last}"),
            "a last frame that is not before the first",
        );
    }
    let count = u64::from(last) - u64::from(first) + 1;
    // FRAMES may have overflowed its 16 bits as well.
    if let Some(frames) = parameters.count("POINT", "FRAMES")?
        && frames != count
        && count < u64::from(LAST_OF_HEADER)
    {
        return wrong(
            format!("POINT:FRAMES = {frames} and the frames {first} to {last}"),
            "one number of frames",
        );
    }
    match usize::try_from(count) {
        Ok(count) => Ok((first, count)),
        Err(_) => wrong(format!("{count} frames"), "fewer"),
    }
}
