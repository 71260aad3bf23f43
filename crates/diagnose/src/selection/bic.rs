//! Selection among adequate hypotheses by the Bayesian information criterion (BIC).

use super::hypothesis::Hypothesis;
use super::stepwise_terms::StepwiseModel;
use crate::context::ScoreTestModel;

/// Maximum difference from the smallest BIC of a hypothesis that is retained.
const MAX_BIC_DIFFERENCE: f64 = 12.0;

/// Amount by which the BIC of library terms must be smaller to replace the hypotheses.
const TERM_BIC_MARGIN: f64 = 1.0;

/// Hypotheses near the smallest BIC, and those with at most `free` unknowns. If adequate library terms are better than
/// all by [`TERM_BIC_MARGIN`], none. Unknowns are penalized, as several effects, or one with a value for each flight,
/// can fit almost any data.
pub(crate) fn select_by_bic(
    model: &ScoreTestModel<'_>,
    hypotheses: Vec<Hypothesis>,
    terms: Option<&StepwiseModel>,
    free: usize,
) -> Vec<Hypothesis> {
    let each = hypotheses.iter();
    let scored: Vec<(f64, usize)> = each
        .map(|h| (bic_of_hypothesis(model, h), model.unknowns_of(&h.effects)))
        .collect();
    let terms = terms.filter(|terms| terms.is_adequate);
    let of_terms = terms.map_or(f64::INFINITY, |terms| bic_of_terms(model, terms));
    let keep = near_least(&scored, of_terms, free);
    let each = hypotheses.into_iter().zip(keep);
    each.filter(|(_, keep)| *keep).map(|(h, _)| h).collect()
}

/// Whether `terms` are an alternative: every hypothesis combines several effects, the terms are adequate, and their BIC
/// is near the smallest.
pub(crate) fn are_alternative(
    model: &ScoreTestModel<'_>,
    hypotheses: &[Hypothesis],
    terms: &StepwiseModel,
) -> bool {
    let each = hypotheses.iter();
    let bics = each.map(|hypothesis| bic_of_hypothesis(model, hypothesis));
    let least = bics.fold(f64::INFINITY, f64::min);
    let is_combined = |hypothesis: &Hypothesis| hypothesis.effects.len() > 1;
    terms.is_adequate
        && hypotheses.iter().all(is_combined)
        && bic_of_terms(model, terms) < least + MAX_BIC_DIFFERENCE
}

fn bic(model: &ScoreTestModel<'_>, squares: f64, unknowns: usize) -> f64 {
    squares + (model.coordinates() as f64).ln() * unknowns as f64
}

pub(super) fn bic_of_hypothesis(model: &ScoreTestModel<'_>, hypothesis: &Hypothesis) -> f64 {
    let unknowns = model.unknowns_of(&hypothesis.effects);
    bic(model, hypothesis.squares, unknowns)
}

pub(super) fn bic_of_terms(model: &ScoreTestModel<'_>, terms: &StepwiseModel) -> f64 {
    bic(model, terms.squares, terms.unknowns())
}

/// Whether each hypothesis (BIC, number of unknowns) is retained, given the BIC of library terms.
fn near_least(scored: &[(f64, usize)], of_terms: f64, free: usize) -> Vec<bool> {
    let least = scored.iter().map(|s| s.0).fold(f64::INFINITY, f64::min);
    if of_terms < least - TERM_BIC_MARGIN {
        return vec![false; scored.len()];
    }
    let limit = least.min(of_terms) + MAX_BIC_DIFFERENCE;
    let keeps = |&(bic, unknowns): &(f64, usize)| unknowns <= free || bic < limit;
    scored.iter().map(keeps).collect()
}

#[cfg(test)]
mod tests {
    use super::near_least;

    #[test]
    fn models_far_above_the_least_bic_are_dropped() {
        let scored = [(100.0, 1), (111.0, 2), (113.0, 3), (500.0, 1)];
        let none = f64::INFINITY;
        assert_eq!(near_least(&scored, none, 0), [true, true, false, false]);
        // Hypotheses with few unknowns are exempt.
        assert_eq!(near_least(&scored, none, 1), [true, true, false, true]);
        // Terms replace the hypotheses only if they are better by the margin.
        assert_eq!(near_least(&scored, 99.5, 0), [true, true, false, false]);
        assert_eq!(near_least(&scored, 98.0, 6), [false; 4]);
        assert!(near_least(&[], 1.0, 0).is_empty());
    }
}
