//! Measured path of a body's origin: by its poses, or by the markers of a point mass.

use nalgebra::Vector3;

use crate::pose::{Pose, point_position};
use crate::pose_points::PosePoints;
use crate::statistics::{median_of, robust_sigma};

/// What is measured of a body in one sample.
pub struct Seen {
    /// Index of the sample.
    pub sample: usize,
    /// Time, s.
    pub time: f64,
    /// Position of the body's origin, m.
    pub position: Vector3<f64>,
    /// Pose of the body; `None` for a point mass.
    pub pose: Option<Pose>,
}

impl Seen {
    /// Variance of a marker coordinate about the rigid body, m²; 0 for a point mass.
    pub fn variance(&self) -> f64 {
        self.pose.as_ref().map_or(0.0, Pose::variance)
    }
}

/// The samples that show the position of the body. `points` returns the measured positions of the points of the pose in a
/// sample, and `pose` the pose that they determine.
pub fn seen_path<'p>(
    body: &PosePoints,
    times: &[f64],
    points: impl Fn(usize) -> &'p [Option<[f64; 3]>],
    pose: impl Fn(usize) -> Option<Pose>,
) -> impl Iterator<Item = Seen> {
    times.iter().enumerate().filter_map(move |(sample, &time)| {
        let (position, pose) = match body.has_attitude {
            true => {
                let pose = pose(sample)?;
                (pose.position, Some(pose))
            }
            false => (point_position(&body.markers, points(sample))?, None),
        };
        Some(Seen {
            sample,
            time,
            position,
            pose,
        })
    })
}

// Noise of a measured path, estimated from the distances of its points from smooth curves through their neighbours.

/// Maximum time span of four successive points relative to the median; the path may curve in a gap.
const MAX_SPAN_RATIO: f64 = 1.6;

/// Robust standard deviation of one coordinate about a smooth path of points (time in s, position in m), in m, by third
/// divided differences; 0 for fewer than four points.
pub fn path_noise(path: impl Iterator<Item = (f64, Vector3<f64>)>) -> f64 {
    let path: Vec<(f64, Vector3<f64>)> = path.collect();
    let span = |four: &[(f64, Vector3<f64>)]| four[3].0 - four[0].0;
    let longest = MAX_SPAN_RATIO * median_of(path.windows(4).map(span)).unwrap_or(0.0);
    let fours = path.windows(4).filter(|four| span(four) <= longest);
    let mut rough: Vec<f64> = fours
        .flat_map(|four| {
            // Third divided difference over its standard deviation for noise of standard deviation 1.
            let weight = |i: usize| -> f64 {
                let others = (0..4).filter(|j| *j != i);
                1.0 / others.map(|j| four[i].0 - four[j].0).product::<f64>()
            };
            let weights = [weight(0), weight(1), weight(2), weight(3)];
            let size = weights.iter().map(|w| w * w).sum::<f64>().sqrt();
            let sum: Vector3<f64> = four.iter().zip(weights).map(|((_, p), w)| p * w).sum();
            <[f64; 3]>::from((sum / size).abs())
        })
        .collect();
    robust_sigma(&mut rough)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_and_curves_are_no_noise() {
        let at = |i: usize| (i as f64 * 0.01, i);
        let kept = (0..100).filter(|i| i % 5 != 2 && i % 7 != 3).map(at);
        let path = |noise: f64| {
            kept.clone().map(move |(t, i)| {
                let sign = if (i * i) % 3 == 0 { 1.0 } else { -1.0 };
                (
                    t,
                    Vector3::new(5.0 * t, noise * sign, 3.0 * t - 30.0 * t * t),
                )
            })
        };
        assert!(path_noise(path(0.0)) < 1e-9);
        let noise = path_noise(path(0.003).map(|(t, p)| (t, Vector3::repeat(p.y))));
        assert!((0.001..0.006).contains(&noise), "{noise}");
    }
}
