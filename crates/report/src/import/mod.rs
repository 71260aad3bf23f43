//! HTML page of an import: what was decided about each recording, and each flight as it was cut.

mod draw;
mod page;

/// Contents of the page of an import.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportPage {
    /// Name of the dataset.
    pub dataset: String,
    /// Name of its model.
    pub model: String,
    /// The recordings, in the order in which they were read.
    pub takes: Vec<ImportedTake>,
}

/// What was decided about one recording.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportedTake {
    /// File of the recording.
    pub file: String,
    /// Decisions: what about, and what was decided.
    pub decisions: Vec<(String, String)>,
    /// What was set aside, left out or doubted.
    pub notes: Vec<String>,
    /// Height of the followed body over the take: time, s, and height, m; not finite where it was not seen.
    pub heights: Vec<(f64, f64)>,
    /// Its flights.
    pub flights: Vec<ImportedFlight>,
}

/// One flight that was cut from a recording.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportedFlight {
    /// Table in the dataset.
    pub file: String,
    /// Number of samples.
    pub samples: usize,
    /// Its beginning.
    pub release: Edge,
    /// Its end.
    pub end: Edge,
    /// Times of the first and the last sample, s.
    pub span: (f64, f64),
    /// Gaps in which the body was not seen: from and to, s.
    pub gaps: Vec<(f64, f64)>,
    /// Markers that were not seen in every sample, with the number of samples without them.
    pub missing: Vec<(String, usize)>,
    /// Curves over the time of the take around the flight.
    pub curves: Vec<Curve>,
    /// Distances between pairs of markers.
    pub distances: Vec<Distance>,
}

/// Where a flight begins or ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    /// Time, s.
    pub time: f64,
    /// Why the flight was cut there.
    pub reason: String,
}

/// A quantity over the time of a take.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// What it is, with its unit.
    pub title: String,
    /// Time, s, and value; not finite where there is none.
    pub points: Vec<(f64, f64)>,
}

/// The distance between two markers of a rigid body.
#[derive(Clone, Debug, PartialEq)]
pub struct Distance {
    /// Name of the pair.
    pub name: String,
    /// Distance in the template, m.
    pub template: f64,
    /// Time, s, and measured distance, m, around the flight; not finite where one was not seen.
    pub points: Vec<(f64, f64)>,
}

impl ImportedFlight {
    /// Whether a time is within the flight.
    fn holds(&self, time: f64) -> bool {
        self.span.0 <= time && time <= self.span.1
    }
}

/// Self-contained page of an import.
pub fn html(page: &ImportPage) -> String {
    page::html(page)
}
