//! The figures of a fit, one kind a file.

mod correlations;
mod histogram;
mod profiles;
pub(crate) mod residuals;
mod states;
mod tracks;
mod whiteness;

pub(super) use correlations::correlations;
pub(super) use histogram::histogram;
pub(super) use profiles::profiles;
pub(super) use residuals::residuals;
pub(super) use states::states;
pub(super) use tracks::tracks;
pub(super) use whiteness::whiteness;

use identify::FlightEvidence;

use super::Drawn;
use crate::figures::{Layout, Panel, figure_of};

/// Flights that are drawn at most.
pub(crate) const MOST_FLIGHTS: usize = 12;

pub(crate) fn small(name: String, title: String, caption: String, panels: &[Panel]) -> Drawn {
    let svg = figure_of(Layout::SMALL, &title, panels);
    Drawn::new(name, title, caption, svg)
}

/// The samples of a flight of which everything is there that a picture needs, whatever a caller put together.
fn samples(flight: &FlightEvidence) -> std::ops::Range<usize> {
    let lengths = [flight.measured.len(), flight.predicted.len()];
    0..lengths.into_iter().fold(flight.times.len(), usize::min)
}

/// Where a marker was seen.
fn seen(flight: &FlightEvidence, sample: usize, marker: usize) -> Option<[f64; 3]> {
    flight.measured[sample].get(marker).copied().flatten()
}

/// Whether a point was taken for an outlier.
fn is_outlier(flight: &FlightEvidence, sample: usize, marker: usize) -> bool {
    let row = flight.outlier.get(sample);
    row.and_then(|row| row.get(marker))
        .copied()
        .unwrap_or(false)
}

/// Where a marker should have been.
fn predicted(flight: &FlightEvidence, sample: usize, marker: usize) -> [f64; 3] {
    let row = flight.predicted[sample].get(marker);
    row.copied().unwrap_or([f64::NAN; 3])
}
