//! First figure of the page: illustration of the main finding.

use diagnose::{CandidateTest, Report, Verdict};
use model_spec::sort_by_number;

use super::super::words;
use super::curve::Curve;
use crate::figure::Figure;
use crate::figures::chart::{Axis, Chart, Row, Shape};
use crate::figures::{Bar, Layout, Line, Panel, symbol};
use identify::numbers::{Digits, equivalent_z, unit, with_unit};

/// File name, without suffix, of the figure in the opening section of the diagnosis report.
const NAME: &str = "finding";
/// Maximum number of rows of a chart in the opening section of the diagnosis report; each row is for a coefficient or a
/// candidate effect.
const MAX_ROWS: usize = 10;
/// Half width of a 95 % confidence interval, in standard errors.
const WIDTH_95: f64 = 1.96;

/// Draws the quantity of `curve` in the model under test and in the extended model, over the variable on which the
/// quantity depends. The 95 % confidence band of the extended model and the number of samples are drawn as well.
pub(super) fn curve(curve: &Curve) -> Figure {
    let line = |name: &str, of: fn(&super::curve::Point) -> f64| Line {
        name: name.into(),
        points: curve.points.iter().map(|p| (p.x, of(p))).collect(),
    };
    let mut lines = vec![line("extended", |p| p.after)];
    if curve.points.iter().any(|p| p.before.is_finite()) {
        lines.push(line("before", |p| p.before));
    }
    let band = curve.points.iter().map(|p| {
        let half = WIDTH_95 * p.error;
        (p.x, p.after - half, p.after + half)
    });
    let band: Vec<(f64, f64, f64)> = band.collect();
    let over = symbol(&curve.over);
    let across = match curve.over_doc.as_str() {
        "" => with_unit(&over, &curve.over_unit),
        doc => with_unit(&format!("{doc} {over}"), &curve.over_unit),
    };
    let samples = curve.points.iter().map(|p| (p.x, p.samples as f64));
    let panels = [
        Panel {
            title: with_unit(&curve.quantity, &curve.unit),
            lines,
            ribbon: band,
            height: Some(190.0),
            ..Panel::default()
        },
        Panel {
            title: "Samples".into(),
            across,
            bars: Bar::between_midpoints(&samples.collect::<Vec<_>>()),
            height: Some(44.0),
            ..Panel::default()
        },
    ];
    let title = format!("{} over {over}", curve.quantity);
    let caption = "Before: the model as it was, fitted. Extended: with the effect, fitted; shaded: its 95\u{a0}% band from \
                   the covariance of the fit, mostly narrower than the line. Below: how many samples of the fitted flights support each part.";
    Figure::of_panels(NAME, &title, caption, Layout::COLUMN, &panels)
}

/// Draws the estimated coefficients of the hypothesis that fits best, in units of their smallest effect sizes of
/// interest if all are declared, otherwise in standard errors. `None` if there are no estimates.
pub(super) fn estimates(report: &Report) -> Option<Figure> {
    let effects = report.explanations.first()?.effects.iter();
    let all = effects.flat_map(|e| &e.estimates);
    let all: Vec<_> = all
        .filter(|(_, e)| e.value.is_finite() && e.std_error > 0.0)
        .take(MAX_ROWS)
        .collect();
    let interest = |e: &diagnose::Estimate| e.smallest_effect_of_interest.filter(|s| *s > 0.0);
    let by_interest = !all.is_empty() && all.iter().all(|(_, e)| interest(e).is_some());
    let rows = all.iter().map(|(name, e)| {
        let scale = if by_interest {
            interest(e).unwrap_or(e.std_error)
        } else {
            e.std_error
        };
        let (value, half) = (e.value.abs() / scale, WIDTH_95 * e.std_error / scale);
        let digits = Digits::of(e.value, e.std_error);
        Row {
            name: (*name).clone(),
            class: "strong",
            shapes: vec![
                Shape::Span((value - half).max(0.0), value + half, "reach"),
                Shape::Dot(value, "after"),
            ],
            words: format!("{} {}", digits.one(e.value), unit(&e.unit)),
        }
    });
    let rows: Vec<Row> = rows.collect();
    if rows.is_empty() {
        return None;
    }
    let (across, level) = if by_interest {
        (
            "size, in units of the smallest size of interest",
            (1.0, "of interest".to_owned()),
        )
    } else {
        (
            "size, in standard errors",
            (report.threshold.z, "significant".to_owned()),
        )
    };
    let chart = Chart {
        title: "Size of the effect".into(),
        legend: Vec::new(),
        rows,
        axis: Axis::Sizes,
        across: across.into(),
        level: Some(level),
    };
    let caption = "Dot and bar: the estimate, without its sign, and its 95\u{a0}% interval; at 0 the effect is absent.";
    Some(Figure::of_chart(NAME, &chart, caption, Layout::COLUMN))
}

/// Draws the most significant score tests of candidate effects with the significance threshold; `None` if there are no
/// candidates.
pub(super) fn strongest(report: &Report) -> Option<Figure> {
    let mut all: Vec<&CandidateTest> = report.tests.iter().collect();
    all.retain(|c| c.z.is_finite());
    sort_by_number(&mut all, |test| -test.z);
    all.truncate(MAX_ROWS);
    if all.is_empty() {
        return None;
    }
    let rows = all.iter().map(|c| {
        let bar = if c.significant {
            "bar alarm"
        } else {
            "bar calm"
        };
        Row {
            name: words::readable(&c.name),
            class: "tick",
            shapes: vec![Shape::Bar(c.z.max(0.0), bar)],
            words: equivalent_z(c.z),
        }
    });
    let chart = Chart {
        title: "The strongest signs of a missing effect".into(),
        legend: Vec::new(),
        rows: rows.collect(),
        axis: Axis::Sizes,
        across: "equivalent z".into(),
        level: Some((report.threshold.z, "significant".into())),
    };
    let caption = match report.verdict {
        Verdict::Adequate => {
            "The effects with the largest test statistics; none reaches the threshold."
        }
        _ => "The effects with the largest test statistics.",
    };
    Some(Figure::of_chart(NAME, &chart, caption, Layout::COLUMN))
}
