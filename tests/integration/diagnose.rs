//! `hyzer diagnose` as its users run it.

use std::path::Path;

use crate::support::examples::the_examples_run;
use crate::support::{hyzer, loads_nothing, told};

fn report(out: &Path) -> serde_json::Value {
    let text = std::fs::read(out.join("report.json")).expect("a report");
    serde_json::from_slice(&text).expect("JSON")
}

#[test]
fn the_readme_s_command_names_what_was_hidden_and_measures_the_gain() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("found");
    let arguments = ["diagnose", "examples/mystery", "--out"];
    let (status, text, errors) = told(hyzer().args(arguments).arg(&out));
    assert_eq!(status, 0, "{errors}");
    assert!(text.starts_with("identified: "), "{text}");
    let report = report(&out);
    assert_eq!(report["schema"], "hyzer.diagnosis/2");
    assert_eq!(report["verdict"], "identified");
    let effect = &report["explanations"][0]["effects"][0];
    assert_eq!(
        (&effect["name"], &effect["site"]),
        (&"stall".into(), &"lift".into())
    );
    let found = &effect["estimates"]["C_Ls"];
    let number = |value: &serde_json::Value| value.as_f64().expect("a number");
    let (value, error) = (number(&found["value"]), number(&found["std_error"]));
    // What examples/mystery/truth.toml says.
    assert!((value - 4.0).abs() < 4.0 * error, "{value} ± {error}");
    let gain = &report["predictive_gain"];
    let [before, after] = ["rms_before_m", "rms_after_m"].map(|key| number(&gain[key]));
    assert!(after < 0.5 * before && after > 0.0, "{gain}");
    for key in [
        "noise",
        "coefficients",
        "not_identifiable",
        "minimum_detectable_effects",
        "seconds",
    ] {
        assert!(!report[key].is_null(), "{key}");
    }
    assert_eq!(report["verified"]["holds"], true);

    // What was written can be checked, verified and fitted like any other model.
    let extended = out.join(report["extended_model"].as_str().expect("a file"));
    let model = model_spec::load::load(extended.to_str().expect("a path"), &[]).expect("a model");
    for coefficient in &model.coefficients {
        let found = number(&report["coefficients"][&coefficient.name]["value"]);
        assert!(
            (coefficient.value - found).abs() <= 1e-15 * found.abs(),
            "{}: {} in the file, {found} in the report",
            coefficient.name,
            coefficient.value
        );
    }
    for command in ["check", "verify"] {
        let (status, text, errors) = told(hyzer().arg(command).arg(&extended));
        assert_eq!(status, 0, "{command}: {text}{errors}");
    }
    let (status, text, errors) = told(
        hyzer()
            .args(["fit", "examples/mystery", "--model"])
            .arg(&extended),
    );
    assert!(status == 0 && text.contains("C_Ls"), "{text}{errors}");
    for file in [
        "report.html",
        "candidates.csv",
        "coefficients.csv",
        "flights.csv",
        "extended/disc.rs",
    ] {
        assert!(out.join(file).is_file(), "{file}");
    }
    let page = std::fs::read_to_string(out.join("report.html")).expect("a page");
    loads_nothing(&page);
}

#[test]
fn an_extended_model_is_fitted_to_flights_whose_template_is_estimated() {
    let folder = tempfile::tempdir().expect("a folder");
    let (data, out) = (folder.path().join("data"), folder.path().join("found"));
    std::fs::create_dir(&data).expect("a folder");
    for entry in std::fs::read_dir("examples/mystery").expect("the example") {
        let file = entry.expect("a file").path();
        std::fs::copy(&file, data.join(file.file_name().expect("a name"))).expect("a copy");
    }
    let manifest = std::fs::read_to_string(data.join("dataset.toml")).expect("a dataset");
    let errors = "[template]\norigin_error = [0.0003, 0.0002, 0.004]\naxis_error = 0.004\n\n";
    let manifest = manifest.replacen("[parameters]", &format!("{errors}[parameters]"), 1);
    std::fs::write(data.join("dataset.toml"), manifest).expect("written");
    let (status, _, errors) = told(hyzer().arg("diagnose").arg(&data).arg("--out").arg(&out));
    assert_eq!(status, 0, "{errors}");
    let extended = out.join("extended.hyz");
    let text = std::fs::read_to_string(&extended).expect("a model");
    assert!(text.contains("coefficient offset_3"), "{text}");
    let (status, text, errors) = told(hyzer().arg("fit").arg(&data).arg("--model").arg(&extended));
    assert!(status == 0 && text.contains("offset_3"), "{text}{errors}");
}

#[test]
fn where_nothing_is_hidden_nothing_is_found() {
    let folder = tempfile::tempdir().expect("a folder");
    for example in ["examples/disc", "examples/ball"] {
        let out = folder.path().join(example);
        let (status, text, errors) = told(hyzer().args(["diagnose", example, "--out"]).arg(&out));
        assert_eq!(status, 0, "{errors}");
        let report = report(&out);
        assert_eq!(report["verdict"], "adequate", "{text}");
        assert_eq!(report["explanations"], serde_json::json!([]));
        assert!(report["extended_model"].is_null() && !out.join("extended.hyz").exists());
    }
}

#[test]
fn the_result_does_not_depend_on_the_number_of_threads() {
    let folder = tempfile::tempdir().expect("a folder");
    let reports = ["1", "3"].map(|threads| {
        let out = folder.path().join(threads);
        let arguments = [
            "diagnose",
            "examples/mystery",
            "--threads",
            threads,
            "--out",
        ];
        let (status, _, errors) = told(hyzer().args(arguments).arg(&out));
        assert_eq!(status, 0, "{errors}");
        let mut report = report(&out);
        report["seconds"] = serde_json::Value::Null;
        report
    });
    assert_eq!(reports[0], reports[1]);
}

#[test]
fn the_examples_of_the_help_run() {
    the_examples_run("diagnose", 2, "found");
}

#[test]
fn what_is_asked_wrongly_is_refused() {
    for (arguments, expected) in [
        (vec!["diagnose", "examples/nothing"], "no such folder"),
        (
            vec!["diagnose", "examples/disc", "--without", "stal"],
            "stall",
        ),
        (vec!["diagnose", "examples/disc", "--hold", "C_X"], "C_X"),
        (
            vec!["diagnose", "examples/disc", "--model", "ball"],
            "radius",
        ),
    ] {
        let (status, text, errors) = told(hyzer().args(&arguments));
        assert_eq!(status, 2, "{arguments:?}: {text}{errors}");
        assert!(errors.contains(expected), "{arguments:?}: {errors}");
    }
}
