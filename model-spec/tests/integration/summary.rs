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

/// Constraints are printed with their tolerances, and each behaviour at a singular point is a sentence.
#[test]
fn a_summary_reads_as_sentences() {
    let text = "model rod;\nframe N;\nparam m = 1 kg;\n\
        point p { mass m; position (x, y, z) in N = (0, 0, -2) m; velocity (vx, vy, vz) in N; }\n\
        solve rod {\n  unknown T: N;\n  constraint norm(position) = 2 m within 1 mm;\n}\n\
        force rod = -T*unit(position);\n\
        let s = acos(x/(1 m)) + abs(y/(1 m)) + max(x, y)/(1 m);\n";
    let model = load::from_text("rod", text, &[]).unwrap();
    let said = summary(&model);
    assert!(said.lines().all(|line| line == line.trim_end()), "{said}");
    insta::assert_snapshot!("rod", said);
}
