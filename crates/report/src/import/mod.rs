//! HTML page of an import: decisions made on each recording, and each flight that was cut from it.

mod data;
mod draw;
mod page;

use crate::figures::Line;

/// Input of the page of an import.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportPage {
    /// Name of the dataset.
    pub dataset: String,
    /// Name of its model.
    pub model: String,
    /// Recordings, in the order in which they were read.
    pub takes: Vec<ImportedTake>,
}

/// Choices, notes and flights of one recording.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportedTake {
    /// File name of the recording.
    pub file: String,
    /// Choices such as units and axes: subject and choice.
    pub decisions: Vec<(String, String)>,
    /// Notes on parts that were excluded or are uncertain.
    pub notes: Vec<String>,
    /// Height of the body, m, over the time of the recording, s; not finite where it was not tracked.
    pub heights: Vec<(f64, f64)>,
    /// Free flights.
    pub flights: Vec<ImportedFlight>,
}

/// A free flight of a recording; times are those of the recording, s.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportedFlight {
    /// File name of its table in the dataset.
    pub file: String,
    /// Number of samples.
    pub samples: usize,
    /// Beginning.
    pub release: Edge,
    /// End.
    pub end: Edge,
    /// Times of the first and the last sample.
    pub span: (f64, f64),
    /// Gaps in which no marker was measured: times of the last sample before and the first after.
    pub gaps: Vec<(f64, f64)>,
    /// Markers with missing samples, and their numbers.
    pub missing: Vec<(String, usize)>,
    /// Quantities of the motion, during the flight and shortly before and after it; not finite where they are missing.
    pub curves: Vec<Line>,
    /// Distances between pairs of markers.
    pub distances: Vec<Distance>,
}

/// Begin or end of a flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    /// Time.
    pub time: f64,
    /// Reason why the flight begins or ends there.
    pub reason: String,
}

/// Distance between two markers of a rigid body over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Distance {
    /// Names of the two markers.
    pub name: String,
    /// Distance on the body, m.
    pub template: f64,
    /// Time and measured distance, m; not finite where a marker is missing.
    pub points: Vec<(f64, f64)>,
}

impl ImportedFlight {
    /// Whether a time is between the first and the last sample.
    fn holds(&self, time: f64) -> bool {
        self.span.0 <= time && time <= self.span.1
    }
}

pub use page::html;
