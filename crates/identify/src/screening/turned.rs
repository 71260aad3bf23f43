//! Left-handed axes of all flights of a body whose markers lie in a plane, which [`mirror`] cannot judge: the body
//! flies upside down throughout, and the model describes the mirror images far better. This is the only check that
//! uses the model's loads, with the coefficients of the model's file.

use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use super::free_fall::{transformed_track, upright};
use super::gravity::acceleration;
use super::mirror;
use super::track::Track;
use crate::data_fault::{DataFault, FaultKind};
use crate::ground_contact::PathPoint;
use crate::initial_state::{RigidMotion, state_for_motion};
use crate::observations::Observations;
use crate::problem::FitProblem;
use dataset::pose::pose;
use dataset::statistics::{median, median_vector};
use dataset::{Dataset, Flight};

/// Minimum magnitude of the vertical component of the unit normal of the markers' plane at which it is clear which side
/// of the body is up.
const UPRIGHT: f64 = 0.3;
/// Minimum number of flights at which mirrored axes are reported; the body must appear upside down in all flights.
const MIN_FLIGHTS: usize = 3;
/// Maximum number of flights in which measured accelerations are compared with those of the model, and maximum number
/// of time windows per flight.
const COMPARED: (usize, usize) = (6, 3);
/// Limit for reporting the flights as mirrored: maximum ratio of the median deviation between measured and modelled
/// accelerations of the mirror images of the flights to that of the recorded flights.
const MISFIT: f64 = 0.6;

/// One data fault for each flight whose path is available, if the recorded flights seem to be mirror images of the true
/// flights; otherwise empty.
pub fn check(problem: &FitProblem, dataset: &Dataset, tracks: &[Option<Track>]) -> Vec<DataFault> {
    if !problem.has_attitude || mirror::is_decided_by(&problem.markers) {
        return Vec::new();
    }
    let seen: Vec<f64> = tracks
        .iter()
        .flatten()
        .filter_map(|track| upright(problem, track))
        .collect();
    let Some(usual) = usual_side(problem) else {
        return Vec::new();
    };
    let is_turned = |side: &f64| side * usual < 0.0 && side.abs() > UPRIGHT;
    if seen.len() < MIN_FLIGHTS || !seen.iter().all(is_turned) {
        return Vec::new();
    }
    let reflection = Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, 1.0));
    let (mut plain, mut mirrored) = (Vec::new(), Vec::new());
    let flights = dataset
        .flights
        .iter()
        .zip(tracks)
        .filter_map(|(f, track)| Some((f, track.as_ref()?)));
    for (flight, track) in flights.take(COMPARED.0) {
        let Ok(observations) = Observations::new(problem, flight) else {
            continue;
        };
        plain.extend(misfits(problem, &observations, track));
        mirrored.extend(misfits(
            problem,
            &observations,
            &transformed_track(problem, flight, &reflection),
        ));
    }
    if plain.len() < MIN_FLIGHTS
        || median(&mut mirrored) > MISFIT * median(&mut plain)
        || mirrored.is_empty()
    {
        return Vec::new();
    }
    let fault = |flight: &Flight| {
        DataFault::new(
            flight,
            FaultKind::Mirrored,
            "in all flights the body is upside down, and the model describes their mirror images far better: the axes seem left-handed, or labels are exchanged",
            mirror::MEND,
        )
    };
    let flights = dataset
        .flights
        .iter()
        .zip(tracks)
        .filter(|(_, track)| track.is_some());
    flights.map(|(flight, _)| fault(flight)).collect()
}

/// Vertical component of the unit normal of the markers' plane in the model's default state, which defines the upper
/// side of the body in normal flight; `None` if the component is too small to distinguish the sides.
fn usual_side(problem: &FitProblem) -> Option<f64> {
    let conditions = problem.body.bind(problem.parameters.clone());
    let state = problem.body.layout().default_states();
    let mut observer = conditions.observer();
    let markers = problem.markers.iter();
    let shown: Vec<_> = markers
        .map(|marker| Some(observer.position(0.0, &state, marker)))
        .collect();
    let side = (pose(&problem.markers, &shown)?.attitude * mirror::normal(&problem.markers)).z;
    (side.abs() > UPRIGHT).then_some(side)
}

/// Magnitudes of the differences between measured and modelled accelerations, m/s², in evenly spaced time windows of a
/// flight. The maximum number of windows is the second number of [`COMPARED`].
fn misfits(problem: &FitProblem, observations: &Observations, track: &Track) -> Vec<f64> {
    let windows = track.windows();
    let step = windows.len().div_ceil(COMPARED.1).max(1);
    let each = windows
        .into_iter()
        .step_by(step)
        .filter_map(|(range, motion)| {
            let points = &track.points[range];
            let middle = points[points.len() / 2];
            let motion_there = RigidMotion {
                position: middle.position,
                velocity: motion.velocity,
                attitude: middle.attitude,
                rates: Some(rates(points)?),
            };
            let state = state_for_motion(problem, observations, &motion_there).ok()?;
            let predicted = acceleration(problem, state.as_slice())?;
            Some((motion.acceleration - predicted).norm())
        });
    each.collect()
}

/// Component-wise median of the body's angular velocities between successive points of a path, rad/s, inertial frame;
/// `None` if there are no two successive points with attitudes.
fn rates(points: &[PathPoint]) -> Option<Vector3<f64>> {
    let pairs = points.windows(2).filter_map(|pair| {
        let turn: UnitQuaternion<f64> = pair[1].attitude? * pair[0].attitude?.inverse();
        Some(turn.scaled_axis() / (pair[1].time - pair[0].time))
    });
    let pairs: Vec<Vector3<f64>> = pairs.collect();
    median_vector(&pairs)
}
