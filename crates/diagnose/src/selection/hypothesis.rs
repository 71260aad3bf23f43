//! A hypothesis: one or several candidate effects that the model lacks, fitted together.

use identify::{FitProblem, Iterate, NoiseModel};

use super::thresholds::Thresholds;
use crate::context::{CandidateId, LinearizationPoint, Refitted, ScoreTestModel, TrajectoryCache};
use crate::error::DiagnosisError;
use crate::score_test::ScoreTests;

/// Maximum number of effects of a hypothesis that is accepted without improving out-of-sample predictions.
const MAX_EFFECTS_UNVALIDATED: usize = 2;

/// Assumption that the model lacks one or several candidate effects, fitted together with the model under test.
pub(crate) struct Hypothesis {
    /// The candidate effects that the hypothesis adds to the model under test.
    pub effects: Vec<CandidateId>,
    /// Estimation problem in which the candidate effects of this hypothesis are estimated.
    pub problem: FitProblem,
    /// Fitted values of all unknowns of `problem`.
    pub iterate: Iterate,
    /// Weighted sum of squares of the residuals at the fitted values.
    pub squares: f64,
    /// Score tests of all candidates outside this hypothesis, with the effects of this hypothesis as nuisance
    /// parameters.
    pub tests: ScoreTests,
    /// False if the fit reached the maximum number of steps, or was abandoned because it progressed slowly at a large
    /// misfit; true otherwise.
    pub is_finished: bool,
    cache: TrajectoryCache,
}

impl Hypothesis {
    /// Linearization point of the normal equations at the fitted values of this hypothesis.
    pub fn linearization_point(&self) -> LinearizationPoint<'_> {
        LinearizationPoint {
            problem: &self.problem,
            iterate: &self.iterate,
            cache: &self.cache,
        }
    }

    /// The candidate effect with the smallest p-value once this hypothesis is included, and its log p-value; `None` if
    /// no candidate can be tested.
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

    /// Whether the hypothesis can fit almost any data: an effect has one value for each flight, or there are more than
    /// [`MAX_EFFECTS_UNVALIDATED`] effects. Such a hypothesis is accepted only if it improves out-of-sample
    /// predictions.
    pub fn is_overflexible(&self, model: &ScoreTestModel<'_>) -> bool {
        let mut effects = self.effects.iter();
        self.effects.len() > MAX_EFFECTS_UNVALIDATED
            || effects.any(|&id| model.candidate(id).is_per_flight())
    }
}

impl ScoreTestModel<'_> {
    /// Fits the candidate effects `effects` together with the model under test, with `from` as initial values of the
    /// unknowns; `None` if the fit or the score tests fail.
    pub fn fit_hypothesis(
        &self,
        effects: &[CandidateId],
        from: &Iterate,
        noise: &NoiseModel,
    ) -> Option<Hypothesis> {
        self.fit_hypothesis_cached(effects, from, noise, TrajectoryCache::DISABLED)
    }

    /// Fits the candidate effects `effects` together with the model under test, with `from` as initial values of the
    /// unknowns. Stores the trajectories at the fitted values in `cache`. `None` if the fit or the score tests fail.
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

    /// Score tests of the library terms and of all candidates outside the hypothesis, with the effects of the
    /// hypothesis as nuisance parameters.
    ///
    /// # Errors
    /// [`DiagnosisError::Fit`] if a trajectory cannot be integrated.
    pub fn tests_given(
        &self,
        hypothesis: &Hypothesis,
        noise: &NoiseModel,
    ) -> Result<ScoreTests, DiagnosisError> {
        let at = hypothesis.linearization_point();
        let blocks = self.normal_equations_with_terms(at, noise)?;
        ScoreTests::new(self, &blocks, &hypothesis.effects, &at.iterate.global)
    }

    /// Whether a hypothesis is adequate: no candidate and no library term remains significant once the effects of the
    /// hypothesis are included.
    ///
    /// # Errors
    /// [`DiagnosisError::Fit`] if a trajectory cannot be integrated.
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
    use crate::selection::thresholds::Thresholds;
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
        }
        let gusts = [fixture.candidate("wind-of-each-flight")];
        let hypothesis = model
            .fit_hypothesis(&gusts, &fixture.iterate, noise)
            .unwrap();
        assert!(hypothesis.is_overflexible(model));
    }
}
