//! One parameter of a C3D file, with its value as stored bytes.

use super::bytes::{Bytes, Order};
use super::{C3dError, refuse};
use crate::takes::words::shown;

/// A parameter of a C3D file whose value is not decoded yet.
pub(super) struct Parameter<'a> {
    /// Byte offset of the parameter's type in the file.
    pub offset: usize,
    pub kind: i8,
    pub dimensions: &'a [u8],
    pub data: Bytes<'a>,
}

/// Type and dimensions of a C3D parameter, and the position of its data in the parameter section of the file.
pub(super) struct Shape<'a> {
    kind: i8,
    dimensions: &'a [u8],
    /// Byte offset of the parameter's type in the file.
    offset: usize,
    /// Byte offset of the parameter's data in the parameter section; the field `size` is the length of these data,
    /// bytes.
    at: usize,
    size: usize,
}

impl<'a> Shape<'a> {
    pub fn read(section: &'a [u8], start: usize, at: usize, name: &str) -> Result<Self, C3dError> {
        let offset = start + at;
        let &[kind, count] = part(section, start, at, 2)? else {
            return refuse(offset, "half a parameter", "a whole one");
        };
        let kind = kind.cast_signed();
        if ![-1, 1, 2, 4].contains(&kind) || count > 7 {
            return refuse(
                offset,
                format!(
                    "the parameter {} of type {kind} with {count} dimensions",
                    shown(name)
                ),
                "type -1, 1, 2 or 4 and at most 7 dimensions",
            );
        }
        let dimensions = part(section, start, at + 2, usize::from(count))?;
        // The product of seven dimensions of 255 fits in 64 bits.
        let size: u64 = dimensions.iter().map(|&d| u64::from(d)).product();
        let size = size * u64::from(kind.unsigned_abs());
        Ok(Self {
            kind,
            dimensions,
            offset,
            at: at + 2 + usize::from(count),
            size: usize::try_from(size).unwrap_or(usize::MAX),
        })
    }

    /// Byte offset in the parameter section of the end of the parameter's data.
    pub fn end(&self) -> usize {
        self.at.saturating_add(self.size)
    }

    pub fn parameter(
        &self,
        section: &'a [u8],
        start: usize,
        order: Order,
    ) -> Result<Parameter<'a>, C3dError> {
        Ok(Parameter {
            offset: self.offset,
            kind: self.kind,
            dimensions: self.dimensions,
            data: Bytes {
                bytes: part(section, start, self.at, self.size)?,
                order,
            },
        })
    }
}

/// Returns the bytes `at..at + length` of the parameter section, or an error if the section is shorter; `start` is the
/// byte offset of the section in the file.
pub(super) fn part(
    section: &[u8],
    start: usize,
    at: usize,
    length: usize,
) -> Result<&[u8], C3dError> {
    let end = at.checked_add(length);
    match end.and_then(|end| section.get(at..end)) {
        Some(part) => Ok(part),
        None => refuse(
            start + at,
            format!("a parameter of {length} bytes at byte {at} of the parameters"),
            format!("all of it within their {} bytes", section.len()),
        ),
    }
}
