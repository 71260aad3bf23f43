//! Figures of coefficient curves without and with the extension, with the number of samples in each interval.

use diagnose::{CoefficientCurve, Report};

use super::super::DiagnosisPage;
use crate::figure::Figure;
use crate::figures::{Bar, Layout, Line, Panel, symbol};
use crate::thin::MAX_CURVE_POINTS;
use identify::numbers::with_unit;

/// Maximum number of coefficient curves drawn in the report.
const MAX_CURVES: usize = 24;

/// Whether the effects that the diagnosis added to the model change the coefficient curve, by more than rounding.
fn moves(curve: &CoefficientCurve) -> bool {
    let largest = curve
        .before
        .iter()
        .filter(|v| v.is_finite())
        .fold(0.0, |a: f64, v| a.max(v.abs()));
    let mut pairs = curve.before.iter().zip(&curve.after);
    pairs.any(|(b, a)| (a - b).abs() > 1e-9 * largest)
}

/// Draws each coefficient curve that has points; curves that the effects added to the model change come first.
pub(super) fn curves(report: &Report) -> Vec<Figure> {
    let mut curves: Vec<&CoefficientCurve> =
        report.curves.iter().filter(|c| !c.x.is_empty()).collect();
    curves.sort_by_key(|c| !moves(c));
    let figures = curves.into_iter().take(MAX_CURVES).enumerate();
    figures.map(|(i, curve)| figure(i, curve)).collect()
}

fn figure(index: usize, curve: &CoefficientCurve) -> Figure {
    let points = |values: &[f64]| {
        let all = curve.x.iter().copied().zip(values.iter().copied());
        all.filter(|p| p.0.is_finite())
            .take(MAX_CURVE_POINTS)
            .collect::<Vec<_>>()
    };
    let line = |name: &str, values: &[f64]| Line {
        name: name.into(),
        points: points(values),
    };
    let over = symbol(&curve.over);
    let across = with_unit(&over, &curve.unit);
    let bars = bars(curve);
    let moved = moves(curve);
    let lines = if moved {
        // The dashed line is drawn over the solid one, so that both are visible if they coincide.
        vec![
            line("extended", &curve.after),
            line("before", &curve.before),
        ]
    } else {
        vec![line("", &curve.before)]
    };
    let title = format!("{} over {over}", curve.quantity);
    let mut panels = vec![Panel {
        title: curve.quantity.clone(),
        across: if bars.is_empty() {
            across.clone()
        } else {
            String::new()
        },
        lines,
        ..Panel::default()
    }];
    if !bars.is_empty() {
        panels.push(Panel {
            title: "Samples".into(),
            across,
            bars,
            height: Some(44.0),
            ..Panel::default()
        });
    }
    let caption = if moved {
        "Without and with the extension; below, the number of samples."
    } else {
        "The same without and with the extension; below, the number of samples."
    };
    let name = format!("curve-{:02}", index + 1);
    Figure::of_panels(name, &title, caption, Layout::SMALL, &panels)
}

/// Histogram bars of the number of samples along the abscissa of the coefficient curve; empty for fewer than two
/// points.
fn bars(curve: &CoefficientCurve) -> Vec<Bar> {
    let points = curve.x.iter().zip(&curve.support).take(MAX_CURVE_POINTS);
    let points: Vec<(f64, f64)> = points
        .map(|(x, n)| (*x, *n as f64))
        .filter(|p| p.0.is_finite())
        .collect();
    if points.len() < 2 || !points.is_sorted_by(|a, b| a.0 < b.0) {
        return Vec::new();
    }
    Bar::between_midpoints(&points)
}

/// Titles, such as `C_D over α`, of the coefficient curves that the effects added to the model do not change; empty if
/// they change no curve at all.
pub(in super::super) fn unmoved(page: &DiagnosisPage<'_>) -> Vec<String> {
    let curves = &page.report.curves;
    if !curves.iter().any(moves) {
        return Vec::new();
    }
    let still = curves.iter().filter(|c| !moves(c));
    still
        .map(|c| format!("{} over {}", c.quantity, symbol(&c.over)))
        .collect()
}
