//! `hyzer bootstrap`: parts, shares, refusals.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn bootstrap(out: &Path, more: &[&str]) -> Output {
    bootstrap_of("ball", out, &[&["--refits", "40"], more].concat())
}

fn bootstrap_of(example: &str, out: &Path, more: &[&str]) -> Output {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    Command::new(env!("CARGO_BIN_EXE_hyzer"))
        .arg("bootstrap")
        .arg(examples.join(example))
        .arg("--out")
        .arg(out)
        .args(more)
        .output()
        .expect("it runs")
}

#[track_caller]
fn done(out: &Path, more: &[&str]) -> String {
    let output = bootstrap(out, more);
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn shares_and_threads_leave_the_same_bits() {
    let around = tempfile::tempdir().expect("a folder");
    let (alone, shared) = (around.path().join("alone"), around.path().join("shared"));
    let text = done(&alone, &[]);
    assert!(
        text.contains("40 refits to 6 flights drawn with replacement, 40 converged"),
        "{text}"
    );
    assert_eq!(done(&shared, &["--part", "2/3", "--threads", "1"]), "");
    // What a share has written is kept, and read.
    let part = shared.join("parts/000001.csv");
    let written = fs::metadata(&part)
        .expect("a part")
        .modified()
        .expect("a time");
    done(&shared, &["--part", "2/3"]);
    assert_eq!(
        fs::metadata(&part)
            .expect("a part")
            .modified()
            .expect("a time"),
        written
    );
    // A part that was damaged is done again.
    fs::write(&part, "refit,converged,C_D\n16,true,oops\n").expect("written");
    assert_eq!(done(&shared, &["--threads", "2"]), text);
    for file in ["refits.csv", "summary.json"] {
        let read = |folder: &Path| fs::read_to_string(folder.join(file)).expect(file);
        assert_eq!(read(&alone), read(&shared));
    }
    assert!(!shared.join("parts").exists());
    // A complete one is only shown again.
    assert_eq!(done(&shared, &[]), text);
}

#[test]
fn other_work_and_foreign_folders_are_refused() {
    let around = tempfile::tempdir().expect("a folder");
    let out = around.path().join("out");
    done(&out, &["--part", "1/3"]);
    for more in [
        &["--seed", "2"][..],
        &["--hold", "C_D=0.5"],
        &["--part", "4/3"],
    ] {
        let output = bootstrap(&out, more);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
    }
    let text = String::from_utf8(bootstrap(&out, &["--seed", "2"]).stderr).expect("text");
    assert!(text.contains("other inputs"), "{text}");
    fs::create_dir(around.path().join("foreign")).expect("a folder");
    fs::write(around.path().join("foreign/mine.txt"), "").expect("written");
    let output = bootstrap(&around.path().join("foreign"), &[]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
}

#[test]
fn an_unreliable_fit_is_unreliable_each_time() {
    let around = tempfile::tempdir().expect("a folder");
    let out = around.path().join("out");
    for time in ["computed", "shown again"] {
        let output = bootstrap_of("mystery", &out, &["--refits", "4"]);
        assert_eq!(output.status.code(), Some(1), "{time}: {output:?}");
        let message = String::from_utf8(output.stderr).expect("text");
        assert!(
            message.contains("do not rely on this fit: the residuals"),
            "{time}: {message}"
        );
    }
}
