//! A hypothesis: one or several candidate effects that the model lacks, fitted together.

use identify::{FitProblem, Iterate, NoiseModel};

use crate::context::{CandidateId, LinearizationPoint, Refitted, ScoreTestModel, TrajectoryCache};
use crate::error::DiagnosisError;
use crate::score_test::ScoreTests;

/// Maximum number of effects of a hypothesis that is accepted without improving out-of-sample predictions.
const MAX_EFFECTS_UNVALIDATED: usize = 2;

/// Thresholds of log p-values, below which the smallest falls with its familywise level by chance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Thresholds {
    /// Of a candidate or term at the fit of the model under test: a model error is detected.
    pub detect: f64,
    /// Of a further candidate or term, given a hypothesis: it is rejected.
    pub reject: f64,
}

/// Assumption that the model lacks one or several candidate effects, fitted together with the model under test.
pub(crate) struct Hypothesis {
    pub effects: Vec<CandidateId>,
    pub problem: FitProblem,
    pub iterate: Iterate,
    pub squares: f64,
    pub tests: ScoreTests,
    /// False if the fit reached its maximum number of steps or was abandoned.
    pub is_finished: bool,
    cache: TrajectoryCache,
}

impl Hypothesis {
    pub fn linearization_point(&self) -> LinearizationPoint<'_> {
        LinearizationPoint {
            problem: &self.problem,
            iterate: &self.iterate,
            cache: &self.cache,
        }
    }

    pub fn strongest_remaining(&self) -> Option<(CandidateId, f64)> {
        let strongest = self.tests.strongest_candidate();
        strongest.map(|(id, test)| (id, test.ln_p_value))
    }

    /// Whether the hypothesis contains several effects, and all of them change the same load or equation, such as lift.
    pub fn combines_one_site(&self, model: &ScoreTestModel<'_>) -> bool {
        let mut sites = self.effects.iter().map(|&id| &model.candidate(id).site);
        let first = sites.next();
        self.effects.len() > 1 && sites.all(|site| Some(site) == first)
    }

    /// Whether the hypothesis can fit almost any data, and is accepted only if it improves predictions: more than
    /// [`MAX_EFFECTS_UNVALIDATED`] effects, or one with a value for each flight.
    pub fn is_overflexible(&self, model: &ScoreTestModel<'_>) -> bool {
        let mut effects = self.effects.iter();
        self.effects.len() > MAX_EFFECTS_UNVALIDATED
            || effects.any(|&id| model.candidate(id).is_per_flight())
    }
}

impl ScoreTestModel<'_> {
    /// Fits `effects` together with the model under test, from `from`; `None` if the fit or the tests fail.
    pub fn fit_hypothesis(
        &self,
        effects: &[CandidateId],
        from: &Iterate,
        noise: &NoiseModel,
    ) -> Option<Hypothesis> {
        self.fit_hypothesis_cached(effects, from, noise, TrajectoryCache::DISABLED)
    }

    /// [`fit_hypothesis`](Self::fit_hypothesis) that stores trajectories in `cache`.
    pub fn fit_hypothesis_cached(
        &self,
        effects: &[CandidateId],
        from: &Iterate,
        noise: &NoiseModel,
        cache: TrajectoryCache,
    ) -> Option<Hypothesis> {
        let Refitted {
            iterate,
            squares,
            is_finished,
        } = self.refit(effects, from, noise).ok()?;
        let problem = self.problem_with(effects);
        let blocks = match cache.is_disabled() {
            true => self.normal_equations(&problem, &iterate, noise).ok()?,
            false => {
                let at = LinearizationPoint {
                    problem: &problem,
                    iterate: &iterate,
                    cache: &cache,
                };
                let blocks = self.normal_equations_with_terms(at, noise).ok()?;
                let each = blocks.iter();
                each.map(|block| self.without_terms(block)).collect()
            }
        };
        let tests = ScoreTests::new(self, &blocks, effects, &iterate.global).ok()?;
        Some(Hypothesis {
            effects: effects.to_vec(),
            problem,
            iterate,
            squares,
            tests,
            is_finished,
            cache,
        })
    }

    /// Score tests of the library terms and other candidates, given the hypothesis.
    pub fn tests_given(
        &self,
        hypothesis: &Hypothesis,
        noise: &NoiseModel,
    ) -> Result<ScoreTests, DiagnosisError> {
        let at = hypothesis.linearization_point();
        let blocks = self.normal_equations_with_terms(at, noise)?;
        ScoreTests::new(self, &blocks, &hypothesis.effects, &at.iterate.global)
    }

    /// Whether no candidate and no library term remains significant, given the hypothesis.
    pub fn is_adequate(
        &self,
        hypothesis: &Hypothesis,
        noise: &NoiseModel,
        thresholds: Thresholds,
    ) -> Result<bool, DiagnosisError> {
        let remaining = hypothesis.strongest_remaining();
        if remaining.is_some_and(|(_, ln_p_value)| ln_p_value < thresholds.reject) {
            return Ok(false);
        }
        let tests = self.tests_given(hypothesis, noise)?;
        let term = tests.strongest_term();
        Ok(term.is_none_or(|(_, test)| test.ln_p_value >= thresholds.reject))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_support::fixture;

    #[test]
    fn the_seeded_effect_alone_is_adequate_and_another_is_not() {
        let fixture = fixture();
        let (model, noise) = (&fixture.model, fixture.fit.noise());
        let thresholds = Thresholds {
            detect: -8.0,
            reject: -9.0,
        };
        for (name, expected) in [("stall", true), ("air-density", false)] {
            let effects = [fixture.candidate(name)];
            let hypothesis = model
                .fit_hypothesis(&effects, &fixture.iterate, noise)
                .unwrap();
            let found = model.is_adequate(&hypothesis, noise, thresholds).unwrap();
            assert_eq!(found, expected, "{name}");
            assert!(!hypothesis.is_overflexible(model));
            // A single effect is no combination.
            assert!(!hypothesis.combines_one_site(model));
        }
        let gusts = [fixture.candidate("wind-of-each-flight")];
        let hypothesis = model
            .fit_hypothesis(&gusts, &fixture.iterate, noise)
            .unwrap();
        assert!(hypothesis.is_overflexible(model));
    }
}
