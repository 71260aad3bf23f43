//! Faults of gyroscopes, accelerometers and poses: saturated readings, and units and conventions that contradict the
//! mechanics of a spinning body: moments turn its angular momentum slowly, and what is steady in the room turns in the
//! body with the angular velocity.

use flight::throw::ThrownModel;
use model_spec::compose::Instrument;
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use super::records::{self, Repeated};
use crate::error::{DataFault, FaultKind};
use crate::problem::FitProblem;
use dataset::statistics::median_of;
use dataset::{
    ACCELERATIONS, ANGULAR_RATES, Dataset, Flight, Reading, SPEEDS, Sensor, SensorKind, attitude,
};

/// Minimum number of samples at the limit, beyond the second number of times the longest run of another value: coarsely
/// rounded readings repeat all their values.
const SATURATED: (usize, usize) = (5, 3);

/// Maximum relative difference of the apparent from a known unit: motions of the axis turn at another rate than the
/// spin.
const UNIT_ERROR: f64 = 0.5;
/// The same of speeds: their units are nearer to one another, and wind may halve a speed.
const SPEED_UNIT_ERROR: f64 = 0.08;
/// Maximum angle by which a direction may turn in the body from sample to sample, rad: nearly half a turn.
const MAX_TURN: f64 = 2.5;
/// Minimum share of what turns in the mean square of the angular velocity across its mean direction; the rest is noise.
const MIN_TURNING: f64 = 0.4;
/// The angular momentum under another convention of quaternions must turn less, in squares: by this ratio, and by no more
/// than this part of its own square, as moments turn some bodies.
const STEADIER_BY: (f64, f64) = (4.0, 0.15);

/// Least rotation over which forces on the body average out in it, rad, and least centripetal acceleration that tells the
/// unit of an accelerometer, m/s².
const MIN_TURNED: f64 = 20.0;
const MIN_CENTRIPETAL: f64 = 10.0;

/// Rotation between two compared angular momenta, rad: enough to see a direction that turns with the body.
const COMPARED_ROTATION: f64 = 1.5;

/// Least ratio of a flat body's third moment of inertia to the others: it is thrown spinning about the third axis.
const FLAT: f64 = 1.2;
pub fn check(problem: &FitProblem, dataset: &Dataset) -> Vec<DataFault> {
    if dataset.sensors.is_empty() {
        return Vec::new();
    }
    let mut faults = Vec::new();
    let mut channel = 0;
    for sensor in &dataset.sensors {
        if !matches!(sensor.kind, SensorKind::Summary(_)) {
            let each = dataset.flights.iter();
            faults.extend(each.filter_map(|flight| repeated(flight, (sensor, channel))));
        }
        let found = match sensor.kind {
            SensorKind::Summary(_) => None,
            SensorKind::Instrument(instrument) => {
                faults.extend(saturated(dataset, (sensor, channel)));
                let found = unit(dataset, instrument, (sensor, channel)).filter(|unit| *unit > 0);
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
        channel += sensor.kind.channels().len();
    }
    faults
}

fn series(flight: &Flight, channel: usize) -> impl Iterator<Item = (f64, Reading)> {
    let samples = flight.times.iter().zip(&flight.readings);
    samples.filter_map(move |(time, row)| Some((*time, (*row.get(channel)?)?)))
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

/// Units in which an instrument may record; the first is that of a dataset.
fn units(instrument: Instrument) -> &'static [(&'static str, f64)] {
    match instrument {
        Instrument::Gyroscope => &ANGULAR_RATES,
        Instrument::Accelerometer => &ACCELERATIONS,
        Instrument::Speed => &SPEEDS,
    }
}

/// Why readings are in another unit than the stated one.
fn why(instrument: Instrument) -> &'static str {
    match instrument {
        Instrument::Accelerometer => {
            "only in this unit do the readings show the centripetal acceleration that the measured rates give at its place"
        }
        Instrument::Gyroscope => "the readings follow the motion of the body only in this unit",
        Instrument::Speed => "only in this unit are the readings those of the measured path",
    }
}

/// Index among [`units`] of the one that is nearest to the median of what the flights show; `None` if none is near, or the
/// mechanics of the body do not tell it.
fn unit(
    dataset: &Dataset,
    instrument: Instrument,
    (sensor, channel): (&Sensor, usize),
) -> Option<usize> {
    let flights = dataset.flights.iter();
    let found = match instrument {
        Instrument::Speed => {
            let apparent = |own| super::path_speed::apparent_unit(dataset, own, channel);
            median_of(flights.filter_map(apparent))
        }
        Instrument::Gyroscope => median_of(flights.filter_map(|own| apparent_unit(own, channel))),
        Instrument::Accelerometer => {
            let (gyroscope, rates) = gyroscope(dataset)?;
            let of_rates = unit(dataset, Instrument::Gyroscope, (gyroscope, rates));
            if sensor.position_is_unknown || of_rates.is_some_and(|unit| unit > 0) {
                return None;
            }
            let place = Vector3::from(sensor.position);
            let apparent = |own| apparent_unit_of_forces(own, [channel, rates], place);
            median_of(flights.filter_map(apparent))
        }
    }?;
    let error = |unit: f64| (found / unit - 1.0).abs();
    let known = units(instrument).iter().map(|(_, unit)| error(*unit));
    let nearest = known.enumerate().min_by(|a, b| a.1.total_cmp(&b.1))?;
    let limit = match instrument {
        Instrument::Speed => SPEED_UNIT_ERROR,
        _ => UNIT_ERROR,
    };
    (nearest.1 < limit).then_some(nearest.0)
}

/// Another unit than the stated one in which an instrument may have recorded.
pub struct OtherUnit {
    sensor: String,
    channel: usize,
    instrument: Instrument,
    unit: &'static (&'static str, f64),
}

impl OtherUnit {
    fn new(sensor: &Sensor, channel: usize, instrument: Instrument, unit: usize) -> Self {
        Self {
            sensor: sensor.name.clone(),
            channel,
            instrument,
            unit: &units(instrument)[unit],
        }
    }

    /// The other units of the instruments whose unit the mechanics of the body do not determine.
    pub fn undetermined(dataset: &Dataset) -> Vec<Self> {
        let (mut found, mut channel) = (Vec::new(), 0);
        for sensor in &dataset.sensors {
            // A speed alone determines too little for a trial.
            if let SensorKind::Instrument(instrument) = sensor.kind
                && instrument != Instrument::Speed
                && unit(dataset, instrument, (sensor, channel)).is_none()
            {
                let others = 1..units(instrument).len();
                found.extend(others.map(|unit| Self::new(sensor, channel, instrument, unit)));
            }
            channel += sensor.kind.channels().len();
        }
        found
    }

    /// The flight with readings converted from this unit.
    pub fn converted(&self, mut flight: Flight) -> Flight {
        let readings = flight.readings.iter_mut();
        for reading in readings.filter_map(|row| row.get_mut(self.channel)?.as_mut()) {
            *reading = reading.map(|part| part * self.unit.1);
        }
        flight
    }

    /// Message and correction, given how the unit was found.
    fn fault(&self, why: &str) -> (FaultKind, (String, String)) {
        let (sensor, (unit, _)) = (&self.sensor, self.unit);
        let (key, si) = match self.instrument {
            Instrument::Accelerometer => ("acceleration", "m/s²"),
            Instrument::Gyroscope => ("angular_rate", "rad/s"),
            Instrument::Speed => ("speed", "m/s"),
        };
        let detail = format!("{sensor} seems to be in {unit}: {why}");
        let correction = format!("state `{key} = \"{unit}\"` in [recording], or write {si}");
        (FaultKind::SensorUnit, (detail, correction))
    }

    /// Faults of the flights with readings in this unit, given how it was found.
    pub fn faults(&self, dataset: &Dataset, why: &str) -> Vec<DataFault> {
        of_flights(dataset, self.channel, self.fault(why))
    }
}

/// A fault of every flight with readings in a channel.
fn of_flights(
    dataset: &Dataset,
    channel: usize,
    (kind, (detail, correction)): (FaultKind, (String, String)),
) -> Vec<DataFault> {
    let flights = dataset.flights.iter();
    let with = flights.filter(|flight| series(flight, channel).next().is_some());
    with.map(|flight| DataFault::new(flight, kind, &*detail, &*correction))
        .collect()
}

/// The first gyroscope and its channel.
fn gyroscope(dataset: &Dataset) -> Option<(&Sensor, usize)> {
    let mut channel = 0;
    for sensor in &dataset.sensors {
        if sensor.kind == SensorKind::Instrument(Instrument::Gyroscope) {
            return Some((sensor, channel));
        }
        channel += sensor.kind.channels().len();
    }
    None
}

/// Unit of the recorded specific forces, m/s²: the mean centripetal acceleration at `place`, across the mean axis of the
/// spin, over their mean; forces on the body turn with it there, and have none. `None` if it turns too little.
fn apparent_unit_of_forces(
    flight: &Flight,
    channels: [usize; 2],
    place: Vector3<f64>,
) -> Option<f64> {
    let rows = flight.times.iter().zip(&flight.readings);
    let samples = rows.filter_map(|(time, row)| {
        let [force, rate] = channels.map(|own| row.get(own).copied().flatten());
        let ([x, y, z, _], [p, q, r, _]) = (force?, rate?);
        Some((*time, Vector3::new(x, y, z), Vector3::new(p, q, r)))
    });
    let samples: Vec<(f64, Vector3<f64>, Vector3<f64>)> = samples.collect();
    let count = samples.len() as f64;
    let rate = samples.iter().map(|own| own.2).sum::<Vector3<f64>>() / count;
    let turned = rate.norm() * (samples.last()?.0 - samples[0].0);
    let across = |vector: Vector3<f64>| vector - rate * (rate.dot(&vector) / rate.norm_squared());
    let read = across(samples.iter().map(|own| own.1).sum::<Vector3<f64>>() / count);
    let centripetal = samples.iter().map(|own| own.2.cross(&own.2.cross(&place)));
    let expected = across(centripetal.sum::<Vector3<f64>>() / count);
    let is_determined = turned > MIN_TURNED && expected.norm() > MIN_CENTRIPETAL;
    is_determined.then(|| expected.norm_squared() / expected.dot(&read))
}

/// Unit of the recorded rates, rad/s: the rate at which their part across the mean turns, over their magnitude; `None`
/// if noise or the interval hide it.
fn apparent_unit(flight: &Flight, channel: usize) -> Option<f64> {
    let rates: Vec<(f64, Vector3<f64>)> = series(flight, channel)
        .map(|(time, [x, y, z, _])| (time, Vector3::new(x, y, z)))
        .collect();
    let mean = rates.iter().map(|(_, rate)| rate).sum::<Vector3<f64>>() / rates.len() as f64;
    let axis = mean.normalize();
    let across = rates.iter().map(|(_, rate)| rate - axis * axis.dot(rate));
    let across: Vec<Vector3<f64>> = across.collect();
    let product = |lag: usize| {
        let pairs = across.iter().zip(across.iter().skip(lag));
        pairs.map(|(a, b)| a.dot(b)).sum::<f64>() / across.len().saturating_sub(lag) as f64
    };
    // A part that turns by φ per sample has the mean products P cos φ and P cos 2φ with the next samples, free of
    // noise: cos φ = x with 2x² − 1 = (cos 2φ/cos φ) x.
    let next = product(1);
    let ratio = product(2) / next;
    let cosine = (ratio + next.signum() * (ratio * ratio + 8.0).sqrt()) / 4.0;
    let turned = cosine.clamp(-1.0, 1.0).acos();
    let is_turning = next / cosine > MIN_TURNING * product(0);
    if !is_turning || turned > MAX_TURN {
        return None;
    }
    let interval = (rates.last()?.0 - rates[0].0) / (rates.len() - 1) as f64;
    Some(turned / interval / mean.norm())
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
