//! Sweeps in winds by height and gusts: lanes against single flights, and what varies.

use std::path::Path;

use analysis::sweep::{SweepOptions, plan, run};
use flight::release::{Vocabulary, read_in_wind};
use flight::{CompiledModel, simulate};
use ode::{IntegrationOptions, Method};

const PLATE: &str = include_str!("support/plate.hyz");
const HEAD: &str = "model = \"plate.hyz\"\nuntil = \"ground\"\n[throw]\nspeed = 20.0\nlaunch = 8.0\nheight = 1.5\nnose = 2.0\nspin = 700.0\nhyzer = 10.0\n";

fn wind(speed: f64, roughness: f64, flight: u64) -> String {
    format!(
        "[wind]\nprofile = \"log\"\nspeed = {speed:?}\ndirection = 70.0\nroughness = {roughness:?}\n[wind.gusts]\nmodel = \"dryden\"\nseed = 5\nflight = {flight}\n"
    )
}

/// Creates a temporary folder that contains a model file as a user could write it.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    // A plate whose states have the names that a landing is looked for by.
    let text = PLATE.replace("(east, north, z)", "(x, y, z)");
    std::fs::write(folder.path().join("plate.hyz"), text).expect("written");
    folder
}

/// Runs a sweep of the plan `text` and returns the values of the named columns of `flights.csv`, one vector per flight.
fn swept(folder: &Path, text: &str, names: &[&str]) -> Vec<Vec<f64>> {
    let plan = plan::read("plan.toml", text, folder).unwrap_or_else(|e| panic!("{e}"));
    let options = SweepOptions {
        threads: 2,
        share: None,
        csv: true,
        progress: &|_| {},
        is_cancelled: &|| false,
    };
    let out = folder.join("out");
    let _ = std::fs::remove_dir_all(&out);
    run(&plan, &out, &options).expect("a sweep");
    let csv = std::fs::read_to_string(out.join("flights.csv")).expect("a table");
    let mut lines = csv.lines();
    let head: Vec<&str> = lines.next().expect("a head").split(',').collect();
    let columns = names
        .iter()
        .map(|name| head.iter().position(|own| own == name).expect(name));
    let columns: Vec<usize> = columns.collect();
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        columns
            .iter()
            .map(|k| cells[*k].parse().unwrap_or(f64::NAN))
            .collect()
    };
    lines.map(row).collect()
}

#[test]
fn lanes_with_gusts_of_their_own_are_the_single_flights() {
    let folder = folder();
    let text = format!(
        "{HEAD}{}[vary]\nwind_speed = {{ values = [0.0, 3.0, 6.0] }}\nwind_roughness = {{ values = [0.01, 0.3] }}\ngusts = true\n",
        wind(4.0, 0.03, 0)
    );
    let text = format!("flights = 2\ntolerance = 1e-12\nmethod = \"dop853\"\n{text}");
    let names = [
        "wind_speed",
        "wind_roughness",
        "landing_t",
        "landing_x",
        "landing_y",
    ];
    let rows = swept(folder.path(), &text, &names);
    assert_eq!(rows.len(), 12);
    let model = std::fs::read_to_string(folder.path().join("plate.hyz")).expect("the model");
    let model = model_spec::load::from_text("plate.hyz", &model, &[]).expect("a model");
    let options = IntegrationOptions {
        method: Method::Dop853,
        ..IntegrationOptions::with_tolerance(1e-12)
    };
    let mut apart = f64::INFINITY;
    for (flight, row) in rows.iter().enumerate() {
        let text = format!("{HEAD}{}", wind(row[0], row[1], flight as u64));
        let names = |_: &str| Ok(Vocabulary::of(&model));
        let (release, names) = read_in_wind("r.toml", &text, &[], names).expect("a release");
        let model = names.model.expect("a model");
        let compiled = CompiledModel::with_derivatives_by(&model, Vec::new());
        let single = simulate(&compiled, &release, &options).expect("a flight");
        let found = [row[2], row[3], row[4]];
        let expected = [single.end, single.end_state[0], single.end_state[1]];
        for k in 0..3 {
            assert!(
                (found[k] - expected[k]).abs() < 1e-9,
                "{flight} {found:?} {expected:?}"
            );
        }
        // Of one speed and roughness, six flights further: the gusts differ.
        if let Some(other) = rows.get(flight + 6).filter(|_| row[0] > 0.0) {
            apart = apart.min((other[3] - row[3]).hypot(other[4] - row[4]));
        }
    }
    assert!(apart > 0.01, "{apart}");
}

#[test]
fn gusts_are_those_of_the_seed() {
    let folder = folder();
    let of = |seed: u64| {
        let text = format!(
            "flights = 3\n{HEAD}{}[vary]\ngusts = true\nwind_direction = {{ sd = 5.0 }}\ngust_intensity = {{ uniform = [0.5, 1.5] }}\n",
            wind(4.0, 0.03, 0)
        );
        let text = text.replace("seed = 5", &format!("seed = {seed}"));
        swept(
            folder.path(),
            &text,
            &["wind_direction", "gust_intensity", "landing_x"],
        )
    };
    let (first, again, other) = (of(5), of(5), of(6));
    assert_eq!(first, again);
    for (a, b) in first.iter().zip(&other) {
        // The seed of the plan draws the rest.
        assert!(a[..2] == b[..2] && a[2] != b[2]);
        assert!(
            (40.0..100.0).contains(&a[0]) && (0.5..1.5).contains(&a[1]),
            "{a:?}"
        );
    }
}

#[test]
fn faults_of_what_varies_have_their_place() {
    let folder = folder();
    for (vary, words) in [
        ("gusts = 3", "expected true"),
        (
            "wind_exponent = { sd = 0.1 }",
            "found nothing called \"wind_exponent\"",
        ),
        (
            "wind_roughness = { values = [-1.0] }",
            "expected a number from 0.000001 to 10",
        ),
    ] {
        let text = format!("flights = 3\n{HEAD}{}[vary]\n{vary}\n", wind(4.0, 0.03, 0));
        let error = plan::read("plan.toml", &text, folder.path())
            .err()
            .expect(vary)
            .to_string();
        assert!(
            error.contains(words) && error.contains("plan.toml:21:"),
            "{error}"
        );
        // No list of phases.
        assert!(error.len() < 1500, "{error}");
    }
    let text = format!("flights = 3\n{HEAD}[vary]\ngusts = true\n");
    let error = plan::read("plan.toml", &text, folder.path())
        .err()
        .expect("a fault")
        .to_string();
    assert!(error.contains("no [wind.gusts]"), "{error}");
}
