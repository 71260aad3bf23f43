//! Builds the report of a diagnosis from the results of its stages.

use std::collections::BTreeMap;

use identify::{Fit, FlightReport, MARKER, NoiseModel, NoiseReport};
use model_spec::sort_by_number;

use super::narrative;
use super::types::{
    CandidateTest, Coefficient, Estimate, Explanation, ExplanationEffect, FlightGain, LoadChannel,
    RemainingEffect, Report, ScoreCorrelations, Threshold, Unattributed, Verdict,
};
use crate::context::{Candidate, CandidateParameter, ColumnId, ScoreTestModel, display_name};
use crate::noise::LoadHistory;
use crate::power::detectable;
use crate::score_test::{MIN_TOLERANCE, ScoreTest, ln_p_to_z};
use crate::selection::{Hypothesis, INFLATED, Search, StepwiseModel};
use identify::LackOfFit;

/// Builds the report of a search, and of whether it shows a model error; what concerns the extended model is set later.
pub(crate) fn build_report(
    (before, residuals): (&Fit, Option<&LackOfFit>),
    model: &ScoreTestModel<'_>,
    (search, is_error): (&Search, bool),
) -> Report {
    let context = model.context;
    let explanations = search.accepted.iter();
    let mut explanations: Vec<Explanation> = explanations
        .map(|h| explanation(model, search, h))
        .collect();
    if let Some(residuals) = residuals {
        explanations
            .iter_mut()
            .for_each(|explanation| add_share(explanation, residuals));
    }
    let alpha = context.options.alpha_detect;
    let is_noise = !residuals.is_some_and(|residuals| residuals.fails(alpha));
    let detect = search.at_base.thresholds.detect;
    let (not_identifiable, minimum_detectable_effects) =
        detectable(model, &search.at_base.tests, detect);
    let mut report = Report {
        schema: "hyzer.diagnosis/2".into(),
        dataset: context.options.dataset.to_owned(),
        model: context.model.name.clone(),
        effects: context
            .model
            .effects
            .iter()
            .map(|e| display_name(&e.name))
            .collect(),
        verdict: verdict(is_error || !is_noise, &explanations),
        explanations,
        noise: noise((before, residuals), model, search),
        coefficients: coefficients(before, None),
        not_identifiable,
        minimum_detectable_effects,
        tests: candidate_tests(model, search),
        threshold: Threshold {
            alpha: context.options.alpha_detect,
            ln_p_value: detect,
            z: ln_p_to_z(detect),
        },
        score_correlations: score_correlations(model, search),
        data_faults: before.report.data_faults.clone(),
        flights: before.report.flights.iter().map(flight_before).collect(),
        lack_of_fit: residuals.cloned(),
        converged: true,
        complete: true,
        ..Report::default()
    };
    note_convergence(&mut report, before, "the model");
    report
}

pub(super) fn verdict(is_significant: bool, explanations: &[Explanation]) -> Verdict {
    let is_negligible =
        |explanation: &Explanation| explanation.effects.iter().all(|effect| effect.negligible);
    match explanations {
        _ if !is_significant => Verdict::Adequate,
        [] => Verdict::Unattributed,
        explanations if explanations.iter().all(is_negligible) => Verdict::Negligible,
        [_] => Verdict::Identified,
        _ => Verdict::Ambiguous,
    }
}

/// Sets the fraction of the excess χ² that `explanation` accounts for, and the rms residual that it leaves.
pub(super) fn add_share(explanation: &mut Explanation, residuals: &LackOfFit) {
    let share = explanation.chi2_decrease / residuals.excess_chi2.max(f64::MIN_POSITIVE);
    explanation.explained_fraction = share.clamp(0.0, 1.0);
    explanation.remaining_rms_m =
        residuals.beyond_noise_m * (1.0 - explanation.explained_fraction).sqrt();
}

/// Noise as estimated by the search, or the noise floor of the residuals if the candidates leave much more; the rest as in
/// the fit of the model under test.
pub(crate) fn noise(
    (before, residuals): (&Fit, Option<&LackOfFit>),
    model: &ScoreTestModel<'_>,
    search: &Search,
) -> BTreeMap<String, NoiseReport> {
    let flights = model.flights.iter();
    let points: usize = flights
        .clone()
        .map(|f| f.measured.iter().flatten().count())
        .sum();
    let outliers: usize = flights
        .map(|f| f.outlier.iter().filter(|o| **o).count())
        .sum();
    let mut noise = before.report.noise.clone();
    let floor = residuals.map(|own| &own.noise);
    let is_inflated = |floor: &&NoiseModel| search.noise.overall() > INFLATED * floor.overall();
    let found = floor.filter(is_inflated).unwrap_or(&search.noise);
    for (kind, [sigma, ar1]) in model.problem.noise_by_kind(found) {
        if let Some(own) = noise.get_mut(kind) {
            own.sigma = sigma;
            own.lag1_autocorrelation = ar1;
        }
    }
    if let Some(positions) = noise.get_mut(MARKER) {
        positions.outlier_fraction = outliers as f64 / points.max(1) as f64;
    }
    noise
}

fn flight_before(flight: &FlightReport) -> FlightGain {
    FlightGain {
        file: flight.file.clone(),
        role: flight.role,
        outcome: flight.outcome.clone(),
        rms_before_m: flight.position_rms(),
        rms_after_m: None,
    }
}

pub(super) fn coefficients(fit: &Fit, before: Option<&Fit>) -> BTreeMap<String, Coefficient> {
    let each = fit.report.coefficients.iter().map(|(name, c)| {
        let earlier = before.and_then(|before| before.report.coefficients.get(name));
        let coefficient = Coefficient {
            value: c.value,
            std_error: c.std_error,
            unit: c.unit.clone(),
            before: earlier.map(|earlier| earlier.value),
        };
        (name.clone(), coefficient)
    });
    each.collect()
}

fn candidate_tests(model: &ScoreTestModel<'_>, search: &Search) -> Vec<CandidateTest> {
    let each = model.candidates().filter_map(|(id, candidate)| {
        let test = search.at_base.tests.candidates[id].as_ref()?;
        Some(CandidateTest {
            name: candidate.name.clone(),
            description: candidate.doc.clone(),
            site: candidate.site.clone(),
            score_chi2: test.score_chi2,
            degrees_of_freedom: test.degrees_of_freedom,
            ln_p_value: test.ln_p_value,
            z: ln_p_to_z(test.ln_p_value),
            significant: test.degrees_of_freedom > 0
                && test.ln_p_value < search.at_base.thresholds.detect,
            tolerance: test.tolerance,
            one_step_estimates: one_step(candidate, model.columns_of(id), test),
        })
    });
    let mut all: Vec<CandidateTest> = each.collect();
    sort_by_number(&mut all, |test| test.ln_p_value);
    all
}

fn one_step(
    candidate: &Candidate,
    columns: &[ColumnId],
    test: &ScoreTest,
) -> BTreeMap<String, Estimate> {
    let each = columns.iter().zip(&candidate.coefficients);
    let each = each.filter_map(|(column, parameter)| {
        let found = test
            .one_step_estimates
            .iter()
            .find(|found| found.column == *column)?;
        Some((
            parameter.name.clone(),
            estimate(parameter, found.value, found.std_error),
        ))
    });
    each.collect()
}

fn estimate<Id>(parameter: &CandidateParameter<Id>, value: f64, std_error: f64) -> Estimate {
    Estimate {
        value,
        std_error,
        unit: parameter.unit.clone(),
        smallest_effect_of_interest: parameter.smallest_effect_of_interest,
    }
}

fn score_correlations(model: &ScoreTestModel<'_>, search: &Search) -> ScoreCorrelations {
    let tests = &search.at_base.tests;
    let tested = tests.partition.tested.iter().enumerate();
    let shown: Vec<(usize, &str)> = tested
        .filter(|(i, _)| tests.information[(*i, *i)] > MIN_TOLERANCE)
        .filter_map(|(i, column)| Some((i, model.column_name(*column)?)))
        .collect();
    let all = tests.score_correlations();
    let row = |&(i, _): &(usize, &str)| shown.iter().map(|&(j, _)| all[(i, j)]).collect();
    ScoreCorrelations {
        names: shown.iter().map(|(_, name)| (*name).to_owned()).collect(),
        matrix: shown.iter().map(row).collect(),
    }
}

fn explanation(
    model: &ScoreTestModel<'_>,
    search: &Search,
    hypothesis: &Hypothesis,
) -> Explanation {
    let std_error = hypothesis.tests.nuisance_std_errors();
    let effects = hypothesis.effects.iter().map(|&id| {
        let candidate = model.candidate(id);
        let mut estimates = BTreeMap::new();
        let mut negligible = true;
        let mut add = |name: &str, departure: f64, estimate: Estimate| {
            let limit = estimate.smallest_effect_of_interest;
            negligible &= limit.is_some_and(|limit| departure < limit);
            estimates.insert(name.to_owned(), estimate);
        };
        for (parameter, &column) in candidate.coefficients.iter().zip(model.columns_of(id)) {
            let value = hypothesis.iterate.global[column.index()];
            let departure = (value - parameter.null_value).abs();
            add(
                &parameter.name,
                departure,
                estimate(parameter, value, std_error(column)),
            );
        }
        for state in &candidate.states {
            let locals = hypothesis.iterate.local.iter();
            let largest_misfits = locals.map(|local| local[state.id.index()] - state.null_value);
            let count = hypothesis.iterate.local.len().max(1) as f64;
            let rms = (largest_misfits.map(|d| d * d).sum::<f64>() / count).sqrt();
            add(
                &state.name,
                rms,
                estimate(state, rms, rms / (2.0 * count).sqrt()),
            );
        }
        let test = search.at_base.tests.candidates[id].as_ref();
        let first = candidate
            .coefficients
            .first()
            .zip(model.columns_of(id).first());
        let departure = first.map_or(0.0, |(parameter, column)| {
            hypothesis.iterate.global[column.index()] - parameter.null_value
        });
        ExplanationEffect {
            name: candidate.name.clone(),
            description: candidate.sentence(departure).to_owned(),
            site: candidate.site.clone(),
            variables: candidate.variables.clone(),
            estimates,
            score_chi2: test.map_or(0.0, |test| test.score_chi2),
            negligible,
        }
    });
    let mut effects: Vec<ExplanationEffect> = effects.collect();
    sort_by_number(&mut effects, |effect| -effect.score_chi2);
    let remaining = hypothesis.strongest_remaining();
    Explanation {
        effects,
        chi2_decrease: (search.at_base.squares - hypothesis.squares).max(0.0),
        strongest_remaining: remaining.map(|(id, ln_p_value)| RemainingEffect {
            name: model.candidate(id).name.clone(),
            p_value: ln_p_value.exp(),
        }),
        ..Explanation::default()
    }
}

/// Section on a lack of fit that no candidate explains; `histories` by load channel and flight.
pub(crate) fn unattributed_report(
    model: &ScoreTestModel<'_>,
    search: &Search,
    stepwise: &StepwiseModel,
    histories: Vec<Vec<LoadHistory>>,
) -> Unattributed {
    let channels = load_channels(model, search, histories);
    Unattributed {
        description: narrative::unattributed(stepwise, &channels),
        channels,
        terms: stepwise.terms(),
    }
}

fn load_channels(
    model: &ScoreTestModel<'_>,
    search: &Search,
    histories: Vec<Vec<LoadHistory>>,
) -> Vec<LoadChannel> {
    let Some(terms) = &model.terms else {
        return Vec::new();
    };
    let is_term = |column: ColumnId| column.index() >= model.global_columns();
    let all = search
        .at_base
        .tests
        .joint_statistic(is_term)
        .max(f64::MIN_POSITIVE);
    let loads = terms.sites().zip(histories);
    let channels = loads.map(|((load, site), histories)| {
        let columns = terms
            .terms
            .iter_enumerated()
            .filter(|(_, term)| term.channel == load);
        let columns: Vec<ColumnId> = columns.map(|(id, _)| model.term_column(id)).collect();
        let own = search
            .at_base
            .tests
            .joint_statistic(|column| columns.contains(&column));
        LoadChannel {
            site: site.to_owned(),
            explained_fraction: (own / all).clamp(0.0, 1.0),
            histories,
        }
    });
    channels.collect()
}

/// Adds a note and marks the report as not converged if `fit` did not converge; `what` names the fitted model.
pub(crate) fn note_convergence(report: &mut Report, fit: &Fit, what: &str) {
    let iterations = &fit.report.iterations;
    if !iterations.converged {
        report.converged = false;
        report.notes.push(format!(
            "the fit of {what} did not converge in {} steps: its estimates are not reliable",
            iterations.steps
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use identify::FlightOutcome;

    use crate::context::{Context, DiagnosisOptions, EncompassingModel};
    use crate::selection::Weights;
    use crate::test_support::mystery;

    /// Report of a fit that did not converge and in which the first flight has no samples. The two values of the array
    /// state whether a model error is detected: first with the default detection threshold, then with the threshold −∞. The
    /// last value is the noise, m, that is reported if misfit inflates that of the search a hundredfold.
    fn report_of_faulty_fit() -> (Report, [bool; 2], f64) {
        let mut dataset = mystery(4);
        dataset.flights[0]
            .positions
            .iter_mut()
            .for_each(|row| row.fill(None));
        let model = model_spec::load::load("disc", &[]).unwrap();
        let options = DiagnosisOptions::default();
        let context = Context {
            model: &model,
            dataset: &dataset,
            options: &options,
        };
        let mut fit = identify::fit(&model, &dataset, &options.fit).unwrap();
        fit.report.iterations.converged = false;
        let encompassing = EncompassingModel::new(&model, &[]).unwrap();
        let (mut tests, base) = ScoreTestModel::new(encompassing, context, &fit).unwrap();
        let mut search =
            Search::new(&mut tests, &base, Weights::EstimatedFrom(fit.noise())).unwrap();
        let before = search.is_significant();
        search.at_base.thresholds.detect = f64::NEG_INFINITY;
        let after = search.is_significant();
        let report = build_report((&fit, None), &tests, (&search, after));
        for sigma in &mut search.noise.sigma {
            *sigma *= 100.0;
        }
        let residuals = LackOfFit::of_fit(&fit, 1).unwrap();
        let inflated = build_report((&fit, residuals.as_ref()), &tests, (&search, after));
        (report, [before, after], inflated.leading_noise().sigma)
    }

    #[test]
    fn excluded_flights_unconverged_fits_and_changed_thresholds_are_reported() {
        let (report, significant, noise) = report_of_faulty_fit();
        // The dataset was made with noise of 1.5 mm.
        assert!((noise / 0.0015 - 1.0).abs() < 0.1, "{noise}");
        // An excluded flight has no residuals.
        let [excluded, fitted, ..] = &report.flights[..] else {
            panic!("four flights");
        };
        assert!(matches!(excluded.outcome, FlightOutcome::Excluded { .. }));
        assert!(excluded.rms_before_m.is_none());
        assert_eq!(fitted.outcome, FlightOutcome::Fitted);
        assert!(fitted.rms_before_m.is_some_and(|rms| rms > 0.0));
        assert!(!report.converged);
        assert!(
            report
                .notes
                .iter()
                .any(|note| note.contains("did not converge"))
        );
        // The verdict and the candidates' significance follow the same threshold.
        assert_eq!(significant, [true, false]);
        assert_eq!(report.verdict, Verdict::Adequate);
        assert!(report.tests.iter().all(|candidate| !candidate.significant));
    }
}
