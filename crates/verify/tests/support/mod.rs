//! Models with a line changed, and their checks.

use model_spec::load::{Loaded, inspect, inspect_text};
use verify::Options;
use verify::report::{Report, Row, Verdict};

/// Few points and no mutants: a fault shows at almost every point.
pub const QUICK: Options = Options {
    seed: 1,
    cases: 24,
    mutants: false,
    effects: true,
};

/// Checks that refute a built-in model for a defect that is known and not the model's.
pub const KNOWN: [&str; 0] = [];

/// What is refuted, but for what is known.
#[allow(dead_code)]
pub fn refuted(report: &Report) -> Vec<&'static str> {
    let refuted = report
        .rows
        .iter()
        .filter(|row| row.verdict == Verdict::Refuted);
    refuted
        .map(|row| row.check)
        .filter(|check| !KNOWN.contains(check))
        .collect()
}

/// A built-in model.
#[allow(dead_code)]
pub fn built_in(name: &str) -> Loaded {
    inspect(name, &[]).unwrap()
}

/// A built-in model with a piece of its text exchanged.
#[allow(dead_code)]
pub fn edited(name: &str, from: &str, to: &str) -> Loaded {
    let text = built_in(name).sources[0].text.clone();
    assert!(text.contains(from), "{name} has no `{from}`");
    inspect_text(name, &text.replacen(from, to, 1), &[]).unwrap()
}

/// A built-in model with lines added.
#[allow(dead_code)]
pub fn with_lines(name: &str, lines: &str) -> Loaded {
    let text = built_in(name).sources[0].text.clone() + lines;
    inspect_text(name, &text, &[]).unwrap()
}

/// The row of a check.
#[allow(dead_code)]
pub fn row<'a>(report: &'a Report, check: &str) -> &'a Row {
    let found = report.rows.iter().find(|row| row.check == check);
    found.unwrap_or_else(|| panic!("no check is called `{check}`"))
}

/// What a check says of a model.
#[allow(dead_code)]
pub fn verdict(loaded: &Loaded, check: &str) -> Verdict {
    assert!(loaded.model.is_some(), "{:#?}", loaded.diagnostics);
    row(&verify::run(loaded, &QUICK), check).verdict
}
