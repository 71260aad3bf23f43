//! Left-handed axes: markers that match the mirror image of the template. Turned over, markers in a plane do so, too.
//! Poses of a body whose third axis points down.

use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use super::Body;
use super::loads::acceleration;
use super::track::{Conversion, Track};
use crate::contact::PathPoint;
use crate::fault::{DataFault, FaultKind};
use crate::pose::{Pose, RigidMotion, pose};
use crate::statistics::{median, median_of, median_vector};
use crate::{Dataset, Flight};

const SAMPLES: usize = 20;
/// Minimum ratio of the smallest to the largest extent of markers that are not in a plane.
const THICKNESS: f64 = 0.05;
/// Minimum ratio of the variance about the template to that about its mirror image, and distance of the markers from the
/// template, m.
const MIRRORED: (f64, f64) = (10.0, 0.003);

/// Instruction for correcting left-handed axes, for the user.
pub const MEND: &str = "change the sign of one horizontal axis (write -y for y)";

/// Whether four markers not in a plane tell the template from its mirror image.
pub fn is_decided_by(markers: &[[f64; 3]]) -> bool {
    if markers.len() < 4 {
        return false;
    }
    let scatter = scatter(markers);
    let sizes = scatter.symmetric_eigenvalues();
    sizes.min().max(0.0).sqrt() > THICKNESS * sizes.max().sqrt()
}

/// Unit normal of the markers' plane, in body components; its sign is arbitrary.
fn normal(markers: &[[f64; 3]]) -> Vector3<f64> {
    let eigen = scatter(markers).symmetric_eigen();
    eigen.eigenvectors.column(eigen.eigenvalues.imin()).into()
}

/// Scatter matrix of the marker positions about their centroid, m².
fn scatter(markers: &[[f64; 3]]) -> Matrix3<f64> {
    let each = || markers.iter().map(|marker| Vector3::from(*marker));
    let centre = each().sum::<Vector3<f64>>() / markers.len() as f64;
    each()
        .map(|marker| (marker - centre) * (marker - centre).transpose())
        .sum()
}

/// Fault of a flight whose markers fit the mirror image of `markers` much better.
pub fn check(markers: &[[f64; 3]], flight: &Flight) -> Option<DataFault> {
    let mirrored: Vec<[f64; 3]> = markers.iter().map(|&[x, y, z]| [-x, y, z]).collect();
    let complete = flight
        .positions
        .iter()
        .filter(|row| row.iter().flatten().count() >= 4);
    let rows: Vec<_> = complete.collect();
    let step = rows.len().div_ceil(SAMPLES).max(1);
    let (mut plain, mut mirror) = (Vec::new(), Vec::new());
    for row in rows.into_iter().step_by(step) {
        let (Some(one), Some(other)) = (pose(markers, row), pose(&mirrored, row)) else {
            continue;
        };
        plain.push(one.variance());
        mirror.push(other.variance());
    }
    let (plain, mirror) = (median(&mut plain), median(&mut mirror));
    (plain > MIRRORED.0 * mirror && plain.sqrt() > MIRRORED.1).then(|| DataFault::new(flight, FaultKind::Mirrored, format!(
            "the markers fit the mirror image of the template ({:.1} mm) and not the template ({:.1} mm): the axes seem left-handed",
            1e3 * mirror.sqrt(),
            1e3 * plain.sqrt()
        ), MEND))
}

// A body that flies upside down in all flights, where the model describes far better what another convention of the
// axes makes of them. The only check that uses the model's loads.

/// Minimum vertical component of the normal of the markers' plane at which its upper side is clear.
pub const UPRIGHT: f64 = 0.3;
/// Minimum number of flights at which mirrored axes are reported; the body must appear upside down in all flights.
const MIN_FLIGHTS: usize = 3;
/// Maximum number of compared flights, and of time windows in each.
const COMPARED: (usize, usize) = (6, 3);
/// Maximum ratio of the misfit of the mirror images to that of the recorded flights.
const MISFIT: f64 = 0.6;

/// Body axes of which the third points the other way.
const TURNED_OVER: Conversion = Conversion {
    space: Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
    body: Matrix3::new(1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, -1.0),
};

/// A fault for each flight with a path, if the body is upside down in all flights, and should not be.
pub fn check_all(body: &dyn Body, dataset: &Dataset, tracks: &[Option<Track>]) -> Vec<DataFault> {
    let (kind, conversion, detail, correction) = match body.points().are_markers {
        true => (
            FaultKind::Mirrored,
            reflection(body),
            "in all flights the body is upside down, and the model describes their mirror images far better: the axes seem left-handed, or labels are exchanged",
            MEND,
        ),
        false => (
            FaultKind::AttitudeConvention,
            TURNED_OVER,
            "in all flights the body is upside down, and the model describes them far better with the body turned over: the third body axis seems to point down",
            "state `body_up = \"-z\"` in [recording], or turn the body axes",
        ),
    };
    if !body.points().has_attitude || is_decided_by(&body.points().markers) {
        return Vec::new();
    }
    let seen: Vec<f64> = tracks
        .iter()
        .flatten()
        .filter_map(|track| upright(body, track))
        .collect();
    let Some(usual) = usual_side(body) else {
        return Vec::new();
    };
    if seen.len() < MIN_FLIGHTS || !seen.iter().all(|side| is_turned(*side, usual)) {
        return Vec::new();
    }
    let (mut plain, mut converted) = (Vec::new(), Vec::new());
    let with_track = || {
        let flights = dataset.flights.iter().zip(tracks);
        flights.filter_map(|(flight, track)| Some((flight, track.as_ref()?)))
    };
    for (flight, track) in with_track().take(COMPARED.0) {
        plain.extend(misfits(body, flight, track));
        let track = Track::converted(body, flight, &conversion);
        converted.extend(misfits(body, flight, &track));
    }
    if plain.len() < MIN_FLIGHTS
        || median(&mut converted) > MISFIT * median(&mut plain)
        || converted.is_empty()
    {
        return Vec::new();
    }
    let fault = |(flight, _): (&Flight, &Track)| DataFault::new(flight, kind, detail, correction);
    with_track().map(fault).collect()
}

/// Whether the body is upside down in the poses of every flight, as markers in a plane show it if the axes are left-handed.
pub fn is_upside_down(
    body: &dyn Body,
    mut flights: impl Iterator<Item = Vec<Option<Pose>>>,
) -> bool {
    let points = body.points();
    if !points.are_markers || !points.has_attitude || is_decided_by(&points.markers) {
        return false;
    }
    let normal = normal(&points.markers);
    let side = |poses: &[Option<Pose>]| {
        let each = poses.iter().flatten();
        median_of(each.map(|pose| (pose.attitude * normal).z))
    };
    usual_side(body).is_some_and(|usual| {
        flights.all(|poses| side(&poses).is_some_and(|side| is_turned(side, usual)))
    })
}

/// Whether a body with the markers' normal `side` is upside down, where `usual` is that of the default state.
fn is_turned(side: f64, usual: f64) -> bool {
    side * usual < 0.0 && side.abs() > UPRIGHT
}

/// Vertical component of the markers' normal in the default state; `None` if too small.
fn usual_side(body: &dyn Body) -> Option<f64> {
    let conditions = body.compiled().bind(body.parameters().to_vec());
    let state = body.compiled().layout().default_states();
    let mut observer = conditions.observer();
    let markers = body.points().markers.iter();
    let shown: Vec<_> = markers
        .map(|marker| Some(observer.position(0.0, &state, marker)))
        .collect();
    let side = (pose(&body.points().markers, &shown)?.attitude * normal(&body.points().markers)).z;
    (side.abs() > UPRIGHT).then_some(side)
}

/// Whether the model describes flights far better as changed, by their accelerations.
pub fn is_described_better(
    body: &dyn Body,
    dataset: &Dataset,
    change: impl Fn(&Flight) -> Flight,
) -> bool {
    let misfit = |change: &dyn Fn(&Flight) -> Flight| {
        let flights = dataset.flights.iter().take(COMPARED.0).map(change);
        let each = flights.flat_map(|flight| {
            let (track, _) = Track::until_contact(body, &flight);
            misfits(body, &flight, &track)
        });
        median_of(each)
    };
    let (stated, changed) = (misfit(&Flight::clone), misfit(&change));
    stated
        .zip(changed)
        .is_some_and(|(stated, changed)| changed < MISFIT * stated)
}

/// Differences between measured and modelled accelerations, m/s², in evenly spaced windows.
fn misfits(body: &dyn Body, flight: &Flight, track: &Track) -> Vec<f64> {
    let windows = track.windows();
    let step = windows.len().div_ceil(COMPARED.1).max(1);
    let each = windows.into_iter().step_by(step);
    let each = each.filter_map(|(range, motion)| {
        let points = &track.points[range];
        let middle = points[points.len() / 2];
        let motion_there = RigidMotion {
            position: middle.position,
            velocity: motion.velocity,
            attitude: middle.attitude,
            rates: Some(rates(points)?),
        };
        Some((motion.acceleration, motion_there))
    });
    let (measured, motions): (Vec<Vector3<f64>>, Vec<RigidMotion>) = each.unzip();
    let states = body.states(flight, &motions).into_iter().zip(measured);
    let each = states.filter_map(|(state, measured)| {
        let predicted = acceleration(body, &state?)?;
        Some((measured - predicted).norm())
    });
    each.collect()
}

/// Median angular velocity between successive points of a path, rad/s, inertial.
fn rates(points: &[PathPoint]) -> Option<Vector3<f64>> {
    let pairs = points.windows(2).filter_map(|pair| {
        let turn: UnitQuaternion<f64> = pair[1].attitude? * pair[0].attitude?.inverse();
        Some(turn.scaled_axis() / (pair[1].time - pair[0].time))
    });
    let pairs: Vec<Vector3<f64>> = pairs.collect();
    median_vector(&pairs)
}

/// Reflection of the space that turns left-handed axes into right-handed ones; markers in a plane show the body turned
/// over then.
pub fn reflection(body: &dyn Body) -> Conversion {
    let body = match body.points().has_attitude {
        true => {
            let normal = normal(&body.points().markers);
            Matrix3::identity() - 2.0 * normal * normal.transpose()
        }
        false => Matrix3::identity(),
    };
    Conversion {
        space: Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, 1.0)),
        body,
    }
}

/// Median vertical component of the normal of the markers' plane; `None` without attitudes.
pub fn upright(body: &dyn Body, track: &Track) -> Option<f64> {
    let normal = body
        .points()
        .has_attitude
        .then(|| normal(&body.points().markers))?;
    let each = track
        .points
        .iter()
        .filter_map(|point| Some((point.attitude? * normal).z));
    median_of(each)
}
