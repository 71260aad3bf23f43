//! Detection of the first contact of a flight; samples after it do not belong to free flight.

mod change;
mod smooth_motion;
#[cfg(test)]
pub(crate) mod tests;

pub use change::{MIN_UPWARD_PART, first_change};
use nalgebra::{UnitQuaternion, Vector3};

use crate::levels::OUTLIER_VARIANCE;
use crate::pose::Pose;
use crate::pose_points::PosePoints;
use crate::seen_path::seen_path;
use crate::statistics::median_of;

/// Least threshold of the residual variance of a pose, m².
const MIN_OUTLIER_VARIANCE: f64 = 1e-8;

/// Point of the measured path of a body: position of its origin, and attitude if known, in one sample.
#[derive(Clone, Copy, Debug)]
pub struct PathPoint {
    /// Index of the sample.
    pub sample: usize,
    /// Time, s.
    pub time: f64,
    /// Position of the body's origin, m.
    pub position: Vector3<f64>,
    /// Rotation from body to inertial components; `None` for a point mass or with an outlier.
    pub attitude: Option<UnitQuaternion<f64>>,
}

/// The first contact of a flight with the ground or an object.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// Index of the first sample after it.
    pub sample: usize,
    /// Description of the evidence for the contact, as text for messages.
    pub why: String,
}

/// Result of a search for the first contact of a flight with the ground or an object.
#[derive(Clone, Debug, Default)]
pub struct ContactSearch {
    /// The contact, if one was found.
    pub contact: Option<Contact>,
    /// Pose in each sample; empty for a point mass, and if none were computed.
    pub poses: Vec<Option<Pose>>,
}

impl ContactSearch {
    /// The result for the `samples` samples that follow the first `unseen` ones.
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

/// Path of the body's origin, from poses; for a point mass, from its markers. `points` returns the measured positions in a
/// sample.
pub fn path<'p>(
    body: &PosePoints,
    times: &[f64],
    poses: &[Option<Pose>],
    points: impl Fn(usize) -> &'p [Option<[f64; 3]>],
) -> Vec<PathPoint> {
    let limit = variance_limit(poses.iter().flatten().map(Pose::variance));
    let pose = |sample: usize| *poses.get(sample)?;
    let each = seen_path(body, times, points, pose).map(|seen| {
        let rigid = seen.pose.filter(|pose| pose.variance() <= limit);
        PathPoint {
            sample: seen.sample,
            time: seen.time,
            position: seen.position,
            attitude: rigid.map(|pose| pose.attitude),
        }
    });
    each.collect()
}

/// Residual variance of a pose, m², above which it contains an outlier, given those of all poses of the flight.
fn variance_limit(variances: impl Iterator<Item = f64>) -> f64 {
    let usual = median_of(variances).unwrap_or(0.0);
    (OUTLIER_VARIANCE * usual).max(MIN_OUTLIER_VARIANCE)
}
