//! What `hyzer check` prints about models that are right.

use model_spec::{load, summary};

#[test]
fn summaries() {
    for (name, model, with) in [
        (
            "disc_with_effects",
            "disc",
            &["side-force-by-spin", "zero-lift-drag-angle"][..],
        ),
        ("disc_appendix", "disc_appendix", &[]),
        ("disc_quaternion", "disc_quaternion", &[]),
        ("discus", "discus", &[]),
        ("ball", "ball", &[]),
    ] {
        let model = load::load(model, with).unwrap();
        insta::assert_snapshot!(name, summary(&model));
    }
}

#[test]
fn faults_in_colour_have_the_same_words() {
    let loaded = load::inspect("disc_appendix_printed", &[]).unwrap();
    let colored = model_spec::render(&loaded.diagnostics, &loaded.sources, true);
    let plain = model_spec::render(&loaded.diagnostics, &loaded.sources, false);
    assert!(colored.contains("\u{1b}["));
    assert!(!plain.contains('\u{1b}'));
    assert!(colored.contains("a force (N = kg·m/s²)"));
    insta::assert_snapshot!("disc_appendix_printed", plain);
}
