//! `hyzer simulate` of throws: by options, from `[throw]`, from a launch monitor's table; and of values that would have no influence.

use std::path::Path;

use crate::support::examples::the_examples_run;
use crate::support::{hyzer, told};

const TECHDISC: &str = "examples/throws/techdisc.csv";

#[test]
fn a_coach_throws_in_miles_per_hour_and_reads_feet() {
    let (text, imperial) = flown(&[
        "disc",
        "--speed",
        "45",
        "--height",
        "5",
        "--spin",
        "700",
        "--wind=10,0,0",
        "--units",
        "imperial",
    ]);
    let [speed, height, wind] =
        [45.0 * 0.44704, 5.0 * 0.3048, 10.0 * 0.44704].map(|v| v.to_string());
    let wind = format!("--wind={wind},0,0");
    let (metric, si) = flown(&[
        "disc", "--speed", &speed, "--height", &height, "--spin", "700", &wind,
    ]);
    // Files are in SI, whatever is printed.
    assert_eq!(imperial, si);
    let feet = si["range_m"].as_f64().expect("a number") / 0.3048;
    assert!(text.contains(&format!("range {feet:.2} ft")), "{text}");
    assert!(
        text.contains("speed, mph") && !text.contains("m/s"),
        "{text}"
    );
    assert!(
        metric.contains("speed, m/s") && !metric.contains("mph"),
        "{metric}"
    );
    let mut wrong = hyzer();
    let (status, _, errors) =
        told(wrong.args(["simulate", "disc", "--speed", "fast", "--units", "imperial"]));
    assert!(
        status == 2 && errors.contains("a number in mph"),
        "{errors}"
    );
}

#[test]
fn the_examples_of_its_help_run() {
    the_examples_run("simulate", 6, "flight");
}

fn summary(folder: &Path) -> serde_json::Value {
    let text = std::fs::read_to_string(folder.join("summary.json")).expect("a summary");
    serde_json::from_str(&text).expect("JSON")
}

/// Runs `hyzer simulate` with an output folder, and asserts that it succeeds. Returns the printed text and the summary
/// from `summary.json`.
fn flown(arguments: &[&str]) -> (String, serde_json::Value) {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let mut command = hyzer();
    command
        .arg("simulate")
        .args(arguments)
        .arg("--out")
        .arg(&out);
    let (status, text, errors) = told(&mut command);
    assert_eq!(status, 0, "{errors}");
    (text, summary(&out))
}

fn close(value: &serde_json::Value, expected: f64) {
    let value = value.as_f64().expect("a number");
    assert!((value - expected).abs() < 1e-6, "{value} {expected}");
}

#[test]
fn a_level_throw_may_wobble() {
    // The length of the quaternion, which the motion does not depend on, is one state at a level attitude.
    let level = ["disc_quaternion", "--speed", "14", "--spin", "700"];
    let (_, summary) = flown(&[&level[..], &["--wobble", "3"]].concat());
    close(&summary["release"]["wobble_deg"], 3.0);
}

#[test]
fn a_throw_by_options_is_that_of_the_file() {
    let (by_file, summary) = flown(&["--release", "examples/throws/backhand.toml"]);
    let by_options = flown(&[
        "disc", "--speed", "20", "--launch", "8", "--nose", "2", "--hyzer", "10", "--spin", "700",
        "--height", "1.5", "--wobble", "2",
    ]);
    assert_eq!(by_file, by_options.0);
    assert_eq!(summary, by_options.1);
    assert_eq!(summary["schema"], "hyzer.flight/1");
    assert_eq!(summary["ended_by"], "ground");
    let release = &summary["release"];
    for (name, expected) in [
        ("speed_m_s", 20.0),
        ("heading_deg", 0.0),
        ("launch_deg", 8.0),
        ("nose_deg", 2.0),
        ("hyzer_deg", 10.0),
        ("spin_rpm", 700.0),
        ("height_m", 1.5),
        ("wobble_deg", 2.0),
    ] {
        close(&release[name], expected);
    }
    close(&summary["landing_m"][2], 0.0);
    let [least, greatest] = ["least", "greatest"].map(|k| summary["alpha_deg"][k].as_f64());
    assert!(least < Some(2.0) && greatest > Some(2.0), "{summary}");
    assert!(
        by_file.contains("range ") && by_file.contains("spin, rpm"),
        "{by_file}"
    );
}

#[test]
fn options_win_over_the_release_and_leave_the_rest() {
    let (_, before) = flown(&["--release", "examples/throws/backhand.toml"]);
    let (_, after) = flown(&[
        "--release",
        "examples/throws/backhand.toml",
        "--hyzer",
        "-5",
    ]);
    close(&after["release"]["hyzer_deg"], -5.0);
    for name in [
        "speed_m_s",
        "nose_deg",
        "launch_deg",
        "spin_rpm",
        "wobble_deg",
        "height_m",
    ] {
        close(
            &after["release"][name],
            before["release"][name].as_f64().expect("a number"),
        );
    }
    // A release of states too.
    let (_, own) = flown(&["--release", "backhand", "--speed", "15"]);
    close(&own["release"]["speed_m_s"], 15.0);
    close(&own["release"]["height_m"], 0.913);
}

#[test]
fn a_point_mass_has_no_angles() {
    let (text, ball) = flown(&["ball", "--speed", "12", "--launch", "30"]);
    assert!(
        ball["release"]["nose_deg"].is_null() && ball["alpha_deg"].is_null(),
        "{ball}"
    );
    assert!(!text.contains("spin, rpm"), "{text}");
    let (status, _, errors) =
        told(hyzer().args(["simulate", "ball", "--speed", "12", "--nose", "3"]));
    assert_eq!(status, 2);
    assert!(
        errors.contains("--nose") && errors.contains("point mass"),
        "{errors}"
    );
}

#[test]
fn a_component_of_a_vector_input_is_set_by_its_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let release = folder.path().join("drive.toml");
    let text = "model = \"golf_ball\"\nuntil = \"ground\"\n[throw]\nspeed = 60.0\nlaunch = 12.0\n[wind]\n\
        constant = [0.0, 3.0, 0.0]\n[known]\nomega = [0.0, -280.0, 0.0]\n";
    std::fs::write(&release, text).expect("written");
    let (_, stated) = flown(&["--release", &release.to_string_lossy()]);
    let sets = ["--set", "omega_y=-280", "--set", "wind_y=3"];
    let (_, set) = flown(&[&["golf_ball", "--speed", "60", "--launch", "12"][..], &sets].concat());
    assert_eq!(stated["landing_m"], set["landing_m"]);
}

#[test]
fn a_state_that_a_throw_determines_is_not_set() {
    for (name, is_kept) in [("x", true), ("z", false), ("u", false), ("C_D0", true)] {
        let set = format!("{name}=0.2");
        let (status, _, errors) = told(hyzer().args([
            "simulate", "disc", "--speed", "12", "--spin", "700", "--set", &set,
        ]));
        assert_eq!(status == 0, is_kept, "{errors}");
        assert!(
            is_kept || errors.contains(&format!("the throw determines {name}")),
            "{errors}"
        );
    }
    let (status, _, errors) = told(hyzer().args(["stability", "disc", "--set", "z=3"]));
    assert_eq!(status, 2);
    assert!(errors.contains("the throw determines z"), "{errors}");
}

#[test]
fn one_row_of_a_table_is_flown_by_its_id_or_number() {
    let (by_id, id) = flown(&["disc", "--techdisc", TECHDISC, "--row", "hyzer"]);
    let (by_number, number) = flown(&["disc", "--techdisc", TECHDISC, "--row", "2"]);
    assert_eq!((&by_id, &id), (&by_number, &number));
    close(&id["release"]["speed_m_s"], 58.2 * 0.44704);
    close(&id["release"]["hyzer_deg"], 18.0);
    let (status, _, errors) =
        told(hyzer().args(["simulate", "disc", "--techdisc", TECHDISC, "--row", "9"]));
    assert_eq!(status, 2);
    assert!(
        errors.contains("--row: found \"9\"") && errors.contains("1 to 5"),
        "{errors}"
    );
}

#[test]
fn malformed_tables_are_refused_with_their_place() {
    let head = "id,speedMph,spinRpm,launchAngle,noseAngle,hyzerAngle,wobbleAngle\n";
    let many = "a,50,700,8,1,0,1\n".repeat(1001);
    let cases = [
        (String::new(), "found no throw"),
        (head.into(), "found no throw"),
        (
            "id,spinRpm,launchAngle,noseAngle,hyzerAngle\n".into(),
            ":1: found no column speedMph or speedKmh",
        ),
        (
            "id,speedMph,launchAngle,noseAngle,hyzerAngle\n".into(),
            ":1: found no column spinRpm",
        ),
        (
            "speedMph,speedMph\n".into(),
            ":1: column 2: found speedMph again",
        ),
        (
            format!("{head}a,fast,700,8,1,0,1\n"),
            ":2: column 2: found speedMph \"fast\", expected a number",
        ),
        (
            format!("{head}a,50,700,8,1,0,1\nb,50,inf,8,1,0,1\n"),
            ":3: column 3: found spinRpm \"inf\"",
        ),
        (
            format!("{head}a,50,700,8,,0,1\n"),
            ":2: column 5: found noseAngle \"\"",
        ),
        (
            format!("{head}a,50,700,95,1,0,1\n"),
            ":2: column 4: launch is 95; expected a number from -90 to 90 deg",
        ),
        (
            format!("{head}a,0,700,8,1,0,1\n"),
            ":2: column 2: speed is 0;",
        ),
        (
            format!("{head}a,50,0,8,1,0,1\n"),
            ":2: column 7: found wobble without spin",
        ),
        (format!("{head}a,50,700\n"), ":2: found 3 cells, expected 7"),
        (format!("{head}{many}"), "found more than 1000 throws"),
        (format!("{}\n", "x,".repeat(300)), "found 301 columns"),
        (
            "speedMph,speedKmh,spinRpm,launchAngle,noseAngle,hyzerAngle\n50,50,700,8,1,0\n".into(),
            ":2: column 2: found speeds of 22.35 m/s and 13.89 m/s",
        ),
    ];
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("t.csv");
    for (text, expected) in cases {
        std::fs::write(&file, &text).expect("a file");
        let (status, _, errors) = told(hyzer().args(["simulate", "disc", "--techdisc"]).arg(&file));
        assert_eq!(status, 2, "{expected}: {errors}");
        assert!(errors.contains(expected), "{expected}: {errors}");
    }
    std::fs::write(&file, b"id,\xff\n").expect("a file");
    let (status, _, errors) = told(hyzer().args(["simulate", "disc", "--techdisc"]).arg(&file));
    assert!(status == 2 && errors.contains(":1:4: "), "{errors}");
}

#[test]
fn every_row_of_a_table_is_flown() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let mut command = hyzer();
    command
        .args([
            "simulate",
            "disc",
            "--techdisc",
            TECHDISC,
            "--height",
            "1.5",
            "--out",
        ])
        .arg(&out);
    let (status, text, errors) = told(&mut command);
    assert_eq!(status, 0, "{errors}");
    let expected = "\x20 row  id             m/s  range, m  left, m  height, m  time, s\n\
\x20   1  flat         24.59     23.15    10.52      11.25     4.16\n\
\x20   2  hyzer        26.02     28.17    18.90      10.72     3.84\n\
\x20   3  nose-up      23.42     22.48    13.28      11.20     3.89\n\
\x20   4  anhyzer      24.18     24.81    -0.05      10.61     4.84\n\
\x20   5  left-hander  24.59     23.15   -10.52      11.25     4.16\n";
    assert_eq!(text, expected);
    let results = std::fs::read_to_string(out.join("results.csv")).expect("results");
    assert_eq!(results.lines().count(), 6);
    close(&summary(&out.join("row-0003"))["release"]["nose_deg"], 7.0);
    assert!(out.join("row-0005/trajectory.csv").is_file());
}

#[test]
fn a_value_of_an_input_with_a_table_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let sled = "model sled;\nparam m = 2 kg;\ninput thrust: N = 0;\nframe N;\n\
        point sled { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }\n\
        force push = (thrust, 0, 0) in N;\n";
    let release = |thrust: &str| {
        format!(
            "model = \"sled.hyz\"\nduration = 1.0\n[initial]\nx = 0\ny = 0\nz = 1\nvx = 1\nvy = 0\nvz = 0\n[inputs]\nthrust = {thrust}\n"
        )
    };
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text);
    write("sled.hyz", sled).expect("written");
    write("number.toml", &release("1.0")).expect("written");
    write("table.toml", &release("{ t = [0, 1], value = [1, 2] }")).expect("written");
    let flown = |release: &str| {
        let mut command = hyzer();
        command.current_dir(folder.path());
        command.args([
            "simulate",
            "--release",
            release,
            "--set",
            "thrust=2",
            "--out",
            "flown",
        ]);
        told(&mut command)
    };
    let (status, _, errors) = flown("number.toml");
    assert_eq!(status, 0, "{errors}");
    let (status, _, errors) = flown("table.toml");
    assert!(
        status == 2 && errors.contains("--set: thrust has a table over time in [inputs]"),
        "{errors}"
    );
}
