//! What errors advise where a newcomer guesses the notation.

use model_spec::load::from_text;

const BODY: &str = "model probe; frame N; param m = 0.5 kg; input wind in N = (0, 0, 0) m/s;
    point probe { mass m; position (x, y, z) in N; velocity (u, v, w) in N; }
";

fn refused(statements: &str) -> String {
    let text = format!("{BODY}{statements}");
    let error = from_text("probe.hyz", &text, &[]).expect_err(statements);
    error.to_string()
}

fn is_told(cases: &[(&str, &[&str])]) {
    for (statements, parts) in cases {
        let told = refused(statements);
        for part in *parts {
            assert!(told.contains(part), "{statements}\n{told}");
        }
    }
}

#[test]
fn an_index_in_the_brackets_is_led_to_the_form_of_arrays() {
    is_told(&[
        (
            "param chord[i in 1..8] = 8 mm;",
            &["found `in`", "`chord[i] for i in 1..8 = …`"],
        ),
        ("let a[i in 1..8] = 1;", &["`a[i] for i in 1..8 = …`"]),
        ("force f[k in 1..2] = N.3;", &["`f[k] for k in 1..2 = …`"]),
    ]);
}

#[test]
fn what_papers_write_is_led_to_the_notation() {
    is_told(&[
        (
            "let s[k, i] for k in 1..2, i in 1..8 = k*i; let a = s_1,8;",
            &["`s[1, 8]`"],
        ),
        (
            "let s[k, i] for k in 1..2, i in 1..8 = k*i; let a = (s_1,8);",
            &["`s[1, 8]`"],
        ),
        ("let a = 1,5;", &["decimals have a point: `1.5`"]),
        ("let a = 2*(u, w);", &["three components: `(u, w, 0)`"]),
        ("coefficient c = pi;", &["`pi` is 3.14159"]),
        ("coefficient a = 0.2, b = 0.3;", &["a statement of its own"]),
        (
            "state a = 1; (1 + m/(1 kg))*der(a) = 1/(1 s);",
            &["a block `solve { … }`"],
        ),
        (
            "function f(a) -> vector N in N { return N.1; }",
            &["behind a colon"],
        ),
        ("function f(a) { return a*N.1; }", &["`): vector … in N`"]),
        (
            "function f(a) { let place = a; return place; } let b = place;",
            &["within the function `f` alone"],
        ),
        ("force weight = -m*g*N.3;", &["`param g = 9.81 m/s^2;`"]),
        ("let drag = velocity/norm(velocity);", &["`unit(v)`"]),
        (
            "param length = max(1, 2) m;",
            &["a unit stands behind a number: `*(1 m)`"],
        ),
        (
            "param I = 2*0.5*40 kg*m^2; let a = I + 1 [kg*m^2];",
            &[
                "`40 kg*m^2` is `40 kg` times the quantity `m`",
                "`40 [kg*m^2]`",
            ],
        ),
        (
            "let a[k] for k in -1..1 = k;",
            &["`k in 1..2`", "`3 - 2*k`"],
        ),
    ]);
}

#[test]
fn a_function_with_an_error_is_not_said_to_return_nothing() {
    let told = refused("function f(a) { return a }");
    assert!(
        told.contains("`;` at the end of this `return`") && !told.contains("nothing"),
        "{told}"
    );
}

#[test]
fn a_marker_has_no_place_and_stands_for_all() {
    is_told(&[
        (
            "marker tip in N = (36, 0, 0) mm;",
            &[
                "comes with each recording",
                "stands for all markers",
                "`marker tip in N;`",
            ],
        ),
        (
            "marker tip in N; marker root in N;",
            &["`marker` is stated twice", "it stands for all markers"],
        ),
    ]);
}

#[test]
fn a_case_is_led_to_numbers() {
    let case = |inner: &str| refused(&format!("check \"c\" {{ {inner} }}"));
    for inner in [
        "expect der(velocity).3 = 0 m/s^2 within 1 m/s^2;",
        "expect der(velocity.3) = 0 m/s^2 within 1 m/s^2;",
        "expect der(velocity) = (0, 0, 0) m/s^2 within 1 m/s^2;",
        "expect der(velocity) = 0 m/s^2 within 1 m/s^2;",
    ] {
        let told = case(inner);
        assert!(told.contains("`expect der(w) = …`"), "{told}");
    }
    let told = case("set wind.3 = 1 m/s;");
    assert!(
        told.contains("`set wind = (…, …, …);`") && told.contains("`wind_z`"),
        "{told}"
    );
    let told = case("expect wind = (0, 0, 0) m/s within 1 m/s;");
    assert!(told.contains("`let wind_3 = wind.3;`"), "{told}");
}

#[test]
fn an_acceleration_is_led_to_what_there_is() {
    for statement in [
        "let ac = acceleration;",
        "let b = der(velocity);",
        "let b = der(w);",
    ] {
        let told = refused(statement);
        let is_told = told.contains("`specific_force`") && told.contains("`expect der(w) = …`");
        assert!(is_told, "{told}");
    }
}
