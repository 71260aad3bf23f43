//! Winds by height and gusts: against their formulae, in the air that moves, and as they are read.

use flight::release::{Release, Vocabulary, read_in_wind};
use flight::wind::{GUST_TERMS, gust_phases, gust_spectrum};
use flight::{CompiledModel, simulate};
use model_spec::model::Model;
use ode::IntegrationOptions;

const PLATE: &str = include_str!("../../design/tests/support/plate.hyz");

/// A built-in model, or the user's plate.
fn model(name: &str) -> Model {
    match name {
        "plate" => model_spec::load::from_text("plate.hyz", PLATE, &[]).expect("the plate"),
        _ => model_spec::load::load(name, &[]).expect("a model"),
    }
}

/// A release in its wind, with the model that flies it.
fn released(text: &str) -> (Release, Model) {
    let (release, names) = read_in_wind("r.toml", text, &[], |name| Ok(Vocabulary::of(&model(name))))
        .unwrap_or_else(|e| panic!("{e}\n{text}"));
    let model = names.model.expect("the model");
    (release, Model::clone(&model))
}

/// A release of the model to the ground, without `[wind]`.
fn throw(name: &str) -> String {
    let thrown = |name: &str, more: &str| {
        format!("model = {name:?}\nuntil = \"ground\"\n[throw]\nspeed = 20.0\nlaunch = 8.0\nheight = 1.5\n{more}")
    };
    let spinning = "nose = 2.0\nspin = 700.0\nhyzer = 10.0\n";
    match name {
        "ball" => thrown(name, ""),
        // A model without a body, whose states are those of the disc.
        "disc_appendix" => {
            let (disc, _) = released(&thrown("disc", spinning));
            let states = disc.initial.iter().map(|(state, x)| format!("{state} = {x:?}\n"));
            let states: String = states.collect();
            format!("model = {name:?}\nuntil = \"ground\"\n[initial]\n{states}")
        }
        _ => thrown(name, spinning),
    }
}

const MODELS: [&str; 6] = ["ball", "disc", "disc_appendix", "disc_quaternion", "discus", "plate"];

#[test]
fn every_model_flies_in_every_wind() {
    let winds = [
        "[wind]\nprofile = \"log\"\nspeed = 4.0\ndirection = 30.0",
        "[wind]\nprofile = \"power\"\nspeed = 4.0\ndirection = 30.0",
        "[wind]\ntable = [[0.5, 1.0, 0.0, 0.0], [2.0, 2.5, 0.5, 0.0], [8.0, 4.0, 0.0, 0.0]]",
        "[wind]\nprofile = \"log\"\nspeed = 4.0\n[wind.gusts]\nmodel = \"dryden\"\nseed = 7",
        "[wind]\nconstant = [3.0, 1.0, 0.0]\n[wind.gusts]\nmodel = \"dryden\"\nseed = 7\nsd = [1.0, 1.0, 0.5]\nlength = [20.0, 20.0, 3.0]",
    ];
    for name in MODELS {
        let calm = released(&throw(name));
        let options = IntegrationOptions::with_tolerance(1e-8);
        let end = |(release, model): &(Release, Model)| {
            let t0 = std::time::Instant::now();
            let compiled = CompiledModel::with_derivatives_by(model, Vec::new());
            let t1 = t0.elapsed();
            let x = simulate(&compiled, release, &options).expect("it flies");
            println!("{name} compile {t1:?} {:?} steps {}", t0.elapsed(), x.stats.steps);
            x.end_state
        };
        let still = end(&calm);
        for wind in winds {
            let moved = end(&released(&format!("{}{wind}\n", throw(name))));
            let by = (moved[0] - still[0]).hypot(moved[1] - still[1]);
            assert!(by > 0.05, "{name} {wind} {by}");
        }
    }
}
