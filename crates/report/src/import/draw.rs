//! Figures of an import: each flight over the time of its take, and each whole take.

use model_spec::sort_by_number;

use super::{Curve, Distance, ImportedFlight, ImportedTake};
use crate::figure::Figure;
use crate::figures::{Layout, Line, Look, Mark, Panel};
use crate::thin;

/// Maximum number of marker pairs whose distances are drawn for a flight: the number of distinct line colours.
const MAX_PAIRS: usize = 4;
/// Maximum number of dots with which the part of a curve before and after the flight is drawn.
const MAX_DOTS: usize = 150;

/// Draws the motion and the marker distances of an imported flight over time: lines during the flight, grey dots for
/// the recording before and after it. `number` becomes part of the figure's file name.
pub(super) fn flight(number: usize, flight: &ImportedFlight) -> Figure {
    let mut panels: Vec<Panel> = flight.curves.iter().map(|it| curve(flight, it)).collect();
    if let Some(panel) = distances(flight) {
        panels.push(panel);
    }
    for panel in &mut panels {
        panel.marks = vec![
            Mark::vertical("release", flight.release.time),
            Mark::vertical("end", flight.end.time),
        ];
    }
    let caption = format!(
        "From {:.3} s: {}. To {:.3} s: {}.",
        flight.release.time, flight.release.reason, flight.end.time, flight.end.reason
    );
    let name = format!("flight-{number:02}");
    without_table(Figure::of_panels(
        name,
        &flight.file,
        caption,
        Layout::SMALL,
        &panels,
    ))
}

/// Draws the height of the body over the whole recording `take`, with begin and end of each flight. `number` becomes
/// part of the figure's file name.
pub(super) fn take(number: usize, take: &ImportedTake) -> Figure {
    let inside = |time: f64| take.flights.iter().any(|flight| flight.holds(time));
    let mut panel = split(&take.heights, inside);
    panel.title = "Height, m".into();
    panel.height = Some(110.0);
    let flights = || take.flights.iter();
    let starts = flights().map(|flight| Mark::vertical(&flight.file, flight.release.time));
    let ends = flights().map(|flight| Mark::vertical("", flight.end.time));
    panel.marks = starts.chain(ends).collect();
    without_table(Figure::of_panels(
        format!("take-{number:02}"),
        &take.file,
        "Lines: the flights; grey: what was cut away.",
        Layout::WIDE,
        &[panel],
    ))
}

/// The figure without its CSV table: an import is one page, and its numbers are the tables of the dataset.
fn without_table(figure: Figure) -> Figure {
    Figure {
        csv: String::new(),
        ..figure
    }
}

/// Panel of the pairs (time in s, value) in `points`. Points for whose time `inside` returns true form a line; all
/// other points are grey dots.
fn split(points: &[(f64, f64)], inside: impl Fn(f64) -> bool) -> Panel {
    let line = points.iter().map(|&(time, value)| {
        if inside(time) {
            (time, value)
        } else {
            (time, f64::NAN)
        }
    });
    let line: Vec<(f64, f64)> = line.collect();
    let outside = points
        .iter()
        .filter(|(time, value)| !inside(*time) && value.is_finite());
    let outside: Vec<(f64, f64)> = outside.copied().collect();
    Panel::new("", "time of the recording, s")
        .line("", thin::curve(&line, thin::MAX_CURVE_POINTS))
        .dots(Look::Pale, thin::stride(&outside, MAX_DOTS))
}

fn curve(flight: &ImportedFlight, curve: &Curve) -> Panel {
    Panel {
        title: curve.title.clone(),
        ..split(&curve.points, |time| flight.holds(time))
    }
}

/// Panel of the measured distances between pairs of markers, minus the distances according to the declared marker
/// positions, mm. The line of a pair whose markers were swapped or came loose has a jump. `None` if there are no pairs.
fn distances(flight: &ImportedFlight) -> Option<Panel> {
    let mut pairs: Vec<&Distance> = flight.distances.iter().collect();
    sort_by_number(&mut pairs, |pair| -spread(flight, pair));
    let left_out = pairs.len().saturating_sub(MAX_PAIRS);
    pairs.truncate(MAX_PAIRS);
    let line = |pair: &&Distance| {
        let off = pair.points.iter().map(|&(t, d)| {
            if flight.holds(t) {
                (t, 1e3 * (d - pair.template))
            } else {
                (t, f64::NAN)
            }
        });
        let off: Vec<(f64, f64)> = off.collect();
        // Spaces widen the margin, because bold letters of a name can be wide.
        let name = format!("{}   ", pair.name);
        Line::new(name, thin::curve(&off, thin::MAX_CURVE_POINTS))
    };
    let more = match left_out {
        0 => String::new(),
        n => format!(" ({n} steadier pairs left out)"),
    };
    (!pairs.is_empty()).then(|| Panel {
        lines: pairs.iter().map(line).collect(),
        thin: true,
        levels: vec![0.0],
        ..Panel::new(
            format!("Distance less template, mm{more}"),
            "time of the recording, s",
        )
    })
}

/// Median of the distance between two markers during the flight, and maximum absolute deviation from the median, m;
/// `None` if the distance was never measured.
pub(super) fn median_and_departure(flight: &ImportedFlight, pair: &Distance) -> Option<(f64, f64)> {
    let seen = pair
        .points
        .iter()
        .filter(|(t, d)| flight.holds(*t) && d.is_finite());
    let mut seen: Vec<f64> = seen.map(|point| point.1).collect();
    seen.sort_by(f64::total_cmp);
    let middle = *seen.get(seen.len() / 2)?;
    let farthest = seen.iter().map(|d| (d - middle).abs()).fold(0.0, f64::max);
    Some((middle, farthest))
}

fn spread(flight: &ImportedFlight, pair: &Distance) -> f64 {
    median_and_departure(flight, pair).map_or(0.0, |(_, departure)| departure)
}
