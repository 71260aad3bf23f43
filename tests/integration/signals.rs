//! Ctrl-C and SIGTERM end every command within a second, whatever it is at.
#![cfg(unix)]

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::support::{hyzer, told};

/// Exit status of a program that a signal interrupted.
const INTERRUPTED: i32 = 130;

const LIMIT: Duration = Duration::from_secs(1);

/// Starts a command whose standard output is a pipe that nobody reads; long output fills the pipe.
fn start(command: &mut Command) -> Child {
    command.stdout(Stdio::piped()).stderr(Stdio::null());
    command.spawn().expect("it runs")
}

/// Sends a signal to a process and waits for its end; returns the exit status and the time until the end.
fn signal(child: &mut Child, name: &str) -> (Option<i32>, Duration) {
    let sent = Instant::now();
    let id = child.id().to_string();
    let kill = Command::new("kill")
        .args([&format!("-{name}"), &id])
        .status();
    assert!(kill.expect("kill").success());
    let status = child.wait().expect("it ends");
    (status.code(), sent.elapsed())
}

/// Asserts that SIGINT and SIGTERM end the command within a time limit. Each signal is sent to a separate process,
/// after the process has worked for a while.
fn both_end(name: &str, command: impl Fn() -> Command) {
    for (sent, after) in [("INT", 300), ("TERM", 900)] {
        let mut child = start(&mut command());
        std::thread::sleep(Duration::from_millis(after));
        let is_done = child.try_wait().expect("a process").is_some();
        assert!(
            !is_done,
            "{name} was done after {after} ms already: more work is needed"
        );
        let (status, took) = signal(&mut child, sent);
        assert!(took < LIMIT, "{name}: {took:?} after SIG{sent}");
        assert_eq!(status, Some(INTERRUPTED), "{name} after SIG{sent}");
    }
}

fn with(arguments: &[&str], paths: &[(&str, &Path)]) -> Command {
    let mut command = hyzer();
    command.args(arguments);
    for (option, path) in paths {
        if !option.is_empty() {
            command.arg(option);
        }
        command.arg(path);
    }
    command
}

/// Writes a model that takes long to compile and whose summary does not fit into a pipe's buffer.
fn wide_model(folder: &Path) -> PathBuf {
    let mut text = "model wide;\nframe N;\nparam m = 1 kg;\n".to_owned();
    for k in 0..2000 {
        let doc = "A coefficient with a long description. ".repeat(3);
        let _ = write!(text, "/// {doc}\ncoefficient c{k} = 0.1 in 0 .. 1;\n");
    }
    let sum: Vec<String> = (0..2000).map(|k| format!("c{k}")).collect();
    for (k, part) in sum.chunks(20).enumerate() {
        let _ = writeln!(text, "let s{k} = {};", part.join(" + "));
    }
    let sums: Vec<String> = (0..100).map(|k| format!("s{k}")).collect();
    for (k, part) in sums.chunks(10).enumerate() {
        let _ = writeln!(text, "let t{k} = {};", part.join(" + "));
    }
    text += "point p { mass m; position (x, y, z) in N; velocity (u, v, w) in N; }\n\
        force f = m*(t0 + t1 + t2 + t3 + t4 + t5 + t6 + t7 + t8 + t9)*1 [m/s^2]*N.1;\n\
        marker k in N;\nobserve k_seen = position + k;\n";
    write(folder, "wide.hyz", &text)
}

fn write(folder: &Path, name: &str, text: &str) -> PathBuf {
    let path = folder.join(name);
    std::fs::write(&path, text).expect("written");
    path
}

#[test]
fn commands_on_models_end() {
    let folder = tempfile::tempdir().expect("a folder");
    let wide = wide_model(folder.path());
    let out = folder.path().join("out");
    both_end("check", || with(&["check"], &[("", &wide)]));
    both_end("verify", || {
        with(&["verify", "disc", "--cases", "100000"], &[])
    });
    both_end("generate", || {
        with(&["generate"], &[("", &wide), ("--out", &out)])
    });
    both_end("explain", || {
        let mut command = with(&["explain"], &[("", &wide)]);
        command.args(["der(u)", "--wrt", "c7"]);
        command
    });
    assert!(!out.exists());
}

#[test]
fn commands_on_flights_end() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    both_end("simulate", || {
        let arguments = [
            "simulate",
            "disc",
            "--release",
            "backhand",
            "--until",
            "150",
        ];
        let mut command = with(&arguments, &[("--out", &out)]);
        command.args(["--rate", "6000", "--tolerance", "1e-14"]);
        command
    });
    both_end("synthesize", || {
        let arguments = [
            "synthesize",
            "disc",
            "--release",
            "backhand",
            "--duration",
            "1",
        ];
        let mut command = with(&arguments, &[("--out", &out)]);
        command.args(["--flights", "3000", "--rate", "1000"]);
        command
    });
    let made = folder.path().join("made");
    let arguments = [
        "synthesize",
        "disc",
        "--release",
        "backhand",
        "--duration",
        "2",
    ];
    let (status, _, errors) =
        told(with(&arguments, &[("--out", &made)]).args(["--flights", "400"]));
    assert_eq!(status, 0, "{errors}");
    for name in ["fit", "diagnose"] {
        both_end(name, || {
            let mut command = with(&[name], &[("", &made), ("--out", &out)]);
            command.args(["--threads", "1"]);
            command
        });
    }
    assert!(!out.exists());
}

#[test]
fn a_signal_while_results_are_written_leaves_them_whole() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    for sent in ["INT", "TERM", "INT", "TERM"] {
        let arguments = ["simulate", "disc", "--release", "backhand", "--until", "1"];
        let mut command = with(&arguments, &[("--out", &out)]);
        command.args(["--rate", "20000"]);
        let mut child = start(&mut command);
        let part = folder.path().join(format!(".out.hyzer-{}", child.id()));
        while !part.exists() && child.try_wait().expect("a process").is_none() {
            std::thread::yield_now();
        }
        let (status, took) = signal(&mut child, sent);
        assert!(took < LIMIT, "{took:?}");
        // Too late for the signal, it ends as it would have.
        assert!([Some(0), Some(INTERRUPTED)].contains(&status), "{status:?}");
        let left: Vec<_> = std::fs::read_dir(folder.path())
            .expect("a folder")
            .collect();
        assert_eq!(left.len(), 1, "{left:?}");
        let table = std::fs::read_to_string(out.join("trajectory.csv")).expect("a table");
        assert_eq!(table.lines().count(), 20_002);
    }
}
