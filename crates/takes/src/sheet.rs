//! Rows of a table with their locations.

use csv::{Reader, ReaderBuilder, StringRecord};

use crate::error::{Fault, Place};
use crate::number::number;
use crate::words::shown;

/// Cell separator of a line: a tab or a semicolon if it has one outside quotes, otherwise a comma.
pub(crate) fn separator(line: &str) -> u8 {
    let mut quoted = false;
    let mut bare = line.to_owned();
    bare.retain(|c| {
        quoted ^= c == '"';
        !quoted
    });
    let mut marks = [b'\t', b';'].into_iter();
    marks
        .find(|&mark| bare.contains(char::from(mark)))
        .unwrap_or(b',')
}

/// Reader of a table's rows.
pub(crate) struct Sheet<'t> {
    text: &'t str,
    reader: Reader<&'t [u8]>,
    record: StringRecord,
    separator: u8,
    line: usize,
}

impl<'t> Sheet<'t> {
    pub fn new(text: &'t str, separator: u8) -> Self {
        let reader = ReaderBuilder::new()
            .delimiter(separator)
            .has_headers(false)
            .flexible(true)
            .from_reader(text.as_bytes());
        Self {
            text,
            reader,
            record: StringRecord::new(),
            separator,
            line: 0,
        }
    }

    /// Advances to the next row that is no comment and has text; false at the end.
    pub fn advance(&mut self) -> Result<bool, Fault> {
        while self.advance_line()? {
            if self.filled() > 0 {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Advances to the next row that is no comment and no blank line; its cells may all be empty. False at the end.
    pub fn advance_line(&mut self) -> Result<bool, Fault> {
        loop {
            let read = self.reader.read_record(&mut self.record);
            let place = self.record.position();
            let line = place.map_or(self.line, |place| place.line() as usize);
            let read = read.map_err(|error| {
                Fault::new(Place::Line(line), error.to_string(), "a readable table")
            })?;
            if !read {
                return Ok(false);
            }
            self.line = line;
            if let Some(cell) = self.record.iter().position(|cell| cell.contains('\n')) {
                let found = "a quote that is not closed";
                return Err(self.fault(cell, found, "a quote at both ends"));
            }
            let is_blank = self.record.len() == 1 && self.cell(0).is_empty();
            if !is_blank && !self.cell(0).starts_with('#') {
                return Ok(true);
            }
        }
    }

    /// Line of the current row, from 1.
    pub fn line(&self) -> usize {
        self.line
    }

    /// Number of cells of the current row, without empty ones at its end.
    pub fn filled(&self) -> usize {
        let cells = self.record.iter().zip(1..);
        let filled = cells.filter(|(cell, _)| !cell.trim().is_empty());
        filled.last().map_or(0, |(_, number)| number)
    }

    /// Number of cells of the current row.
    pub fn width(&self) -> usize {
        self.record.len()
    }

    /// A cell of the current row, trimmed; empty where there is none.
    pub fn cell(&self, index: usize) -> &str {
        self.record.get(index).unwrap_or_default().trim()
    }

    /// The cells of the current row, trimmed.
    pub fn cells(&self) -> Vec<String> {
        self.record
            .iter()
            .map(|cell| cell.trim().to_owned())
            .collect()
    }

    /// Whether the current row is the last and its line has no end: the file may have been cut in it.
    pub fn is_cut(&self) -> bool {
        self.reader.position().byte() as usize >= self.text.len() && !self.text.ends_with('\n')
    }

    /// A cell of the current row as a number; `None` where it is empty or NaN. Decimal commas are read where the comma does
    /// not separate cells.
    pub fn number(&self, index: usize) -> Result<Option<f64>, Fault> {
        let cell = self.cell(index);
        let is_decimal = |c: char| c.is_ascii_digit() || ['-', '+', ',', 'e', 'E'].contains(&c);
        let comma = self.separator != b','
            && cell.matches(',').count() == 1
            && cell.chars().all(is_decimal);
        let read = match comma {
            true => number(&cell.replace(',', ".")),
            false => number(cell),
        };
        read.map_err(|expected| self.fault(index, shown(cell), expected))
    }

    /// A cell that must hold a number.
    pub fn needed(&self, index: usize, what: &str) -> Result<f64, Fault> {
        match self.number(index) {
            Ok(Some(number)) => Ok(number),
            _ => Err(self.fault(index, shown(self.cell(index)), what)),
        }
    }

    /// An error at a cell of the current row.
    pub fn fault(
        &self,
        index: usize,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> Fault {
        Fault::new(Place::Cell(self.line, index + 1), found, expected)
    }
}
