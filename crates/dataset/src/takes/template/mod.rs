//! Estimation of the marker positions on a body from its free flights, without a flight model: shape, spin axis, centre
//! of mass.
//!
//! The shape consists of the marker positions that the samples have in common up to a rotation and a translation
//! ([`shape`]). The spin axis is the direction of the body, and the centre of mass the point of the body, whose
//! trajectories contain no component that rotates with the body ([`centre`]). Body frame: the third axis is the spin
//! axis, upwards at the release; the first axis points towards the first marker; the origin is the centre of mass.

mod air;
mod centre;
mod frame;
mod shape;
mod smooth;
mod text;

use flight::table::listed;

/// Times and measured marker positions of the samples of one free flight.
#[derive(Clone, Copy, Debug)]
pub struct FreeFlight<'a> {
    /// Times of the samples, s, increasing.
    pub times: &'a [f64],
    /// `positions[sample][marker]`, m, right-handed axes with z up; `None` where the marker was not seen.
    pub positions: &'a [Vec<Option<[f64; 3]>>],
}

/// Body template estimated from free flights: marker positions and centre of mass, with their uncertainty.
#[derive(Clone, Debug, PartialEq)]
pub struct EstimatedTemplate {
    /// Markers with their estimated positions, in the order of the labels from which the template was estimated.
    pub markers: Vec<EstimatedMarker>,
    /// Estimated standard deviation of one coordinate of a measured marker position, m.
    pub sigma: f64,
    /// Source of the height of the centre of mass along the spin axis.
    pub height: CentreHeight,
    /// Standard error of the direction of the third body axis, rad: the greatest over the directions normal to it.
    pub tilt_error: f64,
    /// Numbers of flights that begin with the third body axis up and down, which decide its sign; `None` if equal.
    pub up: Option<UpVote>,
    /// Index of the marker that the first body axis points to.
    pub first: usize,
    /// Number of flights with at least one sample in which the attitude of the body was determined.
    pub flights: usize,
    /// Number of samples, over all flights, in which the attitude of the body was determined.
    pub samples: usize,
    /// Number of measured marker positions left out as outliers.
    pub outliers: usize,
    /// Number of turns of the body about its spin axis, summed over all flights.
    pub turns: f64,
}

/// A marker of the body with its estimated position.
#[derive(Clone, Debug, PartialEq)]
pub struct EstimatedMarker {
    /// Label of the marker in the recording.
    pub label: String,
    /// Position in the body frame, m: the origin is the centre of mass, the third axis the spin axis (upwards at the
    /// beginning of most flights), and the first points to the marker [`EstimatedTemplate::first`].
    pub position: [f64; 3],
    /// Standard errors of the marker position along the body axes, m. If the height of the centre of mass was not
    /// estimated, the third value is the error of the marker's height relative to the other markers only.
    pub std_error: [f64; 3],
}

/// Source of the height of the centre of mass along the spin axis. Heights are relative to the mean of the markers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CentreHeight {
    /// The height is estimated from the wobble of the body in the flights.
    Estimated {
        /// Estimated height of the centre of mass along the spin axis, relative to the mean of the markers, m.
        height: f64,
        /// Standard error of the estimated height, m.
        std_error: f64,
    },
    /// The height is stated by the user.
    Stated {
        /// Stated height of the centre of mass along the spin axis, relative to the mean of the markers, m.
        height: f64,
        /// Estimate, from the flights, of the height that the user stated, for comparison, and its standard error, m.
        shown: Option<(f64, f64)>,
    },
    /// The height is assumed to be 0, the mean height of the markers, because the flights do not determine it.
    Assumed {
        /// Standard error of the unused estimate of the height from the flights, m.
        std_error: Option<f64>,
    },
}

/// Numbers of flights that begin with the third body axis upwards and downwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UpVote {
    /// Number of flights with the third body axis upwards at the release.
    pub for_it: usize,
    /// Number of flights with the third body axis downwards at the release.
    pub against: usize,
}

/// Reason why no body template (marker positions on the body and centre of mass) can be estimated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TemplateError {
    /// There are fewer than 3 markers, too few for an attitude.
    #[error(
        "found {} ({}), expected at least 3 points that move as one body, or a template by --markers",
        count(.0.len(), "point"), listed(.0)
    )]
    FewPoints(Vec<String>),
    /// A marker is never seen together with enough other markers to determine its position on the body.
    #[error(
        "found no sample that places {0} among the other points, expected it with 3 others or more, or a template by --markers"
    )]
    Unplaced(String),
    /// The markers lie on a line, which does not fix the attitude.
    #[error(
        "found the points on a line, expected points that fix an attitude, or a template by --markers"
    )]
    Collinear,
    /// No flight has enough samples in which at least 3 points are seen.
    #[error(
        "found {found} samples with at least 3 points, expected {expected} or more in a flight, or a template by --markers"
    )]
    FewSamples {
        /// Greatest number, over the flights, of samples in which at least 3 points are seen.
        found: usize,
        /// Minimum number of samples in which at least 3 points are seen, required in at least one flight.
        expected: usize,
    },
    /// The body does not spin about one axis.
    #[error(
        "found {0:.1} turns of the body in all flights without one axis of spin, expected a body that spins about its axis, or a template by --markers"
    )]
    NoSpin(f64),
}

/// Minimum standard error reported for the centre of mass along the spin axis, m, if its height is assumed.
const ASSUMED: f64 = 0.02;

/// Number of standard errors of an estimated template within which a fit of the same flights may move it: the fit sees
/// the same noise again, and a bounce or a drift, which an estimate without a model does not see, is none.
const ALLOWED: f64 = 5.0;

impl EstimatedTemplate {
    /// Allowed errors of the centre of mass along the axes of the body for a fit of the same flights, m: several standard
    /// errors, rounded up to 1 µm; 0 along the third axis if the user stated the height of the centre of mass.
    pub fn origin_error(&self) -> [f64; 3] {
        let across = |axis: usize| {
            let each = self.markers.iter().map(|marker| marker.std_error[axis]);
            each.fold(0.0, f64::max)
        };
        let along = match self.height {
            CentreHeight::Estimated { std_error, .. } => ALLOWED * std_error,
            CentreHeight::Stated { .. } => 0.0,
            CentreHeight::Assumed { std_error } => std_error.unwrap_or(ASSUMED).max(ASSUMED),
        };
        [ALLOWED * across(0), ALLOWED * across(1), along].map(rounded_up)
    }

    /// Allowed error of the third body axis for a fit of the same flights, rad: several standard errors, rounded up.
    pub fn axis_error(&self) -> f64 {
        rounded_up(ALLOWED * self.tilt_error)
    }
}

/// Standard error rounded up to a millionth: more digits would pretend a precision that no estimate has.
fn rounded_up(error: f64) -> f64 {
    (error * 1e6).ceil() / 1e6
}

/// Formats a count with its noun in the singular or plural, such as `1 flight` or `2 flights`.
fn count(number: usize, noun: &str) -> String {
    match number {
        1 => format!("1 {noun}"),
        _ => format!("{number} {noun}s"),
    }
}

/// Minimum samples with an attitude for a flight to contribute to the spin axis and the centre of mass.
const MIN_SAMPLES: usize = 12;

/// Estimates the positions of the labelled markers from free flights of their body.
///
/// `centre_height` is the height of the centre of mass above the mean of the markers along the third body axis, m. If
/// it is `None`, it is estimated if the flights determine it, or assumed to be 0.
///
/// # Errors
/// [`TemplateError`] if the flights do not determine the shape or the spin axis.
pub fn estimate_template(
    labels: &[String],
    flights: &[FreeFlight<'_>],
    centre_height: Option<f64>,
) -> Result<EstimatedTemplate, TemplateError> {
    let shape = shape::shape(labels, flights)?;
    let centre = centre::centre(&shape, flights)?;
    Ok(frame::template(labels, &shape, &centre, centre_height))
}
