//! Figures of the residuals of all flights, plotted one flight after the other, as in Figure 4 of Hubbard & Hummel
//! (2000).

use dataset::Role;
use identify::{FlightEvidence, NoiseReport};

use super::{points, samples};
use crate::figure::Figure;
use crate::figures::csv::of_panels;
use crate::figures::{Dots, Layout, Look, Mark, Panel, figure_of};
use crate::thin::{MAX_DOTS, MAX_FLIGHTS, stride};

/// Maximum number of dots of a panel on a narrow screen.
const NARROW_DOTS: usize = 600;
const MAX_CROSSES: usize = 200;

/// Roles of flights, with name and title of the figure and the meaning of the residuals.
const KINDS: [(Role, &str, &str, &str); 2] = [
    (
        Role::Fit,
        "residuals",
        "Residuals of the fitted flights",
        "",
    ),
    (
        Role::HeldOut,
        "residuals-held-out",
        "Residuals of the held-out flights",
        " The first 30\u{a0}% of each were used for its initial state; the rest is a prediction.",
    ),
];

/// Residuals of the fitted and of the held-out flights, one colour per marker; grey and blue for two models.
pub(crate) fn residuals(
    evidence: &[FlightEvidence],
    after: &[FlightEvidence],
    noise: &NoiseReport,
) -> Vec<Figure> {
    let figures = KINDS.into_iter().filter_map(|(role, name, title, meaning)| {
        let flights = flights_of(evidence, role);
        let extended = flights_of(after, role);
        let panel = |(i, axis): (usize, &str)| {
            let sigma = noise.axes.get(axis).map_or(noise.sigma, |n| n.sigma);
            panel(&flights, &extended, i, axis, sigma)
        };
        let axes = ["x", "y", "z"].into_iter().enumerate();
        let panels: Vec<Panel> = axes.map(panel).collect();
        let files = flights.iter().zip(1..).map(|(f, n)| format!("{n} {}", f.file));
        let files: Vec<String> = files.collect();
        let colours = if extended.is_empty() {
            "one colour per marker"
        } else {
            "grey for the model, blue for the extended model"
        };
        let caption = format!(
            "Residuals (measured − predicted), one flight after the other, {colours}; shaded: ±2 standard deviations of \
             the noise; crosses: outliers, at the edge if they are beyond it.{meaning} Flights: {}.",
            files.join(", ")
        );
        let texts = [caption, of_panels(&panels)];
        let draw = |layout| residual_figure(layout, title, &panels);
        (!flights.is_empty())
            .then(|| Figure::in_layouts(name, title, texts, Layout::WIDE, &draw))
    });
    figures.collect()
}

/// Flights with a role among those that are drawn.
fn flights_of(evidence: &[FlightEvidence], role: Role) -> Vec<&FlightEvidence> {
    let drawn = evidence.iter().take(MAX_FLIGHTS);
    drawn.filter(|f| f.role == role).collect()
}

/// Draws panels, with fewer dots in any layout but the widest.
fn residual_figure(layout: Layout, title: &str, panels: &[Panel]) -> String {
    if layout == Layout::WIDE {
        return figure_of(layout, title, panels);
    }
    let mut fewer = panels.to_vec();
    for panel in &mut fewer {
        let most = NARROW_DOTS / panel.dots.len().max(1);
        for series in &mut panel.dots {
            series.points = stride(&series.points, most);
        }
    }
    figure_of(layout, title, &fewer)
}

/// Residuals (mm) along one axis over the time since the start of the first flight.
#[derive(Default)]
struct Series {
    /// Of each marker, without outliers.
    markers: Vec<Vec<(f64, f64)>>,
    outliers: Vec<(f64, f64)>,
    /// Start of each flight.
    starts: Vec<f64>,
}

impl Series {
    fn of(flights: &[&FlightEvidence], axis: usize) -> Series {
        let markers = flights.iter().map(|f| f.markers.len()).max().unwrap_or(0);
        let mut series = Series {
            markers: vec![Vec::new(); markers],
            ..Series::default()
        };
        let mut start = 0.0;
        for flight in flights {
            series.starts.push(start);
            for measured in points(flight, markers) {
                let time = start + measured.time - flight.times[0];
                let point = (time, measured.residual[axis]);
                if measured.is_outlier {
                    series.outliers.push(point);
                } else if point.1.is_finite() {
                    series.markers[measured.marker].push(point);
                }
            }
            let last = samples(flight).last().map_or(0.0, |s| flight.times[s]);
            let first = flight.times.first().copied().unwrap_or(0.0);
            start += (last - first).max(0.0);
        }
        series
    }
}

/// Panel of the residuals along an axis by the model and by the extended model; `sigma` is the noise, m.
fn panel(
    flights: &[&FlightEvidence],
    after: &[&FlightEvidence],
    axis: usize,
    name: &str,
    sigma: f64,
) -> Panel {
    let (before, after) = (Series::of(flights, axis), Series::of(after, axis));
    let all = || before.markers.iter().chain(&after.markers);
    let largest = all().flatten().map(|p| p.1.abs()).fold(0.0, f64::max);
    let band = Some(2e3 * sigma).filter(|b| b.is_finite() && *b > 0.0);
    let reach = 1.08 * largest.max(band.unwrap_or(0.0)).max(1e-9);
    let dots = if after.starts.is_empty() {
        let markers = before.markers.iter().enumerate();
        let each = MAX_DOTS / before.markers.len().max(1);
        let dots = markers.map(|(i, points)| Dots::new(Look::Colour(i), stride(points, each)));
        dots.collect()
    } else {
        let both = [(Look::Pale, &before), (Look::Colour(0), &after)];
        let dots = both.map(|(look, series)| {
            let points = series.markers.concat();
            Dots::new(look, stride(&points, MAX_DOTS))
        });
        Vec::from(dots)
    };
    let is_extended = !after.starts.is_empty();
    let own = if is_extended { &after } else { &before };
    let inside = |p: &(f64, f64)| (p.0, p.1.clamp(-0.96 * reach, 0.96 * reach));
    let crosses: Vec<(f64, f64)> = own.outliers.iter().map(inside).collect();
    let starts = before.starts.iter().zip(1..);
    let starts = starts.map(|(start, n)| Mark::vertical(format!("{n}"), *start));
    Panel {
        dots,
        marks: starts.collect(),
        band: band.map(|b| (-b, b)),
        up: Some((-reach, reach)),
        ..Panel::new(format!("{name}, mm"), "time, flights in sequence, s")
    }
    .dots(Look::Cross, stride(&crosses, MAX_CROSSES))
}
