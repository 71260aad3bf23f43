//! What right files mean: values, units, order, limits, effects.

use model_spec::diagnostic::Kind;
use model_spec::load::{self, from_text, inspect_text};
use model_spec::model::{ClaimedAttitude, Expr, ExprKind, Function, Model, Shape};
use model_spec::singular_points;

const POINT: &str = "\
model probe;
frame N;
param m = 500 g;
param g = 9.81 m/s^2;
point probe { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
let drag = m*g;
force drag = -drag*N.3;
marker mark in N;
observe mark = position + mark;
";

fn model(more: &str) -> Model {
    from_text("probe.hyz", &format!("{POINT}{more}"), &[]).unwrap_or_else(|e| panic!("{e}"))
}

fn faults(more: &str) -> Vec<Kind> {
    let loaded = inspect_text("probe.hyz", &format!("{POINT}{more}"), &[]).unwrap();
    loaded.diagnostics.iter().map(|d| d.kind).collect()
}

/// Evaluates an expression that contains only numbers, π, auxiliary variables and arithmetic operations.
fn value(model: &Model, e: &Expr) -> f64 {
    let v = |e: &Expr| value(model, e);
    match &e.kind {
        ExprKind::Number { value, .. } => *value,
        ExprKind::Pi => std::f64::consts::PI,
        ExprKind::AuxVariable(i) => v(&model.aux_variables[*i].value),
        ExprKind::Neg(a) => -v(a),
        ExprKind::Add(a, b) => v(a) + v(b),
        ExprKind::Sub(a, b) => v(a) - v(b),
        ExprKind::Mul(a, b) => v(a) * v(b),
        ExprKind::Div(a, b) => v(a) / v(b),
        ExprKind::Pow(a, doubled) => v(a).powf(f64::from(*doubled) / 2.0),
        other => panic!("{other:?}"),
    }
}

fn named<'m>(model: &'m Model, name: &str) -> &'m Expr {
    &model
        .aux_variables
        .iter()
        .find(|l| l.name == name)
        .unwrap()
        .value
}

#[test]
fn operators_bind_as_people_write_them() {
    for (text, expected) in [
        ("-2^2", -4.0),
        ("2^3^2", 512.0),
        ("2^-1", 0.5),
        ("-2*3 - -4", -2.0),
        ("2*3^2", 18.0),
        ("12/2/3", 2.0),
        ("12/2*3", 18.0),
        ("1 - 2 - 3", -4.0),
        ("1 - (2 - 3)", 2.0),
        ("4^(1/2) + 3² − 2·2 × 2", 3.0),
        ("(2*3)^2/4", 9.0),
        ("+2 - +1", 1.0),
        ("2^2^0", 2.0),
    ] {
        let model = model(&format!("let a = {text};\n"));
        assert_eq!(value(&model, named(&model, "a")), expected, "{text}");
    }
}

#[test]
fn values_are_si_and_exact_where_they_can_be() {
    let model =
        model("param turn = 90 deg;\nparam speed = 36 km/h;\nlet a = 20 cm + 3 m²/(2 m);\n");
    assert_eq!(model.params[0].value, 0.5);
    assert_eq!(model.params[0].unit_text, "kg");
    assert_eq!(model.params[2].value, std::f64::consts::FRAC_PI_2);
    assert_eq!(
        (model.params[3].value, model.params[3].unit_text.as_str()),
        (10.0, "m/s")
    );
    let ExprKind::Add(left, _) = &named(&model, "a").kind else {
        panic!()
    };
    assert!(matches!(
        left.kind,
        ExprKind::Number {
            exact: Some((1, 5)),
            ..
        }
    ));
}

#[test]
fn units_are_inferred_through_names_and_powers() {
    let model = model(
        "param k = 3 [?];\nparam l = 2 [?];\nlet spring = -k*position;\nforce spring = spring;\n\
         let a = l^2 + z/(1 m) + unused*0;\nparam unused = 1 [?];\n",
    );
    let unit = |name: &str| {
        let c = model.params.iter().find(|c| c.name == name).unwrap();
        assert!(c.inferred);
        c.unit_text.clone()
    };
    assert_eq!(unit("k"), "kg/s^2");
    assert_eq!(unit("l"), "1");
    assert_eq!(unit("unused"), "1");
    assert_eq!(named(&model, "spring").unit.to_string(), "kg*m/s^2");
}

#[test]
fn a_bare_zero_fits_every_unit_and_other_numbers_do_not() {
    assert!(
        faults("let a = max(z, 0) + 0;\nlet b = (x, 0, 0) in N;\nlimit z > 0 \"down\";\n")
            .is_empty()
    );
    assert_eq!(faults("let a = max(z, 1);\n"), [Kind::Unit]);
    assert_eq!(faults("let a = z + 1e-9;\n"), [Kind::Unit]);
}

#[test]
fn a_stated_unit_holds_for_those_that_use_it() {
    assert_eq!(faults("let a: m = z*m;\nlet b = a + z;\n"), [Kind::Unit]);
    assert_eq!(
        faults("let a: m = z + vz;\nlet b = a + vz;\n"),
        [Kind::Unit, Kind::Unit]
    );
}

#[test]
fn quantities_stand_after_those_that_they_use() {
    let model = model("let c = b + a;\nlet b = 2*a;\nlet a = z;\n");
    let order: Vec<&str> = model
        .aux_variables
        .iter()
        .map(|l| l.name.as_str())
        .collect();
    assert_eq!(order, ["drag", "a", "b", "c"]);
    for (i, named) in model.aux_variables.iter().enumerate() {
        for e in named.value.nodes() {
            assert!(!matches!(e.kind, ExprKind::AuxVariable(j) if j >= i));
        }
    }
}

#[test]
fn greek_letters_are_their_names() {
    let model = model("param ρ = 1.2 kg/m³;\nlet α = z·ρ;\nlet b = rho*alpha;\n");
    assert_eq!(model.params[2].name, "rho");
    assert!(model.aux_variables.iter().any(|l| l.name == "alpha"));
}

#[test]
fn products_with_a_dot_and_a_cross_follow_what_they_multiply() {
    let model =
        model("let a = velocity·position;\nlet b = velocity×position;\nlet c = m·position;\n");
    assert!(matches!(named(&model, "a").kind, ExprKind::Dot(..)));
    assert!(matches!(named(&model, "b").kind, ExprKind::Cross(..)));
    assert_eq!(named(&model, "c").shape, Shape::Vector(0));
}

#[test]
fn divisors_are_what_cannot_vanish() {
    for right in [
        "let a = z/(2*m*g);",
        "let a = z/exp(time/(1 s));",
        "let a = z/(1 + x^2/(1 m^2));",
        "let a = z/(1 m + norm(position));",
        "limit vz > 0 \"a\"; let a = z/(m*vz^2);",
        "let V = norm(velocity); limit V > 1 [m/s] \"slow\"; let a = z/V;",
        "let V = norm(velocity); limit norm(velocity) > 0 \"slow\"; let a = V^-1;",
        "let d = 2*m; let a = z/d;",
        "let a = tan(0.5*m/m);  limit cos(0.5*m/m) > 0 \"a\";",
    ] {
        assert!(faults(right).is_empty(), "{right}: {:?}", faults(right));
    }
    for wrong in [
        "let a = z/(m - 1 kg);",
        "let a = z/sin(time/(1 s));",
        "let a = z/(x^2);",
        "limit vz > -1 [m/s] \"a\"; let a = z/vz;",
        "let d = 2*x; let a = z/d;",
        "let a = z/(x - y)^2;",
        "let a = z/(m*0);",
        "let a = z/step(x);",
        "let a = tan(m/m);",
    ] {
        assert_eq!(faults(wrong), [Kind::Singular], "{wrong}");
    }
}

#[test]
fn singular_points_are_listed_with_their_behaviour() {
    let model = model(
        "let a = norm(velocity);\nlet b = ratio(z, x, 1);\nlet c = sqrt(m/m);\nlet d = unit(velocity, N.1);\n",
    );
    let points: Vec<String> = singular_points(&model)
        .iter()
        .map(|p| format!("{}: {}", p.text, p.what))
        .collect();
    assert_eq!(
        points,
        [
            "norm(velocity): is 0 with derivative 0 where `velocity` is zero",
            "ratio(z, x, 1): is `1` where `x` is 0",
            "sqrt(m/m): is 0 with derivative 0 where `m/m` is 0 or less",
            "unit(velocity, N.1): is `N.1` where `velocity` is zero",
        ]
    );
}

#[test]
fn angles_bring_their_own_limit_unless_the_model_states_it() {
    let body = |axes: [u8; 3], limit: &str| {
        let [a, b, c] = axes;
        let text = format!(
            "model probe;\nparam m = 1 kg;\nparam I = 1 kg*m^2;\nframe N;\n\
             frame A = N turned a about {a};\nframe B = A turned b about {b};\nframe C = B turned c about {c};\n\
             body probe {{ mass m; inertia diag(I, I, I) in C; fixed in C; position (x, y, z) in N; \
             velocity (u, v, w) in C; }}\n{limit}"
        );
        from_text("probe.hyz", &text, &[]).unwrap_or_else(|e| panic!("{e}"))
    };
    let is = |model: &Model, function: Function| {
        let [limit] = &model.limits[..] else {
            panic!("{:?}", model.limits)
        };
        assert!(matches!(limit.value.kind, ExprKind::Call(f, _) if f == function));
        (limit.bound, model.is_automatic(limit))
    };
    assert_eq!(is(&body([1, 2, 3], ""), Function::Cos), (0.01, true));
    assert_eq!(is(&body([3, 1, 3], ""), Function::Sin), (0.01, true));
    let stated = body([1, 2, 3], "limit cos(b) > 0.1 \"steep\";");
    assert_eq!(is(&stated, Function::Cos), (0.1, false));
    // A limit below zero does not keep it away from the singular attitude.
    assert_eq!(
        body([1, 2, 3], "limit cos(b) > -0.1 \"steep\";")
            .limits
            .len(),
        2
    );
}

const EFFECTS: &str = "\
effect more { site drag; coefficient k = 0; replace drag = previous*(1 + k); }
effect fresh { site drag; coefficient j = 0 N; replace drag = m*g + j; }
effect seen { site marker; coefficient s = 0 m; replace observe mark = previous + s*N.1; }
effect pushed { site side; coefficient p = 0 N; replace force drag = previous + p*N.2; let half = p/2; }
";

#[test]
fn effects_add_up_and_do_not_undo_one_another() {
    let text = format!("{POINT}{EFFECTS}");
    let with = |names: &[&str]| from_text("probe.hyz", &text, names);
    let all = with(&["fresh", "more", "seen", "pushed"]).unwrap_or_else(|e| panic!("{e}"));
    let coefficients: Vec<&str> = all.coefficients.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(coefficients, ["j", "k", "s", "p"]);
    assert_eq!(all.text(named(&all, "drag").span), "previous*(1 + k)");
    assert_eq!(all.forces.len(), 1);
    assert_eq!(all.forces[0].effect, Some(3));
    assert_eq!(all.tree.effects().count(), 4);
    let undone = with(&["more", "fresh"]).unwrap_err();
    assert!(
        undone
            .to_string()
            .contains("`fresh` would undo the effect `more`"),
        "{undone}"
    );
    assert!(
        with(&["more", "more"])
            .unwrap_err()
            .to_string()
            .contains("switched on twice")
    );
    // Switched off they change nothing.
    let off = with(&[]).unwrap();
    assert_eq!(off.aux_variables.len(), 1);
    assert!(off.coefficients.is_empty());
}

#[test]
fn an_extended_model_is_a_file_like_any_other() {
    let loaded = load::inspect("disc", &["zero-lift-drag-angle"]).unwrap();
    let written = loaded.file.to_string();
    let read =
        from_text("extended.hyz", &written, &[]).unwrap_or_else(|e| panic!("{e}\n{written}"));
    assert_eq!(read.coefficients.last().unwrap().name, "alpha_0");
    assert_eq!(
        read.aux_variables.len(),
        loaded.model.unwrap().aux_variables.len()
    );
}

#[test]
fn a_path_wins_over_a_name_and_effects_may_be_paths() {
    let folder = std::env::temp_dir().join(format!("hyzer-load-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("own.hyz");
    std::fs::write(&path, format!("\u{FEFF}{}", POINT.replace('\n', "\r\n"))).unwrap();
    let effect = folder.join("effect.hyz");
    std::fs::write(&effect, "effect more {\n  site drag;\n  coefficient k = 0;\n  replace drag = previous*(1 + k);\n}\n")
        .unwrap();
    let model = load::load(path.to_str().unwrap(), &[effect.to_str().unwrap()]).unwrap();
    let missing = load::load("dsic", &[]).unwrap_err().to_string();
    let unknown = load::load("disc", &["side_force_by_spn"])
        .unwrap_err()
        .to_string();
    std::fs::remove_dir_all(&folder).unwrap();
    assert_eq!((model.name.as_str(), model.effects.len()), ("probe", 1));
    assert!(missing.contains("did you mean `disc`?"), "{missing}");
    assert!(
        unknown.contains("did you mean `side_force_by_spin`?"),
        "{unknown}"
    );
}

#[test]
fn faults_of_units_alone_leave_a_model_to_speak_of() {
    let text = format!("{POINT}let a = z + vz;\nforce push = m*N.1;\n");
    let loaded = inspect_text("probe.hyz", &text, &[]).unwrap();
    assert_eq!(loaded.diagnostics.len(), 2);
    let model = loaded.model.unwrap();
    assert_eq!((model.aux_variables.len(), model.forces.len()), (2, 2));
    let loaded = inspect_text("probe.hyz", &format!("{POINT}let a = q;\n"), &[]).unwrap();
    assert!(loaded.model.is_none());
}

#[test]
fn a_unit_error_shows_the_declaration_that_would_agree() {
    for (text, mended) in [
        (
            "coefficient C_p = 0.6 in 0 .. 3;\nforce probe = -C_p*norm(velocity)*velocity;\n",
            "coefficient C_p = 0.6 kg/m in 0 .. 3;",
        ),
        // Through a name, by one of two declarations without a unit.
        (
            "param k_p = 2;\nparam more = 0.1;\nlet pull = k_p*(1 + more)*z;\nforce probe = pull*N.3;\n",
            "param k_p = 2 kg/s^2;",
        ),
        (
            "input push in N = (0, 0, 1);\nforce probe = push;\n",
            "input push in N = (0, 0, 1) N;",
        ),
        ("state s_p = 1;\nder(s_p) = z;\n", "state s_p = 1 m*s;"),
    ] {
        let wrong = inspect_text("probe.hyz", &format!("{POINT}{text}"), &[]).unwrap();
        let [fault] = &wrong.diagnostics[..] else {
            panic!("{text}: {:?}", wrong.diagnostics);
        };
        let help = fault.help.as_deref().unwrap_or_default();
        assert!(
            help.contains(&format!("write `{mended}`")),
            "{text}: {help}"
        );
        let old = mended.split('=').next().unwrap();
        let line = text.lines().find(|l| l.starts_with(old)).unwrap();
        model(&text.replace(line, mended));
    }
    assert_eq!(faults("param l_p = 2 [?];\nlet a_p = l_p + z;\n"), []);
    assert_eq!(
        faults("param l_p = 2 [1];\nlet a_p = l_p + z;\n"),
        [Kind::Unit]
    );
}

#[test]
fn a_claim_says_what_stands_for_the_quantities_of_a_body() {
    let page = std::fs::read_to_string("../docs/reference/language.md").unwrap();
    let of = |name: &str| {
        let start = page.find(&format!("model {name};")).unwrap();
        let text = &page[start..start + page[start..].find("```").unwrap()];
        load::from_text(name, text, &[]).unwrap()
    };
    let glider = of("glider").claim.unwrap();
    assert_eq!(glider.name, "glider");
    assert!(glider.rotation.is_none());
    assert_eq!(glider.force.shape, Shape::Vector(0));
    assert_eq!(glider.force.unit, model_spec::unit::Unit::NEWTON);
    let top = of("top").claim.unwrap().rotation.unwrap();
    assert_eq!(top.attitude, ClaimedAttitude::Axis(1, 3));
    assert_eq!(top.inertia_frame, 1);
    assert_eq!(top.moment.shape, Shape::Vector(1));
}
