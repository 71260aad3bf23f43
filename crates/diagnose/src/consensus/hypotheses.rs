//! Search for hypotheses on which the flights agree.
//!
//! Real flights differ from one another by more than the measurement noise: values stated for a flight have errors,
//! and the air moves. A hypothesis is accepted here if the effects have the same sign in the flights and, once they
//! are included in the model, no further candidate has; the remaining lack of fit then follows no law that is common
//! to all flights.

use identify::Iterate;
use model_spec::sort_by_number;

use super::sign_flip_test::SignFlipTest;
use crate::context::{CandidateId, ColumnId, ScoreTestModel, TermId};
use crate::error::{DiagnosisError, if_possible};
use crate::selection::{Hypothesis, Search};

/// Familywise significance level of the sign-flip test: the flights agree on a candidate effect if its p-value is below
/// this level.
const ALPHA_AGREE: f64 = 0.01;

/// Familywise significance level of the sign-flip test by which a hypothesis is rejected: the flights still agree on a
/// further candidate effect or library term once the effect of the hypothesis is included.
const ALPHA_REJECT: f64 = 0.002;

/// Minimum number of flights for a test of whether they agree on an effect; with fewer flights the sign-flip test
/// cannot be significant.
const MIN_FLIGHTS: usize = 20;

/// Minimum fraction of the excess χ² that a hypothesis must explain to be accepted. The excess χ² is the weighted sum
/// of squares minus its expectation for pure noise, over all flights or over the concordant flights.
const MIN_EXPLAINED: f64 = 0.5;

/// Minimum fraction of concordant flights, which agree on the effect, for the diagnosis to be repeated without the
/// discordant flights, which contradict it.
const MIN_CONCORDANT: f64 = 0.5;

/// Result of the search for effects that the model may lack and on which the flights agree.
pub(crate) struct Consensus {
    /// Hypotheses of one missing effect that explain at least half of the excess χ² of all flights, best fit first.
    /// Empty if there are none, but a hypothesis explains at least half of the excess χ² of the concordant flights,
    /// which are those not in `discordant`.
    pub hypotheses: Vec<Hypothesis>,
    /// Fraction, 0 … 1, of the excess χ² that the best hypothesis explains, over all flights, or over the concordant
    /// flights if `hypotheses` is empty. The excess χ² is the weighted sum of squares minus its expectation for pure
    /// noise.
    pub explained_fraction: f64,
    /// Familywise p-value of the sign-flip test of the effect of the best hypothesis: probability that the flights
    /// agree as much under the null hypothesis.
    pub p_value: f64,
    /// Indices of the discordant flights, which contradict the effect on which the other flights agree. The search is
    /// to be repeated without them.
    pub discordant: Vec<usize>,
}

/// Searches for hypotheses of one missing effect on which the flights agree. `None` if there are fewer than
/// [`MIN_FLIGHTS`] flights. Also `None` if no such hypothesis explains the fraction [`MIN_EXPLAINED`] of the misfit
/// beyond noise, of all flights or of the concordant flights.
///
/// # Errors
/// [`DiagnosisError::Fit`] if a trajectory cannot be integrated, or the caller cancelled.
pub(crate) fn consensus(
    model: &ScoreTestModel<'_>,
    search: &Search,
    base: &Iterate,
) -> Result<Option<Consensus>, DiagnosisError> {
    let flights = model.flights.len();
    if flights < MIN_FLIGHTS {
        return Ok(None);
    }
    let Some(null) = model.fit_hypothesis(&[], base, &search.noise) else {
        return Ok(None);
    };
    let Some(test) = if_possible(sign_flip_test(model, &null, search))? else {
        return Ok(None);
    };
    let mut agreed = agreed_hypotheses(model, search, (&null, &test))?;
    let of_most = explained_without_discordant(model, &test, &agreed);
    let excess = test.excess_chi2(0..flights);
    let explained = |hypothesis: &Hypothesis| (null.squares - hypothesis.squares) / excess;
    agreed.retain(|agreed| explained(&agreed.hypothesis) >= MIN_EXPLAINED);
    let Some(best) = agreed.first() else {
        return Ok(of_most);
    };
    Ok(Some(Consensus {
        explained_fraction: explained(&best.hypothesis),
        p_value: best.p_value,
        hypotheses: agreed.into_iter().map(|agreed| agreed.hypothesis).collect(),
        discordant: of_most.map(|most| most.discordant).unwrap_or_default(),
    }))
}

/// A hypothesis of one missing effect, and the familywise p-value of the agreement of the flights on this effect.
struct Agreed {
    hypothesis: Hypothesis,
    p_value: f64,
}

/// Fits each single candidate effect on which the flights agree, and returns the hypotheses, best fit first. A
/// hypothesis is omitted if, once its effect is included, the flights still agree on a further candidate or library
/// term.
fn agreed_hypotheses(
    model: &ScoreTestModel<'_>,
    search: &Search,
    (null, test): (&Hypothesis, &SignFlipTest),
) -> Result<Vec<Agreed>, DiagnosisError> {
    let p_values = test.p_values(&groups(model, &[]));
    let mut agreed: Vec<Agreed> = Vec::new();
    for ((id, candidate), &p_value) in model.candidates().zip(&p_values) {
        let is_common = !candidate.is_per_flight() && !model.columns_of(id).is_empty();
        if !is_common || p_value >= ALPHA_AGREE {
            continue;
        }
        model.context.check_cancelled()?;
        if model.context.is_out_of_time() {
            break;
        }
        let from = &null.iterate;
        let Some(hypothesis) = model.fit_hypothesis(&[id], from, &search.noise) else {
            continue;
        };
        let Some(given) = if_possible(sign_flip_test(model, &hypothesis, search))? else {
            continue;
        };
        let remaining = given.p_values(&groups(model, &[id]));
        if remaining.iter().all(|p_value| *p_value >= ALPHA_REJECT) {
            agreed.push(Agreed {
                hypothesis,
                p_value,
            });
        }
    }
    sort_by_number(&mut agreed, |agreed| agreed.hypothesis.squares);
    Ok(agreed)
}

/// Finds the hypothesis in `agreed` that best explains the concordant flights, those that do not contradict it. The
/// best hypothesis explains the largest fraction of the excess χ² of its concordant flights. Considers only hypotheses
/// whose effect has one coefficient. The list of hypotheses in the result is empty. `None` if no fraction reaches
/// [`MIN_EXPLAINED`], or too few flights are concordant.
fn explained_without_discordant(
    model: &ScoreTestModel<'_>,
    test: &SignFlipTest,
    agreed: &[Agreed],
) -> Option<Consensus> {
    let flights = test.flights();
    let mut best: Option<Consensus> = None;
    for Agreed {
        hypothesis,
        p_value,
    } in agreed
    {
        let [column] = model.columns_of(hypothesis.effects[0])[..] else {
            continue;
        };
        let found = test.concordance(column);
        let discordant = found.discordant;
        let concordant = (0..flights).filter(|flight| !discordant.contains(flight));
        let explained = found.chi2_decrease / test.excess_chi2(concordant);
        let count = flights - discordant.len();
        let are_enough = count >= MIN_FLIGHTS && count as f64 >= MIN_CONCORDANT * flights as f64;
        let is_best = best
            .as_ref()
            .is_none_or(|best| explained > best.explained_fraction);
        if are_enough && explained >= MIN_EXPLAINED && is_best {
            best = Some(Consensus {
                hypotheses: Vec::new(),
                explained_fraction: explained,
                p_value: *p_value,
                discordant,
            });
        }
    }
    best
}

/// Sign-flip test of the flights' scores at the fit of the hypothesis `given`. The effects of this hypothesis are
/// nuisance parameters.
fn sign_flip_test(
    model: &ScoreTestModel<'_>,
    given: &Hypothesis,
    search: &Search,
) -> Result<SignFlipTest, DiagnosisError> {
    let at = given.linearization_point();
    let blocks = model.normal_equations_with_terms(at, &search.noise)?;
    SignFlipTest::new(model, &blocks, &given.effects)
}

/// Groups of columns of the normal equations, to be tested by [`SignFlipTest::p_values`]: first the columns of each
/// candidate effect's coefficients (an empty group for the candidates in `conditioned_on`), then the column of each
/// library term.
fn groups(model: &ScoreTestModel<'_>, conditioned_on: &[CandidateId]) -> Vec<Vec<ColumnId>> {
    let of_candidates = model
        .candidates()
        .map(|(id, _)| match conditioned_on.contains(&id) {
            true => Vec::new(),
            false => model.columns_of(id).to_vec(),
        });
    let terms = model.terms.as_ref().map_or(0, |terms| terms.terms.len());
    let of_terms = (0..terms).map(|term| vec![model.term_column(TermId::new(term))]);
    of_candidates.chain(of_terms).collect()
}
