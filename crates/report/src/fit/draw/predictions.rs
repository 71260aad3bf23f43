//! Figures of the predictions of held-out flights: prediction errors over time, with their expected 95 % band.

use dataset::Role;
use identify::{Fit, FlightEvidence, FlightId};

use super::{points, samples};
use crate::bands::{PredictionBand, WIDTH_95, prediction_band};
use crate::figure::Figure;
use crate::figures::{Dots, Layout, Look, Mark, Panel};
use crate::thin::{MAX_CURVE_POINTS, stride};

const MAX_FLIGHTS: usize = 6;
const MAX_DOTS: usize = 400;

/// Prediction errors of each held-out flight by the model of `fit`, and in grey those of another model.
pub(crate) fn predictions(
    fit: &Fit,
    evidence: &[FlightEvidence],
    before: &[FlightEvidence],
) -> Vec<Figure> {
    let is_held_out = |f: &&FlightEvidence| f.role == Role::HeldOut && !f.markers.is_empty();
    let held_out = evidence.iter().filter(is_held_out);
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
        let across = if axis == 2 { "time, s" } else { "" };
        let dots = pale.into_iter().chain([dots(Look::Colour(0), flight)]);
        Panel {
            dots: dots.collect(),
            ribbon: stride(&ribbon, MAX_CURVE_POINTS),
            marks: mark.filter(|_| axis == 0).into_iter().collect(),
            height: Some(84.0),
            ..Panel::new(format!("{name}, mm"), across)
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

/// Times (s) and prediction errors (mm) of all markers along one axis, without outliers.
fn errors(flight: &FlightEvidence, axis: usize) -> Vec<(f64, f64)> {
    let points = points(flight, flight.markers.len()).filter(|point| !point.is_outlier);
    let errors = points.map(|point| (point.time, point.residual[axis]));
    errors.filter(|(_, error)| error.is_finite()).collect()
}
