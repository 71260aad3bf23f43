//! Reading of a dataset's files as bytes or text: ordinary files of bounded size only.

use std::io::{ErrorKind, Read};
use std::path::Path;

use crate::input_error::{InputError, line_and_column, utf8};

/// Reads an ordinary file of at most `largest` bytes; `what` describes the expected file in the error message.
pub(super) fn bytes(file: &Path, largest: u64, what: &str) -> Result<Vec<u8>, InputError> {
    let unreadable = |error: std::io::Error| {
        let found = match error.kind() {
            // The system's own words differ between systems.
            ErrorKind::NotFound => "no such file".into(),
            ErrorKind::PermissionDenied => "a file that may not be read".into(),
            _ => error.to_string(),
        };
        InputError::of_file(file, found, what)
    };
    let about = std::fs::metadata(file).map_err(unreadable)?;
    if about.is_dir() {
        return Err(InputError::of_file(file, "a folder", what));
    }
    // A pipe or a device may never end.
    if !about.is_file() {
        return Err(InputError::of_file(file, "no ordinary file", what));
    }
    let too_large = |size: u64| {
        let expected = format!("{what} of at most {largest} bytes");
        InputError::of_file(file, format!("{size} bytes"), expected)
    };
    if about.len() > largest {
        return Err(too_large(about.len()));
    }
    let mut bytes = Vec::new();
    let mut reader = std::fs::File::open(file)
        .map_err(unreadable)?
        .take(largest + 1);
    reader.read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > largest {
        return Err(too_large(bytes.len() as u64));
    }
    Ok(bytes)
}

/// Decodes the bytes of a file as UTF-8, without the byte-order mark.
pub(super) fn text<'a>(file: &Path, bytes: &'a [u8]) -> Result<&'a str, InputError> {
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err(InputError::at(
            file,
            (1, 1),
            "the byte-order mark of UTF-16",
            "UTF-8 text",
        ));
    }
    let text = utf8(file, bytes)?;
    match text.find('\0') {
        Some(offset) => {
            let place = line_and_column(text, offset);
            Err(InputError::at(file, place, "a NUL byte", "text"))
        }
        None => Ok(text),
    }
}
