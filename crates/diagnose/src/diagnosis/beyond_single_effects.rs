//! Search for explanations if no single candidate effect is adequate.

use super::Discordant;
use super::analysis::{Analysis, FREE_UNKNOWNS};
use crate::consensus::consensus;
use crate::context::CandidateId;
use crate::error::DiagnosisError;
use crate::report::Consensus;
use crate::selection::{MAX_EFFECTS, MAX_SELECTED, StepwiseModel};

impl Analysis<'_> {
    /// Searches for several candidates together, library terms, or effects on which the flights agree. Terms replace
    /// candidates if they explain as much with fewer unknowns. Where nothing is adequate, the best of the hypotheses
    /// remains, as the nearest, if terms do not explain more.
    pub(super) fn search_beyond_single_effects(&mut self) -> Result<(), DiagnosisError> {
        let few = |effects: &[_]| self.model.unknowns_of(effects) <= FREE_UNKNOWNS;
        let singles = &self.search.rejected;
        let single = singles.iter().position(|h| few(&h.effects));
        let single = single.map(|index| self.search.rejected[index].effects.clone());
        self.stepwise = StepwiseModel::start(&self.model, &self.search, None);
        for fewer in 1..MAX_EFFECTS {
            self.add_effect()?;
            self.extend_terms(fewer);
            if !self.search.accepted.is_empty() || self.has_adequate_terms() {
                break;
            }
        }
        if self.search.accepted.is_empty() && !self.has_adequate_terms() {
            self.add_effect()?;
        }
        if self.search.accepted.is_empty() {
            if let Some(stepwise) = &mut self.stepwise {
                stepwise.extend(&self.model, &self.search, &self.before, MAX_SELECTED);
            }
            // A candidate that is not adequate alone may be adequate together with library terms.
            if let (Some(single), false) = (single, self.has_adequate_terms()) {
                self.search_terms_beside(&single);
            }
        }
        self.select_by_bic(0);
        if self.search.accepted.is_empty() && !self.has_adequate_terms() {
            self.search_consensus();
            if self.consensus.is_none() {
                let nearest = self.search.nearest(&self.model, self.stepwise.as_ref());
                self.is_nearest_only = nearest.is_some();
                self.search.accepted.extend(nearest);
            }
        }
        Ok(())
    }

    /// Adds an effect to the rejected hypotheses. Noise that contained misfit weighted the terms, too; these start again.
    fn add_effect(&mut self) -> Result<(), DiagnosisError> {
        self.search.add_effect(&self.model);
        let alpha = self.model.context.options.alpha_detect;
        let unexplained = self.residuals.as_ref().filter(|own| own.fails(alpha));
        let floor = unexplained.map(|own| &own.noise);
        let (model, base) = (&mut self.model, &self.base);
        if self.search.judge_with_less_noise(model, base, floor)? {
            self.stepwise = StepwiseModel::start(&self.model, &self.search, None);
        }
        Ok(())
    }

    /// Adds library terms as alternatives: fewer than the unknowns of an accepted hypothesis, or as many if its effects
    /// change one load, which may approximate a law outside the catalogue; otherwise up to `most`, if the next is
    /// expected to explain about as much as the best rejected hypothesis.
    fn extend_terms(&mut self, most: usize) {
        let (search, Some(stepwise)) = (&self.search, &mut self.stepwise) else {
            return;
        };
        let most = match (search.accepted.first(), search.rejected.first()) {
            (Some(accepted), _) => {
                let unknowns = self.model.unknowns_of(&accepted.effects);
                let limit = match accepted.combines_one_site(&self.model) {
                    true => unknowns,
                    false => unknowns.saturating_sub(1),
                };
                limit.min(MAX_SELECTED)
            }
            (None, Some(rejected)) => {
                let expected = stepwise.expected_squares();
                let promises = expected.is_some_and(|e| search.is_near(e, rejected.squares));
                if promises { most } else { 0 }
            }
            (None, None) => most,
        };
        stepwise.extend(&self.model, search, &self.before, most);
    }

    /// Selects library terms beside the candidates `effects`; the better of this and the present selection is kept.
    fn search_terms_beside(&mut self, effects: &[CandidateId]) {
        let (model, search) = (&self.model, &self.search);
        let single = model.fit_hypothesis(effects, &self.base, &search.noise);
        let beside = single
            .and_then(|single| StepwiseModel::select(model, search, &self.before, Some(&single)));
        self.stepwise = StepwiseModel::better(self.stepwise.take(), beside);
    }

    /// Accepts hypotheses whose effect has the same sign in most flights, and stores the discordant flights.
    fn search_consensus(&mut self) {
        let Some(found) = consensus(&self.model, &self.search, &self.base) else {
            return;
        };
        if !found.discordant.is_empty() {
            let files = found.discordant.iter();
            self.discordant = Some(Discordant {
                files: files
                    .map(|&flight| self.model.flights[flight].file.clone())
                    .collect(),
                p_value: found.p_value,
            });
        }
        if !found.hypotheses.is_empty() {
            self.search.accepted = found.hypotheses;
            self.consensus = Some(Consensus {
                flights: self.model.flights.len(),
                explained_fraction: Some(found.explained_fraction),
                p_value: found.p_value,
                discordant: Vec::new(),
            });
        }
    }
}
