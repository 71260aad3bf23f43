//! Conventions of the attitudes of poses that contradict the mechanics of a spinning body: moments turn its angular
//! momentum slowly, and a flat body is thrown spinning about its third axis.

use flight::throw::ThrownModel;
use nalgebra::Matrix3;

use super::momentum::{is_clearly_better, unsteadiness};
use super::readings::{of_flights, sensors, series};
use crate::error::{DataFault, FaultKind};
use crate::problem::FitProblem;
use dataset::{Dataset, Reading, SensorKind, attitude};

/// Least ratio of a flat body's third moment of inertia to the others: it is thrown spinning about the third axis.
const FLAT: f64 = 1.2;

/// Inertia tensor of the body in body axes, kg m²; `None` for a point mass, or if the model says nothing about it.
fn inertia(problem: &FitProblem) -> Option<Matrix3<f64>> {
    let body = ThrownModel::new(&problem.model).ok()?;
    let layout = problem.body.layout();
    let state = layout.default_states();
    let turning = body.motion(&state, &problem.parameters).turning?;
    let axes = body.frame_axes(&turning);
    Some(axes.transpose() * body.inertia(&state, &problem.parameters)? * axes)
}

/// Faults of the flights with poses of another convention or of other body axes.
pub fn check(problem: &FitProblem, dataset: &Dataset) -> Vec<DataFault> {
    let Some(inertia) = inertia(problem) else {
        return Vec::new();
    };
    let poses = sensors(dataset).filter(|(sensor, _)| sensor.kind == SensorKind::Pose);
    let each = poses.flat_map(|(_, channel)| {
        let attitudes = channel + 1;
        let axes = || body_axes(problem, dataset, attitudes, &inertia);
        let found = convention(dataset, attitudes, &inertia).or_else(axes);
        let found = found.map(|message| (FaultKind::AttitudeConvention, message));
        found.map_or_else(Vec::new, |found| of_flights(dataset, channel, found))
    });
    each.collect()
}

/// Message and correction for another convention of quaternions; `None` if the angular momentum does not tell.
fn convention(
    dataset: &Dataset,
    channel: usize,
    inertia: &Matrix3<f64>,
) -> Option<(String, String)> {
    type Read = fn(Reading) -> Reading;
    let unsteadiness = |read: Read| {
        let flights = dataset.flights.iter();
        let poses =
            |flight| series(flight, channel).map(move |(time, own)| (time, attitude(read(own))));
        unsteadiness(flights.map(poses), inertia)
    };
    let stated = unsteadiness(|own| own)?;
    let others: [(Read, &str, &str); 3] = [
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
    let tried = others.into_iter();
    let tried =
        tried.filter_map(|(read, what, correction)| Some((unsteadiness(read)?, what, correction)));
    let best = tried.min_by(|a, b| a.0.total_cmp(&b.0))?;
    is_clearly_better(best.0, stated).then(|| {
        (
            format!(
                "the quaternions seem to {}: as they are, the angular momentum turns with the body",
                best.1
            ),
            best.2.to_owned(),
        )
    })
}

/// Message and correction for a flat body that spins about another than its axis of symmetry.
fn body_axes(
    problem: &FitProblem,
    dataset: &Dataset,
    channel: usize,
    inertia: &Matrix3<f64>,
) -> Option<(String, String)> {
    let diagonal = inertia.diagonal();
    let (_, axes) = problem.model.flight_axes()?;
    let own = usize::from(axes.spin.number) - 1;
    let others = diagonal[(own + 1) % 3].max(diagonal[(own + 2) % 3]);
    let is_flat = diagonal[own] > FLAT * others;
    let flights = dataset.flights.iter();
    let attitudes = flights.map(|flight| series(flight, channel).map(|(_, own)| attitude(own)));
    let axis = dataset::spin_axis(attitudes).filter(|axis| is_flat && *axis != own)?;
    let name = dataset::AXES[axis];
    Some((
        format!(
            "the body spins about its {name} axis; the model is flat, with its {} axis as axis of symmetry",
            ["first", "second", "third"][own]
        ),
        format!("state `body_up = \"+{name}\"` in [recording], or turn the body axes"),
    ))
}
