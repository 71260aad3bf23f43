//! The points by which flights show the pose of a body: markers, and what stands in for missing ones.

use std::borrow::Cow;

use model_spec::model::{FrameKind, Model};

use super::pose::fix_attitude;
use super::sensor::pose_sensors;
use super::{Dataset, Flight, points_on_body, points_seen};

/// Points of a body that show its pose.
#[derive(Clone, Debug, PartialEq)]
pub struct PosePoints {
    /// Positions in the frame in which markers are fixed, m: the markers; if they do not determine the attitude, also
    /// body-fixed points whose positions are computed from the pose that a sensor measures, or, for a body that turns about
    /// one fixed axis, a point on the line through their centre along that axis.
    pub markers: Vec<[f64; 3]>,
    /// Number of the fixed axis, from 0, along which a point is added to the markers.
    added_along: Option<usize>,
    /// Channels of the positions of pose sensors, among those of all sensors.
    pose_channels: Vec<usize>,
    /// Whether the points are the markers of the dataset, and no others.
    pub are_markers: bool,
    /// Whether the body of the model has an attitude; `false` for a point mass.
    pub has_attitude: bool,
}

impl PosePoints {
    /// The points that show the body of a model in a dataset.
    pub fn new(model: &Model, dataset: &Dataset) -> Self {
        let mut markers: Vec<[f64; 3]> = dataset.markers.iter().map(|m| m.position).collect();
        // Markers of a point mass are fixed in the inertial frame, which is frame 0.
        let marker = model.marker.as_ref();
        let has_attitude = marker.is_some_and(|marker| marker.frame != 0);
        let poses = || pose_sensors(&dataset.sensors);
        if has_attitude && !fix_attitude(&markers) {
            markers.extend(poses().flat_map(|(sensor, _)| points_on_body(sensor.position)));
        }
        let added_along = fixed_axis(model)
            .filter(|_| dataset.sensors.is_empty() && !fix_attitude(&markers))
            .filter(|&axis| add_point(axis, &mut markers));
        Self {
            added_along,
            pose_channels: poses().map(|(_, channel)| channel).collect(),
            are_markers: markers.len() == dataset.markers.len(),
            has_attitude,
            markers,
        }
    }

    /// Positions of the points in each sample of a flight, m: those of the markers, if these are the points.
    pub fn of<'f>(&self, flight: &'f Flight) -> Cow<'f, [Vec<Option<[f64; 3]>>]> {
        if self.are_markers {
            return Cow::Borrowed(&flight.positions);
        }
        let samples = 0..flight.times.len();
        Cow::Owned(
            samples
                .map(|sample| self.stand_ins(flight, sample))
                .collect(),
        )
    }

    /// Positions of the points in one sample, m: the markers, and points whose positions follow from the reading of each
    /// pose sensor.
    fn stand_ins(&self, flight: &Flight, sample: usize) -> Vec<Option<[f64; 3]>> {
        let readings = flight.readings.get(sample);
        let poses = self.pose_channels.iter();
        let seen = poses.filter_map(|&channel| Some(points_seen(readings?.get(channel..)?)));
        let markers = flight.positions[sample].iter().copied();
        let mut seen: Vec<_> = markers.chain(seen.flatten()).collect();
        if let Some(axis) = self.added_along {
            seen.push(point_along(axis, &seen));
        }
        seen
    }
}

/// Number, from 0, of the axis about which the frame of the markers turns, if it turns about one of the inertial frame only.
fn fixed_axis(model: &Model) -> Option<usize> {
    let frame = model.marker.as_ref()?.frame;
    match model.frames[frame].kind {
        FrameKind::Turned {
            parent: 0, axis, ..
        } => Some(usize::from(axis) - 1),
        _ => None,
    }
}

/// The point 1 m from the centre of `markers` along an axis; `None` if one of them is missing.
fn point_along(axis: usize, markers: &[Option<[f64; 3]>]) -> Option<[f64; 3]> {
    let mut centre = [0.0; 3];
    for marker in markers {
        let marker = (*marker)?;
        for (sum, own) in centre.iter_mut().zip(marker) {
            *sum += own / markers.len() as f64;
        }
    }
    centre[axis] += 1.0;
    Some(centre)
}

/// Adds [`point_along`] to the positions of markers; returns whether there are any.
fn add_point(axis: usize, markers: &mut Vec<[f64; 3]>) -> bool {
    let seen: Vec<_> = markers.iter().copied().map(Some).collect();
    let added = point_along(axis, &seen).filter(|_| !seen.is_empty());
    markers.extend(added);
    added.is_some()
}
