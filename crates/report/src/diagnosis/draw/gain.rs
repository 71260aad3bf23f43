//! Figure of the prediction error on held-out flights without and with the extension of the model.

use dataset::Role;
use diagnose::{FlightGain, Report};
use model_spec::sort_by_number;

use crate::figure::Figure;
use crate::figures::Layout;
use crate::figures::chart::{Chart, Row, Shape, axis_for};
use crate::fit::draw::not_drawn;

/// Maximum number of held-out flights whose prediction errors are drawn, one chart row each.
const MAX_FLIGHTS: usize = 12;

/// Draws the RMS prediction errors without and with the effects added to the model, mm: one chart row for all flights
/// and one for each held-out flight. `None` if the errors were not compared.
pub(super) fn gain(report: &Report) -> Option<Figure> {
    let gain = report.predictive_gain.as_ref()?;
    let mm = |metres: f64| 1e3 * metres;
    let mut held_out: Vec<&FlightGain> = Vec::new();
    if gain.held_out_by_dataset {
        let all = report.flights.iter();
        held_out.extend(all.filter(|f| f.role == Role::HeldOut && f.rms_after_m.is_some()));
    }
    let number = held_out.len();
    if number > MAX_FLIGHTS {
        let size = |f: &FlightGain| f.rms_before_m.unwrap_or(f64::NEG_INFINITY);
        sort_by_number(&mut held_out, |flight| -size(flight));
        held_out.truncate(MAX_FLIGHTS);
    }
    let (before, after) = (mm(gain.rms_before_m), mm(gain.rms_after_m));
    let error = mm(gain.std_error_m);
    let all = Row {
        name: "all".into(),
        class: "strong",
        shapes: vec![
            Shape::Span(before, after, "join"),
            Shape::Span((after - error).max(0.0), after + error, "reach"),
            Shape::Dot(before, "before"),
            Shape::Dot(after, "after"),
        ],
        words: String::new(),
    };
    // A single flight would repeat the row of all flights.
    let shown = if number > 1 { &held_out[..] } else { &[] };
    let rows: Vec<Row> = std::iter::once(all)
        .chain(shown.iter().map(|f| row(f)))
        .collect();
    let floor = mm(gain.noise_m);
    let values = rows.iter().flat_map(|r| &r.shapes).filter_map(|s| match s {
        Shape::Dot(value, _) => Some(*value),
        _ => None,
    });
    let axis = axis_for(values.chain([floor]));
    let chart = Chart {
        title: "Prediction errors".into(),
        legend: vec![
            (Shape::Dot(0.0, "before"), "before".into()),
            (Shape::Dot(0.0, "after"), "extended".into()),
        ],
        rows,
        axis,
        across: "RMS prediction error, mm".into(),
        level: Some((floor, "noise".into())),
    };
    let left_out = not_drawn(number.saturating_sub(MAX_FLIGHTS), "more flights");
    let caption = format!(
        "Flights that were not fitted; the bar at ‘all’ is the standard error of the difference, the broken line the \
         noise per coordinate.{left_out}"
    );
    Some(Figure::of_chart("gain", &chart, &caption, Layout::SMALL))
}

/// Chart row of a flight: RMS prediction error or residual, mm, without and with the effects added to the model.
pub(super) fn row(flight: &FlightGain) -> Row {
    let before = 1e3 * flight.rms_before_m.unwrap_or(f64::NAN);
    let after = flight.rms_after_m.map(|rms| 1e3 * rms);
    let mut shapes = Vec::new();
    if let Some(after) = after {
        shapes.push(Shape::Span(before, after, "join"));
    }
    shapes.push(Shape::Dot(before, "before"));
    shapes.extend(after.map(|after| Shape::Dot(after, "after")));
    Row {
        name: flight.file.clone(),
        class: "tick",
        shapes,
        words: String::new(),
    }
}
