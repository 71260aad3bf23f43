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
    let fault = |bytes: &[u8], (offset, found, expected): NotText| {
        let line = 1 + bytes[..offset].iter().filter(|&&b| b == b'\n').count();
        Fault::new(Location::Line(line), found, expected)
    };
    let wide = match bytes {
        [0xff, 0xfe, rest @ ..] => utf16(rest, u16::from_le_bytes)?,
        [0xfe, 0xff, rest @ ..] => utf16(rest, u16::from_be_bytes)?,
        _ => {
            let text = utf8(bytes).map_err(|error| fault(bytes, error))?;
            return Ok(with_newlines(text).map_or(Cow::Borrowed(text), Cow::Owned));
        }
    };
    utf8(wide.as_bytes()).map_err(|error| fault(wide.as_bytes(), error))?;
    Ok(Cow::Owned(with_newlines(&wide).unwrap_or(wide)))
}

/// The text with newlines in place of carriage returns, if its lines end in these alone.
fn with_newlines(text: &str) -> Option<String> {
    let is_bare = text.contains('\r') && !text.contains('\n');
    is_bare.then(|| text.replace('\r', "\n"))
}

/// Offset of a byte that is not text, what was found there and what was expected.
pub(crate) type NotText = (usize, String, &'static str);

/// Decodes UTF-8 without NUL bytes, and removes a byte-order mark.
pub(crate) fn utf8(bytes: &[u8]) -> Result<&str, NotText> {
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let offset = error.valid_up_to();
        let found = format!("the byte {:#04x}", bytes[offset]);
        (offset, found, "UTF-8 text")
    })?;
    match text.find('\0') {
        Some(offset) => Err((offset, "a NUL byte".into(), "text")),
        None => Ok(text.strip_prefix('\u{feff}').unwrap_or(text)),
    }
}

fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Result<String, Fault> {
    let units = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
    let text: Result<String, _> = char::decode_utf16(units).collect();
    text.map_err(|_| Fault::new(Location::Line(1), "bytes that are not UTF-16", "UTF-8 text"))
}
