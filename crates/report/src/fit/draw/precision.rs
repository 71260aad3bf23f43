//! First figure of the fit page: relative standard error of each coefficient.

use model_spec::sort_by_number;

use super::super::FitPage;
use super::not_drawn;
use crate::bands::std_error;
use crate::figure::Figure;
use crate::figures::Layout;
use crate::figures::chart::{Axis, Chart, Row, Shape};
use identify::numbers::percent;

/// Minimum and maximum of the chart axis on which relative standard errors are drawn, %.
const AXIS: (f64, f64) = (0.1, 1e3);
/// Maximum number of coefficients whose relative standard errors are drawn, one chart row each.
const MAX_ROWS: usize = 24;

/// Draws the relative standard error of each estimated coefficient, the smallest first; `None` if no coefficient was
/// estimated.
pub(in super::super) fn precision(page: &FitPage<'_>) -> Option<Figure> {
    let found = page.coefficients().into_iter();
    let sizes = found.map(|(name, c)| (name, c, std_error(c) / c.value.abs()));
    let mut sizes: Vec<_> = sizes
        .filter(|(_, c, size)| !c.fixed && size.is_finite())
        .collect();
    sort_by_number(&mut sizes, |size| size.2);
    let left_out = sizes.len().saturating_sub(MAX_ROWS);
    sizes.truncate(MAX_ROWS);
    if sizes.is_empty() {
        return None;
    }
    let row = |(name, _, size): &(&str, &identify::Coefficient, f64)| {
        let class = if *size < 1.0 { "bar" } else { "bar loose" };
        Row {
            name: (*name).to_owned(),
            class: "tick",
            shapes: vec![Shape::Bar((1e2 * size).clamp(AXIS.0, AXIS.1), class)],
            words: percent(*size),
        }
    };
    let chart = Chart {
        title: "Precision of each coefficient".into(),
        legend: Vec::new(),
        rows: sizes.iter().map(row).collect(),
        axis: Axis::Log(AXIS.0),
        across: "standard error, % of the value".into(),
        level: Some((100.0, "as large as the value".into())),
    };
    let more = not_drawn(left_out, "less precise ones");
    let caption = format!(
        "Short bars: well determined. A bar up to the broken line: the standard error is {} of the value, so that not even the \
         sign is known. The larger of the two kinds of standard error is drawn.{more}",
        percent(1.0)
    );
    let (wide, texts) = (Layout::COLUMN, [caption, chart.csv()]);
    let draw = |layout| chart.draw(layout);
    Some(Figure::in_layouts(
        "precision",
        &chart.title,
        texts,
        wide,
        &draw,
    ))
}
