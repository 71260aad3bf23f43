//! Detection of the first contact of a flight; samples after it do not belong to free flight.

mod change;
mod halt;
mod smooth_motion;
#[cfg(test)]
mod tests;

pub(crate) use change::{MIN_UPWARD_PART, first_change};
use nalgebra::{UnitQuaternion, Vector3};

use crate::observations::Observations;
use crate::problem::FitProblem;
use dataset::pose::{Pose, point_position};
use dataset::statistics::median_of;

/// Ratio of the residual variance of a pose (of the marker positions about the fitted rigid body) to the median of
/// these variances over the flight, above which the sample contains an outlier.
const MAX_VARIANCE_RATIO: f64 = 25.0;
/// Minimum threshold, m², for the residual variance of a pose (of the marker positions about the fitted rigid body). A
/// sample with a variance above the threshold is considered to contain an outlier.
const MIN_OUTLIER_VARIANCE: f64 = 1e-8;

/// Point of the measured path of a body: position of its origin, and attitude if known, in one sample.
#[derive(Clone, Copy, Debug)]
pub struct PathPoint {
    /// Index of the sample in the flight's table.
    pub sample: usize,
    /// Time of the sample, s.
    pub time: f64,
    /// Position of the body's origin, m, inertial frame.
    pub position: Vector3<f64>,
    /// Attitude of the body: rotation from body to inertial components. `None` for a point mass, or if a marker
    /// position in this sample is an outlier.
    pub attitude: Option<UnitQuaternion<f64>>,
}

/// The first contact of a flight with the ground or an object.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// Index of the first sample after the contact with the ground or the object.
    pub sample: usize,
    /// Description of the evidence for the contact, as text for messages.
    pub why: String,
}

/// Result of a search for the first contact of a flight with the ground or an object.
#[derive(Clone, Debug, Default)]
pub struct ContactSearch {
    /// The first contact with the ground or an object; `None` if the search found none.
    pub contact: Option<Contact>,
    /// Pose in each sample of the flight, from which the contact with the ground was searched. Empty for a point mass,
    /// and if no poses were computed.
    pub poses: Vec<Option<Pose>>,
}

impl ContactSearch {
    /// The search result restricted to one part of the flight: the `samples` samples that follow its first `unseen`
    /// samples. The index of the contact counts from the start of this part; it is 0 for an earlier contact.
    pub fn of_part(&self, unseen: usize, samples: usize) -> Self {
        let poses = self
            .poses
            .get(unseen..)
            .and_then(|from| from.get(..samples));
        Self {
            contact: self.contact.as_ref().map(|contact| Contact {
                sample: contact.sample.saturating_sub(unseen),
                ..contact.clone()
            }),
            poses: poses.unwrap_or_default().to_vec(),
        }
    }
}

/// Truncates the observations of a flight before its first contact with the ground or an object. The contact is
/// searched for unless `search` contains the result of a search in these samples. Returns the poses in the remaining
/// samples; empty for a point mass.
pub fn truncate_at_contact(
    problem: &FitProblem,
    observations: &mut Observations,
    search: Option<ContactSearch>,
) -> Vec<Option<Pose>> {
    let (sought, known) = match search {
        Some(ContactSearch { contact, poses }) => (Some(contact), poses),
        None => (None, Vec::new()),
    };
    let mut poses = match known.is_empty() {
        true => observations.poses(problem),
        false => known,
    };
    let found = sought.unwrap_or_else(|| contact_of(problem, observations, &poses));
    let Some(Contact { sample, why }) = found else {
        return poses;
    };
    let time = observations.origin + observations.times[sample];
    observations.truncate(
        sample,
        format!("{why} at t = {time:.3} s, as at a touch of the ground"),
    );
    poses.truncate(sample);
    poses
}

fn contact_of(
    problem: &FitProblem,
    observations: &Observations,
    poses: &[Option<Pose>],
) -> Option<Contact> {
    let points = |sample: usize| observations.points(sample);
    let of_point_mass = (!problem.has_attitude).then_some(&problem.markers[..]);
    first_change(&path(&observations.times, poses, of_point_mass, &points))
}

/// Path of the body's origin, computed from the pose in each sample. For a point mass, `of_point_mass` contains the
/// positions of its markers on the body, and the path is computed from their measured positions. `points` returns the
/// measured positions in the sample with a given index.
pub fn path<'p>(
    times: &[f64],
    poses: &[Option<Pose>],
    of_point_mass: Option<&[[f64; 3]]>,
    points: &dyn Fn(usize) -> &'p [Option<[f64; 3]>],
) -> Vec<PathPoint> {
    let limit = variance_limit(poses.iter().flatten().map(Pose::variance));
    let each = times.iter().enumerate().filter_map(|(sample, &time)| {
        let pose = poses.get(sample).copied().flatten();
        let rigid = pose.filter(|pose| pose.variance() <= limit);
        Some(PathPoint {
            sample,
            time,
            position: match of_point_mass {
                Some(markers) => point_position(markers, points(sample))?,
                None => pose?.position,
            },
            attitude: rigid.map(|pose| pose.attitude),
        })
    });
    each.collect()
}

/// Threshold of the residual variance of a pose, m², above which the sample of the pose is considered to contain an
/// outlier. `variances` are the residual variances of all poses of the flight, m².
fn variance_limit(variances: impl Iterator<Item = f64>) -> f64 {
    let usual = median_of(variances).unwrap_or(0.0);
    (MAX_VARIANCE_RATIO * usual).max(MIN_OUTLIER_VARIANCE)
}
