//! HTML page of an import: decisions made on each recording, and each flight that was cut from it.

mod data;
mod draw;
mod page;

/// Input of the HTML page that reports an import of motion-capture recordings.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportPage {
    /// Name of the imported dataset.
    pub dataset: String,
    /// Name of the model that the imported dataset specifies.
    pub model: String,
    /// Imported recordings, in the order in which they were read.
    pub takes: Vec<ImportedTake>,
}

/// Choices of the import, notes and flights of one imported recording.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportedTake {
    /// File name of the imported recording.
    pub file: String,
    /// Choices that the import made, such as units and axes: pairs of subject and choice, as text.
    pub decisions: Vec<(String, String)>,
    /// Notes on parts of the recording that were excluded or are uncertain.
    pub notes: Vec<String>,
    /// Height of the tracked body during the whole recording: pairs of time on the time axis of the recording, s, and
    /// height, m; the height is not finite at times at which the body was not tracked.
    pub heights: Vec<(f64, f64)>,
    /// Free flights that were extracted from the recording.
    pub flights: Vec<ImportedFlight>,
}

/// One free flight that an import extracted from a recording.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportedFlight {
    /// File name of the flight's table of measurements in the imported dataset.
    pub file: String,
    /// Number of samples between the beginning and the end of the flight.
    pub samples: usize,
    /// Beginning of the flight, with the reason why it was placed there.
    pub release: Edge,
    /// End of the flight, with the reason why it was placed there.
    pub end: Edge,
    /// Times of the first and the last sample of the flight, s, on the time axis of the recording, which need not start
    /// at 0.
    pub span: (f64, f64),
    /// Gaps in which no marker of the body was measured: pairs of the times of the last sample before and the first
    /// sample after the gap, s, on the time axis of the recording.
    pub gaps: Vec<(f64, f64)>,
    /// Markers with missing samples: pairs of marker name and number of missing samples.
    pub missing: Vec<(String, usize)>,
    /// Quantities of the body's motion over the time of the recording, during the flight and shortly before and after
    /// it.
    pub curves: Vec<Curve>,
    /// Measured distances between pairs of markers over time.
    pub distances: Vec<Distance>,
}

/// Begin or end of a flight in a recording.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    /// Time at which the flight begins or ends, s, on the time axis of the recording, which need not start at 0.
    pub time: f64,
    /// Reason why the flight begins or ends at this time, as text.
    pub reason: String,
}

/// Curve of a quantity over the time of a recording.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Name of the quantity, with its unit.
    pub title: String,
    /// Pairs of time on the time axis of the recording, s, and value; the value is not finite where it is missing.
    pub points: Vec<(f64, f64)>,
}

/// Distance between two markers of a rigid body over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Distance {
    /// Names of the two markers, as one text.
    pub name: String,
    /// Distance between the two markers on the body, according to the declared marker positions, m.
    pub template: f64,
    /// Pairs of time on the time axis of the recording, s, and measured distance, m, during the flight and shortly
    /// before and after it; the distance is not finite where a marker is missing.
    pub points: Vec<(f64, f64)>,
}

impl ImportedFlight {
    /// Whether a time in the recording, s, is between the first and the last sample of the flight.
    fn holds(&self, time: f64) -> bool {
        self.span.0 <= time && time <= self.span.1
    }
}

/// Renders the self-contained HTML page that reports an import of recordings.
pub fn html(page: &ImportPage) -> String {
    page::html(page)
}
