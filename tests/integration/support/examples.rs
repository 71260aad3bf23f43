//! The examples of a command's help.

use crate::support::{hyzer, told};

/// Runs every example of a command's help, at least so many; what one names `out` is put elsewhere.
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
