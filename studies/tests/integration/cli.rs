//! The program `hyzer-studies`: its commands, exit statuses and pages.

use std::path::Path;

use assert_cmd::Command;

fn hyzer_studies() -> Command {
    Command::cargo_bin("hyzer-studies").expect("the program is built with its tests")
}

fn stdout(command: &mut Command, code: i32) -> String {
    let output = command.assert().code(code).get_output().clone();
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn the_page_on_the_paper_is_what_the_command_writes() {
    let written = stdout(hyzer_studies().arg("paper"), 0);
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/studies/paper.md");
    let committed = std::fs::read_to_string(page).expect("the page");
    assert_eq!(
        written, committed,
        "run `hyzer-studies paper --out docs/studies/paper.md`"
    );
    assert!(
        written.contains("| 9 of 9 |"),
        "a reading that holds every claim"
    );
}

#[test]
fn every_command_has_help_with_an_example() {
    for command in [
        "paper",
        "identification",
        "real-data",
        "discovery",
        "fits",
        "takes",
    ] {
        let help = stdout(hyzer_studies().args([command, "--help"]), 0);
        assert!(
            help.contains(&format!("  hyzer-studies {command}")),
            "{help}"
        );
    }
}

#[test]
fn bad_input_is_status_2_and_says_what_was_expected() {
    let stderr = |args: &[&str]| {
        let output = hyzer_studies().args(args).assert().code(2);
        String::from_utf8(output.get_output().stderr.clone()).expect("text")
    };
    let told = stderr(&["discovery", "--only", "no such row"]);
    assert!(
        told.contains("no row has the words `no such row`"),
        "{told}"
    );
    assert!(stderr(&["real-data", "--data", "nowhere"]).contains("nowhere"));
    assert!(stderr(&["trials"]).contains("trials"));
}
