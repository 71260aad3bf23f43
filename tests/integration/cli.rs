//! The program as its users meet it: commands, exit statuses, files.

use crate::support::examples;
use std::path::{Path, PathBuf};

use assert_cmd::Command;

pub fn hyzer() -> Command {
    Command::cargo_bin("hyzer").expect("the program is built with its tests")
}

pub fn stdout(command: &mut Command, code: i32) -> String {
    let output = command.assert().code(code).get_output().clone();
    String::from_utf8(output.stdout).expect("text")
}

pub fn stderr(command: &mut Command, code: i32) -> String {
    let output = command.assert().code(code).get_output().clone();
    String::from_utf8(output.stderr).expect("text")
}

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Folder `name` of measured data, in a folder beside the repository. `None`, with a message on standard error, if it
/// is missing.
fn shared_data(name: &str) -> Option<PathBuf> {
    let folder = repository().join("../shared/data").join(name);
    if folder.is_dir() {
        return Some(folder);
    }
    eprintln!("skipped: no measured data {name} beside the checkout");
    None
}

/// Text of the model `disc` with an additional side force along the body axis d2, as a user could write it.
fn disc_with_side_force() -> String {
    let disc =
        std::fs::read_to_string(repository().join("model-spec/models/disc.hyz")).expect("the disc");
    let changed = disc
        .replace(
            "coefficient C_Nr",
            "coefficient C_Yr = 0.002 s;\ncoefficient C_Nr",
        )
        .replace(
            "force aero =",
            "let side = q*A*C_Yr*r;\nforce sideways = side*d2;\nforce aero =",
        );
    assert_ne!(changed, disc);
    changed
}

#[test]
fn check_runs_the_cases_of_a_model() {
    let text = std::fs::read_to_string(repository().join("model-spec/models/ball.hyz"));
    let text = text.expect("the ball");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("ball.hyz");
    std::fs::write(&path, &text).expect("a file");
    let passed = stdout(hyzer().arg("check").arg(&path), 0);
    assert!(passed.contains("pass  falls freely"), "{passed}");
    std::fs::write(
        &path,
        text.replace("-9.81 m/s^2 within", "-9.8 m/s^2 within"),
    )
    .expect("a file");
    let failed = stdout(hyzer().arg("check").arg(&path), 1);
    assert!(
        failed.contains("der(vz) = -9.81 m/s^2, expected -9.8 m/s^2 within 1e-12 m/s^2  ← fails"),
        "{failed}"
    );
}

#[test]
fn a_table_of_too_many_rows_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut command = hyzer();
    command.args([
        "simulate",
        "--release",
        "backhand",
        "--until",
        "100",
        "--rate",
        "1e5",
    ]);
    let told = stderr(command.arg("--out").arg(folder.path()), 2);
    assert!(
        told.contains("1000000 rows") || told.contains("10000000 rows"),
        "{told}"
    );
    assert!(told.contains("a --rate of at most 10000"), "{told}");
}

#[test]
fn the_printed_appendix_is_refused_for_four_units_and_no_more() {
    let told = stderr(hyzer().args(["check", "disc_appendix_printed"]), 1);
    assert_eq!(told.matches("[unit] Error").count(), 4, "{told}");
    for equation in ["der(u) =", "der(v) =", "der(w) =", "der(phidot) ="] {
        assert!(told.contains(equation), "{equation} in {told}");
    }
    assert!(!told.contains("der(gammadot) ="), "{told}");
}

#[test]
fn the_printed_appendix_is_refuted_where_its_units_pass() {
    let told = stdout(
        hyzer().args(["verify", "disc_appendix_printed", "--cases", "40"]),
        1,
    );
    let spin = told
        .split("der(gammadot): ")
        .nth(1)
        .expect("a verdict on gammadot");
    assert!(
        spin.contains("carries a factor `cos(theta)` too many"),
        "{spin}"
    );
}

#[test]
fn every_model_is_verified_and_the_disc_is_one_motion_three_times() {
    let told = stdout(hyzer().args(["verify", "--json", "--cases", "40"]), 0);
    let value: serde_json::Value = serde_json::from_str(&told).expect("JSON");
    assert_eq!(value["holds"], true);
    assert_eq!(value["models"].as_array().map(Vec::len), Some(5));
    assert_eq!(
        value["same_motion"]["pairs"].as_array().map(Vec::len),
        Some(3),
        "{}",
        value["same_motion"]
    );
}

#[test]
fn every_mutant_of_the_disc_is_killed() {
    let told = stdout(hyzer().args(["verify", "disc", "--mutants", "--json"]), 0);
    let value: serde_json::Value = serde_json::from_str(&told).expect("JSON");
    let row = value["models"][0]["rows"]
        .as_array()
        .and_then(|rows| rows.iter().find(|row| row["check"] == "mutants"));
    let cases = row
        .and_then(|row| row["cases"].as_u64())
        .expect("a row of mutants");
    assert!(cases >= 200, "{cases} mutants");
}

#[test]
fn the_committed_code_is_what_the_models_say_and_a_changed_model_is_found_out() {
    hyzer()
        .args(["generate", "--check"])
        .current_dir(repository())
        .assert()
        .success();

    let folder = tempfile::tempdir().expect("a folder");
    for part in ["model-spec/models", "crates/generated/src"] {
        copy(&repository().join(part), &folder.path().join(part));
    }
    let model = folder.path().join("model-spec/models/disc.hyz");
    std::fs::write(&model, disc_with_side_force()).expect("written");
    let told = stdout(
        hyzer()
            .args(["generate", "--check"])
            .current_dir(folder.path()),
        1,
    );
    for new in ["let C_Yr = parameters", "d_v_dot_d_C_Yr", "\"side\""] {
        let added = |line: &str| line.starts_with('+') && line.contains(new);
        assert!(told.lines().any(added), "{new} in\n{told}");
    }

    hyzer()
        .arg("generate")
        .current_dir(folder.path())
        .assert()
        .success();
    hyzer()
        .args(["generate", "--check"])
        .current_dir(folder.path())
        .assert()
        .success();
    // What the reference lets through and what was not compared is said.
    let told = stdout(
        hyzer()
            .args(["verify", "model-spec/models/disc.hyz"])
            .current_dir(folder.path()),
        0,
    );
    for remark in ["NOT IN THE LAW: `C_Yr`", "STALE: the code of `disc`"] {
        assert!(told.contains(remark), "{remark} in\n{told}");
    }
}

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).expect("a folder");
    for entry in std::fs::read_dir(from).expect("a folder") {
        let entry = entry.expect("an entry");
        let target = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy(&entry.path(), &target);
        } else {
            std::fs::copy(entry.path(), target).expect("copied");
        }
    }
}

#[test]
fn a_changed_model_flies_at_once_and_differently() {
    let folder = tempfile::tempdir().expect("a folder");
    let model = folder.path().join("mine.hyz");
    std::fs::write(&model, disc_with_side_force()).expect("written");
    let fly = |model: &str| {
        let out = folder.path().join("out");
        let args = [
            "simulate",
            model,
            "--release",
            "backhand",
            "--until",
            "1",
            "--out",
        ];
        let told = stdout(hyzer().args(args).arg(&out), 0);
        (
            told,
            std::fs::read_to_string(out.join("trajectory.csv")).expect("a table"),
        )
    };
    let (plain, table) = fly("disc");
    let (changed, other) = fly(model.to_str().expect("a path"));
    assert!(plain.contains("generated code") && changed.contains("the tape"));
    assert_eq!(
        table.lines().next(),
        Some("t,x,y,z,u,v,w,phi,theta,gamma,phidot,thetadot,gammadot")
    );
    assert_eq!(table.lines().count(), 1 + 121);
    assert_ne!(table, other);
    let svg = std::fs::read_to_string(folder.path().join("out/flight.svg")).expect("a picture");
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
}

#[test]
fn figures_are_written_as_the_kinds_that_are_asked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let mut command = hyzer();
    let command = command.args(["simulate", "--release", "backhand", "--until", "1"]);
    let command = command.args(["--figures", "pdf", "--figures", "png", "--out"]);
    if !cfg!(feature = "pictures") {
        let errors = stderr(command.arg(&out), 2);
        assert!(errors.contains("--features pictures"), "{errors}");
        assert!(!out.exists());
        return;
    }
    stdout(command.arg(&out), 0);
    let begins =
        |name: &str, with: &[u8]| std::fs::read(out.join(name)).is_ok_and(|f| f.starts_with(with));
    assert!(begins("flight.svg", b"<svg") && begins("flight.html", b"<!DOCTYPE"));
    assert!(begins("flight.pdf", b"%PDF-") && begins("flight.png", b"\x89PNG"));
    let mut command = hyzer();
    let command = command.args([
        "simulate",
        "--release",
        "backhand",
        "--figures",
        "gif",
        "--out",
    ]);
    command.arg(&out).assert().code(2);
}

#[test]
fn a_discus_goes_farther_against_the_wind_than_with_it() {
    let distance = |wind: &str| {
        let told = stdout(
            hyzer().args([
                "simulate",
                "discus",
                "--release",
                "discus",
                "--until",
                "ground",
                "--wind",
                wind,
            ]),
            0,
        );
        let line = told
            .lines()
            .find(|line| line.trim_start().starts_with("x "))
            .expect("x at the end");
        line.split_whitespace()
            .nth(1)
            .and_then(|x| x.parse::<f64>().ok())
            .expect("a number")
    };
    let (against, still, with) = (distance("-10,0,0"), distance("0,0,0"), distance("10,0,0"));
    assert!(
        against > still && against > with + 2.0,
        "{against} {still} {with}"
    );
}

#[test]
fn an_impossible_flight_ends_with_an_error() {
    let args = [
        "simulate",
        "disc",
        "--release",
        "bffl8",
        "--set",
        "C_Ma=5",
        "--until",
        "20",
        "--set",
        "C_Mq=1",
    ];
    let told = stderr(hyzer().args(args), 2);
    assert!(told.contains("at t = ") || told.contains(" s"), "{told}");
    assert!(!told.contains("NaN"), "{told}");
}

#[test]
fn made_flights_are_fitted() {
    let out = tempfile::tempdir().expect("a folder");
    hyzer()
        .arg("fit")
        .arg(repository().join("examples/ball"))
        .arg("--out")
        .arg(out.path())
        .assert()
        .success();
    let (value, error, rms) = drag(out.path());
    assert!((value - 0.47).abs() < 3.0 * error, "{value} ± {error}");
    assert!((0.8e-3..1.2e-3).contains(&rms), "{rms}");
}

#[test]
fn real_flights_are_fitted() {
    let Some(data) = shared_data("spindoe") else {
        return;
    };
    let out = tempfile::tempdir().expect("a folder");
    let fitted = hyzer()
        .arg("fit")
        .arg(data)
        .arg("--out")
        .arg(out.path())
        .assert()
        // The ball without a lift leaves smooth residuals far above the noise.
        .code(1);
    let message = String::from_utf8_lossy(&fitted.get_output().stderr).into_owned();
    assert!(
        message.contains("do not rely on this fit: the residuals"),
        "{message}"
    );
    let (value, error, rms) = drag(out.path());
    assert!(
        (0.4..0.6).contains(&value) && error < 0.02,
        "{value} ± {error}"
    );
    assert!(rms < 0.02, "{rms}");
}

#[test]
fn the_page_of_the_effects_is_what_the_command_writes() {
    let written = stdout(hyzer().arg("effects"), 0);
    let committed =
        std::fs::read_to_string(repository().join("docs/reference/effects.md")).expect("the page");
    assert!(
        written == committed,
        "docs/reference/effects.md is not what the command writes: run `hyzer effects --out docs/reference/effects.md`"
    );
    // Of a model of one's own, its own too.
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("own.hyz");
    let offered = "effect lead on ball { site gravity; variables none; source \"a | scale\";\n\
        coefficient lead = 0 kg in 0 .. 1; negligible lead 1e-5 kg; replace g_here = previous*(1 + lead/m); }\n";
    let ball = repository().join("model-spec/models/ball.hyz");
    let ball = std::fs::read_to_string(ball).expect("the ball");
    std::fs::write(&file, ball + offered).expect("written");
    let told = stdout(hyzer().arg("effects").arg(&file), 0);
    assert!(
        told.contains("| `lead` |  | none | `lead` in kg | 0 | 1e-5 |  | ball | a \\| scale |"),
        "{told}"
    );
    assert!(told.contains("`magnus`") && told.contains("| `stall` | it needs a number `C_L` |"));
}

#[test]
fn a_terminal_gets_no_markup() {
    let effects = stdout(hyzer().args(["effects", "disc", "--format", "text"]), 0);
    let explained = ["explain", "disc", "alpha", "--wrt", "w", "--format", "text"];
    let explained = stdout(hyzer().args(explained), 0);
    assert!(effects.contains("\n  stall "), "{effects}");
    assert!(explained.contains("∂α/∂w = "), "{explained}");
    for text in [&effects, &explained] {
        assert!(!text.contains(['\\', '`', '|']), "{text}");
    }
    let widest = effects.lines().map(|line| line.chars().count()).max();
    assert!(widest.is_some_and(|widest| widest <= 100), "{effects}");
    let latex = stdout(hyzer().args(["explain", "disc", "alpha"]), 0);
    let stated = ["explain", "disc", "alpha", "--format", "latex"];
    assert_eq!(latex, stdout(hyzer().args(stated), 0));
    assert!(latex.contains(r"\alpha = "), "{latex}");
}

#[test]
fn the_examples_of_the_effects_run() {
    examples::the_examples_run("effects", 2, "docs/reference/effects.md");
}

/// Reads the drag coefficient, its standard error, and the RMS residual (m) from the `report.json` in a folder.
fn drag(folder: &Path) -> (f64, f64, f64) {
    let text = std::fs::read_to_string(folder.join("report.json")).expect("a report");
    let report: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(report["schema"], "hyzer.fit/2");
    let number = |value: &serde_json::Value| value.as_f64().expect("a number");
    let drag = &report["coefficients"]["C_D"];
    (
        number(&drag["value"]),
        number(&drag["std_error"]),
        number(&report["residual_rms"]["marker"]["value"]),
    )
}

#[test]
fn a_derivative_is_explained_from_its_line_to_its_code() {
    let told = stdout(hyzer().args(["explain", "disc", "alpha", "--wrt", "w"]), 0);
    for part in [
        "disc.hyz:",
        "let alpha = atan2",
        r"\frac{\partial \alpha}{\partial w}",
        "operations",
    ] {
        assert!(told.contains(part), "{part} in {told}");
    }
}

#[test]
fn bad_input_is_status_2_and_says_what_was_expected() {
    let told = |args: &[&str]| stderr(hyzer().args(args), 2);
    assert!(told(&["check", "dsic"]).contains("disc"));
    assert!(told(&["simulate", "disc"]).contains("--release"));
    assert!(
        told(&[
            "simulate",
            "disc",
            "--release",
            "backhand",
            "--set",
            "C_XX=1"
        ])
        .contains("C_La")
    );
    let told_of_rho = told(&[
        "simulate",
        "disc",
        "--release",
        "backhand",
        "--set",
        "rho=-1",
    ]);
    assert!(
        told_of_rho.contains("rho = -1, expected 0"),
        "{told_of_rho}"
    );
    assert!(
        told(&["simulate", "disc", "--release", "backhand", "--set", "m=-1"]).contains("above 0")
    );
    assert!(
        told(&["simulate", "disc", "--release", "backhand", "--wind", "1,2"]).contains("X,Y,Z")
    );
    assert!(told(&["simulate", "disc", "--release", "backhand", "--rate", "0"]).contains("--rate"));
    assert!(told(&["fit", "nowhere"]).contains("dataset.toml"));
    assert!(told(&["explain", "disc", "alhpa"]).contains("alpha"));
}

#[test]
#[cfg(target_os = "linux")]
fn an_error_of_the_system_is_reported_once() {
    for command in ["simulate", "synthesize"] {
        let mut command_line = hyzer();
        command_line.args([command, "disc", "--release", "backhand"]);
        let errors = stderr(command_line.args(["--out", "/proc/none"]), 2);
        assert_eq!(errors.matches("(os error").count(), 1, "{errors}");
        assert!(!errors.contains("trial"), "{errors}");
    }
}
