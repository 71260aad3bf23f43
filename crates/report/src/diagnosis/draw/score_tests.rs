//! Figure of the score tests of all candidate effects, as equivalent z.

use diagnose::{CandidateTest, Report};
use identify::numbers::{equivalent_z, percent};
use model_spec::sort_by_number;

use crate::figure::Figure;
use crate::figures::Layout;
use crate::figures::chart::{Axis, Chart, Row, Shape};
use crate::fit::draw::not_drawn;
use crate::thin::MAX_ROWS;

/// Draws the score test of each candidate effect as a bar of the equivalent standard normal quantile z, the most
/// significant first; `None` if there are no candidates.
pub(super) fn score_tests(report: &Report) -> Option<Figure> {
    let mut chart = chart(report, "Score tests of the effects", MAX_ROWS)?;
    let has_explanation = !report.explanations.is_empty();
    let significant = if has_explanation {
        "significant alone, explained by the selected effects"
    } else {
        "significant"
    };
    let kinds = [
        ("bar explanation", "part of an explanation"),
        ("bar alarm", significant),
        ("bar calm", "not significant"),
    ];
    for (class, words) in kinds {
        let has = |row: &Row| matches!(row.shapes[0], Shape::Bar(_, own) if own == class);
        if chart.rows.iter().any(has) {
            chart
                .legend
                .push((Shape::Bar(0.0, class), words.to_owned()));
        }
    }
    let left_out = report.tests.len() - chart.rows.len();
    let more = not_drawn(left_out, "more with smaller z");
    let along = if has_explanation {
        " Effects with a signature like that of an explanation are significant with it."
    } else {
        ""
    };
    let caption = format!(
        "Score test of each effect alone, as the standard normal quantile z of equal p-value. The familywise error rate \
         of all tests is {}.{along}{more}",
        percent(report.threshold.alpha)
    );
    let wide = Layout::COLUMN;
    Some(Figure::of_chart("candidates", &chart, &caption, wide))
}

/// Chart of the `most` most significant score tests, with the threshold; `None` if there are no candidates.
pub(in super::super) fn chart(report: &Report, title: &str, most: usize) -> Option<Chart> {
    let mut all: Vec<&CandidateTest> = report.tests.iter().collect();
    // Candidates without a finite z-equivalent come last.
    let size = |c: &CandidateTest| if c.z.is_nan() { f64::NEG_INFINITY } else { c.z };
    sort_by_number(&mut all, |test| -size(test));
    all.truncate(most);
    let effects = report.explanations.iter().flat_map(|found| &found.effects);
    let is_named = |c: &CandidateTest| effects.clone().any(|effect| effect.name == c.name);
    let row = |c: &&CandidateTest| {
        let (class, bar) = match (is_named(c), c.significant) {
            (true, _) => ("strong", "bar explanation"),
            (false, true) => ("tick", "bar alarm"),
            (false, false) => ("weak", "bar calm"),
        };
        let shapes = vec![Shape::Bar(c.z.max(0.0), bar)];
        Row::new(&c.name, class, shapes).words(equivalent_z(c.z))
    };
    let rows: Vec<Row> = all.iter().map(row).collect();
    let z = report.threshold.z;
    (!rows.is_empty()).then(|| Chart {
        level: Some((z, format!("significant from {}", equivalent_z(z)))),
        ..Chart::new(title, rows, Axis::Sizes, "equivalent z")
    })
}
