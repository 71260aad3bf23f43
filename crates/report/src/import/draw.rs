//! Figures of an import: each flight over the time of its take, and each whole take.

use model_spec::sort_by_number;

use super::{Distance, ImportedFlight, ImportedTake};
use crate::figure::Figure;
use crate::figures::{Layout, Line, Look, Mark, Panel};
use crate::thin;

/// Maximum number of marker pairs: the number of distinct colours.
const MAX_PAIRS: usize = 4;
const MAX_DOTS: usize = 150;

/// Motion and marker distances: lines during the flight, grey dots before and after it.
pub(super) fn flight(number: usize, flight: &ImportedFlight) -> Figure {
    let curves = flight.curves.iter().map(|line| Panel {
        title: line.name.clone(),
        ..split(&line.points, |time| flight.holds(time))
    });
    let mut panels: Vec<Panel> = curves.chain(distances(flight)).collect();
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
    let figure = Figure::of_panels(name, &flight.file, caption, Layout::SMALL, &panels);
    without_table(figure)
}

/// Whether the body was tracked where no flight is.
pub(super) fn is_cut(take: &ImportedTake) -> bool {
    let is_inside = |time: f64| take.flights.iter().any(|flight| flight.holds(time));
    let mut tracked = take.heights.iter().filter(|point| point.1.is_finite());
    tracked.any(|(time, _)| !is_inside(*time))
}

/// Height of the body over the whole recording, with begin and end of each flight.
pub(super) fn take(number: usize, take: &ImportedTake) -> Figure {
    let inside = |time: f64| take.flights.iter().any(|flight| flight.holds(time));
    let mut panel = split(&take.heights, inside);
    panel.title = "Height, m".into();
    panel.height = Some(110.0);
    let flights = || take.flights.iter();
    let starts = flights().map(|flight| Mark::vertical(&flight.file, flight.release.time));
    let ends = flights().map(|flight| Mark::vertical("", flight.end.time));
    panel.marks = starts.chain(ends).collect();
    let name = format!("take-{number:02}");
    let caption = "Lines: the flights; grey: what was cut away.";
    without_table(Figure::of_panels(
        name,
        &take.file,
        caption,
        Layout::WIDE,
        &[panel],
    ))
}

/// An import is one page, and its numbers are the tables of the dataset.
fn without_table(figure: Figure) -> Figure {
    Figure {
        csv: String::new(),
        ..figure
    }
}

/// Panel of points over time, s: a line where `inside` holds, and grey dots.
fn split(points: &[(f64, f64)], inside: impl Fn(f64) -> bool) -> Panel {
    let line = points
        .iter()
        .map(|&(t, value)| (t, if inside(t) { value } else { f64::NAN }));
    let line: Vec<(f64, f64)> = line.collect();
    let mut outside = points.to_vec();
    outside.retain(|(time, value)| !inside(*time) && value.is_finite());
    Panel::new("", "time of the recording, s")
        .line("", thin::curve(&line, thin::MAX_CURVE_POINTS))
        .dots(Look::Pale, thin::stride(&outside, MAX_DOTS))
}

/// Distances between markers less those on the body, mm; a line jumps where markers are swapped or loose.
fn distances(flight: &ImportedFlight) -> Option<Panel> {
    let mut pairs: Vec<&Distance> = flight.distances.iter().collect();
    sort_by_number(&mut pairs, |pair| -spread(flight, pair));
    let left_out = pairs.len().saturating_sub(MAX_PAIRS);
    pairs.truncate(MAX_PAIRS);
    let line = |pair: &&Distance| {
        let off = pair.points.iter().map(|&(t, d)| {
            let off = 1e3 * (d - pair.template);
            (t, if flight.holds(t) { off } else { f64::NAN })
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
    let title = format!("Distance less template, mm{more}");
    (!pairs.is_empty()).then(|| Panel {
        lines: pairs.iter().map(line).collect(),
        thin: true,
        levels: vec![0.0],
        ..Panel::new(title, "time of the recording, s")
    })
}

/// Median of the distance between two markers during the flight, and largest departure from it, m, if it was measured.
pub(super) fn median_and_departure(flight: &ImportedFlight, pair: &Distance) -> Option<(f64, f64)> {
    let seen = pair.points.iter().filter(|(t, _)| flight.holds(*t));
    let seen = seen.map(|point| point.1).filter(|d| d.is_finite());
    let mut seen: Vec<f64> = seen.collect();
    seen.sort_by(f64::total_cmp);
    let middle = *seen.get(seen.len() / 2)?;
    let farthest = seen.iter().map(|d| (d - middle).abs()).fold(0.0, f64::max);
    Some((middle, farthest))
}

fn spread(flight: &ImportedFlight, pair: &Distance) -> f64 {
    median_and_departure(flight, pair).map_or(0.0, |(_, departure)| departure)
}
