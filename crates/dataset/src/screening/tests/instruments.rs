//! Conventions of poses and instruments: right ones have no fault, and others are named with their correction.

use model_spec::compose::Instrument;
use nalgebra::{UnitQuaternion, Vector3};

use super::{calm_disc, found};
use crate::FaultKind;
use crate::screening::undetermined;
use crate::{Dataset, Reading, Sensor, SensorKind};

/// What is recorded in one sample: position, quaternion, angular velocity and specific force; and the angular acceleration.
#[derive(Clone, Copy)]
struct Sample {
    position: [f64; 3],
    quaternion: Reading,
    rate: [f64; 3],
    force: [f64; 3],
    angular_acceleration: Vector3<f64>,
}

impl Sample {
    fn with_rate(self, change: impl Fn([f64; 3]) -> [f64; 3]) -> Self {
        let rate = change(self.rate);
        Self { rate, ..self }
    }

    fn with_force(self, change: impl Fn([f64; 3]) -> [f64; 3]) -> Self {
        let force = change(self.force);
        Self { force, ..self }
    }
}

/// Sample of a disc that wobbles and falls more slowly than freely, in flight `index`, with errors of the readings.
fn sample(index: usize, time: f64) -> Sample {
    const TILT: f64 = 0.12;
    const STEP: f64 = 1e-4;
    let (spin, speed) = (-40.0 - 5.0 * index as f64, 8.0 + 3.0 * index as f64);
    // A disc has twice the moment of inertia about its axis, so that it precesses about twice as fast as it spins.
    let precession = 1.93 * (spin / TILT.cos());
    let about = |axis: &Vector3<f64>, angle: f64| UnitQuaternion::from_scaled_axis(axis * angle);
    let (x, z) = (Vector3::x(), Vector3::z());
    let attitude = |time: f64| {
        about(&x, 0.2)
            * about(&z, precession * time)
            * about(&x, TILT)
            * about(&z, (spin - precession * TILT.cos()) * time)
    };
    let relative = z * (spin - precession * TILT.cos());
    let rate_at =
        |time: f64| attitude(time).inverse() * about(&x, 0.2) * (z * precession) + relative;
    let (attitude, rate) = (attitude(time), rate_at(time));
    let angular_acceleration = (rate_at(time + STEP) - rate_at(time - STEP)) / (2.0 * STEP);
    let error = |k: f64| 0.05 * (1e3 * (time + k)).sin();
    let rate = rate + Vector3::new(error(1.0), error(2.0), error(3.0));
    let acceleration = Vector3::new(-5.0, 2.0, -9.4 - 0.1 * index as f64);
    let velocity = Vector3::new(speed, 0.0, 2.0);
    let position =
        Vector3::new(0.0, 0.0, 1.5) + velocity * time + acceleration * (0.5 * time * time);
    let force = attitude.inverse() * (acceleration + Vector3::z() * 9.7935);
    let [qx, qy, qz, qw] = attitude.coords.into();
    Sample {
        position: (position + Vector3::new(error(4.0), error(5.0), error(6.0)) * 0.02).into(),
        quaternion: [qw, qx, qy, qz],
        rate: rate.into(),
        force: (force + Vector3::new(error(7.0), error(8.0), error(9.0))).into(),
        angular_acceleration,
    }
}

/// Flights of the disc, recorded by a pose, a gyroscope and an accelerometer, or by the last two.
fn recorded(has_pose: bool, change: impl Fn(Sample) -> Sample) -> Dataset {
    let (_, mut dataset) = calm_disc(1);
    dataset.markers.clear();
    let instrument = SensorKind::Instrument;
    dataset.sensors = [
        ("tag", SensorKind::Pose),
        ("gyro", instrument(Instrument::Gyroscope)),
        ("acc", instrument(Instrument::Accelerometer)),
    ]
    .into_iter()
    .skip(usize::from(!has_pose))
    .map(|(name, kind)| Sensor::new(name, kind, [0.0; 3]))
    .collect();
    dataset.flights.truncate(5);
    for (index, flight) in dataset.flights.iter_mut().enumerate() {
        flight.times = (0..200).map(|k| f64::from(k) * 0.005).collect();
        flight.positions = vec![Vec::new(); flight.times.len()];
        let rows = flight.times.iter().map(|time| {
            let own = change(sample(index, *time));
            let three = |[x, y, z]: [f64; 3]| Some([x, y, z, 0.0]);
            let pose = has_pose.then(|| [three(own.position), Some(own.quaternion)]);
            let instruments = [three(own.rate), three(own.force)];
            pose.into_iter().flatten().chain(instruments).collect()
        });
        flight.readings = rows.collect();
    }
    dataset
}

/// Kind and correction of the faults of a recording, which all flights have.
fn told(has_pose: bool, change: impl Fn(Sample) -> Sample) -> Option<(FaultKind, String)> {
    let (model, _) = calm_disc(1);
    let dataset = recorded(has_pose, change);
    let mut faults = found(&model, &dataset).into_iter();
    let first = faults.next()?;
    let others: Vec<_> = faults.collect();
    assert_eq!(
        1 + others.len(),
        dataset.flights.len(),
        "{first}: {others:?}"
    );
    assert!(others.iter().all(|own| own.correction == first.correction));
    Some((first.fault, first.correction))
}

#[test]
fn right_recordings_have_no_fault() {
    assert_eq!(told(true, |own| own), None);
    assert_eq!(told(false, |own| own), None);
}

#[test]
fn readings_on_a_coarse_grid_are_not_saturated_and_those_at_a_limit_are() {
    let coarse = |part: f64| (part / 4.0).round() * 4.0;
    for has_pose in [true, false] {
        let told = |change: fn(f64) -> f64| {
            let (model, _) = calm_disc(1);
            let changed = |own: Sample| own.with_rate(|all| all.map(change));
            let faults = found(&model, &recorded(has_pose, changed));
            let saturated = faults
                .into_iter()
                .filter(|own| own.detail.contains("saturated"));
            saturated.count()
        };
        assert_eq!(told(coarse), 0);
        assert_eq!(told(|part| part.clamp(-48.0, 48.0)), 3);
    }
    // On a coarse grid a long run in one flight may be what the body does.
    let (model, _) = calm_disc(1);
    for (flights, count) in [(1, 0), (2, 2)] {
        let mut dataset = recorded(true, |own| own);
        for (index, flight) in dataset.flights.iter_mut().enumerate() {
            for (sample, row) in flight.readings.iter_mut().enumerate() {
                let at_limit = index < flights && (50..90).contains(&sample);
                let rate = if at_limit {
                    40.0
                } else {
                    [10.0, 20.0, 30.0][sample / 6 % 3]
                };
                row[2] = Some([rate, 0.3, -40.0 - 0.01 * sample as f64, 0.0]);
            }
        }
        let faults = found(&model, &dataset);
        let saturated = faults
            .iter()
            .filter(|own| own.detail.contains("gyro_x is saturated"));
        assert_eq!(saturated.count(), count, "{faults:?}");
    }
    // Nowhere else does a reading repeat.
    let (model, _) = calm_disc(1);
    for (samples, count) in [(7, 0), (8, 1)] {
        let mut dataset = recorded(true, |own| own);
        for (k, row) in (0..samples).zip(&mut dataset.flights[1].readings[50..]) {
            row[2] = Some([70.0, 0.3 + 0.01 * f64::from(k), -40.0, 0.0]);
        }
        let faults = found(&model, &dataset);
        let saturated = faults
            .iter()
            .filter(|own| own.detail.contains("gyro_x is saturated"));
        assert_eq!(saturated.count(), count, "{faults:?}");
    }
}

#[test]
fn dropouts_of_a_gyroscope_that_are_written_as_zeros_are_named() {
    let (model, _) = calm_disc(1);
    let told = |is_zero: fn(usize) -> bool| {
        let mut dataset = recorded(true, |own| own);
        let gyroscope = 2; // Behind the position and the attitude of the pose.
        for row in dataset
            .flights
            .iter_mut()
            .flat_map(|own| own.readings.iter_mut().enumerate())
        {
            if is_zero(row.0) {
                row.1[gyroscope] = Some([0.0; 4]);
            }
        }
        let faults = found(&model, &dataset);
        faults
            .iter()
            .filter(|own| own.detail.contains("dropouts are written as zeros"))
            .count()
    };
    assert_eq!(told(|sample| sample % 3 == 1), 5);
    // Of a body that turns at times.
    assert_eq!(told(|sample| sample % 3 != 1), 0);
}

#[test]
fn axes_of_instruments_beside_poses_are_named() {
    type Change = fn(Sample) -> Sample;
    let cases: [(Change, &str); 13] = [
        (
            |own| {
                let turn = crate::attitude(own.quaternion);
                let force = Vector3::from(own.force) - turn.inverse() * Vector3::z() * 19.587;
                Sample {
                    force: force.into(),
                    ..own
                }
            },
            "write specific forces",
        ),
        (
            |own| own.with_rate(|all| all.map(|part| -part)),
            "gyroscope_axes = [\"-x\", \"-y\", \"-z\"]",
        ),
        (
            |own| own.with_rate(|[x, y, z]| [y, x, z]),
            "gyroscope_axes = [\"+y\", \"+x\", \"+z\"]",
        ),
        (
            |own| own.with_rate(|[x, y, z]| [y, z, x]),
            "gyroscope_axes = [\"+z\", \"+x\", \"+y\"]",
        ),
        (
            |own| own.with_force(|all| all.map(|part| -part)),
            "accelerometer_axes = [\"-x\", \"-y\", \"-z\"]",
        ),
        (
            |own| own.with_force(|[x, y, z]| [x, -y, -z]),
            "accelerometer_axes = [\"+x\", \"-y\", \"-z\"]",
        ),
        (
            |own| own.with_force(|all| all.map(|part| part / 9.80665)),
            "acceleration = \"g\"",
        ),
        (
            |own| own.with_force(|all| all.map(|part| part / 9.80665e-3)),
            "acceleration = \"mg\"",
        ),
        (
            |own| own.with_rate(|all| all.map(|part| part.to_degrees() * 1e3)),
            "angular_rate = \"mdeg/s\"",
        ),
        (
            |own| own.with_rate(|all| all.map(|part| part / std::f64::consts::TAU)),
            "angular_rate = \"rev/s\"",
        ),
        (
            |own| {
                let turn = crate::attitude(own.quaternion);
                let force = Vector3::from(own.force) - turn.inverse() * Vector3::z() * 9.7935;
                Sample {
                    force: force.into(),
                    ..own
                }
            },
            "write specific forces",
        ),
        (
            |own| {
                let rate = crate::attitude(own.quaternion) * Vector3::from(own.rate);
                Sample {
                    rate: rate.into(),
                    ..own
                }
            },
            "along the axes of the body",
        ),
        (
            |own| own.with_force(|[x, y, z]| [-z, y, x].map(|part| part / 9.80665)),
            "accelerometer_axes = [\"+z\", \"+y\", \"-x\"]",
        ),
    ];
    for (change, correction) in cases {
        let told = told(true, change).map(|(_, correction)| correction);
        let told = told.unwrap_or_default();
        assert!(told.contains(correction), "{told} for {correction}");
    }
}

/// Turned accelerometers off the axis of the spin: they show the accelerations of another place.
#[test]
fn a_turned_accelerometer_beside_a_gyroscope_alone_is_named() {
    const PLACE: [f64; 3] = [0.02, 0.01, 0.005];
    let (model, _) = calm_disc(1);
    type Turn = fn([f64; 3]) -> [f64; 3];
    let told = |turn: Turn| {
        let mut dataset = recorded(false, |own| {
            let (rate, place) = (Vector3::from(own.rate), Vector3::from(PLACE));
            let lever = own.angular_acceleration.cross(&place) + rate.cross(&rate.cross(&place));
            own.with_force(|force| turn((Vector3::from(force) + lever).into()))
        });
        dataset.sensors[1].position = PLACE;
        let faults = found(&model, &dataset);
        faults.first().map(|own| own.correction.clone())
    };
    assert_eq!(told(|own| own), None);
    let cases: [(Turn, &str); 3] = [
        (|[x, y, z]| [y, -x, z], "[\"-y\", \"+x\", \"+z\"]"),
        (|[x, y, z]| [x, z, -y], "[\"+x\", \"-z\", \"+y\"]"),
        (|[x, y, z]| [-x, -y, z], "[\"-x\", \"-y\", \"+z\"]"),
    ];
    for (turn, axes) in cases {
        let told = told(turn).unwrap_or_default();
        assert!(told.contains(axes), "{told} for {axes}");
    }
}

/// Instruments at the mass centre beside nothing else: the body spins about its axis, and the force on it turns slowly.
#[test]
fn axes_of_instruments_alone_are_named() {
    type Turn = fn([f64; 3]) -> [f64; 3];
    let same: Turn = |own| own;
    let over: Turn = |[x, y, z]| [x, -z, y];
    let exchanged: Turn = |[x, y, z]| [y, x, z];
    let opposite: Turn = |own| own.map(|part| -part);
    let told = |rate: Turn, force: Turn| {
        let found = told(false, |own| own.with_rate(rate).with_force(force));
        let correction = found.map_or_else(String::new, |(_, correction)| correction);
        ["gyroscope_axes", "accelerometer_axes"].map(|key| correction.contains(key))
    };
    let cases = [
        (same, same, [false, false]),
        (over, same, [true, false]),
        (same, over, [false, true]),
        (over, over, [true, true]),
        (same, exchanged, [false, true]),
        (opposite, same, [true, false]),
    ];
    for (case, (rate, force, named)) in cases.into_iter().enumerate() {
        assert_eq!(told(rate, force), named, "case {case}");
    }
}

#[test]
fn a_wrong_place_of_an_accelerometer_beside_a_gyroscope_alone_is_named() {
    let (model, _) = calm_disc(1);
    let told = |place: [f64; 3]| {
        let mut dataset = recorded(false, |own| own);
        dataset.sensors[1].position = place;
        let faults = found(&model, &dataset);
        faults.first().map(|own| own.detail.clone())
    };
    let detail = told([0.03, 0.0, 0.0]).unwrap_or_default();
    assert!(
        detail.contains("only at x = 0.0 mm, y = 0.0 mm"),
        "{detail}"
    );
    // What is off by less is left to the fit.
    assert_eq!(told([0.001, 0.0, 0.0]), None);
}

/// A fit in another unit whose residuals are as large as the readings tells nothing of the unit.
#[test]
fn another_unit_is_one_in_which_a_fit_follows_the_readings() {
    let dataset = recorded(false, |own| own);
    let others = undetermined(&dataset);
    let unit = others.first().expect("units of the accelerometer");
    let squares = dataset.flights.iter().flat_map(|flight| &flight.readings);
    let squares =
        squares.filter_map(|row| row[1].map(|[x, y, z, _]| (x * x + y * y + z * z) / 3.0));
    let squares: Vec<f64> = squares.collect();
    let size = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt() * 9.80665;
    // Of readings of 30 m/s², as if they were in g, or had been converted from g twice.
    let forces = recorded(false, |own| {
        own.with_force(|all| all.map(|part| 3.0 * part))
    });
    assert_eq!(undetermined(&forces).len(), 2);
    let left = |part: f64| move |name: &str| (name == "acc").then_some(part * size);
    assert!(unit.is_followed(&dataset, left(0.1)));
    assert!(!unit.is_followed(&dataset, left(1.0)));
}

#[test]
fn poses_in_other_units_axes_and_conventions_are_named() {
    let scaled = |unit: f64| {
        move |own: Sample| Sample {
            position: own.position.map(|part| part / unit),
            ..own
        }
    };
    for unit in [0.001, 0.0254, 0.3048] {
        let told = told(true, scaled(unit));
        let (kind, correction) = told.unwrap_or_else(|| panic!("no fault of unit {unit}"));
        assert_eq!(kind, FaultKind::Units);
        assert!(correction.ends_with(&unit.to_string()), "{correction}");
    }
    // A room with y up: both the positions and the attitudes are turned.
    let y_up = |own: Sample| {
        let to_y = UnitQuaternion::from_scaled_axis(-Vector3::x() * std::f64::consts::FRAC_PI_2);
        let [x, y, z, w] = (to_y * crate::attitude(own.quaternion)).coords.into();
        Sample {
            position: (to_y * Vector3::from(own.position)).into(),
            quaternion: [w, x, y, z],
            ..own
        }
    };
    let (kind, _) = told(true, y_up).expect("a fault");
    assert_eq!(kind, FaultKind::Axes);
    // With conjugates the track looks as if axes or units were others.
    let conjugated = |own: Sample| {
        let [w, x, y, z] = own.quaternion;
        Sample {
            quaternion: [w, -x, -y, -z],
            ..own
        }
    };
    for scale in [1.0, 0.001] {
        let (kind, correction) = told(true, |own| conjugated(scaled(scale)(own))).expect("a fault");
        assert_eq!(kind, FaultKind::AttitudeConvention);
        assert!(correction.contains("inertial_to_body"), "{correction}");
    }
}
