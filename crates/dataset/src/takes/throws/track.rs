//! Motion of a rigid cluster of points: centroid and attitude at each sample in which it is seen.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

use super::cluster::rigid_points;
use crate::takes::take::Take;
use crate::takes::words::listed;

/// Minimum number of points that move as one body for the attitude of the body to be computed.
const ATTITUDE: usize = 3;
/// Minimum extent, across their longest direction, of points that move as one body for the attitude of the body to be
/// computed, m.
const EXTENT: f64 = 0.01;

/// Motion of the tracked points or of the tracked body in a recording, over the samples in which it is seen.
pub(super) struct Track {
    pub labels: Vec<String>,
    /// Indices of the samples of the recording in which the body is seen.
    pub samples: Vec<usize>,
    /// Times of the samples in which the body is seen, s.
    pub times: Vec<f64>,
    /// Centroid of the tracked points, or position of the tracked body, in each sample in which the body is seen, along
    /// the axes of the room, m.
    pub centres: Vec<[f64; 3]>,
    /// Rotations from the body-fixed axes of the tracked points to the axes of the room, one per sample; empty if the
    /// attitude is not computed.
    rotations: Vec<Matrix3<f64>>,
    /// Median time between consecutive samples in which the body is seen, s.
    pub step: f64,
}

impl Track {
    /// Selects the points or the body named in `labels`; if `labels` is empty, the first tracked body or, without one,
    /// the largest set of points that move as one. Returns `None` and adds a note if the points or the body are seen in
    /// fewer than two samples.
    pub fn new(take: &Take, labels: &[&str], notes: &mut Vec<String>) -> Option<Self> {
        let is_named = |label: &str| labels.is_empty() || labels.contains(&label);
        let named: Vec<usize> = (0..take.points.len())
            .filter(|&i| is_named(&take.points[i].label))
            .collect();
        let body = take.bodies.iter().find(|body| is_named(&body.label));
        let mut track = if let Some(body) = body.filter(|_| labels.is_empty() || named.is_empty()) {
            let mut track = Self::empty(vec![body.label.clone()]);
            for (sample, pose) in body.poses.iter().enumerate() {
                let Some(pose) = pose else { continue };
                let [w, x, y, z] = pose.quaternion;
                let attitude = UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z));
                track.push(take, sample, pose.position);
                track
                    .rotations
                    .push(attitude.to_rotation_matrix().into_inner());
            }
            track
        } else {
            let points = match labels.is_empty() {
                true => rigid_points(take),
                false => named,
            };
            Self::of_points(take, &points)
        };
        let mut steps: Vec<f64> = track.times.windows(2).map(|t| t[1] - t[0]).collect();
        steps.sort_by(f64::total_cmp);
        match steps.get(steps.len() / 2) {
            Some(&step) => {
                track.step = step;
                Some(track)
            }
            None => {
                notes.push(format!(
                    "no points that move as one body are seen together, of {}",
                    listed(take.labels())
                ));
                None
            }
        }
    }

    fn empty(labels: Vec<String>) -> Self {
        Self {
            labels,
            samples: Vec::new(),
            times: Vec::new(),
            centres: Vec::new(),
            rotations: Vec::new(),
            step: 0.0,
        }
    }

    fn push(&mut self, take: &Take, sample: usize, centre: [f64; 3]) {
        self.samples.push(sample);
        self.times.push(take.times[sample]);
        self.centres.push(centre);
    }

    fn of_points(take: &Take, points: &[usize]) -> Self {
        let labels = points.iter().map(|&i| take.points[i].label.clone());
        let mut track = Self::empty(labels.collect());
        let seen = |sample: usize| -> Vec<Option<Vector3<f64>>> {
            let each = points.iter().map(|&i| take.points[i].positions[sample]);
            each.map(|position| position.map(Vector3::from)).collect()
        };
        let template = (0..take.times.len()).find_map(|sample| {
            let whole: Option<Vec<Vector3<f64>>> = seen(sample).into_iter().collect();
            whole.filter(|whole| whole.len() >= ATTITUDE).map(centred)
        });
        let template = template.filter(|points| extent(points) > EXTENT);
        let template = template.map(|first| refined(&first, (0..take.times.len()).map(seen)));
        for sample in 0..take.times.len() {
            let row = seen(sample);
            match &template {
                Some(template) => {
                    if let Some((centre, rotation)) = fitted(template, &row) {
                        track.push(take, sample, centre.into());
                        track.rotations.push(rotation);
                    }
                }
                None => {
                    let whole: Option<Vec<Vector3<f64>>> = row.into_iter().collect();
                    if let Some(whole) = whole.filter(|whole| !whole.is_empty()) {
                        let centre = whole.iter().sum::<Vector3<f64>>() / whole.len() as f64;
                        track.push(take, sample, centre.into());
                    }
                }
            }
        }
        track
    }

    /// Whether the track includes the attitude of the body, not only its position.
    pub fn has_attitude(&self) -> bool {
        !self.rotations.is_empty()
    }

    /// Rotation from the body-fixed axes to the axes of the room at an index of the track; a zero matrix if the
    /// attitude is not computed.
    pub fn rotation(&self, i: usize) -> Matrix3<f64> {
        self.rotations
            .get(i)
            .copied()
            .unwrap_or_else(Matrix3::zeros)
    }

    /// Trajectory of a point of the body along the axes of the room, m, for each sample in which the body is seen.
    /// `offset` is the position of this point relative to the centroid, in the body-fixed axes of the tracked points,
    /// m.
    pub fn path(&self, offset: [f64; 3]) -> Vec<[f64; 3]> {
        let offset = Vector3::from(offset);
        let each = self.centres.iter().enumerate();
        each.map(|(i, centre)| (Vector3::from(*centre) + self.rotation(i) * offset).into())
            .collect()
    }
}

/// Positions of points relative to the mean of these points, in the unit of `points`.
pub(crate) fn centred(points: Vec<Vector3<f64>>) -> Vec<Vector3<f64>> {
    let mean = points.iter().sum::<Vector3<f64>>() / points.len() as f64;
    points.into_iter().map(|point| point - mean).collect()
}

/// Extent of a set of points across its longest direction, m: second singular value of the matrix of points; 0 for
/// points on a line.
fn extent(points: &[Vector3<f64>]) -> f64 {
    let moments: Matrix3<f64> = points.iter().map(|p| p * p.transpose()).sum();
    let mut values: Vec<f64> = moments.symmetric_eigenvalues().iter().copied().collect();
    values.sort_by(f64::total_cmp);
    values[1].max(0.0).sqrt()
}

/// Refined positions of a rigid set of points relative to the mean of the points, m: each point's mean over the
/// samples, after the rotation of each sample to the axes of the initial estimate `first`.
fn refined(
    first: &[Vector3<f64>],
    samples: impl Iterator<Item = Vec<Option<Vector3<f64>>>>,
) -> Vec<Vector3<f64>> {
    let mut sums = vec![(Vector3::zeros(), 0.0); first.len()];
    for row in samples {
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
    centred(
        sums.into_iter()
            .map(|(sum, count)| sum / f64::max(count, 1.0))
            .collect(),
    )
}

/// Fits a rigid motion that maps the points `template` to the measured points `seen`, by least squares over the points
/// that are not `None` (Kabsch 1976). Returns (position of the origin of `template`, rotation), such that position +
/// rotation · template point ≈ measured point; `None` if fewer than 3 points are seen.
pub(crate) fn fitted(
    template: &[Vector3<f64>],
    seen: &[Option<Vector3<f64>>],
) -> Option<(Vector3<f64>, Matrix3<f64>)> {
    let pairs: Vec<(Vector3<f64>, Vector3<f64>)> = template
        .iter()
        .zip(seen)
        .filter_map(|(own, seen)| Some((*own, (*seen)?)))
        .collect();
    let count = pairs.len() as f64;
    if pairs.len() < ATTITUDE {
        return None;
    }
    let own: Vector3<f64> = pairs.iter().map(|pair| pair.0).sum::<Vector3<f64>>() / count;
    let mean: Vector3<f64> = pairs.iter().map(|pair| pair.1).sum::<Vector3<f64>>() / count;
    let covariance: Matrix3<f64> = pairs
        .iter()
        .map(|(a, b)| (b - mean) * (a - own).transpose())
        .sum();
    let svd = covariance.try_svd(true, true, 1e-14, 200)?;
    let (u, v) = (svd.u?, svd.v_t?);
    let sign = (u * v).determinant().signum();
    // The smallest singular value is the last one.
    let rotation = u * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, sign)) * v;
    Some((mean - rotation * own, rotation))
}
