//! `hyzer design` and `hyzer stability` as their users run them.

use std::path::Path;

use crate::support::examples::the_examples_run;
use crate::support::{hyzer, told};
use serde_json::Value;

#[test]
fn the_examples_of_their_help_run() {
    the_examples_run("design", 4, "designed");
    the_examples_run("stability", 3, "modes");
}

#[test]
fn the_coefficients_of_a_fit_are_flown_unless_others_are_set() {
    let folder = tempfile::tempdir().expect("a folder");
    let report = folder.path().join("report.json");
    let text = r#"{ "coefficients": {
        "C_D0": { "value": 0.3, "std_error": 0.002, "at_bound": false },
        "C_Da": { "value": 2.0, "std_error": null, "at_bound": true }
    }, "correlations": {}, "reliable": true }"#;
    std::fs::write(&report, text).expect("a report");
    let miss = |more: &[&str]| {
        let arguments = "design --goal range --starts 8 --samples 20 --seed 1";
        let mut command = hyzer();
        command.args(arguments.split(' ')).args(more);
        let (status, text, errors) = told(&mut command);
        assert_eq!(status, 0, "{text}{errors}");
        text.lines().next().expect("a line").to_owned()
    };
    let fit = report.to_str().expect("a path");
    let by_fit = miss(&["--fit", fit]);
    assert_eq!(by_fit, miss(&["--set", "C_D0=0.3", "--set", "C_Da=2"]));
    assert_ne!(by_fit, miss(&[]));
    let by_both = miss(&["--fit", fit, "--set", "C_D0=0.2"]);
    assert_eq!(by_both, miss(&["--set", "C_D0=0.2", "--set", "C_Da=2"]));
}

fn json(file: &Path) -> Value {
    let text = std::fs::read_to_string(file).expect("a file");
    serde_json::from_str(&text).expect("JSON")
}

#[test]
fn simulate_flies_the_release_of_a_design_to_its_target() {
    // A model that is not built in, with a parameter of the command line.
    let folder = tempfile::tempdir().expect("a folder");
    let (out, flown) = (folder.path().join("designed"), folder.path().join("flown"));
    let model = "crates/analysis/tests/integration/support/plate.hyz";
    let arguments = [
        "design",
        "--goal",
        "hit",
        "--target",
        "24,3,0",
        "--model",
        model,
        "--set",
        "m=0.16",
        "--wind=1,2,0",
        "--samples",
        "50",
    ];
    let (status, text, errors) = told(hyzer().args(arguments).arg("--out").arg(&out));
    assert_eq!(status, 0, "{text}{errors}");
    let design = json(&out.join("design.json"));
    assert_eq!(
        (&design["schema"], &design["goal"], &design["feasible"]),
        (&"hyzer.design/1".into(), &"hit".into(), &true.into())
    );
    assert!(design["miss_m"].as_f64().expect("a number") < 1e-3);
    assert!(
        design["sensitivity"]["speed"]["landing_m_per_unit"][0]
            .as_f64()
            .expect("a number")
            .abs()
            > 0.01
    );
    for file in ["report.html", "path.svg", "landings.svg", "flight.html"] {
        assert!(out.join(file).is_file(), "{file}");
    }
    let release = out.join("release.toml");
    let mut command = hyzer();
    let (status, _, errors) = told(
        command
            .args(["simulate", "--release"])
            .arg(release)
            .arg("--out")
            .arg(&flown),
    );
    assert_eq!(status, 0, "{errors}");
    let landing = json(&flown.join("summary.json"));
    let at = |k: usize| landing["landing_m"][k].as_f64().expect("a number");
    assert!(
        (at(0) - 24.0).abs() < 1e-3 && (at(1) - 3.0).abs() < 1e-3,
        "{landing}"
    );
}

#[test]
fn what_is_impossible_ends_with_status_1_and_the_nearest() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("designed");
    let arguments = [
        "design",
        "--goal",
        "hit",
        "--model",
        "ball",
        "--target",
        "100,0,0",
        "--samples",
        "0",
    ];
    let (status, text, _) = told(hyzer().args(arguments).arg("--out").arg(&out));
    assert_eq!(status, 1, "{text}");
    assert!(text.contains("not possible within these bounds"), "{text}");
    let design = json(&out.join("design.json"));
    assert_eq!(design["feasible"], false);
    let reach = design["landing"][0].as_f64().expect("a number");
    assert!(
        (design["miss_m"].as_f64().expect("a number") - (100.0 - reach)).abs() < 0.01,
        "{design}"
    );
}

#[test]
fn bad_input_is_refused_before_anything_is_written() {
    for (arguments, words) in [
        (
            vec!["design", "--goal", "hit"],
            "no --target: the goal hit needs one",
        ),
        (
            vec!["design", "--goal", "hit", "--target", "1,2"],
            "--target: found \"1,2\", expected three numbers",
        ),
        (
            vec!["design", "--goal", "hit", "--target", "1,2,-3"],
            "3 m below the ground",
        ),
        (
            vec!["design", "--goal", "range", "--target", "1,2,3"],
            "the goal range has no target",
        ),
        (
            vec!["design", "--goal", "curve", "--target", "30,0,0"],
            "needs an obstacle",
        ),
        (
            vec!["design", "--goal", "flare", "--target", "30,0,0"],
            "above the ground",
        ),
        (
            vec![
                "design",
                "--goal",
                "range",
                "--bounds",
                "examples/absent.toml",
            ],
            "found no such file",
        ),
        (
            vec!["design", "--goal", "range", "--fit", "Cargo.toml"],
            "--fit: Cargo.toml",
        ),
        (vec!["stability", "ball"], "has no body that turns"),
        (vec!["stability", "disc", "--speed", "-3"], "--speed"),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        let out = folder.path().join("out");
        let (status, _, errors) = told(hyzer().args(&arguments).arg("--out").arg(&out));
        assert_eq!(status, 2, "{arguments:?}: {errors}");
        assert!(errors.contains(words), "{arguments:?}: {errors}");
        assert!(
            !out.exists() || std::fs::read_dir(&out).expect("a folder").next().is_none(),
            "{arguments:?}"
        );
    }
}

#[test]
fn stability_says_which_body_has_no_axis_of_symmetry() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("modes");
    let boomerang = "examples/boomerang/boomerang.hyz";
    let (status, text, errors) = told(
        hyzer()
            .args(["stability", boomerang, "--speed", "20", "--spin", "600"])
            .arg("--out")
            .arg(&out),
    );
    assert_eq!(status, 0, "{errors}");
    assert!(
        text.contains("depends on the turn about the body's axis"),
        "{text}"
    );
    let (_, text, _) = told(hyzer().args(["stability", "disc", "--json"]));
    let disc: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(disc["schema"], "hyzer.stability/1");
    assert_eq!(disc["release"]["symmetric"], true);
    assert_eq!(disc["release"]["modes"][0]["kind"], "nutation");
    assert_eq!(
        json(&out.join("stability.json"))["release"]["symmetric"],
        false
    );
}
