//! Constants that a dataset states in another unit than the model's.

use dataset::Dataset;
use dataset::synthesize::{Plan, flights};
use flight::release::{Vocabulary, built_in, read};
use identify::{FitOptions, fit};
use model_spec::model::Model;

/// The disc, and flights of one whose mass is `times` as large.
fn thrown(times: f64) -> (Model, Dataset) {
    let text = built_in("backhand").expect("built in");
    let text = text.replace("m = 0.175", &format!("m = {}", times * 0.175));
    released("disc", &text)
}

/// A built-in model, and flights from the release `text`.
fn released(model: &str, text: &str) -> (Model, Dataset) {
    let model = model_spec::load::load(model, &[]).expect("built in");
    let release = read("release", text, |_| Ok(Vocabulary::of(&model))).expect("a release");
    let plan = Plan {
        flights: 3,
        duration: Some(0.6),
        ..Plan::default()
    };
    let made = flights(&model, &[release], &plan).expect("made");
    (model, made.dataset)
}

/// Cautions of a fit where a constant is stated, SI.
fn cautions((model, dataset): &(Model, Dataset), name: &str, value: f64) -> Vec<String> {
    let mut stated = dataset.clone();
    stated.parameters.insert(name.into(), value);
    let found = fit(model, &stated, &FitOptions::default()).expect("a fit");
    found.report.cautions
}

#[test]
fn a_mass_in_grams_is_told_and_a_heavy_body_is_not() {
    let told = cautions(&thrown(1.0), "m", 175.0);
    assert!(
        told[0].contains("m is stated as 175\u{a0}kg, 1000 times the"),
        "{told:?}"
    );
    let heavy = cautions(&thrown(60.0), "m", 60.0 * 0.175);
    assert!(
        heavy.iter().all(|why| !why.contains("is stated as")),
        "{heavy:?}"
    );
}

#[test]
fn gravity_in_feet_is_told_where_the_positions_are_in_feet_too() {
    let (model, mut dataset) = released("ball", built_in("serve").expect("built in"));
    let rows = dataset
        .flights
        .iter_mut()
        .flat_map(|own| &mut own.positions);
    for coordinate in rows.flatten().flatten().flatten() {
        *coordinate *= 3.2808;
    }
    let told = cautions(&(model, dataset), "g", 32.174);
    assert!(told[0].contains("g is stated as 32.2"), "{told:?}");
}

#[test]
fn a_coefficient_that_is_held_at_a_value_that_the_data_contradict_is_told() {
    let (model, dataset) = released("ball", built_in("serve").expect("built in"));
    let drag = model.coefficients.iter().find(|own| own.name == "C_D");
    let drag = drag.expect("a coefficient").value;
    let told = |times: f64| {
        let options = FitOptions {
            fixed: &[("C_D".to_owned(), Some(times * drag))],
            ..FitOptions::default()
        };
        fit(&model, &dataset, &options)
            .expect("a fit")
            .report
            .conflicts()
    };
    assert_eq!(told(1.0), [""; 0]);
    let told = told(1.3);
    assert!(told.len() == 1 && told[0].contains("C_D"), "{told:?}");
}
