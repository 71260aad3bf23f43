//! Profiles against their formulae, by the model's own quantity.

use super::{compiled, model, released, vector};
use flight::CompiledModel;

const BALL: &str = "model = \"ball\"\nduration = 1.0\n[throw]\nspeed = 1.0\n";
const HEIGHTS: [f64; 16] = [
    -100.0, -1.0, -0.02, -1e-9, 0.0, 1e-9, 0.003, 0.03, 0.1, 0.3, 0.999, 1.0, 2.0, 7.5, 10.0, 120.0,
];

/// Mean wind, m/s, at the given heights, m, for the text `table` of the TOML table `[wind]`.
fn winds(table: &str, heights: &[f64]) -> Vec<[f64; 3]> {
    let (release, model) = released(&format!("{BALL}[wind]\n{table}"));
    let parameters = compiled(&model).release_parameters(&release).constants;
    let observing = CompiledModel::observing(&model, "wind_of_profile", Vec::new());
    let observing = observing.expect("a wind");
    let bound = observing.bind(parameters);
    let mut observer = bound.observer();
    let at = |z: &f64| observer.position(0.0, &[3.0, -2.0, *z, 1.0, 0.0, 0.0], &[0.0; 3]);
    heights.iter().map(at).collect()
}

/// Component of the wind along a horizontal direction, deg; panics if the component across that direction is not 0.
fn along(wind: [f64; 3], direction: f64) -> f64 {
    let (sin, cos) = f64::to_radians(direction).sin_cos();
    assert!((cos * wind[1] - sin * wind[0]).abs() < 1e-14 && wind[2] == 0.0);
    cos * wind[0] + sin * wind[1]
}

#[test]
fn the_logarithmic_law() {
    let (speed, direction, h, z0) = (4.0, 30.0, 6.0, 0.02_f64);
    let table = format!(
        "profile = \"log\"\nspeed = {speed}\ndirection = {direction}\nreference_height = {h:?}\nroughness = {z0:?}\n"
    );
    for (z, wind) in HEIGHTS.iter().zip(winds(&table, &HEIGHTS)) {
        let wind = along(wind, direction);
        let form = |z: f64| (1.0 + (z.max(0.0) / z0).powi(2)).ln();
        let expected = speed * form(*z) / form(h);
        assert!((wind - expected).abs() < 1e-13, "{z} {wind} {expected}");
        if *z <= 0.0 {
            assert_eq!(wind, 0.0, "{z}");
        }
        // The textbook's law, well above the roughness.
        if *z >= 10.0 * z0 {
            let law = speed * (z / z0).ln() / (h / z0).ln();
            assert!((wind - law).abs() < 0.003 * law, "{z} {wind} {law}");
        }
    }
}

#[test]
fn the_power_law() {
    let (speed, direction, h, n) = (5.0, -120.0, 10.0, 0.2_f64);
    let table = format!(
        "profile = \"power\"\nspeed = {speed}\ndirection = {direction}\nreference_height = {h:?}\nexponent = {n:?}\n"
    );
    let ground = along(winds(&table, &[0.0])[0], direction);
    assert!((ground - speed * (0.05_f64 / h).powf(n)).abs() < 1e-3);
    for (z, wind) in HEIGHTS.iter().zip(winds(&table, &HEIGHTS)) {
        let wind = along(wind, direction);
        let form = |z: f64| (z.max(0.0).powi(2) + 0.0025).powf(n / 2.0);
        let expected = speed * form(*z) / form(h);
        assert!((wind - expected).abs() < 1e-13, "{z} {wind} {expected}");
        if *z <= 0.0 {
            assert!((wind - ground).abs() < 1e-15, "{z}");
        }
        if *z >= 0.3 {
            let law = speed * (z / h).powf(n);
            assert!((wind - law).abs() < 0.003 * law, "{z} {wind} {law}");
        }
    }
}

#[test]
fn a_table_is_met_smooth_and_monotone() {
    let rows = [
        [0.5, 1.0, 0.0, 0.2],
        [2.0, 2.5, -1.0, 0.2],
        [3.0, 2.6, -3.0, 0.2],
        [9.0, 6.0, 1.0, 0.2],
    ];
    let table = format!("table = {rows:?}\n");
    let of_row =
        |wind: &[f64; 3], row: &[f64; 4]| (0..3).all(|k| (wind[k] - row[k + 1]).abs() < 1e-13);
    let at = |z: f64| winds(&table, &[z])[0];
    for row in &rows {
        assert!(of_row(&at(row[0]), row), "{row:?}");
    }
    for (z, row) in [(-50.0, 0), (0.0, 0), (0.499, 0), (9.001, 3), (400.0, 3)] {
        assert!(of_row(&at(z), &rows[row]), "{z}");
    }
    let heights: Vec<f64> = (0..2000).map(|k| 0.005 * f64::from(k)).collect();
    let all = winds(&table, &heights);
    let mut slope = 0.0;
    for pair in all.windows(2) {
        // The first component only grows, the third is constant.
        assert!(pair[1][0] >= pair[0][0] - 1e-13 && (pair[1][2] - 0.2).abs() < 1e-13);
        // The derivative has no jump: over 5 mm it changes by what the greatest second derivative allows.
        let next = (pair[1][0] - pair[0][0]) / 0.005;
        assert!(f64::abs(next - slope) < 0.04, "{next} {slope}");
        slope = next;
    }
}

#[test]
fn a_table_of_one_law_is_that_law_between_its_heights() {
    let z0 = 0.03_f64;
    let law = |z: f64| 4.0 * (z / z0).ln() / (10.0 / z0).ln();
    let heights: Vec<f64> = (0..40).map(|k| 0.5 * 1.08_f64.powi(k)).collect();
    let rows: Vec<[f64; 4]> = heights.iter().map(|z| [*z, law(*z), 0.0, 0.0]).collect();
    let between: Vec<f64> = heights
        .windows(2)
        .map(|z| 0.4 * z[0] + 0.6 * z[1])
        .collect();
    let all = winds(&format!("table = {rows:?}\n"), &between);
    // Away from the ends, where the slope is 0.
    for (z, wind) in between.iter().zip(&all).skip(1).take(37) {
        assert!((wind[0] - law(*z)).abs() < 1e-4, "{z} {wind:?}");
    }
}

#[test]
fn the_air_of_the_model_is_the_sum() {
    let wind =
        "[wind]\nprofile = \"log\"\nspeed = 4.0\n[wind.gusts]\nmodel = \"dryden\"\nseed = 7\n";
    let (release, model) = released(&format!("{BALL}{wind}"));
    let parameters = compiled(&model).release_parameters(&release).constants;
    let state = [5.0, 1.0, 2.0, 10.0, 0.0, 1.0];
    let of = |name: &str| vector(&model, &parameters, name, 0.4, &state);
    let (air, mean, gust) = (of("air"), of("wind_of_profile"), of("gust_velocity"));
    for k in 0..3 {
        assert!((air[k] - mean[k] - gust[k]).abs() < 1e-14, "{air:?}");
        assert!(gust[k].abs() > 1e-3, "{gust:?}");
    }
}

#[test]
fn winds_are_no_candidates_of_a_diagnosis() {
    let disc = model("disc");
    let known = model_spec::compose::ModelTree::of(&disc);
    for (name, _) in model_spec::load::WINDS {
        assert!(known.find_effect(name).is_err(), "{name}");
    }
}
