//! Reading of model files: size limit and UTF-8 decoding.

use std::sync::Arc;

use crate::diagnostic::{Diagnostic, Kind, Source, Span};
use crate::error::LoadError;
use crate::location::line_and_column;
use crate::syntax::{MAX_SOURCE_BYTES, Parsed, too_long};

/// Reads the file of a model or of an effect as text.
///
/// # Errors
/// [`LoadError::Unreadable`] if the file cannot be read; [`LoadError::Faults`] if it is too long or not UTF-8.
pub(crate) fn read(path: &str) -> Result<String, LoadError> {
    let unreadable = |error| LoadError::Unreadable {
        path: path.to_owned(),
        error: Arc::new(error),
    };
    let length = std::fs::metadata(path).map_err(unreadable)?.len();
    if length > MAX_SOURCE_BYTES as u64 {
        let length = usize::try_from(length).unwrap_or(usize::MAX);
        let Parsed {
            diagnostics,
            source,
            ..
        } = too_long(path, length, 0);
        return Err(LoadError::Faults {
            diagnostics,
            sources: vec![source],
        });
    }
    decode(path, std::fs::read(path).map_err(unreadable)?)
}

/// Decodes the bytes of a model file as UTF-8; messages refer to the file as `name`.
///
/// # Errors
/// [`LoadError::Faults`] if the bytes are not UTF-8, with line and column of the first invalid byte.
pub fn decode(name: &str, bytes: Vec<u8>) -> Result<String, LoadError> {
    let error = match String::from_utf8(bytes) {
        Ok(text) => return Ok(text),
        Err(error) => error,
    };
    let at = error.utf8_error().valid_up_to();
    let bytes = error.as_bytes();
    let (line, column) = line_and_column(&String::from_utf8_lossy(&bytes[..at]), at);
    let message = format!(
        "the file is not UTF-8: byte {at} (0x{:02X}), line {line} column {column}, begins no character",
        bytes[at]
    );
    let mut fault =
        Diagnostic::new(Kind::Lexical, Span::default(), message).help("save the file as UTF-8");
    if at == 0 && (bytes.starts_with(&[0xFF, 0xFE]) || bytes.starts_with(&[0xFE, 0xFF])) {
        fault = fault.note("it begins like a file in UTF-16");
    }
    Err(LoadError::Faults {
        diagnostics: vec![fault],
        sources: vec![Source {
            name: name.to_owned(),
            text: String::new(),
        }],
    })
}
