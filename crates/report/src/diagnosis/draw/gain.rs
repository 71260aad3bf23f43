//! Figures of the prediction errors on held-out flights, and of the residuals of fitted ones, without and with the extension of the model.

use dataset::Role;
use diagnose::{FlightGain, Report};
use identify::numbers::{displayed, unit};
use model_spec::sort_by_number;

use crate::figure::Figure;
use crate::figures::chart::{Chart, Row, Shape, axis_for};
use crate::figures::{Layout, Look, Panel};
use crate::fit::draw::not_drawn;
use crate::thin::{MAX_DOTS, MAX_FLIGHTS, largest_first, stride};

/// RMS prediction errors without and with the added effects, of all held-out flights and of each.
pub(in super::super) fn gain(report: &Report) -> Option<Figure> {
    let gain = report.predictive_gain.as_ref()?;
    // Errors of summaries are no lengths.
    if gain.has_summaries {
        return None;
    }
    let mut held_out: Vec<&FlightGain> = Vec::new();
    if gain.held_out_by_dataset {
        let all = report.flights.iter();
        held_out.extend(all.filter(|f| f.role == Role::HeldOut && f.rms_after_m.is_some()));
    }
    let number = held_out.len();
    let (scale, of) = displayed(&report.leading_noise().unit);
    let held_out = largest_first(held_out, MAX_FLIGHTS, |flight| flight.rms_before_m);
    let mut all = row(
        "all",
        [gain.rms_before_m, gain.rms_after_m].map(Some),
        scale,
    );
    all.class = "strong";
    let (after, error) = (scale * gain.rms_after_m, scale * gain.std_error_m);
    let reach = Shape::Span((after - error).max(0.0), after + error, "reach");
    all.shapes.insert(1, reach);
    // A single flight would repeat the row of all flights.
    let most = if number > 1 { MAX_FLIGHTS } else { 0 };
    let shown = held_out.iter().take(most);
    let rows = std::iter::once(all).chain(shown.map(|flight| of_flight(flight, scale)));
    let across = format!("RMS prediction error, {}", unit(of));
    let chart = before_and_after("Prediction errors", rows, &across, scale * gain.noise_m);
    let left_out = not_drawn(number.saturating_sub(MAX_FLIGHTS), "more flights");
    let caption = format!(
        "Flights that were not fitted; the bar at ‘all’ is the standard error of the difference, the broken line the \
         noise per coordinate.{left_out}"
    );
    Some(Figure::of_chart("gain", &chart, &caption, Layout::SMALL))
}

/// Chart of RMS values without and with the added effects; `noise` in the same unit.
fn before_and_after(
    title: &str,
    rows: impl Iterator<Item = Row>,
    across: &str,
    noise: f64,
) -> Chart {
    let rows: Vec<Row> = rows.collect();
    let value = |shape: &Shape| match shape {
        Shape::Dot(value, _) => Some(*value),
        _ => None,
    };
    let values = rows.iter().flat_map(|r| &r.shapes).filter_map(value);
    let axis = axis_for(values.chain([noise]));
    let legend = [("before", "before"), ("after", "extended")];
    let legend = legend.map(|(class, words)| (Shape::Dot(0.0, class), words.to_owned()));
    Chart {
        legend: legend.into(),
        level: Some((noise, "noise".into())),
        ..Chart::new(title, rows, axis, across)
    }
}

fn of_flight(flight: &FlightGain, scale: f64) -> Row {
    row(
        &flight.file,
        [flight.rms_before_m, flight.rms_after_m],
        scale,
    )
}

fn row(name: &str, rms: [Option<f64>; 2], scale: f64) -> Row {
    let [before, after] = rms.map(|rms| rms.map(|rms| scale * rms));
    let before = before.unwrap_or(f64::NAN);
    let mut shapes = Vec::new();
    shapes.extend(after.map(|after| Shape::Span(before, after, "join")));
    shapes.push(Shape::Dot(before, "before"));
    shapes.extend(after.map(|after| Shape::Dot(after, "after")));
    Row::new(name, "tick", shapes)
}

/// Maximum number of flights with a row each; more are dots in order of their residual.
const MAX_ROWS: usize = 16;

/// RMS residuals of the fitted flights without and with the added effects; `None` without an extension.
pub(in super::super) fn flights(report: &Report) -> Option<Figure> {
    let fitted = report.flights.iter();
    let fitted = fitted.filter(|f| f.role == Role::Fit && f.rms_after_m.is_some());
    let fitted: Vec<&FlightGain> = fitted.collect();
    if fitted.is_empty() {
        return None;
    }
    let (title, noise) = ("Fitted flights", report.leading_noise());
    let (scale, of) = displayed(&noise.unit);
    let (noise, axis) = (scale * noise.sigma, format!("RMS residual, {}", unit(of)));
    if fitted.len() > MAX_ROWS {
        return Some(ranked(title, &fitted, (noise, scale), &axis));
    }
    let rows = fitted.iter().map(|flight| of_flight(flight, scale));
    let chart = before_and_after(title, rows, &axis, noise);
    let caption = "RMS residuals of the fitted flights, without and with the extension.";
    Some(Figure::of_chart("flights", &chart, caption, Layout::SMALL))
}

/// Two dots for each flight, in the order of the residual without the added effects; `noise` as
/// shown, and the factor of what is shown.
fn ranked(title: &str, fitted: &[&FlightGain], (noise, scale): (f64, f64), axis: &str) -> Figure {
    let both = |f: &&FlightGain| Some((scale * f.rms_before_m?, scale * f.rms_after_m?));
    let sizes = fitted.iter().filter_map(both);
    let mut sizes: Vec<(f64, f64)> = sizes.collect();
    sizes.retain(|s| s.0.is_finite() && s.1.is_finite());
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
    let across = "flights in order of their RMS residual before";
    let panel = Panel {
        levels: vec![noise],
        up: Some((0.0, 1.05 * largest)),
        ..Panel::new(axis, across)
            .line("extended", end(&after))
            .line("before", end(&before))
            .dots(Look::Colour(1), before)
            .dots(Look::Colour(0), after)
    };
    let caption =
        "RMS residuals of the fitted flights, two dots per flight; the broken line is the noise.";
    Figure::of_panels("flights", title, caption, Layout::SMALL, &[panel])
}
