//! Summary of a diagnosis as text.

use super::types::{Consensus, Explanation, ExplanationEffect, LoadChannel, Report, Verdict};
use crate::selection::{StepwiseModel, StepwiseTerm};
use crate::text::{millimetres, three_figures};
use crate::validation::{PredictiveGain, Validated};

/// Minimum bias of a coefficient caused by the missing effect, in standard errors of the coefficient, for the summary
/// of the report to name the coefficient.
const MIN_BIAS: f64 = 3.0;

/// Maximum number of flights that a sentence of the report lists by name.
const MAX_NAMES: usize = 16;

/// Summary text of the report, one paragraph: the verdict, the agreement of the flights, the gain in prediction error,
/// and the coefficients that the missing effect biased.
pub(crate) fn summary(report: &Report) -> String {
    let mut text = answer(report);
    if let Some(consensus) = &report.consensus {
        text.push_str(&agreement(consensus));
    }
    if let Some(gain) = &report.predictive_gain {
        text.push_str(&prediction(gain));
    }
    text.push_str(&omitted_variable_bias(report));
    text
}

fn answer(report: &Report) -> String {
    let model = &report.model;
    match report.verdict {
        Verdict::Adequate => format!(
            "No error of the model {model} is detected: none of {} candidate effects is significant (familywise p-value {}).",
            report.tests.len(),
            three_figures(report.threshold.alpha)
        ),
        Verdict::Identified => format!(
            "The model {model} lacks {}",
            described(&report.explanations[0])
        ),
        Verdict::Negligible => format!(
            "The model {model} lacks a significant but negligible effect: {}",
            described(&report.explanations[0])
        ),
        Verdict::Ambiguous => {
            if let Some(undecided) = undecided(&report.explanations) {
                return format!(
                    "The model {model} lacks {} These flights do not decide whether it lacks {undecided} too.",
                    described(&report.explanations[0])
                );
            }
            let names: Vec<String> = report.explanations.iter().map(name).collect();
            format!(
                "The model {model} lacks an effect, and these flights do not tell which of {}: {}. The best fit: {}",
                report.explanations.len(),
                names.join("; "),
                described(&report.explanations[0])
            )
        }
        Verdict::Unattributed => unattributed_answer(report),
    }
}

/// If there are two explanations (`explanations`), and the second consists of all effects of the first and one more effect:
/// name of this further effect; otherwise `None`.
fn undecided(explanations: &[Explanation]) -> Option<String> {
    let [first, second] = explanations else {
        return None;
    };
    let is_in_first = |name: &str| first.effects.iter().any(|effect| effect.name == name);
    let more = second
        .effects
        .iter()
        .filter(|effect| !is_in_first(&effect.name));
    let more: Vec<&str> = more.map(|effect| effect.name.as_str()).collect();
    match &more[..] {
        [more] if second.effects.len() == first.effects.len() + 1 => Some((*more).to_owned()),
        _ => None,
    }
}

fn unattributed_answer(report: &Report) -> String {
    let model = &report.model;
    match &report.unattributed {
        Some(found) if !report.explanations.is_empty() => format!(
            "The model {model} has a lack of fit that no candidate effect explains. {} An effect was written for it: {}.",
            found.description,
            name(&report.explanations[0])
        ),
        Some(found) => format!(
            "The model {model} has a lack of fit that neither a candidate effect nor a term of the library explains. {}",
            found.description
        ),
        None => format!("The model {model} has a lack of fit that no candidate effect explains."),
    }
}

/// Sentences on the flights that agree on the first explanation, and on the discordant flights.
fn agreement(consensus: &Consensus) -> String {
    let mut text = format!(
        " {} flights agree on it (sign-flip test, p ≤ {}).",
        consensus.flights,
        three_figures(consensus.p_value),
    );
    if let Some(explained) = consensus.explained_fraction {
        text.push_str(&format!(
            " It explains {:.0} % of the excess \u{3c7}\u{b2}; the rest differs from flight to flight and follows none of the laws \
             that were tested. Standard errors are cluster-robust (by flight).",
            100.0 * explained
        ));
    }
    if !consensus.discordant.is_empty() {
        text.push_str(&format!(
            " {} discordant flights are left out: check the quantities given for them ({}).",
            consensus.discordant.len(),
            listed(&consensus.discordant)
        ));
    }
    text
}

fn listed(names: &[String]) -> String {
    match names.len().checked_sub(MAX_NAMES) {
        Some(more) if more > 0 => format!("{} and {more} more", names[..MAX_NAMES].join(", ")),
        _ => names.join(", "),
    }
}

fn prediction(gain: &PredictiveGain) -> String {
    let how = match gain.held_out_by_dataset {
        true => "held-out flights",
        false => "flights not used in the fit (2-fold cross-validation)",
    };
    let mut text = format!(
        " The RMS prediction error on {how} falls from {} to {} (noise {}).",
        millimetres(gain.rms_before_m),
        millimetres(gain.rms_after_m),
        millimetres(gain.noise_m)
    );
    if gain.error_reduction_m() < 0.0 {
        text = text.replace(" falls from ", " rises from ");
    }
    text.push_str(&format!(
        " {} of {} flights are predicted better, {} worse (median {} to {}).",
        gain.improved,
        gain.flights,
        gain.worsened,
        millimetres(gain.median_before_m),
        millimetres(gain.median_after_m)
    ));
    for (count, by) in [
        (gain.predicted_only_after, "with"),
        (gain.predicted_only_before, "without"),
    ] {
        if count > 0 {
            let flights = if count == 1 { "flight" } else { "flights" };
            text.push_str(&format!(
                " {count} more {flights} can be computed only {by} the added effects."
            ));
        }
    }
    if !gain.set_apart.is_empty() {
        text.push_str(&format!(
            " Set apart, as no model follows: {}.",
            listed(&gain.set_apart)
        ));
    }
    if gain.without > 0 {
        text.push_str(&format!(
            " {} of these {} flights contradict it in the segment on which their initial state is fitted, and are predicted without \
             it.",
            gain.without, gain.flights
        ));
    }
    text
}

/// Sentence on the coefficients whose estimates were biased because the model lacked an effect; empty if none was.
fn omitted_variable_bias(report: &Report) -> String {
    let biased: Vec<String> = report
        .coefficients
        .iter()
        .filter_map(|(name, c)| {
            let before = c.before?;
            let bias = (c.value - before) / c.std_error;
            let change = || {
                let (before, after) = (three_figures(before), three_figures(c.value));
                format!("{name} from {before} to {after}")
            };
            (bias.abs() > MIN_BIAS).then(change)
        })
        .collect();
    match biased.is_empty() {
        true => String::new(),
        false => format!(
            " Corrected for omitted-variable bias: {}.",
            biased.join(", ")
        ),
    }
}

fn name(explanation: &Explanation) -> String {
    let names: Vec<&str> = explanation
        .effects
        .iter()
        .map(|e| e.name.as_str())
        .collect();
    names.join(" with ")
}

fn described(explanation: &Explanation) -> String {
    let each: Vec<String> = explanation.effects.iter().map(described_effect).collect();
    each.join(" And ")
}

fn described_effect(effect: &ExplanationEffect) -> String {
    let values: Vec<String> = effect
        .estimates
        .iter()
        .map(|(name, e)| {
            let unit = if e.unit == "1" { "" } else { e.unit.as_str() };
            let (value, error) = (three_figures(e.value), three_figures(e.std_error));
            let text = format!("{name} = {value} ± {error} {unit}");
            text.trim_end().to_owned()
        })
        .collect();
    let doc = effect.description.replace('\n', " ");
    let doc = doc.trim().trim_end_matches('.');
    format!(
        "{} ({}): {doc}; {}.",
        effect.name,
        effect.site,
        values.join(", ")
    )
}

/// Sentence that explains why a hypothesis is not accepted although it leaves only noise in the residuals: it can fit
/// almost any data and does not improve out-of-sample predictions.
pub(crate) fn refused(validated: &Validated) -> String {
    let names = validated.extension.effects.join(" with ");
    let errors = validated.gain.as_ref().map_or_else(String::new, |gain| {
        let (before, after) = (gain.rms_before_m, gain.rms_after_m);
        format!(
            " (RMS {} without, {} with)",
            millimetres(before),
            millimetres(after)
        )
    });
    format!(
        "{} fits the flights down to the noise, but does not improve the prediction of others{errors}: an overflexible explanation is \
         not accepted without that",
        names.replace('_', "-")
    )
}

/// Sentences on a lack of fit that no candidate effect explains: the loads in which it lies, and the library terms that
/// `model` selected.
pub(crate) fn unattributed(model: &StepwiseModel, channels: &[LoadChannel]) -> String {
    let selected: Vec<&StepwiseTerm> = model.terms.iter().filter(|term| term.selected).collect();
    let most = channels
        .iter()
        .max_by(|a, b| a.explained_fraction.total_cmp(&b.explained_fraction));
    if let Some(most) = most.filter(|_| selected.is_empty() && model.has_significant_term) {
        return format!(
            "Most of it is a missing load in {} ({:.0} % of what loads explain), and no product of angle of attack, spin, speed, rates, \
             height and time on it predicts flights better out of sample.",
            most.site,
            100.0 * most.explained_fraction
        );
    }
    if selected.is_empty() {
        let greatest = model.terms.first().map_or(0.0, |term| term.score_chi2);
        return format!(
            "No product of angle of attack, spin, speed, rates, height and time on one of the loads is significant (greatest score \
             \u{3c7}\u{b2} {greatest:.1})."
        );
    }
    let each: Vec<String> = selected
        .iter()
        .map(|term| format!("{} by {}", term.site, term.formula))
        .collect();
    let rest = match model.is_adequate {
        true => "",
        false => " A significant lack of fit remains.",
    };
    let beside = match model.effects.as_slice() {
        [] => String::new(),
        effects => format!(
            "The nearest candidate is {}, which is not adequate alone. ",
            effects.join(" with ").replace('_', "-")
        ),
    };
    format!(
        "{beside}The lack of fit is in {}.{rest}",
        each.join(", and in ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gain(after: f64) -> PredictiveGain {
        PredictiveGain {
            rms_before_m: 0.02,
            rms_after_m: after,
            std_error_m: 0.001,
            noise_m: 0.0015,
            flights: 4,
            without: 0,
            held_out_by_dataset: true,
            improved: 3,
            worsened: 1,
            set_apart: vec!["f9.csv".into()],
            ..PredictiveGain::default()
        }
    }

    #[test]
    fn a_prediction_error_falls_or_rises() {
        let text = prediction(&gain(0.002));
        assert!(text.contains("falls from 20.0 mm to 2.0 mm"), "{text}");
        assert!(
            text.contains("3 of 4 flights are predicted better, 1 worse"),
            "{text}"
        );
        assert!(
            text.contains("Set apart, as no model follows: f9.csv"),
            "{text}"
        );
        let text = prediction(&PredictiveGain {
            predicted_only_after: 3,
            predicted_only_before: 1,
            ..gain(0.002)
        });
        assert!(
            text.contains("3 more flights can be computed only with the added effects.")
                && text.contains("1 more flight can be computed only without the added effects."),
            "{text}"
        );
        let text = prediction(&gain(0.03));
        assert!(text.contains("rises from 20.0 mm to 30.0 mm"), "{text}");
    }

    #[test]
    fn long_lists_of_flights_are_shortened() {
        let names: Vec<String> = (0..20).map(|i| format!("f{i}.csv")).collect();
        assert!(listed(&names).ends_with("f15.csv and 4 more"));
        assert_eq!(listed(&names[..2]), "f0.csv, f1.csv");
    }
}
