//! Faults of gyroscopes, accelerometers and poses: saturated readings, and units and conventions that contradict the
//! mechanics of a spinning body: moments turn its angular momentum slowly, and what is steady in the room turns in the
//! body with the angular velocity.

use flight::throw::ThrownModel;
use nalgebra::{Matrix3, UnitQuaternion};

use super::readings::{of_flights, sensors, series};
use super::records::{self, Repeated};
use super::units::{OtherUnit, unit, why};
use crate::error::{DataFault, FaultKind};
use crate::problem::FitProblem;
use dataset::{Dataset, Flight, Reading, Sensor, SensorKind, attitude};

/// Minimum number of samples at the limit, beyond the second number of times the longest run of another value: coarsely
/// rounded readings repeat all their values.
const SATURATED: (usize, usize) = (5, 3);

/// The angular momentum under another convention of quaternions must turn less, in squares: by this ratio, and by no more
/// than this part of its own square, as moments turn some bodies.
const STEADIER_BY: (f64, f64) = (4.0, 0.15);

/// Rotation between two compared angular momenta, rad: enough to see a direction that turns with the body.
const COMPARED_ROTATION: f64 = 1.5;

/// Least ratio of a flat body's third moment of inertia to the others: it is thrown spinning about the third axis.
const FLAT: f64 = 1.2;

pub fn check(problem: &FitProblem, dataset: &Dataset) -> Vec<DataFault> {
    let mut faults = Vec::new();
    for (sensor, channel) in sensors(dataset) {
        if !matches!(sensor.kind, SensorKind::Summary(_)) {
            let each = dataset.flights.iter();
            faults.extend(each.filter_map(|flight| repeated(flight, (sensor, channel))));
        }
        let found = match sensor.kind {
            SensorKind::Summary(_) => None,
            SensorKind::Instrument(instrument) => {
                faults.extend(saturated(dataset, (sensor, channel)));
                let found = unit(dataset, instrument, (sensor, channel));
                let found = found.filter(|unit| unit.index > 0);
                found.map(|unit| {
                    OtherUnit::new(sensor, channel, instrument, unit).fault(why(instrument))
                })
            }
            SensorKind::Pose => inertia(problem)
                .and_then(|inertia| {
                    let attitudes = channel + 1;
                    let axes = || body_axes(problem, dataset, attitudes, &inertia);
                    convention(dataset, attitudes, &inertia).or_else(axes)
                })
                .map(|message| (FaultKind::AttitudeConvention, message)),
        };
        faults.extend(
            found
                .into_iter()
                .flat_map(|found| of_flights(dataset, channel, found)),
        );
    }
    faults
}

/// Inertia tensor of the body in body axes, kg m²; `None` for a point mass, or if the model says nothing about it.
fn inertia(problem: &FitProblem) -> Option<Matrix3<f64>> {
    let body = ThrownModel::new(&problem.model).ok()?;
    let layout = problem.body.layout();
    let state = layout.default_states();
    let turning = body.motion(&state, &problem.parameters).turning?;
    let axes = body.frame_axes(&turning);
    Some(axes.transpose() * body.inertia(&state, &problem.parameters)? * axes)
}

/// Faults of the flights in which a component of the sensor stays at its greatest magnitude.
fn saturated(dataset: &Dataset, (sensor, channel): (&Sensor, usize)) -> Vec<DataFault> {
    let greatest = |flight: &Flight, axis: usize| {
        let values = series(flight, channel).map(|(_, reading)| reading[axis].abs());
        values.fold(0.0, f64::max)
    };
    let mut faults = Vec::new();
    for flight in &dataset.flights {
        for (axis, name) in dataset::AXES.iter().enumerate() {
            let limit = greatest(flight, axis);
            let (mut at_limit, mut elsewhere, mut run, mut last) = (0, 0, 0, f64::NAN);
            for (_, reading) in series(flight, channel) {
                run = if reading[axis] == last { run + 1 } else { 1 };
                last = reading[axis];
                if last.abs() == limit {
                    at_limit = at_limit.max(run);
                } else {
                    elsewhere = elsewhere.max(run);
                }
            }
            let shared = || {
                let mut others = dataset.flights.iter().filter(|o| o.file != flight.file);
                others.any(|other| greatest(other, axis) == limit)
            };
            let is_saturated = limit > 0.0
                && at_limit >= SATURATED.0 + SATURATED.1 * elsewhere
                && (elsewhere > 0 || shared());
            if is_saturated {
                faults.push(DataFault::new(
                    flight,
                    FaultKind::Other,
                    format!(
                        "{}_{name} is saturated: it stays at {limit} {} in {at_limit} samples",
                        sensor.name,
                        sensor.kind.unit()
                    ),
                    "leave the cells of saturated readings empty, or record with a wider range",
                ));
                break;
            }
        }
    }
    faults
}

/// Fault of a flight in which a sensor repeats its readings, or shows zeros in between.
fn repeated(flight: &Flight, (sensor, channel): (&Sensor, usize)) -> Option<DataFault> {
    let rows = flight.readings.iter().enumerate();
    let track = rows.filter_map(|(sample, row)| {
        let [x, y, z, _] = (*row.get(channel)?)?;
        Some((sample, [x, y, z]))
    });
    let track: Vec<(usize, [f64; 3])> = track.collect();
    // A body at rest before its start and after its end shows the same, as it should.
    let same = |a: &(usize, [f64; 3]), b: &(usize, [f64; 3])| a.1 == b.1;
    let rest = track
        .first()
        .map_or(0, |at| track.iter().take_while(|own| same(own, at)).count());
    let track = &track[rest.saturating_sub(1)..];
    let rest = track.last().map_or(0, |at| {
        track.iter().rev().take_while(|own| same(own, at)).count()
    });
    let track = &track[..track.len() - rest.saturating_sub(1)];
    let name = &sensor.name;
    let zeros = track.iter().filter(|(_, reading)| *reading == [0.0; 3]);
    let zeros = zeros.count();
    let is_dropout = zeros >= 2 && 2 * zeros < track.len();
    let (detail, correction) = match records::repeated(track, 0.0) {
        _ if is_dropout => (
            format!(
                "{name} is exactly zero in {zeros} samples, as where dropouts are written as zeros"
            ),
            "leave the cells of readings that are missing empty",
        ),
        Some(Repeated::Often { still, pairs }) => (
            format!("{name} repeats its readings in {still} of {pairs} intervals"),
            "keep only the samples at which the sensor recorded, or leave repeated cells empty",
        ),
        Some(Repeated::Once { first, last, .. }) => (
            format!(
                "{name} stays at the same reading from t = {:.3} s to {:.3} s, and changes otherwise",
                flight.times[first], flight.times[last]
            ),
            "leave these cells empty",
        ),
        None => return None,
    };
    Some(DataFault::new(
        flight,
        FaultKind::Frozen,
        detail,
        correction,
    ))
}

/// Message and correction for another convention of quaternions; `None` if the angular momentum does not tell.
fn convention(
    dataset: &Dataset,
    channel: usize,
    inertia: &Matrix3<f64>,
) -> Option<(String, String)> {
    type Read = fn(Reading) -> Reading;
    let stated = unsteadiness(dataset, channel, inertia, |q| q)?;
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
    let tried = others.into_iter().filter_map(|(read, what, correction)| {
        Some((
            unsteadiness(dataset, channel, inertia, read)?,
            what,
            correction,
        ))
    });
    let best = tried.min_by(|a, b| a.0.total_cmp(&b.0))?;
    (best.0 < STEADIER_BY.1 && STEADIER_BY.0 * best.0 < stated).then(|| {
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

/// Mean square change of the angular momentum while the body turns by [`COMPARED_ROTATION`], relative to its mean
/// square, with attitudes converted by `read`.
fn unsteadiness(
    dataset: &Dataset,
    channel: usize,
    inertia: &Matrix3<f64>,
    read: impl Fn(Reading) -> Reading,
) -> Option<f64> {
    let (mut changes, mut squares) = (0.0, 0.0);
    for flight in &dataset.flights {
        let poses: Vec<(f64, UnitQuaternion<f64>)> = series(flight, channel)
            .map(|(time, reading)| (time, attitude(read(reading))))
            .collect();
        let (mut momenta, mut turned) = (Vec::new(), 0.0);
        for window in poses.windows(2) {
            let turn = (window[0].1.inverse() * window[1].1).scaled_axis();
            let rate = turn / (window[1].0 - window[0].0);
            momenta.push(window[0].1 * (inertia * rate));
            turned += turn.norm();
        }
        let lag = (COMPARED_ROTATION * momenta.len() as f64 / turned).ceil();
        if !(lag >= 1.0 && lag < momenta.len() as f64) {
            continue;
        }
        for (before, after) in momenta.iter().zip(&momenta[lag as usize..]) {
            changes += (after - before).norm_squared();
            squares += before.norm_squared();
        }
    }
    (squares > 0.0).then(|| changes / squares)
}
