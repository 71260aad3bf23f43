//! Sentences of the opening section: the finding, its certainty, and the recommended next step.

use diagnose::{Explanation, ExplanationEffect, LackOfFit, Report, Verdict};
use identify::wording::count;

use super::super::{DiagnosisPage, words};
use super::curve::{Curve, Point};
use crate::figures::symbol;
use identify::numbers::{Digits, equivalent_z, percent, plain, probability, significant, unit};
use identify::wording::names;

/// Minimum absolute ratio of an effect's estimate to its standard error at which the report calls the effect far beyond
/// chance. The threshold is so high that chance does not reach it even in a large number of diagnoses.
const BEYOND_CHANCE: f64 = 8.0;
/// Bonferroni-corrected p-value above which the report attributes the test result of the strongest remaining candidate
/// effect to chance.
const USUAL: f64 = 0.05;

/// Minimum fraction of the samples that must lie on either side of a point of the curve (the point included) for the
/// point to be named in a sentence.
const MIN_SHARE: f64 = 0.025;

/// Sentences that describe the effect that the model lacks, and its size; empty if nothing is known of it.
pub(super) fn what(report: &Report, curve: Option<&Curve>) -> String {
    let first = report.explanations.first();
    let effects = first.map_or_else(String::new, says);
    match report.verdict {
        Verdict::Adequate => "The residuals look like the noise of the measurement.".to_owned(),
        Verdict::Identified => joined([effects, size(curve, first)]),
        Verdict::Ambiguous if first.is_none() => String::new(),
        Verdict::Ambiguous => joined([
            "The one that fits best:".to_owned(),
            effects,
            size(curve, first),
        ]),
        Verdict::Negligible => joined([effects, size(None, first)]),
        Verdict::Unattributed => {
            let channels = report.unattributed.iter().flat_map(|u| &u.channels);
            let most =
                channels.max_by(|a, b| a.explained_fraction.total_cmp(&b.explained_fraction));
            let place = most.filter(|c| c.explained_fraction.is_finite()).map(|c| {
                format!(
                    "Most of it acts as {}: that alone explains {} of what all terms explain.",
                    words::site(&c.site),
                    percent(c.explained_fraction)
                )
            });
            joined([place.unwrap_or_default(), size(curve, first)])
        }
    }
}

fn joined(parts: impl IntoIterator<Item = String>) -> String {
    let parts = parts.into_iter().filter(|part| !part.is_empty());
    parts.collect::<Vec<_>>().join(" ")
}

/// Sentences that describe the effects of the hypothesis `explanation`, one of those that may explain the misfit of the
/// model.
fn says(explanation: &Explanation) -> String {
    joined(explanation.effects.iter().map(ExplanationEffect::sentence))
}

/// Sentence on the size of the missing effects: the quantity of `curve` at the point where the model under test and the
/// extended model differ most; without a curve, the estimates of the hypothesis `explanation`.
fn size(curve: Option<&Curve>, explanation: Option<&Explanation>) -> String {
    let estimates = || {
        let effects = explanation
            .into_iter()
            .flat_map(|explanation| &explanation.effects);
        let all = effects.flat_map(|e| &e.estimates).take(3);
        let all: Vec<String> = all.map(|(name, e)| e.text(name)).collect();
        if all.is_empty() {
            String::new()
        } else {
            format!("Its size: {}.", all.join(", "))
        }
    };
    let Some((curve, point)) = curve.and_then(|c| Some((c, farthest(c)?))) else {
        return estimates();
    };
    let digits = Digits::of(point.after, point.error);
    let unit = unit(&curve.unit);
    let over = match curve.over_doc.as_str() {
        "" => symbol(&curve.over),
        doc => doc.to_owned(),
    };
    let (space, degrees) = match curve.over_unit.as_str() {
        "°" => ("", "°"),
        other => ("\u{a0}", other),
    };
    let place = format!("{over} of {}{space}{degrees}", significant(point.x, 3));
    let quantity = match curve.doc.as_str() {
        "" => curve.quantity.clone(),
        doc => format!("{} ({doc})", curve.quantity),
    };
    let value = format!(
        "{} ± {} {unit}",
        digits.one(point.after),
        digits.one(point.error)
    );
    let value = value.trim_end();
    if point.before.is_finite() {
        format!(
            "At {} {place} {quantity} is {value}; the model without it has {}.",
            article(&over),
            digits.one(point.before)
        )
    } else {
        format!("At {} {place} {quantity} is {value}.", article(&over))
    }
}

fn article(noun: &str) -> &'static str {
    match noun.chars().next() {
        Some('a' | 'e' | 'i' | 'o' | 'u' | 'α') => "an",
        _ => "a",
    }
}

/// Point of the curve at which the model under test and the extended model differ most; `None` if no point can be
/// considered. Points near an end of the curve are not considered: on each side of a point must lie at least the
/// fraction [`MIN_SHARE`] of the samples.
fn farthest(curve: &Curve) -> Option<Point> {
    let size = |p: &Point| {
        if p.before.is_finite() {
            (p.after - p.before).abs()
        } else {
            p.after.abs()
        }
    };
    let all: usize = curve.points.iter().map(|p| p.samples).sum();
    let mut below = 0;
    let supported = curve.points.iter().filter(|p| {
        below += p.samples;
        let (low, high) = (below as f64, (all - below + p.samples) as f64);
        low.min(high) >= MIN_SHARE * all as f64
    });
    let known = supported.filter(|p| p.after.is_finite() && p.error.is_finite());
    known.copied().max_by(|a, b| size(a).total_cmp(&size(b)))
}

/// Coefficient of the hypothesis `explanation` with the largest absolute ratio of estimate to standard error: the effect, the
/// name of the coefficient, and the ratio. `None` if no ratio is finite.
fn clearest(explanation: &Explanation) -> Option<(&ExplanationEffect, &String, f64)> {
    let effects = explanation.effects.iter();
    let all = effects.flat_map(|effect| effect.estimates.iter().map(move |(n, e)| (effect, n, e)));
    let all = all.map(|(effect, name, e)| (effect, name, (e.value / e.std_error).abs()));
    let known = all.filter(|(_, _, z)| z.is_finite());
    known.max_by(|a, b| a.2.total_cmp(&b.2))
}

/// Sentences that state how certain the result of the diagnosis is: how far the estimate is from zero, and whether
/// another candidate effect could also explain the flights.
pub(super) fn sure(report: &Report) -> String {
    let tested = count(report.tests.len(), "effect");
    let threshold = equivalent_z(report.threshold.z);
    let first = report.explanations.first();
    let far = first.and_then(clearest).map(|(_, name, z)| {
        format!(
            "{name} is {} standard errors away from zero{}.",
            plain(z, usize::from(z < 10.0)),
            if z > BEYOND_CHANCE {
                ", far beyond chance"
            } else {
                ""
            }
        )
    });
    let rival = first.and_then(|c| c.strongest_remaining.as_ref());
    let alone = match rival {
        _ if report.tests.is_empty() => String::new(),
        Some(r) => format!(
            "Of the {tested} tested only this one explains the flights: with it in the model, the strongest of the others \
             is {} (p = {}{}).",
            words::readable(&r.name),
            probability(r.p_value),
            // Bonferroni correction for the number of candidates.
            if r.p_value * report.tests.len() as f64 > USUAL {
                ", as chance gives among so many"
            } else {
                ""
            }
        ),
        None => format!("Of the {tested} tested only this one explains the flights."),
    };
    match report.verdict {
        Verdict::Adequate => {
            let strongest = report.tests.iter().map(|c| c.z).filter(|z| z.is_finite());
            let strongest = strongest.fold(f64::NAN, f64::max);
            joined([
                format!(
                    "None of the {tested} tested is significant: the largest test statistic is z = {}, and {threshold} would be \
                     needed.",
                    equivalent_z(strongest)
                ),
                "An effect below its minimum detectable size could still be there; the sizes are listed under the limits \
                 of these flights."
                    .to_owned(),
            ])
        }
        Verdict::Identified if first.is_some_and(|c| c.effects.len() > 1) => joined([
            far.unwrap_or_default(),
            format!("Of the {tested} tested, only these together explain the flights."),
        ]),
        Verdict::Identified => joined([far.unwrap_or_default(), alone]),
        Verdict::Ambiguous => joined([
            "That something is missing is sure".to_owned()
                + &match far {
                    Some(far) => format!(": in the best explanation {far}"),
                    None => ".".to_owned(),
                },
            format!(
                "Which it is, is open: {}.",
                names(
                    &report
                        .explanations
                        .iter()
                        .map(Explanation::name)
                        .collect::<Vec<_>>()
                )
            ),
        ]),
        Verdict::Negligible => joined([
            far.unwrap_or_default(),
            "Every estimate is below the smallest size of interest that its effect states."
                .to_owned(),
        ]),
        Verdict::Unattributed => {
            let strongest = report.lack_of_fit.as_ref().map(LackOfFit::sentence);
            joined([
                strongest.unwrap_or_default(),
                format!("None of the {tested} of the catalogue takes the misfit away."),
            ])
        }
    }
}

/// Sentences that recommend to the user what to do after the diagnosis.
pub(super) fn next(page: &DiagnosisPage<'_>) -> String {
    let report = page.report;
    if !page.report.cautions.is_empty() {
        return "First remove the reasons above; until then this is a hint, not a result."
            .to_owned();
    }
    let extended = report.extended_model.as_deref().map(|file| {
        let checks = match &report.verified {
            Some(v) if v.holds => "; it passes the independent checks",
            Some(_) => "; but it fails an independent check",
            None => "",
        };
        format!("The extended model is {file}, with the values found{checks}.")
    });
    let throw = report
        .proposed_throw
        .as_ref()
        .map(|_| "The throw proposed below would best distinguish the explanations.".to_owned());
    match report.verdict {
        Verdict::Adequate => {
            "Use the model as it is. Flights at other speeds, angles and spins would test it where these do not.".to_owned()
        }
        Verdict::Identified => joined([
            extended.unwrap_or_default(),
            "Use it in place of the model, and diagnose it again with new flights.".to_owned(),
        ]),
        Verdict::Ambiguous => joined([
            throw.unwrap_or_else(|| "Flights that differ more in speed, angle and spin would decide.".to_owned()),
            extended.map(|e| format!("{e} It has the best explanation, which may not be the right one.")).unwrap_or_default(),
        ]),
        Verdict::Negligible => {
            "Keep the model. If an effect of this size matters to you, switch it on with --with.".to_owned()
        }
        Verdict::Unattributed => joined([
            "Look at when and where the load below is missing, and write an effect for it.".to_owned(),
            extended
                .map(|e| format!("{e} Its added term is a description of these flights, not an explanation."))
                .unwrap_or_default(),
        ]),
    }
}
