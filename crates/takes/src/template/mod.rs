//! Positions of the markers on the body from its free flights, without a model: shape, axis of the spin, centre of mass.
//!
//! The shape is what the samples agree on up to a rotation and a translation ([`shape`]). The axis of the spin is the direction
//! of the body, and the centre of mass the point of the body, whose paths have no part that turns with the body ([`centre`]).
//! Third axis of the body frame: the axis of the spin, upwards at the release; first axis: towards the first marker; origin: the
//! centre of mass.

mod air;
mod centre;
mod frame;
mod shape;
mod smooth;
mod text;

use crate::words::listed;

/// One free flight: its samples.
#[derive(Clone, Copy, Debug)]
pub struct FreeFlight<'a> {
    /// Times of the samples, s, increasing.
    pub times: &'a [f64],
    /// `positions[sample][marker]`, m, right-handed axes with z up; `None` where the marker was not seen.
    pub positions: &'a [Vec<Option<[f64; 3]>>],
}

/// A body as its flights show it.
#[derive(Clone, Debug, PartialEq)]
pub struct EstimatedTemplate {
    /// The markers, in the order of their labels.
    pub markers: Vec<EstimatedMarker>,
    /// Standard deviation of one coordinate of a measured position, m.
    pub sigma: f64,
    /// How the position of the centre of mass along the axis of the spin was found.
    pub height: CentreHeight,
    /// Standard error of the direction of the third axis, rad: the greater of two directions across it.
    pub tilt_error: f64,
    /// Whether the third axis points up at the release; `None` where the flights do not decide it.
    pub up: Option<UpVote>,
    /// Index of the marker that the first axis points to.
    pub first: usize,
    /// Number of flights.
    pub flights: usize,
    /// Number of samples with an attitude.
    pub samples: usize,
    /// Positions of single markers that were left out as outliers.
    pub outliers: usize,
    /// Turns of the body about its axis in all flights.
    pub turns: f64,
}

/// A marker of the body.
#[derive(Clone, Debug, PartialEq)]
pub struct EstimatedMarker {
    /// Label in the take.
    pub label: String,
    /// Position in the body frame, m.
    pub position: [f64; 3],
    /// Standard errors of the position, m. Where the height of the centre of mass was not estimated, that of the third
    /// coordinate is the error of the marker's height relative to the other markers alone.
    pub std_error: [f64; 3],
}

/// Source of the position of the centre of mass along the axis of the spin. Heights are relative to the mean of the markers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CentreHeight {
    /// From the wobble of the flights.
    Estimated {
        /// The height, m.
        height: f64,
        /// Its standard error, m.
        std_error: f64,
    },
    /// As the option states.
    Stated {
        /// The height, m.
        height: f64,
        /// What the flights show: height and standard error, m; `None` where they do not determine it.
        shown: Option<(f64, f64)>,
    },
    /// Assumed as 0, in the plane of the markers' mean: the flights do not determine it.
    Assumed {
        /// Standard error that an estimate would have, m; `None` where the axis does not move.
        std_error: Option<f64>,
    },
}

/// How many flights begin with the third axis upwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UpVote {
    /// Flights with the third axis upwards at the release.
    pub for_it: usize,
    /// Flights with the third axis downwards.
    pub against: usize,
}

/// Why no template can be estimated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TemplateError {
    /// Too few markers for an attitude.
    #[error(
        "found {} ({}), expected at least 3 points that move as one body, or a template by --markers",
        count(labels.len(), "point"), listed(labels.iter().map(String::as_str))
    )]
    FewPoints {
        /// Labels of the points.
        labels: Vec<String>,
    },
    /// A marker is never seen together with others that fix the attitude.
    #[error(
        "found no sample that places {label} among the other points, expected it with 3 others or more, or a template by --markers"
    )]
    Unplaced {
        /// Label of the marker.
        label: String,
    },
    /// The markers lie on a line.
    #[error(
        "found the points on a line, expected points that fix an attitude, or a template by --markers"
    )]
    Collinear,
    /// Too few samples.
    #[error(
        "found {found} samples with at least 3 points, expected {expected} or more in a flight, or a template by --markers"
    )]
    FewSamples {
        /// Greatest number of samples of a flight.
        found: usize,
        /// Least number of samples.
        expected: usize,
    },
    /// The body does not turn about one axis.
    #[error(
        "found {turns:.1} turns of the body in all flights without one axis of spin, expected a body that spins about its axis, or a template by --markers"
    )]
    NoSpin {
        /// Turns of the body in all flights.
        turns: f64,
    },
}

/// Least standard error of the centre of mass along the axis where it is assumed, m.
const ASSUMED: f64 = 0.02;

impl EstimatedTemplate {
    /// Standard errors of the centre of mass along the axes of the body, m; 0 along an axis where it is stated.
    pub fn origin_error(&self) -> [f64; 3] {
        let across = |axis: usize| {
            let each = self.markers.iter().map(|marker| marker.std_error[axis]);
            each.fold(0.0, f64::max)
        };
        let along = match self.height {
            CentreHeight::Estimated { std_error, .. } => std_error,
            CentreHeight::Stated { .. } => 0.0,
            CentreHeight::Assumed { std_error } => std_error.unwrap_or(ASSUMED).max(ASSUMED),
        };
        // Finer digits than a micrometre would pretend what no estimate knows.
        [across(0), across(1), along].map(|error| (error * 1e6).ceil() / 1e6)
    }
}

/// A number with its noun.
fn count(number: usize, noun: &str) -> String {
    match number {
        1 => format!("1 {noun}"),
        _ => format!("{number} {noun}s"),
    }
}

/// Least number of samples of a flight.
const LEAST_SAMPLES: usize = 12;

/// Positions of the labelled markers from free flights of their body.
///
/// `centre_height` is the height of the centre of mass above the mean of the markers along the third axis, m, where it is known;
/// otherwise it is estimated if the flights determine it.
///
/// # Errors
/// [`TemplateError`] if the flights do not determine shape or axis.
pub fn estimate_template(
    labels: &[String],
    flights: &[FreeFlight<'_>],
    centre_height: Option<f64>,
) -> Result<EstimatedTemplate, TemplateError> {
    let shape = shape::shape(labels, flights)?;
    let centre = centre::centre(&shape, flights)?;
    Ok(frame::template(labels, &shape, &centre, centre_height))
}
