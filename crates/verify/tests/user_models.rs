//! Six models of a user's own: right ones are never refuted, and mistakes in them are noticed where the model says what
//! its quantities are.

mod support;

use model_spec::load::{Loaded, inspect_text};
use verify::Options;
use verify::engine::Engine;
use verify::mutants::equivalence::Original;
use verify::mutants::mutants;
use verify::mutants::status::{CHECKS, MutantStatus, evaluate};
use verify::random::Random;
use verify::subject::Subject;

fn file(path: &str) -> String {
    let path = format!("{}/{path}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|why| panic!("{path}: {why}"))
}

fn models() -> Vec<(&'static str, String)> {
    let studies = |name: &str| file(&format!("../studies/models/{name}.hyz"));
    vec![
        ("point", studies("shuttlecock")),
        ("spinning body", studies("spinning_ball")),
        ("quaternion body", studies("quaternion_dart")),
        ("stated, with a claim", studies("glider")),
        ("stated, without", studies("glider")),
        ("boomerang", file("tests/models/boomerang.hyz")),
    ]
}

#[test]
fn kills() {
    for (name, text) in models() {
        let loaded: Loaded = inspect_text(name, &text, &[]).unwrap();
        let model = loaded
            .model
            .as_ref()
            .unwrap_or_else(|| panic!("{name}: {:#?}", loaded.diagnostics));
        let compiled = codegen::compile(model);
        let engine = Engine::new(&compiled);
        let subject = Subject::new(model, &engine);
        let original = Original::new(&subject);
        let mut all = mutants(&loaded.file, &loaded.sources);
        let total = all.len();
        let mut random = Random::new(1, "draw");
        let options = Options {
            cases: 6,
            ..support::QUICK
        };
        let (mut drawn, mut killed, mut equivalent) = (0, 0, 0);
        let mut first = [0; CHECKS.len()];
        let mut left = Vec::new();
        while drawn < 200 && !all.is_empty() {
            let mutant = all.swap_remove(random.next() as usize % all.len());
            match evaluate(&mutant, &loaded.sources, &original, &options) {
                MutantStatus::Equivalent(_) => {
                    equivalent += 1;
                    continue;
                }
                MutantStatus::Killed(by) => {
                    killed += 1;
                    first[by[0]] += 1;
                }
                _ => left.push(format!("{}: {}", mutant.place, mutant.change)),
            }
            drawn += 1;
        }
        println!(
            "{name}: {total} mutants; {killed} of {drawn} killed, {equivalent} equivalent; first {first:?}"
        );
        for l in left {
            println!("    {l}");
        }
    }
}
