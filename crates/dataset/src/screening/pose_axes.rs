//! Conventions of the attitudes of poses that contradict the mechanics of a spinning body: moments turn its angular
//! momentum slowly, and a flat body is thrown spinning about its third axis.

use flight::throw::ThrownModel;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

use super::Body;
use super::momentum::{is_clearly_better, momenta, unsteadiness};
use super::readings::{of_flights, series};
use crate::fault::{DataFault, FaultKind};
use crate::levels::AS_GOOD;
use crate::sensor::pose_sensors;
use crate::{Dataset, Reading, attitude};

/// Least ratio of a flat body's third moment of inertia to the others: it is thrown spinning about the third axis.
pub const FLAT: f64 = 1.2;

/// Inertia tensor of the body in body axes, kg m²; `None` for a point mass, or if the model says nothing about it.
pub fn inertia(body: &dyn Body) -> Option<Matrix3<f64>> {
    let thrown = ThrownModel::new(body.model()).ok()?;
    let layout = body.compiled().layout();
    let state = layout.default_states();
    let turning = thrown.motion(&state, body.parameters()).turning?;
    let axes = thrown.frame_axes(&turning);
    Some(axes.transpose() * thrown.inertia(&state, body.parameters())? * axes)
}

/// Faults of the flights with poses of another convention or of other body axes.
pub fn check(body: &dyn Body, dataset: &Dataset) -> Vec<DataFault> {
    let Some(inertia) = inertia(body) else {
        return Vec::new();
    };
    let poses = pose_sensors(&dataset.sensors);
    let each = poses.flat_map(|(_, channel)| {
        let attitudes = Attitudes {
            dataset,
            channel: channel + 1,
            inertia: &inertia,
        };
        let found = attitudes.body_axes(body);
        let found = found.or_else(|| attitudes.convention(body));
        let found = found.map(|message| (FaultKind::AttitudeConvention, message));
        found.map_or_else(Vec::new, |found| of_flights(dataset, channel, found))
    });
    each.collect()
}

type Read = fn(Reading) -> Reading;

/// Other conventions of quaternions: how they are read, what they are, and the correction.
const CONVENTIONS: [(Read, &str, &str); 3] = [
    (
        |[w, x, y, z]| [w, -x, -y, -z],
        "turn inertial to body components",
        "state `attitude = \"inertial_to_body\"` in [recording], or write the conjugates",
    ),
    (
        |[x, y, z, w]| [w, x, y, z],
        "have the scalar part last",
        "write the scalar part into the column _qw",
    ),
    (
        |[x, y, z, w]| [w, -x, -y, -z],
        "have the scalar part last and turn inertial to body components",
        "write the scalar part into the column _qw, and the conjugates",
    ),
];

/// Attitudes of a dataset that are read in some convention, and how unsteady the angular momentum is by them.
struct Attitudes<'a> {
    dataset: &'a Dataset,
    channel: usize,
    inertia: &'a Matrix3<f64>,
}

impl Attitudes<'_> {
    fn unsteadiness(&self, read: Read) -> Option<f64> {
        self.unsteadiness_with(read, self.inertia)
    }

    fn unsteadiness_with(&self, read: Read, inertia: &Matrix3<f64>) -> Option<f64> {
        let poses = |flight| {
            series(flight, self.channel).map(move |(time, own)| (time, attitude(read(own))))
        };
        let flights = self.dataset.flights.iter();
        unsteadiness(flights.map(|flight| momenta(poses(flight), inertia)))
    }

    /// Successive attitudes of each flight.
    fn flights(
        &self,
        read: Read,
    ) -> impl Iterator<Item = impl Iterator<Item = UnitQuaternion<f64>>> {
        let attitudes =
            move |flight| series(flight, self.channel).map(move |(_, own)| attitude(read(own)));
        self.dataset.flights.iter().map(attitudes)
    }

    /// Axis about which the body spins.
    fn spin_axis(&self, read: Read) -> Option<usize> {
        crate::spin_axis(self.flights(read))
    }

    /// How unsteady the angular momentum is if the body spins about its own axis, from which those of the poses are tilted.
    fn unsteadiness_if_tilted(&self, body: &dyn Body) -> Option<f64> {
        let (_, axes) = body.model().flight_axes()?;
        let own = Vector3::ith(usize::from(axes.spin.number) - 1, 1.0);
        let spin = crate::turned(self.flights(|own| own));
        let tilt = Rotation3::rotation_between(&own, &(spin.dot(&own).signum() * spin))?;
        let inertia = tilt * self.inertia * tilt.inverse();
        self.unsteadiness_with(|own| own, &inertia)
    }

    /// Message and correction for another convention of quaternions; `None` if the angular momentum does not tell.
    fn convention(&self, body: &dyn Body) -> Option<(String, String)> {
        let stated = self.unsteadiness(|own| own)?;
        let tried = CONVENTIONS.iter();
        let tried = tried.filter_map(|own| Some((self.unsteadiness(own.0)?, own)));
        let (best, (_, what, correction)) = tried.min_by(|a, b| a.0.total_cmp(&b.0))?;
        // Tilted axes are estimated.
        let is_tilted = |left| left < AS_GOOD * best;
        if self.unsteadiness_if_tilted(body).is_some_and(is_tilted) {
            return None;
        }
        is_clearly_better(best, stated).then(|| {
            (
                format!(
                    "the quaternions seem to {what}: as they are, the angular momentum turns with the body"
                ),
                (*correction).to_owned(),
            )
        })
    }

    /// Message and correction for a flat body that spins about another than its axis of symmetry.
    fn body_axes(&self, body: &dyn Body) -> Option<(String, String)> {
        let diagonal = self.inertia.diagonal();
        let (_, axes) = body.model().flight_axes()?;
        let own = usize::from(axes.spin.number) - 1;
        let others = diagonal[(own + 1) % 3].max(diagonal[(own + 2) % 3]);
        let is_flat = diagonal[own] > FLAT * others;
        let stated: Read = |own| own;
        let axis = self
            .spin_axis(stated)
            .filter(|axis| is_flat && *axis != own)?;
        let name = crate::AXES[axis];
        let turned = format!("state `body_up = \"+{name}\"` in [recording], or turn the body axes");
        // With the parts of the quaternions exchanged, a spin about one axis looks like one about another, and what is
        // steadier may be by noise: both are told.
        let steadiness = self.unsteadiness(stated)?;
        let is_better = |(read, ..): &&(Read, &str, &str)| {
            self.spin_axis(*read) == Some(own)
                && self
                    .unsteadiness(*read)
                    .is_some_and(|other| other < steadiness)
        };
        let correction = match CONVENTIONS.iter().find(is_better) {
            Some((_, what, correction)) => {
                format!("if the quaternions {what}, {correction}; else {turned}")
            }
            None => turned,
        };
        Some((
            format!(
                "the body spins about its {name} axis; the model is flat, with its {} axis as axis of symmetry",
                ["first", "second", "third"][own]
            ),
            correction,
        ))
    }
}
