//! CSV tables of results, and of the data shown in a figure.

use super::panel::Panel;

pub(crate) struct Table {
    writer: csv::Writer<Vec<u8>>,
    lines: usize,
}

impl Table {
    pub(crate) fn new(head: &[&str]) -> Table {
        let mut builder = csv::WriterBuilder::new();
        let mut table = Table {
            writer: builder.flexible(true).from_writer(Vec::new()),
            lines: 0,
        };
        for name in head {
            table.text(name);
        }
        table.end();
        table
    }

    pub(crate) fn text(&mut self, cell: &str) -> &mut Table {
        // Memory does not fail.
        let _ = self.writer.write_field(cell);
        self
    }

    /// Appends a number with six significant digits; an empty cell if it is not finite.
    pub(crate) fn number(&mut self, value: f64) -> &mut Table {
        if !value.is_finite() {
            return self.text("");
        }
        let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
        let size = rounded.abs();
        if size == 0.0 || (1e-4..1e7).contains(&size) {
            self.text(&rounded.to_string())
        } else {
            self.text(&format!("{rounded:e}"))
        }
    }

    /// Appends a number with six decimals.
    pub(crate) fn fixed(&mut self, value: f64) -> &mut Table {
        self.text(&format!("{value:.6}"))
    }

    /// Appends a number; an empty cell for `None`.
    pub(crate) fn optional(&mut self, value: Option<f64>) -> &mut Table {
        self.number(value.unwrap_or(f64::NAN))
    }

    pub(crate) fn end(&mut self) {
        self.lines += 1;
        let _ = self.writer.write_record(None::<&[u8]>);
    }

    /// Number of lines, the heading among them.
    pub(crate) fn lines(&self) -> usize {
        self.lines
    }

    pub(crate) fn finish(self) -> String {
        let bytes = self.writer.into_inner().unwrap_or_default();
        String::from_utf8(bytes).unwrap_or_default()
    }
}

/// CSV table of results that is built column by column: a heading, and a function from a row to its cell, with all digits.
#[derive(Clone, Debug)]
pub struct CsvTable<T> {
    head: Vec<String>,
    rows: Vec<(T, Vec<String>)>,
}

impl<T> CsvTable<T> {
    /// Begins a table with a line for each of `rows`.
    pub fn of(rows: impl IntoIterator<Item = T>) -> CsvTable<T> {
        CsvTable {
            head: Vec::new(),
            rows: rows.into_iter().map(|row| (row, Vec::new())).collect(),
        }
    }

    /// Adds a column.
    #[must_use]
    pub fn column<C: ToString>(self, head: &str, cell: impl Fn(&T) -> C) -> CsvTable<T> {
        self.optional(head, |row| Some(cell(row)))
    }

    /// Adds a column with empty cells for `None`.
    #[must_use]
    pub fn optional<C: ToString>(
        mut self,
        head: &str,
        cell: impl Fn(&T) -> Option<C>,
    ) -> CsvTable<T> {
        self.head.push(head.to_owned());
        for (row, cells) in &mut self.rows {
            cells.push(cell(row).map_or_else(String::new, |cell| cell.to_string()));
        }
        self
    }

    /// The table as text.
    pub fn text(self) -> String {
        let heads: Vec<&str> = self.head.iter().map(String::as_str).collect();
        let mut table = Table::new(&heads);
        for (_, cells) in &self.rows {
            for cell in cells {
                table.text(cell);
            }
            table.end();
        }
        table.finish()
    }
}

/// CSV table of the data shown in panels, with a line for each point, bar, band or level.
pub(crate) fn of_panels(panels: &[Panel]) -> String {
    let mut table = Table::new(&["panel", "kind", "series", "x", "x_end", "y", "y_end"]);
    for panel in panels {
        let mut line = |kind: &str, series: &str, x: [Option<f64>; 2], y: [Option<f64>; 2]| {
            table.text(&panel.title).text(kind).text(series);
            table.optional(x[0]).optional(x[1]);
            table.optional(y[0]).optional(y[1]).end();
        };
        for (x, low, high) in &panel.ribbon {
            line("band", "", [Some(*x), None], [Some(*low), Some(*high)]);
        }
        for of in &panel.lines {
            for (x, y) in &of.points {
                line("line", &of.name, [Some(*x), None], [Some(*y), None]);
            }
        }
        for (i, dots) in panel.dots.iter().enumerate() {
            let series = (i + 1).to_string();
            for (x, y) in &dots.points {
                line("point", &series, [Some(*x), None], [Some(*y), None]);
            }
        }
        for bar in &panel.bars {
            let x = [Some(bar.from), Some(bar.to)];
            line("bar", "", x, [Some(bar.height), None]);
        }
        for level in &panel.levels {
            line("level", "", [None, None], [Some(*level), None]);
        }
    }
    table.finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figures::Line;

    #[test]
    fn cells_are_quoted_and_numbers_rounded() {
        let mut table = Table::new(&["a", "b,c"]);
        table.text("x\"y").number(1.0 / 3.0).end();
        table.number(-1.5e-9).number(f64::NAN).end();
        let text = table.finish();
        assert_eq!(text, "a,\"b,c\"\n\"x\"\"y\",0.333333\n-1.5e-9,\n");
    }

    #[test]
    fn every_point_of_a_panel_has_a_line() {
        let panel = Panel {
            title: "C, 1".into(),
            lines: vec![Line {
                name: "before".into(),
                points: vec![(1.0, 2.0), (3.0, 4.0)],
            }],
            ribbon: vec![(1.0, 1.5, 2.5)],
            levels: vec![9.0],
            ..Panel::default()
        };
        let text = of_panels(&[panel]);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[1], "\"C, 1\",band,,1,,1.5,2.5");
        assert_eq!(lines[3], "\"C, 1\",line,before,3,,4,");
        assert_eq!(lines[4], "\"C, 1\",level,,,,9,");
        assert_eq!(lines.len(), 5);
    }
}
