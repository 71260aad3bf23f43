//! Errors in the files of a recording, with their location.

use std::fmt;
use std::path::{Path, PathBuf};

/// Location of an error in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Location {
    /// The error concerns the whole file.
    File,
    /// A line of a text file, counted from 1.
    Line(usize),
    /// A table cell: line number and position in the line, both counted from 1.
    Cell(usize, usize),
    /// A byte offset, counted from 0.
    Byte(usize),
}

/// A malformed recording: location of the error, what was found and what was expected.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}{location}: found {found}, expected {expected}", file.display())]
pub struct TakeError {
    /// Path of the malformed recording file.
    pub file: PathBuf,
    /// Location of the error in the file: a line, a table cell, a byte offset, or the whole file.
    pub location: Location,
    /// Description of what was found at the location of the error.
    pub found: String,
    /// Description of what was expected at the location of the error.
    pub expected: String,
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => Ok(()),
            Self::Line(line) => write!(f, ":{line}"),
            Self::Cell(line, cell) => write!(f, ":{line}, cell {cell}"),
            Self::Byte(byte) => write!(f, ", byte {byte}"),
        }
    }
}

/// An error in a recording file, without the path of the file, which the caller adds by `Fault::of`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fault {
    pub location: Location,
    pub found: String,
    pub expected: String,
}

impl Fault {
    pub fn new(location: Location, found: impl Into<String>, expected: impl Into<String>) -> Self {
        Self {
            location,
            found: found.into(),
            expected: expected.into(),
        }
    }

    pub fn of(self, file: &Path) -> TakeError {
        TakeError {
            file: file.to_path_buf(),
            location: self.location,
            found: self.found,
            expected: self.expected,
        }
    }
}
