//! `hyzer synthesize` as its users meet it, and the examples, which it makes.

use std::path::{Path, PathBuf};

use assert_cmd::Command;

fn hyzer() -> Command {
    Command::cargo_bin("hyzer").expect("the program is built with its tests")
}

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Arguments of the commands `hyzer synthesize` that a text contains, one list for each line with such a command.
fn commands(text: &str) -> Vec<Vec<String>> {
    let lines = text.lines().map(str::trim);
    let ours = lines.filter_map(|line| line.strip_prefix("hyzer synthesize"));
    let words = |line: &str| line.split_whitespace().map(str::to_owned).collect();
    ours.map(words).collect()
}

/// Runs `hyzer synthesize` with the folder of the option `--out` moved into the folder `around`. Returns the folder as
/// named in the command, and the path to which it was moved.
fn run(command: &[String], around: &Path) -> (PathBuf, PathBuf) {
    let place = command.iter().position(|word| word == "--out");
    let place = place.expect("a folder") + 1;
    let named = PathBuf::from(&command[place]);
    let out = around.join(&named);
    let mut command = command.to_vec();
    command[place] = out.display().to_string();
    hyzer()
        .arg("synthesize")
        .args(command)
        .current_dir(around)
        .assert()
        .success();
    (named, out)
}

#[test]
fn the_examples_of_the_help_run() {
    let output = hyzer()
        .args(["synthesize", "--help"])
        .assert()
        .code(0)
        .get_output()
        .clone();
    let help = String::from_utf8(output.stdout).expect("text");
    let commands: Vec<_> = commands(&help)
        .into_iter()
        .filter(|words| words.contains(&"--out".to_owned()))
        .collect();
    assert_eq!(commands.len(), 3, "{help}");
    let around = tempfile::tempdir().expect("a folder");
    for command in commands {
        let (_, out) = run(&command, around.path());
        dataset::load(&out).expect("a dataset");
        let truth = std::fs::read_to_string(out.join("truth.toml")).expect("the truth");
        assert!(truth.contains("fit` does not read"), "{truth}");
    }
}

#[test]
fn the_committed_examples_are_what_their_commands_make() {
    let page = std::fs::read_to_string(repository().join("examples/README.md")).expect("the page");
    let commands = commands(&page);
    assert_eq!(commands.len(), 3, "{page}");
    let around = tempfile::tempdir().expect("a folder");
    for command in commands {
        let (named, out) = run(&command, around.path());
        let committed = repository().join(&named);
        let mut size = 0;
        let names = |folder: &Path| {
            let entries = std::fs::read_dir(folder).expect("a folder");
            let mut names: Vec<_> = entries
                .map(|entry| entry.expect("one").file_name())
                .collect();
            names.sort();
            names
        };
        assert_eq!(names(&out), names(&committed));
        for name in names(&out) {
            let read = |folder: &Path| std::fs::read_to_string(folder.join(&name)).expect("text");
            let text = read(&committed);
            size += text.len();
            let told = format!(
                "{} of {}: run the command in examples/README.md",
                name.display(),
                named.display()
            );
            assert!(same(&read(&out), &text), "{told}");
        }
        assert!(size < 500_000, "{size} bytes");
    }
}

#[test]
fn what_was_put_into_the_examples_is_fitted_out_of_them() {
    let around = tempfile::tempdir().expect("a folder");
    for name in ["ball", "disc"] {
        let dataset = repository().join("examples").join(name);
        let out = around.path().join(name);
        hyzer()
            .arg("fit")
            .arg(&dataset)
            .arg("--out")
            .arg(&out)
            .assert()
            .success();
        let text = std::fs::read_to_string(out.join("report.json")).expect("a report");
        let report: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        let truth = std::fs::read_to_string(dataset.join("truth.toml")).expect("the truth");
        let lines = truth
            .lines()
            .skip_while(|line| *line != "[coefficients]")
            .skip(1);
        let coefficients: Vec<_> = lines.map_while(|line| line.split_once(" = ")).collect();
        assert_eq!(coefficients.len(), if name == "ball" { 1 } else { 8 });
        for (coefficient, truth) in coefficients {
            let found = &report["coefficients"][coefficient];
            let number = |key: &str| found[key].as_f64().expect("a number");
            let truth: f64 = truth.parse().expect("a number");
            let (value, error) = (number("value"), number("std_error"));
            let off = (value - truth).abs() / error;
            assert!(
                off < 4.0,
                "{coefficient}: {value} ± {error}, put in {truth}"
            );
        }
    }
}

/// Whether two texts are equal except for differences of numbers below 1.5e-5, because rounding may differ between
/// machines.
fn same(a: &str, b: &str) -> bool {
    let words = |text: &str| -> Vec<String> {
        text.split([',', ' ', '\n', '[', ']'])
            .map(str::to_owned)
            .collect()
    };
    let (a, b) = (words(a), words(b));
    let close = |(a, b): (&String, &String)| match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) => (a - b).abs() < 1.5e-5,
        _ => a == b,
    };
    a.len() == b.len() && a.iter().zip(&b).all(close)
}

#[test]
fn texts_are_compared_to_the_last_digit() {
    assert!(same("t,x\n0.1,2.00001\n", "t,x\n0.1,2.00002\n"));
    assert!(!same("t,x\n0.1,2.00001\n", "t,x\n0.1,2.00004\n"));
    assert!(!same("t,x\n0.1,\n", "t,x\n0.1,2.0\n"));
    assert!(!same("t,x\n0.1,2\n", "t,y\n0.1,2\n"));
}

#[test]
fn bad_options_are_refused_and_leave_nothing() {
    let cases: [(&[&str], &str); 19] = [
        (&["disc"], "--release"),
        (&["disc", "--release", "forehand"], "forehand"),
        (&["dsic", "--release", "backhand"], "disc"),
        (&["ball", "--release", "backhand"], "vx"),
        (
            &["--release", "backhand", "--release", "serve"],
            "one model",
        ),
        (
            &["--release", "bffl8", "--release", "fssh3"],
            "different bodies",
        ),
        (&["--release", "backhand", "--set", "C_XX=1"], "C_La"),
        (&["--release", "backhand", "--set", "m=-1"], "above 0"),
        (
            &["--release", "backhand", "--with", "gravity_waves"],
            "gravity_waves",
        ),
        (
            &["--release", "backhand", "--flights", "0"],
            "flights: found 0",
        ),
        (
            &["--release", "backhand", "--held-out", "9"],
            "held-out: found 9",
        ),
        (&["--release", "backhand", "--rate", "0"], "rate: found 0"),
        (&["--release", "backhand", "--duration", "1e9"], "duration"),
        (
            &["--release", "backhand", "--spread", "nan"],
            "spread: found NaN",
        ),
        (
            &["--release", "backhand", "--noise-sigma", "inf"],
            "noise-sigma: found inf",
        ),
        (
            &["--release", "backhand", "--noise-ar1", "-1"],
            "noise-ar1: found -1",
        ),
        (
            &["--release", "backhand", "--dropouts", "1"],
            "dropouts: found 1",
        ),
        (&["--release", "backhand", "--marker", "rim=1,2"], "X,Y,Z"),
        (
            &["--release", "backhand", "--marker", "a b=0,0,0"],
            "a name without spaces",
        ),
    ];
    let around = tempfile::tempdir().expect("a folder");
    for (arguments, expected) in cases {
        let assert = hyzer()
            .arg("synthesize")
            .args(arguments)
            .args(["--out", "made"])
            .current_dir(around.path())
            .assert()
            .code(2);
        let told = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
        assert!(told.contains(expected), "{arguments:?}: {told}");
        let left = std::fs::read_dir(around.path()).expect("a folder").count();
        assert_eq!(left, 0, "{arguments:?}");
    }
}

#[test]
fn a_folder_with_something_else_in_it_is_left_alone() {
    let around = tempfile::tempdir().expect("a folder");
    std::fs::write(around.path().join("notes"), "mine").expect("written");
    let assert = hyzer()
        .args(["synthesize", "--release", "serve", "--out"])
        .arg(around.path())
        .assert()
        .code(2);
    let told = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
    assert!(told.contains("holds something else"), "{told}");
    assert_eq!(
        std::fs::read_dir(around.path()).expect("a folder").count(),
        1
    );
}

#[test]
fn a_model_of_ones_own_goes_with_its_dataset() {
    let around = tempfile::tempdir().expect("a folder");
    let text = std::fs::read_to_string(repository().join("model-spec/models/ball.hyz"));
    let text = text
        .expect("the ball")
        .replace("model ball;", "model wet_ball;");
    std::fs::write(around.path().join("wet.hyz"), text).expect("written");
    let run = |out: &str, seed: &str| {
        hyzer()
            .args(["synthesize", "wet.hyz", "--release", "serve"])
            .args(["--seed", seed, "--out", out])
            .current_dir(around.path())
            .assert()
            .success();
        std::fs::read_to_string(around.path().join(out).join("flight01.csv")).expect("a table")
    };
    let first = run("deep/a", "1");
    std::fs::rename(around.path().join("deep/a"), around.path().join("moved")).expect("moved");
    hyzer()
        .args(["fit", "moved"])
        .current_dir(around.path())
        .assert()
        .success();
    assert_eq!(run("b", "1"), first);
    assert_ne!(run("c", "2"), first);
}
