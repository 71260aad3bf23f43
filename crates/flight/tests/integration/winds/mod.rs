//! Winds by height and gusts: against their formulae, in the air that moves, and as files state them.

mod files;
mod formulae;
mod gusts;
mod moving_air;
mod vector_mechanics;

use flight::CompiledModel;
use flight::release::{Release, Vocabulary, read_in_wind};
use model_spec::model::Model;
use ode::{IntegrationOptions, Method};

const PLATE: &str = include_str!("../../../../analysis/tests/integration/support/plate.hyz");

/// Names of built-in models, and of the test model `plate`, which names no velocity of the air `air`.
const MODELS: [&str; 6] = [
    "ball",
    "disc",
    "disc_appendix",
    "disc_quaternion",
    "discus",
    "plate",
];

/// The built-in model of this name, or the test model `plate`.
fn model(name: &str) -> Model {
    match name {
        "plate" => model_spec::load::from_text("plate.hyz", PLATE, &[]).expect("the plate"),
        _ => model_spec::load::load(name, &[]).expect("a model"),
    }
}

/// Release read from a TOML text, and the model with the wind of the release added.
fn released(text: &str) -> (Release, Model) {
    let names = |name: &str| Ok(Vocabulary::of(&model(name)));
    let (release, names) =
        read_in_wind("r.toml", text, &[], names).unwrap_or_else(|e| panic!("{e}\n{text}"));
    (release, Model::clone(&names.model.expect("the model")))
}

/// TOML text of a release for the model `name`, without the table `[wind]`; `until` is the line that specifies the end
/// of the flight.
fn throw(name: &str, until: &str) -> String {
    let thrown = |name: &str, more: &str| {
        format!(
            "model = {name:?}\n{until}\n[throw]\nspeed = 20.0\nlaunch = 8.0\nheight = 1.5\n{more}"
        )
    };
    let spinning = "nose = 2.0\nspin = 700.0\nhyzer = 10.0\n";
    match name {
        "ball" => thrown(name, ""),
        // A model without a body, whose states are those of the disc.
        "disc_appendix" => {
            let (disc, _) = released(&thrown("disc", spinning));
            let states = disc.initial.iter();
            let states: String = states
                .map(|(state, x)| format!("{state} = {x:?}\n"))
                .collect();
            format!("model = {name:?}\n{until}\n[initial]\n{states}")
        }
        _ => thrown(name, spinning),
    }
}

fn tight() -> IntegrationOptions {
    IntegrationOptions {
        method: Method::Dop853,
        ..IntegrationOptions::with_tolerance(1e-12)
    }
}

/// The model, compiled without derivatives with respect to parameters, which takes less time.
fn compiled(model: &Model) -> CompiledModel {
    CompiledModel::with_derivatives_by(model, Vec::new())
}

/// Components of a named vector of the model at a time and state, in the frame in which the model defines the vector.
fn vector(model: &Model, parameters: &[f64], name: &str, t: f64, state: &[f64]) -> [f64; 3] {
    let observing = CompiledModel::observing(model, name, Vec::new()).expect("a quantity");
    let bound = observing.bind(parameters.to_vec());
    bound.observer().position(t, state, &[0.0; 3])
}

#[test]
fn every_model_flies_in_every_wind() {
    const WINDS: [&str; 5] = [
        "[wind]\nprofile = \"log\"\nspeed = 4.0\ndirection = 30.0",
        "[wind]\nprofile = \"power\"\nspeed = 4.0\ndirection = 30.0",
        "[wind]\ntable = [[0.5, 1.0, 0.0, 0.0], [2.0, 2.5, 0.5, 0.0], [8.0, 4.0, 0.0, 0.0]]",
        "[wind]\nprofile = \"log\"\nspeed = 4.0\n[wind.gusts]\nmodel = \"dryden\"\nseed = 7",
        "[wind]\nconstant = [3.0, 1.0, 0.0]\n[wind.gusts]\nmodel = \"dryden\"\nseed = 7\nsd = [1.0, 1.0, 0.5]\nlength = [20.0, 20.0, 3.0]",
    ];
    for name in MODELS {
        let end = |text: &str| {
            let (release, model) = released(text);
            let options = IntegrationOptions::with_tolerance(1e-8);
            let flight = flight::simulate(&compiled(&model), &release, &options);
            flight.unwrap_or_else(|e| panic!("{name}: {e}")).end_state
        };
        let release = throw(name, "until = \"ground\"");
        let still = end(&release);
        for wind in WINDS {
            let moved = end(&format!("{release}{wind}\n"));
            let by = (moved[0] - still[0]).hypot(moved[1] - still[1]);
            assert!(by > 0.05, "{name} {wind} {by}");
        }
    }
}

#[test]
fn a_wind_that_is_the_same_at_all_heights_is_the_constant_one() {
    for name in MODELS {
        let end = |wind: &str| {
            let text = format!("{}[wind]\n{wind}\n", throw(name, "duration = 1.2"));
            let (release, model) = released(&text);
            let flight = flight::simulate(&compiled(&model), &release, &tight());
            flight.unwrap_or_else(|e| panic!("{name}: {e}")).end_state
        };
        let constant = end("constant = [3.0, -2.0, 0.4]");
        for same in [
            "table = [[0.0, 3.0, -2.0, 0.4], [9.0, 3.0, -2.0, 0.4]]".to_owned(),
            format!(
                "profile = \"power\"\nexponent = 0.0\nspeed = {:?}\ndirection = {:?}",
                3f64.hypot(-2.0),
                f64::atan2(-2.0, 3.0).to_degrees()
            ),
        ] {
            let flown = end(&same);
            let constant = match same.contains("table") {
                true => constant.clone(),
                false => end("constant = [3.0, -2.0, 0.0]"),
            };
            for (a, b) in flown.iter().zip(&constant) {
                let size = b.abs().max(1.0);
                assert!((a - b).abs() < 1e-8 * size, "{name} {same} {a} {b}");
            }
        }
    }
}
