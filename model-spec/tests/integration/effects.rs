//! What effects may add to a model: inputs that they share, states of each flight, a clock,
//! what they depend on.

use model_spec::EffectTree;
use model_spec::load::{self, LoadError, from_text};
use model_spec::model::{EffectUnknown, Model};
use model_spec::summary;
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

/// Text of an effect that displaces the observed position along axis 1. The displacement is the new coefficient
/// `by_{part}` times component `part` of the input vector `marker_is`. `input` is the text that declares this vector.
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
            error.to_string().contains("`marker_is` is declared twice"),
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

/// Applies the effects `names` to the model in `text`, prints the result without the effect declarations, and parses
/// the printed text.
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

const GUST: &str = "\
effect gust {
  site wind;
  state W_x = 0 m/s;
  state W_y = 0.5 m/s;
  der(W_x) = 0;
  der(W_y) = -W_y/(2 s);
  negligible W_y 10 cm/s;
  let fading = der(W_y);
  force gust = 1 [kg/s]*(W_x, W_y, 0) in N + m*fading*N.3;
}
";

#[test]
fn an_effect_adds_states_with_their_equations() {
    let model = right(GUST, &["gust"]);
    let names: Vec<&str> = model.states.iter().map(|s| s.name.as_str()).collect();
    assert_eq!(names, ["x", "y", "z", "vx", "vy", "vz", "W_x", "W_y"]);
    let stated: Vec<usize> = model.equations.iter().map(|e| e.state).collect();
    assert_eq!((stated, model.added_states()), (vec![6, 7], vec![6, 7]));
    let effect = &model.effects[0];
    let states = effect.states.iter();
    let states: Vec<_> = states
        .map(|own| (own.index, own.smallest_effect_of_interest))
        .collect();
    assert_eq!(states, [(6, None), (7, Some(0.1))]);
    let told = summary(&model);
    assert!(
        told.contains("  W_x, of each flight its own, vanishes at 0 m/s\n  W_y, of each flight its own, vanishes at 0.5 m/s, a departure below 0.1 m/s does not matter\n"),
        "{told}"
    );
    let read = written_and_read(&format!("{STONE}{GUST}"), &["gust"]);
    assert_eq!(read.states.len(), 8);
    // What a body's own states do is not stated.
    for (from, to, why) in [
        (
            "der(W_x) = 0",
            "der(vx) = 0",
            "the equation for `vx` follows from the body",
        ),
        ("der(W_y);", "der(vx);", "`der(vx)` follows from the forces"),
        (
            "der(W_x) = 0",
            "der(W_x) = 1 s",
            "`der(W_x)` is an acceleration",
        ),
        (
            "state W_x = 0 m/s",
            "state x = 0 m/s",
            "`x` is declared twice",
        ),
        ("10 cm/s", "10 cm", "`W_y` is in m/s, but this is in m"),
        (
            "negligible W_y",
            "negligible W_z",
            "has no coefficient and no state `W_z`",
        ),
    ] {
        let error = with(&GUST.replacen(from, to, 1), &["gust"]).unwrap_err();
        assert!(error.to_string().contains(why), "{from}: {error}");
    }
}

#[test]
fn an_effect_adds_states_to_stated_equations() {
    let text = "\
model pendulum;
param w = 2 /s;
frame N;
state a = 0.1 rad;
state b = 0 rad/s;
der(a) = b;
der(b) = -w^2*a;
effect drift { site unknown; state c = 0 rad; der(c) = 0; replace a_seen = previous + c; }
let a_seen = a;
";
    let model = from_text("pendulum.hyz", text, &["drift"]).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((model.equations.len(), model.added_states()), (3, vec![2]));
    assert_eq!(
        model.effects[0].states[..],
        [EffectUnknown {
            index: 2,
            null_value: model.states[2].value,
            smallest_effect_of_interest: None
        }]
    );
    let model = from_text("pendulum.hyz", text, &[]).unwrap();
    assert!(model.added_states().is_empty());
}

const CLOCKS: &str = "\
effect fast { site clock; coefficient c = 0 in -0.5 .. 0.5; replace clock = previous/(1 + c); }
effect slow { site clock; coefficient s = 0 in -0.5 .. 0.5; replace clock = previous*(1 - s); }
";
const OTHER: &str = "effect other { site clock; coefficient o = 0; replace clock = 1 + o; }";

#[test]
fn a_clock_is_stated_or_replaced() {
    assert!(right(CLOCKS, &[]).clock.is_none());
    let model = right(CLOCKS, &["fast", "slow"]);
    assert!(model.clock.is_some());
    let told = summary(&model);
    assert!(
        told.contains("\nseconds of flight per second of the clock: previous*(1 - s)\n"),
        "{told}"
    );
    let read = written_and_read(&format!("{STONE}{CLOCKS}"), &["fast"]);
    assert!(read.clock.is_some());
    let own = format!("clock 1 + 0.1;\n{CLOCKS}");
    assert!(right(&own, &["slow"]).clock.is_some());
    for (text, names, why) in [
        ("clock 1; clock 2;", &[][..], "`clock` is stated twice"),
        ("clock 2 s;", &[], "must be a pure number"),
        ("clock N.1;", &[], "the clock must be a number"),
        (
            &format!("{OTHER}effect fast {{ site clock; replace clock = previous*2; }}"),
            &["fast", "other"],
            "`other` would undo the effect `fast`, which replaces the clock too",
        ),
    ] {
        let error = with(text, names).unwrap_err();
        assert!(error.to_string().contains(why), "{text}: {error}");
    }
}

#[test]
fn bounds_keep_a_divisor_away_from_zero() {
    let divided = |bounds: &str, by: &str| {
        with(
            &format!("coefficient c = 0{bounds}; let k = 2*c; let a = 1/({by});\n"),
            &[],
        )
    };
    for (bounds, by) in [
        (" in -0.5 .. 0.5", "1 + c"),
        (" in -0.5 .. 0.5", "c - 1"),
        (" in -0.4 .. 0.5", "1 + k"),
        (" in -0.5 .. 0.5", "3 - k*k"),
    ] {
        divided(bounds, by).unwrap_or_else(|e| panic!("{bounds} {by}: {e}"));
    }
    for (bounds, by) in [
        ("", "1 + c"),
        (" in -1 .. 0.5", "1 + c"),
        (" in -0.5 .. 0.5", "1 + k"),
        (" in -0.5 .. 2", "c - 1"),
    ] {
        let error = divided(bounds, by).unwrap_err();
        assert!(error.to_string().contains("which may be zero"), "{error}");
    }
}

#[test]
fn the_angular_velocity_stays_where_it_was_seen() {
    let text = load::MODELS
        .iter()
        .find(|m| m.0 == "disc")
        .expect("built in")
        .1;
    let effect = "effect wobble { site inertia; coefficient k = 0 kg*m^2;\n\
                  replace inertia ((I_d, 0, k), (0, I_d, 0), (k, 0, I_a)) in C; }\n";
    let text = format!("{text}{effect}");
    let seen = |model: &Model| {
        let rotation = model
            .body
            .as_ref()
            .and_then(|b| b.rotation.as_ref())
            .expect("it turns");
        let name = |frame: usize| model.frames[frame].name.clone();
        (
            name(rotation.angular_velocity_frame),
            name(rotation.inertia_frame),
        )
    };
    let model = from_text("disc.hyz", &text, &[]).unwrap();
    assert_eq!(seen(&model), ("B".into(), "B".into()));
    let model = from_text("disc.hyz", &text, &["wobble"]).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(seen(&model), ("B".into(), "C".into()));
    assert!(summary(&model).contains("\n  inertia in C, angular velocity seen in B\n"));
    assert_eq!(
        seen(&written_and_read(&text, &["wobble"])),
        ("B".into(), "C".into())
    );
    let twice = text.replace(
        "fixed in C;",
        "fixed in C; angular velocity in A; angular velocity in B;",
    );
    let error = from_text("disc.hyz", &twice, &[]).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("`angular velocity in` is stated twice"),
        "{error}"
    );
    let nowhere = text.replace("fixed in C;", "fixed in C; angular velocity in D;");
    let error = from_text("disc.hyz", &nowhere, &[]).unwrap_err();
    assert!(
        error.to_string().contains("there is no frame `D`"),
        "{error}"
    );
}

#[test]
fn a_check_in_the_file_of_an_effect_is_refused() {
    let effect = "effect lead { site gravity; variables none; source \"a scale\";
        coefficient k = 0 in -1 .. 1; negligible k 0.01; }";
    let case = "check \"is not run\" { expect speed = 1 m/s within 0 m/s; }";
    assert!(EffectTree::parse("lead.hyz", effect).is_ok());
    let error = EffectTree::parse("lead.hyz", &format!("{effect}\n{case}")).expect_err("a fault");
    assert!(error.to_string().contains("is not run"), "{error}");
}
