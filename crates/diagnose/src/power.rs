//! Power of the score tests: effects that these flights cannot identify, and minimum detectable effects of the others.

use model_spec::sort_by_number;
use serde::{Deserialize, Serialize};

use crate::context::{CandidateId, CandidateParameter, ColumnId, ScoreTestModel};
use crate::score_test::{ScoreTests, ln_p_to_z};

/// Fraction of a column's squared norm beyond the initial states, at which it is confounded with them.
const MAX_LOCAL_TOLERANCE: f64 = 1e-9;

/// Standard normal quantile of the probability 0.9, the power of the test at which an effect counts as detectable.
const Z_OF_POWER: f64 = 1.281_551_565_544_6;

/// Minimum projection on a nuisance column relative to the longest, for its parameter to be named, and maximum number of
/// parameters named as confounded with one effect.
const NAMED: (f64, usize) = (0.25, 8);

/// Maximum ratio of a minimum detectable size to the width of the bounds.
const MAX_FRACTION_OF_BOUNDS: f64 = 0.5;

/// An effect that the flights cannot distinguish from the parameters of the model under test.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NotIdentifiable {
    /// Display name of the effect: its identifier in the model language, with hyphens instead of underscores.
    pub name: String,
    /// Coefficients of the model with which it is confounded, or `initial states`; empty without influence.
    pub confounded_with: Vec<String>,
}

/// Minimum detectable effect: the smallest size of a coefficient that is detected with probability 0.9.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MinDetectableEffect {
    /// Display name of the effect: its identifier in the model language, with hyphens instead of underscores.
    pub name: String,
    /// Name of the effect's coefficient.
    pub coefficient: String,
    /// Smallest detectable difference of the coefficient from its null value, SI.
    pub value: f64,
    /// Unit of the coefficient, as text.
    pub unit: String,
}

/// Candidates that are not identifiable, and minimum detectable sizes of the others; `detect` is the log p-value of
/// detection.
pub(crate) fn detectable(
    model: &ScoreTestModel<'_>,
    tests: &ScoreTests,
    detect: f64,
) -> (Vec<NotIdentifiable>, Vec<MinDetectableEffect>) {
    let noncentrality = ln_p_to_z(detect) + Z_OF_POWER;
    let (mut hidden, mut detectable) = (Vec::new(), Vec::new());
    for (id, candidate) in model.candidates() {
        let Some(test) = &tests.candidates[id] else {
            continue;
        };
        let parameters = candidate.coefficients.iter().zip(model.columns_of(id));
        let sizes: Vec<MinDetectableEffect> = parameters
            .filter_map(|(parameter, &column)| {
                let value = detectable_size(tests, parameter, column, noncentrality)?;
                Some(MinDetectableEffect {
                    name: candidate.name.clone(),
                    coefficient: parameter.name.clone(),
                    value,
                    unit: parameter.unit.clone(),
                })
            })
            .collect();
        let has_size = candidate.is_per_flight() || !sizes.is_empty();
        if test.degrees_of_freedom > 0 && has_size {
            detectable.extend(sizes);
        } else {
            hidden.push(NotIdentifiable {
                name: candidate.name.clone(),
                confounded_with: confounded_with(model, tests, id),
            });
        }
    }
    (hidden, detectable)
}

/// Minimum detectable size of a coefficient, SI; `None` if too large for its bounds.
fn detectable_size<Id>(
    tests: &ScoreTests,
    parameter: &CandidateParameter<Id>,
    column: ColumnId,
    noncentrality: f64,
) -> Option<f64> {
    let column = tests.partition.tested.iter().position(|&c| c == column)?;
    let information = tests.information[(column, column)].max(0.0);
    let size = noncentrality / (information * tests.norms[column].locals_eliminated).sqrt();
    let bounds = parameter.bounds;
    let width = bounds.map_or(f64::INFINITY, |(low, high)| high - low);
    (size.is_finite() && size < MAX_FRACTION_OF_BOUNDS * width).then_some(size)
}

/// Parameters most confounded with a candidate, by projections of its columns; only `initial states` if these reproduce
/// one.
fn confounded_with(model: &ScoreTestModel<'_>, tests: &ScoreTests, id: CandidateId) -> Vec<String> {
    let own = model.columns_of(id);
    let mut shares: Vec<(&str, f64)> = Vec::new();
    for (column, tested) in tests.partition.tested.iter().enumerate() {
        let norms = tests.norms[column];
        if !own.contains(tested) || norms.total <= 0.0 {
            continue;
        }
        if norms.locals_eliminated <= MAX_LOCAL_TOLERANCE * norms.total {
            return vec!["initial states".to_owned()];
        }
        for (row, &nuisance) in tests.partition.nuisance.iter().enumerate() {
            let norm = tests.nuisance_information[(row, row)].sqrt();
            let share = tests.nuisance_projection[(row, column)].abs() * norm;
            let name = model.column_name(nuisance).unwrap_or_default();
            match shares.iter_mut().find(|(same, _)| *same == name) {
                Some((_, greatest)) => *greatest = greatest.max(share),
                None => shares.push((name, share)),
            }
        }
    }
    greatest_shares(shares)
}

fn greatest_shares(mut shares: Vec<(&str, f64)>) -> Vec<String> {
    sort_by_number(&mut shares, |share| -share.1);
    let greatest = shares.first().map_or(0.0, |first| first.1);
    shares
        .into_iter()
        .filter(|(_, share)| *share >= NAMED.0 * greatest && *share > 0.0)
        .take(NAMED.1)
        .map(|(name, _)| name.to_owned())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_support::fixture;

    #[test]
    fn only_great_shares_are_named() {
        let shares = vec![("C_a", 0.2), ("C_b", 1.0), ("C_c", 0.3), ("C_d", 0.0)];
        assert_eq!(greatest_shares(shares), ["C_b", "C_c"]);
        assert!(greatest_shares(vec![("C_a", 0.0)]).is_empty());
    }

    #[test]
    fn the_minimum_detectable_size_is_significant_with_a_power_of_nine_in_ten() {
        let fixture = fixture();
        let model = &fixture.model;
        let noise = fixture.fit.noise();
        let blocks = model.normal_equations(&model.problem, &fixture.iterate, noise);
        let tests = ScoreTests::new(model, &blocks.unwrap(), &[], &fixture.iterate.global).unwrap();
        let detect = -9.0;
        let (hidden, sizes) = detectable(model, &tests, detect);
        // A higher air density has the same effect as larger coefficients.
        let density = hidden.iter().find(|h| h.name == "air-density").unwrap();
        assert!(
            density
                .confounded_with
                .iter()
                .any(|name| name.starts_with("C_"))
        );
        let stall = sizes.iter().find(|size| size.name == "stall").unwrap();
        let test = tests.candidates[fixture.candidate("stall")]
            .as_ref()
            .unwrap();
        // An estimate of this size is 1.28 standard errors above the threshold.
        let z = stall.value / test.one_step_estimates[0].std_error;
        assert!((z - ln_p_to_z(detect) - Z_OF_POWER).abs() < 1e-6, "{z}");
    }
}
