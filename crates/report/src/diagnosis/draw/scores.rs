//! Figures of the score tests of all candidate effects, and of the correlations between their effective scores.

use diagnose::{CandidateTest, Report};
use identify::numbers::{equivalent_z, percent};
use model_spec::sort_by_number;

use crate::figure::Figure;
use crate::figures::Layout;
use crate::figures::chart::{Axis, Chart, Row, Shape};
use crate::figures::triangle::Triangle;
use crate::fit::draw::not_drawn;
use crate::thin::MAX_ROWS;

/// Score test of each candidate effect, as z, the most significant first.
pub(in super::super) fn score_tests(report: &Report) -> Option<Figure> {
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
            let entry = (Shape::Bar(0.0, class), words.to_owned());
            chart.legend.push(entry);
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

/// Chart of the most significant score tests, with the threshold; `None` without candidates.
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

const MAX_COEFFICIENTS: usize = 25;

/// Correlations between the effective scores of the most significant coefficients; `None` for fewer than two.
pub(in super::super) fn score_correlations(report: &Report) -> Option<Figure> {
    let all = &report.score_correlations.names;
    let order = strongest(report);
    if order.len() < 2 {
        return None;
    }
    let drawn = if order.len() == all.len() {
        "The most significant are first.".to_owned()
    } else {
        let (drawn, all) = (order.len(), all.len());
        format!("The {drawn} most significant are drawn, of {all}.")
    };
    let caption = format!(
        "Each square: the absolute correlation of the signatures of two coefficients of effects in these flights, \
         adjusted for initial states and the model’s own coefficients. The row of an effect is left of its name and its \
         column below it; these flights hardly distinguish pairs of strong colour. {drawn}"
    );
    let effects = report.explanations.iter().flat_map(|found| &found.effects);
    let named: Vec<&String> = effects.flat_map(|effect| effect.estimates.keys()).collect();
    let value = |i: usize, j: usize| {
        let row = report.score_correlations.matrix.get(order[i]);
        let value = row.and_then(|row| row.get(order[j]));
        value.map_or(f64::NAN, |value| value.abs())
    };
    let triangle = Triangle {
        title: "Correlations of effect signatures",
        names: order.iter().map(|i| all[*i].as_str()).collect(),
        is_strong: &|name| named.iter().any(|named| *named == name),
        value: &value,
        is_signed: false,
        ends: ["0: distinct", "1: identical"],
    };
    let wide = Layout::COLUMN;
    Some(Figure::of_triangle("alike", &triangle, &caption, wide))
}

/// Indices of the coefficients of the most significant effects, in this order; at most [`MAX_COEFFICIENTS`].
fn strongest(report: &Report) -> Vec<usize> {
    let names = &report.score_correlations.names;
    let equivalent_z = |name: &String| {
        let mut tests = report.tests.iter();
        let owner = tests.find(|c| c.one_step_estimates.contains_key(name));
        let z = owner.map(|c| c.z).filter(|z| !z.is_nan());
        z.unwrap_or(f64::NEG_INFINITY)
    };
    let mut order: Vec<usize> = (0..names.len()).collect();
    sort_by_number(&mut order, |i| -equivalent_z(&names[*i]));
    order.truncate(MAX_COEFFICIENTS);
    order
}
