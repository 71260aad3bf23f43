//! Reader of C3D files (motion capture): a header, parameters by group and name, and points frame by frame.
//!
//! The format is read without an external crate, since only a small part is needed and files may be malformed: every
//! count is checked against the file length before memory is allocated. Analogue samples are skipped. Where a file
//! contradicts itself and only one reading is sensible, that reading is taken and listed as a [`Deviation`].

mod bytes;
mod floor;
mod frames;
mod parameter;
mod parameters;

use std::fmt::Display;

use self::bytes::{BLOCK, Bytes, Order};
use self::frames::{Extent, frames};
use self::parameters::Parameters;
use crate::axes::Axis;
use crate::unit::LengthUnit;
use crate::words::shown;

/// Greatest frame rate of a C3D file, Hz.
const FASTEST: f64 = 1e6;

/// A fault of a C3D file: its offset in bytes, what was found and what was expected.
#[derive(Clone, Debug, PartialEq)]
pub struct Wrong {
    /// Offset in the file, bytes.
    pub byte: usize,
    /// What was found there.
    pub found: String,
    /// What was expected instead.
    pub expected: String,
}

/// A statement that the file contradicts, and what was read instead.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    /// The contradiction.
    pub wrong: Wrong,
    /// What was read, in words.
    pub read_as: String,
}

fn wrong<T>(byte: usize, found: impl Display, expected: impl Display) -> Result<T, Wrong> {
    Err(Wrong {
        byte,
        found: found.to_string(),
        expected: expected.to_string(),
    })
}

/// C3D file whose header, parameters and file length are consistent, apart from the deviations.
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

/// Storage format of a coordinate.
#[derive(Clone, Copy)]
enum Storage {
    Float,
    /// 16-bit integer, multiplied by this scale factor to give a coordinate in the file's unit.
    Integer(f64),
}

/// Whether bytes begin as a C3D file does.
pub fn is_c3d(bytes: &[u8]) -> bool {
    // The first byte is a number of a block, which is small and no letter.
    bytes.len() >= 2 && bytes[1] == 0x50 && bytes[0] < b'\t'
}

impl<'a> Recording<'a> {
    /// Reads the header and the parameters, and holds their counts against the length of the file.
    ///
    /// # Errors
    /// [`Wrong`] where the file cannot be read, or could be read in several ways.
    pub fn open(bytes: &'a [u8]) -> Result<Self, Wrong> {
        if bytes.len() < 2 * BLOCK || bytes[1] != 0x50 {
            return wrong(1, "no C3D header", "a C3D file, whose second byte is 0x50");
        }
        let start = usize::from(bytes[0]).wrapping_sub(1).saturating_mul(BLOCK);
        let Some(&processor) = bytes.get(start.saturating_add(3)).filter(|_| start > 0) else {
            return wrong(
                0,
                format!("the parameters in block {}", bytes[0]),
                "a block of the file after the first",
            );
        };
        let Some(order) = Order::of_processor(processor) else {
            return wrong(
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
            return wrong(
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
            return wrong(
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

    /// Labels of the points, in their order in a frame; the last points may have none.
    pub fn labels(&self) -> &[String] {
        &self.labels
    }

    /// Contradictions in the file of which one reading was taken.
    pub fn deviations(&self) -> &[Deviation] {
        &self.deviations
    }

    /// Number of frames.
    pub fn frames(&self) -> usize {
        self.extent.count
    }

    /// Number of the first frame, from which the times count.
    pub fn first_frame(&self) -> u32 {
        self.extent.first
    }

    /// Number of points in a frame.
    pub fn points(&self) -> usize {
        self.points
    }

    /// Offset of a frame in the file, bytes.
    pub fn byte_of_frame(&self, frame: usize) -> usize {
        self.data_start + frame * self.frame_bytes
    }

    /// Frames per second.
    ///
    /// # Errors
    /// Where header and parameters state none, or two.
    pub fn rate(&self) -> Result<f64, Wrong> {
        let rate = agreed(
            20,
            "POINT:RATE",
            self.parameters.number("POINT", "RATE")?,
            self.header_rate,
            1e-3,
        )?;
        if rate > 0.0 && rate <= FASTEST {
            Ok(rate)
        } else {
            wrong(
                20,
                format!("the rate {rate}"),
                format!("frames per second above 0, at most {FASTEST}"),
            )
        }
    }

    /// Unit of the coordinates as `POINT:UNITS` states it, with its text.
    ///
    /// # Errors
    /// Where none, or an unknown one is stated.
    pub fn unit(&self) -> Result<(LengthUnit, String), Wrong> {
        const EXPECTED: &str = "m, cm or mm in POINT:UNITS";
        let at = self.parameters.place("POINT", "UNITS");
        match self.parameters.first_text("POINT", "UNITS")? {
            None => wrong(at, "no POINT:UNITS", EXPECTED),
            Some(text) => match LengthUnit::parse(&text) {
                Some(unit) => Ok((unit, text)),
                None => wrong(at, format!("the unit {}", shown(&text)), EXPECTED),
            },
        }
    }

    /// The axis that points up, as the corners of the force platforms in the floor state it.
    pub fn floor_up(&self) -> Option<Axis> {
        floor::up(&self.parameters.floats("FORCE_PLATFORM", "CORNERS"))
    }

    /// Text of `POINT:Y_SCREEN`, the axis that is drawn upwards.
    pub fn screen_up(&self) -> Option<String> {
        self.parameters.text("POINT", "Y_SCREEN").ok().flatten()
    }

    /// Position of a point in a frame in the file's unit; `None` where it was not seen.
    pub fn position(&self, frame: usize, place: usize) -> Option<[f64; 3]> {
        let start = frame.checked_mul(self.frame_bytes)?;
        let points = Bytes {
            bytes: self.data.get(start..start + self.frame_bytes)?,
            order: self.order,
        };
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
        (seen && !raw.iter().any(|x| x.is_nan())).then_some(raw)
    }
}

/// The deviation of parameters that reach into the data: those before the data are read, if they have what is needed.
fn after_the_cut(
    cut: Wrong,
    parameters: &Parameters<'_>,
    length: usize,
) -> Result<Deviation, Wrong> {
    let needed = ["USED", "FRAMES", "SCALE", "RATE", "LABELS", "UNITS"];
    if parameters.end_of_cut() > length || !needed.iter().all(|name| parameters.has("POINT", name))
    {
        return Err(cut);
    }
    Ok(Deviation {
        wrong: cut,
        read_as: "the parameters before it".into(),
    })
}

fn storage(
    parameters: &Parameters<'_>,
    in_header: f32,
    deviations: &mut Vec<Deviation>,
) -> Result<Storage, Wrong> {
    let stated = parameters.number("POINT", "SCALE")?;
    let in_header = f64::from(in_header);
    let scale = match agreed(12, "POINT:SCALE", stated, in_header, 1e-5) {
        // The size of a negative scale is not used: it says that the coordinates are floats.
        Err(wrong) if in_header < 0.0 && stated.is_some_and(|scale| scale < 0.0) => {
            deviations.push(Deviation {
                wrong,
                read_as: "the coordinates are floats by both, and are not scaled".into(),
            });
            in_header
        }
        scale => scale?,
    };
    if !scale.is_finite() {
        wrong(12, format!("the scale {scale}"), "a finite number")
    } else if scale > 0.0 {
        Ok(Storage::Integer(scale))
    } else {
        Ok(Storage::Float)
    }
}

/// Value of a parameter or of the header. If both are given (0 in the header means absent), they must agree within
/// `within`.
fn agreed(
    byte: usize,
    name: &str,
    parameter: Option<f64>,
    header: f64,
    within: f64,
) -> Result<f64, Wrong> {
    let agrees = |value: f64| header == 0.0 || (value - header).abs() <= within * header.abs();
    match parameter {
        Some(value) if agrees(value) => Ok(value),
        Some(value) => wrong(
            byte,
            format!("{name} = {value} and {header} in the header"),
            "one number",
        ),
        None => Ok(header),
    }
}
