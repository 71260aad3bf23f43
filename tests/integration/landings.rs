//! The page and the map of `hyzer sweep`.

use std::path::Path;

use crate::support::{hyzer, told};

fn sweep(out: &Path, options: &[&str]) -> (i32, String, String) {
    let mut command = hyzer();
    command.args(["sweep", "backhands", "--out"]).arg(out);
    told(command.args(options))
}

#[test]
fn landings_are_on_the_page_and_on_a_map() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("swept");
    let options = ["--kml", "47.5,8.5,90", "--units", "imperial"];
    let (status, text, errors) = sweep(&out, &options);
    assert_eq!(status, 0, "{errors}");
    assert!(text.contains("landing_x, ft"), "{text}");
    let read = |name: &str| std::fs::read_to_string(out.join(name)).expect(name);
    let page = read("report.html");
    assert!(page.contains("id=\"landings\"") && page.contains("landing_x, m"));
    let summary: serde_json::Value = serde_json::from_str(&read("summary.json")).expect("JSON");
    let column = &summary["columns"]["landing_x"];
    let (mean, sd) = (column["mean"].as_f64(), column["sd"].as_f64());
    let (mean, sd) = mean.zip(sd).expect("numbers");
    let map = read("landings.kml");
    let points = map.split("<Point><coordinates>").skip(1);
    let longitudes = points.map(|part| part.split(',').next().and_then(|own| own.parse().ok()));
    let longitudes: Vec<f64> = longitudes.map(|own| own.expect("a longitude")).collect();
    // A metre to the east is 1.33e-5 deg at this latitude. The origin and the mean come before the landings.
    let metres = |longitude: f64| (longitude - 8.5) / 1.33e-5;
    assert!((metres(longitudes[1]) - mean).abs() < 0.01 * sd, "{mean}");
    // Some 2,000 of the 6,000, of all three points of the grid of winds.
    let drawn = &longitudes[2..];
    assert!((1800..2200).contains(&drawn.len()), "{}", drawn.len());
    let of_drawn = drawn.iter().map(|own| metres(*own)).sum::<f64>() / drawn.len() as f64;
    assert!((of_drawn - mean).abs() < 0.1 * sd, "{of_drawn} {mean} {sd}");
}

#[test]
fn a_place_that_is_none_is_refused_before_any_flight() {
    let folder = tempfile::tempdir().expect("a folder");
    for (place, expected) in [("91,0", "a latitude"), ("47", "LAT,LON")] {
        let out = folder.path().join("none");
        let (status, _, errors) = sweep(&out, &["--kml", place]);
        assert_eq!(status, 2, "{errors}");
        assert!(
            errors.contains("--kml") && errors.contains(expected),
            "{errors}"
        );
        assert!(!out.exists());
    }
}
