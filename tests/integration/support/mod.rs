//! The program run as its users run it, in the repository.

pub mod examples;

use std::process::Command;

use assert_cmd::cargo::CommandCargoExt;

/// Returns a command that runs `hyzer` in the root of the repository.
pub fn hyzer() -> Command {
    let mut command = Command::cargo_bin("hyzer").expect("the program");
    command.current_dir(env!("CARGO_MANIFEST_DIR"));
    command
}

/// Runs a command and returns its exit status, standard output and standard error.
pub fn told(command: &mut Command) -> (i32, String, String) {
    let output = command.output().expect("it runs");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
    (
        output.status.code().unwrap_or(-1),
        text(output.stdout),
        text(output.stderr),
    )
}

/// Asserts that a page loads nothing.
pub fn loads_nothing(page: &str) {
    for load in [
        "src=\"http",
        "href=\"http",
        "@import",
        "url(http",
        "<script src",
        "<link",
    ] {
        assert!(!page.contains(load), "{load}");
    }
}
