//! What follows a round of the search: its repetition with less noise, and further hypotheses that may be adequate.

use model_spec::sort_by_number;

use super::hypothesis::Hypothesis;
use super::search::{MAX_EFFECTS, Search, Weights};
use crate::context::{CandidateId, LinearizationPoint, ScoreTestModel};
use crate::error::{DiagnosisError, if_possible};

/// Ratio of noise estimates above which the larger one contains misfit.
pub(crate) const INFLATED: f64 = 2.0;

/// Familywise p-value below which the strongest further candidate is reported, too.
const ALPHA_UNDECIDED: f64 = 0.05;

impl Search {
    /// Repeats the search with the noise that the best hypothesis leaves, if that is far less: the noise was estimated
    /// with one that describes the flights badly, and against it anything is adequate.
    pub(super) fn repeat_with_less_noise(
        &mut self,
        model: &mut ScoreTestModel<'_>,
        base: LinearizationPoint<'_>,
    ) -> Result<(), DiagnosisError> {
        let Some(best) = self.accepted.first() else {
            return Ok(());
        };
        let at = best.linearization_point();
        let found = if_possible(model.estimate_noise(at, &best.effects, &self.noise))?;
        let Some(noise) = found.filter(|own| INFLATED * own.overall() < self.noise.overall())
        else {
            return Ok(());
        };
        self.noise = noise;
        self.at_base = model.tests_at(base, &self.noise)?;
        let accepted = std::mem::take(&mut self.accepted);
        let noise = self.noise.clone();
        let mut fitted = self.fit_single_effects(model, base, Weights::Known(&noise))?;
        for own in accepted {
            fitted.retain(|again| again.effects != own.effects);
            fitted.extend(model.fit_hypothesis(&own.effects, &own.iterate, &self.noise));
        }
        self.classify(model, fitted)
    }

    /// Adds adequate hypotheses with one value for all flights of an effect of the same site, instead of a value for
    /// each: fits from far away may not have arrived at them.
    pub(super) fn add_common(&mut self, model: &ScoreTestModel<'_>) -> Result<(), DiagnosisError> {
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
                    model.context.check_cancelled()?;
                    if model.is_exhausted() {
                        break;
                    }
                    let from = model.at_null_value(&accepted.iterate, of_each);
                    common.extend(self.adequate(model, &effects, &from)?);
                }
            }
        }
        self.accepted.extend(common);
        sort_by_number(&mut self.accepted, |hypothesis| hypothesis.squares);
        Ok(())
    }

    /// If one hypothesis is accepted and the strongest further candidate is near significance, accepts the hypothesis
    /// with it, too: the flights do not decide.
    pub fn add_undecided(&mut self, model: &ScoreTestModel<'_>) -> Result<(), DiagnosisError> {
        let [best] = &self.accepted[..] else {
            return Ok(());
        };
        let limit = (ALPHA_UNDECIDED / model.candidates().len() as f64).ln();
        let remaining = best.strongest_remaining();
        let Some((candidate, _)) = remaining.filter(|(_, ln_p_value)| *ln_p_value < limit) else {
            return Ok(());
        };
        model.context.check_cancelled()?;
        if best.effects.len() >= MAX_EFFECTS || model.is_exhausted() {
            return Ok(());
        }
        let mut effects = best.effects.clone();
        effects.push(candidate);
        effects.sort_unstable();
        let with = model.fit_hypothesis(&effects, &best.iterate, &self.noise);
        self.accepted.extend(with);
        Ok(())
    }
}
