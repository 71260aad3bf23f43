//! Errors in the files of a recording, with their location.

use std::path::{Path, PathBuf};

use crate::takes::{Fault, Location};

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

impl TakeError {
    pub(crate) fn new(file: &Path, fault: Fault) -> Self {
        Self {
            file: file.to_path_buf(),
            location: fault.location,
            found: fault.found,
            expected: fault.expected,
        }
    }
}
