//! Files that are not what a command reads: what is told is what was found, what was expected, and what writes it.

use std::path::Path;

use assert_cmd::Command;

use crate::cli::{hyzer, stderr};

#[test]
fn what_is_no_json_of_the_kind_is_told_with_what_writes_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("file.json");
    let told = |file: &Path| {
        let told = |command: &mut Command| stderr(command.arg(file), 2);
        let design = ["design", "--goal", "spread", "--target", "30,0,0", "--fit"];
        [
            told(hyzer().args(["verify", "--check"])),
            told(hyzer().args(design)),
        ]
    };
    let all = |file: &Path, found: &str| {
        for text in told(file) {
            let writes = text.contains("`hyzer verify MODEL") || text.contains("`hyzer fit");
            let is_told =
                text.contains(found) && text.contains("expected") && !text.contains("os error");
            assert!(
                is_told && (writes || found.contains("byte")),
                "{found}: {text}"
            );
        }
    };
    all(&file, "found no such file");
    all(folder.path(), "found a folder");
    for (contents, found) in [
        (&b""[..], "found an empty file"),
        (b"{\"schema\": [1", "1:13: the text ends too early"),
        (
            b"{\"schema\": 1e999}",
            "1:16: this is no JSON: number out of range",
        ),
        (b"{\"schema\": \"hyzer.verification/99\"}", "found"),
        (&[0xff, 0xfe], "1:1: found the byte 0xff"),
    ] {
        std::fs::write(&file, contents).expect("written");
        all(&file, found);
    }
}
