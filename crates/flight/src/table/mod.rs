//! Tables from outside, with the places of their cells, and texts from outside in messages.

mod number;
mod place;
mod sheet;
mod words;

use std::fmt;

pub use number::number;
pub use sheet::{Sheet, separator};
pub use words::{listed, shown};

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

impl Location {
    /// Line and cell, from 1, of a location in a table; the first ones where it states none.
    pub fn place(self) -> (usize, usize) {
        match self {
            Self::Cell(line, cell) => (line, cell),
            Self::Line(line) => (line, 1),
            Self::File | Self::Byte(_) => (1, 1),
        }
    }
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

/// An error in a file, without the path of the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Where in the file.
    pub location: Location,
    /// What was found.
    pub found: String,
    /// What was expected.
    pub expected: String,
}

impl Fault {
    /// Creates an error.
    pub fn new(location: Location, found: impl Into<String>, expected: impl Into<String>) -> Self {
        Self {
            location,
            found: found.into(),
            expected: expected.into(),
        }
    }
}
