//! Sentences of a diagnosis, which report, page and terminal share.

use std::fmt;

use identify::numbers::{
    Digits, displayed, percent, probability, quantity, significant, stated, unit,
};
use identify::wording::{count, names, sentence};
use serde::Serialize;

use super::types::{
    Consensus, Estimate, Explanation, ExplanationEffect, LoadChannel, Report, Verdict,
};
use crate::context::ScoreTestModel;
use crate::score_test::ln_p_to_z;
use crate::selection::{Search, StepwiseModel, StepwiseTerm};
use crate::validation::{ChosenExtension, PredictiveGain};

/// Minimum bias of a coefficient that the summary names, standard errors.
const MIN_BIAS: f64 = 3.0;

impl Report {
    /// Sentence that states the verdict.
    pub fn verdict_sentence(&self) -> String {
        let lacks = |what: &str| match self.explanations.first() {
            Some(found) => format!("The model lacks {what}: {}.", found.name()),
            None => format!("The model lacks {what}."),
        };
        match (self.verdict, self.explanations.as_slice()) {
            (Verdict::Adequate, _) => "No model error detected.".to_owned(),
            (Verdict::Identified, [found, ..]) if found.effects.len() > 1 => format!(
                "The model lacks {} effects, {}.",
                found.effects.len(),
                found.name()
            ),
            (Verdict::Identified, []) => "The model lacks an effect.".to_owned(),
            (Verdict::Identified, _) => lacks("one effect"),
            (Verdict::Ambiguous, [] | [_]) => {
                "The model lacks an effect, but these flights cannot show which.".to_owned()
            }
            (Verdict::Ambiguous, all) => format!(
                "The model lacks one of {} effects; these flights cannot distinguish them.",
                all.len()
            ),
            (Verdict::Unattributed, _) => {
                "The model lacks an effect, and no candidate explains what is missing.".to_owned()
            }
            (Verdict::Negligible, _) => lacks("an effect below the smallest size of interest"),
        }
    }

    /// Sentences on the reduction of the prediction error, or why it was not measured.
    pub fn gain_sentences(&self) -> String {
        match (&self.predictive_gain, &self.extended_model) {
            (Some(gain), _) => gain.sentences(),
            (None, Some(_)) => {
                "The gain on flights that were not fitted could not be measured.".to_owned()
            }
            (None, None) => "The model is not extended.".to_owned(),
        }
    }
}

impl fmt::Display for Verdict {
    /// The name, as in `report.json`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.serialize(f)
    }
}

impl Explanation {
    /// Names of the effects of the explanation, in one text.
    #[doc(hidden)]
    pub fn name(&self) -> String {
        let effects: Vec<&str> = self.effects.iter().map(|e| e.name.as_str()).collect();
        match effects.len() {
            0 => "an explanation without effects".to_owned(),
            1 => names(&effects),
            _ => format!("{} together", names(&effects)),
        }
    }

    pub(super) fn sentences(&self) -> String {
        let effects = self.effects.iter().map(|effect| {
            let estimates = effect.estimates.iter();
            let estimates: Vec<String> = estimates.map(|(name, e)| e.text(name)).collect();
            format!(
                " {} Acts on: {}; {}.",
                effect.sentence(),
                effect.site,
                estimates.join(", ")
            )
        });
        effects.collect()
    }
}

impl ExplanationEffect {
    /// Sentence on the effect, from its documentation.
    #[doc(hidden)]
    pub fn sentence(&self) -> String {
        match self.description.trim() {
            "" => "It has no description.".to_owned(),
            doc => sentence(&doc.replace('\n', " ")),
        }
    }
}

impl Estimate {
    /// The estimate with its standard error as text, such as `C_L0 = 0.188 ± 0.003 1/rad`; `name` is its coefficient.
    #[doc(hidden)]
    pub fn text(&self, name: &str) -> String {
        let digits = Digits::of(self.value, self.std_error);
        let (value, error) = (digits.one(self.value), digits.one(self.std_error));
        let text = format!("{name} = {value} ± {error} {}", unit(&self.unit));
        text.trim_end().to_owned()
    }
}

impl PredictiveGain {
    /// Reduction of the RMS prediction error with its standard error, such as `19.4 ± 0.4 mm`.
    #[doc(hidden)]
    pub fn text(&self) -> String {
        let (scale, of) = match self.has_summaries {
            true => (1.0 / self.noise_m, " times the noise".to_owned()),
            false => {
                let (scale, of) = displayed(&self.unit);
                (scale, format!("\u{a0}{}", unit(of)))
            }
        };
        let (value, error) = (scale * self.error_reduction_m(), scale * self.std_error_m);
        if !(error.is_finite() && error > 0.0) {
            return self.size(self.error_reduction_m());
        }
        let digits = Digits::of(value, error);
        format!("{} ± {}{of}", digits.one(value), digits.one(error))
    }

    /// An error in words; in units of the noise where summaries are predicted.
    fn size(&self, error_m: f64) -> String {
        match self.has_summaries {
            true => format!("{} times the noise", significant(error_m / self.noise_m, 3)),
            false => quantity(error_m, &self.unit),
        }
    }

    /// Sentences on the prediction errors without and with the added effects, over all flights and flight by flight.
    fn sentences(&self) -> String {
        let on = match (self.held_out_by_dataset, self.flights) {
            (true, 0) => "On held-out flights".to_owned(),
            (true, 1) => "On the one held-out flight".to_owned(),
            (true, n) => format!("On {n} held-out flights"),
            (false, n) => format!("By cross-validation over {}", count(n, "flight")),
        };
        let first = "it in the first part already, on which the initial state is fitted, and";
        let without = match self.without {
            0 => String::new(),
            1 => format!(" One of them contradicts {first} is predicted without it."),
            n => format!(" {n} of them contradict {first} are predicted without it."),
        };
        let lower = match self.has_summaries {
            true => String::new(),
            false => format!(
                " The noise, {}, is the lower limit of any model.",
                quantity(self.noise_m, &self.unit)
            ),
        };
        let per = if self.has_summaries {
            "value"
        } else {
            "coordinate"
        };
        let mut text = format!(
            "{on} the RMS prediction error per {per} is {} without the extension and {} with it: a gain of {}.{without}{lower}",
            self.size(self.rms_before_m),
            self.size(self.rms_after_m),
            self.text(),
        );
        let compared = self.improved + self.worsened;
        if compared > 0 {
            text += &format!(
                " {} of {} improve{} (sign test p = {}); the median RMS error over flights changes from {} to {}.",
                self.improved,
                count(compared, "flight"),
                if self.improved == 1 { "s" } else { "" },
                probability(self.sign_test_p_value),
                self.size(self.median_before_m),
                self.size(self.median_after_m)
            );
        }
        for (number, by) in [
            (self.predicted_only_after, "with"),
            (self.predicted_only_before, "without"),
        ] {
            if number > 0 {
                let flights = count(number, "more flight");
                text += &format!(" {flights} can be computed only {by} the added effects.");
            }
        }
        if !self.set_apart.is_empty() {
            let files = names(&self.set_apart);
            text +=
                &format!(" Set apart, because no model follows them, and not counted: {files}.");
        }
        text
    }
}

pub(crate) fn summary(report: &Report) -> String {
    let mut text = report.verdict_sentence() + &details(report);
    if let Some(consensus) = &report.consensus {
        text += &agreement(consensus);
    }
    if report.predictive_gain.is_some() {
        text += &format!(" {}", report.gain_sentences());
    }
    text + &omitted_variable_bias(report)
}

/// Sentences on the verdict's reasons: the tests, the explanations, or the terms outside the catalogue.
fn details(report: &Report) -> String {
    let first = report.explanations.first();
    match report.verdict {
        Verdict::Adequate => format!(
            " None of {} is significant at the familywise level {}.",
            count(report.tests.len(), "candidate effect"),
            stated(report.threshold.alpha)
        ),
        Verdict::Identified | Verdict::Negligible => {
            first.map_or_else(String::new, Explanation::sentences)
        }
        Verdict::Ambiguous => {
            let all: Vec<String> = report.explanations.iter().map(Explanation::name).collect();
            let Some(first) = first else {
                return String::new();
            };
            let undecided = undecided(&report.explanations).map(|effect| {
                format!(" These flights do not decide whether the model lacks {effect} too.")
            });
            format!(
                " They are: {}.{} The best fit: {}.{}",
                all.join("; "),
                undecided.unwrap_or_default(),
                first.name(),
                first.sentences()
            )
        }
        Verdict::Unattributed => {
            let Some(found) = &report.unattributed else {
                return String::new();
            };
            let written = first.filter(|_| !found.terms.is_empty());
            let written =
                written.map(|first| format!(" An effect was written for it: {}.", first.name()));
            format!(" {}{}", found.description, written.unwrap_or_default())
        }
    }
}

/// The one effect by which the second of two explanations exceeds the first.
fn undecided(explanations: &[Explanation]) -> Option<&str> {
    let [first, second] = explanations else {
        return None;
    };
    let is_in_first = |name: &str| first.effects.iter().any(|effect| effect.name == name);
    let more = second.effects.iter().map(|effect| effect.name.as_str());
    let more: Vec<&str> = more.filter(|name| !is_in_first(name)).collect();
    match more[..] {
        [more] if second.effects.len() == first.effects.len() + 1 => Some(more),
        _ => None,
    }
}

/// Sentences on the flights that agree on the first explanation, and on the discordant flights.
fn agreement(consensus: &Consensus) -> String {
    let mut text = format!(
        " {} flights agree on it (sign-flip test, p ≤ {}).",
        consensus.flights,
        probability(consensus.p_value),
    );
    if let Some(explained) = consensus.explained_fraction {
        text += &format!(
            " It explains {} of the excess χ²; the rest differs from flight to flight and follows none of the laws that were \
             tested. Standard errors are cluster-robust (by flight).",
            percent(explained)
        );
    }
    if !consensus.discordant.is_empty() {
        text += &format!(
            " {} discordant flights are left out: check the quantities given for them ({}).",
            consensus.discordant.len(),
            names(&consensus.discordant)
        );
    }
    text
}

/// Note on the strongest library term where it is significant, and no effect that explains it is.
pub(crate) fn term_alone(model: &ScoreTestModel<'_>, search: &Search) -> Option<String> {
    let terms = model.terms.as_ref()?;
    let (term, test) = search.at_base.tests.strongest_term()?;
    Some(format!(
        "the term {} is significant (z = {:.1}), but no effect that explains it is: it may be chance, or a small error of \
         the measurement",
        terms.name(term),
        ln_p_to_z(test.ln_p_value)
    ))
}

/// Sentence on the coefficients whose estimates were biased because the model lacked an effect; empty if none was.
fn omitted_variable_bias(report: &Report) -> String {
    let biased = report.coefficients.iter().filter_map(|(name, c)| {
        let before = c.before?;
        let bias = (c.value - before) / c.std_error;
        let digits = Digits::of(c.value, c.std_error);
        (bias.abs() > MIN_BIAS).then(|| {
            format!(
                "{name} from {} to {}",
                digits.one(before),
                digits.one(c.value)
            )
        })
    });
    let biased: Vec<String> = biased.collect();
    // What merely stands in for the missing effect corrects nothing.
    if biased.is_empty() || report.verdict == Verdict::Unattributed {
        return String::new();
    }
    format!(
        " Corrected for omitted-variable bias: {}.",
        biased.join(", ")
    )
}

/// Why a hypothesis that leaves only noise is not accepted: it does not improve predictions.
pub(crate) fn refused(validated: &ChosenExtension) -> String {
    let names = validated.extension.effects.join(" with ");
    let errors = validated.gain.as_ref().map_or_else(String::new, |gain| {
        let (before, after) = (gain.rms_before_m, gain.rms_after_m);
        format!(
            " (RMS {} without, {} with)",
            gain.size(before),
            gain.size(after)
        )
    });
    format!(
        "{} fits the flights down to the noise, but does not improve the prediction of others{errors}: an overflexible explanation is \
         not accepted without that",
        names.replace('_', "-")
    )
}

/// Sentences on a lack of fit that no candidate explains.
pub(crate) fn unattributed(model: &StepwiseModel, channels: &[LoadChannel]) -> String {
    let terms = model.terms();
    let selected: Vec<&StepwiseTerm> = terms.iter().filter(|term| term.selected).collect();
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
        let greatest = terms.first().map_or(0.0, |term| term.score_chi2);
        return format!(
            "No product of angle of attack, spin, speed, rates, height and time on one of the loads is significant (greatest score \
             \u{3c7}\u{b2} {greatest:.1})."
        );
    }
    let each: Vec<String> = selected
        .iter()
        .map(|term| format!("{} by {}", term.site, term.formula))
        .collect();
    let rest = if model.is_adequate {
        ""
    } else {
        " A significant lack of fit remains."
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

    #[test]
    fn a_prediction_error_falls_or_rises() {
        let gain = |after: f64| PredictiveGain {
            rms_before_m: 0.02,
            rms_after_m: after,
            std_error_m: 0.001,
            noise_m: 0.0015,
            flights: 4,
            held_out_by_dataset: true,
            improved: 3,
            worsened: 1,
            set_apart: vec!["f9.csv".into()],
            predicted_only_after: 3,
            predicted_only_before: 1,
            ..PredictiveGain::default()
        };
        let text = gain(0.002).sentences().replace('\u{a0}', " ");
        for part in [
            "On 4 held-out flights the RMS prediction error per coordinate is 20.0 mm without the extension and 2.00 mm with it",
            "a gain of 18.0 ± 1.0 mm",
            "3 of 4 flights improve",
            "no model follows them, and not counted: f9.csv",
            "3 more flights can be computed only with the added effects.",
            "1 more flight can be computed only without the added effects.",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
        let text = gain(0.03).sentences().replace('\u{a0}', " ");
        assert!(text.contains("a gain of −10.0 ± 1.0 mm"), "{text}");
        let by_accelerometer = PredictiveGain {
            unit: "m/s^2".into(),
            ..gain(0.03)
        };
        let text = by_accelerometer.sentences().replace('\u{a0}', " ");
        assert!(text.contains("a gain of −0.0100 ± 0.0010 m/s²"), "{text}");
        assert!(
            text.contains("0.0300 m/s² with it") && !text.contains("mm"),
            "{text}"
        );
    }
}
