//! Search for explanations if no single candidate effect is adequate.

use super::Discordant;
use super::analysis::{Analysis, FREE_UNKNOWNS};
use crate::consensus::consensus;
use crate::context::CandidateId;
use crate::error::DiagnosisError;
use crate::report::Consensus;
use crate::selection::{MAX_EFFECTS, MAX_SELECTED, StepwiseModel};

impl Analysis<'_> {
    /// Searches for explanations of the misfit if no single candidate effect is adequate: several candidates together,
    /// library terms, or effects on which the flights agree. Library terms replace candidates if they explain as much
    /// with fewer unknowns.
    pub(super) fn search_beyond_single_effects(&mut self) -> Result<(), DiagnosisError> {
        let few = |effects: &[_]| self.model.unknowns_of(effects) <= FREE_UNKNOWNS;
        let singles = &self.search.rejected;
        let single = singles.iter().position(|h| few(&h.effects));
        let single = single.map(|index| self.search.rejected[index].effects.clone());
        self.stepwise = StepwiseModel::start(&self.model, &self.search, None)?;
        for fewer in 1..MAX_EFFECTS {
            self.search.add_effect(&self.model)?;
            self.extend_terms(fewer)?;
            if !self.search.accepted.is_empty() || self.has_adequate_terms() {
                break;
            }
        }
        if self.search.accepted.is_empty() && !self.has_adequate_terms() {
            self.search.add_effect(&self.model)?;
        }
        if self.search.accepted.is_empty() {
            if let Some(stepwise) = &mut self.stepwise {
                stepwise.extend(&self.model, &self.search, &self.before, MAX_SELECTED)?;
            }
            // A candidate that is not adequate alone may be adequate together with library terms.
            if let (Some(single), false) = (single, self.has_adequate_terms()) {
                self.search_terms_beside(&single)?;
            }
        }
        self.select_by_bic(0);
        if self.search.accepted.is_empty() && !self.has_adequate_terms() {
            self.search_consensus()?;
        }
        Ok(())
    }

    /// Adds library terms to the stepwise regression, as alternatives to the hypotheses. If a hypothesis is accepted,
    /// the number of terms remains below the number of its unknowns. It may reach this number if all effects of the
    /// hypothesis change the same load, because they may then approximate a law of this load that is not in the
    /// catalogue. Otherwise up to `most` terms are selected, but none is added if the next term is expected to explain
    /// much less than the best rejected hypothesis.
    fn extend_terms(&mut self, most: usize) -> Result<(), DiagnosisError> {
        let (search, Some(stepwise)) = (&self.search, &mut self.stepwise) else {
            return Ok(());
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
        stepwise.extend(&self.model, search, &self.before, most)
    }

    /// Selects library terms with the candidate effects `effects` included in the model. If terms were already selected
    /// without these effects, the better of the two selections is stored, as determined by [`StepwiseModel::better`].
    fn search_terms_beside(&mut self, effects: &[CandidateId]) -> Result<(), DiagnosisError> {
        let (model, search) = (&self.model, &self.search);
        let Some(single) = model.fit_hypothesis(effects, &self.base, &search.noise) else {
            return Ok(());
        };
        let beside = StepwiseModel::select(model, search, &self.before, Some(&single))?;
        self.stepwise = StepwiseModel::better(self.stepwise.take(), beside);
        Ok(())
    }

    /// Searches for hypotheses whose effect has the same sign in most flights, and stores them as accepted. Also stores
    /// the discordant flights, in which the effect has the opposite sign.
    fn search_consensus(&mut self) -> Result<(), DiagnosisError> {
        let found = consensus(&self.model, &self.search, &self.base)?;
        let Some(found) = found else {
            return Ok(());
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
        Ok(())
    }
}
