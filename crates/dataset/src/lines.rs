//! Rows of a flight's table, with errors at the line and column of a cell.

use std::path::Path;

use crate::input_error::InputError;
use crate::takes::{Fault, Location, Sheet, separator};

/// Reader of the rows of a flight's table.
pub(super) struct Lines<'a> {
    file: &'a Path,
    pub sheet: Sheet<'a>,
}

impl<'a> Lines<'a> {
    pub fn new(file: &'a Path, text: &'a str) -> Self {
        let sheet = Sheet::strict(text, separator(text));
        Self { file, sheet }
    }

    /// Advances to the next row that is neither blank nor a comment; returns `false` at the end of the text.
    pub fn next(&mut self) -> Result<bool, InputError> {
        let read = self.sheet.advance_line();
        read.map_err(|fault| self.located(fault))
    }

    /// Value of a cell of the current row; `None` if it is missing.
    pub fn number(&self, index: usize) -> Result<Option<f64>, InputError> {
        let read = self.sheet.number(index);
        read.map_err(|fault| self.located(fault))
    }

    fn located(&self, fault: Fault) -> InputError {
        match fault.location {
            Location::Cell(_, cell) => self.fault(cell - 1, fault.found, fault.expected),
            _ => InputError::of_file(self.file, fault.found, fault.expected),
        }
    }

    /// Error located at the cell with the index `index` (from 0) of the current row.
    pub fn fault(
        &self,
        index: usize,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> InputError {
        InputError::at(self.file, self.sheet.place(index), found, expected)
    }
}
