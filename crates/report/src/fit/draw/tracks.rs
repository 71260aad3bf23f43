//! Figures of measured and predicted marker positions, as in Figure 3 of Hubbard & Hummel (2000).

use identify::FlightEvidence;

use super::{MeasuredPoint, not_drawn, points, predicted, samples};
use crate::figure::Figure;
use crate::figures::axis::range;
use crate::figures::{Layout, Look, Panel};
use crate::thin::{MAX_CURVE_POINTS, MAX_FLIGHTS, stride};

/// Maximum number of markers whose paths are drawn: the number of distinct line colours.
const MAX_MARKERS: usize = 4;
/// Maximum number of measured positions drawn as dots for each marker; more dots would hide the line of the prediction.
const MAX_DOTS: usize = 80;

/// Draws the measured and predicted marker paths of each flight: top view, and height over time.
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

/// Height of a top view divided by its width, including a margin of 10 %.
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

/// Panel of the measured and predicted marker positions of a flight; `at` maps time (s) and position (m) to a point
/// (x, y) of the panel.
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
