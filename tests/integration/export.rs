//! `hyzer export`: a model for other programs.

use crate::support::{examples, hyzer, told};

#[test]
fn the_examples_of_the_export_run() {
    examples::the_examples_run("export", 2, "disc.json");
}

#[test]
fn a_file_holds_what_is_printed() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("new/ball.json");
    let export = ["export", "ball", "--ir", "--with", "magnus"];
    let (status, printed, _) = told(hyzer().args(export));
    assert_eq!(status, 0);
    let (status, nothing, _) = told(hyzer().args(export).arg("--out").arg(&file));
    assert_eq!((status, nothing.as_str()), (0, ""));
    assert_eq!(std::fs::read_to_string(&file).expect("a file"), printed);
    let value: serde_json::Value = serde_json::from_str(&printed).expect("JSON");
    assert_eq!(value["schema"], "hyzer.ir/1");
    assert_eq!(value["version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(value["effects"][0], "magnus");
    let functions = value["functions"].as_object().expect("functions");
    assert_eq!(functions.len(), 7);
}

#[test]
fn bad_input_writes_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("out.json");
    for bad in [
        &["export", "bal", "--ir"][..],
        &["export", "ball", "--ir", "--with", "stall"],
        &["export", "ball"],
    ] {
        let (status, printed, errors) = told(hyzer().args(bad).arg("--out").arg(&file));
        assert_eq!((status, printed.as_str()), (2, ""), "{bad:?}");
        assert!(!errors.is_empty() && !file.exists(), "{bad:?}");
    }
    let (status, _, errors) = told(hyzer().args(["export", "ball", "--ir", "--out", "/"]));
    assert_eq!(status, 2, "{errors}");
}
