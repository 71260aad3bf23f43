//! How far each fitted flight is missed before and after.

use diagnose::report::{FlightGain, Report};
use identify::dataset::Role;

use super::drawn;
use super::gain::row;
use super::rows::{Chart, Row, Shape, axis_for};
use crate::figures::{Dots, Layout, Look, Panel, figure_of};
use crate::fit::Drawn;
use crate::fit::thin::stride;

/// So many flights have a row each; of more there is a dot each.
const MOST_ROWS: usize = 16;
/// Dots at most.
const MOST_DOTS: usize = 2000;

/// The fitted flights; none where nothing was extended.
pub(super) fn flights(report: &Report) -> Option<Drawn> {
    let fitted = report.flights.iter();
    let fitted = fitted.filter(|f| f.role == Role::Fit && f.rms_after_m.is_some());
    let fitted: Vec<&FlightGain> = fitted.collect();
    if fitted.is_empty() {
        return None;
    }
    let title = "Fitted flights";
    if fitted.len() > MOST_ROWS {
        return Some(scatter(title, &fitted));
    }
    let rows: Vec<Row> = fitted.iter().map(|f| row(f)).collect();
    let values = fitted
        .iter()
        .flat_map(|f| [Some(f.rms_before_m), f.rms_after_m]);
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
                .chain([1e3 * report.noise.sigma_m]),
        ),
        across: "rms of the residuals, mm".into(),
        level: Some((1e3 * report.noise.sigma_m, "noise".into())),
    };
    let caption = "Residuals of the flights that were fitted, without and with the extension.";
    Some(drawn(
        "flights",
        title,
        caption.into(),
        Layout::SMALL,
        |l| chart.draw(l),
    ))
}

fn scatter(title: &str, fitted: &[&FlightGain]) -> Drawn {
    let points = fitted
        .iter()
        .filter_map(|f| Some((1e3 * f.rms_before_m, 1e3 * f.rms_after_m?)));
    let mut points: Vec<(f64, f64)> = points
        .filter(|p| p.0.is_finite() && p.1.is_finite())
        .collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let panel = Panel {
        title: "rms extended, mm".into(),
        across: "rms before, mm".into(),
        dots: vec![Dots {
            look: Look::Colour(0),
            points: stride(&points, MOST_DOTS),
        }],
        diagonal: true,
        ..Panel::default()
    };
    let caption =
        "A dot a flight that was fitted; those below the line are better with the extension.";
    drawn("flights", title, caption.into(), Layout::SMALL, |l| {
        figure_of(l, title, std::slice::from_ref(&panel))
    })
}
