//! Tables of a page.

use crate::figures::svg::escape;
use crate::html::Html;
use crate::text::width;
use crate::text_table::{TextColumn, written};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Column {
    /// What the row is about, or a formula; the header of the row.
    Name,
    Code,
    /// Aligned to the right.
    Number,
    /// Not broken into lines.
    Plain,
    /// Broken into lines.
    Text,
    /// Broken into lines, and left out on a terminal.
    Detail,
    /// Name of a file, broken where it is long.
    File,
}

/// Cell of a table.
#[derive(Clone, Debug)]
pub struct Cell {
    content: Html,
    is_doubtful: bool,
}

impl<T: Into<Html>> From<T> for Cell {
    fn from(content: T) -> Cell {
        Cell {
            content: content.into(),
            is_doubtful: false,
        }
    }
}

impl Cell {
    /// Marks a number that is doubtful.
    #[must_use]
    pub fn doubtful_if(mut self, is_doubtful: bool) -> Cell {
        self.is_doubtful = is_doubtful;
        self
    }
}

/// Table with a header.
#[derive(Clone, Debug, Default)]
pub struct Table {
    columns: Vec<(String, Column)>,
    rows: Vec<Vec<Cell>>,
    is_stacked: bool,
}

/// Table that is built column by column: a heading, and a function from a row to its cell.
#[derive(Clone, Debug)]
pub struct Rows<T> {
    rows: Vec<T>,
    table: Table,
}

impl<T> Rows<T> {
    fn column<C: Into<Cell>>(
        mut self,
        kind: Column,
        head: &str,
        cell: impl Fn(&T) -> C,
    ) -> Rows<T> {
        self.table.columns.push((head.to_owned(), kind));
        for (row, cells) in self.rows.iter().zip(&mut self.table.rows) {
            cells.push(cell(row).into());
        }
        self
    }

    /// Adds the column of what the rows are about: the headers of the rows.
    #[must_use]
    pub fn name<C: Into<Cell>>(self, head: &str, cell: impl Fn(&T) -> C) -> Rows<T> {
        self.column(Column::Name, head, cell)
    }

    /// Adds the column of the formulas that the rows are about.
    #[must_use]
    pub fn code<C: Into<Cell>>(self, head: &str, cell: impl Fn(&T) -> C) -> Rows<T> {
        self.column(Column::Code, head, cell)
    }

    /// Adds a column of numbers, aligned to the right.
    #[must_use]
    pub fn number<C: Into<Cell>>(self, head: &str, cell: impl Fn(&T) -> C) -> Rows<T> {
        self.column(Column::Number, head, cell)
    }

    /// Adds a column of words or units that are not broken into lines.
    #[must_use]
    pub fn plain<C: Into<Cell>>(self, head: &str, cell: impl Fn(&T) -> C) -> Rows<T> {
        self.column(Column::Plain, head, cell)
    }

    /// Adds a column of texts that are broken into lines.
    #[must_use]
    pub fn text<C: Into<Cell>>(self, head: &str, cell: impl Fn(&T) -> C) -> Rows<T> {
        self.column(Column::Text, head, cell)
    }

    /// Adds a column of texts that are left out on a terminal.
    #[must_use]
    pub fn detail<C: Into<Cell>>(self, head: &str, cell: impl Fn(&T) -> C) -> Rows<T> {
        self.column(Column::Detail, head, cell)
    }

    /// Adds a column of the names of files.
    #[must_use]
    pub fn file<C: Into<Cell>>(self, head: &str, cell: impl Fn(&T) -> C) -> Rows<T> {
        self.column(Column::File, head, cell)
    }

    /// Adds columns if a condition holds.
    #[must_use]
    pub fn when(self, is_wanted: bool, add: impl FnOnce(Rows<T>) -> Rows<T>) -> Rows<T> {
        if is_wanted { add(self) } else { self }
    }

    /// The table.
    pub fn table(self) -> Table {
        self.table
    }
}

impl Table {
    /// Begins a table with a row for each of `rows`.
    pub fn of<T>(rows: impl IntoIterator<Item = T>) -> Rows<T> {
        let rows: Vec<T> = rows.into_iter().collect();
        let table = Table {
            rows: rows.iter().map(|_| Vec::new()).collect(),
            ..Table::default()
        };
        Rows { rows, table }
    }

    /// Shows each row as a list of its cells on a narrow screen.
    #[must_use]
    pub fn stacked(mut self) -> Table {
        self.is_stacked = true;
        self
    }

    /// Whether the table has no rows.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// The first `most` rows as text with aligned columns, which fits the terminal; columns without content are left out.
    pub fn text(&self, most: usize) -> String {
        let columns = self.columns.iter().enumerate();
        let columns = columns.filter(|(_, (_, kind))| *kind != Column::Detail);
        let columns = columns.filter_map(|(i, (head, kind))| {
            let rows = self.rows.iter().take(most);
            let cells = rows.map(|row| row[i].content.text()).collect();
            let mut column = TextColumn::new(head, cells)?;
            column.is_number = *kind == Column::Number;
            column.breaks = *kind == Column::Text;
            Some(column)
        });
        let mut text = written(columns.collect(), width());
        if self.rows.len() > most {
            text += &format!("  … and {} more\n", self.rows.len() - most);
        }
        text
    }

    /// The table as HTML. A header without text is left out.
    pub(crate) fn html(&self) -> Html {
        let stacked = self.is_stacked;
        let class = if stacked { " class=\"stacked\"" } else { "" };
        let mut html = format!("<table{class}>\n");
        if self.columns.iter().any(|(head, _)| !head.is_empty()) {
            html += "<thead><tr>";
            for (head, kind) in &self.columns {
                let is_number = *kind == Column::Number;
                let class = if is_number { " class=\"n\"" } else { "" };
                html += &format!("<th{class} scope=\"col\">{}</th>", escape(head));
            }
            html += "</tr></thead>\n";
        }
        html += "<tbody>\n";
        for row in &self.rows {
            html += "<tr>";
            for ((head, kind), cell) in self.columns.iter().zip(row) {
                html += &self.cell(head, *kind, cell);
            }
            html += "</tr>\n";
        }
        Html::trusted(html + "</tbody>\n</table>\n")
    }

    fn cell(&self, head: &str, kind: Column, cell: &Cell) -> String {
        let content = cell.content.as_str();
        let class = match (kind, cell.is_doubtful) {
            (Column::Name, _) => return format!("<th scope=\"row\">{content}</th>"),
            (Column::Code, _) => return format!("<th class=\"code\" scope=\"row\">{content}</th>"),
            (Column::Number, false) => " class=\"n\"",
            (Column::Number, true) => " class=\"n doubt\"",
            (Column::Plain, _) => "",
            (Column::Text | Column::Detail, _) => " class=\"doc\"",
            (Column::File, _) => " class=\"file\"",
        };
        let mut of = String::new();
        if self.is_stacked {
            of = format!(" data-of=\"{}\"", escape(head));
        }
        format!("<td{class}{of}>{content}</td>")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_is_aligned_text_too() {
        let rows = [("a < b", "−0.5"), ("nutation", "10.25"), ("third", "0")];
        let table = Table::of(rows)
            .name("mode", |row| Html::link("#a", row.0))
            .number("decay, 1/s", |row| row.1)
            .plain("empty", |_| "")
            .detail("meaning", |_| "long")
            .table();
        let expected = "  mode      decay, 1/s\n  a < b           −0.5\n  nutation       10.25\n  … and 1 more\n";
        assert_eq!(table.text(2), expected);
    }
}
