//! Figure of the correlations between the effective scores of candidate effects, as a triangular matrix.

use diagnose::Report;
use model_spec::sort_by_number;

use crate::figure::Figure;
use crate::figures::Layout;
use crate::figures::csv::Table;
use crate::figures::svg::{Svg, cut};

/// Maximum number of coefficients in the drawn matrix of score correlations.
const MAX_COEFFICIENTS: usize = 25;
/// Number of steps of the colour scale in the legend of the score correlations.
const STEPS: usize = 40;

/// Draws the correlations between the effective scores of the coefficients of the most significant candidate effects;
/// `None` for fewer than two coefficients.
pub(super) fn score_correlations(report: &Report) -> Option<Figure> {
    let all = &report.score_correlations.names;
    let order = strongest(report);
    let left_out = all.len().saturating_sub(order.len());
    if order.len() < 2 {
        return None;
    }
    let title = "Correlations of effect signatures";
    let caption = format!(
        "Each square: the absolute correlation of the signatures of two coefficients of effects in these flights, \
         adjusted for initial states and the model’s own coefficients. The row of an effect is left of its name and its \
         column below it; these flights hardly distinguish pairs of strong colour. {}",
        match left_out {
            0 => "The most significant are first.".to_owned(),
            n => format!(
                "The {} most significant are drawn, of {}.",
                order.len(),
                order.len() + n
            ),
        }
    );
    let mut table = Table::new(&["row", "column", "correlation"]);
    for (i, &row) in order.iter().enumerate() {
        for &column in &order[..i] {
            let value = report.score_correlations.matrix.get(row);
            let value = value.and_then(|row| row.get(column)).copied();
            table
                .text(&all[row])
                .text(&all[column])
                .optional(value)
                .end();
        }
    }
    let texts = [caption, table.finish()];
    Some(Figure::in_layouts(
        "alike",
        title,
        texts,
        Layout::COLUMN,
        &|layout| draw(report, &order, title, layout),
    ))
}

/// Indices, in the score correlation matrix of the report, of the coefficients of the most significant effects, in
/// descending order of significance; at most [`MAX_COEFFICIENTS`].
fn strongest(report: &Report) -> Vec<usize> {
    let equivalent_z = |name: &String| {
        let owner = report
            .tests
            .iter()
            .find(|c| c.one_step_estimates.contains_key(name));
        let size = owner.map_or(f64::NEG_INFINITY, |c| c.z);
        if size.is_nan() {
            f64::NEG_INFINITY
        } else {
            size
        }
    };
    let names = report.score_correlations.names.iter().enumerate();
    let mut order: Vec<(f64, usize)> = names.map(|(i, name)| (equivalent_z(name), i)).collect();
    sort_by_number(&mut order, |pair| -pair.0);
    order.truncate(MAX_COEFFICIENTS);
    order.into_iter().map(|(_, i)| i).collect()
}

fn draw(report: &Report, order: &[usize], title: &str, layout: Layout) -> String {
    let (letters, letter) = (layout.letters, 1.02 * layout.letter());
    let names: Vec<&String> = order
        .iter()
        .map(|i| &report.score_correlations.names[*i])
        .collect();
    let longest = names.iter().map(|n| n.chars().count()).max().unwrap_or(0) as f64;
    let room = (letter * longest + 8.0).min(0.44 * layout.width);
    // The label at the end of a row is also the label of the column below it.
    let side = ((layout.width - room - 8.0) / (names.len() - 1) as f64).min(34.0);
    let tall = side.max(letters + 3.0);
    let (left, top) = (4.0, 2.0 * letters + 14.0);
    let effects = || {
        report
            .explanations
            .iter()
            .flat_map(|explanation| &explanation.effects)
    };
    let named = |name: &str| effects().any(|e| e.estimates.contains_key(name));
    let mut svg = Svg::new();
    svg.text("title", (2.0, 2.0 * letters), "start", title);
    for (i, name) in names.iter().enumerate() {
        let y = top + tall * i as f64;
        for (j, column) in order.iter().take(i).enumerate() {
            let row = report.score_correlations.matrix.get(order[i]);
            let value = row
                .and_then(|row| row.get(*column))
                .copied()
                .unwrap_or(f64::NAN);
            let place = (left + side * j as f64, y);
            shade(&mut svg, value, place, (side - 1.0, tall - 1.0));
        }
        let x = left + side * i as f64 + 4.0;
        let class = if named(name) { "strong" } else { "tick" };
        let name = cut(name, layout.width - x - 2.0, letter);
        svg.text(class, (x, y + 0.5 * tall + 0.33 * letters), "start", &name);
    }
    let bottom = top + tall * names.len() as f64 + 12.0;
    let wide = (0.6 * layout.width).min(260.0) / STEPS as f64;
    for i in 0..STEPS {
        let place = (left + wide * i as f64, bottom);
        shade(
            &mut svg,
            (i as f64 + 0.5) / STEPS as f64,
            place,
            (wide, 8.0),
        );
    }
    let end = left + wide * STEPS as f64;
    for (x, anchor, text) in [(left, "start", "0: distinct"), (end, "end", "1: identical")] {
        svg.text("tick", (x, bottom + 10.0 + letters), anchor, text);
    }
    svg.finish(
        title,
        (layout.width, bottom + 22.0 + letters),
        layout.most,
        letters,
    )
}

/// Draws a cell of the correlation matrix with the given size and its upper left corner at `place`, SVG units. Its
/// opacity increases with the absolute correlation `value`; a value that is not finite is shown in a separate colour.
fn shade(svg: &mut Svg, value: f64, place: (f64, f64), size: (f64, f64)) {
    if value.is_finite() {
        svg.veil("alike", 0.05 + 0.95 * value.abs().min(1.0), place, size);
    } else {
        svg.block("unknown", place, size);
    }
}
