//! Figures of coefficient curves without and with the extension, with the number of samples in each interval.

use diagnose::{CoefficientCurve, Report};

use super::super::DiagnosisPage;
use crate::figure::Figure;
use crate::figures::{Layout, Panel, samples_below, symbol};
use crate::thin::{MAX_CURVE_POINTS, MAX_FIGURES};
use identify::numbers::with_unit;

/// Whether the added effects change a curve, by more than rounding.
fn moves(curve: &CoefficientCurve) -> bool {
    let sizes = curve.before.iter().map(|v| v.abs());
    let largest = sizes.filter(|v| v.is_finite()).fold(0.0, f64::max);
    let mut pairs = curve.before.iter().zip(&curve.after);
    pairs.any(|(b, a)| (a - b).abs() > 1e-9 * largest)
}

/// Draws the curves that have points; those that the added effects change come first.
pub(in super::super) fn curves(report: &Report) -> Vec<Figure> {
    let curves = report.curves.iter().filter(|c| !c.x.is_empty());
    let mut curves: Vec<&CoefficientCurve> = curves.collect();
    curves.sort_by_key(|c| !moves(c));
    let figures = curves.into_iter().take(MAX_FIGURES).enumerate();
    figures.map(|(i, curve)| figure(i, curve)).collect()
}

fn title(curve: &CoefficientCurve) -> String {
    format!("{} over {}", curve.quantity, symbol(&curve.over))
}

fn figure(index: usize, curve: &CoefficientCurve) -> Figure {
    let points = |values: &[f64]| {
        let all = curve.x.iter().copied().zip(values.iter().copied());
        let all = all.filter(|p| p.0.is_finite()).take(MAX_CURVE_POINTS);
        all.collect::<Vec<_>>()
    };
    let across = with_unit(&symbol(&curve.over), &curve.unit);
    let panel = Panel::new(&curve.quantity, "");
    // The dashed line is drawn over the solid one, so that both are visible if they coincide.
    let (mut panel, same) = if moves(curve) {
        let panel = panel.line("extended", points(&curve.after));
        (panel.line("before", points(&curve.before)), "Without")
    } else {
        (panel.line("", points(&curve.before)), "The same without")
    };
    let support = curve.support.iter().map(|n| *n as f64);
    let support = points(&support.collect::<Vec<_>>());
    let panels = if support.len() < 2 || !support.is_sorted_by(|a, b| a.0 < b.0) {
        panel.across = across;
        vec![panel]
    } else {
        vec![panel, samples_below(across, &support)]
    };
    let caption = format!("{same} and with the extension; below, the number of samples.");
    let name = format!("curve-{:02}", index + 1);
    Figure::of_panels(name, &title(curve), caption, Layout::SMALL, &panels)
}

/// Titles of the curves that the added effects do not change; empty if they change no curve at all.
pub(in super::super) fn unmoved(page: &DiagnosisPage<'_>) -> Vec<String> {
    let curves = &page.report.curves;
    if !curves.iter().any(moves) {
        return Vec::new();
    }
    curves.iter().filter(|c| !moves(c)).map(title).collect()
}
