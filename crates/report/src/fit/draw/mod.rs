//! Figures of the fit report, one kind of figure per file.

mod estimates;
mod flights;
mod predictions;
mod residuals;

pub(super) use estimates::{correlations, histogram, precision, profiles, whiteness};
pub(crate) use flights::inputs;
pub(super) use flights::{states, tracks};
pub(crate) use predictions::predictions;
pub(crate) use residuals::residuals;

use identify::FlightEvidence;

/// Sentence on the number of items that a figure leaves out, with a leading space.
pub(crate) fn not_drawn(number: usize, what: &str) -> String {
    match number {
        0 => String::new(),
        n => format!(" {n} {what} are not drawn."),
    }
}

/// Indices of the samples with times, measurements and predictions.
fn samples(flight: &FlightEvidence) -> std::ops::Range<usize> {
    let lengths = [flight.measured.len(), flight.predicted.len()];
    0..lengths.into_iter().fold(flight.times.len(), usize::min)
}

struct MeasuredPoint {
    /// Time, s.
    time: f64,
    marker: usize,
    /// Position in the inertial frame, m.
    measured: [f64; 3],
    /// Measured − predicted, mm; NaN if there is no prediction.
    residual: [f64; 3],
    is_outlier: bool,
}

/// Measured positions of the first `markers` markers, sample by sample.
fn points(flight: &FlightEvidence, markers: usize) -> impl Iterator<Item = MeasuredPoint> {
    let at = move |sample: usize, marker: usize| {
        let measured = flight.measured[sample].get(marker).copied().flatten()?;
        let predicted = predicted(flight, sample, marker);
        let outliers = flight.outlier.get(sample);
        let is_outlier = outliers.and_then(|row| row.get(marker).copied());
        Some(MeasuredPoint {
            time: flight.times[sample],
            marker,
            measured,
            residual: [0, 1, 2].map(|axis| 1e3 * (measured[axis] - predicted[axis])),
            is_outlier: is_outlier.unwrap_or(false),
        })
    };
    samples(flight).flat_map(move |sample| (0..markers).filter_map(move |k| at(sample, k)))
}

/// Predicted position in the inertial frame, m; NaN if there is none.
fn predicted(flight: &FlightEvidence, sample: usize, marker: usize) -> [f64; 3] {
    let row = flight.predicted[sample].get(marker);
    row.copied().unwrap_or([f64::NAN; 3])
}
