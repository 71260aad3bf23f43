//! State of a diagnosis: explanations that are found, validated and reported.

use identify::{Fit, Iterate, leading_noise};

use crate::base_fit::{BaseFit, Clock};
use crate::context::{Context, ScoreTestModel};
use crate::error::DiagnosisError;
use crate::noise::random_walk_loads;
use crate::offer::measure;
use crate::optimal_design::proposed_throw;
use crate::report::{self, Consensus, Report};
use crate::selection::{
    FittedTerms, Search, StepwiseModel, Weights, are_alternative, select_by_bic,
};
use crate::validation::ChosenExtension;
use crate::validation::predictive_terms;
use flight::parallel::join;
use identify::LackOfFit;

use super::{Diagnosis, Discordant};

/// A hypothesis of one effect that adds at most this number of unknowns is accepted without comparison by BIC.
pub(super) const FREE_UNKNOWNS: usize = 6;

/// State of a diagnosis whose explanations are found, but not validated.
pub(super) struct Analysis<'a> {
    pub(super) clock: Clock,
    pub(super) before: Fit,
    /// Lack-of-fit test of the model under test; `None` if the residuals are too few.
    pub(super) residuals: Option<LackOfFit>,
    pub(super) model: ScoreTestModel<'a>,
    /// Parameter values and initial states of the fit of the model under test, as unknowns of the score-test model.
    pub(super) base: Iterate,
    pub(super) search: Search,
    pub(super) stepwise: Option<StepwiseModel>,
    pub(super) consensus: Option<Consensus>,
    pub(super) discordant: Option<Discordant>,
    /// Whether the accepted hypothesis is not adequate, only the nearest.
    pub(super) is_nearest_only: bool,
    pub(super) notes: Vec<String>,
}

/// Searches for missing effects. Flights that the tests cannot use are removed from the model and named in `set_aside`.
pub(super) fn search_testable(
    model: &mut ScoreTestModel<'_>,
    base: &mut Iterate,
    before: &Fit,
    set_aside: &mut Vec<String>,
) -> Result<Search, DiagnosisError> {
    loop {
        let found = Search::new(model, base, Weights::EstimatedFrom(before.noise()));
        let file = match &found {
            Err(error) if model.flights.len() > 1 => error.flight().map(str::to_owned),
            _ => None,
        };
        match file {
            Some(file) if model.set_aside(&file, base) => set_aside.push(file),
            _ => return found,
        }
    }
}

impl<'a> Analysis<'a> {
    /// Tests all candidates at the fit of the model under test, and searches for explanations.
    pub(super) fn new(context: Context<'a>, base: BaseFit) -> Result<Self, DiagnosisError> {
        let options = context.options;
        let BaseFit {
            clock,
            fit: mut before,
            encompassing,
            is_despite_faults,
        } = base;
        let conflicting = encompassing.conflicting.join(", ");
        let (mut model, mut base) = ScoreTestModel::new(encompassing, context, &before)?;
        let threads = options.fit.threads();
        let mut set_aside = Vec::new();
        let (search, residuals) = join(
            threads,
            || search_testable(&mut model, &mut base, &before, &mut set_aside),
            || LackOfFit::of_fit(&before, threads),
        );
        let (mut search, residuals) = (search?, residuals.ok().flatten());
        before.report.lack_of_fit.clone_from(&residuals);
        let unexplained = residuals
            .as_ref()
            .filter(|residuals| residuals.fails(options.alpha_detect));
        if let Some(residuals) = unexplained
            && !search.is_significant()
        {
            // Misfit inflates the noise too much for the tests; they are repeated with the noise floor.
            search = Search::new(&mut model, &base, Weights::Known(&residuals.noise))?;
        }
        let mut analysis = Self {
            clock,
            before,
            residuals,
            model,
            base,
            search,
            stepwise: None,
            consensus: None,
            discordant: None,
            is_nearest_only: false,
            notes: context.dataset.notes.clone(),
        };
        if is_despite_faults {
            analysis.notes.push(
                "every flight has a fault of the data; they are used all the same, as an effect may explain it"
                    .to_owned(),
            );
        }
        if !conflicting.is_empty() {
            analysis.notes.push(format!(
                "not tested, as they conflict with other candidates: {conflicting}; --with adds one to the model"
            ));
        }
        if !set_aside.is_empty() {
            let files = set_aside.join(", ");
            analysis.notes.push(format!(
                "left out of the tests of effects, as the effects cannot be told from the initial state: {files}"
            ));
        }
        if analysis.search.is_significant() && analysis.search.accepted.is_empty() {
            analysis.search_beyond_single_effects()?;
        } else {
            analysis.select_by_bic(FREE_UNKNOWNS);
        }
        if analysis.consensus.is_none() && !analysis.is_nearest_only {
            analysis.search.add_undecided(&analysis.model);
        }
        Ok(analysis)
    }

    pub(super) fn select_by_bic(&mut self, free: usize) {
        let accepted = std::mem::take(&mut self.search.accepted);
        let stepwise = self.stepwise.as_ref();
        self.search.accepted = select_by_bic(&self.model, accepted, stepwise, free);
    }

    /// The model with library terms if it is an alternative to the accepted hypotheses by BIC.
    pub(super) fn alternative_terms(&self) -> Option<&FittedTerms> {
        let hypotheses = &self.search.accepted;
        let terms = self.stepwise.as_ref().filter(|_| !hypotheses.is_empty());
        let terms = terms.filter(|terms| are_alternative(&self.model, hypotheses, terms))?;
        terms.fitted.last()
    }

    /// Standard deviation of the noise of the leading kind of sensor, in its unit.
    fn noise(&self) -> f64 {
        let fitted = (&self.before, self.residuals.as_ref());
        leading_noise(&report::noise(fitted, &self.model, &self.search)).sigma
    }

    pub(super) fn has_adequate_terms(&self) -> bool {
        let stepwise = self.stepwise.as_ref();
        stepwise.is_some_and(|stepwise| stepwise.is_adequate)
    }

    /// Validates the explanations, extends the model by the best one, and completes the report.
    pub(super) fn finish(mut self) -> Result<Diagnosis, DiagnosisError> {
        let (mut validated, refused) = self.validate_overflexible();
        self.notes.extend(refused);
        self.clock.record("search");
        let context = self.model.context;
        // Whether what was significant, library terms alone, has no explanation that is significant or predicts better.
        let mut is_chance = false;
        let (mut report, measured) = loop {
            let fitted = (&self.before, self.residuals.as_ref());
            let is_error = self.search.is_significant() && !is_chance;
            let mut report = report::build_report(fitted, &self.model, (&self.search, is_error));
            report.consensus.clone_from(&self.consensus);
            if let Some(terms) = self.alternative_terms() {
                report::add_alternative(&mut report, terms, &self.search);
            }
            let Some(chosen) = self.choose(validated.take(), &mut report)? else {
                break (report, None);
            };
            let names = report::display_names(&chosen.extension.effects);
            let is_candidate = !self.search.accepted.is_empty();
            let is_weak = is_candidate && self.is_weak();
            let applies = report.consensus.is_some();
            let noise = report.leading_noise().sigma;
            let measured = measure(context, &self.before, chosen, (applies, noise));
            match measured.ok() {
                Some(measured) if !is_candidate || measured.objection(is_weak).is_none() => {
                    break (report, Some(measured));
                }
                None if !is_candidate => break (report, None),
                found => {
                    let why = found.and_then(|measured| measured.objection(is_weak));
                    let why = why.unwrap_or("the model with it cannot be fitted");
                    self.notes.push(format!("{names} is no explanation: {why}"));
                    self.search.accepted.remove(0);
                    self.search.keep_significant(&self.model);
                    let is_last = self.search.accepted.is_empty() && self.stepwise.is_none();
                    is_chance = is_weak && is_last;
                }
            }
        };
        report.notes.append(&mut self.notes);
        if is_chance {
            report
                .notes
                .extend(report::term_alone(&self.model, &self.search));
        }
        let after =
            measured.and_then(|measured| measured.add_to(&mut report, &self.before, context));
        if self.is_nearest_only && !self.search.accepted.is_empty() {
            report::withdraw_inadequate(&mut report);
        }
        report::describe_departures(&mut report);
        report::withdraw_stand_ins(&mut report);
        report::withdraw_by_excess(&mut report, self.before.report.excess.as_ref());
        let extended = after.as_ref().map(|(_, fit)| &fit.report);
        report::withdraw_by_doubts(&mut report, &self.before.report, extended);
        let is_out_of_time = context.is_out_of_time();
        let is_undecided = self.search.accepted.is_empty() || self.is_nearest_only;
        if is_out_of_time || (self.model.is_exhausted() && is_undecided) {
            report::note_incomplete(&mut report, &self.before.report, is_out_of_time);
        }
        if !is_out_of_time {
            report.proposed_throw = proposed_throw(&self.model, &self.search);
        }
        report.summary = report::summary(&report);
        self.clock.record("total");
        report.seconds = self.clock.seconds;
        let mut diagnosis = Diagnosis {
            report,
            before: self.before,
            after,
        };
        diagnosis.set_verified(None);
        context.options.fit.check_cancelled()?;
        Ok(diagnosis)
    }

    /// Whether neither a candidate nor an adequate hypothesis is significant itself: they only take the significance of a
    /// library term.
    fn is_weak(&self) -> bool {
        let search = &self.search;
        let mut accepted = search.accepted.iter();
        let is_significant = |own| search.is_significant_itself(&self.model, own);
        let is_adequate = self.consensus.is_none() && !self.is_nearest_only;
        is_adequate && !search.has_significant_candidate() && !accepted.any(is_significant)
    }

    /// Validates the best explanation by its out-of-sample gain if it is overflexible. Returns it if it improves
    /// predictions; otherwise drops all overflexible ones and returns the reason.
    fn validate_overflexible(&mut self) -> (Option<ChosenExtension>, Option<String>) {
        let model = &self.model;
        let best = self.search.accepted.first();
        let Some(best) = best.filter(|best| best.is_overflexible(model)) else {
            return (None, None);
        };
        let noise = self.noise();
        if model.context.is_out_of_time() {
            return (None, None);
        }
        let validated = ChosenExtension::validated(model, best, &self.before, noise);
        let refused = match validated {
            Ok(validated) if validated.improves_predictions() => return (Some(validated), None),
            Ok(validated) => Some(report::refused(&validated)),
            Err(_) => None,
        };
        self.search.accepted.retain(|h| !h.is_overflexible(model));
        if self.search.accepted.is_empty() && self.stepwise.is_none() {
            self.stepwise = StepwiseModel::select(model, &self.search, &self.before, None);
        }
        (None, refused)
    }

    /// Chooses the effects by which the model is extended: those of the best explanation, or else the selected library
    /// terms, which are added to the report.
    fn choose(
        &mut self,
        validated: Option<ChosenExtension>,
        report: &mut Report,
    ) -> Result<Option<ChosenExtension>, DiagnosisError> {
        let context = self.model.context;
        if validated.is_some() {
            return Ok(validated);
        }
        if let Some(best) = self.search.accepted.first() {
            if context.is_out_of_time() {
                return Ok(None);
            }
            let extension = best.extension(&self.model)?;
            return Ok(Some(ChosenExtension::unfitted(extension)));
        }
        let Some(mut stepwise) = self.stepwise.take() else {
            return Ok(None);
        };
        let noise = self.noise();
        let (model, search) = (&self.model, &self.search);
        let count = predictive_terms(context, &stepwise, noise);
        stepwise.keep_first(count);
        let histories = match context.is_out_of_time() {
            true => Vec::new(),
            false => random_walk_loads(model, &self.base, &search.noise),
        };
        let found = report::unattributed_report(model, search, &stepwise, histories);
        report.unattributed = Some(found);
        let chi2_decrease = (search.at_base.squares - stepwise.squares).max(0.0);
        Ok(stepwise.fitted.pop().map(|last| ChosenExtension {
            fit: Some(last.fit),
            chi2_decrease,
            ..ChosenExtension::unfitted(last.extension)
        }))
    }
}

#[cfg(test)]
mod tests {
    use std::time::Instant;

    use super::*;
    use crate::context::DiagnosisOptions;
    use crate::diagnosis::diagnose;
    use crate::report::Verdict;
    use crate::test_support::mystery;
    use identify::FitOptions;

    /// State of a diagnosis of four flights of `examples/mystery`, with the hypothesis that the model lacks two
    /// effects: the one with which the flights were simulated, and another one.
    fn analysis_of_two_effects(context: Context<'_>) -> Analysis<'_> {
        let mut analysis = Analysis::new(context, BaseFit::new(context).unwrap()).unwrap();
        // An accepted explanation by fewer unknowns would end the selection of terms.
        analysis.search.accepted.clear();
        let (model, search) = (&analysis.model, &analysis.search);
        let named = |name: &str| model.candidates().find(|(_, c)| c.name == name).unwrap().0;
        let mut effects = ["stall", "gravity"].map(named);
        effects.sort_unstable();
        let pair = model.fit_hypothesis(&effects, &analysis.base, &search.noise);
        let terms = StepwiseModel::select(model, search, &analysis.before, None);
        let mut terms = terms.unwrap();
        terms.keep_first(2);
        analysis.search.accepted = Vec::from_iter(pair);
        analysis.stepwise = Some(terms);
        analysis
    }

    #[test]
    fn terms_that_explain_as_much_as_several_effects_are_in_the_answer() {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let (dataset, options) = (mystery(4), DiagnosisOptions::default());
        let context = Context {
            model: &model,
            dataset: &dataset,
            options: &options,
        };
        let mut analysis = analysis_of_two_effects(context);
        let pair = analysis.search.accepted[0].squares;
        let terms = analysis.stepwise.as_mut().unwrap();
        (terms.is_adequate, terms.squares) = (true, pair + 100.0);
        assert!(analysis.alternative_terms().is_none());
        analysis.stepwise.as_mut().unwrap().squares = pair;
        assert!(analysis.alternative_terms().is_some());

        let diagnosis = analysis.finish().unwrap();
        let report = diagnosis.report;
        assert_eq!(report.verdict, Verdict::Ambiguous);
        let [first, second] = &report.explanations[..] else {
            panic!("two explanations: {}", report.summary);
        };
        let names = |explanation: &report::Explanation| {
            explanation.effects.iter().map(|e| e.name.clone()).collect()
        };
        let names: [Vec<String>; 2] = [names(first), names(second)];
        assert!(names[0].contains(&"stall".to_owned()), "{names:?}");
        assert!(
            names[1].iter().all(|name| name.contains("-by-")),
            "{names:?}"
        );
        assert!(second.chi2_decrease > 0.0);
    }

    /// Report of flights of the right model, if a library term alone is significant, and the candidate that explains least
    /// is adequate; with library terms selected, or without.
    fn report_of_weak_candidate(with_terms: bool) -> Report {
        let model = model_spec::load::load("disc", &["stall"]).unwrap();
        let (dataset, options) = (mystery(4), DiagnosisOptions::default());
        let context = Context {
            model: &model,
            dataset: &dataset,
            options: &options,
        };
        let mut analysis = Analysis::new(context, BaseFit::new(context).unwrap()).unwrap();
        let (model, search) = (&analysis.model, &analysis.search);
        let tests = &search.at_base.tests;
        let (_, term) = tests.strongest_term().unwrap();
        let detect = term.ln_p_value + 0.01;
        let of_candidate = tests.strongest_candidate().unwrap().1.ln_p_value;
        let each = tests.candidates.iter_enumerated();
        let each = each.filter_map(|(id, test)| Some((id, test.as_ref()?)));
        let weakest = each
            .filter(|(_, test)| test.degrees_of_freedom > 0)
            .max_by(|a, b| a.1.ln_p_value.total_cmp(&b.1.ln_p_value));
        let (weakest, _) = weakest.unwrap();
        let weakest = model.fit_hypothesis(&[weakest], &analysis.base, &search.noise);
        if with_terms {
            let terms = StepwiseModel::select(model, search, &analysis.before, None);
            analysis.stepwise = terms;
        }
        analysis.search.accepted = Vec::from_iter(weakest);
        analysis.search.at_base.thresholds.detect = detect;
        assert!(analysis.search.is_significant() && analysis.is_weak());
        // Not where another candidate is significant.
        analysis.search.at_base.thresholds.detect = of_candidate + 0.01;
        assert!(!analysis.is_weak());
        analysis.search.at_base.thresholds.detect = detect;
        analysis.finish().unwrap().report
    }

    #[test]
    fn where_a_library_term_alone_is_significant_predictions_decide() {
        let report = report_of_weak_candidate(false);
        assert_eq!(report.verdict, Verdict::Adequate, "{}", report.summary);
        assert!(report.explanations.is_empty());
        let notes = report.notes.join(" ");
        assert!(notes.contains("is not significant itself"), "{notes}");
        assert!(notes.contains("no effect that explains it is"), "{notes}");
    }

    #[test]
    fn terms_that_were_selected_remain_the_answer_where_no_candidate_does() {
        let report = report_of_weak_candidate(true);
        assert_eq!(report.verdict, Verdict::Unattributed, "{}", report.summary);
        assert!(report.unattributed.is_some());
    }

    #[test]
    fn past_the_deadline_there_is_an_answer_that_says_so() {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let options = DiagnosisOptions {
            fit: FitOptions {
                deadline: Some(Instant::now()),
                ..FitOptions::default()
            },
            ..DiagnosisOptions::default()
        };
        let found = diagnose(&model, &mystery(4), &options).unwrap();
        assert!(!found.report.complete && found.after.is_none());
        let notes = found.report.notes.join(" ");
        assert!(notes.contains("the time given was over"), "{notes}");
    }

    #[test]
    fn no_effect_makes_up_for_a_mass_in_grams() {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let mut dataset = mystery(3);
        *dataset.parameters.get_mut("m").unwrap() *= 1e3;
        let found = diagnose(&model, &dataset, &DiagnosisOptions::default()).unwrap();
        let report = found.report;
        assert!(report.explanations.is_empty() && !report.reliable);
        let notes = report.notes.join(" ");
        assert!(notes.contains("a constant seems to be stated"), "{notes}");
        let cautions = report.cautions.join(" ");
        assert!(cautions.contains("m is stated as"), "{cautions}");
    }
}
