//! A recording: positions of points and poses of rigid bodies over time.

use crate::takes::{Axis, Format, LengthUnit};

/// A recording as read from its file: coordinates in m along the file's own axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Take {
    /// Format of the file from which the recording was read.
    pub format: Format,
    /// Times of the samples, s, increasing.
    pub times: Vec<f64>,
    /// Tracked points, each with its trajectory.
    pub points: Vec<Point>,
    /// Tracked rigid bodies, each with its poses.
    pub bodies: Vec<Body>,
    /// Unit of the coordinates in the file, from the file or an option; those in this structure are in m.
    pub length: LengthUnit,
    /// Axis of the file that points up; `None` if the file does not specify it.
    pub up: Option<Axis>,
    /// Whether the axes of the file are left-handed; `None` if this is specified neither in the file nor by its format.
    pub left_handed: Option<bool>,
    /// Notes on decisions made while reading, such as values that were overridden or columns left out.
    pub notes: Vec<String>,
}

/// A tracked point and its trajectory.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Label of the point in the file, made unique among all labels of the recording.
    pub label: String,
    /// Position at each sample, m; `None` where the point was not seen.
    pub positions: Vec<Option<[f64; 3]>>,
}

/// A tracked rigid body and its poses over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Label of the body in the file, made unique among all labels of the recording.
    pub label: String,
    /// Pose at each sample; `None` where the body was not seen.
    pub poses: Vec<Option<Pose>>,
}

/// Position and attitude of a rigid body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Position of the origin of the body-fixed axes along the axes of the recording, m.
    pub position: [f64; 3],
    /// Unit quaternion w, x, y, z of the rotation from the body's axes to those of the room.
    pub quaternion: [f64; 4],
}

impl Take {
    /// The recording with all positions multiplied by `factor`.
    pub(crate) fn scaled(mut self, factor: f64) -> Self {
        let points = self
            .points
            .iter_mut()
            .flat_map(|point| &mut point.positions);
        let poses = self.bodies.iter_mut().flat_map(|body| &mut body.poses);
        let positions = points.flatten();
        let positions = positions.chain(poses.flatten().map(|pose| &mut pose.position));
        for coordinate in positions.flatten() {
            *coordinate *= factor;
        }
        self
    }

    /// Labels of all points, followed by those of all bodies.
    pub fn labels(&self) -> impl Iterator<Item = &str> {
        let points = self.points.iter().map(|point| point.label.as_str());
        points.chain(self.bodies.iter().map(|body| body.label.as_str()))
    }
}
