//! Tables: what is read, printed and added by effects.

use model_spec::load::from_text;
use model_spec::model::{Continuation, Interpolation, Model};
use model_spec::syntax;

const MODEL: &str = "model probe;
frame N;
param m = 0.5 kg;
point probe { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
";

fn read(statements: &str) -> Model {
    let text = format!("{MODEL}{statements}");
    from_text("probe.hyz", &text, &[]).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn numbers_have_the_unit_of_their_column_or_their_own() {
    let model = read(
        "/// along the height\ntable wind(height: m): km/h = { 0: 0, 50 cm: 3.6, 2: 2 m/s, } monotone, constant;
         table slope(alpha) = { -10 deg: -1, 0: 0, 0.5 rad: 2 };",
    );
    let [wind, slope] = &model.tables[..] else {
        panic!("two tables")
    };
    let close = |(x, y): (f64, f64), (a, b): (f64, f64)| {
        assert!((x - a).abs() < 1e-15 && (y - b).abs() < 1e-15, "({x}, {y})");
    };
    close(wind.points()[1], (0.5, 1.0));
    close(wind.points()[2], (2.0, 2.0));
    close(slope.points()[0], (-10_f64.to_radians(), -1.0));
    assert_eq!(wind.doc, "along the height");
    assert_eq!(wind.arguments[0].unit_text, "m");
    assert_eq!(wind.unit_text, "m/s");
    assert_eq!(
        (wind.interpolation, wind.continuation),
        (Interpolation::Monotone, Continuation::Constant)
    );
    assert_eq!(
        (slope.interpolation, slope.continuation),
        (Interpolation::Spline, Continuation::Linear)
    );
}

#[test]
fn a_table_of_two_arguments_prints_and_reads_as_the_same() {
    let statements = "table a(x: deg, y: m): N = { y: (0, 50 cm, 2), 0: (1, 2, 3), 0.5 rad: (4 kN, 5, 6) } linear;
        let b = a(0.2, z);";
    let model = read(statements);
    let table = &model.tables[0];
    assert_eq!(table.arguments[0].knots, [0.0, 0.5]);
    assert_eq!(table.arguments[1].knots, [0.0, 0.5, 2.0]);
    assert_eq!(table.values, [1.0, 2.0, 3.0, 4000.0, 5.0, 6.0]);
    let text = format!("{MODEL}{statements}");
    let printed = syntax::parse("probe.hyz", &text).file.to_string();
    let again =
        from_text("printed.hyz", &printed, &[]).unwrap_or_else(|e| panic!("{printed}\n{e}"));
    assert_eq!(again.tables[0].fingerprint(), table.fingerprint());
    let points = model_spec::singular_points(&model);
    assert!(
        points
            .iter()
            .any(|point| point.what == "has a kink at each knot of the table `a`")
    );
}

#[test]
fn a_model_with_a_wrong_unit_in_a_table_has_all_its_knots() {
    let text = format!("{MODEL}table a(x: m) = {{ 0: 1, 1 s: 2 kg, 2: 3 }}; let b = a(z);");
    let loaded = model_spec::load::inspect_text("probe.hyz", &text, &[]).unwrap();
    assert_eq!(loaded.diagnostics.len(), 2);
    assert_eq!(loaded.model.unwrap().tables[0].points().len(), 3);
}

#[test]
fn calls_of_a_table_of_two_arguments_are_checked() {
    for (statement, message) in [
        ("let b = a(z);", "takes two numbers"),
        (
            "let b = a(m, z);",
            "the argument `x` of `a` must be a length",
        ),
        ("let b = a(z, z) + m;", "different units"),
    ] {
        let table = "table a(x: m, y: m) = { y: (0, 1), 0: (1, 2), 1: (3, 4) };";
        let error = from_text("probe.hyz", &format!("{MODEL}{table}{statement}"), &[]).unwrap_err();
        assert!(error.to_string().contains(message), "{error}");
    }
}

#[test]
fn a_printed_table_reads_as_the_same() {
    let statements = "table a(x: m): kg/m = { 0: 1, 1 cm: 2 g/m, 2: 3 } constant;
        table b(x) = { 0: 1, 1: 2, 2: 3 } monotone;
        let c = a(z)*b(2);";
    let text = format!("{MODEL}{statements}");
    let printed = syntax::parse("probe.hyz", &text).file.to_string();
    let again =
        from_text("printed.hyz", &printed, &[]).unwrap_or_else(|e| panic!("{printed}\n{e}"));
    let knots = |model: &Model| -> Vec<_> {
        let tables = model.tables.iter();
        tables
            .map(|t| {
                let arguments = t.arguments.clone();
                let values = t.values.clone();
                (arguments, values, t.unit, t.interpolation, t.continuation)
            })
            .collect()
    };
    assert_eq!(knots(&read(statements)), knots(&again));
}

#[test]
fn an_effect_may_bring_a_table() {
    let text = format!(
        "{MODEL}let share = 0;
        effect sheltered {{ site wind; coefficient k = 0 in -2 .. 2;
          table of_height(z: m) = {{ 0: 0, 2: 0.5, 5: 1 }};
          replace share = previous + k*of_height(z); }}"
    );
    let plain = from_text("probe.hyz", &text, &[]).unwrap();
    assert!(plain.tables.is_empty());
    let with = from_text("probe.hyz", &text, &["sheltered"]).unwrap();
    assert_eq!(with.tables.len(), 1);
}

#[test]
fn a_table_may_share_the_name_of_a_quantity() {
    let model = read("table C_L(a) = { 0: 0, 1: 0.5, 5: 1 }; let C_L = C_L(z/1 [m]);");
    assert_eq!(model.aux_variables[0].name, "C_L");
}

#[test]
fn the_number_of_knots_and_of_tables_is_bounded() {
    let table = |name: usize, knots: usize| {
        let knots: Vec<String> = (0..knots).map(|k| format!("{k}: {}", k % 7)).collect();
        format!("table t{name}(a) = {{ {} }};", knots.join(", "))
    };
    let fails = |statements: String, why: &str| {
        let text = format!("{MODEL}{statements}");
        let error = from_text("probe.hyz", &text, &[]).unwrap_err().to_string();
        assert!(error.contains(why), "{error}");
    };
    read(&table(0, 10_000));
    fails(table(0, 10_001), "has 10001 knots");
    fails(table(0, 1), "has 1 knot, but must");
    let many = |count: usize| (0..count).map(|k| table(k, 3)).collect::<String>();
    read(&many(100));
    fails(many(101), "at most 100 tables");
}
