//! Search for hypotheses on which the flights agree. Real flights differ by more than the noise: stated values have
//! errors, and the air moves. A hypothesis is accepted here if its effects have the same sign in the flights and no
//! further candidate has; the rest then follows no common law.

use identify::Iterate;
use model_spec::sort_by_number;

use super::sign_flip_test::SignFlipTest;
use crate::context::{CandidateId, ColumnId, ScoreTestModel, TermId};
use crate::error::DiagnosisError;
use crate::selection::{Hypothesis, Search};

/// Familywise level of the sign-flip test at which the flights agree on a candidate.
const ALPHA_AGREE: f64 = 0.01;

/// Familywise level of the sign-flip test of further candidates and terms, by which a hypothesis is rejected.
const ALPHA_REJECT: f64 = 0.002;

/// Minimum number of flights; with fewer, the sign-flip test cannot be significant.
const MIN_FLIGHTS: usize = 20;

/// Minimum fraction of the excess χ² that an accepted hypothesis explains, and of concordant flights for a diagnosis
/// without the discordant ones.
const LEAST: (f64, f64) = (0.5, 0.5);

/// Result of the search for effects that the model may lack and on which the flights agree.
pub(crate) struct Consensus {
    /// Hypotheses of one effect that explain enough of the excess χ² of all flights, best fit first. Empty if one
    /// explains enough of that of the concordant flights only.
    pub hypotheses: Vec<Hypothesis>,
    /// Fraction of the excess χ², 0 … 1, that the best hypothesis explains.
    pub explained_fraction: f64,
    /// Familywise p-value of the sign-flip test of the best hypothesis.
    pub p_value: f64,
    /// Indices of the flights that contradict it, without which the search is repeated.
    pub discordant: Vec<usize>,
}

/// Hypotheses of one effect on which the flights agree; `None` for fewer than [`MIN_FLIGHTS`], or if none explains
/// [`LEAST`] of the misfit beyond noise of all or of the concordant flights.
pub(crate) fn consensus(
    model: &ScoreTestModel<'_>,
    search: &Search,
    base: &Iterate,
) -> Option<Consensus> {
    let flights = model.flights.len();
    if flights < MIN_FLIGHTS {
        return None;
    }
    let null = model.fit_hypothesis(&[], base, &search.noise)?;
    let test = sign_flip_test(model, &null, search).ok()?;
    let mut agreed = agreed_hypotheses(model, search, (&null, &test));
    let of_most = explained_without_discordant(model, &test, &agreed);
    let excess = test.excess_chi2(0..flights);
    let explained = |hypothesis: &Hypothesis| (null.squares - hypothesis.squares) / excess;
    agreed.retain(|agreed| explained(&agreed.hypothesis) >= LEAST.0);
    let Some(best) = agreed.first() else {
        return of_most;
    };
    Some(Consensus {
        explained_fraction: explained(&best.hypothesis),
        p_value: best.p_value,
        hypotheses: agreed.into_iter().map(|agreed| agreed.hypothesis).collect(),
        discordant: of_most.map(|most| most.discordant).unwrap_or_default(),
    })
}

/// A hypothesis of one missing effect, and the familywise p-value of the agreement of the flights on this effect.
struct Agreed {
    hypothesis: Hypothesis,
    p_value: f64,
}

/// Fits each single candidate on which the flights agree, best fit first, unless they still agree on a further one.
fn agreed_hypotheses(
    model: &ScoreTestModel<'_>,
    search: &Search,
    (null, test): (&Hypothesis, &SignFlipTest),
) -> Vec<Agreed> {
    let p_values = test.p_values(&groups(model, &[]));
    let mut agreed: Vec<Agreed> = Vec::new();
    for ((id, candidate), &p_value) in model.candidates().zip(&p_values) {
        let is_common = !candidate.is_per_flight() && !model.columns_of(id).is_empty();
        if !is_common || p_value >= ALPHA_AGREE {
            continue;
        }
        if model.context.is_out_of_time() {
            break;
        }
        let from = &null.iterate;
        let Some(hypothesis) = model.fit_hypothesis(&[id], from, &search.noise) else {
            continue;
        };
        let Ok(given) = sign_flip_test(model, &hypothesis, search) else {
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
    agreed
}

/// The hypothesis in `agreed` of one coefficient that best explains its concordant flights; the list of hypotheses in
/// the result is empty. `None` if it explains too little, or too few flights are concordant.
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
        let are_enough = count >= MIN_FLIGHTS && count as f64 >= LEAST.1 * flights as f64;
        let is_best = best
            .as_ref()
            .is_none_or(|best| explained > best.explained_fraction);
        if are_enough && explained >= LEAST.0 && is_best {
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

/// Sign-flip test at the fit of `given`, whose effects are nuisance parameters.
fn sign_flip_test(
    model: &ScoreTestModel<'_>,
    given: &Hypothesis,
    search: &Search,
) -> Result<SignFlipTest, DiagnosisError> {
    let at = given.linearization_point();
    let blocks = model.normal_equations_with_terms(at, &search.noise)?;
    SignFlipTest::new(model, &blocks, &given.effects)
}

/// Columns of each candidate (none if it is in `conditioned_on`), then the column of each library term.
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
