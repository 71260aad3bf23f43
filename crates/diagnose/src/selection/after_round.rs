//! What follows a round of the search: its repetition with less noise, and further hypotheses that may be adequate.

use identify::{Iterate, NoiseModel};
use model_spec::sort_by_number;

use super::hypothesis::Hypothesis;
use super::search::{MAX_EFFECTS, Search, Weights};
use crate::context::{CandidateId, LinearizationPoint, ScoreTestModel, TrajectoryCache};
use crate::error::DiagnosisError;
use crate::score_test::chi2_ln_sf;

/// Ratio of noise estimates above which the larger one contains misfit.
pub(crate) const INFLATED: f64 = 2.0;

/// Familywise p-value below which the strongest further candidate is reported, too.
const ALPHA_UNDECIDED: f64 = 0.05;

/// Level of the noise at slow changes, where misfit is: that of correlated noise is far above its standard deviation.
fn slow_level(noise: &NoiseModel) -> f64 {
    let axes = noise.sigma.iter().zip(noise.ar1);
    let squares = axes.map(|(sigma, ar1)| sigma * sigma * (1.0 + ar1) / (1.0 - ar1));
    squares.sum::<f64>().sqrt()
}

impl Search {
    /// Repeats the search for single effects with the noise that the best hypothesis leaves, if that is far less.
    pub(super) fn repeat_with_less_noise(
        &mut self,
        model: &mut ScoreTestModel<'_>,
        base: LinearizationPoint<'_>,
    ) -> Result<(), DiagnosisError> {
        let Some(accepted) = self.take_less_noise(model, base, None)? else {
            return Ok(());
        };
        let noise = self.noise.clone();
        let mut fitted = self.fit_single_effects(model, base, Weights::Known(&noise));
        fitted.retain(|again| accepted.iter().all(|own| own.effects != again.effects));
        fitted.extend(accepted);
        self.classify(model, fitted);
        Ok(())
    }

    /// Judges accepted combinations again by the noise that the best of them leaves, or by `floor`, the noise that no
    /// smooth motion follows, if that is far less; returns whether it is. `base` is the fit of the model under test.
    pub fn judge_with_less_noise(
        &mut self,
        model: &mut ScoreTestModel<'_>,
        base: &Iterate,
        floor: Option<&NoiseModel>,
    ) -> Result<bool, DiagnosisError> {
        let problem = model.problem.clone();
        let base = LinearizationPoint {
            problem: &problem,
            iterate: base,
            cache: &TrajectoryCache::DISABLED,
        };
        let Some(accepted) = self.take_less_noise(model, base, floor)? else {
            return Ok(false);
        };
        self.classify(model, accepted);
        Ok(true)
    }

    /// Takes the noise that the best hypothesis leaves, or `floor`, if that is far less, and returns the accepted
    /// hypotheses, fitted with it: the noise was estimated with one that describes the flights badly, and against it
    /// anything is adequate.
    fn take_less_noise(
        &mut self,
        model: &mut ScoreTestModel<'_>,
        base: LinearizationPoint<'_>,
        floor: Option<&NoiseModel>,
    ) -> Result<Option<Vec<Hypothesis>>, DiagnosisError> {
        let Some(best) = self.accepted.first() else {
            return Ok(None);
        };
        let at = best.linearization_point();
        let left = model.estimate_noise(at, &best.effects, &self.noise);
        let least = left.into_iter().chain(floor.cloned());
        let least = least.min_by(|a, b| slow_level(a).total_cmp(&slow_level(b)));
        let is_less = |own: &NoiseModel| INFLATED * slow_level(own) < slow_level(&self.noise);
        let Some(noise) = least.filter(is_less) else {
            return Ok(None);
        };
        self.noise = noise;
        self.at_base = model.tests_at(base, &self.noise)?;
        self.nearest = None;
        let accepted = std::mem::take(&mut self.accepted).into_iter();
        let again = accepted
            .filter_map(|own| model.fit_hypothesis(&own.effects, &own.iterate, &self.noise));
        Ok(Some(again.collect()))
    }

    /// Whether a hypothesis is significant itself, by its decrease of χ².
    pub fn is_significant_itself(&self, model: &ScoreTestModel<'_>, own: &Hypothesis) -> bool {
        let decrease = self.at_base.squares - own.squares;
        chi2_ln_sf(decrease, model.unknowns_of(&own.effects)) < self.at_base.thresholds.detect
    }

    /// Drops hypotheses that are not significant themselves: where predictions refuse a better one, they do not explain
    /// what that one explained.
    pub fn keep_significant(&mut self, model: &ScoreTestModel<'_>) {
        let mut accepted = std::mem::take(&mut self.accepted);
        accepted.retain(|own| self.is_significant_itself(model, own));
        self.accepted = accepted;
    }

    /// Adds adequate hypotheses with one value for all flights of an effect of the same site, instead of a value for
    /// each: fits from far away may not have arrived at them.
    pub(super) fn add_common(&mut self, model: &ScoreTestModel<'_>) {
        let mut common: Vec<Hypothesis> = Vec::new();
        for accepted in &self.accepted {
            for &of_each in &accepted.effects {
                let own = model.candidate(of_each);
                let others = model.candidates().filter(|(id, other)| {
                    own.is_per_flight()
                        && !other.is_per_flight()
                        && other.site == own.site
                        && !model.columns_of(*id).is_empty()
                });
                for (other, _) in others {
                    let rest = accepted.effects.iter().copied().filter(|id| *id != of_each);
                    let mut effects: Vec<CandidateId> = rest.chain([other]).collect();
                    effects.sort_unstable();
                    effects.dedup();
                    let mut known = self.accepted.iter().chain(&common);
                    if known.any(|known| known.effects == effects) {
                        continue;
                    }
                    if model.is_exhausted() {
                        break;
                    }
                    let from = model.at_null_value(&accepted.iterate, of_each);
                    common.extend(self.adequate(model, &effects, &from));
                }
            }
        }
        self.accepted.extend(common);
        sort_by_number(&mut self.accepted, |hypothesis| hypothesis.squares);
    }

    /// If one hypothesis is accepted and the strongest further candidate is near significance, accepts the hypothesis
    /// with it, too: the flights do not decide.
    pub fn add_undecided(&mut self, model: &ScoreTestModel<'_>) {
        let [best] = &self.accepted[..] else {
            return;
        };
        let limit = (ALPHA_UNDECIDED / model.candidates().len() as f64).ln();
        let remaining = best.strongest_remaining();
        let Some((candidate, _)) = remaining.filter(|(_, ln_p_value)| *ln_p_value < limit) else {
            return;
        };
        if best.effects.len() >= MAX_EFFECTS || model.is_exhausted() {
            return;
        }
        let mut effects = best.effects.clone();
        effects.push(candidate);
        effects.sort_unstable();
        let with = model.fit_hypothesis(&effects, &best.iterate, &self.noise);
        self.accepted.extend(with);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_support::fixture;

    #[test]
    fn an_answer_is_judged_again_by_noise_that_it_explains() {
        let mut fixture = fixture();
        let noise = fixture.fit.noise().clone();
        let (model, base) = (&mut fixture.model, &fixture.iterate);
        let mut search = Search::new(model, base, Weights::EstimatedFrom(&noise)).unwrap();
        let right = search.accepted[0].effects.clone();
        // By the noise that the right answer leaves, nothing is judged again.
        assert!(!search.judge_with_less_noise(model, base, None).unwrap());
        let own = search.noise.clone();
        // Misfit that was taken for correlated noise: little of it, and against it everything is adequate.
        search.noise.ar1 = [0.9; 3];
        let wrong = model.candidates();
        let wrong = { wrong }
            .find(|(_, own)| own.name == "air-density")
            .unwrap()
            .0;
        let wrong = model.fit_hypothesis(&[wrong], base, &search.noise).unwrap();
        search.accepted = vec![wrong];
        let again = search.judge_with_less_noise(model, base, Some(&own));
        assert!(again.unwrap() && search.accepted.is_empty());
        assert!(slow_level(&search.noise) <= slow_level(&own));
        search.add_effect(model);
        assert!(search.accepted.iter().any(|found| found.effects == right));
    }

    #[test]
    fn what_is_not_significant_itself_explains_nothing() {
        let mut fixture = fixture();
        let noise = fixture.fit.noise().clone();
        let (model, base) = (&mut fixture.model, &fixture.iterate);
        let mut search = Search::new(model, base, Weights::EstimatedFrom(&noise)).unwrap();
        let count = search.accepted.len();
        search.keep_significant(model);
        assert_eq!(search.accepted.len(), count);
        for own in &mut search.accepted {
            own.squares = search.at_base.squares - 3.0;
        }
        search.keep_significant(model);
        assert!(search.accepted.is_empty());
    }
}
