//! Certificates by the program: written, checked, and named on the pages of a fit.

use std::fs;
use std::path::Path;

use crate::support::{hyzer, told};

const KITE: &str = "model kite; param g0 = 9.81 m/s^2; param k = 0.3 1/s; frame N;
state z = 1 m; state v = 0 m/s; der(z) = v; der(v) = -g0 - k*v;";

fn verify(arguments: &[&str]) -> (i32, String, String) {
    told(hyzer().arg("verify").args(arguments))
}

/// Path of the file `name` in a folder, as a command-line argument.
fn at(folder: &Path, name: &str) -> String {
    folder.join(name).display().to_string()
}

#[test]
fn a_certificate_is_written_stands_and_falls_with_its_source() {
    let folder = tempfile::tempdir().expect("a folder");
    let (model, file) = (
        at(folder.path(), "kite.hyz"),
        at(folder.path(), "kite.json"),
    );
    fs::write(&model, KITE).expect("a model");
    let write = ["--cases", "10", "--certificate", &file];
    // Stated equations without a law: not verified, and the certificate says so.
    let (status, _, said) = verify(&[&[model.as_str()], write.as_slice()].concat());
    assert_eq!(
        (status, said.contains("kite: NOT VERIFIED")),
        (3, true),
        "{said}"
    );
    let first = fs::read(&file).expect("a certificate");
    assert_eq!(verify(&[&[model.as_str()], write.as_slice()].concat()).0, 3);
    assert_eq!(
        fs::read(&file).expect("a certificate"),
        first,
        "the same bytes"
    );
    let json: serde_json::Value = serde_json::from_slice(&first).expect("JSON");
    assert_eq!(json["outcome"], "not-verified");
    assert_eq!(
        json["models"][0]["covers"]["sources"][0]["name"],
        "kite.hyz"
    );
    for arguments in [vec!["--check", &file], vec!["--check", &file, "--again"]] {
        let (status, said, _) = verify(&arguments);
        assert_eq!(status, 0, "{said}");
        assert!(said.ends_with("stands: kite: NOT VERIFIED\n"), "{said}");
    }
    fs::write(&model, KITE.replace("- k*v", "- 2*k*v")).expect("a model");
    let (status, said, _) = verify(&["--check", &file]);
    assert_eq!(status, 1, "{said}");
    assert!(
        said.contains("does not stand:\n  kite: source kite.hyz changed"),
        "{said}"
    );
    assert!(said.contains("kite: schedule changed"), "{said}");
    let (status, said, _) = verify(&["--check", &file, "--json"]);
    let json: serde_json::Value = serde_json::from_str(&said).expect("JSON");
    assert_eq!(
        (status, &json["stands"]),
        (1, &serde_json::Value::Bool(false))
    );
    assert_eq!(json["changes"][0]["what"], "source kite.hyz changed");
}

#[test]
fn several_models_share_a_certificate_and_a_refuted_one_is_certified_as_such() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = at(folder.path(), "both.json");
    let write = ["--cases", "10", "--certificate", &file];
    let all = [&["ball", "disc_appendix_printed"], write.as_slice()].concat();
    let (status, _, said) = verify(&all);
    assert_eq!(status, 1, "{said}");
    assert!(
        said.contains("ball: verified, disc_appendix_printed: REFUTED"),
        "{said}"
    );
    assert_eq!(verify(&["--check", &file]).0, 0);
    let all = [&["disc", "disc_quaternion"], write.as_slice()].concat();
    assert_eq!(verify(&all).0, 0);
    let (status, said, _) = verify(&["--check", &file, "--again"]);
    assert_eq!(status, 0, "{said}");
    let text = fs::read_to_string(&file).expect("a certificate");
    assert!(text.contains("disc and disc_quaternion: flights"), "{text}");
}

#[test]
fn what_is_no_certificate_is_bad_input_and_a_refused_model_has_none() {
    let folder = tempfile::tempdir().expect("a folder");
    let (bad, model) = (at(folder.path(), "bad.json"), at(folder.path(), "bad.hyz"));
    fs::write(&bad, "{\n  \"schema\": 1\n}").expect("a file");
    let (status, _, said) = verify(&["--check", &bad]);
    assert_eq!(status, 2, "{said}");
    assert!(
        said.contains("bad.json") && said.contains("line 2"),
        "{said}"
    );
    let (status, _, said) = verify(&["--check", &at(folder.path(), "absent.json")]);
    assert_eq!(status, 2, "{said}");
    assert_eq!(verify(&["disc", "--check", &bad]).0, 2);
    assert_eq!(verify(&["disc", "--again"]).0, 2);
    let (status, _, said) = told(
        hyzer()
            .args(["fit", "examples/ball", "--certificate"])
            .arg(&bad),
    );
    assert!(status == 2 && said.contains("--certificate"), "{said}");
    fs::write(&model, "model bad; der(z) = ").expect("a file");
    let none = at(folder.path(), "none.json");
    let (status, _, said) = verify(&[&model, "--certificate", &none]);
    assert_eq!(status, 1, "{said}");
    assert!(said.contains("no certificate is written"), "{said}");
    assert!(!Path::new(&none).exists());
}

#[test]
fn the_page_of_a_fit_names_the_certificate_next_to_the_model() {
    let folder = tempfile::tempdir().expect("a folder");
    let model = at(folder.path(), "own_ball.hyz");
    let text = fs::read_to_string("model-spec/models/ball.hyz").expect("the ball");
    fs::write(&model, &text).expect("a model");
    let out = at(folder.path(), "out");
    let page = |options: &[&str]| {
        let mut command = hyzer();
        command.args(["fit", "examples/ball", "--model", &model, "--out", &out]);
        let (status, _, said) = told(command.args(options));
        assert_eq!(status, 0, "{said}");
        let read = |name: &str| fs::read_to_string(Path::new(&out).join(name)).expect(name);
        let json: serde_json::Value = serde_json::from_str(&read("report.json")).expect("JSON");
        (read("report.html"), json)
    };
    let (html, json) = page(&[]);
    assert!(html.contains("The model has no certificate"), "no line");
    assert_eq!(json["certificate"]["file"], serde_json::Value::Null);
    assert_eq!(json["schema"], "hyzer.fit/1");

    let file = at(folder.path(), "own_ball.certificate.json");
    assert_eq!(
        verify(&[&model, "--cases", "10", "--certificate", &file]).0,
        0
    );
    for options in [vec![], vec!["--certificate", &file]] {
        let (html, json) = page(&options);
        let stands = "Model verified: the certificate own_ball.certificate.json stands.";
        assert!(html.contains(stands), "{options:?}");
        assert_eq!(json["certificate"]["stands"], true);
        assert_eq!(json["certificate"]["outcome"], "verified");
    }
    fs::write(&model, text + "\n// a remark\n").expect("a model");
    let (html, json) = page(&[]);
    assert!(
        html.contains(
            "own_ball.certificate.json does not stand: ball: source own_ball.hyz changed"
        )
    );
    assert_eq!(json["certificate"]["stands"], false);
    fs::write(&file, "{").expect("a file");
    let (html, _) = page(&[]);
    assert!(html.contains("does not stand: EOF while parsing"), "{html}");
}

#[test]
fn the_examples_of_the_help_run_one_after_the_other() {
    let folder = tempfile::tempdir().expect("a folder");
    let help = verify(&["--help"]).1;
    let lines = help.lines().filter_map(|line| {
        let words = line.trim().strip_prefix("hyzer verify ")?;
        Some(words.split(" #").next().unwrap_or(words).to_owned())
    });
    let examples: Vec<String> = lines.collect();
    assert!(examples.iter().any(|e| e.contains("--check")), "{help}");
    for example in examples {
        let mut command = hyzer();
        command.current_dir(folder.path()).arg("verify");
        let (status, _, said) = told(command.args(example.split_whitespace()));
        assert_eq!(status, 0, "{example}: {said}");
    }
}
