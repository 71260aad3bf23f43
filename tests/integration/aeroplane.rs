//! An aeroplane of a user's own, with its control surfaces as inputs over time: `examples/aeroplane`.

use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;

fn hyzer(arguments: &[&str]) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/aeroplane");
    let command = Command::cargo_bin("hyzer").expect("the program");
    let done = { command }.current_dir(folder).args(arguments).output();
    let done = done.expect("it runs");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let (out, errors) = (text(&done.stdout), text(&done.stderr));
    assert!(done.status.success(), "{arguments:?}\n{out}{errors}");
    out
}

#[test]
fn it_is_verified_flown_and_found_from_its_flights() {
    let verdict = hyzer(&["verify", "aeroplane.hyz", "--json"]);
    assert!(verdict.contains("\"verified\""), "{verdict}");
    let folder = tempfile::tempdir().expect("a folder");
    let [flown, made, found] = ["flown", "made", "found"].map(|name| folder.path().join(name));
    let [flown, made, found] = [&flown, &made, &found].map(|path| path.to_str().expect("text"));
    hyzer(&["simulate", "--release", "doublets.toml", "--out", flown]);
    let drawn = std::fs::read_to_string(format!("{flown}/flight.svg")).expect("a figure");
    assert!(drawn.contains("Input aileron, elevator, rudder, rad"));
    let marker = |place: &'static str| ["--marker", place];
    let markers = ["nose=1,0,0", "left=0,1.4,0", "tail=-0.8,0,0.2"].map(marker);
    let plan = "synthesize --release doublets.toml --flights 2 --rate 20 --spread 0.02 --duration 7.5 --out";
    let words: Vec<&str> = plan.split(' ').chain([made]).collect();
    hyzer(&[words, markers.concat()].concat());
    hyzer(&["fit", made, "--out", found]);
    let report = std::fs::read_to_string(format!("{found}/report.json")).expect("a report");
    let report: Value = serde_json::from_str(&report).expect("JSON");
    let model = model_spec::load::load("examples/aeroplane/aeroplane.hyz", &[]).expect("a model");
    for own in &model.coefficients {
        let number = |key: &str| report["coefficients"][&own.name][key].as_f64().expect(key);
        let error = (number("value") - own.value) / number("std_error");
        assert!(error.abs() < 4.0, "{}: {error} standard errors", own.name);
    }
    let elevator = &report["coefficients"]["C_m_3"]["std_error"];
    assert!(elevator.as_f64().expect("a number") < 0.02, "{elevator}");
}

#[test]
fn its_control_derivatives_are_those_of_the_equations() {
    let told = hyzer(&[
        "stability",
        "aeroplane.hyz",
        "--release",
        "doublets.toml",
        "--json",
    ]);
    let told: Value = serde_json::from_str(&told).expect("JSON");
    let equations = &told["linearised"];
    let place = |kind: &str, name: &str| {
        let names = equations[kind].as_array().expect("names");
        names.iter().position(|own| own == name).expect(name)
    };
    let model = model_spec::load::load("examples/aeroplane/aeroplane.hyz", &[]).expect("a model");
    let value = |name: &str| {
        let mut all = model.coefficients.iter().chain(&model.params);
        all.find(|own| own.name == name).expect(name).value
    };
    // Nose up is a turn to the right about axis 2, which points to the left: the moment of the book with another sign.
    let pressure_area = 0.5 * value("rho") * 25.0_f64.powi(2) * value("S");
    let expected = -pressure_area * value("c") * value("C_m_3") / value("J_y");
    let entry = |state: &str, input: &str| {
        let row = &equations["b"][place("states", state)];
        row[place("inputs", input)].as_f64().expect("a number")
    };
    assert!((entry("w2", "elevator") / expected - 1.0).abs() < 1e-9);
    assert_eq!([entry("w2", "rudder"), entry("x", "elevator")], [0.0; 2]);
    // A propeller pulls with the square of the throttle.
    let throttle = value("throttle");
    let pull = value("rho") * value("S_prop") * value("k_motor").powi(2) * throttle / value("m");
    let along = entry("vx", "throttle").hypot(entry("vz", "throttle"));
    assert!((along / pull - 1.0).abs() < 1e-9, "{along} {pull}");
    let rows = equations["a"].as_array().expect("rows");
    assert_eq!(
        (rows.len(), rows[0].as_array().expect("a row").len()),
        (13, 13)
    );
    let slope = rows[place("states", "x")][place("states", "vx")].as_f64();
    assert_eq!(slope, Some(1.0));
}
