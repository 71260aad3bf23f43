//! Reading of files as bytes or text; only regular files of bounded size are accepted.

use std::borrow::Cow;
use std::io::{ErrorKind, Read};
use std::path::Path;

use crate::takes::{Fault, Location, TakeError};

/// Reads a regular file of at most `largest` bytes; `what` describes the expected file in the error message.
///
/// # Errors
/// [`TakeError`] for the whole file if it does not exist, cannot be read, is not a regular file or is larger than
/// `largest`.
pub fn bytes(file: &Path, largest: u64, what: &str) -> Result<Vec<u8>, TakeError> {
    let refused = |found: String, expected: &str| {
        TakeError::new(file, Fault::new(Location::File, found, expected))
    };
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

/// Decodes the bytes of a table as [`decoded`]; an error has the line.
pub(crate) fn text(bytes: &[u8]) -> Result<Cow<'_, str>, Fault> {
    decoded(bytes).map_err(|(offset, found, expected)| {
        let line = 1 + bytes[..offset].iter().filter(|&&b| b == b'\n').count();
        Fault::new(Location::Line(line), found, expected)
    })
}

/// Decodes the bytes of a table: UTF-8, UTF-16 with a byte-order mark, which is removed, or Latin-1; lines may end in a
/// carriage return alone. Fails for NUL bytes and for bytes that are no character of these encodings.
///
/// Numbers and separators are the same in every one-byte encoding; names have to agree with the dataset's anyway.
pub(crate) fn decoded(bytes: &[u8]) -> Result<Cow<'_, str>, NotText> {
    let text = match bytes {
        [0xff, 0xfe, rest @ ..] => utf16(rest, u16::from_le_bytes)?.into(),
        [0xfe, 0xff, rest @ ..] => utf16(rest, u16::from_be_bytes)?.into(),
        _ => match utf8(bytes) {
            Ok(text) => Cow::Borrowed(text),
            Err(_) if is_latin1(bytes) => bytes.iter().map(|&b| char::from(b)).collect(),
            Err(error) => return Err(error),
        },
    };
    let text = with_newlines(&text).map_or(text, Cow::Owned);
    Ok(with_commented_separator(&text).map_or(text, Cow::Owned))
}

/// The text with its first line a comment, if that is `sep=;` or its like, by which a table tells a spreadsheet what
/// separates cells.
fn with_commented_separator(text: &str) -> Option<String> {
    let first = text.lines().next().unwrap_or_default().trim_end();
    let is_separator = first.chars().count() == 5 && first.starts_with("sep=");
    is_separator.then(|| format!("#{}", &text[1..]))
}

/// Whether the bytes can be Latin-1: no NUL, no upper control character, and no 0xff, more often damage than ÿ.
fn is_latin1(bytes: &[u8]) -> bool {
    let is_shown = |&byte: &u8| byte != 0 && byte != 0xff && !(0x80..0xa0).contains(&byte);
    bytes.iter().all(is_shown)
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

fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Result<String, NotText> {
    let units = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
    let text: Result<String, _> = char::decode_utf16(units).collect();
    let text = text.map_err(|_| (0, "bytes that are not UTF-16".into(), "UTF-8 text"))?;
    match text.contains('\0') {
        true => Err((0, "a NUL character".into(), "text")),
        false => Ok(text),
    }
}
