//! Help, manual pages, completions and the list of models.

use crate::support::{hyzer, told};
use std::process::Command;

fn stdout(command: &mut Command) -> String {
    let (status, text, errors) = told(command);
    assert_eq!(status, 0, "{errors}");
    text
}

/// Names of all commands, by their manual pages.
fn commands() -> Vec<String> {
    let folder = tempfile::tempdir().expect("a folder");
    stdout(hyzer().args(["man", "--out"]).arg(folder.path()));
    assert!(folder.path().join("hyzer.1").is_file());
    let pages = std::fs::read_dir(folder.path()).expect("the pages");
    let pages = pages.map(|page| page.expect("a page").file_name().into_string());
    let pages = pages.map(|name| name.expect("a name"));
    let names = pages.filter_map(|name| {
        let name = name.strip_prefix("hyzer-")?.strip_suffix(".1")?;
        Some(name.to_owned())
    });
    names.collect()
}

#[test]
fn every_command_has_help_with_an_example() {
    let commands = commands();
    assert!(commands.iter().any(|name| name == "fit"), "{commands:?}");
    for command in commands.iter().filter(|name| *name != "help") {
        let told = stdout(hyzer().args([command, "--help"]));
        assert!(told.contains(&format!("  hyzer {command}")), "{told}");
    }
}

#[test]
fn completions_know_every_command() {
    let commands = commands();
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = stdout(hyzer().args(["completions", shell]));
        for command in &commands {
            assert!(script.contains(command.as_str()), "{shell}: {command}");
        }
    }
}

#[test]
fn models_lists_what_is_built_in() {
    let listed = stdout(hyzer().arg("models"));
    let built_in = [model_spec::load::MODELS, model_spec::load::BODIES].concat();
    for (name, _) in built_in {
        let line = listed
            .lines()
            .find(|line| line.trim_start().starts_with(&format!("{name} ")));
        assert!(line.is_some_and(|line| line.len() > 30), "{name}: {listed}");
    }
}
