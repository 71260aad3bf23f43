//! The nearest of the rejected hypotheses, which is the best answer where none is adequate.

use super::bic::{bic_of_hypothesis, bic_of_terms};
use super::hypothesis::Hypothesis;
use super::search::{MAX_EFFECTS, Nearest, Search};
use super::stepwise_terms::StepwiseModel;
use crate::context::ScoreTestModel;

impl Search {
    pub(super) fn note_nearest(&mut self, model: &ScoreTestModel<'_>, hypothesis: &Hypothesis) {
        let bic = bic_of_hypothesis(model, hypothesis);
        let is_nearer = self.nearest.as_ref().is_none_or(|known| bic < known.bic);
        if hypothesis.effects.len() <= MAX_EFFECTS && is_nearer {
            self.nearest = Some(Nearest {
                bic,
                effects: hypothesis.effects.clone(),
                iterate: hypothesis.iterate.clone(),
            });
        }
    }

    /// The rejected hypothesis of the smallest BIC, of at most [`MAX_EFFECTS`] effects, if library terms do not have a
    /// smaller one.
    pub fn nearest(
        &self,
        model: &ScoreTestModel<'_>,
        terms: Option<&StepwiseModel>,
    ) -> Option<Hypothesis> {
        let of_terms = terms.map_or(f64::INFINITY, |terms| bic_of_terms(model, terms));
        let nearest = self
            .nearest
            .as_ref()
            .filter(|nearest| nearest.bic < of_terms)?;
        model.fit_hypothesis(&nearest.effects, &nearest.iterate, &self.noise)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::context::CandidateId;
    use crate::selection::Weights;
    use crate::test_support::fixture;

    #[test]
    fn the_nearest_has_the_least_bic_of_all_rounds_and_few_effects() {
        let mut fixture = fixture();
        let noise = fixture.fit.noise().clone();
        let weights = Weights::EstimatedFrom(&noise);
        let mut search = Search::new(&mut fixture.model, &fixture.iterate, weights).unwrap();
        search.nearest = None;
        assert!(search.nearest(&fixture.model, None).is_none());
        let all = ["stall", "air-density", "roll-damping", "gravity"];
        for names in [&all[1..2], &all[..1], &all[2..3], &all] {
            let mut effects: Vec<CandidateId> =
                names.iter().map(|name| fixture.candidate(name)).collect();
            effects.sort_unstable();
            let (model, from) = (&fixture.model, &fixture.iterate);
            let hypothesis = model.fit_hypothesis(&effects, from, &search.noise).unwrap();
            search.note_nearest(model, &hypothesis);
        }
        let nearest = search.nearest(&fixture.model, None).unwrap();
        assert_eq!(nearest.effects, [fixture.candidate("stall")]);
    }
}
