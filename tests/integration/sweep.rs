//! `hyzer sweep`: the same bits however the work is divided, a run that was killed goes on, and faults of plans are named.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::time::Duration;

use crate::support::examples::the_examples_run;
use crate::support::{hyzer, told};
use serde_json::Value;

/// Text of a model that a user could write, with which sweeps are tested.
const LEAF: &str = "model leaf;
param m = 0.002 kg;
param g = 9.81 m/s^2;
coefficient k = 0.004 kg/m in 0 .. 1;
input wind in N = (0, 0, 0) m/s;
frame N;
point leaf { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
let air_velocity = velocity - wind;
force weight = -m*g*N.3;
force drag = -k*norm(air_velocity)*air_velocity;
";
const LEAF_PLAN: &str = "model = \"leaf.hyz\"
until = \"ground\"
flights = 5000
seed = 3
[throw]
speed = 6.0
launch = 40.0
height = 2.0
[vary]
speed = { sd = 0.5 }
wind_x = { normal = [1.0, 0.5] }
heading = { values = [0.0, 90.0] }
k = { uniform = [0.003, 0.005] }
[[correlations]]
of = [\"speed\", \"wind_x\"]
value = -0.5
";

/// Creates a temporary folder with the model [`LEAF`] and a sweep plan for it. Returns the folder and the path of the
/// plan.
pub fn leaf() -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("leaf.hyz"), LEAF).expect("written");
    let plan = folder.path().join("plan.toml");
    fs::write(&plan, LEAF_PLAN).expect("written");
    (folder, plan)
}

/// Runs `hyzer sweep`, asserts that it succeeds, and returns what it prints.
pub fn sweep(plan: &Path, out: &Path, options: &[&str]) -> String {
    let mut command = hyzer();
    let (status, text, errors) = told(
        command
            .arg("sweep")
            .arg(plan)
            .arg("--out")
            .arg(out)
            .args(options),
    );
    assert_eq!(status, 0, "{errors}");
    text
}

/// Runs a sweep of the plan with the given text; returns its summary and the lines of `flights.csv`.
pub fn swept(text: &str) -> (Value, Vec<String>) {
    let folder = tempfile::tempdir().expect("a folder");
    let (plan, out) = (folder.path().join("plan.toml"), folder.path().join("out"));
    fs::write(&plan, text).expect("written");
    sweep(&plan, &out, &["--csv"]);
    let csv = fs::read_to_string(out.join("flights.csv")).expect("a table");
    (summary(&out), csv.lines().map(str::to_owned).collect())
}

fn summary(out: &Path) -> Value {
    let text = fs::read_to_string(out.join("summary.json")).expect("a summary");
    serde_json::from_str(&text).expect("JSON")
}

/// Number in the named column and in data row `row`, counted from 0, of a CSV table given by its lines.
fn cell(lines: &[String], row: usize, column: &str) -> f64 {
    let place = lines[0]
        .split(',')
        .position(|name| name == column)
        .expect(column);
    lines[row + 1]
        .split(',')
        .nth(place)
        .expect("a cell")
        .parse()
        .expect("a number")
}

fn results(out: &Path) -> [Vec<u8>; 2] {
    ["flights.parquet", "summary.json"].map(|name| fs::read(out.join(name)).expect(name))
}

#[test]
fn the_examples_of_its_help_run() {
    the_examples_run("sweep", 2, "swept");
}

#[test]
fn threads_and_shares_change_no_bit() {
    let (folder, plan) = leaf();
    let out = |name: &str| folder.path().join(name);
    sweep(&plan, &out("one"), &["--threads", "1"]);
    let one = results(&out("one"));
    sweep(&plan, &out("three"), &["--threads", "3"]);
    assert!(one == results(&out("three")), "threads change bits");
    for share in ["3/3", "1/3", "2/3"] {
        sweep(&plan, &out("shares"), &["--part", share, "--threads", "2"]);
        assert!(!out("shares").join("flights.parquet").exists());
    }
    sweep(&plan, &out("shares"), &[]);
    assert!(one == results(&out("shares")), "shares change bits");
    let summary = summary(&out("one"));
    assert_eq!(summary["flights"], 10_000);
    assert_eq!(summary["statuses"]["landed"], 10_000);
    // Again, from complete results: nothing changes, and the CSV can be had afterwards.
    sweep(&plan, &out("one"), &["--csv"]);
    assert!(one == results(&out("one")));
    let csv = fs::read_to_string(out("one").join("flights.csv")).expect("a table");
    assert_eq!(csv.lines().count(), 10_001);
    assert!(!out("one").join("parts").exists());
}

#[test]
fn the_numbers_are_those_of_the_distributions() {
    let (folder, plan) = leaf();
    let out = folder.path().join("out");
    sweep(&plan, &out, &["--csv"]);
    let csv = fs::read_to_string(out.join("flights.csv")).expect("a table");
    let lines: Vec<String> = csv.lines().map(str::to_owned).collect();
    let column = |name: &str| {
        (0..10_000)
            .map(|row| cell(&lines, row, name))
            .collect::<Vec<f64>>()
    };
    let mean = |of: &[f64]| of.iter().sum::<f64>() / of.len() as f64;
    let (speed, wind) = (column("speed"), column("wind_x"));
    let sd = |of: &[f64]| {
        let mean = mean(of);
        (of.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / of.len() as f64).sqrt()
    };
    // Four standard errors.
    assert!((mean(&speed) - 6.0).abs() < 0.02 && (sd(&speed) - 0.5).abs() < 0.015);
    assert!((mean(&wind) - 1.0).abs() < 0.02 && (sd(&wind) - 0.5).abs() < 0.015);
    let products: Vec<f64> = speed
        .iter()
        .zip(&wind)
        .map(|(a, b)| (a - 6.0) * (b - 1.0))
        .collect();
    let correlation = mean(&products) / (sd(&speed) * sd(&wind));
    assert!((correlation + 0.5).abs() < 0.04, "{correlation}");
    let k = column("k");
    assert!(k.iter().all(|k| (0.003..0.005).contains(k)) && (mean(&k) - 0.004).abs() < 3e-5);
    let summary = summary(&out);
    let range = column("range");
    let told = &summary["columns"]["range"];
    let close = |value: &Value, expected: f64, tolerance: f64| {
        let value = value.as_f64().expect("a number");
        assert!(
            (value - expected).abs() <= tolerance * expected.abs(),
            "{value} {expected}"
        );
    };
    close(&told["mean"], mean(&range), 1e-12);
    close(&told["sd"], sd(&range), 1e-4);
    let mut sorted = range.clone();
    sorted.sort_by(f64::total_cmp);
    close(&told["quantiles"]["0.5"], sorted[4999], 2e-4);
    close(&told["min"], sorted[0], 0.0);
    let (x, y) = (column("landing_x"), column("landing_y"));
    let xy: Vec<f64> = x
        .iter()
        .zip(&y)
        .map(|(a, b)| (a - mean(&x)) * (b - mean(&y)))
        .collect();
    close(&summary["landing_covariance"][0][1], mean(&xy), 1e-3);
}

#[test]
fn a_killed_sweep_goes_on_and_gives_the_same_bits() {
    let folder = tempfile::tempdir().expect("a folder");
    let plan = folder.path().join("plan.toml");
    // Four parts of full discs, some seconds.
    let text = fs::read_to_string(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/src/commands/sweep/backhands.toml"
    ));
    let text = text
        .expect("the plan")
        .replace("flights = 2000", "flights = 9000");
    fs::write(&plan, text).expect("written");
    let (killed, whole) = (folder.path().join("killed"), folder.path().join("whole"));
    let parts = |out: &Path| {
        let entries = fs::read_dir(out.join("parts"))
            .into_iter()
            .flatten()
            .flatten();
        let names = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
        names
            .filter(|name| !name.starts_with('.'))
            .collect::<Vec<String>>()
    };
    let mut command = hyzer();
    command
        .arg("sweep")
        .arg(&plan)
        .arg("--out")
        .arg(&killed)
        .args(["--threads", "1"]);
    let mut child = command
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("it runs");
    while parts(&killed).is_empty() {
        assert!(
            child.try_wait().expect("a process").is_none(),
            "it ended before a part was there"
        );
        std::thread::sleep(Duration::from_millis(2));
    }
    child.kill().expect("killed");
    child.wait().expect("ended");
    assert!(
        !killed.join("flights.parquet").exists(),
        "it was done before it was killed"
    );
    let kept = parts(&killed);
    let modified = |name: &String| {
        let path = killed.join("parts").join(name);
        fs::metadata(path)
            .and_then(|m| m.modified())
            .expect("a part")
    };
    let before: Vec<_> = kept.iter().map(modified).collect();
    // A part that was damaged is flown again, one that is whole is not.
    sweep(&plan, &killed, &["--part", "1/1"]);
    assert_eq!(before, kept.iter().map(modified).collect::<Vec<_>>());
    fs::write(killed.join("parts").join(&kept[0]), "damaged").expect("written");
    sweep(&plan, &killed, &[]);
    sweep(&plan, &whole, &[]);
    assert!(
        results(&killed) == results(&whole),
        "a killed sweep differs"
    );
    // Another plan does not mix with it.
    let other = fs::read_to_string(&plan)
        .expect("the plan")
        .replace("seed = 1", "seed = 2");
    fs::write(&plan, other).expect("written");
    let (status, _, errors) = told(hyzer().arg("sweep").arg(&plan).arg("--out").arg(&whole));
    assert_eq!(status, 2);
    assert!(errors.contains("other inputs"), "{errors}");
}

#[test]
fn the_same_seed_draws_the_same_flight_in_a_longer_sweep() {
    let text = |flights: usize| {
        format!(
            "model = \"ball\"\nuntil = \"ground\"\nflights = {flights}\n[throw]\nspeed = 30.0\n[vary]\nspeed = {{ sd = 1.0 }}"
        )
    };
    let (_, short) = swept(&text(20));
    let (_, long) = swept(&text(9000));
    assert_eq!(short[..21], long[..21]);
    assert_ne!(short[1], short[2]);
}

#[test]
fn a_drop_without_spin_does_not_drift_and_a_throw_straight_up_comes_down() {
    let (_, drop) = swept(
        "model = \"disc\"\nuntil = \"ground\"\n[initial]\nx = 0\ny = 0\nz = 20\nu = 0\nv = 0\nw = 0\nphi = 0\ntheta = 0\ngamma = 0\n\
         phidot = 0\nthetadot = 0\ngammadot = 0\n[vary]\nz = { values = [5.0, 20.0, 80.0] }",
    );
    for row in 0..3 {
        assert!(drop[row + 1].ends_with(",landed"), "{}", drop[row + 1]);
        assert!(cell(&drop, row, "range") < 1e-12, "{}", drop[row + 1]);
    }
    for model in ["ball", "disc_quaternion"] {
        let (_, up) = swept(&format!(
            "model = \"{model}\"\nuntil = \"ground\"\n[throw]\nspeed = 20.0\nlaunch = 90.0\n[vary]\nspeed = {{ values = [5.0, 15.0, 30.0] }}"
        ));
        for row in 0..3 {
            assert!(up[row + 1].ends_with(",landed"), "{model}: {}", up[row + 1]);
            assert!(cell(&up, row, "apex_z") > 1.5, "{model}: {}", up[row + 1]);
            assert!(cell(&up, row, "landing_z").abs() < 1e-9);
            if model == "ball" {
                assert!(cell(&up, row, "range") < 1e-9, "{}", up[row + 1]);
            }
        }
    }
}

#[test]
fn a_bad_flight_is_a_row_and_no_error() {
    // Below the ground, without a state of that throw within the limits, out of bounds.
    let (summary, lines) = swept(
        "model = \"disc\"\nuntil = \"ground\"\n[throw]\nspeed = 20.0\nspin = 600.0\n[vary]\nheight = { values = [1.0, -5.0] }\nnose = { values = [0.0, 90.0] }",
    );
    assert_eq!(summary["flights"], 4);
    assert_eq!(summary["statuses"]["landed"], 1, "{lines:?}");
    assert_eq!(summary["statuses"]["starts-below-ground"], 1, "{lines:?}");
    assert_eq!(summary["statuses"]["refused"], 2, "{lines:?}");
}

#[test]
fn a_fit_is_an_input() {
    let folder = tempfile::tempdir().expect("a folder");
    let report = r#"{"coefficients": {"C_D": {"value": 0.5, "std_error": 0.02, "at_bound": false}}, "correlations": {"C_D": {"C_D": 1.0}}}"#;
    fs::write(folder.path().join("report.json"), report).expect("written");
    let plan = folder.path().join("plan.toml");
    let text = "model = \"ball\"\nuntil = \"ground\"\nflights = 4000\n[throw]\nspeed = 20.0\n[fit]\nreport = \"report.json\"\n";
    fs::write(&plan, text).expect("written");
    let out = folder.path().join("out");
    sweep(&plan, &out, &[]);
    let column = &summary(&out)["columns"]["C_D"];
    let [mean, sd] = ["mean", "sd"].map(|key| column[key].as_f64().expect("a number"));
    assert!(
        (mean - 0.5).abs() < 0.0013 && (sd - 0.02).abs() < 0.001,
        "{mean} {sd}"
    );
    fs::write(&plan, format!("{text}[coefficients]\nC_D = 0.3\n")).expect("written");
    let (status, _, errors) = told(hyzer().arg("sweep").arg(&plan).arg("--out").arg(&out));
    assert_eq!(status, 2);
    assert!(
        errors.contains(":7:10: report.json: C_D is 0.3 in the plan and 0.5 in the fit"),
        "{errors}"
    );
}

#[test]
fn faults_of_a_plan_are_named_with_their_place() {
    let folder = tempfile::tempdir().expect("a folder");
    let plan = folder.path().join("plan.toml");
    let base = "model = \"disc\"\nuntil = \"ground\"\nflights = 10\n[throw]\nspeed = 20.0\n";
    for (text, place, said) in [
        (
            "[vary]\nspede = { sd = 1.0 }",
            "7:1",
            "did you mean \"speed\"?",
        ),
        (
            "[vary]\nspeed = { sd = -1.0 }",
            "7:16",
            "expected a number above 0",
        ),
        ("[vary]\nspeed = 3", "7:9", "expected a table"),
        (
            "[vary]\nspeed = { sd = 1.0, uniform = [1.0, 2.0] }",
            "7:9",
            "sd and uniform",
        ),
        (
            "[vary]\nspeed = { uniform = [2.0, 1.0] }",
            "7:21",
            "the lower bound first",
        ),
        (
            "[vary]\nspeed = { values = [10.0, 10000.0] }",
            "7:9",
            "speed would be 10000",
        ),
        ("[vary]\nspeed = { values = [] }", "7:20", "a list of 1 to"),
        (
            "[vary]\nz = { values = [1.0] }",
            "7:1",
            "expected one of speed, heading, launch",
        ),
        (
            "[vary]\nspeed = { sd = 1.0 }\nspin = { sd = 9.0 }\n[[correlations]]\nof = [\"speed\", \"spin\"]\n\
             value = 0.9\n[[correlations]]\nof = [\"spin\", \"speed\"]\nvalue = 0.2",
            "13:6",
            "a second correlation of spin and speed",
        ),
        ("[vary]\nm = { values = [-1.0] }", "7:5", "a number above 0"),
        (
            "[vary]\nspeed = { range = [1.0, 2.0], count = 1e300 }",
            "7:39",
            "count is",
        ),
        ("[vary]\nspeed = { values = [nan] }", "7:21", "finite"),
        ("[fit]\nreport = \"nowhere.json\"", "7:10", "nowhere.json"),
        ("seed = 1", "6:1", "unknown key \"seed\""),
        (
            "[vary]\nspeed = { sd = 1.0 }\nspin = { sd = 1.0 }\n[[correlations]]\nof = [\"speed\", \"spin\"]\nvalue = 1.5",
            "11:9",
            "from -1 to 1",
        ),
        (
            "[vary]\nspeed = { sd = 1.0 }\n[[correlations]]\nof = [\"speed\", \"nose\"]\nvalue = 0.5",
            "9:6",
            "normal quantities",
        ),
    ] {
        fs::write(&plan, format!("{base}{text}")).expect("written");
        let out = folder.path().join("out");
        let (status, _, errors) = told(hyzer().arg("sweep").arg(&plan).arg("--out").arg(&out));
        assert_eq!(status, 2, "{text}: {errors}");
        assert!(
            errors.contains(&format!("plan.toml:{place}: ")),
            "{text}: {errors}"
        );
        assert!(errors.contains(said), "{text}: {errors}");
        assert!(!out.exists(), "{text}");
    }
    for (text, said) in [
        (
            "model = \"disc\"\nuntil = \"ground\"\n[throw]\nspeed = 20.0\n[vary]\nspeed = { sd = 1.0 }",
            "found no number of flights",
        ),
        ("model = \"nothing\"\nuntil = \"ground\"", "nothing"),
        ("model = [", "no TOML"),
    ] {
        fs::write(&plan, text).expect("written");
        let (status, _, errors) = told(
            hyzer()
                .arg("sweep")
                .arg(&plan)
                .arg("--out")
                .arg(folder.path().join("out")),
        );
        assert_eq!((status, errors.contains(said)), (2, true), "{errors}");
    }
    // A folder with other files is left alone.
    let full = folder.path().join("full");
    fs::create_dir(&full).expect("a folder");
    fs::write(full.join("own.txt"), "own").expect("written");
    fs::write(&plan, base).expect("written");
    let (status, _, errors) = told(hyzer().arg("sweep").arg(&plan).arg("--out").arg(&full));
    assert_eq!(
        (status, errors.contains("did not write")),
        (2, true),
        "{errors}"
    );
    assert_eq!(fs::read_dir(&full).expect("a folder").count(), 1);
}

/// Simulates a sweep of a million flights and asserts that it needs no more memory than one of a few flights. It takes
/// minutes, so it runs only with `cargo test --release --test integration sweep:: -- --ignored`.
#[test]
#[ignore = "minutes"]
#[cfg(target_os = "linux")]
fn a_million_flights_need_no_more_memory_than_a_few() {
    let folder = tempfile::tempdir().expect("a folder");
    let peak = |flights: u64| {
        let plan = folder.path().join(format!("{flights}.toml"));
        let text = format!(
            "model = \"ball\"\nuntil = \"ground\"\nflights = {flights}\n[throw]\nspeed = 30.0\nlaunch = 30.0\n[vary]\nspeed = {{ sd = 1.0 }}"
        );
        fs::write(&plan, text).expect("written");
        let out = folder.path().join(flights.to_string());
        let mut child = hyzer()
            .arg("sweep")
            .arg(&plan)
            .arg("--out")
            .arg(&out)
            .spawn()
            .expect("it runs");
        let status = format!("/proc/{}/status", child.id());
        let mut peak = 0;
        while child.try_wait().expect("a process").is_none() {
            let text = fs::read_to_string(&status).unwrap_or_default();
            let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
            let size = line.and_then(|line| line.trim().strip_suffix(" kB")?.parse::<u64>().ok());
            peak = peak.max(size.unwrap_or(0));
            std::thread::sleep(Duration::from_millis(5));
        }
        assert_eq!(summary(&out)["flights"], flights);
        peak
    };
    let (few, many) = (peak(65_536), peak(1_000_000));
    println!("peak resident memory: {few} kB with 65,536 flights, {many} kB with 1,000,000");
    assert!(many < few + few / 4, "{few} kB, then {many} kB");
}
