//! First figure of the page: illustration of the main finding.

use diagnose::{Estimate, Report, Verdict};

use super::super::draw::chart_of_tests;
use super::curve::{Curve, Point};
use crate::bands::WIDTH_95;
use crate::figure::Figure;
use crate::figures::chart::{Axis, Chart, Row, Shape};
use crate::figures::{Layout, Panel, samples_below, symbol};
use identify::numbers::{Digits, unit, with_unit};

const NAME: &str = "finding";
const MAX_ROWS: usize = 10;

/// The quantity in both models, with the 95 % band of the extended one and the number of samples.
pub(super) fn curve(curve: &Curve) -> Figure {
    let points = |of: fn(&Point) -> f64| curve.points.iter().map(move |p| (p.x, of(p)));
    let title = with_unit(&curve.quantity.name, &curve.quantity.unit);
    let mut panel = Panel::new(title, "").line("extended", points(|p| p.after));
    if curve.points.iter().any(|p| p.before.is_finite()) {
        panel = panel.line("before", points(|p| p.before));
    }
    let band = curve.points.iter().map(|p| {
        let half = WIDTH_95 * p.error;
        (p.x, p.after - half, p.after + half)
    });
    panel.ribbon = band.collect();
    panel.height = Some(190.0);
    let over = symbol(&curve.over.name);
    let across = match curve.over.doc.as_str() {
        "" => with_unit(&over, &curve.over.unit),
        doc => with_unit(&format!("{doc} {over}"), &curve.over.unit),
    };
    let samples: Vec<(f64, f64)> = points(|p| p.samples as f64).collect();
    let panels = [panel, samples_below(across, &samples)];
    let title = format!("{} over {over}", curve.quantity.name);
    let caption = "Before: the model as it was, fitted. Extended: with the effect, fitted; shaded: its 95\u{a0}% band from \
                   the covariance of the fit, mostly narrower than the line. Below: how many samples of the fitted flights support each part.";
    Figure::of_panels(NAME, &title, caption, Layout::COLUMN, &panels)
}

/// Estimates of the best explanation, in units of their smallest sizes of interest or standard errors.
pub(super) fn estimates(report: &Report) -> Option<Figure> {
    let effects = report.explanations.first()?.effects.iter();
    let all = effects.flat_map(|e| &e.estimates);
    let all = all.filter(|(_, e)| e.value.is_finite() && e.std_error > 0.0);
    let all: Vec<_> = all.take(MAX_ROWS).collect();
    if all.is_empty() {
        return None;
    }
    let interest = |e: &Estimate| e.smallest_effect_of_interest.filter(|s| *s > 0.0);
    let by_interest = all.iter().all(|(_, e)| interest(e).is_some());
    let rows = all.iter().map(|(name, e)| {
        let scale = interest(e).filter(|_| by_interest).unwrap_or(e.std_error);
        let (value, half) = (e.value.abs() / scale, WIDTH_95 * e.std_error / scale);
        let shapes = vec![
            Shape::Span((value - half).max(0.0), value + half, "reach"),
            Shape::Dot(value, "after"),
        ];
        let value = Digits::of(e.value, e.std_error).one(e.value);
        Row::new(name, "strong", shapes).words(format!("{value} {}", unit(&e.unit)))
    });
    let (across, level, name) = if by_interest {
        let across = "size, in units of the smallest size of interest";
        (across, 1.0, "of interest")
    } else {
        let across = "size, in standard errors";
        (across, report.threshold.z, "significant")
    };
    let chart = Chart {
        level: Some((level, name.to_owned())),
        ..Chart::new("Size of the effect", rows.collect(), Axis::Sizes, across)
    };
    let caption = "Dot and bar: the estimate, without its sign, and its 95\u{a0}% interval; at 0 the effect is absent.";
    Some(Figure::of_chart(NAME, &chart, caption, Layout::COLUMN))
}

pub(super) fn strongest(report: &Report) -> Option<Figure> {
    let title = "The strongest signs of a missing effect";
    let chart = chart_of_tests(report, title, MAX_ROWS)?;
    let none = match report.verdict {
        Verdict::Adequate => "; none reaches the threshold",
        _ => "",
    };
    let caption = format!("The effects with the largest test statistics{none}.");
    Some(Figure::of_chart(NAME, &chart, &caption, Layout::COLUMN))
}
