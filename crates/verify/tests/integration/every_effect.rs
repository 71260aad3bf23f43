//! Every check holds of every model with every effect of the catalogue switched on.

use crate::support::{QUICK, refuted};
use model_spec::load::{EFFECTS, inspect, load};
use verify::Options;

const MODELS: [&str; 4] = ["disc", "disc_quaternion", "discus", "ball"];

fn verified(model: &str, effects: &[&str], options: &Options) {
    let with = inspect(model, effects).expect("a text");
    let report = verify::run(&with, options);
    assert!(
        refuted(&report).is_empty(),
        "{effects:?}\n{}",
        report.table()
    );
}

#[test]
fn a_model_with_an_effect_is_verified() {
    let options = Options { cases: 8, ..QUICK };
    for (name, _) in EFFECTS {
        for model in MODELS.iter().filter(|model| load(model, &[name]).is_ok()) {
            verified(model, &[name], &options);
        }
    }
}

#[test]
fn a_model_with_all_effects_is_verified() {
    for model in MODELS {
        let names = EFFECTS.iter().map(|(name, _)| *name);
        let names: Vec<&str> = names.filter(|name| load(model, &[name]).is_ok()).collect();
        verified(model, &names, &Options { cases: 8, ..QUICK });
    }
}
