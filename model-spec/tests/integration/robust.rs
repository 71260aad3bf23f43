//! No input makes the reader or the checks panic, hang or overflow the stack.

use model_spec::load::{self, EFFECTS, MODELS, REFUTED};
use model_spec::syntax::ast::{Expr, ExprKind, ItemKind};
use model_spec::syntax::parse;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use rustix::time::{ClockId, clock_gettime};

/// Loads a model text, renders its errors and summarizes the model, on a thread with a small stack (1 MiB). Fails if
/// that panics or takes 5 s or more of the processor.
fn digest(text: String) {
    let work = move || {
        let start = processor_time();
        let loaded = load::inspect_text("random.hyz", &text, &[]).unwrap();
        let shown = model_spec::render(&loaded.diagnostics, &loaded.sources, false);
        assert_eq!(shown.is_empty(), loaded.diagnostics.is_empty());
        if let Some(model) = loaded.model {
            let summary = model_spec::summary(&model);
            assert!(summary.starts_with("model "));
        }
        processor_time() - start
    };
    let seconds = std::thread::Builder::new()
        .stack_size(1 << 20)
        .spawn(work)
        .unwrap()
        .join()
        .unwrap();
    assert!(seconds < 5.0, "took {seconds} s");
}

/// Processor time of the thread, s: other tests share the processor.
fn processor_time() -> f64 {
    let now = clock_gettime(ClockId::ThreadCPUTime);
    now.tv_sec as f64 + 1e-9 * now.tv_nsec as f64
}

const TOKENS: &[&str] = &[
    "model",
    "probe",
    "reference",
    "param",
    "coefficient",
    "input",
    "state",
    "frame",
    "body",
    "point",
    "let",
    "table",
    "monotone",
    "constant",
    "force",
    "moment",
    "der",
    "marker",
    "observe",
    "limit",
    "check",
    "effect",
    "set",
    "expect",
    "within",
    "replace",
    "site",
    "source",
    "negligible",
    "previous",
    "turned",
    "about",
    "by",
    "quaternion",
    "in",
    "mass",
    "inertia",
    "diag",
    "fixed",
    "position",
    "velocity",
    "angular",
    "N",
    "A",
    "B",
    "x",
    "y",
    "z",
    "u",
    "alpha",
    "α",
    "φ̇",
    "m",
    "kg",
    "s",
    "rad",
    "deg",
    "C_L",
    "sin",
    "atan2",
    "norm",
    "unit",
    "ratio",
    "in_N",
    "dot",
    "cross",
    "pi",
    "time",
    "1",
    "2",
    "3",
    "0",
    "-1e-5",
    "1e999",
    "0.175",
    "^",
    "²",
    "⁻¹",
    "+",
    "-",
    "−",
    "*",
    "·",
    "×",
    "/",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ";",
    ";",
    ";",
    ":",
    "=",
    ">",
    "<",
    "..",
    ".",
    "\"a\"",
    "\"",
    "//",
    "///",
    "//!",
    "\n",
    "\n",
    "#",
    "\0",
];

fn models() -> Vec<&'static str> {
    MODELS
        .iter()
        .chain(REFUTED)
        .chain(EFFECTS)
        .map(|(_, text)| *text)
        .collect()
}

/// Byte offset of a pseudo-random character boundary in a text; may be the end of the text.
fn boundary(text: &str, index: &Index) -> usize {
    let mut at = index.index(text.len() + 1);
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_bytes_are_digested(bytes in prop::collection::vec(any::<u8>(), 0..600)) {
        match load::decode("random.hyz", bytes) {
            Ok(text) => digest(text),
            Err(error) => prop_assert!(error.to_string().contains("UTF-8")),
        }
    }

    #[test]
    fn random_characters_are_digested(text in "\\PC{0,400}") {
        digest(text);
    }

    #[test]
    fn soups_of_tokens_are_digested(tokens in prop::collection::vec(select(TOKENS), 0..400)) {
        digest(tokens.join(" "));
    }

    #[test]
    fn soups_after_a_good_beginning_are_digested(tokens in prop::collection::vec(select(TOKENS), 0..200)) {
        digest(format!("{}\n{}", MODELS[1].1, tokens.join(" ")));
    }

    #[test]
    fn changed_models_are_digested(
        text in select(models()),
        cuts in prop::collection::vec((any::<Index>(), any::<Index>(), select(TOKENS)), 1..6),
    ) {
        let mut text = text.to_owned();
        for (from, length, token) in &cuts {
            let start = boundary(&text, from);
            let mut end = start + length.index(40).min(text.len() - start);
            while !text.is_char_boundary(end) {
                end += 1;
            }
            text.replace_range(start..end, token);
        }
        digest(text);
    }

    #[test]
    fn what_is_written_groups_as_it_did(text in expression()) {
        let first = parsed(&text);
        let again = parsed(&first.to_string());
        prop_assert_eq!(grouped(&first), grouped(&again));
    }
}

/// Generates texts of random expressions, with parentheses at random positions.
fn expression() -> impl Strategy<Value = String> {
    let leaf = select(vec![
        "x",
        "y",
        "z",
        "2",
        "3.5",
        "4 [m/s]",
        "N.3",
        "(x, y, 1) in N",
        "der(x)",
    ]);
    leaf.prop_map(str::to_owned)
        .prop_recursive(6, 40, 3, |inner| {
            let operator = select(vec![" + ", " - ", "*", "/", "^", "·", " × "]);
            prop_oneof![
                (inner.clone(), operator, inner.clone())
                    .prop_map(|(a, op, b)| format!("{a}{op}{b}")),
                inner.clone().prop_map(|a| format!("({a})")),
                inner.clone().prop_map(|a| format!("-{a}")),
                inner.clone().prop_map(|a| format!("sin({a})")),
                inner.prop_map(|a| format!("({a})²")),
            ]
        })
}

fn parsed(text: &str) -> Expr {
    let parsed = parse("expression.hyz", &format!("let a = {text};"));
    assert!(
        parsed.diagnostics.is_empty(),
        "{text}: {:?}",
        parsed.diagnostics
    );
    match &parsed.file.items[0].kind {
        ItemKind::Let(binding) => binding.value.clone(),
        other => panic!("{other:?}"),
    }
}

/// Prints an expression with parentheses around every operation, so that the text shows how it was parsed.
fn grouped(e: &Expr) -> String {
    match &e.kind {
        ExprKind::Number(q) => q.to_string(),
        ExprKind::Name(name) => name.clone(),
        ExprKind::Part(of, part) => format!("{}.{part}", grouped(of)),
        ExprKind::Derivative(state) => format!("der({})", state.text),
        ExprKind::Components(parts, frame) => {
            format!(
                "({}) in {}",
                parts.each_ref().map(grouped).join(", "),
                frame.text
            )
        }
        ExprKind::Neg(of) => format!("(-{})", grouped(of)),
        ExprKind::Binary(op, a, b) => format!("({} {op:?} {})", grouped(a), grouped(b)),
        ExprKind::Call(name, arguments) => {
            let arguments: Vec<String> = arguments.iter().map(grouped).collect();
            format!("{}({})", name.text, arguments.join(", "))
        }
        other => panic!("none of the expressions above: {other:?}"),
    }
}

#[test]
fn chains_of_definitions_are_digested() {
    // Each uses the one before twice; nothing may follow all paths.
    let mut text = MODELS[0].1.to_owned();
    text += "let a0 = x;\n";
    for i in 1..20_000 {
        text += &format!("let a{i} = a{} + a{};\n", i - 1, i - 1);
    }
    digest(text.clone());
    // The same, each declared before what it uses.
    let mut lines: Vec<&str> = text.lines().collect();
    let head = lines.iter().position(|l| l.starts_with("let a0")).unwrap();
    lines[head..].reverse();
    digest(lines.join("\n"));
}

#[test]
fn many_unknown_units_are_digested() {
    let mut text = MODELS[0].1.to_owned();
    for i in 0..5000 {
        text += &format!(
            "param k{i} = 1 [?];\nlet b{i} = k{i}*{};\n",
            if i == 0 {
                "x".to_owned()
            } else {
                format!("b{}", i - 1)
            }
        );
    }
    digest(text);
    let mut text = MODELS[0].1.to_owned();
    for i in 0..5000 {
        text += &format!("param k{i} = 1 [?];\n");
    }
    for i in 1..5000 {
        text += &format!("let c{i} = k{i} + k{};\n", i - 1);
    }
    digest(text);
}

#[test]
fn powers_of_powers_are_digested() {
    let mut text = MODELS[0].1.to_owned();
    text += "let p0 = m;\n";
    for i in 1..200 {
        text += &format!("let p{i} = p{}^64;\n", i - 1);
    }
    digest(text);
}

#[test]
fn files_as_long_as_they_may_be_are_digested_quickly() {
    let base = MODELS[0].1;
    /// Function that returns one line of a long model text, for the given line number.
    type Line = fn(usize) -> String;
    let lines: [(&str, Line); 23] = [
        ("", |_| "a;".into()),
        ("", |i| format!("model m{i};")),
        ("", |i| format!("frame F{i} = G{i} turned a about 1;")),
        ("model m; frame F0;", |i| {
            format!("frame F{} = F{i} turned a{i} about 1;", i + 1)
        }),
        ("model m; frame N;", |i| {
            format!("state x{i} = 1; der(y{i}) = 1;")
        }),
        ("model m; frame N;", |i| {
            format!("state x{i} = 1; der(x{i}) = der(x{});", i + 1)
        }),
        (base, |i| format!("check \"{i}\" {{}}")),
        (base, |i| {
            format!("check \"{i}\" {{ set q{i} = 1; expect q{i} = 1 within 1; }}")
        }),
        (base, |i| format!("effect e{i} {{ site drag; }}")),
        (base, |i| format!("limit x > {i} \"a\";")),
        (base, |i| format!("let a{i} = b{i};")),
        (base, |i| format!("let a{i} = f{i}(x);")),
        (base, |i| format!("let a{i} = in_F{i}(x);")),
        (base, |i| format!("let a{i} = x/z;")),
        (base, |i| format!("let a{i} = x + vx;")),
        (base, |i| format!("let a{i} = 1/(x*y*z*vx*vy*vz);")),
        (base, |i| format!("let a{i} = a{};", i + 1)),
        (base, |i| format!("let a{i} = a{i} + a{};", i + 1)),
        (base, |i| format!("param a{i} = 3 furlong{i};")),
        (base, |i| format!("force f{i} = x;")),
        (base, |_| "force f = x*N.1;".into()),
        (base, |i| format!("input w{i} in M{i} = (0, 0, 0);")),
        (base, |i| {
            format!("marker m{i} in N; observe m{i} = position;")
        }),
    ];
    for (head, line) in lines {
        let mut text = head.to_owned();
        let mut i = 0;
        while text.len() < 500_000 {
            text += &line(i);
            text.push('\n');
            i += 1;
        }
        digest(text);
    }
    // Units inferred from one another, solved from the far end of the chain and then used.
    let mut text = base.to_owned();
    (0..10_000).for_each(|i| text += &format!("param c{i} = 1 [?];\n"));
    let chain = (0..9_999).rev();
    chain.for_each(|i| text += &format!("let l{i} = c{i} + c{};\n", i + 1));
    (0..5_000).for_each(|i| text += &format!("let u{i} = c9999 + c{};\n", i * 2));
    digest(text);
    // One effect that replaces very much.
    let mut text = base.to_owned();
    (0..15_000).for_each(|i| text += &format!("let a{i} = x;\n"));
    text += "effect e { site drag;\n";
    (0..15_000).for_each(|i| text += &format!("replace a{i} = y; negligible b{i} 1;\n"));
    text += "}\n";
    digest(text);
    // One expression with very many names, and a fault.
    let names: Vec<String> = (0..30_000).map(|i| format!("a{i}")).collect();
    let mut text = base.to_owned();
    names
        .iter()
        .for_each(|n| text += &format!("param {n} = 1;\n"));
    let rows: Vec<String> = names
        .chunks(170)
        .map(|c| format!("({})", c.join("*")))
        .collect();
    text += &format!("let s = x + vx*({});\n", rows.join(" + "));
    digest(text);
}
