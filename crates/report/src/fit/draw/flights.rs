//! Figures of the states over time, as in Figures 5 and 6 of Hubbard & Hummel (2000), and of the marker positions (Figure 3).

use identify::FlightEvidence;
use model_spec::model::Model;

use super::{MeasuredPoint, not_drawn, points, predicted, samples};
use crate::figure::Figure;
use crate::figures::axis::range;
use crate::figures::{Layout, Look, Panel, StateLabel, panels_over_time, symbol};
use crate::thin::{MAX_CURVE_POINTS, MAX_FIGURES, MAX_FLIGHTS, curve, stride};

/// Maximum ratio of the peak magnitudes of two states in one panel: the nutation must remain visible next to the spin.
const APART: f64 = 3.0;
/// Quantities that are drawn too if the model defines them: name, title and unit.
const QUANTITIES: [(&str, &str, &str); 3] = [
    ("alpha", "Angle of attack α", "rad"),
    ("V", "Airspeed V", "m/s"),
    ("r", "Spin r", "rad/s"),
];

pub(in super::super) fn states(evidence: &[FlightEvidence], model: &Model) -> Vec<Figure> {
    let flights = evidence.iter().take(MAX_FLIGHTS).enumerate();
    let figures = flights.filter_map(|(i, flight)| state_figure(i, flight, model));
    figures.collect()
}

fn state_figure(index: usize, flight: &FlightEvidence, model: &Model) -> Option<Figure> {
    let mut panels = input_panels(flight);
    panels.extend(state_panels(flight, model));
    for (name, title, unit) in QUANTITIES {
        let at = flight.quantity_names.iter().position(|n| n == name);
        let Some(at) = at else { continue };
        let points = column(flight, &flight.quantities, at);
        if points.iter().any(|p| p.1.is_finite()) {
            let panel = Panel::new(format!("{title}, {unit}"), "time, s");
            panels.push(panel.line(symbol(name), points));
        }
    }
    let name = format!("states-{:02}", index + 1);
    let caption = match flight.input_names.is_empty() {
        true => "States of the fitted flight over time.",
        false => "Inputs as recorded, and states of the fitted flight over time.",
    };
    let draw = || Figure::of_panels(name, &flight.file, caption, Layout::SMALL, &panels);
    (!panels.is_empty()).then(draw)
}

fn state_panels(flight: &FlightEvidence, model: &Model) -> Vec<Panel> {
    let unit = |name: &str| {
        let state = model.states.iter().find(|s| s.name == name);
        state.map_or("", |s| s.unit_text.as_str())
    };
    let labels = flight.state_names.iter().take(MAX_FIGURES);
    let label = |name| StateLabel {
        name,
        unit: unit(name),
    };
    let labels: Vec<StateLabel<'_>> = labels.map(|name| label(name)).collect();
    // Rows that are too short are an error of the caller and are not drawn.
    let rows = flight.states.iter().filter(|row| row.len() >= labels.len());
    let rows: Vec<Vec<f64>> = rows.cloned().collect();
    if rows.is_empty() {
        return Vec::new();
    }
    let points = |i| column(flight, &flight.states, i);
    panels_over_time(&labels, &rows, Some(APART), &points)
}

/// Figures of the inputs that vary, a figure for each flight.
pub(crate) fn inputs(evidence: &[FlightEvidence]) -> Vec<Figure> {
    let flights = evidence.iter().take(MAX_FLIGHTS).enumerate();
    let figures = flights.filter_map(|(i, flight)| {
        let panels = input_panels(flight);
        let name = format!("inputs-{:02}", i + 1);
        let caption = "Inputs as recorded.";
        let draw = || Figure::of_panels(name, &flight.file, caption, Layout::SMALL, &panels);
        (!panels.is_empty()).then(draw)
    });
    figures.collect()
}

fn input_panels(flight: &FlightEvidence) -> Vec<Panel> {
    let names = flight.input_names.iter().take(MAX_FIGURES);
    let labels = names.zip(&flight.input_units);
    let labels = labels.map(|(name, unit)| StateLabel { name, unit });
    let labels: Vec<StateLabel<'_>> = labels.collect();
    let points = |i| column(flight, &flight.inputs, i);
    panels_over_time(&labels, &flight.inputs, None, &points)
}

/// Points (time, value) of a column of a table with a row for each sample.
fn column(flight: &FlightEvidence, table: &[Vec<f64>], at: usize) -> Vec<(f64, f64)> {
    let value = |s: usize| table.get(s).and_then(|row| row.get(at)).copied();
    let points = samples(flight).map(|s| (flight.times[s], value(s).unwrap_or(f64::NAN)));
    let points: Vec<(f64, f64)> = points.collect();
    curve(&points, MAX_CURVE_POINTS * 3 / 4)
}

/// Maximum number of markers: the number of distinct colours.
const MAX_MARKERS: usize = 4;
/// Maximum number of dots of a marker; more would hide the line of the prediction.
const MAX_DOTS: usize = 80;

pub(in super::super) fn tracks(evidence: &[FlightEvidence]) -> Vec<Figure> {
    let flights = || evidence.iter().take(MAX_FLIGHTS);
    let map = |flight| panel(flight, |_, p| (p[0], p[1]));
    let maps: Vec<Panel> = flights().map(map).collect();
    // All top views have equal height, so that figures in a row are aligned.
    let shapes = maps.iter().map(shape).filter(|shape| shape.is_finite());
    let height = (shapes.fold(0.0, f64::max) * 300.0).clamp(80.0, 190.0);
    let tracks = flights().zip(maps).enumerate();
    let tracks = tracks.map(|(i, (flight, map))| track(i, flight, map, height));
    tracks.collect()
}

/// Height of a top view over its width, with a margin.
fn shape(map: &Panel) -> f64 {
    let points = || map.lines.iter().flat_map(|line| &line.points);
    let (x, y) = (range(points().map(|p| p.0)), range(points().map(|p| p.1)));
    1.1 * (y.1 - y.0) / (x.1 - x.0)
}

fn track(index: usize, flight: &FlightEvidence, map: Panel, tall: f64) -> Figure {
    let height = |t: f64, p: [f64; 3]| (t, p[2]);
    let mut above = Panel {
        title: "Top view: y, m".into(),
        across: "x, m".into(),
        map: true,
        heights: Some((tall, tall)),
        ..map
    };
    for line in &mut above.lines {
        line.name.clear();
    }
    let side = Panel {
        title: "Height z, m".into(),
        across: "time, s".into(),
        height: Some(130.0),
        ..panel(flight, height)
    };
    let left_out = flight.markers.len().saturating_sub(MAX_MARKERS);
    let caption = "Dots: measured; lines: predicted; crosses: outliers. Long flights are drawn with fewer samples.";
    let caption = caption.to_owned() + &not_drawn(left_out, "more markers");
    let name = format!("tracks-{:02}", index + 1);
    Figure::of_panels(name, &flight.file, caption, Layout::SMALL, &[above, side])
}

/// Panel of the measured and predicted marker positions; `at` maps time (s) and position (m) to a point.
fn panel(flight: &FlightEvidence, at: impl Fn(f64, [f64; 3]) -> (f64, f64)) -> Panel {
    let mut panel = Panel {
        thin: true,
        ..Panel::default()
    };
    let mut outliers = Vec::new();
    let measured: Vec<MeasuredPoint> = points(flight, MAX_MARKERS).collect();
    for (marker, name) in flight.markers.iter().take(MAX_MARKERS).enumerate() {
        let mut dots = Vec::new();
        for measured in measured.iter().filter(|point| point.marker == marker) {
            let point = at(measured.time, measured.measured);
            if measured.is_outlier {
                outliers.push(point);
            } else {
                dots.push(point);
            }
        }
        let line = samples(flight).map(|s| at(flight.times[s], predicted(flight, s, marker)));
        let line: Vec<(f64, f64)> = line.collect();
        let line = stride(&line, MAX_CURVE_POINTS);
        let dots = stride(&dots, MAX_DOTS);
        panel = panel.line(name, line).dots(Look::Colour(marker), dots);
    }
    // Outliers far outside the predicted range are not drawn.
    let reach = |axis: fn(&(f64, f64)) -> f64| {
        let all = panel.lines.iter().flat_map(|l| &l.points).map(axis);
        let (low, high) = range(all);
        let room = 0.3 * (high - low);
        (low - room, high + room)
    };
    let (x, y) = (reach(|p| p.0), reach(|p| p.1));
    outliers.retain(|p| x.0 <= p.0 && p.0 <= x.1 && y.0 <= p.1 && p.1 <= y.1);
    panel.dots(Look::Cross, stride(&outliers, MAX_DOTS))
}
