//! Figure of the score tests of all candidate effects, as equivalent z.

use diagnose::{CandidateTest, Report};
use identify::numbers::equivalent_z;
use model_spec::sort_by_number;

use crate::figure::Figure;
use crate::figures::Layout;
use crate::figures::chart::{Axis, Chart, Row, Shape};
use crate::fit::draw::not_drawn;

/// Maximum number of candidate effects whose score tests are drawn.
const MAX_CANDIDATES: usize = 60;

/// Draws the score test of each candidate effect as a bar of the equivalent standard normal quantile z, the most
/// significant first; `None` if there are no candidates.
pub(super) fn score_tests(report: &Report) -> Option<Figure> {
    let mut all: Vec<&CandidateTest> = report.tests.iter().collect();
    // Candidates without a finite z-equivalent come last.
    let size = |c: &CandidateTest| {
        if c.z.is_nan() { f64::NEG_INFINITY } else { c.z }
    };
    sort_by_number(&mut all, |test| -size(test));
    let left_out = all.len().saturating_sub(MAX_CANDIDATES);
    all.truncate(MAX_CANDIDATES);
    if all.is_empty() {
        return None;
    }
    let named = |c: &CandidateTest| {
        let effects = report
            .explanations
            .iter()
            .flat_map(|explanation| &explanation.effects);
        effects.into_iter().any(|e| e.name == c.name)
    };
    let row = |c: &&CandidateTest| {
        let (class, bar) = match (named(c), c.significant) {
            (true, _) => ("strong", "bar explanation"),
            (false, true) => ("tick", "bar alarm"),
            (false, false) => ("weak", "bar calm"),
        };
        Row {
            name: c.name.clone(),
            class,
            shapes: vec![Shape::Bar(c.z.max(0.0), bar)],
            words: equivalent_z(c.z),
        }
    };
    let rows: Vec<Row> = all.iter().map(row).collect();
    let kinds = [
        ("bar explanation", "part of an explanation"),
        (
            "bar alarm",
            "significant alone, explained by the selected effects",
        ),
        ("bar calm", "not significant"),
    ];
    let drawn_kinds = kinds.into_iter().filter(|(class, _)| {
        let has = |row: &Row| matches!(row.shapes[0], Shape::Bar(_, c) if c == *class);
        rows.iter().any(has)
    });
    let legend = drawn_kinds.map(|(class, words)| {
        let words = if report.explanations.is_empty() && class == "bar alarm" {
            "significant"
        } else {
            words
        };
        (Shape::Bar(0.0, class), words.to_owned())
    });
    let threshold = report.threshold.z;
    let chart = Chart {
        title: "Score tests of the effects".into(),
        legend: legend.collect(),
        rows,
        axis: Axis::Sizes,
        across: "equivalent z".into(),
        level: Some((
            threshold,
            format!("significant from {}", equivalent_z(threshold)),
        )),
    };
    let more = not_drawn(left_out, "more with smaller z");
    let along = if report.explanations.is_empty() {
        ""
    } else {
        " Effects with a signature like that of a explanation are significant with it."
    };
    let caption = format!(
        "Score test of each effect alone, as the standard normal quantile z of equal p-value. The familywise error rate \
         of all tests is {}.{along}{more}",
        identify::numbers::percent(report.threshold.alpha)
    );
    Some(Figure::of_chart(
        "candidates",
        &chart,
        &caption,
        Layout::COLUMN,
    ))
}
