//! The review of models: what could not be verified, and what a change does.

use std::path::Path;

use assert_cmd::Command;

fn hyzer() -> Command {
    Command::cargo_bin("hyzer").expect("the program is built with its tests")
}

fn stdout(command: &mut Command, code: i32) -> String {
    let output = command.assert().code(code).get_output().clone();
    String::from_utf8(output.stdout).expect("text")
}

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn what_could_not_be_checked_has_an_exit_status_of_its_own() {
    let folder = tempfile::tempdir().expect("a folder");
    let model = folder.path().join("swing.hyz");
    let text = "model swing; param l = 1 m; param g = 9.81 m/s^2; frame N;
        state phi = 10 deg; state phidot = 0 rad/s; der(phi) = phidot; der(phidot) = -g/l*sin(phi);";
    std::fs::write(&model, text).expect("a file");
    let output = stdout(hyzer().arg("verify").arg(&model), 3);
    assert!(output.contains("NOT VERIFIED: reference"), "{output}");
    let output = stdout(hyzer().arg("verify").arg(&model).arg("--json"), 3);
    let value: serde_json::Value = serde_json::from_str(&output).expect("JSON");
    assert_eq!(value["holds"], true);
    assert_eq!(value["outcome"], "not-verified");
    let help = stdout(hyzer().args(["verify", "--help"]), 0);
    assert!(help.contains("3 not verified"), "{help}");
}

#[test]
fn diff_says_the_same_function_of_a_rewriting_and_names_what_a_change_changes() {
    let folder = tempfile::tempdir().expect("a folder");
    let disc = std::fs::read_to_string(repository().join("model-spec/models/disc.hyz"));
    let disc = disc.expect("the disc");
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).expect("a file");
    };
    let diff = |arguments: &[&str], code| {
        let output = hyzer()
            .arg("diff")
            .args(arguments)
            .current_dir(folder.path())
            .assert()
            .code(code)
            .get_output()
            .clone();
        (
            String::from_utf8(output.stdout).expect("text"),
            String::from_utf8(output.stderr).expect("text"),
        )
    };
    write("new.hyz", &disc.replace("rho_air*V^2/2", "V*rho_air/2*V"));
    let (output, _) = diff(&["disc", "new.hyz"], 0);
    assert!(output.contains(": the same function"), "{output}");
    assert!(output.contains("rewritten let q"), "{output}");

    write("new.hyz", &disc.replace("C_Da*alpha^2", "C_Da*alpha^3"));
    let flown = ["disc", "new.hyz", "--release", "backhand"];
    let (output, _) = diff(&flown, 1);
    assert!(
        output.contains("another function: der(u), der(v), der(w)"),
        "{output}"
    );
    assert!(output.contains("\nflights\n  backhand\n    - "), "{output}");
    let (output, _) = diff(&[flown.as_slice(), &["--json"]].concat(), 1);
    let value: serde_json::Value = serde_json::from_str(&output).expect("JSON");
    assert_eq!(value["schema"], "hyzer.diff/2");
    assert_eq!(value["changed"], true);
    assert!(value["operations"]["f"]["new"].as_u64() > Some(0));
    let [old, new] = ["old", "new"].map(|model| &value["landings"][0][model]["end"]);
    assert_ne!(old["state"]["x"], new["state"]["x"]);
    assert!(old["time_s"].as_f64() > Some(0.5), "{output}");

    for (arguments, why) in [
        (["nothing", "disc", "backhand"], "there is no model"),
        (
            ["ball", "disc", "backhand"],
            "the old model cannot fly the release",
        ),
        (["disc", "disc", "absent.toml"], "absent.toml"),
    ] {
        let [old, new, release] = arguments;
        let (_, error) = diff(&[old, new, "--release", release], 2);
        assert!(error.contains(why), "{arguments:?}: {error}");
    }
    let (output, _) = diff(&["disc_appendix_printed", "disc_appendix"], 1);
    assert!(output.contains("units\n  mended"), "{output}");
    let term = "I_a*(der(phidot)*sin(theta) + phidot*thetadot*cos(theta))";
    let by = format!("by der(gammadot): `-{term}` instead of `-{term}*cos(theta)`");
    assert!(output.contains(&by), "{output}");
}
