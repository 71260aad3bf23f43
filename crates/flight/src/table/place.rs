//! Source locations (line and column) of table cells, computed only when an error is reported.

/// Text of a flight's table and its cell separator, from which the line and column of a cell are computed.
pub(super) struct CellLocations<'a> {
    pub text: &'a str,
    pub separator: char,
}

impl CellLocations<'_> {
    /// Byte offset of the first record at or after the byte offset `from`; empty lines and comments are skipped.
    pub fn record(&self, from: usize) -> usize {
        let mut start = from.min(self.text.len());
        loop {
            let rest = &self.text[start..];
            if rest.starts_with(['\n', '\r']) {
                start += 1;
            } else if rest.starts_with('#') {
                start += rest.find(['\n', '\r']).unwrap_or(rest.len());
            } else {
                return start;
            }
        }
    }

    /// Line and column, from 1, of the cell `index` (from 0) in the first record at or after the byte offset `from`.
    pub fn cell(&self, from: usize, index: usize) -> (usize, usize) {
        let start = self.record(from);
        let (mut line, mut column) = end_location(&self.text[..start]);
        let mut left = index;
        let (mut at_start, mut quoted) = (true, false);
        let mut before = '\0';
        for c in self.text[start..].chars() {
            if left == 0 && !(at_start && c == ' ') {
                break;
            }
            if c == '"' && (at_start || quoted) {
                quoted = !quoted;
                at_start = false;
            } else if c == '"' && before == '"' {
                // A doubled quote inside quotes.
                quoted = true;
            } else if !quoted && c == self.separator {
                // Spaces in a row are one separator.
                left -= usize::from(c != ' ' || !at_start);
                at_start = true;
            } else if !quoted && (c == '\n' || c == '\r') {
                break;
            } else {
                at_start = at_start && left == 0 && c == ' ';
            }
            if c == '\n' {
                line += 1;
                column = 1;
            } else {
                column += 1;
            }
            before = c;
        }
        (line, column)
    }
}

/// Line and column, from 1, of the end of the text `before`, whose lines end with LF, CR LF or CR.
fn end_location(before: &str) -> (usize, usize) {
    let bytes = before.as_bytes();
    let ends = |i: &usize| match bytes[*i] {
        b'\n' => true,
        b'\r' => bytes.get(i + 1) != Some(&b'\n'),
        _ => false,
    };
    let line = 1 + (0..bytes.len()).filter(ends).count();
    let last = before.rsplit(['\n', '\r']).next().unwrap_or_default();
    (line, 1 + last.chars().count())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cell(text: &str, from: usize, index: usize) -> (usize, usize) {
        let separator = ',';
        CellLocations { text, separator }.cell(from, index)
    }

    #[test]
    fn spaces_in_a_row_are_one_separator() {
        let separator = ' ';
        let text = "  t   x y\n 0 1";
        let locations = CellLocations { text, separator };
        assert_eq!(locations.cell(0, 0), (1, 3));
        assert_eq!(locations.cell(0, 1), (1, 7));
        assert_eq!(locations.cell(10, 1), (2, 4));
    }

    #[test]
    fn cells_are_found_past_comments_quotes_and_letters_of_many_bytes() {
        assert_eq!(cell("a,b,c", 0, 2), (1, 5));
        assert_eq!(cell("\r\n# x,\"\n\nа,  б", 0, 1), (4, 5));
        assert_eq!(cell("\"a,\"\"b\",c", 0, 1), (1, 9));
        assert_eq!(cell("a\rb,c", 2, 1), (2, 3));
        assert_eq!(cell("a,b", 0, 7), (1, 4));
    }
}
