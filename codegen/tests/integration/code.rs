//! Generated code: its text, its operation counts, its determinism.

use crate::support::{self, model};
use codegen::BACKENDS;
use codegen::backend::SourceFile;
use codegen::count::count;
use codegen::{Selection, compile, compile_for, generate};
use model_spec::model::Model;
use std::path::Path;

fn all() -> Vec<Model> {
    support::models().into_iter().map(model).collect()
}

/// Maximum operation counts of the compiled functions `f`, `f_jac`, `f_jac_par` and `prepare`, in this order, for each
/// model.
const MAX_OPERATIONS: [(&str, [usize; 4]); 5] = [
    ("ball", [14, 33, 56, 13]),
    ("disc", [108, 340, 495, 26]),
    ("disc_appendix", [123, 396, 556, 32]),
    ("disc_quaternion", [141, 576, 664, 20]),
    ("discus", [114, 352, 506, 34]),
];

#[test]
fn operations_do_not_creep_up() {
    for (name, most) in MAX_OPERATIONS {
        let compiled = compile(&model(name));
        let names = ["f", "f_jac", "f_jac_par", "prepare"];
        let counts = names.map(|function| compiled.count(function).total());
        for ((function, count), most) in names.iter().zip(counts).zip(most) {
            assert!(
                count <= most,
                "{name} {function} takes {count} operations, no longer {most}"
            );
        }
    }
}

/// Lowest operation counts that another code generator in benches/peers reaches for the functions `f`, `f_jac` and
/// `f_jac_par` of the disc model; negations are not counted.
const LEANEST_PEER: [usize; 3] = [125, 522, 722];

#[test]
fn fewer_operations_than_any_peer() {
    let compiled = compile(&model("disc"));
    for (function, peer) in ["f", "f_jac", "f_jac_par"].into_iter().zip(LEANEST_PEER) {
        // with negations, and with the share of `prepare`
        let ours = compiled.count(function).total() + compiled.count_prepared(function).total();
        assert!(ours < peer, "{function}: {ours}, a peer {peer}");
    }
}

#[test]
fn generation_is_deterministic() {
    let (first, second) = (generate::generate(&all()), generate::generate(&all()));
    assert_eq!(first, second);
    // independent of the order of the models
    let mut reversed = all();
    reversed.reverse();
    assert_eq!(first, generate::generate(&reversed));
}

#[test]
fn every_backend_writes_each_model_once_and_always_the_same() {
    let models = support::with_zoo();
    for backend in BACKENDS {
        let files = generate::generate_with(*backend, &models);
        assert_eq!(files, generate::generate_with(*backend, &models));
        assert!(files.len() >= models.len(), "{}", backend.name());
        assert!(
            files.windows(2).all(|pair| pair[0].path < pair[1].path),
            "{} writes a file twice",
            backend.name()
        );
        for SourceFile { path, text } in &files {
            assert!(!text.contains("//@"), "{path}: a marker is left");
            if path.ends_with(".rs") {
                syn::parse_file(text).unwrap_or_else(|error| panic!("{path}: {error}"));
            }
        }
    }
}

#[test]
fn committed_code_is_what_would_be_generated() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates/generated/src");
    let committed = ["ball", "disc"].map(model);
    let differences = generate::check(&source, &committed).expect("a readable folder");
    let text: Vec<String> = differences.iter().map(ToString::to_string).collect();
    assert!(text.is_empty(), "{}", text.join("\n"));
}

#[test]
fn stale_code_is_shown_as_a_difference() {
    let folder = std::env::temp_dir().join(format!("stale-{}", std::process::id()));
    let ball = [model("ball")];
    let written = generate::write(&folder, &ball).expect("a writable folder");
    assert!(written.contains(&"ball/f.rs".to_string()));
    assert!(
        generate::check(&folder, &ball)
            .expect("readable")
            .is_empty()
    );
    assert!(
        generate::write(&folder, &ball)
            .expect("writable")
            .is_empty(),
        "nothing to write twice"
    );

    let path = folder.join("ball/f.rs");
    let text = std::fs::read_to_string(&path).expect("a file");
    std::fs::write(&path, text.replace("vz_dot", "vx_dot")).expect("writable");
    std::fs::write(folder.join("left_over.rs"), "//! Nothing.\n").expect("writable");
    let differences = generate::check(&folder, &ball).expect("readable");
    let paths: Vec<&str> = differences
        .iter()
        .map(|difference| difference.path.as_str())
        .collect();
    assert_eq!(paths, ["ball/f.rs", "left_over.rs"]);
    assert!(
        differences[0].text.contains("+    dx[5] = vz_dot;"),
        "{}",
        differences[0]
    );
    std::fs::remove_dir_all(folder).expect("removable");
}

#[test]
fn no_name_is_a_number_and_no_line_is_too_long() {
    for SourceFile { path, text } in generate::generate(&all()) {
        syn::parse_file(&text).unwrap_or_else(|error| panic!("{path}: {error}"));
        assert!(!text.contains("//@"), "{path}: a marker is left");
        for line in text.lines() {
            let skipped = path.ends_with("mod.rs") || line.contains("//") || line.contains("fn ");
            let skipped = skipped || line.contains("pub observe_jac");
            assert!(skipped || line.chars().count() <= 100, "{path}: {line}");
            assert!(
                !line.contains("tmp") && !line.contains("local_"),
                "{path}: {line}"
            );
        }
    }
}

#[test]
fn a_selection_has_only_its_columns() {
    let disc = model("disc");
    let all = compile(&disc);
    let (a, b) = (
        all.layout.parameter("C_La").unwrap().index(),
        all.layout.parameter("C_Nr").unwrap().index(),
    );
    let some = compile_for(&disc, &Selection::Only(vec![a, b]));
    let columns: Vec<u32> = some
        .f_jac_par
        .pattern("jp")
        .iter()
        .map(|&(_, column)| column)
        .collect();
    assert!(
        columns.iter().all(|&column| column < 2) && columns.contains(&0) && columns.contains(&1)
    );
    assert!(count(&some.f_jac_par.program).total() < count(&all.f_jac_par.program).total());
}

#[test]
fn ball_reads_like_its_model() {
    let ball = model("ball");
    let files = codegen::rust::emit(&compile(&ball), &ball);
    let text: Vec<String> = files
        .into_iter()
        .filter(|file| {
            ["ball/f.rs", "ball/f_jac.rs", "ball/prepare.rs"].contains(&file.path.as_str())
        })
        .map(|SourceFile { path, text }| format!("// {path}\n{text}"))
        .collect();
    insta::assert_snapshot!(text.join("\n"));
}
