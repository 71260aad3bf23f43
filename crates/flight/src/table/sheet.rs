//! Row-by-row reader of a table that keeps the locations of cells for error messages.

use std::cell::Cell;

use csv::{Reader, ReaderBuilder, StringRecord};

use super::place::CellLocations;
use super::{Fault, Location, number, shown};

/// Cell separator of a table, by the first of its lines that is neither blank nor a comment: the first of tab, semicolon,
/// comma and space that this line contains outside quotes, or the comma. Spaces in a row are one separator.
pub fn separator(text: &str) -> char {
    let header = text
        .split(['\n', '\r'])
        .map(str::trim)
        .find(|line| !line.is_empty() && !line.starts_with('#'));
    let mut quoted = false;
    let mut bare = header.unwrap_or_default().to_owned();
    bare.retain(|c| {
        quoted ^= c == '"';
        !quoted
    });
    let mut marks = ['\t', ';', ',', ' '].into_iter();
    marks.find(|&mark| bare.contains(mark)).unwrap_or(',')
}

/// Reader of a table row by row.
pub struct Sheet<'t> {
    reader: Reader<&'t [u8]>,
    record: StringRecord,
    locations: CellLocations<'t>,
    line: usize,
    has_quotes: bool,
    is_strict: bool,
    /// Decimal mark of the numbers so far, of a table whose cells may have either.
    decimal_mark: Cell<Option<char>>,
}

impl<'t> Sheet<'t> {
    /// Reader of a table, a row of which may be cut at its end.
    pub fn new(text: &'t str, separator: char) -> Self {
        Self::with(text, separator, false)
    }

    /// Reader of a table in which a quote left open in a truncated last row is an error; otherwise that row is only
    /// cut. Comments may contain quotes; the line numbers of rows are not valid, but their places are.
    pub fn strict(text: &'t str, separator: char) -> Self {
        Self::with(text, separator, true)
    }

    fn with(text: &'t str, separator: char, is_strict: bool) -> Self {
        let reader = ReaderBuilder::new()
            .delimiter(separator as u8)
            .comment(is_strict.then_some(b'#'))
            .has_headers(false)
            .flexible(true)
            .from_reader(text.as_bytes());
        Self {
            reader,
            record: StringRecord::new(),
            locations: CellLocations { text, separator },
            line: 0,
            has_quotes: text.contains('"'),
            is_strict,
            decimal_mark: Cell::new(None),
        }
    }

    /// Advances to the next row that is neither a comment nor empty; false at the end of the table.
    pub fn advance(&mut self) -> Result<bool, Fault> {
        while self.advance_line()? {
            if self.filled() > 0 {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Advances as [`advance`](Self::advance); the end of the table is an error with the texts `found` and `expected`.
    pub fn require(&mut self, found: &str, expected: &str) -> Result<(), Fault> {
        match self.advance()? {
            true => Ok(()),
            false => Err(self.line_fault(found, expected)),
        }
    }

    /// Advances to the next row that is neither a comment nor blank; its cells may be empty. False at the end.
    pub fn advance_line(&mut self) -> Result<bool, Fault> {
        loop {
            let read = self.reader.read_record(&mut self.record);
            let line = self.record.position().map(|place| place.line() as usize);
            let line = line.unwrap_or(self.line);
            let read = read.map_err(|error| {
                Fault::new(Location::Line(line), error.to_string(), "a readable table")
            })?;
            if !read {
                return Ok(false);
            }
            self.line = line;
            if self.locations.separator == ' ' {
                self.join_separators();
            }
            self.check_quotes()?;
            let is_blank = self.record.len() <= 1 && self.cell(0).is_empty();
            if !is_blank && !self.cell(0).starts_with('#') {
                return Ok(true);
            }
        }
    }

    /// Removes the empty cells between spaces in a row.
    fn join_separators(&mut self) {
        let place = self.record.position().cloned();
        self.record = self.record.iter().filter(|c| !c.is_empty()).collect();
        self.record.set_position(place);
    }

    /// Returns an error if a quote of the current row is not closed, which would extend over the following rows.
    fn check_quotes(&self) -> Result<(), Fault> {
        if !self.has_quotes {
            return Ok(());
        }
        let text = self.locations.text;
        let end = (self.reader.position().byte() as usize).min(text.len());
        let raw = &text[self.locations.record(self.start()).min(end)..end];
        let may_be_open = !self.is_strict && self.is_cut();
        let is_open = !may_be_open && raw.matches('"').count() % 2 == 1;
        let broken = self
            .record
            .iter()
            .position(|cell| cell.contains(['\n', '\r']));
        match broken.or(is_open.then_some(0)) {
            Some(cell) => {
                Err(self.fault(cell, "a quote that is not closed", "a quote at both ends"))
            }
            None => Ok(()),
        }
    }

    fn start(&self) -> usize {
        self.record
            .position()
            .map_or(0, |place| place.byte() as usize)
    }

    /// Line and column, from 1, of a cell of the current row.
    pub fn place(&self, index: usize) -> (usize, usize) {
        self.locations.cell(self.start(), index)
    }

    /// Line and column, from 1, of the end of the table.
    pub fn end(&self) -> (usize, usize) {
        self.locations.cell(self.locations.text.len(), 0)
    }

    /// Cell separator of the table.
    pub fn separator(&self) -> char {
        self.locations.separator
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
        let text = self.locations.text;
        self.reader.position().byte() as usize >= text.len() && !text.ends_with('\n')
    }

    /// Value of a cell of the current row of the table; `None` if the value is missing. A decimal comma is accepted unless
    /// the comma is the cell separator, or the table has decimal points.
    pub fn number(&self, index: usize) -> Result<Option<f64>, Fault> {
        let cell = self.cell(index);
        let mark = match self.locations.separator {
            ',' => None,
            _ => cell.chars().find(|c| [',', '.'].contains(c)),
        };
        let is_decimal = |c: char| c.is_ascii_digit() || ['-', '+', ',', 'e', 'E'].contains(&c);
        let is_other =
            mark == Some(',') && cell.matches(',').count() == 1 && cell.chars().all(is_decimal);
        let read = if is_other {
            number(&cell.replace(',', "."))
        } else {
            number(cell)
        };
        let read = read.map_err(|expected| self.fault(index, shown(cell), expected))?;
        match (mark, self.decimal_mark.get()) {
            (Some(mark), Some(before)) if mark != before => {
                let expected = format!("one decimal mark in a file, which is `{before}` above");
                Err(self.fault(index, shown(cell), expected))
            }
            (mark, before) => {
                self.decimal_mark.set(before.or(mark));
                Ok(read)
            }
        }
    }

    /// Values of the cells with the indices `columns`; `None` if one of them is empty or NaN.
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

    /// Value of a cell that must contain a number; `what` describes it in the error.
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
        let line = match self.is_strict {
            true => self.place(index).0,
            false => self.line,
        };
        Fault::new(Location::Cell(line, index + 1), found, expected)
    }

    /// Error whose location is the line of the current row.
    pub fn line_fault(&self, found: impl Into<String>, expected: impl Into<String>) -> Fault {
        Fault::new(Location::Line(self.line), found, expected)
    }
}
