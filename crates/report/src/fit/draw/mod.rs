//! Figures of the fit report, one kind of figure per file.

mod correlations;
mod histogram;
mod precision;
mod predictions;
mod profiles;
pub(crate) mod residuals;
mod states;
mod tracks;
mod whiteness;

pub(super) use correlations::correlations;
pub(super) use histogram::histogram;
pub(super) use precision::precision;
pub(crate) use predictions::predictions;
pub(super) use profiles::profiles;
pub(super) use residuals::residuals;
pub(super) use states::states;
pub(super) use tracks::tracks;
pub(super) use whiteness::whiteness;

use identify::FlightEvidence;

use super::Drawn;
use crate::figures::csv::of_panels;
use crate::figures::{Layout, Panel, figure_of};

/// Maximum number of flights in a figure that shows all flights, and maximum number of figures of single flights.
pub(crate) const MOST_FLIGHTS: usize = 12;

/// Draws the panels in the small layout as a figure with CSV data.
pub(crate) fn small(name: String, title: String, caption: String, panels: &[Panel]) -> Drawn {
    let svg = figure_of(Layout::SMALL, &title, panels);
    Drawn::new(name, title, [caption, svg, of_panels(panels)])
}

/// Range of sample indices for which times, measurements and predictions all exist.
fn samples(flight: &FlightEvidence) -> std::ops::Range<usize> {
    let lengths = [flight.measured.len(), flight.predicted.len()];
    0..lengths.into_iter().fold(flight.times.len(), usize::min)
}

/// Measured position of a marker at a sample, m; `None` if missing.
fn seen(flight: &FlightEvidence, sample: usize, marker: usize) -> Option<[f64; 3]> {
    flight.measured[sample].get(marker).copied().flatten()
}

/// Whether a measured marker position was classified as an outlier; false if unknown.
fn is_outlier(flight: &FlightEvidence, sample: usize, marker: usize) -> bool {
    let row = flight.outlier.get(sample);
    row.and_then(|row| row.get(marker))
        .copied()
        .unwrap_or(false)
}

/// Predicted position of a marker at a sample, m; NaN if there is no prediction.
fn predicted(flight: &FlightEvidence, sample: usize, marker: usize) -> [f64; 3] {
    let row = flight.predicted[sample].get(marker);
    row.copied().unwrap_or([f64::NAN; 3])
}
