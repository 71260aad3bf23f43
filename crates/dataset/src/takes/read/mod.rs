//! Readers of recordings, one module per format.

mod c3d;
mod header;
mod optitrack;
mod qualisys;
mod vicon;

use std::path::Path;

use crate::takes::commented::with_bare_header;
use crate::takes::two_headers::joined;
use crate::takes::{Fault, Format, Location, ReadOptions, Take, TakeError};

/// Maximum size of a recording file, bytes.
const MAX_FILE_BYTES: u64 = 1 << 30;

/// Reads the recording in a file.
///
/// # Errors
/// [`TakeError`] with the location of the first fault if the file cannot be read or is malformed.
pub fn read(file: &Path, options: &ReadOptions) -> Result<Take, TakeError> {
    let bytes = crate::takes::file::bytes(file, MAX_FILE_BYTES, "a recording")?;
    parse(file, &bytes, options)
}

/// Parses the bytes of a recording file; the path `file` is used in error messages only.
///
/// # Errors
/// [`TakeError`] with the location of the first fault if the bytes are malformed.
pub fn parse(file: &Path, bytes: &[u8], options: &ReadOptions) -> Result<Take, TakeError> {
    checked(bytes, options).map_err(|fault| TakeError::new(file, fault))
}

fn checked(bytes: &[u8], options: &ReadOptions) -> Result<Take, Fault> {
    let format = match options.format {
        Some(format) => format,
        None => Format::recognise(bytes)?,
    };
    let take = if format == Format::C3d {
        c3d::read(bytes, options)?
    } else {
        let text = crate::takes::file::text(bytes)?;
        match format {
            Format::Vicon => vicon::read(&text, options)?,
            Format::Qualisys | Format::QualisysPoses => qualisys::read(&text, format, options)?,
            Format::OptiTrack => optitrack::read(&text, options)?,
            _ => header::read(&joined(with_bare_header(text)), format, options)?,
        }
    };
    let points = take.points.iter().flat_map(|point| &point.positions);
    let mut seen = points.filter(|position| position.is_some());
    let mut poses = take.bodies.iter().flat_map(|body| &body.poses);
    if seen.next().is_none() && !poses.any(std::option::Option::is_some) {
        let expected = "a point that is seen at least once";
        return Err(Fault::new(Location::File, "positions of nothing", expected));
    }
    Ok(take)
}
