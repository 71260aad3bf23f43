//! Number and size of the frames in a C3D file, from the header, the parameters and the file length.

use super::parameters::Parameters;
use super::{Deviation, fault, refuse};
use crate::takes::Fault;

/// Maximum frame number that a 16-bit word of the C3D header can state.
const LAST_OF_HEADER: u32 = 0xffff;
/// Number of bytes after the last frame of a C3D file below which they count as padding.
const PADDING: usize = 512;

pub(super) struct Frames {
    pub first: u32,
    pub count: usize,
    pub bytes: usize,
}

pub(super) struct Layout {
    /// Size of one stored number of the C3D file, bytes.
    pub width: usize,
    pub points: usize,
    /// Number of values of analogue sensors per frame, as the header states it.
    pub analog: usize,
    /// Number of samples of each analogue sensor per frame.
    pub analog_per_channel: usize,
    pub data_start: usize,
    /// Number of bytes from the beginning of the data to the end of the file.
    pub available: usize,
}

/// Determines the frames; `first` and `last` are the frame numbers in the header.
pub(super) fn frames(
    parameters: &Parameters<'_>,
    (first, last): (u32, u32),
    layout: &Layout,
    deviations: &mut Vec<Deviation>,
) -> Result<Frames, Fault> {
    let Layout {
        width,
        points,
        analog,
        available,
        ..
    } = *layout;
    let (first, count) = stated(parameters, first, last, deviations)?;
    let mut bytes = width * (4 * points + analog);
    // Some programs write the number of channels instead of the number of analogue words.
    let all = analog.saturating_mul(layout.analog_per_channel);
    let whole = width * (4 * points + all);
    let fills = |bytes: usize| {
        let needed = bytes.checked_mul(count);
        needed.is_some_and(|n| n <= available && available - n < PADDING)
    };
    if layout.analog_per_channel > 1 && fills(whole) && !fills(bytes) {
        let found = format!("{analog} analogue words per frame");
        let expected = format!("{all}, by the length of the file");
        deviations.push(Deviation {
            contradiction: fault(4, found, expected),
            read_as: format!("frames of {all} analogue words"),
        });
        bytes = whole;
    }
    let held = available.checked_div(bytes).unwrap_or(0);
    if points > 0 && held >= count {
        return Ok(Frames {
            first,
            count,
            bytes,
        });
    }
    let found = format!("{available} bytes of data");
    let expected = format!("{count} frames of {points} points, {bytes} bytes each");
    let short = fault(layout.data_start, found, expected);
    if points == 0 || held == 0 {
        return Err(short);
    }
    deviations.push(Deviation {
        contradiction: short,
        read_as: format!("the {held} whole frames that the file holds"),
    });
    Ok(Frames {
        first,
        count: held,
        bytes,
    })
}

/// First frame of a C3D file and number of frames, from the header, or from the parameters beyond its 16 bits.
fn stated(
    parameters: &Parameters<'_>,
    first: u32,
    last: u32,
    deviations: &mut Vec<Deviation>,
) -> Result<(u32, usize), Fault> {
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
    let range = format!("the frames {first} to {last}");
    if last < first {
        return refuse(6, range, "a last frame that is not before the first");
    }
    let count = u64::from(last) - u64::from(first) + 1;
    // POINT:FRAMES may have overflowed its 16 bits as well.
    if let Some(frames) = parameters.count("POINT", "FRAMES")?
        && frames != count
        && count < u64::from(LAST_OF_HEADER)
    {
        let found = format!("POINT:FRAMES = {frames} and {range}");
        let contradiction = fault(6, found, "one number of frames");
        if frames.abs_diff(count) != 1 {
            return Err(contradiction);
        }
        deviations.push(Deviation {
            contradiction,
            read_as: range,
        });
    }
    match usize::try_from(count) {
        Ok(count) => Ok((first, count)),
        Err(_) => refuse(6, format!("{count} frames"), "fewer"),
    }
}
