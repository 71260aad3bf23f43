//! Scores a diagnosis against the effects added to the simulated flights.

use diagnose::{Report, Verdict};

use super::case::Case;
use super::outcome::{Discordant, Outcome};
use crate::oracle_flights::file_name;
use crate::seeded::{self, InputErrors};

/// Standard normal quantile of 0.9. An effect whose expected z exceeds the detection threshold by this amount is
/// detected with probability (power) 0.9.
const POWER_QUANTILE: f64 = 1.281_551_565_544_6;

/// Names of the effects of each hypothesis in a report, sorted; words are joined by underscores.
pub(super) fn hypotheses(report: &Report) -> Vec<Vec<String>> {
    let each = report.explanations.iter().map(|hypothesis| {
        let names = hypothesis.effects.iter();
        let mut names: Vec<String> = names.map(|effect| underscored(&effect.name)).collect();
        names.sort();
        names
    });
    each.collect()
}

/// Copies verdict and hypotheses from a diagnosis report to `outcome`, and scores them against the effects added to the
/// simulated flights.
pub(super) fn score(outcome: &mut Outcome, report: &Report) {
    outcome.verdict = Some(report.verdict);
    outcome.seconds = report.seconds.get("total").copied().unwrap_or(f64::NAN);
    outcome.hypotheses = hypotheses(report);
    let remaining = report.explanations.iter().map(|hypothesis| {
        let remaining = hypothesis.strongest_remaining.as_ref()?;
        Some((underscored(&remaining.name), remaining.p_value))
    });
    outcome.strongest_remaining = remaining.collect();
    let terms = report
        .unattributed
        .iter()
        .flat_map(|outside| &outside.terms);
    let taken: Vec<_> = terms.filter(|term| term.selected).collect();
    outcome.terms = taken.len();
    outcome.sites = taken.iter().map(|term| term.site.clone()).collect();
    outcome.sites.dedup();
    let is_single = outcome.hypotheses.len() == 1
        && matches!(report.verdict, Verdict::Identified | Verdict::Negligible);
    if !outcome.case.seeded.unlisted.is_empty() {
        score_unlisted(outcome, report, is_single);
    } else if let Some(errors) = outcome.case.input_errors {
        score_input_errors(outcome, report, errors, is_single);
    } else {
        score_listed(outcome, report, is_single);
    }
}

/// Scores a run with an effect outside the built-in effects catalogue. The right verdict is `Unattributed`. A single
/// hypothesis (`is_single`) is wrong unless it names the nearly equivalent effect of the catalogue.
fn score_unlisted(outcome: &mut Outcome, report: &Report, is_single: bool) {
    // An effect of the catalogue may be so similar that it is an equally right answer.
    let mut seeded = outcome.case.seeded.unlisted.iter();
    let near = seeded.find_map(|(name, _)| seeded::unlisted(name)?.near);
    let is_near = |hypothesis: &Vec<String>| near.is_some_and(|near| *hypothesis == [near]);
    outcome.in_set =
        report.verdict == Verdict::Unattributed || outcome.hypotheses.iter().any(is_near);
    outcome.uniquely_wrong = is_single && !is_near(&outcome.hypotheses[0]);
}

fn score_input_errors(
    outcome: &mut Outcome,
    report: &Report,
    errors: InputErrors,
    is_single: bool,
) {
    let truth = outcome.case.truth();
    outcome.discordant = discordant(&outcome.case, errors, report);
    outcome.in_set = outcome.hypotheses.contains(&truth);
    // If every spin is exchanged with another flight's, no hypothesis is right.
    let is_wrong = || outcome.hypotheses[0] != truth || errors.exchanged == 1.0;
    outcome.uniquely_wrong = is_single && is_wrong();
}

fn score_listed(outcome: &mut Outcome, report: &Report, is_single: bool) {
    let truth = outcome.case.truth();
    let mut detectable: Vec<String> = Vec::new();
    for (name, values) in outcome.case.seeded.listed.clone() {
        let mut hidden = report.not_identifiable.iter();
        let not_identifiable = hidden.any(|effect| underscored(&effect.name) == name);
        let detectability = match not_identifiable {
            true => Some(0.0),
            false => detectability(report, &name, &values),
        };
        if detectability.is_none_or(|ratio| ratio >= 1.0) {
            detectable.push(name.clone());
        }
        outcome.not_identifiable |= not_identifiable;
        outcome.detectability = least(outcome.detectability, detectability);
        outcome.z = least(outcome.z, z(report, &name));
    }
    detectable.sort();
    outcome.in_set = !truth.is_empty() && outcome.hypotheses.contains(&truth);
    // If one effect of a pair is below the minimum detectable size, the other effect alone is right.
    let is_right = |hypothesis: &Vec<String>| {
        *hypothesis == truth || (!detectable.is_empty() && *hypothesis == detectable)
    };
    outcome.uniquely_wrong = is_single && !is_right(&outcome.hypotheses[0]);
}

/// Counts the flights that a report lists as discordant (contradicting the effect found in most flights), and how many
/// of these had their spins in the dataset exchanged between flights as an introduced error.
fn discordant(case: &Case, errors: InputErrors, report: &Report) -> Discordant {
    let exchanged = errors.exchanged_flights(case.flights, case.seed);
    let exchanged: Vec<String> = exchanged.into_iter().map(file_name).collect();
    let files = report
        .consensus
        .iter()
        .flat_map(|consensus| &consensus.discordant);
    Discordant {
        listed: files.clone().count(),
        exchanged: files.filter(|file| exchanged.contains(file)).count(),
    }
}

/// Size of an effect in the simulated flights / minimum detectable size; the maximum over the effect's coefficients.
/// For an effect without coefficients, whose states vary from flight to flight: z of its score test / the z at which
/// the test has power 0.9. `None` if the report lacks these values.
fn detectability(report: &Report, name: &str, values: &[f64]) -> Option<f64> {
    let effect = crate::seeded::law::by_name(name)?;
    let coefficients = effect.coefficients.iter().zip(values);
    let ratios = coefficients.filter_map(|(coefficient, value)| {
        let mut detectable = report.minimum_detectable_effects.iter();
        let smallest =
            detectable.find(|d| underscored(&d.name) == name && d.coefficient == *coefficient)?;
        Some(value.abs() / smallest.value)
    });
    let greatest = ratios.fold(None, |greatest: Option<f64>, ratio| {
        Some(greatest.map_or(ratio, |greatest| greatest.max(ratio)))
    });
    if greatest.is_some() || effect.states.is_empty() {
        return greatest;
    }
    Some(z(report, name)? / (report.threshold.z + POWER_QUANTILE))
}

/// z-equivalent (two-sided standard normal quantile of the p-value) of the score test of the candidate effect `name`;
/// `None` if the report has no such candidate.
fn z(report: &Report, name: &str) -> Option<f64> {
    let mut candidates = report.tests.iter();
    let candidate = candidates.find(|candidate| underscored(&candidate.name) == name)?;
    Some(candidate.z)
}

/// Replaces hyphens by underscores: reports write the names of effects with hyphens, models with underscores.
fn underscored(name: &str) -> String {
    name.replace('-', "_")
}

fn least(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.min(b)),
        (a, b) => a.or(b),
    }
}
