//! The examples of a command's help.

use crate::support::{hyzer, told};

/// Runs every example in the help of a command, of which there must be at least `least`, and asserts that it succeeds.
/// Output to the path `out` goes to a temporary folder instead.
pub fn the_examples_run(command: &str, least: usize, out: &str) {
    let help = told(hyzer().args([command, "--help"])).1;
    let examples: Vec<&str> = help
        .lines()
        .filter_map(|line| line.trim().strip_prefix("hyzer "))
        .filter(|line| line.split_whitespace().next() == Some(command))
        .collect();
    assert!(examples.len() >= least, "{help}");
    for example in examples {
        let folder = tempfile::tempdir().expect("a folder");
        let command = example.split(" #").next().unwrap_or(example);
        let words = command.split_whitespace().map(|word| {
            if word == out {
                folder.path().join("out").display().to_string()
            } else {
                word.to_owned()
            }
        });
        let (status, _, errors) = told(hyzer().args(words));
        assert_eq!(status, 0, "{example}: {errors}");
    }
}
