//! Measured path of a body's origin: by its poses, or by the markers of a point mass.

use nalgebra::Vector3;

use crate::problem::FitProblem;
use dataset::pose::{Pose, point_position};

/// What is measured of a body in one sample.
pub struct Seen {
    pub sample: usize,
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
    problem: &FitProblem,
    times: &[f64],
    points: impl Fn(usize) -> &'p [Option<[f64; 3]>],
    pose: impl Fn(usize) -> Option<Pose>,
) -> impl Iterator<Item = Seen> {
    times.iter().enumerate().filter_map(move |(sample, &time)| {
        let (position, pose) = match problem.has_attitude {
            true => {
                let pose = pose(sample)?;
                (pose.position, Some(pose))
            }
            false => (point_position(&problem.markers, points(sample))?, None),
        };
        Some(Seen {
            sample,
            time,
            position,
            pose,
        })
    })
}
