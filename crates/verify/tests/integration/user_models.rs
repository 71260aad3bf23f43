//! Six models of a user's own: right ones are never refuted, and mistakes in them are noticed where the model says what
//! its quantities are.
//!
//! A mutant of a force law that the author alone states is another model, not a wrong one; what tells it is the author's own
//! worked example, a `check` case with all derivatives at one state. The cases of `tests/integration/models` were worked outside of this
//! repository from the laws as the models' documentation states them.

use crate::support::{self, row};
use model_spec::load::{Loaded, inspect_text};
use verify::Options;
use verify::checks::claim::CLAIM;
use verify::checks::{identities, metamorphic, reference};
use verify::engine::Engine;
use verify::flights::{INVARIANTS, MOMENTA};
use verify::mutants::equivalence::Original;
use verify::mutants::status::{CHECKS, MutantStatus, evaluate};
use verify::mutants::{Mutant, mutants};
use verify::random::Random;
use verify::report::{Outcome, Verdict};
use verify::subject::Subject;

/// Maximum number of mutants that are drawn for each model.
const DRAWN: usize = 200;

fn file(path: &str) -> String {
    let path = format!("{}/{path}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|why| panic!("{path}: {why}"))
}

/// Text of the model `name` in the folder `studies/models`.
fn studied(name: &str) -> String {
    file(&format!("../../studies/models/{name}.hyz"))
}

/// Text of the model `name` in the folder `studies/models`, with a check case of its author appended.
fn worked(name: &str) -> String {
    studied(name) + &file(&format!("tests/integration/models/{name}_case.hyz"))
}

/// Removes the `claim` block from a model text.
fn unclaimed(text: &str) -> String {
    let start = text.find("claim ").unwrap();
    let end = start + text[start..].find("}\n").unwrap() + 2;
    format!("{}{}", &text[..start], &text[end..])
}

/// The tested models: description, text, and whether the equations can be verified because the model declares a body or
/// has a `claim` block.
fn models() -> Vec<(&'static str, String, bool)> {
    let glider = studied("glider");
    vec![
        ("point", worked("pendulum"), true),
        ("spinning body", worked("spinning_ball"), true),
        ("quaternion body", worked("quaternion_dart"), true),
        ("stated equations with a claim", glider.clone(), true),
        ("the same without", unclaimed(&glider), false),
        (
            "boomerang",
            file("../../examples/boomerang/boomerang.hyz"),
            true,
        ),
    ]
}

fn loaded(text: &str) -> Loaded {
    let loaded = inspect_text("own", text, &[]).unwrap();
    assert!(loaded.model.is_some(), "{:#?}", loaded.diagnostics);
    loaded
}

#[test]
fn right_models_are_not_refuted_by_any_seed() {
    for (name, text, says) in models() {
        let loaded = loaded(&text);
        for seed in 1..=6 {
            let options = Options {
                seed,
                ..support::QUICK
            };
            let report = verify::run(&loaded, &options);
            let expected = if says {
                Outcome::Verified
            } else {
                Outcome::NotVerified
            };
            assert_eq!(report.outcome(), expected, "{name}: {}", report.table());
        }
    }
}

/// Numbers of mutants of a model by their status.
#[derive(Debug, Default)]
struct Kills {
    drawn: usize,
    killed: usize,
    equivalent: usize,
    /// For each check in [`CHECKS`], the number of mutants for which it is the first check to refute them.
    first: [usize; CHECKS.len()],
    left: Vec<String>,
}

/// Whether a mutant changes only the observation and not the motion of the body.
fn is_of_observation(mutant: &Mutant) -> bool {
    mutant.place.starts_with("observe") || mutant.place.starts_with("marker")
}

/// Draws random mutants of a model that are not equivalent to it and do not affect only the observation, at most
/// [`DRAWN`], and runs every check on each.
fn kills(text: &str, seed: u64) -> Kills {
    let loaded = loaded(text);
    let model = loaded.model.as_ref().unwrap();
    let engine = Engine::new(&codegen::compile(model));
    let subject = Subject::new(model, &engine);
    let original = Original::new(&subject);
    let mut all = mutants(&loaded.file, &loaded.sources);
    all.retain(|mutant| !is_of_observation(mutant));
    let mut random = Random::new(seed, "draw");
    let options = Options {
        cases: 6,
        ..support::QUICK
    };
    let mut kills = Kills::default();
    while kills.drawn < DRAWN && !all.is_empty() {
        let mutant = all.swap_remove(random.next() as usize % all.len());
        match evaluate(&mutant, &loaded.sources, &original, &options) {
            MutantStatus::Equivalent(_) => {
                kills.equivalent += 1;
                continue;
            }
            MutantStatus::Killed(by) => {
                kills.killed += 1;
                kills.first[by[0]] += 1;
            }
            MutantStatus::NotCovered | MutantStatus::Survived => kills
                .left
                .push(format!("{}: {}", mutant.place, mutant.change)),
        }
        kills.drawn += 1;
    }
    kills
}

#[test]
fn mistakes_are_noticed_where_a_model_says_what_its_quantities_are() {
    for (name, text, says) in models() {
        let kills = kills(&text, 1);
        println!("{name}: {kills:#?}");
        assert!(kills.drawn >= 120, "{name}: {kills:#?}");
        if says {
            assert_eq!(kills.killed, kills.drawn, "{name}: {kills:#?}");
        } else {
            assert!(kills.killed < kills.drawn, "{name}: {kills:#?}");
        }
    }
}

#[test]
fn what_cannot_be_checked_without_a_claim_is_said_with_what_to_add() {
    let report = verify::run(&loaded(&unclaimed(&studied("glider"))), &support::QUICK);
    assert_eq!(report.outcome(), Outcome::NotVerified);
    let open = [
        reference::REFERENCE,
        CLAIM,
        identities::IDENTITIES,
        INVARIANTS,
        MOMENTA,
        metamorphic::METAMORPHIC,
    ];
    for check in open {
        assert_eq!(row(&report, check).verdict, Verdict::Unverified, "{check}");
    }
    let text = report.table();
    for said in [
        "NOT VERIFIED: reference, claimed body,",
        "nothing says what these equations are about",
        "claim body NAME {",
        "claim point NAME {",
        "the momentum by the\nforce and the angular momentum by the moment",
    ] {
        assert!(text.contains(said), "{said}: {text}");
    }
}
