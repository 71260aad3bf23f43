//! Reading of files as bytes or text; only regular files of bounded size are accepted.

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

/// Decodes the bytes of a table as UTF-8 and strips the byte-order mark. Fails for UTF-16, invalid UTF-8 and NUL bytes.
pub(crate) fn text(bytes: &[u8]) -> Result<&str, Fault> {
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        let found = "the byte-order mark of UTF-16";
        return Err(Fault::new(Location::Line(1), found, "UTF-8 text"));
    }
    let line = |offset: usize| 1 + bytes[..offset].iter().filter(|&&b| b == b'\n').count();
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let offset = error.valid_up_to();
        let found = format!("the byte {:#04x}", bytes[offset]);
        Fault::new(Location::Line(line(offset)), found, "UTF-8 text")
    })?;
    match text.find('\0') {
        Some(offset) => Err(Fault::new(
            Location::Line(line(offset)),
            "a NUL byte",
            "text",
        )),
        None => Ok(text.strip_prefix('\u{feff}').unwrap_or(text)),
    }
}
