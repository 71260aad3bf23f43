//! Figure of correlations as the lower triangle of a matrix.

use identify::numbers::plain;

use super::Layout;
use super::csv::Table;
use super::svg::{Svg, cut};

const STEPS: usize = 40;
/// Maximum number of rows for which the correlations are printed in their cells.
const MAX_WRITTEN: usize = 12;
/// Absolute correlation above which a cell is so dark that its text is white.
const DARK: f64 = 0.65;

/// Correlations of at least two quantities.
pub(crate) struct Triangle<'a> {
    pub(crate) title: &'a str,
    pub(crate) names: Vec<&'a str>,
    /// Whether a quantity is emphasised.
    pub(crate) is_strong: &'a dyn Fn(&str) -> bool,
    /// Correlation of the quantities of a row and a column of an earlier row; NaN if it is not known.
    pub(crate) value: &'a dyn Fn(usize, usize) -> f64,
    /// Whether the sign counts: the scale is from −1 to 1 instead of 0 to 1, and few correlations are printed.
    pub(crate) is_signed: bool,
    pub(crate) ends: [&'a str; 2],
}

impl Triangle<'_> {
    pub(crate) fn csv(&self) -> String {
        let mut table = Table::new(&["row", "column", "correlation"]);
        for (i, row) in self.names.iter().enumerate() {
            for (j, column) in self.names.iter().take(i).enumerate() {
                table
                    .text(row)
                    .text(column)
                    .number((self.value)(i, j))
                    .end();
            }
        }
        table.finish()
    }

    pub(crate) fn draw(&self, layout: Layout) -> String {
        let (letters, letter) = (layout.letters, 1.02 * layout.letter());
        let longest = self.names.iter().map(|n| n.chars().count()).max();
        let room = (letter * longest.unwrap_or(0) as f64 + 8.0).min(0.44 * layout.width);
        // The label at the end of a row is also the label of the column below it.
        let last = self.names.len().saturating_sub(1).max(1) as f64;
        let side = ((layout.width - room - 8.0) / last).min(44.0);
        let tall = side.min(34.0).max(letters + 3.0);
        let (left, top) = (4.0, 2.0 * letters + 14.0);
        let mut svg = Svg::new();
        svg.text("title", (2.0, 2.0 * letters), "start", self.title);
        for (i, name) in self.names.iter().enumerate() {
            let y = top + tall * i as f64;
            let base = y + 0.5 * tall + 0.33 * letters;
            for j in 0..i {
                let x = left + side * j as f64;
                let value = (self.value)(i, j);
                self.shade(&mut svg, value, (x, y), (side - 1.0, tall - 1.0));
                if self.is_signed && self.names.len() <= MAX_WRITTEN {
                    let class = if value.abs() > DARK { "pale" } else { "dark" };
                    let text = plain(value, if side < 27.0 { 1 } else { 2 });
                    let place = (x + 0.5 * side - 0.5, base);
                    let class = format!("{class} cell little");
                    svg.text(&class, place, "middle", &text.replacen("0.", ".", 1));
                }
            }
            let x = left + side * i as f64 + 4.0;
            let is_strong = (self.is_strong)(name);
            let class = if is_strong { "strong" } else { "tick" };
            let name = cut(name, layout.width - x - 2.0, letter);
            svg.text(class, (x, base), "start", &name);
        }
        let bottom = top + tall * self.names.len() as f64 + 12.0;
        let end = left + self.scale(&mut svg, layout, (left, bottom));
        let [low, high] = self.ends;
        for (x, anchor, text) in [(left, "start", low), (end, "end", high)] {
            svg.text("tick", (x, bottom + 10.0 + letters), anchor, text);
        }
        let size = (layout.width, bottom + 22.0 + letters);
        svg.finish(self.title, size, layout.most, letters)
    }

    /// Draws the colour scale with its upper left corner at `place`, SVG units; returns its width.
    fn scale(&self, svg: &mut Svg, layout: Layout, (left, top): (f64, f64)) -> f64 {
        let wide = (0.6 * layout.width).min(260.0) / STEPS as f64;
        for i in 0..STEPS {
            let part = (i as f64 + 0.5) / STEPS as f64;
            let signed = self.is_signed;
            let value = if signed { 2.0 * part - 1.0 } else { part };
            self.shade(svg, value, (left + wide * i as f64, top), (wide, 8.0));
        }
        wide * STEPS as f64
    }

    /// Draws a cell, the stronger the greater the absolute correlation; one that is not finite has a colour of its own.
    fn shade(&self, svg: &mut Svg, value: f64, place: (f64, f64), size: (f64, f64)) {
        let opacity = 0.05 + 0.95 * value.abs().min(1.0);
        match value.is_finite() {
            true if self.is_signed && value > 0.0 => svg.veil("positive", opacity, place, size),
            true => svg.veil("alike", opacity, place, size),
            false => svg.block("unknown", place, size),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figures::tests::{blocks, texts};

    #[test]
    fn cells_are_apart_and_the_scale_with_its_ends_is_below_them() {
        let triangle = Triangle {
            title: "Correlations",
            names: vec!["C_L0", "C_La", "C_D0", "C_Da"],
            is_strong: &|_| false,
            value: &|row, column| 0.1 * (row + column) as f64,
            is_signed: false,
            ends: ["none", "all"],
        };
        let svg = triangle.draw(Layout::COLUMN);
        let (texts, blocks) = (texts(&svg), blocks(&svg));
        let (cells, scale) = blocks.split_at(6);
        assert_eq!(scale.len(), STEPS);
        // Rows of one, two and three cells.
        let lower = |cell: &[f64; 4]| cell[1] + cell[3];
        for (above, below) in [(0, 1), (1, 3), (2, 4)] {
            assert!(lower(&cells[above]) < cells[below][1], "{cells:?}");
        }
        let last = lower(&cells[5]);
        assert!(scale.iter().all(|own| own[1] > last), "{scale:?}");
        for end in ["none", "all"] {
            let (_, at) = texts.iter().find(|own| own.0 == end).expect(end);
            assert!(
                at[1] - 0.7 * Layout::COLUMN.letters > lower(&scale[0]),
                "{end} {at:?}"
            );
        }
    }
}
