//! Reads a dataset's files as bytes or text; only regular files of bounded size are accepted.

use std::borrow::Cow;
use std::path::Path;

use model_spec::location::line_and_column;

use crate::input_error::InputError;
use crate::takes::file::{NotText, decoded, utf8};

/// Reads a regular file of at most `largest` bytes; `what` describes the expected file in the error message.
pub(super) fn bytes(file: &Path, largest: u64, what: &str) -> Result<Vec<u8>, InputError> {
    crate::takes::file::bytes(file, largest, what)
        .map_err(|error| InputError::of_file(file, error.found, error.expected))
}

/// Decodes the content of a TOML file as UTF-8 and drops a byte-order mark. An error for UTF-16 or a NUL byte.
pub(super) fn text<'a>(file: &Path, bytes: &'a [u8]) -> Result<&'a str, InputError> {
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        let found = "the byte-order mark of UTF-16";
        return Err(InputError::at(file, (1, 1), found, "UTF-8 text"));
    }
    utf8(bytes).map_err(|error| located(file, bytes, error))
}

/// Decodes the content of a table, in the encodings of [`decoded`].
pub(super) fn table_text<'a>(file: &Path, bytes: &'a [u8]) -> Result<Cow<'a, str>, InputError> {
    decoded(bytes).map_err(|error| located(file, bytes, error))
}

fn located(file: &Path, bytes: &[u8], (offset, found, expected): NotText) -> InputError {
    let before = String::from_utf8_lossy(&bytes[..offset]);
    let place = line_and_column(&before, before.len());
    InputError::at(file, place, found, expected)
}
