//! Mutants are models too, thousands of odd ones: the compiler must get each of them right.

use crate::support::{QUICK, built_in};
use verify::Options;
use verify::checks::{derivatives, reference};
use verify::engine::Engine;
use verify::engine::Values;
use verify::mutants::mutants;
use verify::report::Verdict;
use verify::subject::Subject;

const FEW: Options = Options { cases: 4, ..QUICK };

fn models(name: &str) -> impl Iterator<Item = (String, model_spec::model::Model)> {
    let loaded = built_in(name);
    let made = mutants(&loaded.file, &loaded.sources);
    made.into_iter().filter_map(move |mutant| {
        let model = model_spec::check(&mutant.file, &loaded.sources).model?;
        Some((
            format!("{name}, {}: {}", mutant.place, mutant.change),
            model,
        ))
    })
}

#[test]
fn values_agree_with_the_vector_tree() {
    for (name, _) in model_spec::load::MODELS {
        let mut count = 0;
        for (change, model) in models(name) {
            let values = Values::of(&model);
            let row = reference::tree(&Subject::new(&model, &values), &FEW);
            assert_eq!(
                row.verdict,
                Verdict::Holds,
                "{change}: {} {}",
                row.worst,
                row.detail
            );
            count += 1;
        }
        assert!(count > 50, "{name}: {count}");
    }
}

#[test]
fn derivatives_agree_with_dual_numbers() {
    for name in ["disc", "ball"] {
        for (change, model) in models(name).step_by(7) {
            let compiled = codegen::compile(&model);
            let engine = Engine::new(&compiled);
            let subject = Subject::new(&model, &engine);
            for row in &derivatives::check(&subject, &compiled, &FEW)[..3] {
                assert_eq!(
                    row.verdict,
                    Verdict::Holds,
                    "{change}: {} {}",
                    row.worst,
                    row.detail
                );
            }
        }
    }
}
