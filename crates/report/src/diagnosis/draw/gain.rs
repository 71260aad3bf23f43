//! Figure of the prediction error on held-out flights without and with the extension of the model.

use dataset::Role;
use diagnose::{FlightGain, Report};

use crate::figure::Figure;
use crate::figures::Layout;
use crate::figures::chart::{Chart, Row, Shape, axis_for};
use crate::fit::draw::not_drawn;
use crate::thin::{MAX_FLIGHTS, largest_first};

/// Draws the RMS prediction errors without and with the effects added to the model, mm: one chart row for all flights
/// and one for each held-out flight. `None` if the errors were not compared.
pub(super) fn gain(report: &Report) -> Option<Figure> {
    let gain = report.predictive_gain.as_ref()?;
    let mut held_out: Vec<&FlightGain> = Vec::new();
    if gain.held_out_by_dataset {
        let all = report.flights.iter();
        held_out.extend(all.filter(|f| f.role == Role::HeldOut && f.rms_after_m.is_some()));
    }
    let number = held_out.len();
    let held_out = largest_first(held_out, MAX_FLIGHTS, |flight| flight.rms_before_m);
    let mut all = row("all", Some(gain.rms_before_m), Some(gain.rms_after_m));
    all.class = "strong";
    let (after, error) = (1e3 * gain.rms_after_m, 1e3 * gain.std_error_m);
    let reach = Shape::Span((after - error).max(0.0), after + error, "reach");
    all.shapes.insert(1, reach);
    // A single flight would repeat the row of all flights.
    let most = if number > 1 { MAX_FLIGHTS } else { 0 };
    let shown = held_out.iter().take(most);
    let rows = std::iter::once(all).chain(shown.map(|flight| of_flight(flight)));
    let across = "RMS prediction error, mm";
    let chart = before_and_after("Prediction errors", rows, across, gain.noise_m);
    let left_out = not_drawn(number.saturating_sub(MAX_FLIGHTS), "more flights");
    let caption = format!(
        "Flights that were not fitted; the bar at ‘all’ is the standard error of the difference, the broken line the \
         noise per coordinate.{left_out}"
    );
    Some(Figure::of_chart("gain", &chart, &caption, Layout::SMALL))
}

/// Chart of RMS values, mm, without and with the effects added to the model; `noise` is the RMS noise, m.
pub(super) fn before_and_after(
    title: &str,
    rows: impl Iterator<Item = Row>,
    across: &str,
    noise: f64,
) -> Chart {
    let rows: Vec<Row> = rows.collect();
    let values = rows.iter().flat_map(|r| &r.shapes).filter_map(|s| match s {
        Shape::Dot(value, _) => Some(*value),
        _ => None,
    });
    let axis = axis_for(values.chain([1e3 * noise]));
    let legend = [("before", "before"), ("after", "extended")];
    Chart {
        legend: legend
            .map(|(class, words)| (Shape::Dot(0.0, class), words.to_owned()))
            .into(),
        level: Some((1e3 * noise, "noise".into())),
        ..Chart::new(title, rows, axis, across)
    }
}

/// Chart row of a flight: RMS prediction error or residual, mm, without and with the effects added to the model.
pub(super) fn of_flight(flight: &FlightGain) -> Row {
    row(&flight.file, flight.rms_before_m, flight.rms_after_m)
}

fn row(name: &str, before: Option<f64>, after: Option<f64>) -> Row {
    let before = 1e3 * before.unwrap_or(f64::NAN);
    let after = after.map(|rms| 1e3 * rms);
    let mut shapes = Vec::new();
    shapes.extend(after.map(|after| Shape::Span(before, after, "join")));
    shapes.push(Shape::Dot(before, "before"));
    shapes.extend(after.map(|after| Shape::Dot(after, "after")));
    Row::new(name, "tick", shapes)
}
