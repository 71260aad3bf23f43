//! Bodies of the program without generated code, and one of a user's own: by name in any folder they are flown, verified and
//! written as code.

use assert_cmd::Command;
use std::path::{Path, PathBuf};

fn hyzer(folder: &Path, arguments: &[&str]) -> String {
    let done = Command::cargo_bin("hyzer")
        .expect("the program")
        .current_dir(folder)
        .args(arguments)
        .output()
        .expect("it runs");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let (out, errors) = (text(&done.stdout), text(&done.stderr));
    assert!(done.status.success(), "{arguments:?}\n{out}{errors}");
    out
}

fn boomerang(file: &str) -> String {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let path = root.join("examples/boomerang").join(file);
    path.to_string_lossy().into_owned()
}

/// Names of the built-in bodies, followed by the path of a model file of a boomerang, as a user could write it.
fn bodies() -> Vec<String> {
    let named = model_spec::load::BODIES
        .iter()
        .map(|(name, _)| (*name).to_owned());
    named.chain([boomerang("boomerang.hyz")]).collect()
}

#[test]
fn bodies_are_flown_and_verified_in_any_folder() {
    let folder = tempfile::tempdir().expect("a folder");
    for body in bodies() {
        let throw = ["--speed", "14", "--launch", "12", "--until", "ground"];
        let mut simulate = vec!["simulate", body.as_str(), "--out", "flight"];
        simulate.extend(throw);
        let model = model_spec::load::load(&body, &[]).expect("a model");
        if model.body.is_some_and(|body| body.rotation.is_some()) {
            simulate.extend(["--spin", "800"]);
        }
        hyzer(folder.path(), &simulate);
        let path = folder.path().join("flight/trajectory.csv");
        let path = std::fs::read_to_string(path).expect("a trajectory");
        assert!(path.lines().count() > 50, "{body}");
        let verdict = hyzer(folder.path(), &["verify", &body, "--json"]);
        assert!(verdict.contains("\"verified\""), "{body}: {verdict}");
    }
    let release = boomerang("throw.toml");
    let text = std::fs::read_to_string(&release).expect("a release");
    let model = boomerang("boomerang.hyz");
    let text = text.replace("examples/boomerang/boomerang.hyz", &model);
    std::fs::write(folder.path().join("throw.toml"), text).expect("written");
    let told = hyzer(
        folder.path(),
        &["simulate", "--release", "throw.toml", "--out", "flight"],
    );
    assert!(told.contains("ended by ground"), "{told}");
}

#[test]
fn bodies_are_written_as_code_with_their_tables() {
    let folder = tempfile::tempdir().expect("a folder");
    for body in bodies() {
        hyzer(folder.path(), &["generate", &body, "--out", "plain"]);
        hyzer(
            folder.path(),
            &["generate", &body, "--lanes", "--out", "lanes"],
        );
    }
    let read = |path: &str| std::fs::read_to_string(folder.path().join(path)).expect(path);
    assert!(read("plain/boomerang.rs").contains("pub fn f("));
    let plain = read("plain/golf_driver.rs");
    assert!(plain.contains("const C_L_KNOTS: [f64; 33]"), "{plain}");
    assert!(plain.contains("piecewise_cubic(alpha, &C_L_KNOTS, &C_L_CUBICS)"));
    assert!(plain.contains("fn piecewise_cubic(x: f64,"));
    let lanes = read("lanes/golf_driver.rs");
    assert!(lanes.contains("alpha.piecewise_cubic(&C_L_KNOTS, &C_L_CUBICS)"));
    // Code of plain f64 is a program of its own.
    let program = folder.path().join("driver.rs");
    let main =
        "fn main() { let p = DEFAULTS; let mut k = [0.0; PREPARED.len()]; prepare(&p, &mut k);
        let mut x = INITIAL; x[3] = 20.0; let mut dx = [0.0; 12]; f(0.0, &x, &p, &k, &mut dx);
        println!(\"{}\", dx[3]); }";
    std::fs::write(&program, format!("{plain}\n{main}")).expect("written");
    let compiled = std::process::Command::new("rustc")
        .args(["--edition", "2024", "-A", "warnings", "driver.rs"])
        .current_dir(folder.path())
        .status()
        .expect("rustc");
    assert!(compiled.success());
    let run = std::process::Command::new(folder.path().join("driver")).output();
    let out = run.expect("it runs").stdout;
    let slowed: f64 = String::from_utf8_lossy(&out)
        .trim()
        .parse()
        .expect("a number");
    // Drag of the table at 0, as the model's own check has it.
    assert!((slowed + 2.0413566251122273).abs() < 1e-12, "{slowed}");
}

/// Simulates flights of a driver (golf disc) with 10 % more lift than in the model and, in one dataset, a pitching
/// moment that the model lacks. The fit must find the factor on the lift, and the diagnosis the moment.
#[test]
fn a_model_with_tables_is_fitted_and_diagnosed() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = folder.path();
    let throw = "model = \"golf_driver\"\nuntil = \"ground\"\n[throw]\nspeed = 22.0\nlaunch = 9.0\nnose = 1.0\nhyzer = 8.0\n\
                 spin = 1100\nheight = 1.5\n";
    std::fs::write(here.join("throw.toml"), throw).expect("written");
    let make = |more: &[&str], out: &str| {
        let mut arguments = vec!["synthesize", "golf_driver", "--release", "throw.toml"];
        arguments.extend(["--flights", "8", "--held-out", "2", "--duration", "1.5"]);
        arguments.extend(["--noise-sigma", "0.002", "--set", "k_L=1.1", "--seed", "3"]);
        arguments.extend(more);
        hyzer(here, &[&arguments[..], &["--out", out]].concat());
    };
    let report = |of: &str| -> serde_json::Value {
        let text = std::fs::read_to_string(here.join(of).join("report.json")).expect(of);
        serde_json::from_str(&text).expect("JSON")
    };
    make(&[], "plain");
    hyzer(
        here,
        &["fit", "plain", "--model", "golf_driver", "--out", "fit"],
    );
    for (name, truth) in [("k_L", 1.1), ("k_D", 1.0), ("k_M", 1.0), ("C_Mq", -6e-4)] {
        let found = &report("fit")["coefficients"][name];
        let [value, error] = ["value", "std_error"].map(|key| found[key].as_f64().expect(key));
        assert!(
            (value - truth).abs() < 4.0 * error,
            "{name}: {value} ± {error}"
        );
    }
    make(
        &["--with", "constant_pitching_moment", "--set", "C_M0=0.004"],
        "odd",
    );
    let diagnose = ["diagnose", "odd", "--model", "golf_driver", "--out", "why"];
    hyzer(here, &diagnose);
    let summary = report("why")["summary"].to_string();
    assert!(
        summary.contains("best fit: constant-pitching-moment"),
        "{summary}"
    );
}
