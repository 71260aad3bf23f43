//! Reading of files as bytes or text; only regular files of bounded size are accepted.

use std::borrow::Cow;
use std::io::{ErrorKind, Read};
use std::path::Path;

use crate::takes::error::{Fault, Location, TakeError};

/// Reads a regular file of at most `largest` bytes; `what` describes the expected file in the error message.
///
/// # Errors
/// [`TakeError`] for the whole file if it does not exist, cannot be read, is not a regular file or is larger than
/// `largest`.
pub fn bytes(file: &Path, largest: u64, what: &str) -> Result<Vec<u8>, TakeError> {
    let refused =
        |found: String, expected: &str| Fault::new(Location::File, found, expected).of(file);
    let unreadable = |error: std::io::Error| {
        let found = match error.kind() {
            // Operating systems word these errors differently.
            ErrorKind::NotFound => "no such file".into(),
            ErrorKind::PermissionDenied => "a file that may not be read".into(),
            _ => error.to_string(),
        };
        refused(found, what)
    };
    let about = std::fs::metadata(file).map_err(unreadable)?;
    if about.is_dir() {
        return Err(refused("a folder".into(), what));
    }
    // A pipe or a device may never end.
    if !about.is_file() {
        return Err(refused("no ordinary file".into(), what));
    }
    let too_large = |size: u64| {
        let expected = format!("{what} of at most {largest} bytes");
        refused(format!("{size} bytes"), &expected)
    };
    if about.len() > largest {
        return Err(too_large(about.len()));
    }
    let mut bytes = Vec::new();
    let opened = std::fs::File::open(file).map_err(unreadable)?;
    let mut reader = opened.take(largest + 1);
    reader.read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > largest {
        return Err(too_large(bytes.len() as u64));
    }
    Ok(bytes)
}

/// Decodes the bytes of a table: UTF-8, or UTF-16 with a byte-order mark, which is stripped; lines may end in a carriage
/// return alone. Fails for other encodings and NUL bytes.
pub(crate) fn text(bytes: &[u8]) -> Result<Cow<'_, str>, Fault> {
    let line = |before: &[u8]| Location::Line(1 + before.iter().filter(|&&b| b == b'\n').count());
    let text = match bytes {
        [0xff, 0xfe, rest @ ..] => Cow::Owned(utf16(rest, u16::from_le_bytes)?),
        [0xfe, 0xff, rest @ ..] => Cow::Owned(utf16(rest, u16::from_be_bytes)?),
        _ => Cow::Borrowed(std::str::from_utf8(bytes).map_err(|error| {
            let offset = error.valid_up_to();
            let found = format!("the byte {:#04x}", bytes[offset]);
            Fault::new(line(&bytes[..offset]), found, "UTF-8 text")
        })?),
    };
    if let Some(offset) = text.find('\0') {
        let before = &text.as_bytes()[..offset];
        return Err(Fault::new(line(before), "a NUL byte", "text"));
    }
    if text.contains('\r') && !text.contains('\n') {
        return Ok(Cow::Owned(text.replace('\r', "\n")));
    }
    Ok(match text {
        Cow::Borrowed(text) => Cow::Borrowed(text.strip_prefix('\u{feff}').unwrap_or(text)),
        owned => owned,
    })
}

fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Result<String, Fault> {
    let units = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
    let text: Result<String, _> = char::decode_utf16(units).collect();
    text.map_err(|_| Fault::new(Location::Line(1), "bytes that are not UTF-16", "UTF-8 text"))
}
