//! Fits by sensors of every kind, of datasets in axes of unknown vertical, and of markers whose origin is uncertain.

use std::collections::BTreeMap;

use dataset::{Dataset, Role, Sensor, SensorKind};
use diagnose::{DiagnosisOptions, diagnose};
use identify::{FitOptions, FitReport, VERTICAL_ANGLES, fit, upward};
use model_spec::compose::Instrument;
use nalgebra::{Rotation3, Vector3};
use studies::oracle_flights::{Plan, TWELVE, disc, truth};
use studies::sensors::{Observed, SensorNoise, sensor_flights};

/// Maximum permitted error of an estimate, in standard errors.
const MAX_Z: f64 = 4.5;

const PLAN: Plan<'static> = Plan {
    flights: 6,
    ..TWELVE
};

fn inertial() -> Vec<Sensor> {
    let gyroscope = SensorKind::Instrument(Instrument::Gyroscope);
    let accelerometer = SensorKind::Instrument(Instrument::Accelerometer);
    vec![
        Sensor::new("gyro", gyroscope, [0.0; 3]),
        Sensor::new("acc", accelerometer, [0.02, -0.01, 0.005]),
    ]
}

fn observed(markers: bool, sensors: Vec<Sensor>, displacement: [f64; 3]) -> Observed {
    Observed {
        markers,
        sensors,
        displacement,
        noise: SensorNoise::default(),
    }
}

fn assert_true(report: &FitReport, words: &str) {
    for (name, value) in truth(&disc(), &PLAN) {
        let own = &report.coefficients[&name];
        let z = (own.value - value) / own.std_error;
        assert!(z.abs() < MAX_Z, "{words}: {name} {z} standard errors off");
    }
}

fn fitted(dataset: &Dataset) -> FitReport {
    let found = fit(&disc(), dataset, &FitOptions::default()).expect("a fit");
    assert!(
        found.report.iterations.converged,
        "{:?}",
        found.report.iterations
    );
    found.report
}

#[test]
fn poses_and_inertial_sensors_give_the_coefficients_that_markers_give() {
    let noise = SensorNoise::default();
    let pose = || Sensor::new("tag", SensorKind::Pose, [0.03, 0.0, 0.01]);
    let sets = [
        ("pose", observed(false, vec![pose()], [0.0; 3])),
        ("inertial", observed(false, inertial(), [0.0; 3])),
        ("markers and inertial", observed(true, inertial(), [0.0; 3])),
    ];
    let stated = BTreeMap::from([
        ("position", noise.position),
        ("attitude", noise.attitude),
        ("gyroscope", noise.rate),
        ("accelerometer", noise.force),
    ]);
    for (words, set) in sets {
        let report = fitted(&sensor_flights(&disc(), &PLAN, &set, 7));
        assert_true(&report, words);
        assert_eq!(report.position_noise().is_some(), words != "inertial");
        for sensor in &report.sensors {
            let ratio = sensor.sigma / stated[sensor.measures.as_str()];
            assert!((ratio - 1.0).abs() < 0.08, "{words}: {sensor:?}");
        }
    }
}

#[test]
fn a_displaced_accelerometer_is_named() {
    let set = observed(true, inertial(), [0.005, 0.0, 0.0]);
    let mut dataset = sensor_flights(&disc(), &PLAN, &set, 7);
    for flight in dataset.flights.iter_mut().skip(4) {
        flight.role = Role::HeldOut;
    }
    let found = diagnose(&disc(), &dataset, &DiagnosisOptions::default()).expect("a diagnosis");
    let cause = &found.report.explanations[0].effects[0];
    assert_eq!(cause.name, "accelerometer-misplaced");
    let by = &cause.estimates["accelerometer_by_1"];
    assert!((by.value - 0.005).abs() < MAX_Z * by.std_error, "{by:?}");
}

/// Changes what the instrument number `instrument` of a dataset without poses reads.
fn misread(
    dataset: &mut Dataset,
    instrument: usize,
    change: impl Fn(Vector3<f64>) -> Vector3<f64>,
) {
    for row in dataset.flights.iter_mut().flat_map(|own| &mut own.readings) {
        row[instrument] = row[instrument].map(|[x, y, z, last]| {
            let read = change(Vector3::new(x, y, z));
            [read.x, read.y, read.z, last]
        });
    }
}

/// Checks that a diagnosis names `effect` alone, with the value of its coefficient, where an instrument is misread.
fn assert_named(
    (instrument, effect): (usize, &str),
    expected: (String, f64),
    change: impl Fn(Vector3<f64>) -> Vector3<f64>,
) {
    let set = observed(true, inertial(), [0.0; 3]);
    let mut dataset = sensor_flights(&disc(), &PLAN, &set, 7);
    misread(&mut dataset, instrument, change);
    assert_names(&dataset, effect, expected);
}

/// Checks that a diagnosis names `effect` alone, with the value of its coefficient.
fn assert_names(dataset: &Dataset, effect: &str, (coefficient, expected): (String, f64)) {
    let found = diagnose(&disc(), dataset, &DiagnosisOptions::default());
    let report = found.expect("a diagnosis").report;
    let effects = &report.explanations[0].effects;
    assert_eq!(effects.len(), 1, "{}", report.summary);
    assert_eq!(effects[0].name, effect, "{}", report.summary);
    let found = &effects[0].estimates[&coefficient];
    let error = (found.value - expected).abs();
    assert!(error < MAX_Z * found.std_error, "{expected}: {found:?}");
}

#[test]
fn an_instrument_that_is_turned_about_any_axis_is_named() {
    let of_names = [
        ("gyroscope-misaligned", "gyro_turn"),
        ("accelerometer-misaligned", "accelerometer_turn"),
    ];
    for (instrument, (name, coefficient)) in of_names.into_iter().enumerate() {
        for (axis, angle) in [(0, 0.05), (2, 0.6)] {
            let turn = Rotation3::from_axis_angle(&Vector3::ith_axis(axis), angle);
            let coefficient = format!("{coefficient}_{}", axis + 1);
            let expected = (coefficient, 2.0 * f64::tan(angle / 2.0));
            assert_named((instrument, name), expected, |read| turn.inverse() * read);
        }
    }
}

#[test]
fn a_wrong_scale_of_any_axis_of_an_instrument_is_named() {
    let of_names = [
        ("gyroscope-scale", "gyro_scale"),
        ("accelerometer-scale", "force_scale"),
    ];
    for (instrument, (name, coefficient)) in of_names.into_iter().enumerate() {
        for axis in [0, 2] {
            let mut scale = Vector3::repeat(1.0);
            scale[axis] = 1.04;
            let expected = (format!("{coefficient}_{}", axis + 1), 0.04);
            assert_named((instrument, name), expected, |read| {
                read.component_mul(&scale)
            });
        }
    }
}

/// Keeps every third sample, with the readings of the gyroscope from two samples before.
fn delayed(dataset: &mut Dataset) {
    for flight in &mut dataset.flights {
        let kept = (2..flight.times.len()).step_by(3);
        let read = |k: usize| {
            let mut row = flight.readings[k].clone();
            row[0] = flight.readings[k - 2][0];
            row
        };
        flight.readings = kept.clone().map(read).collect();
        flight.positions = kept.clone().map(|k| flight.positions[k].clone()).collect();
        flight.times = kept.map(|k| flight.times[k]).collect();
    }
}

#[test]
fn a_gyroscope_that_is_late_by_a_part_of_the_time_between_samples_is_named() {
    let set = observed(true, inertial(), [0.0; 3]);
    let mut dataset = sensor_flights(&disc(), &PLAN, &set, 7);
    delayed(&mut dataset);
    let expected = ("gyro_late".to_owned(), 2.0 / PLAN.rate);
    assert_names(&dataset, "gyroscope-late", expected);
}

#[test]
fn without_positions_the_noise_of_a_diagnosis_is_that_of_the_instrument() {
    let set = observed(false, inertial(), [0.0; 3]);
    let mut dataset = sensor_flights(&disc(), &PLAN, &set, 7);
    misread(&mut dataset, 1, |read| read + Vector3::new(0.7, -0.4, 0.5));
    let found = diagnose(&disc(), &dataset, &DiagnosisOptions::default()).expect("a diagnosis");
    let gain = found.report.predictive_gain.expect("an explanation");
    let force = SensorNoise::default().force;
    for noise in [gain.noise_m, found.report.noise["accelerometer"].sigma] {
        assert!((noise / force - 1.0).abs() < 0.1, "{noise} and {force}");
    }
}

/// Rotates all measured positions of a dataset, and marks its vertical direction as unknown.
fn turned(mut dataset: Dataset, turn: Rotation3<f64>) -> Dataset {
    for flight in &mut dataset.flights {
        for position in flight.positions.iter_mut().flatten().flatten() {
            *position = (turn * Vector3::from(*position)).into();
        }
    }
    dataset.unknown_vertical = true;
    dataset
}

#[test]
fn a_vertical_at_any_angle_is_found() {
    let set = observed(true, Vec::new(), [0.0; 3]);
    let plan = Plan { flights: 4, ..PLAN };
    for turn in [
        Rotation3::from_euler_angles(2.0, 0.7, 0.0),
        Rotation3::from_euler_angles(-0.4, -1.3, 0.5),
    ] {
        let dataset = turned(sensor_flights(&disc(), &plan, &set, 11), turn);
        let report = fitted(&dataset);
        let angles = VERTICAL_ANGLES.map(|name| report.coefficients[name].value);
        let found = Vector3::from(upward(angles));
        let angle = found.angle(&(turn * Vector3::z()));
        assert!(angle < 2e-3, "{angle} rad off");
        assert_true(&report, "unknown vertical");
    }
}

#[test]
fn an_uncertain_origin_of_the_markers_is_estimated() {
    let set = observed(true, Vec::new(), [0.0; 3]);
    let mut dataset = sensor_flights(&disc(), &PLAN, &set, 13);
    for marker in &mut dataset.markers {
        marker.position[2] += 0.004;
    }
    dataset.origin_error = Some([0.0, 0.0, 0.005]);
    let report = fitted(&dataset);
    let offset = &report.coefficients["offset_3"];
    let z = (offset.value + 0.004) / offset.std_error;
    assert!(z.abs() < MAX_Z && offset.std_error < 0.004, "{offset:?}");
    assert!(report.coefficients["offset_1"].fixed);
    assert_true(&report, "uncertain origin");
}

/// Writes a dataset to a folder with the positions of the markers or sensors `names` replaced by "unknown", and loads
/// it again. Returns the error message if the folder cannot be loaded.
fn with_unknown(dataset: &Dataset, names: &[&str]) -> Result<Dataset, String> {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path().join("dataset");
    dataset::write(&folder, dataset).expect("written");
    let file = folder.join("dataset.toml");
    let text = std::fs::read_to_string(&file).expect("a manifest");
    let mut is_named = false;
    let lines = text.lines().map(|line| {
        if let Some(name) = line.strip_prefix("name = ") {
            is_named = names.contains(&name.trim_matches('"'));
        }
        match line.starts_with("position = ") && is_named {
            true => "position = \"unknown\"",
            false => line,
        }
    });
    let lines: Vec<&str> = lines.collect();
    std::fs::write(&file, lines.join("\n")).expect("written");
    dataset::load(&folder).map_err(|error| error.to_string())
}

#[test]
fn unknown_positions_of_markers_are_those_that_the_flights_show() {
    let set = observed(true, Vec::new(), [0.0; 3]);
    let dataset = sensor_flights(&disc(), &PLAN, &set, 17);
    let names: Vec<&str> = dataset.markers.iter().map(|marker| &*marker.name).collect();
    let all = with_unknown(&dataset, &names).expect("a dataset");
    assert!(all.origin_error.is_some());
    for (found, truth) in all.markers.iter().zip(&dataset.markers) {
        let radius = |marker: &dataset::Marker| marker.position[0].hypot(marker.position[1]);
        let error = radius(found) - radius(truth);
        assert!(error.abs() < 1e-3, "{found:?} {truth:?}");
    }
    assert_true(&fitted(&all), "no position of a marker known");

    let error = with_unknown(&dataset, &names[1..]).expect_err("too few");
    let few = format!("found 1 of {} markers with a position", names.len());
    assert!(error.contains(&few), "{error}");
    let turned = turned(dataset, Rotation3::from_euler_angles(0.3, 0.0, 0.0));
    let error = with_unknown(&turned, &names_of(&turned)).expect_err("no direction");
    assert!(error.contains("up = \"unknown\""), "{error}");
}

fn names_of(dataset: &Dataset) -> Vec<&str> {
    let markers = dataset.markers.iter();
    markers.map(|marker| marker.name.as_str()).collect()
}

#[test]
fn unknown_positions_of_sensors_are_estimated() {
    let place = [0.02, -0.01, 0.005];
    let set = observed(true, inertial(), [0.0; 3]);
    let dataset = sensor_flights(&disc(), &PLAN, &set, 19);
    let unknown = with_unknown(&dataset, &["acc", "gyro"]).expect("a dataset");
    let report = fitted(&unknown);
    for (axis, truth) in place.into_iter().enumerate() {
        let own = &report.coefficients[&format!("accelerometer_by_{}", axis + 1)];
        let z = (own.value - truth) / own.std_error;
        assert!(z.abs() < MAX_Z && own.std_error < 0.02, "{axis} {own:?}");
    }
    assert_true(&report, "unknown place of an accelerometer");

    let tag = vec![Sensor::new("tag", SensorKind::Pose, [0.03, 0.0, 0.01])];
    let dataset = sensor_flights(&disc(), &PLAN, &observed(false, tag.clone(), [0.0; 3]), 23);
    let unknown = with_unknown(&dataset, &["tag"]).expect("a dataset");
    let report = fitted(&unknown);
    let own = &report.coefficients["offset_1"];
    let z = (own.value - 0.03) / own.std_error;
    assert!(z.abs() < MAX_Z && own.std_error < 1e-3, "{own:?}");
    assert_true(&report, "unknown place of a pose");

    let dataset = sensor_flights(&disc(), &PLAN, &observed(true, tag, [0.0; 3]), 23);
    let placed = with_unknown(&dataset, &["tag"]).expect("a dataset");
    let found = placed.sensors[0].position;
    assert!((found[0] - 0.03).abs() < 1e-3 && (found[2] - 0.01).abs() < 1e-3);
    assert!(!placed.sensors[0].position_is_unknown);
}

#[test]
fn a_tilted_template_is_estimated() {
    let set = observed(true, Vec::new(), [0.0; 3]);
    let mut dataset = sensor_flights(&disc(), &PLAN, &set, 19);
    let tilt = Vector3::new(0.003, -0.002, 0.0);
    for marker in &mut dataset.markers {
        let place = Vector3::from(marker.position);
        marker.position = (place - tilt.cross(&place)).into();
    }
    dataset.axis_error = Some(0.005);
    let report = fitted(&dataset);
    for (name, truth) in [("tilt_1", tilt.x), ("tilt_2", tilt.y)] {
        let found = &report.coefficients[name];
        let z = (found.value - truth) / found.std_error;
        assert!(
            z.abs() < MAX_Z && found.std_error < 5e-4,
            "{name} {found:?}"
        );
    }
    assert_true(&report, "tilted template");
}
