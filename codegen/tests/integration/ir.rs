//! A model as JSON: the same text each time, operations that are documented, errors for what JSON cannot hold.

use crate::support::{with_zoo, zoo};
use codegen::ir::{IrError, json};
use std::collections::BTreeSet;

#[test]
fn a_model_gives_the_same_text_each_time() {
    for model in with_zoo() {
        let text = json(&model).unwrap();
        assert_eq!(text, json(&model).unwrap());
        let start = "{\n\"schema\":\"hyzer.ir/1\",\n\"version\":\"";
        assert!(
            text.starts_with(start) && text.ends_with("\n}\n}\n"),
            "{text}"
        );
    }
}

#[test]
fn every_operation_is_in_the_page_and_in_the_schema() {
    let page = include_str!("../../../docs/reference/ir.md");
    let schema = include_str!("../../../docs/reference/ir.schema.json");
    let text = json(&zoo()).unwrap();
    let statements = text.lines().filter_map(|line| line.strip_prefix("[\""));
    let operations = statements.filter_map(|line| line.split('"').next());
    let operations: BTreeSet<&str> = operations.collect();
    assert!(operations.len() > 20, "{operations:?}");
    for operation in operations {
        assert!(page.contains(&format!("`{operation}`")), "{operation}");
        assert!(schema.contains(&format!("\"{operation}\"")), "{operation}");
    }
}

#[test]
fn a_constant_that_is_not_finite_is_an_error() {
    let text = "model burst; frame N; param k = 1 1/s; state a = 1; der(a) = k*a*1e300*1e300;";
    let model = model_spec::load::from_text("burst", text, &[]).unwrap();
    let Err(IrError::NotFinite { place, value, .. }) = json(&model) else {
        panic!("an infinite constant")
    };
    assert_eq!(
        (place.as_str(), value),
        ("the function `prepare`", f64::INFINITY)
    );
}

#[test]
fn strings_are_quoted() {
    let text = "model quoted; frame N; /// the \"gain\" of C:\\\nparam k = 1 1/s; state a = 1; der(a) = k*a; limit a > 0 \"a\u{9}tab\";";
    let model = model_spec::load::from_text("quoted", text, &[]).unwrap();
    let text = json(&model).unwrap();
    assert!(text.contains(r#""doc":"the \"gain\" of C:\\""#), "{text}");
    assert!(text.contains(r#""reason":"a\u0009tab""#), "{text}");
}
