//! Results in a folder: they carry what was found, and appear whole or not at all.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::time::{Duration, Instant};

use crate::support::{hyzer, told};

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn report(folder: &Path) -> serde_json::Value {
    serde_json::from_str(&read(&folder.join("report.json"))).expect("JSON")
}

#[test]
fn simulating_the_fitted_model_flies_what_was_found_and_a_fit_starts_there() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("fitted");
    let (status, _, errors) = told(hyzer().args(["fit", "examples/ball", "--out"]).arg(&out));
    assert_eq!(status, 0, "{errors}");
    let fitted = out.join("fitted.hyz");
    let found = report(&out)["coefficients"]["C_D"]["value"].to_string();
    let fly = |model: &Path, set: &[String]| {
        let out = folder.path().join("flight");
        let mut command = hyzer();
        command.arg("simulate").arg(model);
        command.args(["--release", "serve", "--until", "0.5", "--out"]);
        let (status, _, errors) = told(command.arg(&out).args(set));
        assert_eq!(status, 0, "{errors}");
        read(&out.join("trajectory.csv"))
    };
    let ball = Path::new("ball");
    let same = fly(ball, &["--set".to_owned(), format!("C_D={found}")]);
    assert_ne!(fly(ball, &[]), same);
    // Generated code and tape agree to the last bits of a number.
    let [of_file, of_name] = [fly(&fitted, &[]), same].map(|table| numbers(&table));
    assert_eq!(of_file.len(), of_name.len());
    for (a, b) in of_file.iter().zip(&of_name) {
        assert!((a - b).abs() <= 1e-9, "{a} {b}");
    }

    let again = folder.path().join("again");
    let arguments = ["fit", "examples/ball", "--model"];
    let mut command = hyzer();
    let (status, _, errors) = told(
        command
            .args(arguments)
            .arg(&fitted)
            .arg("--out")
            .arg(&again),
    );
    assert_eq!(status, 0, "{errors}");
    let value = |folder: &Path, key: &str| report(folder)["coefficients"]["C_D"][key].as_f64();
    let [first, second] = [&out, &again].map(|folder| value(folder, "value").expect("a number"));
    let error = value(&out, "std_error").expect("a number");
    assert!(
        (first - second).abs() < 1e-3 * error,
        "{first} {second} ± {error}"
    );
}

fn numbers(table: &str) -> Vec<f64> {
    let rows = table.lines().skip(1).flat_map(|line| line.split(','));
    rows.map(|cell| cell.parse().expect("a number")).collect()
}

#[test]
fn the_folder_is_tried_before_the_work() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("taken");
    std::fs::write(&file, "mine").expect("written");
    for command in [
        &["fit", "examples/ball"][..],
        &["diagnose", "examples/mystery"],
        &["simulate", "disc", "--release", "backhand"],
        &[
            "synthesize",
            "disc",
            "--release",
            "backhand",
            "--flights",
            "90000",
            "--duration",
            "1",
        ],
    ] {
        let started = Instant::now();
        let (status, text, errors) = told(hyzer().args(command).arg("--out").arg(&file));
        assert_eq!((status, text.as_str()), (2, ""), "{errors}");
        assert!(errors.contains("taken is a file"), "{errors}");
        if command[0] == "synthesize" {
            continue;
        }
        let (status, _, errors) = told(hyzer().args(command).arg("--out").arg(folder.path()));
        assert_eq!(status, 2);
        assert!(
            errors.contains("files that hyzer did not write or that were edited (taken)"),
            "{errors}"
        );
        assert!(started.elapsed() < Duration::from_secs(5), "{command:?}");
    }
    assert_eq!(read(&file), "mine");
}

#[test]
fn earlier_results_are_gone_and_a_folder_with_other_files_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let simulate = [
        "simulate",
        "disc",
        "--release",
        "backhand",
        "--until",
        "0.1",
    ];
    let run = |command: &[&str]| told(hyzer().args(command).arg("--out").arg(&out));
    assert_eq!(run(&["fit", "examples/ball"]).0, 0);
    assert_eq!(run(&simulate).0, 0);
    let names = || {
        let entries = std::fs::read_dir(&out).expect("a folder");
        let names = entries.map(|entry| entry.expect("an entry").file_name());
        let mut names: Vec<_> = names
            .map(|name| name.to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    };
    let results = [
        ".hyzer-results",
        "flight.html",
        "flight.svg",
        "summary.json",
        "trajectory.csv",
    ];
    assert_eq!(names(), results);
    std::fs::write(out.join("notes.txt"), "mine").expect("written");
    let before = names();
    let (status, text, errors) = run(&simulate);
    assert_eq!((status, text.as_str()), (2, ""));
    assert!(errors.contains("(notes.txt)"), "{errors}");
    assert_eq!(names(), before);
}

/// Test in which runs of `hyzer` are killed at random times; afterwards the output folder must contain the complete
/// results of a single run.
struct Kills {
    around: tempfile::TempDir,
    /// Names of the two releases that are simulated in turn; their results differ.
    releases: [&'static str; 2],
    seed: u64,
}

impl Kills {
    fn new() -> Kills {
        Kills {
            around: tempfile::tempdir().expect("a folder"),
            releases: ["backhand", "bffl8"],
            seed: 7,
        }
    }

    fn out(&self) -> PathBuf {
        self.around.path().join("out")
    }

    fn command(&self, release: &str) -> std::process::Command {
        let mut command = hyzer();
        command.args(["simulate", "disc", "--release", release, "--until", "1"]);
        command.args(["--rate", "20000", "--out"]).arg(self.out());
        command.stdout(Stdio::null()).stderr(Stdio::null());
        command
    }

    fn random(&mut self) -> f64 {
        self.seed = self
            .seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (self.seed >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn contents(&self) -> BTreeMap<String, Vec<u8>> {
        let entries = std::fs::read_dir(self.out()).expect("the folder is there");
        let each = entries.map(|entry| {
            let entry = entry.expect("an entry");
            let name = entry.file_name().to_string_lossy().into_owned();
            (name, std::fs::read(entry.path()).expect("a file"))
        });
        each.collect()
    }

    /// Kills `kills` runs of `hyzer`, which simulate the two releases in turn, and asserts that the output folder
    /// contains the complete results of one of them. Returns how many kills left the earlier results in the folder, and
    /// how many the new ones.
    fn run(mut self, kills: usize) -> [usize; 2] {
        let mut whole = Vec::new();
        let mut longest = Duration::ZERO;
        for release in self.releases {
            let started = Instant::now();
            assert!(self.command(release).status().expect("it runs").success());
            longest = longest.max(started.elapsed());
            whole.push(self.contents());
        }
        let (mut now, mut counts) = (1, [0; 2]);
        for kill in 0..kills {
            let next = 1 - now;
            let mut run = self.command(self.releases[next]).spawn().expect("it runs");
            let moment = longest.mul_f64(1.2 * self.random());
            let started = Instant::now();
            // Every second one while the results are written, which takes a small part of the time.
            let part = self.around.path().join(format!(".out.hyzer-{}", run.id()));
            while kill % 2 == 0 && !part.exists() && run.try_wait().expect("a process").is_none() {
                std::thread::yield_now();
            }
            let moment = match kill % 2 {
                0 => started.elapsed() + Duration::from_micros((4000.0 * self.random()) as u64),
                _ => moment,
            };
            std::thread::sleep(moment.saturating_sub(started.elapsed()));
            run.kill().expect("killed");
            run.wait().expect("it ended");
            let found = self.contents();
            let state = whole.iter().position(|whole| *whole == found);
            let names: Vec<&String> = found.keys().collect();
            let state = state.unwrap_or_else(|| panic!("kill {kill} left {names:?}"));
            counts[usize::from(state == next)] += 1;
            now = state;
        }
        // The next run removes what the killed ones left.
        assert!(
            self.command("backhand")
                .status()
                .expect("it runs")
                .success()
        );
        let left = std::fs::read_dir(self.around.path()).expect("a folder");
        assert_eq!(left.count(), 1);
        eprintln!(
            "{kills} kills: {} left the earlier results, {} the new ones",
            counts[0], counts[1]
        );
        counts
    }
}

#[test]
fn a_kill_leaves_the_earlier_results_or_the_new_ones() {
    Kills::new().run(20);
}

#[test]
#[ignore = "takes a minute"]
fn two_hundred_kills_leave_the_earlier_results_or_the_new_ones() {
    let counts = Kills::new().run(200);
    assert!(counts.iter().all(|&count| count > 0), "{counts:?}");
}
