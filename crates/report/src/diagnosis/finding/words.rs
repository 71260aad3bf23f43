//! Sentences of the opening section: the finding, its certainty, and the recommended next step.
use diagnose::{Explanation, ExplanationEffect, LackOfFit, LoadChannel, Report, Verdict};
use identify::numbers::{Digits, equivalent_z, percent, plain, probability, significant, unit};
use identify::wording::{count, names};

use super::super::{DiagnosisPage, words};
use super::curve::{Curve, Point};
use crate::figures::symbol;

/// Ratio of an estimate to its standard error that is far beyond chance in any number of diagnoses.
const BEYOND_CHANCE: f64 = 8.0;
/// Bonferroni-corrected p-value above which the strongest remaining effect is attributed to chance.
const USUAL: f64 = 0.05;

/// Fraction of the samples on either side of a point that is named in a sentence.
const MIN_SHARE: f64 = 0.025;

/// What the model lacks, and how large it is; empty if nothing is known.
pub(super) fn what(report: &Report, curve: Option<&Curve>) -> String {
    let first = report.explanations.first();
    let effects = first.map_or_else(String::new, |found| {
        joined(found.effects.iter().map(ExplanationEffect::sentence))
    });
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
            let share = |channel: &LoadChannel| channel.explained_fraction;
            let most = channels.max_by(|a, b| share(a).total_cmp(&share(b)));
            let place = most.filter(|c| share(c).is_finite()).map(|c| {
                format!(
                    "Most of it acts as {}: that alone explains {} of what all terms explain.",
                    words::site(&c.site),
                    percent(share(c))
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

/// Sentence on the size of the missing effects: the quantity of `curve` where the models differ most, or the estimates.
fn size(curve: Option<&Curve>, explanation: Option<&Explanation>) -> String {
    let estimates = || {
        let effects = explanation.iter().flat_map(|found| &found.effects);
        let all = effects.flat_map(|e| &e.estimates).take(3);
        match all.map(|(name, e)| e.text(name)).collect::<Vec<_>>() {
            all if all.is_empty() => String::new(),
            all => format!("Its size: {}.", all.join(", ")),
        }
    };
    let Some((curve, point)) = curve.and_then(|c| Some((c, farthest(c)?))) else {
        return estimates();
    };
    let digits = Digits::of(point.after, point.error);
    let unit = unit(&curve.quantity.unit);
    let over = match curve.over.doc.as_str() {
        "" => symbol(&curve.over.name),
        doc => doc.to_owned(),
    };
    let (space, degrees) = match curve.over.unit.as_str() {
        "°" => ("", "°"),
        other => ("\u{a0}", other),
    };
    let place = format!("{over} of {}{space}{degrees}", significant(point.x, 3));
    let quantity = match curve.quantity.doc.as_str() {
        "" => curve.quantity.name.clone(),
        doc => format!("{} ({doc})", curve.quantity.name),
    };
    let (after, error) = (digits.one(point.after), digits.one(point.error));
    let value = format!("{after} ± {error} {unit}");
    let (article, value) = (article(&over), value.trim_end());
    if point.before.is_finite() {
        let before = digits.one(point.before);
        format!("At {article} {place} {quantity} is {value}; the model without it has {before}.")
    } else {
        format!("At {article} {place} {quantity} is {value}.")
    }
}

fn article(noun: &str) -> &'static str {
    match noun.chars().next() {
        Some('a' | 'e' | 'i' | 'o' | 'u' | 'α') => "an",
        _ => "a",
    }
}

/// Point at which the models differ most; on each side of it lies at least the fraction [`MIN_SHARE`] of the samples.
fn farthest(curve: &Curve) -> Option<Point> {
    let size = |p: &Point| {
        let known = p.before.is_finite();
        (if known { p.after - p.before } else { p.after }).abs()
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

/// Name of the coefficient with the largest ratio of estimate to standard error, and this ratio.
fn clearest(explanation: &Explanation) -> Option<(&String, f64)> {
    let all = explanation.effects.iter().flat_map(|e| &e.estimates);
    let all = all.map(|(name, e)| (name, (e.value / e.std_error).abs()));
    let known = all.filter(|(_, z)| z.is_finite());
    known.max_by(|a, b| a.1.total_cmp(&b.1))
}

/// How certain the result is: how far the estimate is from zero, and whether another effect could explain the flights.
pub(super) fn sure(report: &Report) -> String {
    let tested = count(report.tests.len(), "effect");
    let threshold = equivalent_z(report.threshold.z);
    let first = report.explanations.first();
    let far = first.and_then(clearest).map(|(name, z)| {
        let is_far = z > BEYOND_CHANCE;
        let beyond = if is_far { ", far beyond chance" } else { "" };
        let z = plain(z, usize::from(z < 10.0));
        format!("{name} is {z} standard errors away from zero{beyond}.")
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
        Verdict::Ambiguous => {
            let far = match far {
                Some(far) => format!(": in the best explanation {far}"),
                None => ".".to_owned(),
            };
            let all = report.explanations.iter().map(Explanation::name);
            let all = all.collect::<Vec<_>>();
            format!(
                "That something is missing is sure{far} Which it is, is open: {}.",
                names(&all)
            )
        }
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

#[cfg(test)]
mod tests {
    use super::super::curve::Variable;
    use super::*;

    /// Of 154 samples at least four are on either side of a point that is named.
    #[test]
    fn the_point_that_is_named_has_samples_on_either_side() {
        let named = |samples: [usize; 5]| {
            let variable = || Variable {
                name: "alpha".to_owned(),
                doc: String::new(),
                unit: "rad".to_owned(),
            };
            let points = samples
                .into_iter()
                .enumerate()
                .map(|(place, samples)| Point {
                    x: place as f64,
                    before: 0.0,
                    after: (place as f64).powi(2),
                    error: 0.1,
                    samples,
                });
            let curve = Curve {
                quantity: variable(),
                over: variable(),
                points: points.collect(),
            };
            farthest(&curve).map(|point| point.x)
        };
        assert_eq!(named([50, 50, 50, 2, 2]), Some(3.0));
        assert_eq!(named([50, 50, 50, 3, 1]), Some(3.0));
        assert_eq!(named([50, 50, 51, 2, 1]), Some(2.0));
        assert_eq!(named([30, 30, 30, 32, 32]), Some(4.0));
    }
}
