//! Search over hypotheses: first single effects, then hypotheses with one more effect as long as none is adequate.

use identify::{Iterate, NoiseModel, fit};
use model_spec::sort_by_number;

use super::hypothesis::{Hypothesis, Thresholds};
use crate::context::{CandidateId, LinearizationPoint, ScoreTestModel, TrajectoryCache};
use crate::error::DiagnosisError;
use crate::score_test::{ScoreTest, ScoreTests};

/// Margin of χ² above the smallest expected one within which a hypothesis is fitted, and further one for linearization
/// error, as a fraction of the decrease by the best extension.
const MARGIN: (f64, f64) = (30.0, 0.25);

/// Maximum number of hypotheses fitted in one round of the search; all of them have the same number of effects.
const MAX_REFITS: usize = 6;

/// Maximum number of missing effects in one hypothesis.
pub(crate) const MAX_EFFECTS: usize = 3;

/// Maximum difference of equal noise estimates: relative for standard deviations, absolute for autocorrelations.
const NOISE_TOLERANCE: f64 = 0.05;

/// Maximum number of rejected hypotheses that the search extends by one further effect.
const MAX_PARENTS: usize = 3;

/// State of the search for hypotheses, each a combination of candidate effects that the model under test may lack.
pub(crate) struct Search {
    pub noise: NoiseModel,
    /// Score tests of all candidate effects and library terms at the fit of the model under test.
    pub at_base: TestsAtPoint,
    /// Model confidence set: hypotheses that are not rejected, best fit first.
    pub accepted: Vec<Hypothesis>,
    /// Hypotheses of the last round without an adequate one, best fit first.
    pub rejected: Vec<Hypothesis>,
    /// The rejected hypothesis of the smallest BIC, of all rounds.
    pub(super) nearest: Option<Nearest>,
}

/// A hypothesis as the start of its fit.
pub(super) struct Nearest {
    pub bic: f64,
    pub effects: Vec<CandidateId>,
    pub iterate: Iterate,
}

/// Score tests of candidate effects and library terms at a linearization point.
pub(crate) struct TestsAtPoint {
    pub tests: ScoreTests,
    /// Familywise thresholds of log p-values, for detection and rejection.
    pub thresholds: Thresholds,
    pub squares: f64,
}

/// Noise model with which a search weights the residuals.
#[derive(Clone, Copy)]
pub(crate) enum Weights<'n> {
    /// The noise is estimated by the search, from residuals that are weighted with this noise model.
    EstimatedFrom(&'n NoiseModel),
    /// The noise is known: the search weights residuals with this noise model and does not estimate another one.
    Known(&'n NoiseModel),
}

impl ScoreTestModel<'_> {
    /// Score tests of all candidates and library terms at `at`.
    pub fn tests_at(
        &self,
        at: LinearizationPoint<'_>,
        noise: &NoiseModel,
    ) -> Result<TestsAtPoint, DiagnosisError> {
        let blocks = self.normal_equations_with_terms(at, noise)?;
        let tests = ScoreTests::new(self, &blocks, &[], &at.iterate.global)?;
        let options = self.context.options;
        let [detect, reject] = tests.thresholds([options.alpha_detect, options.alpha_reject]);
        Ok(TestsAtPoint {
            tests,
            thresholds: Thresholds { detect, reject },
            squares: blocks.iter().map(|block| block.squares).sum(),
        })
    }
}

impl Search {
    /// Tests all candidates at the fit of the model under test, and fits the strongest as single effects.
    pub fn new(
        model: &mut ScoreTestModel<'_>,
        base: &Iterate,
        weights: Weights<'_>,
    ) -> Result<Self, DiagnosisError> {
        let problem = model.problem.clone();
        let cache = TrajectoryCache::for_flights(model.flights.len());
        let base = LinearizationPoint {
            problem: &problem,
            iterate: base,
            cache: &cache,
        };
        let noise = match weights {
            Weights::EstimatedFrom(noise) => model.estimate_noise(base, &[], noise)?,
            Weights::Known(noise) => noise.clone(),
        };
        let mut search = Self {
            at_base: model.tests_at(base, &noise)?,
            noise,
            accepted: Vec::new(),
            rejected: Vec::new(),
            nearest: None,
        };
        if search.is_significant() {
            let fitted = search.fit_single_effects(model, base, weights);
            search.classify(model, fitted);
            if matches!(weights, Weights::EstimatedFrom(_)) {
                search.repeat_with_less_noise(model, base)?;
            }
        }
        Ok(search)
    }

    /// Whether a candidate or a library term is significant at the fit of the model under test.
    pub fn is_significant(&self) -> bool {
        let term = self.at_base.tests.strongest_term();
        self.has_significant_candidate() || term.is_some_and(|(_, test)| self.is_detected(test))
    }

    /// Whether a candidate is significant there.
    pub fn has_significant_candidate(&self) -> bool {
        let candidate = self.at_base.tests.strongest_candidate();
        candidate.is_some_and(|(_, test)| self.is_detected(test))
    }

    fn is_detected(&self, test: &ScoreTest) -> bool {
        test.ln_p_value < self.at_base.thresholds.detect
    }

    /// Whether an `expected` χ² is below `fitted`, or above it by less than the margin.
    pub fn is_near(&self, expected: f64, fitted: f64) -> bool {
        expected < fitted + MARGIN.0 + MARGIN.1 * (self.at_base.squares - fitted)
    }

    /// Fits the strongest candidates one by one. Noise that is not known is estimated again with the first; if it
    /// changes, all tests are repeated. None if nothing is significant in these.
    pub(super) fn fit_single_effects(
        &mut self,
        model: &mut ScoreTestModel<'_>,
        base: LinearizationPoint<'_>,
        weights: Weights<'_>,
    ) -> Vec<Hypothesis> {
        let mut fitted: Vec<Hypothesis> = Vec::new();
        for (index, effects) in strongest_singles(&self.at_base.tests)
            .into_iter()
            .enumerate()
        {
            if index > 0 && model.context.is_out_of_time() {
                break;
            }
            // The first hypothesis is linearized several times.
            let cache = match index {
                0 => TrajectoryCache::for_flights(model.flights.len()),
                _ => TrajectoryCache::DISABLED,
            };
            let from = base.iterate;
            let hypothesis = model.fit_hypothesis_cached(&effects, from, &self.noise, cache);
            let Some(mut hypothesis) = hypothesis else {
                continue;
            };
            let is_first = fitted.is_empty();
            if is_first && !hypothesis.is_finished {
                hypothesis = self.fitted_from_scratch(model, hypothesis);
            }
            let is_estimated = is_first && matches!(weights, Weights::EstimatedFrom(_));
            if is_estimated && matches!(self.refine_noise(model, &hypothesis, base), Ok(true)) {
                if !self.is_significant() {
                    return Vec::new();
                }
                let from = &hypothesis.iterate;
                fitted.extend(model.fit_hypothesis(&effects, from, &self.noise));
            } else {
                fitted.push(hypothesis);
            }
        }
        fitted
    }

    /// Fits a hypothesis that did not converge from the samples; the better fit is returned.
    fn fitted_from_scratch(
        &self,
        model: &ScoreTestModel<'_>,
        hypothesis: Hypothesis,
    ) -> Hypothesis {
        let context = model.context;
        let fitted = || {
            let extension = hypothesis.extension(model).ok()?;
            let fit = fit(&extension.model, context.dataset, &context.options.fit).ok()?;
            let cache = TrajectoryCache::for_flights(model.flights.len());
            let from = model.iterate_of(&fit)?;
            model.fit_hypothesis_cached(&hypothesis.effects, &from, &self.noise, cache)
        };
        let again = fitted().filter(|again| again.squares < hypothesis.squares);
        again.unwrap_or(hypothesis)
    }

    /// Estimates the noise with `given` included. If it differs, repeats all tests and returns true.
    fn refine_noise(
        &mut self,
        model: &mut ScoreTestModel<'_>,
        given: &Hypothesis,
        base: LinearizationPoint<'_>,
    ) -> Result<bool, DiagnosisError> {
        let at = given.linearization_point();
        let noise = model.estimate_noise(at, &given.effects, &self.noise)?;
        if noise.is_within(&self.noise, NOISE_TOLERANCE) {
            return Ok(false);
        }
        self.noise = noise;
        self.at_base = model.tests_at(base, &self.noise)?;
        Ok(true)
    }

    /// Stores the adequate ones of `fitted` as accepted; if none is, all as rejected; by ascending χ².
    pub(super) fn classify(&mut self, model: &ScoreTestModel<'_>, mut fitted: Vec<Hypothesis>) {
        sort_by_number(&mut fitted, |hypothesis| hypothesis.squares);
        let (adequate, others): (Vec<_>, Vec<_>) = fitted
            .into_iter()
            .partition(|hypothesis| self.is_adequate(model, hypothesis));
        if adequate.is_empty() {
            for hypothesis in &others {
                self.note_nearest(model, hypothesis);
            }
            self.rejected = others;
        } else {
            self.accepted = adequate;
            self.add_common(model);
        }
    }

    /// Whether a hypothesis is adequate; not if that cannot be tested.
    fn is_adequate(&self, model: &ScoreTestModel<'_>, hypothesis: &Hypothesis) -> bool {
        let found = model.is_adequate(hypothesis, &self.noise, self.at_base.thresholds);
        found.unwrap_or(false)
    }

    /// Forward selection by one effect, then backward elimination; more than [`MAX_EFFECTS`] must become fewer.
    pub fn add_effect(&mut self, model: &ScoreTestModel<'_>) {
        let Some(count) = self.rejected.first().map(|h| h.effects.len() + 1) else {
            return;
        };
        if count > MAX_EFFECTS + 1 {
            return;
        }
        let mut fitted = Vec::new();
        for (effects, parent) in strongest_additions(&self.rejected, count) {
            if model.is_exhausted() {
                break;
            }
            let from = &self.rejected[parent].iterate;
            fitted.extend(model.fit_hypothesis(&effects, from, &self.noise));
        }
        if fitted.is_empty() {
            return;
        }
        self.classify(model, fitted);
        // Starting from a better fit, one effect of an accepted hypothesis may prove unnecessary.
        while let Some(fewer) = self.prune(model) {
            self.accepted = fewer;
        }
        self.accepted.retain(|h| h.effects.len() <= MAX_EFFECTS);
    }

    /// The hypothesis of `effects`, fitted from `from`, if it is adequate.
    pub(super) fn adequate(
        &self,
        model: &ScoreTestModel<'_>,
        effects: &[CandidateId],
        from: &Iterate,
    ) -> Option<Hypothesis> {
        let hypothesis = model.fit_hypothesis(effects, from, &self.noise)?;
        self.is_adequate(model, &hypothesis).then_some(hypothesis)
    }

    /// Adequate hypotheses with one effect fewer than the accepted ones; `None` if every effect is needed.
    fn prune(&self, model: &ScoreTestModel<'_>) -> Option<Vec<Hypothesis>> {
        let mut fewer: Vec<Hypothesis> = Vec::new();
        for hypothesis in self.accepted.iter().filter(|h| h.effects.len() > 1) {
            for dropped in &hypothesis.effects {
                if model.is_exhausted() {
                    break;
                }
                let rest = hypothesis.effects.iter().copied().filter(|e| e != dropped);
                let rest: Vec<CandidateId> = rest.collect();
                if fewer.iter().any(|known| known.effects == rest) {
                    continue;
                }
                let from = model.at_null_value(&hypothesis.iterate, *dropped);
                fewer.extend(self.adequate(model, &rest, &from));
            }
        }
        sort_by_number(&mut fewer, |hypothesis| hypothesis.squares);
        (!fewer.is_empty()).then_some(fewer)
    }
}

/// Score statistic minus the Akaike penalty of 2 for each degree of freedom.
fn penalized(test: &ScoreTest) -> f64 {
    test.score_chi2 - 2.0 * test.degrees_of_freedom as f64
}

/// Single effects that are worth fitting: the largest penalized statistics, within the margin; at most [`MAX_REFITS`].
fn strongest_singles(tests: &ScoreTests) -> Vec<Vec<CandidateId>> {
    let each = tests.candidates.iter_enumerated();
    let mut decreases: Vec<(CandidateId, f64)> = each
        .filter_map(|(id, test)| Some((id, test.as_ref()?)))
        .filter(|(_, test)| test.degrees_of_freedom > 0)
        .map(|(id, test)| (id, penalized(test)))
        .collect();
    sort_by_number(&mut decreases, |decrease| -decrease.1);
    let best = decreases.first().map_or(0.0, |first| first.1);
    let near = decreases
        .into_iter()
        .filter(|(_, decrease)| *decrease > best - MARGIN.0 - MARGIN.1 * best);
    near.take(MAX_REFITS).map(|(id, _)| vec![id]).collect()
}

/// Extensions of rejected hypotheses to `count` effects that are worth fitting, each with the index of its parent: the
/// smallest expected χ², within the margin; at most [`MAX_REFITS`].
fn strongest_additions(rejected: &[Hypothesis], count: usize) -> Vec<(Vec<CandidateId>, usize)> {
    let mut all: Vec<(Vec<CandidateId>, usize, f64)> = Vec::new();
    for (parent, hypothesis) in rejected.iter().enumerate().take(MAX_PARENTS) {
        for (id, test) in hypothesis.tests.candidates.iter_enumerated() {
            let Some(test) = test.as_ref().filter(|test| test.degrees_of_freedom > 0) else {
                continue;
            };
            let mut effects = hypothesis.effects.clone();
            effects.push(id);
            effects.sort_unstable();
            let expected = hypothesis.squares - penalized(test);
            match all.iter_mut().find(|(same, ..)| *same == effects) {
                Some((_, from, least)) if expected < *least => {
                    (*from, *least) = (parent, expected);
                }
                Some(_) => {}
                None if effects.len() == count => all.push((effects, parent, expected)),
                None => {}
            }
        }
    }
    sort_by_number(&mut all, |addition| addition.2);
    let least = all.first().map_or(0.0, |first| first.2);
    let decrease = rejected.first().map_or(0.0, |best| best.squares) - least;
    let near = all
        .into_iter()
        .filter(|(.., expected)| *expected < least + MARGIN.0 + MARGIN.1 * decrease);
    near.take(MAX_REFITS)
        .map(|(effects, parent, _)| (effects, parent))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_support::{Fixture, fixture};

    /// Calls `with` with the test fixture and with a search that starts at the fit of the fixture; the accepted
    /// hypotheses are removed from the search.
    fn searched(with: impl FnOnce(&Fixture, Search)) {
        let mut fixture = fixture();
        let noise = fixture.fit.noise().clone();
        let mut search = Search::new(
            &mut fixture.model,
            &fixture.iterate,
            Weights::EstimatedFrom(&noise),
        )
        .unwrap();
        search.accepted.clear();
        with(&fixture, search);
    }

    fn hypothesis(fixture: &Fixture, search: &Search, names: &[&str]) -> Hypothesis {
        let mut effects: Vec<CandidateId> = names.iter().map(|n| fixture.candidate(n)).collect();
        effects.sort_unstable();
        let found = fixture
            .model
            .fit_hypothesis(&effects, &fixture.iterate, &search.noise);
        found.unwrap()
    }

    #[test]
    fn an_effect_that_may_be_missing_too_is_added_to_the_set() {
        searched(|fixture, mut search| {
            search.accepted = vec![hypothesis(fixture, &search, &["stall"])];
            search.add_undecided(&fixture.model);
            assert_eq!(search.accepted.len(), 1);
            search.accepted = vec![hypothesis(fixture, &search, &["air-density"])];
            search.add_undecided(&fixture.model);
            let [first, second] = &search.accepted[..] else {
                panic!("{} hypotheses", search.accepted.len());
            };
            assert_eq!(first.effects, [fixture.candidate("air-density")]);
            assert!(second.effects.contains(&fixture.candidate("stall")));
        });
    }

    #[test]
    fn an_exchange_leads_from_wrong_effects_to_the_right_one() {
        searched(|fixture, mut search| {
            let wrong = ["air-density", "roll-damping", "gravity"];
            assert_eq!(wrong.len(), MAX_EFFECTS);
            search.rejected = vec![hypothesis(fixture, &search, &wrong)];
            search.add_effect(&fixture.model);
            assert!(!search.accepted.is_empty());
            let stall = fixture.candidate("stall");
            assert!(
                search
                    .accepted
                    .iter()
                    .all(|h| h.effects.len() <= MAX_EFFECTS)
            );
            assert!(search.accepted.iter().any(|h| h.effects == [stall]));
        });
    }

    #[test]
    fn a_refit_that_did_not_arrive_starts_again_from_the_samples() {
        searched(|fixture, search| {
            let arrived = hypothesis(fixture, &search, &["stall"]);
            let mut stuck = hypothesis(fixture, &search, &["stall"]);
            (stuck.squares, stuck.is_finished) = (10.0 * arrived.squares, false);
            let found = search.fitted_from_scratch(&fixture.model, stuck);
            assert!(found.is_finished);
            assert!((found.squares / arrived.squares - 1.0).abs() < 1e-3);
        });
    }
}
