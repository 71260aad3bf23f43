//! Selection among adequate hypotheses by the Bayesian information criterion (BIC).

use super::hypothesis::Hypothesis;
use super::stepwise_terms::StepwiseModel;
use crate::context::ScoreTestModel;

/// Maximum amount by which the BIC of a hypothesis may exceed the smallest BIC for the hypothesis to be retained: the
/// smallest of all hypotheses and of the model with library terms.
const MAX_BIC_DIFFERENCE: f64 = 12.0;

/// Maximum amount by which the BIC of the model with library terms may be below the smallest BIC of the hypotheses
/// while the hypotheses are still preferred.
const TERM_BIC_MARGIN: f64 = 1.0;

/// Returns the hypotheses whose BIC exceeds the smallest by less than [`MAX_BIC_DIFFERENCE`], and all hypotheses with
/// at most `free` unknowns, without changing their order. The library terms in `terms` take part in the comparison if
/// they are adequate (no other term or candidate effect remains significant). If their BIC is smaller than that of
/// every hypothesis by more than [`TERM_BIC_MARGIN`], the result is empty. Unknowns are penalized because several
/// effects together, or an effect with a separate value for each flight, can fit almost any data.
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

/// Whether the library terms `terms` are an alternative to `hypotheses`. They are if every hypothesis combines several
/// effects, no other term or candidate effect remains significant with the terms, and their BIC exceeds the smallest of
/// the hypotheses by less than [`MAX_BIC_DIFFERENCE`].
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

fn bic_of_hypothesis(model: &ScoreTestModel<'_>, hypothesis: &Hypothesis) -> f64 {
    let unknowns = model.unknowns_of(&hypothesis.effects);
    bic(model, hypothesis.squares, unknowns)
}

fn bic_of_terms(model: &ScoreTestModel<'_>, terms: &StepwiseModel) -> f64 {
    bic(model, terms.squares, terms.unknowns())
}

/// Returns for each hypothesis, given by (BIC, number of unknowns), whether it is retained. No hypothesis is retained
/// if the BIC of the library terms, `of_terms`, is smaller than the BIC of every hypothesis by more than
/// [`TERM_BIC_MARGIN`]. Otherwise a hypothesis is retained if it has at most `free` unknowns, or its BIC exceeds the
/// smallest of the hypotheses and the library terms by less than [`MAX_BIC_DIFFERENCE`].
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
