//! Winds by height and gusts by the commands: `--wind FILE`, `[wind]` of releases, and who refuses them.

use crate::support::{hyzer, told};

const GUSTY: &str = "examples/throws/gusty.toml";

/// Runs `hyzer` with the arguments; returns its exit status, standard output and standard error.
fn run(arguments: &[&str]) -> (i32, String, String) {
    told(hyzer().args(arguments))
}

#[test]
fn the_example_is_flown_and_its_wind_can_be_anothers() {
    let (status, by_file, errors) = run(&["simulate", "--release", GUSTY]);
    assert_eq!(status, 0, "{errors}");
    let throw = [
        "simulate", "disc", "--speed", "20", "--launch", "8", "--nose", "2", "--hyzer", "10",
        "--spin", "700", "--height", "1.5",
    ];
    let with = |more: &[&str]| run(&[&throw, more].concat());
    let (status, by_option, errors) = with(&["--wind", GUSTY]);
    assert_eq!(status, 0, "{errors}");
    assert_eq!(by_file, by_option);
    let (_, calm, _) = with(&[]);
    let (_, stronger, _) = with(&["--wind", GUSTY, "--set", "wind_speed=6"]);
    let (_, still, _) = with(&["--wind", GUSTY, "--set", "wind_speed=0"]);
    let range = |text: &str| {
        let line = text
            .lines()
            .find(|line| line.contains("range"))
            .expect("a range");
        line.to_owned()
    };
    assert!(range(&calm) != range(&by_file) && range(&stronger) != range(&by_file));
    // Gusts of the low-altitude model vanish with the wind.
    assert_eq!(range(&still), range(&calm));
}

#[test]
fn contradictions_and_what_is_not_flown_are_refused() {
    for (arguments, words) in [
        (
            &["simulate", "--release", GUSTY, "--wind", "1,2,3"][..],
            "expected only one wind",
        ),
        (
            &["simulate", "disc", "--speed", "20", "--wind", "absent.toml"],
            "a TOML file with [wind]",
        ),
        (
            &[
                "simulate",
                "disc",
                "--speed",
                "20",
                "--wind",
                "examples/throws/backhand.toml",
            ],
            "found no [wind]",
        ),
        (
            &["stability", "disc", "--release", GUSTY],
            "expected only a constant wind here",
        ),
        (
            &["simulate", "--release", GUSTY, "--set", "wind_speed=-1"],
            "expected a number from 0 to 100",
        ),
    ] {
        let (status, _, errors) = run(arguments);
        assert!(
            status == 2 && errors.contains(words),
            "{arguments:?} {status} {errors}"
        );
    }
}

#[test]
fn a_constant_wind_that_a_model_cannot_feel_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let stone = folder.path().join("stone.hyz");
    let text = "model stone;\nparam m = 1 kg;\nframe N;\npoint stone {\n  mass m;\n  position (x, y, z) in N;\n  velocity (u, v, w) in N;\n}\nforce weight = -m*9.81 [m/s^2]*N.3;\n";
    std::fs::write(&stone, text).expect("written");
    let stone = stone.to_str().expect("a name");
    let thrown = ["simulate", stone, "--speed", "5", "--wind"];
    let (status, _, errors) = run(&[&thrown[..], &["1,0,0"]].concat());
    assert!(
        status == 2 && errors.contains("no input `wind`"),
        "{errors}"
    );
    let (status, _, errors) = run(&[&thrown[..], &["0,0,0"]].concat());
    assert_eq!(status, 0, "{errors}");
    let release = folder.path().join("throw.toml");
    let text = format!(
        "model = {stone:?}\nuntil = \"ground\"\n[throw]\nspeed = 5.0\n[wind]\nconstant = [1.0, 0.0, 0.0]\n"
    );
    std::fs::write(&release, text).expect("written");
    let (status, _, errors) = run(&["simulate", "--release", release.to_str().expect("a name")]);
    let is_placed = errors.contains("throw.toml:5") && errors.contains("no input `wind`");
    assert!(status == 2 && is_placed, "{errors}");
}

#[test]
fn the_plan_of_the_page_on_wind_is_flown() {
    let page = std::fs::read_to_string("docs/how-to/wind.md").expect("the page");
    let mut blocks = page.split("```toml\n").skip(1);
    let blocks = blocks.find_map(|part| {
        let block = part.split("```").next()?;
        block.contains("[vary]").then_some(block)
    });
    let plan = blocks.expect("a plan");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("plan.toml");
    std::fs::write(&path, plan.replace("flights = 2000", "flights = 20")).expect("written");
    let out = folder.path().join("swept");
    let (path, out_text) = (path.display().to_string(), out.display().to_string());
    let (status, _, errors) = run(&["sweep", &path, "--out", &out_text]);
    assert_eq!(status, 0, "{errors}");
    let summary = std::fs::read_to_string(out.join("summary.json")).expect("a summary");
    let summary: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
    for column in [
        "wind_speed",
        "wind_direction",
        "gust_intensity",
        "landing_x",
    ] {
        assert!(
            summary["columns"][column]["mean"].is_f64(),
            "{column} {summary}"
        );
    }
}
