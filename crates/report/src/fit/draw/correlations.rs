//! Figure of the correlation matrix of the estimated coefficients.

use super::super::FitPage;
use crate::figure::Figure;
use crate::figures::Layout;
use crate::figures::csv::Table;
use crate::figures::svg::{Svg, cut};
use identify::numbers::plain;

const WIDTH: f64 = 360.0;
const LETTERS: f64 = 13.0;
/// Maximum number of coefficients in the drawn correlation matrix.
const MAX_COEFFICIENTS: usize = 40;
/// Maximum number of coefficients for which the correlations are printed in the cells of the matrix.
const MAX_WRITTEN: usize = 12;
/// Maximum number of coefficients for which the diagonal of the drawn matrix shows their names; for more coefficients,
/// it shows their row indices.
const MAX_NAMED: usize = 8;

/// Draws the lower triangle of the correlation matrix of the estimated coefficients; `None` for fewer than two.
pub(in super::super) fn correlations(page: &FitPage<'_>) -> Option<Figure> {
    let report = page.report;
    let estimated = |name: &&String| report.coefficients.get(*name).is_none_or(|c| !c.fixed);
    let mut names: Vec<&String> = report.correlations.keys().filter(estimated).collect();
    names.sort_by_key(|name| page.place(name));
    let names = &names[..names.len().min(MAX_COEFFICIENTS)];
    if names.len() < 2 {
        return None;
    }
    // For few coefficients, the diagonal shows their names; otherwise the columns are numbered there.
    let named = names.len() <= MAX_NAMED;
    let label = |i: usize| match named {
        true => names[i].clone(),
        false => format!("{} {}", names[i], i + 1),
    };
    let longest = names.iter().map(|n| n.chars().count()).max().unwrap_or(0) as f64;
    let letter = 0.7 * LETTERS;
    let room = |letters: f64| (10.0 + letter * letters).min(120.0);
    let left = room(longest + if named { 0.0 } else { 3.0 });
    let top = 44.0;
    let mut side = ((WIDTH - left - 4.0) / names.len() as f64).min(44.0);
    if named {
        // The last diagonal name is printed at the right of the last but one row and needs space.
        side = side.min((WIDTH - left - room(longest)) / (names.len() - 1) as f64);
    }
    let mut svg = Svg::new();
    svg.text("title", (2.0, 26.0), "start", "Correlations");
    let rows = side.max(LETTERS + 2.0);
    for (i, row) in names.iter().enumerate() {
        let y = top + rows * i as f64;
        let (base, across) = (y + 0.5 * rows, |j: usize| left + side * j as f64);
        let size = (side - 1.0, rows - 1.0);
        let name = cut(&label(i), left - 9.0, letter);
        svg.text("tick", (left - 8.0, base + 5.0), "end", &name);
        for (j, column) in names.iter().take(i).enumerate() {
            let found = report.correlations.get(*row).and_then(|r| r.get(*column));
            let value = found.copied().unwrap_or(f64::NAN);
            svg.cell(&colour(value), (across(j), y), size);
            if names.len() <= MAX_WRITTEN {
                let class = if value.abs() > 0.65 { "pale" } else { "dark" };
                let class = format!("{class} cell{}", if side > 34.0 { "" } else { " little" });
                let place = (across(j) + 0.5 * side - 0.5, base + 4.0);
                svg.text(&class, place, "middle", &short(value, side));
            }
        }
        svg.cell("#c9ccd1", (across(i), y), size);
        if named && i + 1 < names.len() {
            let place = (across(i + 1) + 5.0, base + 5.0);
            let name = cut(row, WIDTH - place.0 - 2.0, letter);
            svg.text("tick", place, "start", &name);
        } else if !named && side > 14.0 {
            let place = (across(i) + 0.5 * side - 0.5, base + 4.0);
            svg.text("dark cell little", place, "middle", &(i + 1).to_string());
        }
    }
    let bottom = top + rows * names.len() as f64 + 14.0;
    scale(&mut svg, left, bottom);
    let title = "Correlations of the coefficients";
    let text = svg.finish(title, (WIDTH, bottom + 36.0), 460.0, LETTERS);
    let caption = "Of the estimation errors of two coefficients: near ±1 only a combination of the two is identifiable.";
    let mut table = Table::new(&["row", "column", "correlation"]);
    for (i, row) in names.iter().enumerate() {
        for column in names.iter().take(i) {
            let found = report.correlations.get(*row).and_then(|r| r.get(*column));
            table.text(row).text(column).optional(found.copied()).end();
        }
    }
    let texts = [caption.into(), table.finish()];
    Some(Figure::in_layouts(
        "correlations",
        title,
        texts,
        Layout::SMALL,
        &|_| text.clone(),
    ))
}

/// Draws the colour scale for correlations from −1 to 1, with its upper left corner at (`left`, `top`), SVG units.
fn scale(svg: &mut Svg, left: f64, top: f64) {
    let steps = 40;
    let wide = (WIDTH - left - 30.0) / f64::from(steps);
    for i in 0..steps {
        let value = -1.0 + 2.0 * (f64::from(i) + 0.5) / f64::from(steps);
        svg.cell(
            &colour(value),
            (left + wide * f64::from(i), top),
            (wide + 0.2, 8.0),
        );
    }
    for (value, text) in [(-1.0, "−1"), (0.0, "0"), (1.0, "1")] {
        let x = left + 0.5 * (value + 1.0) * wide * f64::from(steps);
        svg.text("tick", (x, top + 23.0), "middle", text);
    }
}

/// Formats a correlation without a leading zero, such as `−.87`, for a cell of width `side`, SVG units.
fn short(value: f64, side: f64) -> String {
    let text = plain(value, if side < 27.0 { 1 } else { 2 });
    text.replacen("0.", ".", 1)
}

/// Colour of a cell of the correlation matrix: from blue (−1) through white (0) to orange (1), distinguishable for the
/// colour-blind; grey if not finite.
fn colour(value: f64) -> String {
    if !value.is_finite() {
        return "#bbb".to_owned();
    }
    let (end, middle) = if value < 0.0 {
        ([5.0, 80.0, 150.0], [246.0, 246.0, 246.0])
    } else {
        ([178.0, 72.0, 0.0], [246.0, 246.0, 246.0])
    };
    let part = value.abs().min(1.0);
    let mix = |i: usize| (middle[i] + (end[i] - middle[i]) * part).round() as u8;
    format!("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2))
}
