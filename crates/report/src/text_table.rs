//! Tables as text with aligned columns, which fit the width of a terminal.

use crate::text::lines;

/// Characters between two columns, and before the first.
const GAP: usize = 2;

/// Column of a table: its heading and its cells, one a row, each as lines of text.
pub(crate) struct TextColumn {
    pub is_number: bool,
    /// Whether cells are broken into lines where the table is too wide.
    pub breaks: bool,
    head: Vec<String>,
    cells: Vec<Vec<String>>,
}

impl TextColumn {
    /// `None` if all cells are empty.
    pub fn new(head: &str, cells: Vec<String>) -> Option<TextColumn> {
        let has_content = cells.iter().any(|cell| !cell.is_empty());
        has_content.then(|| TextColumn {
            is_number: false,
            breaks: false,
            head: vec![head.to_owned()],
            cells: cells.into_iter().map(|cell| vec![cell]).collect(),
        })
    }

    fn width(&self) -> usize {
        longest(self.cells.iter().chain([&self.head]).flatten())
    }

    /// Breaks the heading into lines no wider than the cells, or than its longest word.
    fn break_head(&mut self) {
        let head = self.head.join(" ");
        let width = longest(self.cells.iter().flatten()).max(longest_word(&head));
        self.head = lines(&head, width + 1);
    }

    /// Breaks the cells into lines of at most `width` characters, if their words allow it.
    fn break_cells(&mut self, width: usize) {
        let broken = |cell: &mut Vec<String>| {
            let text = cell.join(" ");
            *cell = lines(&text, width.max(longest_word(&text)) + 1);
        };
        self.cells.iter_mut().for_each(broken);
    }
}

fn length(text: &str) -> usize {
    text.chars().count()
}

fn longest<'t>(texts: impl Iterator<Item = &'t String>) -> usize {
    texts.map(|text| length(text)).max().unwrap_or(0)
}

fn longest_word(text: &str) -> usize {
    text.split_whitespace().map(length).max().unwrap_or(0)
}

fn total(columns: &[TextColumn]) -> usize {
    columns.iter().map(|column| GAP + column.width()).sum()
}

/// The table with a line for the headings and one for each row. A table wider than `width` has its headings and then its
/// sentences broken into lines; columns that still do not fit follow below, after the first column again.
pub(crate) fn written(mut columns: Vec<TextColumn>, width: Option<usize>) -> String {
    let Some(width) = width.filter(|width| total(&columns) > *width) else {
        return block(&columns.iter().collect::<Vec<_>>());
    };
    columns.iter_mut().for_each(TextColumn::break_head);
    for i in 0..columns.len() {
        let surplus = total(&columns).saturating_sub(width);
        if columns[i].breaks && surplus > 0 {
            let own = columns[i].width().saturating_sub(surplus);
            columns[i].break_cells(own);
            columns[i].break_head();
        }
    }
    let blocks: Vec<String> = blocks(&columns, width)
        .iter()
        .map(|own| block(own))
        .collect();
    blocks.join("\n")
}

/// Groups of columns that fit the width, each begun by the first column of the table.
fn blocks(columns: &[TextColumn], width: usize) -> Vec<Vec<&TextColumn>> {
    let Some((first, rest)) = columns.split_first() else {
        return Vec::new();
    };
    let mut blocks = vec![vec![first]];
    let mut used = GAP + first.width();
    for column in rest {
        let own = GAP + column.width();
        let is_begun = blocks.last().is_some_and(|block| block.len() > 1);
        if used + own > width && is_begun {
            blocks.push(vec![first]);
            used = GAP + first.width();
        }
        used += own;
        blocks
            .last_mut()
            .into_iter()
            .for_each(|block| block.push(column));
    }
    blocks
}

fn block(columns: &[&TextColumn]) -> String {
    let rows = columns.first().map_or(0, |column| column.cells.len());
    let row = |of: &dyn Fn(&TextColumn) -> Vec<String>| {
        let cells: Vec<Vec<String>> = columns.iter().map(|column| of(column)).collect();
        let height = cells.iter().map(Vec::len).max().unwrap_or(0);
        let mut text = String::new();
        for k in 0..height {
            let mut line = String::new();
            for (cell, column) in cells.iter().zip(columns) {
                let part = cell.get(k).map_or("", String::as_str);
                let width = column.width();
                line += &match column.is_number {
                    true => format!("  {part:>width$}"),
                    false => format!("  {part:width$}"),
                };
            }
            text += line.trim_end();
            text.push('\n');
        }
        text
    };
    let mut text = row(&|column| column.head.clone());
    for i in 0..rows {
        text += &row(&|column| column.cells[i].clone());
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn columns() -> Vec<TextColumn> {
        let column = |head, cells: [&str; 2]| {
            let cells = cells.map(str::to_owned).to_vec();
            TextColumn::new(head, cells).unwrap()
        };
        let mut all = vec![
            column("coefficient", ["C_L0", "C_Da"]),
            column("standard error", ["0.001", "0.2"]),
            column("what it says", ["one two three four", "five"]),
            column("unit", ["1", "1/rad^2"]),
        ];
        all[1].is_number = true;
        all[2].breaks = true;
        all
    }

    #[test]
    fn a_table_fits_the_terminal_and_loses_nothing() {
        let wide = written(columns(), Some(62));
        assert_eq!(wide, written(columns(), None));
        for width in [10, 30, 40, 50] {
            let text = written(columns(), Some(width));
            for word in ["C_Da", "standard", "0.001", "four", "1/rad^2"] {
                assert!(text.contains(word), "{width}: {text}");
            }
            let widest = text.lines().map(length).max().unwrap_or(0);
            assert!(widest <= width.max(24), "{width}: {text}");
        }
        let expected = "  coefficient  standard  what it  unit\n                  error  says\n  \
                        C_L0            0.001  one two  1\n                         three\n                         four\n  \
                        C_Da              0.2  five     1/rad^2\n";
        assert_eq!(written(columns(), Some(42)), expected);
    }
}
