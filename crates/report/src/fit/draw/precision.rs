//! First figure of the fit page: relative standard error of each coefficient.

use identify::Coefficient;
use identify::numbers::percent;
use model_spec::sort_by_number;

use super::super::FitPage;
use super::not_drawn;
use crate::bands::std_error;
use crate::figure::Figure;
use crate::figures::Layout;
use crate::figures::chart::{Axis, Chart, Row, Shape};
use crate::thin::MAX_FIGURES;

/// Minimum and maximum of the chart axis on which relative standard errors are drawn, %.
const AXIS: (f64, f64) = (0.1, 1e3);

/// Draws the relative standard error of each estimated coefficient, the smallest first; `None` if no coefficient was
/// estimated.
pub(in super::super) fn precision(page: &FitPage<'_>) -> Option<Figure> {
    let size = |c: &Coefficient| std_error(c) / c.value.abs();
    let mut found = page.coefficients();
    found.retain(|(_, c)| !c.fixed && size(c).is_finite());
    sort_by_number(&mut found, |(_, c)| size(c));
    let left_out = found.len().saturating_sub(MAX_FIGURES);
    let rows = found.iter().take(MAX_FIGURES).map(|(name, c)| {
        let size = size(c);
        let class = if size < 1.0 { "bar" } else { "bar loose" };
        let bar = Shape::Bar((1e2 * size).clamp(AXIS.0, AXIS.1), class);
        Row::new(name, "tick", vec![bar]).words(percent(size))
    });
    let (title, across) = (
        "Precision of each coefficient",
        "standard error, % of the value",
    );
    let chart = Chart {
        level: Some((100.0, "as large as the value".into())),
        ..Chart::new(title, rows.collect(), Axis::Log(AXIS.0), across)
    };
    let more = not_drawn(left_out, "less precise ones");
    let caption = format!(
        "Short bars: well determined. A bar up to the broken line: the standard error is {} of the value, so that not even the \
         sign is known. The larger of the two kinds of standard error is drawn.{more}",
        percent(1.0)
    );
    let draw = || Figure::of_chart("precision", &chart, &caption, Layout::COLUMN);
    (!chart.rows.is_empty()).then(draw)
}
