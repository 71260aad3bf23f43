//! Figures of the fit report, one kind of figure per file.

mod correlations;
mod histogram;
mod precision;
mod predictions;
mod profiles;
mod residuals;
mod states;
mod tracks;
mod whiteness;

pub(super) use correlations::correlations;
pub(super) use histogram::histogram;
pub(super) use precision::precision;
pub(crate) use predictions::predictions;
pub(super) use profiles::profiles;
pub(crate) use residuals::residuals;
pub(super) use states::states;
pub(super) use tracks::tracks;
pub(super) use whiteness::whiteness;

use identify::FlightEvidence;

/// Sentence on the number of items that a figure leaves out, with a leading space; empty if it leaves out none. `what`
/// describes the items, such as `more flights`.
pub(crate) fn not_drawn(number: usize, what: &str) -> String {
    match number {
        0 => String::new(),
        n => format!(" {n} {what} are not drawn."),
    }
}

/// Range of the indices of the samples of a flight for which times, measurements and predictions all exist.
fn samples(flight: &FlightEvidence) -> std::ops::Range<usize> {
    let lengths = [flight.measured.len(), flight.predicted.len()];
    0..lengths.into_iter().fold(flight.times.len(), usize::min)
}

/// Measured position of a marker at a sample.
struct MeasuredPoint {
    /// Time of the sample, s.
    time: f64,
    /// Index of the marker among the markers of the flight.
    marker: usize,
    /// Measured position, m, in the inertial frame.
    measured: [f64; 3],
    /// Measured − predicted position, mm; NaN if there is no prediction.
    residual: [f64; 3],
    /// Whether the measurement was classified as an outlier; false if unknown.
    is_outlier: bool,
}

/// Measured positions of the first `markers` markers of a flight, sample by sample.
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

/// Predicted position of a marker at a sample, m, in the inertial frame; NaN if there is no prediction.
fn predicted(flight: &FlightEvidence, sample: usize, marker: usize) -> [f64; 3] {
    let row = flight.predicted[sample].get(marker);
    row.copied().unwrap_or([f64::NAN; 3])
}
