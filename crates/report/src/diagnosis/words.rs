//! Sentences and formatted values of a diagnosis.

use diagnose::{
    Estimate, Explanation, ExplanationEffect, LackOfFit, PredictiveGain, Report, Verdict,
};
use identify::wording::count;

use crate::numbers::{Digits, millimetres, plain, raised, significant, unit};
use crate::wording::{names, sentence};

/// Name of a hypothesis on the explanation of a misfit: the joined names of its effects.
pub(super) fn explanation(explanation: &Explanation) -> String {
    let effects: Vec<&str> = explanation
        .effects
        .iter()
        .map(|e| e.name.as_str())
        .collect();
    let effects = names(&effects);
    match explanation.effects.len() {
        0 => "an explanation without effects".to_owned(),
        1 => effects,
        _ => format!("{effects} together"),
    }
}

/// Sentence on an effect, from its documentation.
pub(super) fn description(effect: &ExplanationEffect) -> String {
    match effect.description.trim() {
        "" => "It has no description.".to_owned(),
        doc => sentence(&doc.replace('\n', " ")),
    }
}

/// Estimate of a coefficient, such as `C_L0 = 0.188 ± 0.003 1/rad`.
pub(super) fn estimate(name: &str, e: &Estimate) -> String {
    let digits = Digits::of(e.value, e.std_error);
    let (value, error) = (digits.one(e.value), digits.one(e.std_error));
    let text = format!("{name} = {value} ± {error} {}", unit(&e.unit));
    text.trim_end().to_owned()
}

/// Name of an effect as words separated by spaces.
pub(super) fn readable(name: &str) -> String {
    name.replace(['-', '_'], " ")
}

/// Sentence that states the outcome (verdict) of the diagnosis.
pub(super) fn verdict(report: &Report) -> String {
    let first = report.explanations.first();
    match report.verdict {
        Verdict::Adequate => "No model error detected.".to_owned(),
        Verdict::Identified => match first {
            Some(found) if found.effects.len() > 1 => {
                format!(
                    "The model lacks {} effects, {}.",
                    found.effects.len(),
                    explanation(found)
                )
            }
            Some(found) => format!("The model lacks one effect: {}.", explanation(found)),
            None => "The model lacks an effect.".to_owned(),
        },
        Verdict::Ambiguous => match report.explanations.len() {
            0 | 1 => "The model lacks an effect, but these flights cannot show which.".to_owned(),
            n => format!(
                "The model lacks one of {n} effects; these flights cannot distinguish them."
            ),
        },
        Verdict::Unattributed => {
            "The model lacks an effect that is not in the catalogue.".to_owned()
        }
        Verdict::Negligible => match first {
            Some(found) => format!(
                "The model lacks an effect below the smallest size of interest: {}.",
                explanation(found)
            ),
            None => "The model lacks an effect below the smallest size of interest.".to_owned(),
        },
    }
}

/// Name of the outcome (verdict) of a diagnosis, as written in `report.json` and on the terminal, and used as CSS
/// class.
pub fn verdict_name(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Adequate => "adequate",
        Verdict::Identified => "identified",
        Verdict::Ambiguous => "ambiguous",
        Verdict::Unattributed => "unattributed",
        Verdict::Negligible => "negligible",
    }
}

/// Sentences on the reduction of the prediction error of held-out flights by the effects added to the model, or the
/// reason why it was not measured.
pub(super) fn gain(report: &Report) -> String {
    let Some(gain) = &report.predictive_gain else {
        return match report.extended_model {
            Some(_) => "The gain on flights that were not fitted could not be measured.".to_owned(),
            None => "The model is not extended.".to_owned(),
        };
    };
    let after = millimetres(gain.rms_after_m);
    let before = millimetres(gain.rms_before_m);
    let how = match (gain.held_out_by_dataset, gain.flights) {
        (true, 0) => "On held-out flights".to_owned(),
        (true, 1) => "On the one held-out flight".to_owned(),
        (true, n) => format!("On {n} held-out flights"),
        (false, n) => format!("By cross-validation over {}", count(n, "flight")),
    };
    let first = "in the first part already, on which the initial state is fitted,";
    let without = match gain.without {
        0 => String::new(),
        1 => format!(" One of them contradicts it {first} and is predicted without it."),
        n => format!(" {n} of them contradict it {first} and are predicted without it."),
    };
    format!(
        "{how} the RMS prediction error per coordinate is {before} without the extension and {after} with it: a gain of \
         {}.{without} The noise, {}, is the lower limit of any model.",
        gained(gain),
        millimetres(gain.noise_m)
    )
}

/// Sentence that compares, flight by flight, the prediction errors without and with the effects added to the model;
/// `None` if no flight is compared or left out of the comparison.
pub fn paired(gain: &PredictiveGain) -> Option<String> {
    let compared = gain.improved + gain.worsened;
    if compared == 0 && gain.set_apart.is_empty() {
        return None;
    }
    let mut text = String::new();
    if compared > 0 {
        text = format!(
            "{} of {} improve{} (sign test p = {}); the median RMS error over flights changes from {} to {}.",
            gain.improved,
            count(compared, "flight"),
            if gain.improved == 1 { "s" } else { "" },
            probability(gain.sign_test_p_value),
            millimetres(gain.median_before_m),
            millimetres(gain.median_after_m)
        );
    }
    if !gain.set_apart.is_empty() {
        let files = names(&gain.set_apart);
        text += &format!(" Set apart, because no model follows them, and not counted: {files}.");
    }
    Some(text.trim_start().to_owned())
}

/// Sentence on the result of the lack-of-fit test.
pub fn lack_of_fit(test: &LackOfFit) -> String {
    let p = probability(test.p_value);
    let floor = millimetres(test.noise_m);
    match test.largest_misfits.is_empty() {
        true => format!(
            "The residuals are compatible with noise of {floor} (lack-of-fit test, p = {p})."
        ),
        false => format!(
            "The residuals are not noise (lack-of-fit test, p = {p}): {} rms remain beyond the noise of {floor}.",
            millimetres(test.beyond_noise_m)
        ),
    }
}

/// Formats the reduction of the RMS prediction error by the effects added to the model, with its standard error, such
/// as `19.4 ± 0.4 mm`.
pub(super) fn gained(gain: &PredictiveGain) -> String {
    let value = 1e3 * (gain.rms_before_m - gain.rms_after_m);
    let error = 1e3 * gain.std_error_m;
    let digits = Digits::of(value, error);
    if error.is_finite() && error > 0.0 {
        format!("{} ± {}\u{a0}mm", digits.one(value), digits.one(error))
    } else {
        millimetres(value / 1e3)
    }
}

/// Readable name of a site (component of the model that an effect changes, such as a force, a moment or a clock); the
/// name in the model language if it has no other.
pub(super) fn site(site: &str) -> &str {
    match site {
        "side" => "side force",
        "roll" => "rolling moment",
        "pitch" => "pitching moment",
        "spin" => "moment about the axis",
        "vertical" => "the measured vertical",
        "scale" => "the measured lengths",
        "clock" => "the clock",
        "marker" => "the markers’ places",
        other => other,
    }
}

/// Formats a p-value; `–` if it is not between 0 and 1.
pub(super) fn probability(p: f64) -> String {
    if !(0.0..=1.0).contains(&p) {
        "–".to_owned()
    } else if p >= 1e-3 {
        plain(p, if p < 0.0995 { 3 } else { 2 })
    } else if p > 1e-300 {
        significant(p, 2)
    } else {
        format!("less than 10{}", raised(-300))
    }
}

/// Formats a p-value given as its natural logarithm, which may represent a value below the range of `f64`.
pub(super) fn probability_of_ln(ln_p_value: f64) -> String {
    if ln_p_value.is_nan() || ln_p_value > 0.0 {
        return "–".to_owned();
    }
    if ln_p_value > -20.0 {
        return probability(ln_p_value.exp());
    }
    let power = ln_p_value / std::f64::consts::LN_10;
    if power < -1e9 {
        return "0".to_owned();
    }
    format!("10{}", raised(power.round() as i32))
}

/// Formats a standard normal quantile z, such as the one that is equivalent to the p-value of a test: with one decimal
/// below 99.95, without decimals above.
pub(super) fn equivalent_z(value: f64) -> String {
    plain(value, usize::from(value.abs() < 99.95))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn probabilities_are_written_however_small() {
        for (p, text) in [
            (0.314, "0.31"),
            (0.0042, "0.004"),
            (0.0, "less than 10⁻³⁰⁰"),
            (f64::NAN, "–"),
            (2.0, "–"),
        ] {
            assert_eq!(probability(p), text);
        }
        assert_eq!(probability(1.234e-5), "1.2 · 10⁻⁵");
        assert_eq!(probability_of_ln(-2302.585), "10⁻¹⁰⁰⁰");
        assert_eq!(probability_of_ln(0.314_f64.ln()), "0.31");
        assert_eq!(probability_of_ln(f64::NEG_INFINITY), "0");
    }
}
