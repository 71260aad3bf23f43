//! Figure of the correlation matrix of the estimated coefficients.

use super::super::FitPage;
use crate::figure::Figure;
use crate::figures::Layout;
use crate::figures::triangle::Triangle;

/// Maximum number of coefficients in the drawn correlation matrix.
const MAX_COEFFICIENTS: usize = 40;

/// Draws the lower triangle of the correlation matrix of the estimated coefficients; `None` for fewer than two.
pub(in super::super) fn correlations(page: &FitPage<'_>) -> Option<Figure> {
    let report = page.report;
    let estimated = |name: &&str| report.coefficients.get(*name).is_none_or(|c| !c.fixed);
    let names = report.correlations.keys().map(String::as_str);
    let mut names: Vec<&str> = names.filter(estimated).collect();
    names.sort_by_key(|name| page.place(name));
    names.truncate(MAX_COEFFICIENTS);
    let order = names.clone();
    let value = |i: usize, j: usize| {
        let row = report.correlations.get(order[i]);
        let value = row.and_then(|row| row.get(order[j]));
        value.copied().unwrap_or(f64::NAN)
    };
    let triangle = Triangle {
        title: "Correlations of the coefficients",
        names,
        is_strong: &|_| false,
        value: &value,
        is_signed: true,
        ends: ["−1", "1"],
    };
    let caption = "Of the estimation errors of two coefficients: near ±1 only a combination of the two is identifiable. The row of \
                   a coefficient is left of its name, its column below it.";
    let draw = || Figure::of_triangle("correlations", &triangle, caption, Layout::SMALL);
    (order.len() > 1).then(draw)
}
