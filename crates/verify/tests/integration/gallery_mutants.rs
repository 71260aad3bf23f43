//! Mutants of the gallery's models, drawn at random: what the checks say of each.

use std::path::PathBuf;

use model_spec::load::{Loaded, inspect};
use verify::Options;
use verify::mutants::equivalence::Original;
use verify::mutants::status::evaluate;
use verify::mutants::{Mutant, MutationMatrix, mutants};
use verify::random::Random;
use verify::subject::{Interpreted, Subject};

use crate::support::QUICK;

const FEW: Options = Options { cases: 4, ..QUICK };

/// Every model of the gallery, by name.
fn gallery() -> Vec<(String, Loaded)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples/gallery");
    let files = std::fs::read_dir(folder).expect("the gallery");
    let paths = files.map(|file| file.expect("a file").path());
    let mut models: Vec<PathBuf> = paths
        .filter(|path| path.extension().is_some_and(|end| end == "hyz"))
        .collect();
    models.sort();
    let load = |path: &PathBuf| {
        let name = path.file_stem().expect("a name").to_string_lossy().into();
        let loaded = inspect(&path.to_string_lossy(), &[]).expect("it is read");
        (name, loaded)
    };
    models.iter().map(load).collect()
}

/// `count` mutants of a model, drawn without repetition.
fn drawn(loaded: &Loaded, name: &str, count: usize) -> Vec<Mutant> {
    let mut all = mutants(&loaded.file, &loaded.sources);
    let mut random = Random::new(7, name);
    for place in 0..count.min(all.len()) {
        let left = (all.len() - place) as u64;
        let other = place + (random.next() % left) as usize;
        all.swap(place, other);
    }
    all.truncate(count);
    all
}

fn matrix(name: &str, loaded: &Loaded, count: usize) -> MutationMatrix {
    let model = loaded.model.as_ref().expect("a model");
    let equations = Interpreted::new(model).expect("equations");
    let subject = Subject::new(model, &equations);
    let original = Original::new(&subject);
    let drawn = drawn(loaded, name, count);
    let statuses = flight::parallel::each(drawn.len(), |k| {
        evaluate(&drawn[k], &loaded.sources, &original, &FEW)
    });
    MutationMatrix::of(&drawn, &statuses)
}

/// No mutant of `count` per model survives without a reason; prints what became of them.
fn check(count: usize) {
    println!("| model | mutants | killed | equivalent | not covered | survived |");
    println!("|---|---:|---:|---:|---:|---:|");
    let mut survivors = Vec::new();
    for (name, loaded) in gallery() {
        let matrix = matrix(&name, &loaded, count);
        let (killed, equivalent) = (matrix.killed(), matrix.equivalent.len());
        let uncovered = matrix.not_covered.len();
        let survived = matrix.survivors.len();
        let all = killed + equivalent + uncovered + survived;
        println!("| {name} | {all} | {killed} | {equivalent} | {uncovered} | {survived} |");
        for own in &matrix.not_covered {
            println!("<!-- {name}: {own} -->");
        }
        survivors.extend(matrix.survivors.iter().map(|own| format!("{name}: {own}")));
    }
    assert!(survivors.is_empty(), "{survivors:#?}");
}

#[test]
fn no_mutant_of_the_gallery_survives_without_a_reason() {
    check(2);
}

#[test]
#[ignore = "takes minutes"]
fn none_of_200_mutants_of_each_model_survives_without_a_reason() {
    check(200);
}
