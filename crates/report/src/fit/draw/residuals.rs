//! Figures of the residuals of all flights, plotted one flight after the other, as in Figure 4 of Hubbard & Hummel
//! (2000).

use dataset::Role;
use identify::{FlightEvidence, NoiseReport};

use super::{MAX_FLIGHTS, points, samples};
use crate::figure::Figure;
use crate::figures::csv::of_panels;
use crate::figures::{Dots, Layout, Look, Mark, Panel, figure_of};
use crate::thin::stride;

/// Maximum number of residuals drawn as dots in a panel, over all markers.
const MAX_DOTS: usize = 1500;
/// Maximum number of residuals drawn as dots for each marker on a narrow screen.
const NARROW_DOTS: usize = 150;

/// Flights of one role, whose residuals are drawn in one figure.
pub(crate) struct FlightsOfRole<'e> {
    /// File name, without suffix, of the figure of residuals.
    pub(crate) name: &'static str,
    /// Title of the figure of residuals.
    pub(crate) title: &'static str,
    /// Flights of this role among the first [`MAX_FLIGHTS`] flights of a fit or diagnosis; only those are drawn.
    pub(crate) flights: Vec<&'e FlightEvidence>,
    /// Sentences at the end of the caption: the meaning of the residuals, and the files of the flights.
    pub(crate) notes: String,
}

impl<'e> FlightsOfRole<'e> {
    /// Groups the flights by role: the fitted flights, then the held-out flights; a role without flights is left out.
    pub(crate) fn all(evidence: &'e [FlightEvidence]) -> impl Iterator<Item = FlightsOfRole<'e>> {
        let kinds = [
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
        let of_kind = |(role, name, title, meaning)| {
            let flights = flights_of(evidence, role);
            let files = flights.iter().enumerate();
            let files: Vec<String> = files
                .map(|(i, f)| format!("{} {}", i + 1, f.file))
                .collect();
            FlightsOfRole {
                name,
                title,
                flights,
                notes: format!("{meaning} Flights: {}.", files.join(", ")),
            }
        };
        let all = kinds.into_iter().map(of_kind);
        all.filter(|of| !of.flights.is_empty())
    }

    /// Role of the flights: fitted or held out.
    pub(crate) fn role(&self) -> Role {
        self.flights[0].role
    }
}

/// Flights with the given role (fitted or held out) among the first [`MAX_FLIGHTS`] elements of `evidence`.
pub(crate) fn flights_of(evidence: &[FlightEvidence], role: Role) -> Vec<&FlightEvidence> {
    let drawn = evidence.iter().take(MAX_FLIGHTS);
    drawn.filter(|f| f.role == role).collect()
}

/// Draws panels of residuals. In any layout but the widest, each series has at most `dots` dots.
pub(crate) fn residual_figure(
    layout: Layout,
    title: &str,
    panels: &[Panel],
    dots: usize,
) -> String {
    if layout == Layout::WIDE {
        return figure_of(layout, title, panels);
    }
    let mut fewer = panels.to_vec();
    for series in fewer.iter_mut().flat_map(|panel| &mut panel.dots) {
        series.points = stride(&series.points, dots);
    }
    figure_of(layout, title, &fewer)
}

/// Draws one figure for the residuals of the fitted flights and one for those of the held-out flights. A figure without
/// flights is omitted.
pub(in super::super) fn residuals(evidence: &[FlightEvidence], noise: &NoiseReport) -> Vec<Figure> {
    let figure = |of: FlightsOfRole<'_>| {
        let axes = ["x", "y", "z"].into_iter().enumerate();
        let panels = axes.map(|(i, axis)| {
            let sigma = noise.axes.get(axis).map_or(noise.sigma, |n| n.sigma);
            panel(&of.flights, i, axis, sigma)
        });
        let panels: Vec<Panel> = panels.collect();
        let caption = format!(
            "Residuals (measured − predicted), one flight after the other, one colour per marker; shaded: ±2 standard \
             deviations of the noise; crosses: outliers, at the edge if they are beyond it.{}",
            of.notes
        );
        let texts = [caption, of_panels(&panels)];
        Figure::in_layouts(of.name, of.title, texts, Layout::WIDE, &|layout| {
            residual_figure(layout, of.title, &panels, NARROW_DOTS)
        })
    };
    FlightsOfRole::all(evidence).map(figure).collect()
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
        for measured in points(flight, markers) {
            let time = start + measured.time - flight.times[0];
            let point = (time, measured.residual[axis]);
            if measured.is_outlier {
                outliers.push(point);
            } else if point.1.is_finite() {
                dots[measured.marker].push(point);
            }
        }
        let last = samples(flight).last().map_or(0.0, |s| flight.times[s]);
        let first = flight.times.first().copied().unwrap_or(0.0);
        start += (last - first).max(0.0);
    }
    let each = MAX_DOTS / markers.max(1);
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
