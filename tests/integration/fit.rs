//! `hyzer fit` as its users run it.

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::support::examples::the_examples_run;
use crate::support::{hyzer, loads_nothing, told};

#[test]
fn the_readme_s_command_writes_a_page_that_needs_no_network() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("fitted");
    let (status, text, errors) = told(hyzer().args(["fit", "examples/disc", "--out"]).arg(&out));
    assert_eq!(status, 0, "{errors}");
    assert!(
        text.contains("C_L0") && text.contains("95 % interval"),
        "{text}"
    );
    // Nothing but where the results are and what comes next: no bar where there is no terminal.
    let [place, next] = errors.lines().collect::<Vec<_>>()[..] else {
        panic!("{errors}")
    };
    assert!(place.contains("are in"), "{place}");
    assert!(
        next.starts_with("next: hyzer diagnose examples/disc"),
        "{next}"
    );
    let report: serde_json::Value =
        serde_json::from_slice(&std::fs::read(out.join("report.json")).expect("a report"))
            .expect("JSON");
    assert_eq!(report["schema"], "hyzer.fit/2");
    for key in [
        "model",
        "residual_rms",
        "noise",
        "coefficients",
        "correlations",
        "flights",
        "not_identifiable",
        "seconds",
    ] {
        assert!(!report[key].is_null(), "{key}");
    }
    for key in ["value", "std_error", "unit", "at_bound"] {
        assert!(!report["coefficients"]["C_Ma"][key].is_null(), "{key}");
    }
    assert!(!report["flights"][0]["initial"]["gammadot"]["std_error"].is_null());
    let page = std::fs::read_to_string(out.join("report.html")).expect("a page");
    loads_nothing(&page);
    for file in [
        "coefficients.csv",
        "correlations.csv",
        "flights.csv",
        "residuals.csv",
        "residuals.svg",
    ] {
        assert!(out.join(file).is_file(), "{file}");
    }
    assert!(std::fs::read_dir(&out).expect("files").all(|file| {
        let name = file.expect("a file").file_name();
        !name.to_string_lossy().contains("tmp")
    }));
}

#[test]
fn tables_are_parquet_too() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let mut command = hyzer();
    command.args(["fit", "examples/ball", "--tables", "parquet", "--out"]);
    let (status, _, errors) = told(command.arg(&out));
    assert_eq!(status, 0, "{errors}");
    for name in ["coefficients", "flights", "residuals"] {
        let bytes = std::fs::read(out.join(format!("{name}.parquet"))).expect(name);
        assert!(
            bytes.starts_with(b"PAR1") && bytes.ends_with(b"PAR1"),
            "{name}"
        );
        assert!(out.join(format!("{name}.csv")).is_file(), "{name}");
    }
}

#[test]
fn the_examples_of_the_help_run() {
    the_examples_run("fit", 3, "fitted");
}

#[test]
fn what_is_asked_wrongly_is_refused() {
    for (arguments, expected) in [
        (vec!["fit", "examples/nothing"], "no such folder"),
        (vec!["fit", "examples/disc", "--hold", "C_X"], "C_X"),
        (
            vec!["fit", "examples/disc", "--hold", "C_La", "--free", "C_La"],
            "found --hold C_La and --free C_La; expected one of them",
        ),
        (
            vec!["fit", "examples/disc", "--hold", "C_Nr=fast"],
            "\"fast\"",
        ),
        (
            vec!["fit", "examples/disc", "--prior", "C_D0=0.1"],
            "VALUE+-SIGMA",
        ),
        (
            vec!["fit", "examples/disc", "--prior", "C_D0=0.1+-0"],
            "above 0",
        ),
        (vec!["fit", "examples/disc", "--free", "wind"], "wind"),
        (vec!["fit", "examples/disc", "--profile", "m"], "m"),
        (vec!["fit", "examples/disc", "--model", "ball"], "ball"),
        (vec!["fit", "examples/ball", "--model", "disc"], "radius"),
    ] {
        let (status, _, errors) = told(hyzer().args(&arguments));
        assert_eq!(status, 2, "{arguments:?}: {errors}");
        assert!(errors.contains(expected), "{arguments:?}: {errors}");
    }
}

/// Creates a dataset whose fit takes so long that a test can interrupt it.
fn long_work(folder: &Path) {
    let made = hyzer()
        .args([
            "synthesize",
            "disc",
            "--release",
            "backhand",
            "--flights",
            "400",
            "--duration",
            "2",
            "--out",
        ])
        .arg(folder)
        .output()
        .expect("it runs");
    assert!(
        made.status.success(),
        "{}",
        String::from_utf8_lossy(&made.stderr)
    );
}

#[test]
#[cfg(unix)]
fn an_interruption_ends_it_within_a_second_and_leaves_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let (made, out) = (folder.path().join("made"), folder.path().join("out"));
    long_work(&made);
    for delay in [50, 700, 1500] {
        let mut child = hyzer()
            .arg("fit")
            .arg(&made)
            .args(["--threads", "1", "--out"])
            .arg(&out)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("it runs");
        std::thread::sleep(Duration::from_millis(delay));
        let told = Instant::now();
        let killed = Command::new("kill")
            .args(["-INT", &child.id().to_string()])
            .status();
        assert!(killed.expect("kill").success());
        let status = child.wait().expect("it ends");
        assert!(
            told.elapsed() < Duration::from_secs(1),
            "after {delay} ms: {:?}",
            told.elapsed()
        );
        assert!(!status.success(), "after {delay} ms it was done already");
        assert!(!out.exists(), "after {delay} ms something was left");
    }
}
