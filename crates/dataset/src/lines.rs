//! Reads the records of a table together with their source locations.

use std::path::Path;

use csv::StringRecord;

use super::place::CellLocations;
use crate::input_error::InputError;

/// Reader of the records (lines) of a flight's table, which keeps the byte offset of the current record.
pub(super) struct Lines<'a> {
    pub(super) file: &'a Path,
    pub(super) places: CellLocations<'a>,
    pub(super) quotes: bool,
    pub(super) start: usize,
}

impl Lines<'_> {
    /// Reads the next record of the table that is neither blank nor a comment; returns `false` at the end of the text.
    pub(super) fn next(
        &mut self,
        reader: &mut csv::Reader<&[u8]>,
        record: &mut StringRecord,
    ) -> Result<bool, InputError> {
        loop {
            let read = reader.read_record(record).map_err(|error| {
                InputError::of_file(self.file, error.to_string(), "a readable table")
            })?;
            if !read {
                return Ok(false);
            }
            self.start = record.position().map_or(0, |place| place.byte() as usize);
            if self.quotes {
                self.quotes_are_closed(reader.position().byte() as usize, record)?;
            }
            let first = record.get(0).unwrap_or_default().trim();
            // The CSV reader itself skips empty lines, and comments at the beginning of a line.
            let blank = record.len() == 1 && first.is_empty();
            if !blank && !first.starts_with('#') {
                return Ok(true);
            }
        }
    }

    /// Returns an error if `record`, whose text ends at the byte offset `end`, has an unclosed quote, which would
    /// otherwise extend over the following rows of the table.
    fn quotes_are_closed(&self, end: usize, record: &StringRecord) -> Result<(), InputError> {
        let text = self.places.text;
        let raw = &text[self.places.record(self.start).min(end)..end.min(text.len())];
        let broken = record.iter().position(|cell| cell.contains(['\n', '\r']));
        let open = raw.matches('"').count() % 2 == 1;
        match broken.or(open.then_some(0)) {
            Some(index) => {
                Err(self.fault(index, "a quote that is not closed", "a quote at both ends"))
            }
            None => Ok(()),
        }
    }

    /// Creates an error located at the cell with the index `index` (from 0) of the current record. `found` and
    /// `expected` are its texts.
    pub fn fault(
        &self,
        index: usize,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> InputError {
        let place = self.places.cell(self.start, index);
        InputError::at(self.file, place, found, expected)
    }
}
