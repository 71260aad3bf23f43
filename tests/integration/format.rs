//! The command `format`.

use std::fs;
use std::io::Write;
use std::process::{Command, Output, Stdio};

use crate::support::{hyzer, told};

fn told_of_input(command: &mut Command, input: &str) -> Output {
    let pipes = command.stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut child = pipes.stderr(Stdio::piped()).spawn().expect("it runs");
    let mut pipe = child.stdin.take().expect("a pipe");
    pipe.write_all(input.as_bytes()).expect("it reads");
    drop(pipe);
    child.wait_with_output().expect("it ends")
}

#[test]
fn files_are_formatted_or_all_stay() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::write(&path, text).expect("written");
        path
    };
    let rough = file("rough.hyz", "param  m=1 kg; // a stone\r\n");
    let even = file("even.hyz", "let a = 1;\n");
    let faulty = file("faulty.hyz", "let  a = ;\nlet b\n");
    let text = |path| fs::read_to_string(path).expect("text");

    let (status, shown, _) = told(hyzer().args(["format", "--check"]).args([&rough, &even]));
    assert_eq!(status, 1);
    let changes: Vec<&str> = shown
        .lines()
        .filter(|line| line.starts_with(['+', '-']))
        .collect();
    assert!(
        matches!(
            changes[..],
            [
                _,
                _,
                "-param  m=1 kg; // a stone",
                "+param m = 1 kg; // a stone"
            ]
        ),
        "{shown}"
    );

    let (status, _, errors) = told(hyzer().arg("format").args([&rough, &faulty]));
    assert_eq!(status, 2);
    assert_eq!(errors.matches("faulty.hyz").count(), 2, "{errors}");
    assert_eq!(text(&rough), "param  m=1 kg; // a stone\r\n");

    let (status, _, errors) = told(hyzer().arg("format").args([&rough, &even]));
    assert_eq!((status, errors.lines().count()), (0, 1), "{errors}");
    assert_eq!(text(&rough), "param m = 1 kg; // a stone\r\n");
    assert_eq!(
        told(hyzer().args(["format", "--check"]).args([&rough, &even])).0,
        0
    );
}

#[test]
fn standard_input_is_formatted_to_standard_output() {
    let of = |input| {
        let output = told_of_input(hyzer().args(["format", "-"]), input);
        let text = String::from_utf8(output.stdout).expect("text");
        (output.status.code(), text)
    };
    assert_eq!(of("let a=1;"), (Some(0), "let a = 1;\n".to_owned()));
    assert_eq!(of("let a=;"), (Some(2), String::new()));
}
