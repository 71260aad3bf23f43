//! Figures of the states over time, as in Figures 5 and 6 of Hubbard & Hummel (2000), with angle of attack, airspeed
//! and spin if the model defines these quantities.

use identify::FlightEvidence;
use model_spec::model::Model;

use super::samples;
use crate::figure::Figure;
use crate::figures::{Layout, Panel, StateLabel, panels_of_states, symbol};
use crate::thin::{MAX_CURVE_POINTS, MAX_FIGURES, MAX_FLIGHTS, curve};

/// Maximum ratio of the peak magnitudes of two states that share a panel. In a small panel, the nutation of the
/// angular rates must remain visible next to the spin.
const APART: f64 = 3.0;
/// Quantities that are drawn in addition to the states if the model defines them: name, title and unit.
const QUANTITIES: [(&str, &str, &str); 3] = [
    ("alpha", "Angle of attack α", "rad"),
    ("V", "Airspeed V", "m/s"),
    ("r", "Spin r", "rad/s"),
];

/// Draws the fitted states of each flight over time, one figure for each flight.
pub(in super::super) fn states(evidence: &[FlightEvidence], model: &Model) -> Vec<Figure> {
    let flights = evidence.iter().take(MAX_FLIGHTS).enumerate();
    let figures = flights.filter_map(|(i, flight)| state_figure(i, flight, model));
    figures.collect()
}

fn state_figure(index: usize, flight: &FlightEvidence, model: &Model) -> Option<Figure> {
    let mut panels = state_panels(flight, model);
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
    let caption = "States of the fitted flight over time.";
    let draw = || Figure::of_panels(name, &flight.file, caption, Layout::SMALL, &panels);
    (!panels.is_empty()).then(draw)
}

fn state_panels(flight: &FlightEvidence, model: &Model) -> Vec<Panel> {
    let unit = |name: &str| {
        let state = model.states.iter().find(|s| s.name == name);
        state.map_or("", |s| s.unit_text.as_str())
    };
    let names = flight.state_names.iter().take(MAX_FIGURES);
    let labels = names.map(|name| StateLabel {
        name,
        unit: unit(name),
    });
    let labels: Vec<StateLabel<'_>> = labels.collect();
    // Rows that are too short are an error of the caller and are not drawn.
    let rows = flight.states.iter().filter(|row| row.len() >= labels.len());
    let rows: Vec<Vec<f64>> = rows.cloned().collect();
    if rows.is_empty() {
        return Vec::new();
    }
    panels_of_states(&labels, &rows, APART, &|i| {
        column(flight, &flight.states, i)
    })
}

/// Points (time in s, value) of the column `at` of `table`, which has one row for each sample of the flight.
fn column(flight: &FlightEvidence, table: &[Vec<f64>], at: usize) -> Vec<(f64, f64)> {
    let value = |s: usize| table.get(s).and_then(|row| row.get(at)).copied();
    let points = samples(flight).map(|s| (flight.times[s], value(s).unwrap_or(f64::NAN)));
    let points: Vec<(f64, f64)> = points.collect();
    curve(&points, MAX_CURVE_POINTS * 3 / 4)
}
