//! Small things that papers write: powers of quantities, turned frames, definitions in blocks.

use model_spec::load::from_text;
use model_spec::model::{FrameKind, Model};
use model_spec::syntax;
use model_spec::syntax::ast::{ExprKind, ItemKind};
use model_spec::unit::Unit;

const BODY: &str = "model probe; frame N; param m = 0.5 kg;
    point probe { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
";

fn read(statements: &str) -> Model {
    let text = format!("{BODY}{statements}");
    from_text("probe.hyz", &text, &[]).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

fn refused(statements: &str) -> String {
    let text = format!("{BODY}{statements}");
    let error = from_text("probe.hyz", &text, &[]).expect_err(statements);
    error
        .to_string()
        .lines()
        .next()
        .unwrap_or_default()
        .to_owned()
}

#[test]
fn a_power_of_a_quantity_has_a_unit_where_that_is_one() {
    let model =
        read("param V = 8 m^3; let edge = V^(1/3); let area = V^(-2/3); let half: m = edge/2;");
    let units: Vec<Unit> = model
        .aux_variables
        .iter()
        .map(|own| own.value.unit)
        .collect();
    assert_eq!(units[0], Unit::METRE);
    assert_eq!(units[1], Unit::METRE.checked_pow(-2, 1).unwrap());
    let message = refused("let a = z^(1/3);");
    assert!(
        message.contains("the base of `z^(1/3)` must be a pure number"),
        "{message}"
    );
    let message = refused("param n = 2; let a = z^n;");
    assert!(message.contains("must be a pure number"), "{message}");
}

#[test]
fn a_frame_is_turned_by_an_expression_of_parameters() {
    let statements = "param i_w = 2 deg; coefficient twist = 0.1 in -1 .. 1; param tilt = 2*i_w;
        function half(a: 1): 1 { return a/2; }
        frame A = N turned i_w about 2; frame B = A turned tilt about 1; frame C = B turned -3.5 deg about 3;
        frame D = C turned half(twist) + i_w about 1; force lift = 1 [N]*D.3;";
    let model = read(statements);
    assert_eq!(model.constant_angles.len(), 4);
    let turned = model.frames.iter().filter_map(|frame| match frame.kind {
        FrameKind::Fixed { angle, .. } => Some(model.text(model.constant_angles[angle].span)),
        _ => None,
    });
    let turned: Vec<String> = turned.collect();
    assert_eq!(turned, ["i_w", "tilt", "-3.5 deg", "half(twist) + i_w"]);
    let text = format!("{BODY}{statements}");
    let printed = syntax::parse("probe.hyz", &text).file.to_string();
    let again =
        from_text("printed.hyz", &printed, &[]).unwrap_or_else(|e| panic!("{printed}\n{e}"));
    let angles = again.constant_angles.iter().zip(&model.constant_angles);
    assert!({ angles }.all(|(own, before)| own.same(before)));
    for (statement, message) in [
        ("frame A = N turned m about 1;", "must be an angle"),
        (
            "input flap: deg = 0 in -9 .. 9; frame A = N turned flap about 1;",
            "may change during a flight",
        ),
        ("frame A = N turned 3 m about 1;", "must be an angle"),
        (
            "let twice = 2*z/(1 m); frame A = N turned twice about 1;",
            "may change during a flight",
        ),
        (
            "frame A = N turned a about 1; param a = norm(in_N((1, 0, 0) in A));",
            "depends on a vector",
        ),
    ] {
        let found = refused(statement);
        assert!(found.contains(message), "{found}");
    }
}

#[test]
fn a_frame_by_a_quaternion_is_spelt_for_whoever_turns_by_one() {
    let text = format!("{BODY}frame A = N turned (q0, q1, q2, q3);");
    let error = from_text("probe.hyz", &text, &[]).expect_err("no angle");
    let told = format!("{error:?}{error}");
    assert!(told.contains("by quaternion (q0, q1, q2, q3)"), "{told}");
}

#[test]
fn a_case_expects_something_and_sets_nothing_twice() {
    let nothing = refused("check \"c\" { set z = 1 m; }");
    assert!(nothing.contains("the case expects nothing"), "{nothing}");
    let twice =
        refused("check \"c\" { set z = 1 m; set z = 2 m; expect vz = 0 m/s within 1 m/s; }");
    assert!(twice.contains("`set z`"), "{twice}");
}

#[test]
fn a_body_does_not_turn_in_a_frame_that_is_turned_by_a_constant() {
    let text = "model probe; param m = 1 kg; param I = 1 kg*m^2; frame N; frame T = N turned 3 deg about 1;
        frame C = T by quaternion (q0, q1, q2, q3);
        body probe { mass m; inertia diag(I, I, I) in C; fixed in C; position (x, y, z) in N;
          velocity (u, v, w) in N; angular velocity (p, q, r) in C; }";
    let error = from_text("probe.hyz", text, &[]).unwrap_err().to_string();
    assert!(
        error.contains("the frame T is turned by a constant"),
        "{error}"
    );
}

#[test]
fn a_definition_in_a_block_is_one_of_the_model() {
    let text = "model probe; frame N; param m = 0.5 kg;
        point probe { let whole = 2*m; mass whole; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
        check \"a case\" { let twice = 2*x; set x = 3 m; expect twice = 6 m within 1e-12; }";
    let model = from_text("probe.hyz", text, &[]).unwrap_or_else(|e| panic!("{e}"));
    let names: Vec<&str> = model
        .aux_variables
        .iter()
        .map(|own| own.name.as_str())
        .collect();
    assert_eq!(names, ["whole", "twice"]);
}

#[test]
fn comments_stand_anywhere_in_an_effect() {
    let text = format!(
        "{BODY}//! of the file
        force weight = -m*9.81 [m/s^2]*N.3;
        /// documented
        effect push {{ // here
          //! and there
          /// site
          site drag; /* no */"
    );
    let text = text.replace(" /* no */", "")
        + "
          /// what it depends on
          variables none; // nothing
          /// size
          coefficient k = 0 N in -1 .. 1;
          /// what matters
          negligible k 1e-3 N;
          // last
          replace force weight = previous + k*N.1; // behind
          // at the end
        }";
    from_text("probe.hyz", &text, &["push"]).unwrap_or_else(|e| panic!("{e}"));
}

/// Whoever changes the copy of a function that a call has become is told, as whoever changes the function is.
#[test]
fn the_result_of_a_copied_function_has_its_type() {
    let text = "model probe; param k = 2 kg/s; frame N;
        point probe { mass 1 kg; position (x, y, z) in N; velocity (u, v, w) in N; }
        function drag(v: vector m/s in N): vector N in N { return k*v; }
        force drag = drag(velocity);";
    let mut file = syntax::parse("probe.hyz", text).file;
    assert!(model_spec::check(&file, &[]).model.is_some());
    let mut values = file
        .items
        .iter_mut()
        .filter_map(|item| match &mut item.kind {
            ItemKind::Load(load) => Some(&mut load.value),
            _ => None,
        });
    let value = values.next().expect("the force");
    let ExprKind::Ascribed(result, _) = &mut value.kind else {
        panic!("{value}")
    };
    let ExprKind::Binary(_, factor, _) = &result.kind else {
        panic!("{result}")
    };
    **result = (**factor).clone();
    let found = model_spec::check(&file, &[]).diagnostics;
    assert_eq!(found.len(), 1, "{found:?}");
    let message = "the result of `drag` must be a vector";
    assert!(found[0].message.starts_with(message), "{found:?}");
}

#[test]
fn pure_numbers_in_types_are_printed_as_they_are_read() {
    let text = "function half(a: 1, v: vector 1 in N): vector 1 in N { return a*v/2; }
        let way = half(1, N.1);
        solve { unknown push: vector 1 in N; push = way; }";
    let printed = read(text).tree.to_string();
    let again = syntax::parse("probe.hyz", &printed);
    assert!(again.diagnostics.is_empty(), "{printed}");
    assert_eq!(again.file.to_string(), printed);
}

#[test]
fn mass_and_inertia_of_each_body_are_checked() {
    let text = |mass: &str, inertia: &str| {
        format!(
            "model pair; frame N; frame C = N by quaternion (e0, e1, e2, e3);
             point first {{ mass 1 kg; position (x, y, z) in N; velocity (u, v, w) in N; }}
             body second {{ mass {mass}; inertia {inertia} in C; fixed in C; position (x2, y2, z2) in N;
               velocity (u2, v2, w2) in N; angular velocity (p, q, r) in C; }}"
        )
    };
    let right = "((2, 0.5, 0), (0.5, 2, 0), (0, 0, 1.6)) kg*m^2";
    from_text("pair.hyz", &text("1 kg", right), &[]).unwrap_or_else(|error| panic!("{error}"));
    for (mass, inertia, expected) in [
        ("-1 kg", right, "the mass must be positive"),
        ("1 kg", "diag(1, -1, 1) kg*m^2", "must be positive"),
        (
            "1 kg",
            "((1, 0.5, 0), (0.1, 1, 0), (0, 0, 1)) kg*m^2",
            "moments of inertia are symmetric",
        ),
        (
            "1 kg",
            "((1, 5, 0), (5, 1, 0), (0, 0, 1)) kg*m^2",
            "is not positive definite",
        ),
        ("1 kg", "diag(1, 1, 2.1) kg*m^2", "is that of no body"),
        (
            "1 kg",
            "((1, 0.9, 0.9), (0.9, 1, -0.9), (0.9, -0.9, 1)) kg*m^2",
            "is not positive definite",
        ),
    ] {
        let error = from_text("pair.hyz", &text(mass, inertia), &[]).expect_err(expected);
        assert!(error.to_string().contains(expected), "{error}");
    }
}

/// The text without comments, with `gap` in place of each white space outside of quotation marks.
fn with_gaps(text: &str, gap: &str) -> String {
    let mut out = String::new();
    for line in text.lines() {
        let code = line.split("//").next().unwrap_or_default();
        for (k, part) in code.split('"').enumerate() {
            let quote = if k > 0 { "\"" } else { "" };
            out += quote;
            out += &match k % 2 {
                0 => part.split_whitespace().collect::<Vec<_>>().join(gap),
                _ => part.to_owned(),
            };
            if k % 2 == 0 {
                out += gap;
            }
        }
        out += gap;
    }
    out
}

#[test]
fn line_breaks_mean_nothing() {
    let own = "model breaks; frame N; param m = 0.5 kg in 0 .. 3 kg; param d[i] for i in 1..2 = (3, 4) in ;
        point p { mass m; position (x, y, z) in N = (0, 0, 1) m; velocity (vx, vy, vz) in N; }
        table T(a: m): N = { 0: 1, 1 ft: 2, 2 m: 3 } monotone , constant ;
        let e = 5 m + x + 5 [m] ; limit z > -1 km \"it is lost\";
        force f = T(x)*N.1 + 2 N *N.2 - 3 N * (1, 0, 0) in N;
        check \"still\" { set z = 2 m; expect e = 10 m within 1 mm; }";
    let models = model_spec::load::MODELS.iter();
    for (name, text) in models.copied().chain([("breaks", own)]) {
        let [one_line, many] = [" ", "\n"].map(|gap| with_gaps(text, gap));
        let [one_line, many] = [one_line, many].map(|text| {
            let tree = model_spec::ModelTree::parse(name, &text);
            tree.unwrap_or_else(|error| panic!("{name}: {error}"))
                .to_text("")
        });
        assert_eq!(one_line, many, "{name}");
    }
}

#[test]
fn what_is_set_may_be_spelt_as_in_the_model() {
    let text =
        "model spelt; frame N; param m = 1 kg; coefficient k[i] for i in 1..2 = 3 N; param ρ = 2;
        point p { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
        force f = (k[1] + k[2]*rho)*N.1; param twice = 2*m;";
    let model = model_spec::load::from_text("spelt", text, &[]).unwrap();
    let model = model.with_values([("k[2]", 7.0), ("ρ", 5.0)]).unwrap();
    let model = model.check().unwrap();
    assert_eq!(model.coefficients[1].value, 7.0);
    assert_eq!(model.params[1].value, 5.0);
    assert!(model.is_computed("twice") && !model.is_computed("m"));
}

#[test]
fn divisors_and_tangents_of_bounded_angles_are_kept_from_zero() {
    let angles = "param tilt = 10 deg in -80 .. 80 deg; param turn = 10 deg in -90 .. 90 deg;
        coefficient a = 1.5 in 1.2 .. 2;";
    for allowed in [
        "tan(45 deg)",
        "tan(tilt)",
        "1/cos(30 deg)",
        "1/sin(30 deg)",
        "1/tan(-20 deg)",
        "1/cos(tilt)",
        "1/log(a)",
        "1/log(2)",
        "1/cos(pi)",
        "tan(atan(a - 3))",
        "1/sqrt(dot(velocity, velocity) + (1e-8 [m^2/s^2]))",
    ] {
        read(&format!("{angles} let b = {allowed};"));
    }
    for (wrong, what) in [
        ("tan(90 deg)", "is infinite"),
        ("tan(turn)", "is infinite"),
        ("tan(100*tilt)", "is infinite"),
        ("1/cos(270 deg)", "may be zero"),
        ("1/sin(tilt)", "may be zero"),
        ("1/sin(180 deg)", "may be zero"),
        ("1/tan(pi)", "may be zero"),
        ("1/log(a - 0.2)", "may be zero"),
    ] {
        let message = refused(&format!("{angles} let b = {wrong};"));
        assert!(message.contains(what), "{wrong}: {message}");
    }
}

#[test]
fn limits_keep_sums_of_squares_and_ranges_from_zero() {
    let speed = "let speed = sqrt(vx^2 + vy^2); limit speed > 0 \"it hangs\";";
    let velocity = "let speed = norm(velocity); limit speed^2 > 0 \"it hangs\";";
    let steep = "let gamma = atan2(vz, vx); limit 80 deg - abs(gamma) > 0 \"too steep\";";
    for (limit, allowed) in [
        (speed, "1/(vx^2 + vy^2)"),
        (speed, "1/sqrt(vx^2 + vy^2 + vz^2)"),
        (speed, "1/norm(velocity)"),
        (speed, "1/norm((velocity.1, velocity.2, 0) in N)"),
        (velocity, "1/dot(velocity, velocity)"),
        (velocity, "1/(vx*vx + vy^2 + velocity.3^2)"),
        (velocity, "1/norm(velocity)^3"),
        ("limit abs(vx) > 1 m/s \"slow\";", "1/vx"),
        ("limit vx^2 > 0 \"slow\";", "1/vx^3"),
        ("limit vx > 2 m/s \"slow\";", "1/(vx - 1 [m/s])"),
        ("limit vx > -2 m/s \"back\";", "1/(vx + 3 [m/s])"),
        ("limit 5 [m/s] - vx > 0 \"fast\";", "1/(6 [m/s] - vx)"),
        (steep, "tan(gamma)/cos(gamma)"),
    ] {
        read(&format!("{limit} let b = {allowed};"));
    }
    for (limit, wrong) in [
        (speed, "1/vx"),
        (speed, "1/(vx^2 + vz^2)"),
        (speed, "1/(vx^2 - vy^2)"),
        (velocity, "1/(vx^2 + vy^2)"),
        ("limit vx > 0.5 m/s \"slow\";", "1/(vx - 1 [m/s])"),
        ("limit vx > -2 m/s \"back\";", "1/vx^2"),
        (steep, "1/sin(gamma)"),
    ] {
        let message = refused(&format!("{limit} let b = {wrong};"));
        assert!(message.contains("may be zero"), "{wrong}: {message}");
    }
}

#[test]
fn moments_of_inertia_by_a_chain_of_names_take_no_time() {
    let links = (1..60).map(|k| format!("let I{k} = (I{0} + I{0})/2;\n", k - 1));
    let text = |third: &str| {
        format!(
            "model chain; param m = 1 kg; param I = 1e-3 kg*m^2; frame N;
             frame A = N turned phi about 1; frame B = A turned theta about 2; frame C = B turned gamma about 3;
             let I0 = I; {}
             body chain {{ mass m; inertia diag(I59, I59, {third}) in C; fixed in C; position (x, y, z) in N;
             velocity (u, v, w) in N; }} force weight = -m*(9.8 [m/s^2])*N.3; marker k in C; observe k = position + in_N(k);",
            links.clone().collect::<String>()
        )
    };
    from_text("chain.hyz", &text("2*I59"), &[]).expect("a flat body");
    let error = from_text("chain.hyz", &text("3*I59"), &[]).expect_err("of no body");
    assert!(error.to_string().contains("that of no body"), "{error}");
}
