//! What effects may add to a model: inputs that they share, what they depend on.

use model_spec::load::{self, LoadError, from_text};
use model_spec::model::Model;
use model_spec::summary::summary;
use model_spec::syntax::ast::ItemKind;

const STONE: &str = "\
model stone;
param m = 0.5 kg;
param g = 9.81 m/s^2;
frame N;
point stone {
  mass m;
  position (x, y, z) in N;
  velocity (vx, vy, vz) in N;
}
force weight = -m*g*N.3;
marker mark in N;
observe mark = position + mark;
";

fn with(effects: &str, names: &[&str]) -> Result<Model, LoadError> {
    from_text("stone.hyz", &format!("{STONE}{effects}"), names)
}

fn right(effects: &str, names: &[&str]) -> Model {
    with(effects, names).unwrap_or_else(|error| panic!("{error}"))
}

/// An effect on one marker, with its input declared by `input`.
fn on_marker(name: &str, part: u8, input: &str) -> String {
    format!(
        "effect {name} {{ site marker; variables none; {input} coefficient by_{part} = 0 m;\n\
         replace observe mark = previous + marker_is.{part}*by_{part}*N.1; }}\n"
    )
}

#[test]
fn effects_share_an_input_that_they_declare_alike() {
    let input = "input marker_is in N = (0, 0, 0);";
    // The same, written in another way.
    let alike = "/// which marker is seen\ninput marker_is in N = (0.0, 0, -0);";
    let both = on_marker("first", 1, input) + &on_marker("second", 2, alike);
    let model = right(&both, &["first", "second"]);
    let names: Vec<&str> = model.inputs.iter().map(|i| i.name.as_str()).collect();
    assert_eq!(names, ["marker_is"]);
    assert_eq!(model.effects.len(), 2);
    for other in [
        "input marker_is in N = (0, 0, 1);",
        "input marker_is in N = (0, 0, 0) m;",
    ] {
        let both = on_marker("first", 1, input) + &on_marker("second", 2, other);
        let error = with(&both, &["first", "second"]).unwrap_err();
        assert!(
            error.message.contains("`marker_is` is declared twice"),
            "{error}"
        );
    }
}

#[test]
fn an_effect_says_what_it_depends_on() {
    let effect = |word: &str| {
        format!("effect odd {{ site spin; {word} coefficient k = 0 N; force odd = k*N.1; }}\n")
    };
    let model = right(&effect("variables spin, alpha;"), &["odd"]);
    assert_eq!(model.effects[0].variables, ["spin", "alpha"]);
    assert!(summary(&model).contains("  depends on spin, alpha\n"));
    let model = right(&effect(""), &["odd"]);
    assert!(model.effects[0].variables.is_empty());
    assert!(!summary(&model).contains("depends on"));
}

/// The model of a text with its effects applied, written and read again; the text without the effects themselves.
fn written_and_read(text: &str, names: &[&str]) -> Model {
    let mut file = load::inspect_text("stone.hyz", text, names).unwrap().file;
    file.items
        .retain(|item| !matches!(item.kind, ItemKind::Effect(_)));
    let written = file.to_string();
    from_text("written.hyz", &written, &[]).unwrap_or_else(|error| panic!("{error}\n{written}"))
}

#[test]
fn what_effects_add_is_written_so_that_it_reads_the_same() {
    let effects = on_marker("first", 1, "input marker_is in N = (0, 0, 0);");
    let read = written_and_read(&format!("{STONE}{effects}"), &["first"]);
    assert_eq!((read.inputs.len(), read.coefficients.len()), (1, 1));
}
