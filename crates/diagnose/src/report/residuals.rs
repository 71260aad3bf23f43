//! The lack-of-fit test in the report, what withdraws a verdict, and whether a diagnosis is reliable.

use identify::numbers::{percent, quantity, significant};
use identify::{
    Fit, FitReport, LackOfFit, SmoothMisfit, convergence_caution, exclusion_caution, input_noise,
};

use super::types::{Explanation, Report, Unattributed, Verdict, Verified};
use crate::context::display_name;
use crate::extension::ExtendedModel;

/// Maximum number of flights whose largest smooth deviation is described in the report's text on the lack of fit.
const MAX_DEPARTURES: usize = 3;

/// Fraction of the misfit that an explanation must account for if residuals remain and the flights do not agree on it.
const MIN_EXPLAINED: f64 = 0.9;

/// Number of effects on one load that together fit nearly any smooth law of it.
const EXPANSION: usize = 3;

/// Ratio of the decrease of χ² by an explanation to that without the priors that the data contradict, above which it is not
/// their stand-in.
const MORE_THAN_PRIORS: f64 = 2.0;

/// Replaces the lack-of-fit test by that of the extended model, and the shares of the explanations: what the first one
/// leaves is measured, and the others leave as much more as their χ² falls less.
pub(crate) fn add_residuals(report: &mut Report, residuals: Option<LackOfFit>) {
    if let (Some(before), Some(after)) = (&report.lack_of_fit, &residuals)
        && let Some(decrease) = report.explanations.first().map(|first| first.chi2_decrease)
    {
        let excess = before.excess_chi2.max(f64::MIN_POSITIVE);
        for explanation in &mut report.explanations {
            let more = (decrease - explanation.chi2_decrease) / excess;
            let left = (after.excess_chi2 / excess + more).clamp(0.0, 1.0);
            let squares = after.beyond_noise_m.powi(2) + before.beyond_noise_m.powi(2) * more;
            explanation.explained_fraction = 1.0 - left;
            explanation.remaining_rms_m = squares.max(0.0).sqrt();
        }
    }
    report.lack_of_fit = residuals.or(report.lack_of_fit.take());
}

/// Describes the largest deviations where the test fails; else clears their list.
pub(crate) fn describe_departures(report: &mut Report) {
    let alpha = report.threshold.alpha;
    let Some(found) = &mut report.lack_of_fit else {
        return;
    };
    if !found.fails(alpha) {
        found.largest_misfits.clear();
        return;
    }
    let limit = alpha / found.flights.len().max(1) as f64;
    let alone = found
        .largest_misfits
        .iter()
        .filter(|d| d.p_value < limit)
        .count();
    found.largest_misfits.truncate(alone.max(MAX_DEPARTURES));
    let says = departures(found);
    match (&mut report.unattributed, report.verdict) {
        (Some(unattributed), _) => {
            unattributed.description = format!("{} {says}", unattributed.description);
        }
        (None, Verdict::Unattributed) => report.withdraw(says),
        (None, Verdict::Identified | Verdict::Ambiguous) if report.consensus.is_none() => {
            let nearest = report.explanations.first();
            match nearest.filter(|nearest| nearest.explained_fraction < MIN_EXPLAINED) {
                None => report.notes.push(format!("a lack of fit remains: {says}")),
                Some(nearest) => report.withdraw(format!("{} {says}", explains(nearest))),
            }
        }
        _ => report.notes.push(format!("a lack of fit remains: {says}")),
    }
}

fn explains(nearest: &Explanation) -> String {
    format!(
        "The nearest candidate, {}, explains {} of the misfit.",
        nearest.name(),
        percent(nearest.explained_fraction)
    )
}

/// Withdraws the verdict where the explanation is the nearest alone, and something significant remains with it.
pub(crate) fn withdraw_inadequate(report: &mut Report) {
    let Some(nearest) = report.explanations.first() else {
        return;
    };
    report.withdraw(format!("{}{}", explains(nearest), nearest.sentences()));
}

/// Withdraws the verdict where several effects stand in for one that is no candidate, as powers of the speed for another law
/// of it: the tests of the extended model show that it lacks a term still, or [`EXPANSION`] effects are on the same load.
pub(crate) fn withdraw_stand_ins(report: &mut Report) {
    let Some(nearest) = report
        .explanations
        .first()
        .filter(|_| report.states_cause())
    else {
        return;
    };
    let sites = nearest.effects.iter().map(|effect| &effect.site);
    let is_of_one_load = sites.clone().all(|site| *site == nearest.effects[0].site);
    let why = match (report.missing_term(), nearest.effects.len()) {
        (Some(missing), 2..) => format!("With these effects, {missing}"),
        (None, EXPANSION..) if is_of_one_load => {
            "So many effects on one load fit nearly any law of it.".to_owned()
        }
        _ => return,
    };
    let nearest = explains(nearest);
    report.withdraw(format!(
        "{nearest} {why} They stand in for an effect that is no candidate."
    ));
}

/// Withdraws the verdict that the model is adequate where the residuals exceed the noise between the markers.
pub(crate) fn withdraw_by_excess(report: &mut Report, excess: Option<&String>) {
    if let Some(excess) = excess.filter(|_| report.verdict == Verdict::Adequate) {
        report.withdraw(format!(
            "No candidate explains what the fit found: {excess}."
        ));
    }
}

/// Withdraws the verdict where the data contradict what the user states, most flights could not be used, or recorded inputs
/// are too noisy: the effect may stand in for it. A prior was contradicted for want of the effect if that explains far more
/// than leaving the prior out would, and no conflict is left with it; so were readings that the extended model predicts.
pub(crate) fn withdraw_by_doubts(
    report: &mut Report,
    before: &FitReport,
    after: Option<&FitReport>,
) {
    let by_priors: f64 = before.prior_conflicts().map(|(_, z)| z * z).sum();
    let explained = report.explanations.first();
    let explained = explained.is_some_and(|own| own.chi2_decrease > MORE_THAN_PRIORS * by_priors);
    let alpha = report.threshold.alpha;
    let fits = { report.lack_of_fit.as_ref() }.is_some_and(|found| !found.fails(alpha));
    let after = after.filter(|_| explained && fits);
    let at = after.unwrap_or(before);
    let mut doubts = before.contradicted.clone();
    doubts.extend(at.misread.iter().cloned());
    doubts.extend(at.prior_conflicts().map(|(why, _)| why));
    doubts.extend(exclusion_caution(before));
    doubts.extend(input_noise(before));
    if doubts.is_empty() || !report.states_cause() {
        return;
    }
    let explanations = report.explanations.iter();
    let names: Vec<String> = explanations.map(Explanation::name).collect();
    report.withdraw(format!(
        "The data are in doubt, before an effect is missing: {}. Correct that first; {} may stand in for it.",
        doubts.join("; "),
        names.join(", ")
    ));
}

fn departures(found: &LackOfFit) -> String {
    let each = found.largest_misfits.iter().take(MAX_DEPARTURES);
    let each: Vec<String> = each.map(departure).collect();
    format!(
        "The residuals are not noise (p = {}): {} remain. The greatest deviations: {}.",
        significant(found.p_value, 3),
        found.beyond_noise(),
        each.join("; ")
    )
}

fn departure(found: &SmoothMisfit) -> String {
    let SmoothMisfit {
        file,
        coordinate,
        from_s,
        to_s,
        size_m,
        unit,
        ..
    } = found;
    let size = quantity(*size_m, unit);
    let sign = if *size_m > 0.0 { "+" } else { "" };
    format!("{file}, {coordinate} by {sign}{size} at {from_s:.2} to {to_s:.2} s")
}

pub(crate) fn display_names(effects: &[String]) -> String {
    let names: Vec<String> = effects.iter().map(|name| display_name(name)).collect();
    names.join(" with ")
}

/// Notes that the extended model is not proposed, as it predicts worse.
pub(crate) fn note_not_offered(report: &mut Report, extension: &ExtendedModel) {
    let names = display_names(&extension.effects);
    report.notes.push(format!(
        "the model with {names} predicts other flights worse than the model without: it is not offered"
    ));
}

/// Notes that the search for what the fit `before` lacks ended early, and why.
pub(crate) fn note_incomplete(report: &mut Report, before: &FitReport, is_out_of_time: bool) {
    report.complete = false;
    let why = match (before.has_misstated_constant(), is_out_of_time) {
        (true, _) => "a constant seems to be stated in another unit",
        (false, true) => "the time given was over",
        (false, false) => "it took as many steps as a search may",
    };
    report.notes.push(format!(
        "the search was not completed, since {why}: this is the best answer until then"
    ));
}

// Assessment whether a diagnosis is reliable, with the reasons if it is not.

impl Report {
    /// Withdraws the verdict: the lack of fit is not attributed, for the reason that the description states.
    fn withdraw(&mut self, description: String) {
        self.verdict = Verdict::Unattributed;
        self.unattributed = Some(Unattributed {
            description,
            ..Unattributed::default()
        });
    }

    /// Assesses whether the diagnosis is reliable. Large residuals of the model under test do not count: their cause is
    /// sought.
    pub(crate) fn assess(&mut self, before: &Fit, after: Option<&Fit>, verified: Option<Verified>) {
        let (fit, name) = match after {
            Some(fit) => (fit, "the fit of the extended model"),
            None => (before, "the fit of the model"),
        };
        let is_refuted = verified.as_ref().is_some_and(|verified| !verified.holds);
        let caution = |applies: bool, text: &str| applies.then(|| text.to_owned());
        let cautions = [
            convergence_caution(&fit.report, name),
            caution(!self.complete, "the search was not completed"),
            exclusion_caution(&before.report),
            input_noise(&before.report),
            caution(is_refuted, "the extended model fails an independent check"),
            caution(
                self.verdict == Verdict::Unattributed,
                "what the model lacks is attributed to no effect: the coefficients may be off by far more than their standard errors",
            ),
            caution(
                self.lack_remains(),
                "the residuals are not noise with what was found either: it is at best a part of what is missing",
            ),
        ];
        self.cautions = cautions.into_iter().flatten().collect();
        let missing = self.missing_term();
        let missing = missing.map(|missing| format!("with what was found, {missing}"));
        let constants = before.report.doubtful_constants().cloned();
        self.cautions.extend(missing.into_iter().chain(constants));
        if self.verdict == Verdict::Adequate {
            self.cautions.extend(fit.report.doubt_of_summaries.clone());
        }
        self.reliable = self.cautions.is_empty();
        self.verified = verified;
    }

    /// Whether the diagnosis states what is missing.
    fn states_cause(&self) -> bool {
        matches!(self.verdict, Verdict::Identified | Verdict::Ambiguous)
    }

    /// Sentence on the term that the extended model lacks by its tests, if the diagnosis states what is missing.
    fn missing_term(&self) -> Option<String> {
        let test = self.lack_of_fit.as_ref().filter(|_| self.states_cause());
        test?.missing_term()
    }

    /// Whether the diagnosis states what is missing, and the residuals with it are not noise.
    fn lack_remains(&self) -> bool {
        let is_stated = self.states_cause();
        let test = self.lack_of_fit.as_ref();
        is_stated && test.is_some_and(|test| test.fails(self.threshold.alpha))
    }
}
