//! Figure of the RMS residual of each fitted flight without and with the extension of the model.

use dataset::Role;
use diagnose::{FlightGain, Report};
use model_spec::sort_by_number;

use super::gain::{before_and_after, of_flight};
use crate::figure::Figure;
use crate::figures::{Layout, Look, Panel};
use crate::thin::{MAX_DOTS, stride};

/// Maximum number of flights drawn as one chart row each; more flights are drawn as dots in order of their residual.
const MAX_ROWS: usize = 16;

/// Draws the RMS residuals of the fitted flights, without and with the effects added to the model; `None` if no effect
/// was added.
pub(super) fn flights(report: &Report) -> Option<Figure> {
    let fitted = report.flights.iter();
    let fitted = fitted.filter(|f| f.role == Role::Fit && f.rms_after_m.is_some());
    let fitted: Vec<&FlightGain> = fitted.collect();
    if fitted.is_empty() {
        return None;
    }
    let (title, noise) = ("Fitted flights", report.leading_noise().sigma);
    if fitted.len() > MAX_ROWS {
        return Some(ranked(title, &fitted, 1e3 * noise));
    }
    let rows = fitted.iter().map(|flight| of_flight(flight));
    let chart = before_and_after(title, rows, "RMS residual, mm", noise);
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
    let ends = sizes.iter().map(|s| s.0.max(s.1)).chain([noise]);
    let largest = ends.filter(|v| v.is_finite()).fold(1e-6, f64::max);
    let last = sizes.len() as f64;
    let ranks = sizes.iter().zip(1..).map(|(s, rank)| (f64::from(rank), *s));
    let ranks = stride(&ranks.collect::<Vec<(f64, (f64, f64))>>(), MAX_DOTS);
    let before: Vec<(f64, f64)> = ranks.iter().map(|(rank, s)| (*rank, s.0)).collect();
    let after: Vec<(f64, f64)> = ranks.iter().map(|(rank, s)| (*rank, s.1)).collect();
    // A line of a single point shows only its label.
    let end = |points: &[(f64, f64)]| points.last().map(|p| (last, p.1));
    let panel = Panel {
        levels: vec![noise],
        up: Some((0.0, 1.05 * largest)),
        ..Panel::new(
            "RMS residual, mm",
            "flights in order of their RMS residual before",
        )
        .line("extended", end(&after))
        .line("before", end(&before))
        .dots(Look::Colour(1), before)
        .dots(Look::Colour(0), after)
    };
    let caption =
        "RMS residuals of the fitted flights, two dots per flight; the broken line is the noise.";
    Figure::of_panels("flights", title, caption, Layout::SMALL, &[panel])
}
