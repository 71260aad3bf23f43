//! Blocks `solve { … }`: what they mean, and what is wrong with them.

use model_spec::load::from_text;
use model_spec::model::{ExprKind, Model};

const HEAD: &str =
    "model probe; frame N; frame B = N turned q about 3; param m = 2 kg; param g = 9.81 m/s^2;
    state x = 1 m; state v = 0 m/s; state q = 0 rad; state w = 0 rad/s;
    der(x) = v; der(q) = w;\n";

fn model(rest: &str) -> Model {
    from_text("probe.hyz", &format!("{HEAD}{rest}"), &[]).unwrap_or_else(|error| panic!("{error}"))
}

/// The first line of the only error.
fn error(rest: &str) -> String {
    let found = from_text("probe.hyz", &format!("{HEAD}{rest}"), &[]);
    let error = found.err().unwrap_or_else(|| panic!("{rest} is right"));
    let diagnostics = error.diagnostics();
    assert_eq!(diagnostics.len(), 1, "{error}");
    diagnostics[0].message.clone()
}

/// Lagrange's equations of three weights on rods compile to some hundred operations: the bound is one of these, not of
/// the factors of all products.
#[test]
fn a_triple_pendulum_is_within_the_bound_of_operations() {
    let mut text = "model triple; frame N; param g = 9.81 m/s^2; let r0 = 0 [m]*N.1;".to_owned();
    let mut lagrangian = Vec::new();
    for k in 1..=3 {
        let above = k - 1;
        text += &format!(
            "param l{k} = 0.{k} m; param m{k} = {k} kg; state th{k} = {k}0 deg; state om{k} = 0 rad/s; der(th{k}) = om{k};
             let r{k} = r{above} + l{k}*(sin(th{k}), 0, -cos(th{k})) in N; let v{k} = der(r{k});\n"
        );
        lagrangian.push(format!("m{k}*(v{k}·v{k}/2 - g*r{k}.3)"));
    }
    text += &format!("let L = {}; solve lagrange {{", lagrangian.join(" + "));
    for k in 1..=3 {
        text += &format!("der(partial(L, om{k})) = partial(L, th{k});");
    }
    from_text("triple.hyz", &(text + "}"), &[]).unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn unknowns_are_quantities_and_printed_blocks_read_as_the_same() {
    let text = "solve rod {\n  /// tension\n  unknown T: N;\n  m*der(v) = -T;\n  der(w) = T/(m*(1 m));\n  constraint x*sin(q) = 0.5 [m] within 1 mm;\n}
        let load = T/(m*g); limit 90 N - T > 0 N \"it breaks\";";
    let own = model(text);
    let unknowns: Vec<&str> = { own.systems[0].unknowns.iter() }
        .map(|own| &*own.name)
        .collect();
    assert_eq!(unknowns, ["der(v)", "der(w)", "T"]);
    let tension = { own.aux_variables.iter() }
        .find(|own| own.name == "T")
        .unwrap();
    assert_eq!(tension.doc, "tension");
    assert!(matches!(tension.value.kind, ExprKind::Unknown(0, 2)));
    let printed = own.tree.to_string();
    let again = from_text("probe.hyz", &printed, &[]).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(again.tree.to_string(), printed);
    // The deviation and its rate are limited, then the block, then what the file states.
    assert_eq!(again.limits.len(), 4);
}

#[test]
fn blocks_that_use_unknowns_of_others_come_after_them() {
    let own = model(
        "solve late { der(w)*m = T/(1 m); } solve early { unknown T: N; T = m*g; m*der(v) = T; }",
    );
    let titles: Vec<&str> = own.systems.iter().map(|own| &*own.title).collect();
    assert_eq!(titles, ["`solve early`", "`solve late`"]);
    let circular = "solve a { unknown T: N; T = F; m*der(v) = T; }
        solve b { unknown F: N; F = T; m*der(w)*(1 m) = F; }";
    assert_eq!(error(circular), "these blocks use one another's unknowns");
}

#[test]
fn faults_are_named() {
    let rest = |block: &str| format!("der(w) = 0; solve {{ {block} }}");
    let cases = [
        (
            "m*der(v)*der(v) = 1 [N^2/kg];",
            "`m*der(v)*der(v)` is not linear in the unknowns of `solve`",
        ),
        (
            "unknown T: N; m*der(v) = 2*T*T/(1 N); T = m*g;",
            "`2*T*T` is not linear in the unknowns of `solve`",
        ),
        (
            "m*der(v) = v;",
            "the sides of an equation must have one unit: `m*der(v)` is a force (N = kg·m/s²), but `v` is a velocity (m/s)",
        ),
        (
            "unknown R: vector N in B; R = m*g*N.3; der(v) = 0;",
            "the vectors have their components in different frames: `R` in B, `m*g*N.3` in N",
        ),
        (
            "unknown T: N; der(v) = g; m*der(v) = 2*m*g;",
            "the equations of `solve` do not determine `T`",
        ),
        (
            "der(v) = g; x = 2*x;",
            "`solve` has 2 equations, but 1 unknown",
        ),
        (
            "unknown T: N; m*der(v) = T; constraint v^2 = 1 [m^2/s^2];",
            "expected `within` after the constraint, found `;`",
        ),
        (
            "unknown T: N; m*der(v) = T; constraint m*g = 20 N within 1 N;",
            "neither `constraint m*g = 20 N within 1 N;` nor its derivatives have unknowns of this block",
        ),
    ];
    for (block, message) in cases {
        assert_eq!(error(&rest(block)), message, "{block}");
    }
    let many: String = { 0..13 }
        .map(|k| format!("unknown T{k}: N; T{k} = m*g;"))
        .collect();
    let message = error(&format!("der(w) = 0; der(v) = 0; solve {{ {many} }}"));
    assert_eq!(message, "`solve` has 13 unknowns; at most 12 are possible");
}

#[test]
fn what_is_differentiated_depends_on_what_has_a_derivative() {
    let cases = [
        (
            "let a = der(T); solve { unknown T: N; m*der(v) = T; T = m*g; }",
            "`T` depends on the unknown `T`",
        ),
        ("let a = partial(x^2, m); der(v) = 0;", "`m` is not a state"),
        (
            "let a = der(der(der(der(x^2)))); der(v) = x/(1 s^2);",
            "at most 3 derivatives may stand within one another",
        ),
    ];
    for (rest, message) in cases {
        assert_eq!(error(&format!("der(w) = 0; {rest}")), message, "{rest}");
    }
    let circular = error("der(w) = 0; der(v) = der(x*v)/(1 m);");
    assert_eq!(circular, "`der(v)` is defined by itself");
}

#[test]
fn derivatives_of_long_products_count_each_of_their_terms() {
    let with = |factors: usize| {
        let states: String = (0..factors)
            .map(|k| format!("state s{k} = 1; der(s{k}) = 1 [/s]; "))
            .collect();
        let names: Vec<String> = (0..factors).map(|k| format!("s{k}")).collect();
        let product = names.join("*");
        let rest =
            format!("{states} let a = {product}; let b = der(der(a)); der(v) = 0; der(w) = 0;");
        from_text("probe.hyz", &format!("{HEAD}{rest}"), &[])
    };
    assert!(with(12).is_ok());
    let message = with(60).expect_err("too long").to_string();
    assert!(message.contains("at most 25000 are possible"), "{message}");
}

const BODY: &str = "model probe; param m = 0.5 kg; param L = 2 m; param I = 1e-3 kg*m^2; frame N;
    frame C = N by quaternion (q0, q1, q2, q3);
    body probe { mass m; inertia diag(I, I, I) in C; fixed in C; position (x, y, z) in N;
    velocity (u, v, w) in C; angular velocity (p, q, r) in C; }
    force weight = -m*9.81 [m/s^2]*N.3;\n";

#[test]
fn constraints_hold_a_declared_body() {
    let read = |statements: &str| from_text("probe.hyz", &format!("{BODY}{statements}"), &[]);
    let rod = "force rod = -T*unit(position); solve rod { unknown T: N; constraint norm(position) = L within 1 mm; }";
    let model = read(rod).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(model.systems[0].constraints.len(), 2);
    // Three hold a point of it.
    let tip = "let tip = position - L*in_N(C.3); force tip = R; moment tip = (-L*C.3) × in_C(R);
        solve tip { unknown R: vector N in N;
          constraint tip.1 = 0 within 1 mm; constraint tip.2 = 0 within 1 mm; constraint tip.3 = 0 within 1 mm; }";
    let model = read(tip).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(model.systems[0].constraints.len(), 6);
    // Of velocities: once differentiated. The rim of a wheel does not slip.
    let wheel = "force grip = F*N.1; moment grip = in_C(-(0.1 [m])*N.3) × in_C(F*N.1);
        solve wheel { unknown F: N; constraint in_N(velocity).1 = 0.1 [m]*in_N(angular_velocity).2 within 1 mm/s; }";
    let model = read(wheel).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(model.systems[0].constraints.len(), 1);
    let refused = |statements: &str| read(statements).expect_err(statements).to_string();
    let message = refused("solve rod { unknown T: N; constraint norm(position) = L within 1 mm; }");
    assert!(
        message.contains("nor its derivatives have unknowns of this block"),
        "{message}"
    );
    let two = "force a = -T*unit(position); force b = F*N.2;
        solve a { unknown T: N; constraint norm(position) = L within 1 mm; }
        solve b { unknown F: N; constraint y = 0 within 1 mm; }";
    let message = refused(two);
    assert!(
        message.contains("the equations of `solve a` have `F`, which `solve b` determines"),
        "{message}"
    );
    let message = refused("let a = der(position); force b = 0*m*a/(1 s);");
    assert!(
        message.contains("`der(position)` follows from the forces and cannot be used here"),
        "{message}"
    );
}
