//! Shares run by Dask on a local cluster: the same bits as one process. Skipped where no Python has Dask.

use std::fs;
use std::path::Path;
use std::process::Command;

/// Python interpreter named by the environment variable `HYZER_PYTHON`, or else `python3`; `None` if it lacks Dask.
fn python() -> Option<String> {
    let python = std::env::var("HYZER_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let has = Command::new(&python)
        .args(["-c", "import dask.distributed"])
        .output();
    has.is_ok_and(|done| done.status.success())
        .then_some(python)
}

/// Runs a command in one process and in several processes started by Dask, and asserts that both write the same
/// contents to the result file `file`.
fn compare(arguments: &[&str], file: &str) {
    let Some(python) = python() else {
        eprintln!("skipped: no Python with dask.distributed (HYZER_PYTHON names one)");
        return;
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let around = tempfile::tempdir().expect("a folder");
    let hyzer = env!("CARGO_BIN_EXE_hyzer");
    let run = |command: &mut Command| {
        let done = command.current_dir(root).output().expect("it runs");
        let told = String::from_utf8_lossy(&done.stderr);
        assert!(done.status.success(), "{told}");
    };
    let (alone, shared) = (around.path().join("alone"), around.path().join("shared"));
    run(Command::new(hyzer).args(arguments).arg("--out").arg(&alone));
    run(Command::new(python)
        .arg("examples/dask/shares.py")
        .args(arguments)
        .args(["--shares", "3", "--hyzer", hyzer, "--out"])
        .arg(&shared));
    let read = |folder: &Path| fs::read(folder.join(file)).expect("results");
    assert!(read(&alone) == read(&shared), "{file}");
}

#[test]
fn a_sweep_is_the_same_bits() {
    compare(&["sweep", "backhands"], "flights.parquet");
}

#[test]
fn a_bootstrap_is_the_same_bits() {
    compare(
        &["bootstrap", "examples/disc", "--refits", "80"],
        "refits.csv",
    );
}
