//! Reader of C3D files (motion capture): a header, parameters by group and name, and points frame by frame.
//!
//! The format is read without an external crate, since only a small part is needed and files may be malformed: every
//! count is checked against the file length before memory is allocated. Analogue samples are skipped. If a file
//! contradicts itself and has only one sensible interpretation, this one is used and listed as a [`Deviation`].

mod bytes;
mod floor;
mod frames;
mod parameter;
mod parameters;

use std::fmt::Display;

use self::bytes::{BLOCK, Bytes, Order};
use self::frames::{Extent, frames};
use self::parameters::Parameters;
use crate::takes::axes::Axis;
use crate::takes::number::checked_rate;
use crate::takes::unit::LengthUnit;
use crate::takes::words::shown;

/// Error in a C3D file: its byte offset, what was found and what was expected.
#[derive(Clone, Debug, PartialEq)]
pub struct C3dError {
    /// Byte offset of the error in the file.
    pub byte: usize,
    /// Description of what was found at the byte offset of the error.
    pub found: String,
    /// Description of what was expected at the byte offset of the error.
    pub expected: String,
}

/// A contradiction in a C3D file that has only one sensible interpretation, and this interpretation.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    /// The contradiction: its byte offset, what was found and what was expected.
    pub contradiction: C3dError,
    /// Description of how the contradictory data are interpreted.
    pub read_as: String,
}

fn refuse<T>(byte: usize, found: impl Display, expected: impl Display) -> Result<T, C3dError> {
    Err(C3dError {
        byte,
        found: found.to_string(),
        expected: expected.to_string(),
    })
}

/// A C3D file whose header, parameters and length are consistent, apart from contradictions listed in
/// [`deviations`](Recording::deviations()).
pub struct Recording<'a> {
    data: &'a [u8],
    data_start: usize,
    order: Order,
    labels: Vec<String>,
    parameters: Parameters<'a>,
    header_rate: f64,
    extent: Extent,
    points: usize,
    frame_bytes: usize,
    storage: Storage,
    deviations: Vec<Deviation>,
}

/// Storage format of a coordinate: floating point or scaled integer.
#[derive(Clone, Copy)]
enum Storage {
    Float,
    /// 16-bit integer, multiplied by this scale factor to give a coordinate in the file's unit.
    Integer(f64),
}

/// Whether the bytes begin with the signature of a C3D file.
pub fn is_c3d(bytes: &[u8]) -> bool {
    // The first byte is a block number, which is small and not a letter.
    bytes.len() >= 2 && bytes[1] == 0x50 && bytes[0] < b'\t'
}

impl<'a> Recording<'a> {
    /// Reads the header and the parameters, and checks their counts against the length of the file.
    ///
    /// # Errors
    /// [`C3dError`] if the file is malformed, or contradicts itself in a way that has several sensible interpretations.
    pub fn open(bytes: &'a [u8]) -> Result<Self, C3dError> {
        if bytes.len() < 2 * BLOCK || bytes[1] != 0x50 {
            return refuse(1, "no C3D header", "a C3D file, whose second byte is 0x50");
        }
        let start = usize::from(bytes[0]).wrapping_sub(1).saturating_mul(BLOCK);
        let Some(&processor) = bytes.get(start.saturating_add(3)).filter(|_| start > 0) else {
            return refuse(
                0,
                format!("the parameters in block {}", bytes[0]),
                "a block of the file after the first",
            );
        };
        let Some(order) = Order::of_processor(processor) else {
            return refuse(
                start + 3,
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
            return refuse(
                16,
                format!("the data in block {}", word(9)),
                "a block of the file after the parameters",
            );
        }
        let section = &bytes[start..data_start];
        let (parameters, cut) = Parameters::read(section, start, order)?;
        let (points, analog) = (word(2) as usize, word(3) as usize);
        if let Some(used) = parameters.number("POINT", "USED")?
            && used != points as f64
        {
            return refuse(
                2,
                format!("POINT:USED = {used} and {points} points in the header"),
                "one number",
            );
        }
        let mut deviations = Vec::new();
        if let Some(cut) = cut {
            deviations.push(after_the_cut(cut, &parameters, bytes.len())?);
        }
        let storage = storage(&parameters, header.f32(12), &mut deviations)?;
        // Each point has three coordinates and a residual.
        let width = match storage {
            Storage::Float => 4,
            Storage::Integer(_) => 2,
        };
        let data = &bytes[data_start..];
        let layout = frames::Layout {
            width,
            points,
            analog,
            analog_per_channel: word(10) as usize,
            data_start,
            available: data.len(),
        };
        let (extent, frame_bytes) =
            frames(&parameters, word(4), word(5), &layout, &mut deviations)?;
        Ok(Self {
            data,
            data_start,
            order,
            labels: parameters.labels(points)?,
            parameters,
            header_rate: f64::from(header.f32(20)),
            extent,
            points,
            frame_bytes,
            storage,
            deviations,
        })
    }

    /// Labels of the points, in the order of the points in a frame; the last points may have no label.
    pub fn labels(&self) -> &[String] {
        &self.labels
    }

    /// Contradictions in the file that have only one sensible interpretation; the data are read with this
    /// interpretation.
    pub fn deviations(&self) -> &[Deviation] {
        &self.deviations
    }

    /// Number of frames in the file.
    pub fn frames(&self) -> usize {
        self.extent.count
    }

    /// Frame number of the first frame; the time of a frame is its frame number divided by the frame rate.
    pub fn first_frame(&self) -> u32 {
        self.extent.first
    }

    /// Number of points per frame.
    pub fn points(&self) -> usize {
        self.points
    }

    /// Byte offset of a frame in the file; `frame` counts from 0.
    pub fn byte_of_frame(&self, frame: usize) -> usize {
        self.data_start + frame * self.frame_bytes
    }

    /// Frame rate, Hz.
    ///
    /// # Errors
    /// [`C3dError`] if the header and `POINT:RATE` state different rates, or if the rate is absent or out of range.
    pub fn rate(&self) -> Result<f64, C3dError> {
        let rate = agreed(
            20,
            "POINT:RATE",
            self.parameters.number("POINT", "RATE")?,
            self.header_rate,
            1e-3,
        )?;
        checked_rate(rate).or_else(|(found, expected)| refuse(20, found, expected))
    }

    /// Unit of the coordinates specified in `POINT:UNITS`, with the text of that parameter.
    ///
    /// # Errors
    /// [`C3dError`] if the parameter is absent or contains an unknown unit.
    pub fn unit(&self) -> Result<(LengthUnit, String), C3dError> {
        const EXPECTED: &str = "m, cm or mm in POINT:UNITS";
        let at = self.parameters.offset("POINT", "UNITS");
        match self.parameters.first_text("POINT", "UNITS")? {
            None => refuse(at, "no POINT:UNITS", EXPECTED),
            Some(text) => match LengthUnit::parse(&text) {
                Some(unit) => Ok((unit, text)),
                None => refuse(at, format!("the unit {}", shown(&text)), EXPECTED),
            },
        }
    }

    /// Axis that points up, derived from the corners of the force platforms in the floor; `None` if they do not
    /// determine it.
    pub fn floor_up(&self) -> Option<Axis> {
        floor::up(&self.parameters.floats("FORCE_PLATFORM", "CORNERS"))
    }

    /// Text of `POINT:Y_SCREEN`, the axis that is drawn upwards; `None` if the parameter is absent or not a text.
    pub fn screen_up(&self) -> Option<String> {
        self.parameters.text("POINT", "Y_SCREEN").ok().flatten()
    }

    /// Position of the point with index `point` in a frame, in the file's unit; `None` if the point was not seen.
    pub fn position(&self, frame: usize, point: usize) -> Option<[f64; 3]> {
        let start = frame.checked_mul(self.frame_bytes)?;
        let points = Bytes {
            bytes: self.data.get(start..start + self.frame_bytes)?,
            order: self.order,
        };
        // The sign of the fourth word states whether the point was seen; its bytes encode the cameras and the residual.
        let (raw, seen) = match self.storage {
            Storage::Float => {
                let word = |i: usize| f64::from(points.f32(16 * point + 4 * i));
                ([word(0), word(1), word(2)], word(3) >= 0.0)
            }
            Storage::Integer(scale) => {
                let word = |i: usize| f64::from(points.i16(8 * point + 2 * i));
                (
                    [word(0), word(1), word(2)].map(|x| x * scale),
                    word(3) >= 0.0,
                )
            }
        };
        (seen && !raw.iter().any(|x| x.is_nan())).then_some(raw)
    }
}

/// Decides how to proceed after the error `cut`, which reports that a parameter extends past the parameter section. If
/// the preceding parameters suffice and the extending one ends within the file of `length` bytes, the result is a
/// [`Deviation`] by which only the preceding parameters are used. Otherwise the result is the error `cut`.
fn after_the_cut(
    cut: C3dError,
    parameters: &Parameters<'_>,
    length: usize,
) -> Result<Deviation, C3dError> {
    let needed = ["USED", "FRAMES", "SCALE", "RATE", "LABELS", "UNITS"];
    if parameters.end_of_cut() > length || !needed.iter().all(|name| parameters.has("POINT", name))
    {
        return Err(cut);
    }
    Ok(Deviation {
        contradiction: cut,
        read_as: "the parameters before it".into(),
    })
}

fn storage(
    parameters: &Parameters<'_>,
    in_header: f32,
    deviations: &mut Vec<Deviation>,
) -> Result<Storage, C3dError> {
    let stated = parameters.number("POINT", "SCALE")?;
    let in_header = f64::from(in_header);
    let scale = match agreed(12, "POINT:SCALE", stated, in_header, 1e-5) {
        // The magnitude of a negative scale is unused: the sign only states that the coordinates are floats.
        Err(contradiction) if in_header < 0.0 && stated.is_some_and(|scale| scale < 0.0) => {
            deviations.push(Deviation {
                contradiction,
                read_as: "the coordinates are floats by both, and are not scaled".into(),
            });
            in_header
        }
        scale => scale?,
    };
    if !scale.is_finite() {
        refuse(12, format!("the scale {scale}"), "a finite number")
    } else if scale > 0.0 {
        Ok(Storage::Integer(scale))
    } else {
        Ok(Storage::Float)
    }
}

/// Value specified in the parameter `name`, in the header, or in both (0 in the header means absent); 0 if neither
/// specifies it. If both specify it, they must agree within the relative tolerance `within`; otherwise the result is an
/// error at the offset `byte`.
fn agreed(
    byte: usize,
    name: &str,
    parameter: Option<f64>,
    header: f64,
    within: f64,
) -> Result<f64, C3dError> {
    let agrees = |value: f64| header == 0.0 || (value - header).abs() <= within * header.abs();
    match parameter {
        Some(value) if agrees(value) => Ok(value),
        Some(value) => refuse(
            byte,
            format!("{name} = {value} and {header} in the header"),
            "one number",
        ),
        None => Ok(header),
    }
}
