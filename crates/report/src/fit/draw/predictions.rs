//! Figures of the predictions of held-out flights: prediction errors over time, with their expected 95 % band.

use dataset::Role;
use identify::{Fit, FlightEvidence, FlightId};

use super::{points, samples};
use crate::bands::{PredictionBand, WIDTH_95, prediction_band};
use crate::figure::Figure;
use crate::figures::{Dots, Layout, Look, Mark, Panel};
use crate::thin::{MAX_CURVE_POINTS, stride};

/// Maximum number of held-out flights whose prediction errors are drawn, one figure each.
const MAX_FLIGHTS: usize = 6;
/// Maximum number of dots with which a series of prediction errors is drawn.
const MAX_DOTS: usize = 400;

/// Draws one figure for each held-out flight: the errors of the predictions in `evidence`, which were made by the model
/// of `fit`. Errors of the predictions in `before`, which were made by another model, are drawn in grey.
pub(crate) fn predictions(
    fit: &Fit,
    evidence: &[FlightEvidence],
    before: &[FlightEvidence],
) -> Vec<Figure> {
    let held_out = evidence
        .iter()
        .filter(|f| f.role == Role::HeldOut && !f.markers.is_empty());
    let figures = held_out.take(MAX_FLIGHTS).enumerate();
    let figures = figures.filter_map(|(i, flight)| {
        let mut flights = fit.report.flights.iter();
        let index = flights.position(|f| f.file == flight.file)?;
        let band = prediction_band(fit, FlightId::new(index))?;
        let other = before.iter().find(|f| f.file == flight.file);
        Some(figure(i, flight, other, &band, fit.noise().sigma))
    });
    figures.collect()
}

fn figure(
    index: usize,
    flight: &FlightEvidence,
    before: Option<&FlightEvidence>,
    band: &PredictionBand,
    sigma: [f64; 3],
) -> Figure {
    let first = flight.times.get(band.first);
    let panel = |(axis, name): (usize, &str)| {
        let half = |sample: usize| {
            let errors = band.std_error.get(sample)?.iter().map(|error| error[axis]);
            let largest = errors.filter(|e| e.is_finite()).reduce(f64::max)?;
            Some(1e3 * WIDTH_95 * largest.hypot(sigma[axis]))
        };
        let ribbon = samples(flight).filter_map(|s| Some((flight.times[s], -half(s)?, half(s)?)));
        let ribbon: Vec<(f64, f64, f64)> = ribbon.collect();
        let dots = |look, of| Dots::new(look, stride(&errors(of, axis), MAX_DOTS));
        let pale = before.map(|before| dots(Look::Pale, before));
        let mark = first.map(|t| Mark::vertical("predicted from here", *t));
        Panel {
            dots: pale
                .into_iter()
                .chain([dots(Look::Colour(0), flight)])
                .collect(),
            ribbon: stride(&ribbon, MAX_CURVE_POINTS),
            marks: mark.filter(|_| axis == 0).into_iter().collect(),
            height: Some(84.0),
            ..Panel::new(
                format!("{name}, mm"),
                if axis == 2 { "time, s" } else { "" },
            )
        }
    };
    let panels: Vec<Panel> = ["x", "y", "z"].into_iter().enumerate().map(panel).collect();
    let grey = match before {
        Some(_) => "; grey: by the model before",
        None => "",
    };
    let caption = format!(
        "Measured − predicted, all markers{grey}. Shaded: where 95\u{a0}% of the points of a correct model lie, from the covariance \
         of the coefficients, of the initial state (fitted to the first 30\u{a0}%) and of the noise."
    );
    let name = format!("prediction-{:02}", index + 1);
    Figure::of_panels(name, &flight.file, caption, Layout::SMALL, &panels)
}

/// Times (s) and prediction errors (measured − predicted position, mm) of a flight along one axis of the inertial frame
/// (0 x, 1 y, 2 z), for all markers. Outliers and errors that are not finite are omitted.
fn errors(flight: &FlightEvidence, axis: usize) -> Vec<(f64, f64)> {
    let points = points(flight, flight.markers.len()).filter(|point| !point.is_outlier);
    let errors = points.map(|point| (point.time, point.residual[axis]));
    errors.filter(|(_, error)| error.is_finite()).collect()
}
