//! Stepwise regression with library terms, used if no candidate effect explains the data.

use identify::{Fit, FitStatus, fit, refit};
use model_spec::compose::EffectTree;
use model_spec::index::IndexVec;
use model_spec::sort_by_number;
use serde::{Deserialize, Serialize};

use super::hypothesis::Hypothesis;
use super::search::Search;
use crate::context::{
    EncompassingModel, LibraryTerms, LinearizationPoint, ScoreTestModel, TermId, TrajectoryCache,
    identifier,
};
use crate::error::DiagnosisError;
use crate::extension::ExtendedModel;
use crate::score_test::{ScoreTest, ScoreTests};
use identify::numbers::significant;

/// Maximum number of library terms selected by the stepwise regression.
pub(crate) const MAX_SELECTED: usize = 4;

/// Maximum number of terms listed in the report, beside the selected ones.
const MAX_REPORTED: usize = 12;

/// Score test of one library term, as listed in a report.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StepwiseTerm {
    /// Display name of the effect that is created from the library term.
    pub name: String,
    /// Site of the library term: the load to which it is added, such as lift.
    pub site: String,
    /// Formula of the product of variables of the library term, in the model language.
    pub formula: String,
    /// Score statistic, χ² with one degree of freedom.
    pub score_chi2: f64,
    /// One-step estimate of the coefficient of the library term, SI.
    pub value: f64,
    /// Standard error of `value`, SI.
    pub std_error: f64,
    /// Whether the library term is part of the extended model.
    pub selected: bool,
}

/// The model under test with library terms selected one by one.
pub(crate) struct StepwiseModel {
    /// Identifiers of the candidate effects that are included in the model in addition to the library terms.
    pub effects: Vec<String>,
    /// Number of unknowns that the candidate effects of this model add, over all flights.
    effect_unknowns: usize,
    selected: Vec<TermId>,
    /// Library terms listed in the report: those with the largest score statistics, and the selected ones.
    listed: Vec<TermId>,
    /// Score test of each library term in the model without any selected term.
    first: IndexVec<TermId, StepwiseTerm>,
    /// Models extended by the first selected library term, by the first two terms, and so on, with their fits.
    pub fitted: Vec<FittedTerms>,
    /// Weighted sum of squares with the selected terms, by the noise of the search.
    pub squares: f64,
    /// Whether no candidate effect and no other library term is significant once the selected terms are included.
    pub is_adequate: bool,
    pub has_significant_term: bool,
    /// The library term to be selected next, and its score statistic; `None` if no further term is to be selected.
    next: Option<(TermId, f64)>,
}

/// The model extended by some library terms, with its fit.
pub(crate) struct FittedTerms {
    pub extension: ExtendedModel,
    pub fit: Fit,
    /// Weighted sum of squares of the residuals of `fit`; the weights follow from the noise that the search estimated.
    pub squares: f64,
}

impl StepwiseModel {
    /// The terms listed in the report.
    pub fn terms(&self) -> Vec<StepwiseTerm> {
        let each = self.listed.iter().map(|id| StepwiseTerm {
            selected: self.selected.contains(id),
            ..self.first[*id].clone()
        });
        each.collect()
    }

    /// Keeps only the first `count` selected library terms.
    pub fn keep_first(&mut self, count: usize) {
        if count >= self.selected.len() {
            return;
        }
        self.selected.truncate(count);
        self.fitted.truncate(count);
        self.squares = self.fitted.last().map_or(self.squares, |last| last.squares);
        self.is_adequate = false;
    }

    /// Number of unknowns that library terms and candidate effects add to the model under test, over all flights.
    pub fn unknowns(&self) -> usize {
        self.selected.len() + self.effect_unknowns
    }

    /// The better of two selections: an adequate one, or else the smaller sum of squares.
    pub fn better(one: Option<Self>, other: Option<Self>) -> Option<Self> {
        let rank = |model: &Self| (!model.is_adequate, model.squares);
        match (one, other) {
            (Some(one), Some(other)) if rank(&other) < rank(&one) => Some(other),
            (one, other) => one.or(other),
        }
    }
}

/// An extended model with its fit, and the score tests at this fit.
struct Step {
    fitted: FittedTerms,
    tests: ScoreTests,
}

impl StepwiseModel {
    /// Starts without a selected term, beside the effects of `beside`; `None` without a library.
    pub fn start(
        model: &ScoreTestModel<'_>,
        search: &Search,
        beside: Option<&Hypothesis>,
    ) -> Option<Self> {
        let terms = model.terms.as_ref()?;
        let given = beside.map(|given| model.tests_given(given, &search.noise));
        let given = given.transpose().ok()?;
        let first = given.as_ref().unwrap_or(&search.at_base.tests);
        let effects = beside.map_or(&[][..], |given| given.effects.as_slice());
        let names = effects
            .iter()
            .map(|&id| identifier(&model.candidate(id).name));
        let next = next_term(first, search.at_base.thresholds.reject, &[]);
        Some(Self {
            effects: names.collect(),
            effect_unknowns: model.unknowns_of(effects),
            selected: Vec::new(),
            listed: strongest_terms(first),
            first: (first.terms.iter_enumerated())
                .map(|(id, test)| StepwiseTerm::new(terms, id, test))
                .collect(),
            fitted: Vec::new(),
            squares: beside.map_or(search.at_base.squares, |given| given.squares),
            is_adequate: false,
            has_significant_term: next.is_some(),
            next,
        })
    }

    /// [`start`](Self::start), then selects up to [`MAX_SELECTED`] terms.
    pub fn select(
        model: &ScoreTestModel<'_>,
        search: &Search,
        before: &Fit,
        beside: Option<&Hypothesis>,
    ) -> Option<Self> {
        let mut stepwise = Self::start(model, search, beside)?;
        stepwise.extend(model, search, before, MAX_SELECTED);
        Some(stepwise)
    }

    /// Selects the most significant term and fits again, up to `most` terms, while something is significant, a term
    /// decreases χ², and the rest can be expected to explain as much as an accepted hypothesis.
    pub fn extend(
        &mut self,
        model: &ScoreTestModel<'_>,
        search: &Search,
        before: &Fit,
        most: usize,
    ) {
        let reject = search.at_base.thresholds.reject;
        while let Some((term, statistic)) = self.next.filter(|_| self.selected.len() < most) {
            // The remaining terms, each as strong as the next, must be able to explain as much.
            let following = (most - self.selected.len()) as f64;
            let promised = self.squares - following * statistic;
            let accepted = search.accepted.first();
            if accepted.is_some_and(|accepted| !search.is_near(promised, accepted.squares))
                || model.context.is_out_of_time()
            {
                return;
            }
            let mut selected = self.selected.clone();
            selected.push(term);
            let before = self.fitted.last().map_or(before, |last| &last.fit);
            let step = fit_terms(model, search, before, (self, &selected));
            // A term that does not decrease the sum of squares is not selected.
            let Some(Step { fitted, tests }) = step.filter(|s| s.fitted.squares <= self.squares)
            else {
                self.next = None;
                return;
            };
            let remaining = tests.strongest_candidate();
            let is_rejected = remaining.is_some_and(|(_, test)| test.ln_p_value < reject);
            let next = next_term(&tests, reject, &selected);
            self.is_adequate = !is_rejected && next.is_none();
            self.next = next.filter(|_| !self.is_adequate);
            self.squares = fitted.squares;
            self.fitted.push(fitted);
            self.selected = selected;
            if !self.listed.contains(&term) {
                self.listed.push(term);
            }
        }
    }

    /// Sum of squares expected after the next term, by linearization.
    pub fn expected_squares(&self) -> Option<f64> {
        self.next.map(|(_, statistic)| self.squares - statistic)
    }
}

/// Fits the model with the selected terms, from `before`, and if that does not arrive, from the samples. `None` if it
/// cannot be composed or fitted, or used other flights.
fn fit_terms(
    model: &ScoreTestModel<'_>,
    search: &Search,
    before: &Fit,
    (stepwise, selected): (&StepwiseModel, &[TermId]),
) -> Option<Step> {
    let terms = model.terms.as_ref()?;
    let context = model.context;
    let options = context.options;
    let effect = |&term: &TermId| {
        let is_listed = stepwise.listed.contains(&term);
        let listed = is_listed.then(|| &stepwise.first[term]);
        let doc = evidence(options.dataset, model.flights.len(), listed);
        terms.effect(term, &doc)
    };
    let effects: Vec<EffectTree> = selected.iter().map(effect).collect();
    let extension = ExtendedModel::new(context.model, &stepwise.effects, &effects).ok()?;
    let from_before = refit(&extension.model, context.dataset, &options.fit, before).ok()?;
    let status = from_before.report.iterations.status;
    let arrived = step(model, search, extension.clone(), from_before).ok()?;
    let is_minimum = matches!(status, FitStatus::Converged | FitStatus::NoiseNotConverged);
    let has_arrived = |step: &Step| is_minimum && step.fitted.squares <= stepwise.squares;
    if arrived.as_ref().is_some_and(has_arrived) {
        return arrived;
    }
    let from_samples = fit(&extension.model, context.dataset, &options.fit).ok()?;
    let again = step(model, search, extension, from_samples).ok()?;
    let both = arrived.into_iter().chain(again);
    both.min_by(|a, b| a.fitted.squares.total_cmp(&b.fitted.squares))
}

/// Score tests at a fit of `extension`; `None` if it used other flights.
fn step(
    model: &ScoreTestModel<'_>,
    search: &Search,
    extension: ExtendedModel,
    fit: Fit,
) -> Result<Option<Step>, DiagnosisError> {
    let context = model.context;
    let encompassing = EncompassingModel::new(&extension.model, context.options.without)?;
    let (mut there, iterate) = ScoreTestModel::new(encompassing, context, &fit)?;
    if !model.has_same_flights(&there.flights) {
        return Ok(None);
    }
    for (to, from) in there.flights.iter_mut().zip(&model.flights) {
        if to.outlier.len() == from.outlier.len() {
            to.outlier.clone_from(&from.outlier);
        }
    }
    let at = LinearizationPoint {
        problem: &there.problem,
        iterate: &iterate,
        cache: &TrajectoryCache::DISABLED,
    };
    let found = there.tests_at(at, &search.noise)?;
    let fitted = FittedTerms {
        extension,
        fit,
        squares: found.squares,
    };
    Ok(Some(Step {
        fitted,
        tests: found.tests,
    }))
}

fn next_term(tests: &ScoreTests, reject: f64, selected: &[TermId]) -> Option<(TermId, f64)> {
    let (term, test) = tests.strongest_term()?;
    (test.ln_p_value < reject && !selected.contains(&term)).then_some((term, test.score_chi2))
}

/// The library terms with the largest score statistics, in descending order; at most [`MAX_REPORTED`].
fn strongest_terms(tests: &ScoreTests) -> Vec<TermId> {
    let each = tests.terms.iter_enumerated();
    let mut order: Vec<(TermId, &ScoreTest)> = each
        .filter(|(_, test)| test.degrees_of_freedom > 0)
        .collect();
    sort_by_number(&mut order, |term| -term.1.score_chi2);
    order.truncate(MAX_REPORTED);
    order.into_iter().map(|(id, _)| id).collect()
}

impl StepwiseTerm {
    fn new(terms: &LibraryTerms, term: TermId, test: &ScoreTest) -> Self {
        let estimate = test.one_step_estimates.first();
        Self {
            name: terms.name(term),
            site: terms.site(term).to_owned(),
            formula: terms.formula(term),
            score_chi2: test.score_chi2,
            value: estimate.map_or(0.0, |estimate| estimate.value),
            std_error: estimate.map_or(0.0, |estimate| estimate.std_error),
            selected: false,
        }
    }
}

/// Doc comment of a created effect: dataset, number of flights, statistic and estimate.
fn evidence(dataset: &str, flights: usize, term: Option<&StepwiseTerm>) -> String {
    let test = term.map_or_else(String::new, |term| {
        format!(
            ": score \u{3c7}\u{b2}(1) = {:.0}, one-step estimate {} \u{b1} {}",
            term.score_chi2,
            significant(term.value, 3),
            significant(term.std_error, 3)
        )
    });
    format!("Found in {flights} flights of {dataset}, which no candidate effect explains{test}.")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::selection::Weights;
    use crate::test_support::fixture;

    #[test]
    fn every_library_term_can_be_written_into_its_model() {
        for (name, count) in [("disc", 132), ("ball", 40)] {
            let model = model_spec::load::load(name, &[]).unwrap();
            let all = EncompassingModel::new(&model, &[]).unwrap();
            let layout = codegen::Layout::new(&all.model);
            let terms = LibraryTerms::new(all.library.unwrap(), &layout).unwrap();
            assert_eq!(terms.terms.len(), count);
            for term in terms.terms.indices() {
                let written = [terms.effect(term, "Found.")];
                let extension = ExtendedModel::new(&model, &[], &written);
                let extension = extension.unwrap_or_else(|e| panic!("{}: {e}", terms.name(term)));
                assert_eq!(extension.effects, [identifier(&terms.name(term))]);
                let text = extension.text("Extended.");
                let again = model_spec::load::from_text("extended", &text, &[]).unwrap();
                assert_eq!(again.coefficients.len(), model.coefficients.len() + 1);
            }
        }
    }

    #[test]
    fn the_comment_of_an_effect_ends_where_no_statistic_is_known() {
        let comment = evidence("made", 6, None);
        assert_eq!(
            comment,
            "Found in 6 flights of made, which no candidate effect explains."
        );
    }

    #[test]
    fn the_strongest_terms_come_first_and_only_a_significant_one_is_next() {
        let fixture = fixture();
        let model = &fixture.model;
        let at = LinearizationPoint {
            problem: &model.problem,
            iterate: &fixture.iterate,
            cache: &TrajectoryCache::DISABLED,
        };
        let blocks = model
            .normal_equations_with_terms(at, fixture.fit.noise())
            .unwrap();
        let tests = ScoreTests::new(model, &blocks, &[], &fixture.iterate.global).unwrap();
        let reported = strongest_terms(&tests);
        assert_eq!(reported.len(), MAX_REPORTED);
        let score_chi2 = |id: TermId| tests.terms[id].score_chi2;
        assert!(reported.is_sorted_by(|a, b| score_chi2(*a) >= score_chi2(*b)));
        let (next, statistic) = next_term(&tests, -20.0, &[]).unwrap();
        assert_eq!(statistic, score_chi2(reported[0]));
        assert_eq!(next, reported[0]);
        assert_eq!(next_term(&tests, -20.0, &[next]), None);
        assert_eq!(next_term(&tests, -1e9, &[]), None);
    }

    #[test]
    fn an_adequate_selection_is_better_and_then_one_that_fits_better() {
        let mut fixture = fixture();
        let weights = Weights::EstimatedFrom(fixture.fit.noise());
        let search = Search::new(&mut fixture.model, &fixture.iterate, weights).unwrap();
        let selection = |is_adequate: bool, squares: f64| {
            let start = StepwiseModel::start(&fixture.model, &search, None);
            start.map(|start| StepwiseModel {
                is_adequate,
                squares,
                ..start
            })
        };
        let better = |one, other| StepwiseModel::better(one, other).map(|own| own.squares);
        for (best, worse) in [((true, 3.0), (false, 1.0)), ((false, 1.0), (false, 2.0))] {
            let make = |(is_adequate, squares)| selection(is_adequate, squares);
            assert_eq!(better(make(best), make(worse)), Some(best.1));
            assert_eq!(better(make(worse), make(best)), Some(best.1));
            assert_eq!(better(None, make(worse)), Some(worse.1));
        }
    }
}
