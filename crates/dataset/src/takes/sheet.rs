//! Row-by-row reader of a table that keeps the line numbers for error messages.

use csv::{Reader, ReaderBuilder, StringRecord};

use crate::takes::error::{Fault, Location};
use crate::takes::number::number;
use crate::takes::words::shown;

/// Cell separator of a line of a table: the tab, else the semicolon, if the line contains one outside quotes; otherwise
/// the comma.
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

/// Row-by-row reader of a text table; skips comment lines, which begin with `#`.
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

    /// Advances to the next row of the table that is neither a comment nor empty; returns false at the end of the
    /// table.
    pub fn advance(&mut self) -> Result<bool, Fault> {
        while self.advance_line()? {
            if self.filled() > 0 {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Advances to the next row that is neither a comment nor a blank line; its cells may all be empty. Returns false
    /// at the end of the table.
    pub fn advance_line(&mut self) -> Result<bool, Fault> {
        loop {
            let read = self.reader.read_record(&mut self.record);
            let place = self.record.position();
            let line = place.map_or(self.line, |place| place.line() as usize);
            let read = read.map_err(|error| {
                Fault::new(Location::Line(line), error.to_string(), "a readable table")
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

    /// Line number of the current row of the table, counted from 1.
    pub fn line(&self) -> usize {
        self.line
    }

    /// Number of cells of the current row of the table, not counting empty cells at its end.
    pub fn filled(&self) -> usize {
        let cells = self.record.iter().zip(1..);
        let filled = cells.filter(|(cell, _)| !cell.trim().is_empty());
        filled.last().map_or(0, |(_, number)| number)
    }

    /// Number of cells of the current row of the table, including empty ones.
    pub fn width(&self) -> usize {
        self.record.len()
    }

    /// Text of a cell of the current row of the table, trimmed; empty if the row has no cell at this index.
    pub fn cell(&self, index: usize) -> &str {
        self.record.get(index).unwrap_or_default().trim()
    }

    /// Texts of all cells of the current row, trimmed.
    pub fn cells(&self) -> Vec<String> {
        self.record
            .iter()
            .map(|cell| cell.trim().to_owned())
            .collect()
    }

    /// Whether the file ends in the current row without a line break, so that the row may be truncated.
    pub fn is_cut(&self) -> bool {
        self.reader.position().byte() as usize >= self.text.len() && !self.text.ends_with('\n')
    }

    /// Value of a cell of the current row of the table; `None` if the cell is empty or NaN. A decimal comma is accepted
    /// unless the comma is the cell separator.
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

    /// Values of the cells with the indices `columns` in the current row of the table; `None` if one of them is empty
    /// or NaN.
    pub fn numbers<const N: usize>(&self, columns: [usize; N]) -> Result<Option<[f64; N]>, Fault> {
        let mut values = [0.0; N];
        for (value, column) in values.iter_mut().zip(columns) {
            match self.number(column)? {
                Some(number) => *value = number,
                None => return Ok(None),
            }
        }
        Ok(Some(values))
    }

    /// Value of a cell of the current row that must contain a number. If it does not, the result is an error whose
    /// message contains `what`, the description of the expected value.
    pub fn needed(&self, index: usize, what: &str) -> Result<f64, Fault> {
        match self.number(index) {
            Ok(Some(number)) => Ok(number),
            _ => Err(self.fault(index, shown(self.cell(index)), what)),
        }
    }

    /// Error whose location is a cell of the current row of the table.
    pub fn fault(
        &self,
        index: usize,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> Fault {
        Fault::new(Location::Cell(self.line, index + 1), found, expected)
    }
}
