//! Figure of the correlations between the effective scores of candidate effects, as a triangular matrix.

use diagnose::Report;
use model_spec::sort_by_number;

use crate::figure::Figure;
use crate::figures::Layout;
use crate::figures::triangle::Triangle;

/// Maximum number of coefficients in the drawn matrix of score correlations.
const MAX_COEFFICIENTS: usize = 25;

/// Draws the correlations between the effective scores of the coefficients of the most significant candidate effects;
/// `None` for fewer than two coefficients.
pub(super) fn score_correlations(report: &Report) -> Option<Figure> {
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

/// Indices, in the score correlation matrix of the report, of the coefficients of the most significant effects, in
/// descending order of significance; at most [`MAX_COEFFICIENTS`].
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
