//! Motion of a rigid cluster of points: centroid and attitude at each sample in which it is seen.

use nalgebra::{Matrix3, Vector3};

use super::cluster::rigid_points;
use crate::pose::rigid_motion;
use crate::sensor::attitude;
use crate::takes::{Take, listed};

/// Minimum number of points that move as one body for the attitude of the body to be computed.
const ATTITUDE: usize = 3;
/// Minimum extent, across their longest direction, of points for the attitude of the body to be computed, m.
const EXTENT: f64 = 0.01;

/// Motion of the tracked points or of the tracked body in a recording, over the samples in which it is seen.
#[derive(Default)]
pub(super) struct Track {
    pub labels: Vec<String>,
    pub samples: Vec<usize>,
    pub times: Vec<f64>,
    /// Centroid of the tracked points, or position of the tracked body, in each of these samples, m.
    pub centres: Vec<Vector3<f64>>,
    /// Rotations from the body-fixed axes of the tracked points to the axes of the room, one per sample.
    rotations: Vec<Matrix3<f64>>,
    pub step: f64,
}

impl Track {
    /// Selects the points or the body named in `labels`; without any, the first tracked body or else the largest set of
    /// points that move as one. `None` and a note if they are seen in fewer than two samples.
    pub fn new(take: &Take, labels: &[&str], notes: &mut Vec<String>) -> Option<Self> {
        let is_named = |label: &str| labels.is_empty() || labels.contains(&label);
        let named: Vec<usize> = (0..take.points.len())
            .filter(|&i| is_named(&take.points[i].label))
            .collect();
        let body = take.bodies.iter().find(|body| is_named(&body.label));
        let mut track = Self::default();
        if let Some(body) = body.filter(|_| labels.is_empty() || named.is_empty()) {
            track.labels.push(body.label.clone());
            for (sample, pose) in body.poses.iter().enumerate() {
                if let Some(pose) = pose {
                    let rotation = attitude(pose.quaternion).to_rotation_matrix();
                    track.push(take, sample, pose.position.into());
                    track.rotations.push(rotation.into_inner());
                }
            }
        } else if labels.is_empty() {
            track.follow_points(take, &rigid_points(take));
        } else {
            track.follow_points(take, &named);
        }
        let mut steps: Vec<f64> = track.times.windows(2).map(|t| t[1] - t[0]).collect();
        steps.sort_by(f64::total_cmp);
        let Some(&step) = steps.get(steps.len() / 2) else {
            notes.push(format!(
                "no points that move as one body are seen together, of {}",
                listed(take.labels())
            ));
            return None;
        };
        track.step = step;
        Some(track)
    }

    fn push(&mut self, take: &Take, sample: usize, centre: Vector3<f64>) {
        self.samples.push(sample);
        self.times.push(take.times[sample]);
        self.centres.push(centre);
    }

    fn follow_points(&mut self, take: &Take, points: &[usize]) {
        let labels = points.iter().map(|&i| take.points[i].label.clone());
        self.labels = labels.collect();
        let seen = |sample: usize| -> Vec<Option<Vector3<f64>>> {
            let each = points.iter().map(|&i| take.points[i].positions[sample]);
            each.map(|position| position.map(Vector3::from)).collect()
        };
        let samples = 0..take.times.len();
        let whole = |sample: usize| seen(sample).into_iter().collect::<Option<Vec<_>>>();
        let mut wholes = samples.clone().filter_map(whole);
        let first = wholes.find(|whole| whole.len() >= ATTITUDE).map(centred);
        let first = first.filter(|points| moments(points)[1].max(0.0).sqrt() > EXTENT);
        let template = first.map(|first| refined(&first, samples.clone().map(seen)));
        for sample in samples {
            if let Some(template) = &template {
                if let Some((centre, rotation)) = fitted(template, &seen(sample)) {
                    self.push(take, sample, centre);
                    self.rotations.push(rotation);
                }
            } else if let Some(whole) = whole(sample).filter(|whole| !whole.is_empty()) {
                let centre = whole.iter().sum::<Vector3<f64>>() / whole.len() as f64;
                self.push(take, sample, centre);
            }
        }
    }

    /// Whether the track includes the attitude of the body, not only its position.
    pub fn has_attitude(&self) -> bool {
        !self.rotations.is_empty()
    }

    /// Rotation from the body-fixed axes to those of the room; a zero matrix if the attitude is not computed.
    pub fn rotation(&self, i: usize) -> Matrix3<f64> {
        self.rotations.get(i).copied().unwrap_or_default()
    }
}

/// Positions of points relative to the mean of these points, in the unit of `points`.
pub(crate) fn centred(points: Vec<Vector3<f64>>) -> Vec<Vector3<f64>> {
    let mean = points.iter().sum::<Vector3<f64>>() / points.len() as f64;
    points.into_iter().map(|point| point - mean).collect()
}

/// Squares of the extents of a centred set of points along its principal axes, summed, in increasing order.
pub(crate) fn moments(points: &[Vector3<f64>]) -> [f64; 3] {
    let moments: Matrix3<f64> = points.iter().map(|p| p * p.transpose()).sum();
    let mut values: [f64; 3] = moments.symmetric_eigenvalues().into();
    values.sort_by(f64::total_cmp);
    values
}

/// Refined positions of a rigid set of points relative to the mean of the points, m.
fn refined(
    first: &[Vector3<f64>],
    samples: impl Iterator<Item = Vec<Option<Vector3<f64>>>>,
) -> Vec<Vector3<f64>> {
    let mut sums = vec![(Vector3::zeros(), 0.0); first.len()];
    for row in samples {
        flight::cancellation::stop_if_cancelled();
        let Some((centre, rotation)) = fitted(first, &row) else {
            continue;
        };
        for ((sum, count), point) in sums.iter_mut().zip(&row) {
            if let Some(point) = point {
                *sum += rotation.transpose() * (point - centre);
                *count += 1.0;
            }
        }
    }
    let means = sums
        .into_iter()
        .map(|(sum, count)| sum / f64::max(count, 1.0));
    centred(means.collect())
}

/// Least-squares rigid motion from `template` to `seen`: position and rotation; `None` for under 3 points.
pub(crate) fn fitted(
    template: &[Vector3<f64>],
    seen: &[Option<Vector3<f64>>],
) -> Option<(Vector3<f64>, Matrix3<f64>)> {
    let pairs = template.iter().zip(seen);
    let pairs = pairs.filter_map(|(own, seen)| Some((*own, (*seen)?)));
    if pairs.clone().count() < ATTITUDE {
        return None;
    }
    let (position, rotation) = rigid_motion(pairs)?;
    Some((position, rotation.to_rotation_matrix().into_inner()))
}
