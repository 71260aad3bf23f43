//! Errors in input files, with file, line and column.

use std::fmt;
use std::path::{Path, PathBuf};

use model_spec::location::line_and_column;

/// A malformed input file: the location of the error, what was found there and what was expected.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputError {
    /// File that contains the error.
    pub file: PathBuf,
    /// Line and column of the error, both counted from 1; `None` if the error concerns the whole file.
    pub place: Option<(usize, usize)>,
    /// Description of the text or value found at the location of the error.
    pub found: String,
    /// Description of what was expected at the location of the error.
    pub expected: String,
}

impl InputError {
    /// Creates an error that concerns a whole file.
    pub fn of_file(file: &Path, found: impl Into<String>, expected: impl Into<String>) -> Self {
        Self {
            file: file.to_path_buf(),
            place: None,
            found: found.into(),
            expected: expected.into(),
        }
    }

    /// Creates an error at a line and column, both counted from 1.
    pub fn at(
        file: &Path,
        place: (usize, usize),
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> Self {
        Self {
            place: Some(place),
            ..Self::of_file(file, found, expected)
        }
    }
}

impl fmt::Display for InputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.file.display())?;
        if let Some((line, column)) = self.place {
            write!(f, ":{line}:{column}")?;
        }
        write!(f, ": found {}, expected {}", self.found, self.expected)
    }
}

impl std::error::Error for InputError {}

/// Decodes the bytes of a file as UTF-8 and removes a byte-order mark.
///
/// # Errors
/// [`InputError`] with the location of the first byte that is not valid UTF-8.
pub(crate) fn utf8<'a>(file: &Path, bytes: &'a [u8]) -> Result<&'a str, InputError> {
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok(text.strip_prefix('\u{feff}').unwrap_or(text)),
        Err(error) => {
            let good = String::from_utf8_lossy(&bytes[..error.valid_up_to()]);
            let place = line_and_column(&good, good.len());
            Err(InputError::at(
                file,
                place,
                format!("the byte {:#04x}", bytes[error.valid_up_to()]),
                "UTF-8 text",
            ))
        }
    }
}
