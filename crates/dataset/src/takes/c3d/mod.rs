//! Reader of C3D files (motion capture): a header, parameters by group and name, and points frame by frame.
//!
//! The format is read without an external crate, since only a small part is needed and files may be malformed: every
//! count is checked against the file length before memory is allocated. Analogue samples are skipped. If a file
//! contradicts itself and has only one sensible interpretation, this one is used and listed as a [`Deviation`].

mod bytes;
mod floor;
mod frames;
mod parameters;

use self::bytes::{BLOCK, Bytes, Order};
use self::frames::{Frames, frames};
use self::parameters::Parameters;
use crate::takes::{Axis, Fault, LengthUnit, Location, checked_rate, shown};

/// A contradiction in a C3D file that has only one sensible interpretation, and this interpretation.
pub(crate) struct Deviation {
    pub contradiction: Fault,
    pub read_as: String,
}

fn fault(byte: usize, found: impl Into<String>, expected: impl Into<String>) -> Fault {
    Fault::new(Location::Byte(byte), found, expected)
}

fn refuse<T>(
    byte: usize,
    found: impl Into<String>,
    expected: impl Into<String>,
) -> Result<T, Fault> {
    Err(fault(byte, found, expected))
}

/// A C3D file whose header, parameters and length are consistent, apart from [`deviations`](Self::deviations).
pub(crate) struct Recording<'a> {
    data: Bytes<'a>,
    data_start: usize,
    /// Labels of the points, in the order of the points in a frame; the last points may have no label.
    pub labels: Vec<String>,
    parameters: Parameters<'a>,
    header_rate: f64,
    frames: Frames,
    pub points: usize,
    storage: Storage,
    /// Contradictions with only one sensible interpretation, by which the data are read.
    pub deviations: Vec<Deviation>,
}

#[derive(Clone, Copy)]
enum Storage {
    Float,
    /// 16-bit integer, multiplied by this scale factor to give a coordinate in the file's unit.
    Integer(f64),
}

pub(crate) fn is_c3d(bytes: &[u8]) -> bool {
    // The first byte is a block number, which is small and not a letter.
    bytes.len() >= 2 && bytes[1] == 0x50 && bytes[0] < b'\t'
}

impl<'a> Recording<'a> {
    /// Reads the header and the parameters, and checks their counts against the length of the file. An error if the
    /// file is malformed, or contradicts itself in a way that has several sensible interpretations.
    pub fn open(bytes: &'a [u8]) -> Result<Self, Fault> {
        if bytes.len() < 2 * BLOCK || bytes[1] != 0x50 {
            return refuse(
                1,
                "no C3D header",
                "a C3D file: 1024 bytes or more, the second of which is 0x50",
            );
        }
        let start = usize::from(bytes[0]).wrapping_sub(1).saturating_mul(BLOCK);
        let Some(&processor) = bytes.get(start.saturating_add(3)).filter(|_| start > 0) else {
            let found = format!("the parameters in block {}", bytes[0]);
            return refuse(0, found, "a block of the file after the first");
        };
        let Some(order) = Order::of_processor(processor) else {
            let found = format!("the processor type {processor}");
            return refuse(start + 3, found, "84 (Intel), 85 (DEC) or 86 (MIPS)");
        };
        let header = Bytes {
            bytes: &bytes[..BLOCK],
            order,
        };
        let word = |number: usize| u32::from(header.u16(2 * (number - 1)));
        let data_start = (word(9) as usize).saturating_sub(1) * BLOCK;
        if data_start <= start || data_start > bytes.len() {
            let found = format!("the data in block {}", word(9));
            return refuse(16, found, "a block of the file after the parameters");
        }
        let mut parameters = Parameters::read(&bytes[start..data_start], start, order)?;
        let (points, analog) = (word(2) as usize, word(3) as usize);
        if let Some(used) = parameters.number("POINT", "USED")?
            && used != points as f64
        {
            let found = format!("POINT:USED = {used} and {points} points in the header");
            return refuse(2, found, "one number");
        }
        let mut deviations = Vec::new();
        if let Some((contradiction, end)) = parameters.cut.take() {
            // The parameters before it must suffice, and the file must contain all of it.
            let needed = ["USED", "FRAMES", "SCALE", "RATE", "LABELS", "UNITS"];
            if end > bytes.len() || !needed.iter().all(|name| parameters.has("POINT", name)) {
                return Err(contradiction);
            }
            deviations.push(Deviation {
                contradiction,
                read_as: "the parameters before it".into(),
            });
        }
        let storage = storage(&parameters, header.f32(12), &mut deviations)?;
        let layout = frames::Layout {
            width: match storage {
                Storage::Float => 4,
                Storage::Integer(_) => 2,
            },
            points,
            analog,
            analog_per_channel: word(10) as usize,
            data_start,
            available: bytes.len() - data_start,
        };
        let frames = frames(&parameters, (word(4), word(5)), &layout, &mut deviations)?;
        Ok(Self {
            data: Bytes {
                bytes: &bytes[data_start..],
                order,
            },
            data_start,
            labels: parameters.labels(points)?,
            parameters,
            header_rate: f64::from(header.f32(20)),
            frames,
            points,
            storage,
            deviations,
        })
    }

    /// Number of frames in the file.
    pub fn frames(&self) -> usize {
        self.frames.count
    }

    /// Frame number of the first frame; the time of a frame is its frame number divided by the frame rate.
    pub fn first_frame(&self) -> u32 {
        self.frames.first
    }

    /// Byte offset of a frame in the file; `frame` counts from 0.
    pub fn byte_of_frame(&self, frame: usize) -> usize {
        self.data_start + frame * self.frames.bytes
    }

    /// Frame rate, Hz; an error if it is absent or out of range, or header and `POINT:RATE` differ.
    pub fn rate(&self) -> Result<f64, Fault> {
        let stated = self.parameters.number("POINT", "RATE")?;
        let rate = agreed(20, "POINT:RATE", stated, self.header_rate, 1e-3)?;
        checked_rate(rate).or_else(|(found, expected)| refuse(20, found, expected))
    }

    /// Unit of the coordinates specified in `POINT:UNITS`, with the text of that parameter.
    pub fn unit(&self) -> Result<(LengthUnit, String), Fault> {
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

    /// Axis that points up, from the corners of the force platforms; `None` if they do not determine it.
    pub fn floor_up(&self) -> Option<Axis> {
        floor::up(&self.parameters.floats("FORCE_PLATFORM", "CORNERS"))
    }

    /// Text of `POINT:Y_SCREEN`, the axis that is drawn upwards; `None` if the parameter is absent or not a text.
    pub fn screen_up(&self) -> Option<String> {
        self.parameters.text("POINT", "Y_SCREEN").ok().flatten()
    }

    /// Position of the point with index `point` in a frame, in the file's unit; `None` if the point was not seen.
    pub fn position(&self, frame: usize, point: usize) -> Option<[f64; 3]> {
        let start = frame.checked_mul(self.frames.bytes)?;
        let points = Bytes {
            bytes: self.data.bytes.get(start..start + self.frames.bytes)?,
            ..self.data
        };
        // Three coordinates, and a word whose sign states whether the point was seen.
        let [x, y, z, seen] = match self.storage {
            Storage::Float => {
                [0, 4, 8, 12].map(|offset| f64::from(points.f32(16 * point + offset)))
            }
            Storage::Integer(scale) => [(0, scale), (2, scale), (4, scale), (6, 1.0)]
                .map(|(offset, scale)| scale * f64::from(points.i16(8 * point + offset))),
        };
        let raw = [x, y, z];
        (seen >= 0.0 && !raw.iter().any(|x| x.is_nan())).then_some(raw)
    }
}

fn storage(
    parameters: &Parameters<'_>,
    in_header: f32,
    deviations: &mut Vec<Deviation>,
) -> Result<Storage, Fault> {
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
/// specifies it. If both specify it, they must agree within the relative tolerance `within`.
fn agreed(
    byte: usize,
    name: &str,
    parameter: Option<f64>,
    header: f64,
    within: f64,
) -> Result<f64, Fault> {
    let agrees = |value: f64| header == 0.0 || (value - header).abs() <= within * header.abs();
    match parameter {
        Some(value) if agrees(value) => Ok(value),
        Some(value) => {
            let found = format!("{name} = {value} and {header} in the header");
            refuse(byte, found, "one number")
        }
        None => Ok(header),
    }
}
