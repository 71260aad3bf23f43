//! `hyzer import` as its users meet it: recordings become datasets that `hyzer fit` takes.

use std::fmt::Write;
use std::path::Path;
use std::process::Command;

use crate::support::examples::the_examples_run;
use crate::support::{hyzer, told};
use dataset::{Dataset, Flight};

const TEMPLATE: &str = "examples/disc/dataset.toml";

/// Formats an example flight as a Vicon recording in mm, with y up and labels that differ from the marker names. Before
/// the flight, the body is at rest in a hand and then accelerated.
fn vicon(flight: &dataset::Flight) -> String {
    let rate = 120.0;
    let first = flight
        .positions
        .iter()
        .position(|row| row.iter().all(Option::is_some));
    let first = first.expect("all seen");
    let row =
        |i: usize| -> Option<Vec<[f64; 3]>> { flight.positions.get(i)?.iter().copied().collect() };
    let mean = |row: &[[f64; 3]]| {
        [0, 1, 2].map(|a| row.iter().map(|p| p[a]).sum::<f64>() / row.len() as f64)
    };
    let (early, late) = (
        first,
        (first + 1..first + 20)
            .rev()
            .find(|&i| row(i).is_some())
            .expect("seen"),
    );
    let seconds = flight.times[late] - flight.times[early];
    let (a, b) = (
        mean(&row(early).expect("seen")),
        mean(&row(late).expect("seen")),
    );
    let velocity = [0, 1, 2].map(|axis| (b[axis] - a[axis]) / seconds);
    let push = 0.15;
    let mut rows: Vec<Vec<Option<[f64; 3]>>> = Vec::new();
    for i in 0..60 {
        // Time before the first sample; from rest to the velocity at a constant acceleration.
        let t = f64::from(60 - i) / rate;
        let way = if t < push {
            t - 0.5 * t * t / push
        } else {
            0.5 * push
        };
        let held = row(first).expect("seen").into_iter();
        let noise = 1e-3 * (f64::from(i) * 12.9898).sin();
        rows.push(
            held.map(|p| Some([0, 1, 2].map(|k| p[k] - velocity[k] * way + noise)))
                .collect(),
        );
    }
    rows.extend(flight.positions[first..].iter().cloned());
    let mut text = format!(
        "Trajectories\n{rate}\n,,lab:A,,,lab:B,,,lab:rim C,,\nFrame,Sub Frame,X,Y,Z,X,Y,Z,X,Y,Z\n"
    );
    text += ",,mm,mm,mm,mm,mm,mm,mm,mm,mm\n";
    for (i, row) in rows.iter().enumerate() {
        let _ = write!(text, "{i},0");
        for point in row {
            let _ = match point {
                Some([x, y, z]) => write!(text, ",{:.4},{:.4},{:.4}", 1e3 * x, 1e3 * z, -1e3 * y),
                None => write!(text, ",,,"),
            };
        }
        text.push('\n');
    }
    text
}

/// Writes a recording of each flight of the dataset `examples/disc` to a folder. Returns the command `hyzer import` for
/// these recordings, and the dataset.
fn importing(folder: &Path, recording: impl Fn(&Flight) -> String) -> (Command, Dataset) {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/disc");
    let dataset = dataset::load(&example).expect("the example");
    let mut command = hyzer();
    command.arg("import");
    for (i, flight) in dataset.flights.iter().enumerate() {
        let file = folder.join(format!("take{i}.csv"));
        std::fs::write(&file, recording(flight)).expect("written");
        command.arg(file);
    }
    (command, dataset)
}

#[test]
fn the_examples_of_the_help_run() {
    the_examples_run("import", 2, "imported");
}

#[test]
fn recordings_become_a_dataset_that_is_fitted() {
    let around = tempfile::tempdir().expect("a folder");
    let (mut command, dataset) = importing(around.path(), vicon);
    let out = around.path().join("imported");
    command
        .args(["--up", "+y", "--markers", TEMPLATE, "--out"])
        .arg(&out);
    command.args(["--label", "A=m1", "--label", "B=m2", "--label", "rim C=m3"]);
    let (status, text, errors) = told(&mut command);
    assert_eq!(status, 0, "{errors}");
    assert!(text.contains("the hand lets go"), "{text}");
    assert!(text.contains("the subject \"lab\" is left out"), "{text}");
    let decisions = std::fs::read_to_string(out.join("import.txt")).expect("the decisions");
    assert!(text.starts_with(&decisions), "{decisions}");
    let page = std::fs::read_to_string(out.join("import.html")).expect("the page");
    for text in [
        "the hand lets go",
        "not seen",
        "Height, m",
        "Speed, m/s",
        "Rate of rotation, rad/s",
        "Distance less template, mm",
        "flight08.csv",
        "m1–m2",
        "+y, by --up",
    ] {
        assert!(page.contains(text), "{text}");
    }
    let imported = dataset::load(&out).expect("a dataset");
    assert_eq!(imported.flights.len(), dataset.flights.len());
    assert_eq!(
        (&imported.model, &imported.markers),
        (&dataset.model, &dataset.markers)
    );
    // 60 samples were of the hand; a release that was not seen is at the first sample after the gap.
    let starts = imported
        .flights
        .iter()
        .map(|flight| flight.times[0] * 120.0);
    let starts: Vec<f64> = starts.collect();
    assert!(
        starts.iter().all(|start| (59.0..75.0).contains(start)),
        "{starts:?}"
    );
    let seen = starts.iter().filter(|start| (59.0..64.0).contains(*start));
    assert!(seen.count() >= 6, "{starts:?}");
    let fitted = around.path().join("fitted");
    let (status, text, errors) = told(hyzer().arg("fit").arg(&out).arg("--out").arg(&fitted));
    assert_eq!(status, 0, "{text}{errors}");
    let report = std::fs::read_to_string(fitted.join("report.json")).expect("a report");
    let report: serde_json::Value = serde_json::from_str(&report).expect("JSON");
    let truth = std::fs::read_to_string("examples/disc/truth.toml").expect("the truth");
    let truth: toml::Table = truth.parse().expect("TOML");
    let truths = truth["coefficients"].as_table().expect("coefficients");
    assert_eq!(truths.len(), 8);
    for (name, truth) in truths {
        let found = &report["coefficients"][name];
        let number = |key: &str| found[key].as_f64().expect("a number");
        let off =
            (number("value") - truth.as_float().expect("a number")).abs() / number("std_error");
        assert!(off < 5.0, "{name}: {found}, put in {truth}");
    }
}

#[test]
fn a_folder_stands_for_its_recordings() {
    let around = tempfile::tempdir().expect("a folder");
    let takes = around.path().join("takes");
    std::fs::create_dir(&takes).expect("a folder");
    let (mut by_files, _) = importing(&takes, vicon);
    std::fs::write(takes.join("notes.md"), "windy").expect("written");
    std::fs::write(takes.join(".take0.csv"), "hidden").expect("written");
    let mut by_folder = hyzer();
    by_folder.arg("import").arg(&takes);
    let labels = ["--label", "A=m1", "--label", "B=m2", "--label", "rim C=m3"];
    let read = |command: &mut Command, name: &str| {
        let out = around.path().join(name);
        command.args(["--up", "+y", "--markers", TEMPLATE]);
        let (status, _, errors) = told(command.args(labels).arg("--out").arg(&out));
        assert_eq!(status, 0, "{errors}");
        let read = |file: &str| std::fs::read_to_string(out.join(file)).expect("a file");
        ["dataset.toml", "import.txt", "flight08.csv"].map(read)
    };
    let expected = read(&mut by_files, "by_files");
    assert_eq!(read(&mut by_folder, "by_folder"), expected);

    let refused = |folder: &Path| {
        let out = around.path().join("refused");
        let (status, _, errors) = told(hyzer().arg("import").arg(folder).arg("--out").arg(&out));
        assert_eq!(status, 2, "{errors}");
        errors
    };
    let empty = around.path().join("empty");
    std::fs::create_dir(&empty).expect("a folder");
    assert!(refused(&empty).contains("found no recording in this folder"));
    let dataset = around.path().join("by_files");
    assert!(refused(&dataset).contains("found a dataset, expected recordings"));
}

#[test]
fn a_free_flight_is_not_cut() {
    let around = tempfile::tempdir().expect("a folder");
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/disc");
    let dataset = dataset::load(&example).expect("the example");
    let out = around.path().join("imported");
    let mut command = hyzer();
    command.arg("import");
    for flight in &dataset.flights {
        command.arg(example.join(&flight.file));
    }
    command.args([
        "--length",
        "m",
        "--time",
        "s",
        "--up",
        "+z",
        "--markers",
        TEMPLATE,
        "--out",
    ]);
    let (status, text, errors) = told(command.arg(&out));
    assert_eq!(status, 0, "{errors}");
    assert!(!text.contains("suddenly"), "{text}");
    let imported = dataset::load(&out).expect("a dataset");
    for (flight, whole) in imported.flights.iter().zip(&dataset.flights) {
        // Samples in which all three markers are seen.
        let seen = |row: &Vec<Option<[f64; 3]>>| row.iter().all(Option::is_some);
        let ends = [
            whole.positions.iter().position(seen),
            whole.positions.iter().rposition(seen),
        ];
        let ends = ends.map(|end| whole.times[end.expect("seen")]);
        assert_eq!(
            [flight.times[0], *flight.times.last().expect("samples")],
            ends,
            "{}",
            whole.file
        );
    }
}

#[test]
fn a_wrong_unit_of_length_is_told_by_the_template() {
    for length in ["mm", "cm", "in", "ft"] {
        let around = tempfile::tempdir().expect("a folder");
        let mut command = hyzer();
        command.args(["import", "examples/disc/flight01.csv", "--time", "s"]);
        command.args(["--up", "+z", "--length", length, "--markers", TEMPLATE]);
        let (status, _, errors) = told(command.arg("--out").arg(around.path().join("made")));
        assert_eq!(status, 2, "{length}: {errors}");
        assert!(errors.contains("--length m\n"), "{length}: {errors}");
    }
}

#[test]
fn what_is_not_known_is_asked_for_and_nothing_is_written() {
    const TAKE: &str = "examples/disc/flight01.csv";
    let cases: [(&[&str], &str); 10] = [
        (&[TAKE, "--markers", TEMPLATE], "--time"),
        (&[TAKE, "--time", "s", "--markers", TEMPLATE], "--length"),
        (
            &[TAKE, "--time", "s", "--length", "m", "--markers", TEMPLATE],
            "--up",
        ),
        (&[TAKE, "--time", "s", "--length", "m"], "--markers"),
        (
            &[
                TAKE,
                "--time",
                "s",
                "--length",
                "m",
                "--up",
                "+z",
                "--markers",
                "examples/ball/dataset.toml",
            ],
            "--label",
        ),
        (&[TAKE, "--time", "h", "--markers", TEMPLATE], "s or ms"),
        (
            &[TAKE, "--length", "yard", "--markers", TEMPLATE],
            "m, cm, mm, in or ft",
        ),
        (
            &[
                TAKE,
                "--time",
                "s",
                "--length",
                "m",
                "--up",
                "top",
                "--markers",
                TEMPLATE,
            ],
            "+z, -z",
        ),
        (&[TAKE, "--format", "trc", "--markers", TEMPLATE], "vicon"),
        (
            &["examples/README.md", "--markers", TEMPLATE],
            "a recording",
        ),
    ];
    let around = tempfile::tempdir().expect("a folder");
    for (arguments, expected) in cases {
        let out = around.path().join("made");
        let (status, text, errors) =
            told(hyzer().arg("import").args(arguments).arg("--out").arg(&out));
        assert_eq!((status, text.as_str()), (2, ""), "{arguments:?}: {errors}");
        assert!(errors.contains(expected), "{arguments:?}: {errors}");
        assert_eq!(
            std::fs::read_dir(around.path()).expect("a folder").count(),
            0
        );
    }
}

#[test]
fn the_only_point_is_the_only_marker() {
    let around = tempfile::tempdir().expect("a folder");
    let mut table = "t,X,Y,Z\n".to_owned();
    for i in 0..60 {
        let t = f64::from(i) / 120.0;
        let _ = writeln!(table, "{t},{},0,{}", 10.0 * t, 2.0 - 4.905 * t * t);
    }
    let (take, out) = (around.path().join("t.csv"), around.path().join("imported"));
    std::fs::write(&take, table).expect("written");
    let template = "examples/ball/dataset.toml";
    let mut command = hyzer();
    command.arg("import").arg(&take).arg("--out").arg(&out);
    command.args([
        "--up",
        "+z",
        "--length",
        "m",
        "--time",
        "s",
        "--markers",
        template,
    ]);
    let (status, _, errors) = told(&mut command);
    assert_eq!(status, 0, "{errors}");
    let imported = dataset::load(&out).expect("a dataset");
    let template = dataset::load("examples/ball".as_ref()).expect("a dataset");
    assert_eq!(imported.markers[0].name, template.markers[0].name);
    assert_eq!(imported.flights[0].times.len(), 60);
}

#[test]
fn a_pose_is_written_as_a_sensor() {
    let around = tempfile::tempdir().expect("a folder");
    let mut table = "t_s,disc_x_m,disc_y_m,disc_z_m,disc_qw,disc_qx,disc_qy,disc_qz\n".to_owned();
    for i in 0..60 {
        let t = f64::from(i) / 120.0;
        let (w, z) = ((10.0 * t).cos(), (10.0 * t).sin());
        let _ = writeln!(
            table,
            "{t},{},0,{},{w},0,0,{z}",
            10.0 * t,
            2.0 - 4.905 * t * t
        );
    }
    let take = around.path().join("pose.csv");
    std::fs::write(&take, table).expect("written");
    let out = around.path().join("imported");
    let mut command = hyzer();
    command
        .arg("import")
        .arg(&take)
        .args(["--up", "+z", "--markers", TEMPLATE, "--out"])
        .arg(&out);
    let (status, text, errors) = told(&mut command);
    assert_eq!(status, 0, "{errors}");
    assert!(text.contains("the poses are written as"), "{text}");
    let imported = dataset::load(&out).expect("a dataset");
    assert!(imported.markers.is_empty(), "{imported:?}");
    let sensor = &imported.sensors[0];
    assert_eq!((sensor.name.as_str(), sensor.kind.name()), ("disc", "pose"));
    let flight = &imported.flights[0];
    assert_eq!(flight.times.len(), 60);
    let t = flight.times[19];
    let [place, turn] = [0, 1].map(|channel| flight.readings[19][channel].expect("seen"));
    assert!((place[0] - 10.0 * t).abs() < 1e-9, "{place:?}");
    assert!((turn[3] - (10.0 * t).sin()).abs() < 1e-9, "{turn:?}");
}

/// Adds a point that does not move, with coordinates in every sample, to the text of a Vicon recording.
fn with_wand(text: &str) -> String {
    let lines = text.lines().enumerate().map(|(i, line)| {
        line.to_owned()
            + match i {
                0 | 1 => "",
                2 => ",lab:wand,,",
                3 => ",X,Y,Z",
                4 => ",mm,mm,mm",
                _ => ",5000.0,100.0,0.0",
            }
            + "\n"
    });
    lines.collect()
}

#[test]
fn without_a_template_the_positions_of_the_markers_are_estimated() {
    let around = tempfile::tempdir().expect("a folder");
    let (mut command, dataset) = importing(around.path(), |flight| with_wand(&vicon(flight)));
    let out = around.path().join("imported");
    command.args(["--up", "+y", "--model", "disc", "--label", "A=m1", "--out"]);
    let (status, text, errors) = told(command.arg(&out));
    assert_eq!(status, 0, "{errors}");
    assert!(
        text.contains("they do not keep their distances to the others in every take: wand"),
        "{text}"
    );
    assert!(text.contains("third axis: the axis of the spin"), "{text}");
    assert!(text.contains("centre of mass: "), "{text}");
    let manifest = std::fs::read_to_string(out.join("dataset.toml")).expect("a manifest");
    let comments =
        manifest.matches("# estimated from the takes; standard errors of the position, m: ");
    assert_eq!(comments.count(), 3, "{manifest}");
    let imported = dataset::load(&out).expect("a dataset");
    let names: Vec<&str> = imported.markers.iter().map(|m| m.name.as_str()).collect();
    assert_eq!(names, ["m1", "B", "rim_C"]);
    // The first marker of the example is on the first axis, as the estimate chooses.
    let mean = |markers: &[dataset::Marker]| {
        markers.iter().map(|m| m.position[2]).sum::<f64>() / markers.len() as f64
    };
    let (height, truth) = (mean(&imported.markers), mean(&dataset.markers));
    for (found, truth_marker) in imported.markers.iter().zip(&dataset.markers) {
        let [x, y, z] = [0, 1, 2].map(|axis| found.position[axis] - truth_marker.position[axis]);
        let along = z - (height - truth);
        assert!(
            x.hypot(y) < 1e-3 && along.abs() < 1e-3,
            "{found:?}, put in {truth_marker:?}"
        );
    }
    for command in ["fit", "diagnose"] {
        let results = around.path().join(command);
        let (status, text, errors) =
            told(hyzer().arg(command).arg(&out).arg("--out").arg(&results));
        assert_eq!(status, 0, "{text}{errors}");
        let report = std::fs::read_to_string(results.join("report.json")).expect("a report");
        assert!(report.contains("\"offset_3\""), "{report}");
    }
    let fitted = std::fs::read_to_string(around.path().join("fit/fitted.hyz")).expect("a model");
    assert!(!fitted.contains("offset_3"), "{fitted}");
}

#[test]
fn a_template_that_cannot_be_estimated_is_asked_for() {
    let around = tempfile::tempdir().expect("a folder");
    let out = around.path().join("imported");
    let ball = [
        "examples/ball/flight01.csv",
        "--length",
        "m",
        "--time",
        "s",
        "--up",
        "+z",
    ];
    let mut command = hyzer();
    command
        .arg("import")
        .args(ball)
        .args(["--model", "disc", "--out"]);
    let (status, _, errors) = told(command.arg(&out));
    assert_eq!(status, 2, "{errors}");
    assert!(errors.contains("expected at least 3 points"), "{errors}");
    // The one point of a point mass is its centre; a recording that cannot be read is left out of several.
    let broken = around.path().join("broken.csv");
    std::fs::write(&broken, "t,a_x,a_y,a_z\n0,1,2\n").expect("written");
    let mut command = hyzer();
    command.arg("import").arg(&broken).args(ball);
    let point = around.path().join("point");
    let (status, _, errors) = told(command.args(["--model", "ball", "--out"]).arg(&point));
    assert_eq!(status, 0, "{errors}");
    assert!(
        errors.contains("left out: ") && errors.contains("broken.csv"),
        "{errors}"
    );
    let made = dataset::load(&point).expect("a dataset");
    assert_eq!(made.markers[0].position, [0.0; 3]);
    assert!(!made.flights.is_empty());
    let mut command = hyzer();
    command
        .arg("import")
        .args(ball)
        .args(["--model", "ball", "--centre-height", "12", "--out"]);
    let (status, _, errors) = told(command.arg(&out));
    assert_eq!(status, 2, "{errors}");
    assert!(errors.contains("millimetres?"), "{errors}");
}
