//! Figure of the RMS residual of each fitted flight without and with the extension of the model.

use dataset::Role;
use diagnose::{FlightGain, Report};
use model_spec::sort_by_number;

use super::gain::row;
use crate::figure::Figure;
use crate::figures::chart::{Chart, Row, Shape, axis_for};
use crate::figures::{Dots, Layout, Line, Look, Panel};
use crate::thin::stride;

/// Maximum number of flights drawn as one chart row each; more flights are drawn as dots in order of their residual.
const MAX_ROWS: usize = 16;
/// Maximum number of flights drawn as dots. Each flight has two dots, so that a figure has at most twice as many dots.
const MAX_DOTS: usize = 2000;

/// Draws the RMS residuals of the fitted flights, without and with the effects added to the model; `None` if no effect
/// was added.
pub(super) fn flights(report: &Report) -> Option<Figure> {
    let fitted = report.flights.iter();
    let fitted = fitted.filter(|f| f.role == Role::Fit && f.rms_after_m.is_some());
    let fitted: Vec<&FlightGain> = fitted.collect();
    if fitted.is_empty() {
        return None;
    }
    let title = "Fitted flights";
    if fitted.len() > MAX_ROWS {
        return Some(ranked(title, &fitted, 1e3 * report.leading_noise().sigma));
    }
    let rows: Vec<Row> = fitted.iter().map(|f| row(f)).collect();
    let values = fitted.iter().flat_map(|f| [f.rms_before_m, f.rms_after_m]);
    let chart = Chart {
        title: title.into(),
        legend: vec![
            (Shape::Dot(0.0, "before"), "before".into()),
            (Shape::Dot(0.0, "after"), "extended".into()),
        ],
        rows,
        axis: axis_for(
            values
                .flatten()
                .map(|rms| 1e3 * rms)
                .chain([1e3 * report.leading_noise().sigma]),
        ),
        across: "RMS residual, mm".into(),
        level: Some((1e3 * report.leading_noise().sigma, "noise".into())),
    };
    let caption = "RMS residuals of the fitted flights, without and with the extension.";
    Some(Figure::of_chart("flights", &chart, caption, Layout::SMALL))
}

/// Draws two dots for each flight: its RMS residuals without and with the effects added to the model. Flights are
/// ordered by the residual without these effects; `noise` is the RMS measurement noise, mm.
fn ranked(title: &str, fitted: &[&FlightGain], noise: f64) -> Figure {
    let sizes = fitted
        .iter()
        .filter_map(|f| Some((1e3 * f.rms_before_m?, 1e3 * f.rms_after_m?)));
    let mut sizes: Vec<(f64, f64)> = sizes
        .filter(|s| s.0.is_finite() && s.1.is_finite())
        .collect();
    sort_by_number(&mut sizes, |size| size.0);
    let last = sizes.len() as f64;
    let ranks = sizes
        .iter()
        .enumerate()
        .map(|(i, s)| (i as f64 + 1.0, s.0, s.1));
    let ranks = stride(&ranks.collect::<Vec<_>>(), MAX_DOTS);
    let before: Vec<(f64, f64)> = ranks
        .iter()
        .map(|(rank, before, _)| (*rank, *before))
        .collect();
    let after: Vec<(f64, f64)> = ranks
        .iter()
        .map(|(rank, _, after)| (*rank, *after))
        .collect();
    let largest = sizes
        .iter()
        .map(|s| s.0.max(s.1))
        .chain([noise])
        .filter(|v| v.is_finite());
    let largest = largest.fold(1e-6, f64::max);
    // A line of a single point shows only its label.
    let name = |name: &str, points: &[(f64, f64)]| Line {
        name: name.into(),
        points: points.last().map(|p| (last, p.1)).into_iter().collect(),
    };
    let dots = |colour, points| Dots {
        look: Look::Colour(colour),
        points,
    };
    let panel = Panel {
        title: "RMS residual, mm".into(),
        across: "flights in order of their RMS residual before".into(),
        lines: vec![name("extended", &after), name("before", &before)],
        dots: vec![dots(1, before), dots(0, after)],
        levels: vec![noise],
        up: Some((0.0, 1.05 * largest)),
        ..Panel::default()
    };
    let caption =
        "RMS residuals of the fitted flights, two dots per flight; the broken line is the noise.";
    Figure::of_panels("flights", title, caption, Layout::SMALL, &[panel])
}
