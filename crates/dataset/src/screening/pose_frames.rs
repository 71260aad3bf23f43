//! Poses whose positions and attitudes are in different frames of the room: converted ones, and their correction.

use nalgebra::{UnitQuaternion, Vector3};

use super::Body;
use super::mirror;
use super::readings::of_flights;
use crate::fault::{DataFault, FaultKind};
use crate::sensor::pose_sensors;
use crate::{AXES, Dataset, Flight, Reading, attitude};

/// The poses of the first sensor of a dataset that has any.
pub struct Poses<'d> {
    dataset: &'d Dataset,
    sensor: &'d str,
    /// Channel of the positions; that of the attitudes follows.
    channel: usize,
}

impl<'d> Poses<'d> {
    /// `None` without poses.
    pub fn of(dataset: &'d Dataset) -> Option<Self> {
        let (sensor, channel) = pose_sensors(&dataset.sensors).next()?;
        Some(Self {
            dataset,
            sensor: &sensor.name,
            channel,
        })
    }

    /// The flight with one coordinate of its positions negated.
    pub fn negated(&self, flight: &Flight, axis: usize) -> Flight {
        changed(flight, self.channel, |mut position| {
            position[axis] = -position[axis];
            position
        })
    }

    /// The flight with attitudes turned about the third axis of the room, degrees.
    pub fn turned(&self, flight: &Flight, degrees: f64) -> Flight {
        let turn = UnitQuaternion::from_scaled_axis(Vector3::z() * degrees.to_radians());
        changed(flight, self.channel + 1, |own| {
            let [x, y, z, w] = (turn * attitude(own)).coords.into();
            [w, x, y, z]
        })
    }

    /// Whether the model describes the flights far better as changed.
    pub fn are_better(&self, body: &dyn Body, change: impl Fn(&Flight) -> Flight) -> bool {
        mirror::is_described_better(body, self.dataset, change)
    }

    /// Faults of positions with one coordinate of the wrong sign.
    pub fn faults_of_sign(&self, axis: usize) -> Vec<DataFault> {
        let (name, axis) = (self.sensor, AXES[axis]);
        let detail = format!(
            "the {axis} coordinate of {name} seems to have the opposite sign of that of its attitudes: only so do the flights fit"
        );
        self.faults(detail, format!("change the sign of {name}_{axis}"))
    }

    /// Faults of attitudes that are turned about the third axis by an angle, degrees.
    pub fn faults_of_turn(&self, degrees: f64) -> Vec<DataFault> {
        let detail = format!(
            "the attitudes of {} seem to be in a frame that is turned by about {degrees:.0}° about z against that of the positions: only so do the flights fit",
            self.sensor
        );
        self.faults(
            detail,
            format!("turn the attitudes by {:.0}° about z", -degrees),
        )
    }

    fn faults(&self, detail: String, correction: String) -> Vec<DataFault> {
        let found = (FaultKind::AttitudeConvention, (detail, correction));
        of_flights(self.dataset, self.channel, found)
    }
}

fn changed(flight: &Flight, channel: usize, change: impl Fn(Reading) -> Reading) -> Flight {
    let mut flight = flight.clone();
    let readings = flight.readings.iter_mut();
    for reading in readings.filter_map(|row| row.get_mut(channel)?.as_mut()) {
        *reading = change(*reading);
    }
    flight
}
