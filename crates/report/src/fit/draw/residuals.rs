//! Figures of the residuals of all flights, plotted one flight after the other, as in Figure 4 of Hubbard & Hummel
//! (2000).

use identify::dataset::Role;
use identify::{FlightEvidence, NoiseReport};

use super::super::Drawn;
use super::super::thin::stride;
use super::{MOST_FLIGHTS, is_outlier, predicted, samples, seen};
use crate::figures::csv::of_panels;
use crate::figures::{Dots, Layout, Look, Mark, Panel, figure_of};

/// Maximum number of dots in a panel, over all markers.
const MOST_DOTS: usize = 1500;
/// Maximum number of dots for each marker on a narrow screen.
const NARROW_DOTS: usize = 150;

/// Draws one figure for the residuals of the fitted flights and one for the held-out flights; no figure for a role
/// without flights.
pub(in super::super) fn residuals(evidence: &[FlightEvidence], noise: &NoiseReport) -> Vec<Drawn> {
    let of = |role: Role| {
        let flights = evidence.iter().take(MOST_FLIGHTS);
        flights.filter(move |f| f.role == role).collect::<Vec<_>>()
    };
    let kinds = [
        (Role::Fit, "residuals", "Residuals of the fitted flights"),
        (
            Role::HeldOut,
            "residuals-held-out",
            "Residuals of the held-out flights",
        ),
    ];
    let figure = |(role, name, title): (Role, &str, &str)| {
        let flights = of(role);
        if flights.is_empty() {
            return None;
        }
        let axes = ["x", "y", "z"].iter().enumerate();
        let mut panels: Vec<Panel> = axes
            .map(|(i, axis)| {
                let sigma = noise.axes.get(*axis).map_or(noise.sigma_m, |n| n.sigma_m);
                panel(&flights, i, axis, sigma)
            })
            .collect();
        let files: Vec<String> = flights
            .iter()
            .enumerate()
            .map(|(i, f)| format!("{} {}", i + 1, f.file))
            .collect();
        let meaning = match role {
            Role::Fit => "",
            Role::HeldOut => {
                " The first 30\u{a0}% of each were used for its initial state; the rest is a prediction."
            }
        };
        let caption = format!(
            "Residuals (measured − predicted), one flight after the other, one colour per marker; shaded: ±2 standard \
             deviations of the noise; crosses: outliers, at the edge if they are beyond it.{meaning} Flights: {}.",
            files.join(", ")
        );
        let svg = figure_of(Layout::WIDE, title, &panels);
        let mut drawn = Drawn::new(
            name.into(),
            title.into(),
            [caption, svg, of_panels(&panels)],
        );
        let dots = panels.iter_mut().flat_map(|panel| &mut panel.dots);
        dots.for_each(|dots| dots.points = stride(&dots.points, NARROW_DOTS));
        drawn.narrow = Some(figure_of(Layout::SMALL, title, &panels));
        Some(drawn)
    };
    kinds.into_iter().filter_map(figure).collect()
}

/// Panel of the residuals (measured − predicted, mm) along `axis` (0 x, 1 y, 2 z), with the flights one after the other
/// on the time axis. `name` is the name of the axis for the panel's title; `sigma` is the standard deviation of the
/// noise, m.
pub(crate) fn panel(flights: &[&FlightEvidence], axis: usize, name: &str, sigma: f64) -> Panel {
    let markers = flights.iter().map(|f| f.markers.len()).max().unwrap_or(0);
    let mut dots: Vec<Vec<(f64, f64)>> = vec![Vec::new(); markers];
    let (mut outliers, mut marks) = (Vec::new(), Vec::new());
    let mut start = 0.0;
    for (number, flight) in flights.iter().enumerate() {
        marks.push(Mark {
            name: format!("{}", number + 1),
            at: (start, f64::NAN),
        });
        for sample in samples(flight) {
            for (marker, dots) in dots.iter_mut().enumerate() {
                let Some(place) = seen(flight, sample, marker) else {
                    continue;
                };
                let residual = 1e3 * (place[axis] - predicted(flight, sample, marker)[axis]);
                let point = (start + flight.times[sample] - flight.times[0], residual);
                if is_outlier(flight, sample, marker) {
                    outliers.push(point);
                } else if point.1.is_finite() {
                    dots.push(point);
                }
            }
        }
        let last = samples(flight).last().map_or(0.0, |s| flight.times[s]);
        let first = flight.times.first().copied().unwrap_or(0.0);
        start += (last - first).max(0.0);
    }
    let each = MOST_DOTS / markers.max(1);
    let largest = dots.iter().flatten().map(|p| p.1.abs()).fold(0.0, f64::max);
    let band = Some(2e3 * sigma).filter(|b| b.is_finite() && *b > 0.0);
    let reach = 1.08 * largest.max(band.unwrap_or(0.0)).max(1e-9);
    for point in &mut outliers {
        point.1 = point.1.clamp(-0.96 * reach, 0.96 * reach);
    }
    let mut all: Vec<Dots> = dots
        .iter()
        .enumerate()
        .map(|(marker, points)| Dots {
            look: Look::Colour(marker),
            points: stride(points, each),
        })
        .collect();
    all.push(Dots {
        look: Look::Cross,
        points: stride(&outliers, 200),
    });
    Panel {
        title: format!("{name}, mm"),
        across: "time, flights in sequence, s".into(),
        dots: all,
        marks,
        band: band.map(|b| (-b, b)),
        up: Some((-reach, reach)),
        ..Panel::default()
    }
}
