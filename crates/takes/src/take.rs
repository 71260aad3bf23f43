//! A recording: positions of points and poses of rigid bodies over time.

use crate::axes::Axis;
use crate::format::Format;
use crate::unit::LengthUnit;

/// A recording as its file has it: coordinates in m along the file's own axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Take {
    /// Format of the file.
    pub format: Format,
    /// Times of the samples, s, increasing.
    pub times: Vec<f64>,
    /// Tracked points.
    pub points: Vec<Point>,
    /// Tracked rigid bodies.
    pub bodies: Vec<Body>,
    /// Unit of the coordinates in the file, stated there or by an option.
    pub length: LengthUnit,
    /// Axis that points up, where the file states it.
    pub up: Option<Axis>,
    /// Whether the axes are left-handed, where the file or its format states it.
    pub left_handed: Option<bool>,
    /// What was decided while reading: a statement of the file that was not followed, what was left out.
    pub notes: Vec<String>,
}

/// A tracked point.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Label in the file, unique in the take.
    pub label: String,
    /// Position at each sample, m; `None` where the point was not seen.
    pub positions: Vec<Option<[f64; 3]>>,
}

/// A tracked rigid body.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Label in the file, unique in the take.
    pub label: String,
    /// Pose at each sample; `None` where the body was not seen.
    pub poses: Vec<Option<Pose>>,
}

/// Position and attitude of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Position of the body's origin, m.
    pub position: [f64; 3],
    /// Unit quaternion w, x, y, z of the rotation from the body's axes to those of the room.
    pub quaternion: [f64; 4],
}

impl Take {
    /// Names of the points and then of the bodies.
    pub fn labels(&self) -> impl Iterator<Item = &str> {
        let points = self.points.iter().map(|point| point.label.as_str());
        points.chain(self.bodies.iter().map(|body| body.label.as_str()))
    }
}
