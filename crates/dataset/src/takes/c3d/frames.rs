//! Number and size of the frames in a C3D file, from the header, the parameters and the file length.

use super::parameters::Parameters;
use super::{C3dError, Deviation, refuse};

/// Maximum frame number that a 16-bit word of the C3D header can state. As the number of the last frame it may also
/// stand for any greater number.
const LAST_OF_HEADER: u32 = 0xffff;
/// Number of bytes after the last frame of a C3D file below which they count as padding.
const PADDING: usize = 512;

/// Number of the first frame in a C3D file, and number of frames.
pub(super) struct Extent {
    pub first: u32,
    pub count: usize,
}

/// Quantities that determine the size of a frame in a C3D file and the position of the data.
pub(super) struct Layout {
    /// Size of one stored number of the C3D file, bytes.
    pub width: usize,
    pub points: usize,
    /// Number of values of analogue sensors per frame, as the header states it.
    pub analog: usize,
    /// Number of samples of each analogue sensor per frame.
    pub analog_per_channel: usize,
    pub data_start: usize,
    /// Number of bytes from the beginning of the data (field `data_start`) to the end of the file.
    pub available: usize,
}

/// Determines the number of the first frame, the number of frames and the size of a frame in bytes; `first` and `last`
/// are the frame numbers in the header. Contradictions in the file with only one sensible interpretation are added to
/// `deviations`.
pub(super) fn frames(
    parameters: &Parameters<'_>,
    first: u32,
    last: u32,
    layout: &Layout,
    deviations: &mut Vec<Deviation>,
) -> Result<(Extent, usize), C3dError> {
    let (first, count) = stated(parameters, first, last, deviations)?;
    let mut size = layout.width * (4 * layout.points + layout.analog);
    // Some programs write the number of channels instead of the number of analogue words.
    let all = layout.analog.saturating_mul(layout.analog_per_channel);
    let whole = layout.width * (4 * layout.points + all);
    let fills = |size: usize| {
        let needed = size.checked_mul(count);
        needed.is_some_and(|n| n <= layout.available && layout.available - n < PADDING)
    };
    if layout.analog_per_channel > 1 && fills(whole) && !fills(size) {
        deviations.push(Deviation {
            contradiction: C3dError {
                byte: 4,
                found: format!("{} analogue words per frame", layout.analog),
                expected: format!("{all}, by the length of the file"),
            },
            read_as: format!("frames of {all} analogue words"),
        });
        size = whole;
    }
    let held = layout.available.checked_div(size).unwrap_or(0);
    if layout.points > 0 && held >= count {
        return Ok((Extent { first, count }, size));
    }
    let short = C3dError {
        byte: layout.data_start,
        found: format!("{} bytes of data", layout.available),
        expected: format!(
            "{count} frames of {} points, {size} bytes each",
            layout.points
        ),
    };
    if layout.points == 0 || held == 0 {
        return Err(short);
    }
    deviations.push(Deviation {
        contradiction: short,
        read_as: format!("the {held} whole frames that the file holds"),
    });
    Ok((Extent { first, count: held }, size))
}

/// Number of the first frame of a C3D file and number of frames, from the header, or from the parameters if the 16 bits
/// of the header do not suffice.
fn stated(
    parameters: &Parameters<'_>,
    first: u32,
    last: u32,
    deviations: &mut Vec<Deviation>,
) -> Result<(u32, usize), C3dError> {
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
        return refuse(
            6,
            format!("the frames {first} to {last}"),
            "a last frame that is not before the first",
        );
    }
    let count = u64::from(last) - u64::from(first) + 1;
    // POINT:FRAMES may have overflowed its 16 bits as well.
    if let Some(frames) = parameters.count("POINT", "FRAMES")?
        && frames != count
        && count < u64::from(LAST_OF_HEADER)
    {
        let contradiction = C3dError {
            byte: 6,
            found: format!("POINT:FRAMES = {frames} and the frames {first} to {last}"),
            expected: "one number of frames".into(),
        };
        let nearly = frames.abs_diff(count) == 1;
        if !nearly {
            return Err(contradiction);
        }
        deviations.push(Deviation {
            contradiction,
            read_as: format!("the frames {first} to {last}"),
        });
    }
    match usize::try_from(count) {
        Ok(count) => Ok((first, count)),
        Err(_) => refuse(6, format!("{count} frames"), "fewer"),
    }
}
