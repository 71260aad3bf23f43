//! Detection of the first contact of a flight; samples after it do not belong to free flight.

mod designs;
mod halt;
mod impact_detection;
mod motion;
mod motion_fits;
mod onset;
mod regression;
#[cfg(test)]
mod tests;
mod touch;
mod wobble;

use nalgebra::{UnitQuaternion, Vector3};

use crate::observations::Observations;
use crate::pose::{Pose, point_position, pose};
use crate::problem::FitProblem;
use crate::statistics::median;

/// Ratio of the residual variance of a pose (of the marker positions about the fitted rigid body) to the median over
/// the flight, above which the sample contains an outlier.
const MAX_VARIANCE_RATIO: f64 = 25.0;
/// Lower limit of the threshold of the residual variance of a pose, m², above which the sample of the pose is
/// considered to contain an outlier.
const MIN_OUTLIER_VARIANCE: f64 = 1e-8;

/// Maximum difference, in samples, between a contact detected from the path and one detected from the attitude, for
/// both to be the same contact.
const SAME: usize = 4;

/// Sample index, time (s) and position (m) of the body's origin.
pub type PathPoint = (usize, f64, Vector3<f64>);

/// A point of a path, with the rotation from body components to inertial components.
pub type Posed = (PathPoint, UnitQuaternion<f64>);

/// The first contact of a flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// Index of the first sample after the contact.
    pub sample: usize,
    /// Description of the evidence for the contact, as text for messages.
    pub why: String,
}

/// Result of a search for the first contact of a flight.
#[derive(Clone, Debug, Default)]
pub struct ContactSearch {
    /// The first contact; `None` if the search found none.
    pub contact: Option<Contact>,
    /// Pose in each sample of the flight, from which the contact was searched. Empty for a point mass, and if no poses
    /// were computed.
    pub poses: Vec<Option<Pose>>,
}

impl ContactSearch {
    /// The same result for a flight of `samples` samples without the first `unseen` ones of this flight.
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

/// Truncates a flight before its first contact. The contact is searched for unless `search` contains the result of a
/// search in the samples of `observations`. Returns the poses in the remaining samples; empty for a point mass.
pub fn truncate_at_contact(
    problem: &FitProblem,
    observations: &mut Observations,
    search: Option<ContactSearch>,
) -> Vec<Option<Pose>> {
    let samples = 0..observations.times.len();
    let (sought, known) = match search {
        Some(ContactSearch { contact, poses }) => (Some(contact), poses),
        None => (None, Vec::new()),
    };
    let mut poses: Vec<Option<Pose>> = match problem.has_attitude && known.is_empty() {
        true => samples
            .map(|sample| pose(&problem.markers, observations.points(sample)))
            .collect(),
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
    let samples = 0..observations.times.len();
    let position = |sample: usize| match problem.has_attitude {
        true => poses[sample].map(|pose| pose.position),
        false => point_position(&problem.markers, observations.points(sample)),
    };
    let point = |sample: usize| Some((sample, observations.times[sample], position(sample)?));
    let path: Vec<PathPoint> = samples.clone().filter_map(point).collect();
    let limit = variance_limit(poses.iter().flatten().map(Pose::variance));
    let posed = samples.filter_map(|sample| {
        let pose = (*poses.get(sample)?).filter(|pose| pose.variance() <= limit)?;
        Some((point(sample)?, pose.attitude))
    });
    contact(&path, &posed.collect::<Vec<Posed>>())
}

/// Threshold of the residual variance of a pose, m², above which the sample of the pose is considered to contain an
/// outlier. `variances` are the residual variances of all poses of the flight, m².
pub fn variance_limit(variances: impl Iterator<Item = f64>) -> f64 {
    let limit = MAX_VARIANCE_RATIO * median(&mut variances.collect::<Vec<f64>>());
    limit.max(MIN_OUTLIER_VARIANCE)
}

/// Finds the first contact of a body from the path of its origin and from its attitude; `None` if there is none.
/// `posed` contains the points of the path that have an attitude; it is empty for a point mass.
pub fn contact(path: &[PathPoint], posed: &[Posed]) -> Option<Contact> {
    let of_path = impact_detection::impact(path).map(|impact| Contact {
        sample: path[impact.index].0,
        why: format!(
            "the velocity jumps by ({:.1}, {:.1}, {:.1}) m/s",
            impact.jump.x, impact.jump.y, impact.jump.z
        ),
    });
    let of_attitude = touch::touch(posed).map(|touch| Contact {
        sample: touch.sample,
        why: format!(
            "the body is turned aside and its velocity jumps up by {:.1} m/s",
            touch.jump
        ),
    });
    match (of_path, of_attitude) {
        // For a hard impact, the detection on the path is late, because the rest of the rim hits later, and that by the
        // attitude is early.
        (Some(path), Some(touch))
            if (touch.sample..=touch.sample + SAME).contains(&path.sample) =>
        {
            Some(Contact {
                sample: touch.sample.midpoint(path.sample),
                ..touch
            })
        }
        (of_path, of_attitude) => {
            let both = of_path.into_iter().chain(of_attitude);
            both.min_by_key(|contact| contact.sample)
        }
    }
}
