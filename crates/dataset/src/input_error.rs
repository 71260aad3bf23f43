//! Errors in input files, with file, line and column.

use std::fmt;
use std::path::{Path, PathBuf};

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
