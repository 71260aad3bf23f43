//! Every check holds of every model with every effect of the catalogue for one model switched on; `general_effects`
//! tests those for any model.

use crate::support::{QUICK, refuted, row};
use model_spec::EffectTree;
use model_spec::compose::known_effects;
use model_spec::load::{inspect, load};
use verify::Options;
use verify::checks::effects::EFFECT_REFERENCE;

const MODELS: [&str; 4] = ["disc", "disc_quaternion", "discus", "ball"];

fn specific() -> impl Iterator<Item = &'static str> {
    let effects = EffectTree::built_in().iter();
    effects
        .filter(|effect| !effect.is_general())
        .map(EffectTree::name)
}

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
    for name in specific() {
        for model in MODELS.iter().filter(|model| load(model, &[name]).is_ok()) {
            verified(model, &[name], &options);
        }
    }
}

#[test]
fn a_model_with_all_effects_is_verified() {
    for model in MODELS {
        let names: Vec<&str> = specific()
            .filter(|name| load(model, &[name]).is_ok())
            .collect();
        verified(model, &names, &Options { cases: 8, ..QUICK });
    }
}

#[test]
fn the_row_has_each_effect_alone_and_all_together() {
    for name in ["disc", "ball"] {
        let known = known_effects(&load(name, &[]).unwrap());
        let offered = known.iter().filter(|known| known.refused.is_none()).count();
        let specific = specific()
            .filter(|effect| load(name, &[effect]).is_ok())
            .count();
        assert!(offered >= specific, "{name}");
        let report = verify::run(&inspect(name, &[]).unwrap(), &QUICK);
        assert_eq!(row(&report, EFFECT_REFERENCE).cases, offered + 1, "{name}");
    }
}
