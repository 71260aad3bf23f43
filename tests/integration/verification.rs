//! Verifications by the program: written as JSON, and repeated.

use std::fs;
use std::path::Path;

use crate::support::{hyzer, told};

const KITE: &str = "model kite; param g0 = 9.81 m/s^2; param k = 0.3 1/s; frame N;
state z = 1 m; state v = 0 m/s; der(z) = v; der(v) = -g0 - k*v;";

fn verify(arguments: &[&str]) -> (i32, String, String) {
    told(hyzer().arg("verify").args(arguments))
}

/// Path of the file `name` in a folder, as a command-line argument.
fn at(folder: &Path, name: &str) -> String {
    folder.join(name).display().to_string()
}

/// Verifies models with `arguments`, and writes the JSON to `file`; returns the exit status and the JSON.
fn write(arguments: &[&str], file: &str) -> (i32, serde_json::Value) {
    let (status, json, said) = verify(&[arguments, &["--cases", "10", "--json"]].concat());
    fs::write(file, &json).expect("a file");
    let value = serde_json::from_str(&json).unwrap_or_else(|error| panic!("{error}: {said}"));
    (status, value)
}

#[test]
fn a_verification_agrees_with_itself_and_not_with_another_text() {
    let folder = tempfile::tempdir().expect("a folder");
    let [model, file] = ["kite.hyz", "kite.json"].map(|name| at(folder.path(), name));
    fs::write(&model, KITE).expect("a model");
    // Stated equations without a law: not verified, and the JSON says so.
    let (status, json) = write(&[&model], &file);
    assert_eq!(status, 3);
    assert_eq!(json["schema"], "hyzer.verification/1");
    assert_eq!(json["outcome"], "not-verified");
    assert_eq!((&json["cases"], &json["seed"]), (&10.into(), &1.into()));
    assert_eq!(json["models"][0]["source"], model.as_str());
    let (status, said, _) = verify(&["--check", &file]);
    assert_eq!(status, 0, "{said}");
    fs::write(&model, KITE.replace("- k*v", "- k*v*cos(q)")).expect("a model");
    let (status, said, _) = verify(&["--check", &file]);
    assert_eq!(
        (status, said.as_str()),
        (1, "kite: the model can no longer be loaded\n")
    );
    let moved = KITE.replace(
        "- k*v;",
        "- 2*k*v; check \"fall\" { set v = 1 m/s; expect der(z) = 2 m/s within 1e-12; }",
    );
    fs::write(&model, &moved).expect("a model");
    let (status, said, error) = verify(&["--check", &file, "--json"]);
    assert_eq!(status, 1, "{said}{error}");
    let json: serde_json::Value = serde_json::from_str(&said).expect("JSON");
    let differences = json["differences"].as_array().expect("a list");
    for difference in [
        "kite: hash of the model's text changed",
        "kite: hash of the generated code changed",
        "kite: check check cases of the model: was skipped, is refuted",
    ] {
        assert!(differences.contains(&difference.into()), "{said}");
    }
}

#[test]
fn several_models_are_recorded_with_their_verdicts() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = at(folder.path(), "both.json");
    assert_eq!(write(&["ball", "disc_appendix_printed"], &file).0, 1);
    assert_eq!(verify(&["--check", &file]).0, 0);
    let text = fs::read_to_string(&file).expect("a record");
    let refuted = "\"verdict\": \"refuted\"";
    fs::write(&file, text.replacen(refuted, "\"verdict\": \"holds\"", 1)).expect("a record");
    let (status, said, _) = verify(&["--check", &file]);
    assert_eq!(status, 1, "{said}");
    assert!(said.starts_with("disc_appendix_printed: check "), "{said}");
    assert!(said.ends_with(": was holds, is refuted\n"), "{said}");
    assert_eq!(
        write(&["disc", "disc_quaternion", "--with", "wind"], &file).0,
        0
    );
    let (status, said, _) = verify(&["--check", &file]);
    assert_eq!(status, 0, "{said}");
}

#[test]
fn what_is_no_verification_is_bad_input() {
    let folder = tempfile::tempdir().expect("a folder");
    let bad = at(folder.path(), "bad.json");
    fs::write(&bad, "{\n  \"schema\": 1\n}").expect("a file");
    let (status, _, said) = verify(&["--check", &bad]);
    assert_eq!(status, 2, "{said}");
    assert!(
        said.contains("bad.json") && said.contains("expected \"hyzer.verification/1\""),
        "{said}"
    );
    fs::write(&bad, [0xff; 8]).expect("a file");
    assert_eq!(verify(&["--check", &bad]).0, 2);
    assert_eq!(write(&["ball"], &bad).0, 0);
    let text = fs::read_to_string(&bad).expect("a record");
    fs::write(&bad, text.replace("\"cases\": 10,", "\"cases\": 0,")).expect("a file");
    let (status, _, said) = verify(&["--check", &bad]);
    assert_eq!(status, 2, "{said}");
    let (status, _, said) = verify(&["--check", &at(folder.path(), "absent.json")]);
    assert_eq!(status, 2, "{said}");
    assert_eq!(verify(&["disc", "--check", &bad]).0, 2);
}

#[test]
fn the_examples_of_the_help_run_one_after_the_other() {
    let folder = tempfile::tempdir().expect("a folder");
    let help = verify(&["--help"]).1;
    let lines = help.lines().filter_map(|line| {
        let words = line.trim().strip_prefix("hyzer verify ")?;
        Some(words.split(" #").next().unwrap_or(words).to_owned())
    });
    let examples: Vec<String> = lines.collect();
    assert!(examples.iter().any(|e| e.contains("--check")), "{help}");
    for example in examples {
        let (words, file) = example.split_once('>').unwrap_or((&example, ""));
        let mut command = hyzer();
        command.current_dir(folder.path()).arg("verify");
        let (status, written, said) = told(command.args(words.split_whitespace()));
        assert_eq!(status, 0, "{example}: {said}");
        if !file.is_empty() {
            fs::write(folder.path().join(file.trim()), written).expect("a file");
        }
    }
}

#[test]
fn moments_of_inertia_that_no_body_has_are_refused_wherever_they_are_stated() {
    let folder = tempfile::tempdir().expect("a folder");
    let [model, release] = ["brick.hyz", "release.toml"].map(|name| at(folder.path(), name));
    let text = |product: &str, third: &str| {
        format!(
            "model brick; param m = 1 kg; param a = 0.02 kg*m^2; param b = 0.03 kg*m^2; param c = {third} kg*m^2;
param I_13 = {product} kg*m^2; param g = 9.81 m/s^2; frame N;
frame B = N by quaternion (q0, q1, q2, q3);
body brick {{ mass m; inertia ((a, 0, I_13), (0, b, 0), (I_13, 0, c)) in B; fixed in B;
position (x, y, z) in N; velocity (vx, vy, vz) in N; angular velocity (p, q, r) in B; }}
force weight = -m*g*N.3;"
        )
    };
    let wrong = [
        ("0.1", "0.04", "is not positive definite"),
        ("0", "0.06", "is that of no body"),
    ];
    for (product, third, expected) in wrong {
        fs::write(&model, text(product, third)).expect("a model");
        let (status, _, said) = verify(&[&model, "--cases", "10"]);
        let (checked, _, printed) = told(hyzer().arg("check").arg(&model));
        assert_eq!((status, checked), (1, 1), "{said}");
        for told in [said, printed] {
            assert!(
                told.contains(expected) && told.contains("brick.hyz:4"),
                "{told}"
            );
        }
    }
    fs::write(&model, text("0", "0.04")).expect("a model");
    let flown = |third: &str, sets: &[&str]| {
        let text = format!(
            "model = \"brick.hyz\"\nduration = 0.1\n[parameters]\nc = {third}\n[initial]\nx = 0.0\ny = 0.0\nz = 1.0\n\
             vx = 0.0\nvy = 0.0\nvz = 0.0\nq0 = 1.0\nq1 = 0.0\nq2 = 0.0\nq3 = 0.0\np = 1.0\nq = 2.0\nr = 3.0\n"
        );
        fs::write(&release, text).expect("a release");
        let (status, _, said) = told(hyzer().args(["simulate", "--release", &release]).args(sets));
        (status, said)
    };
    assert_eq!(flown("0.05", &[]).0, 0);
    for ((status, said), place) in [
        (flown("0.06", &[]), "release.toml:3:"),
        (flown("0.04", &["--set", "c=0.06"]), "--set: "),
    ] {
        assert_eq!(status, 2, "{said}");
        assert!(
            said.contains(place) && said.contains("is that of no body"),
            "{said}"
        );
    }
    let measured = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/disc");
    for file in fs::read_dir(measured).expect("a dataset") {
        let file = file.expect("a file").path();
        let name = file.file_name().expect("a name").to_owned();
        fs::copy(&file, folder.path().join(name)).expect("a copy");
    }
    let dataset = folder.path().join("dataset.toml");
    let text = fs::read_to_string(&dataset).expect("a dataset");
    fs::write(&dataset, text.replace("I_a = 0.002352", "I_a = 0.0026")).expect("a dataset");
    let (status, _, said) = told(hyzer().arg("fit").arg(folder.path()));
    assert_eq!(status, 2, "{said}");
    assert!(
        said.contains("[parameters] of the dataset the inertia tensor is that of no body"),
        "{said}"
    );
}
