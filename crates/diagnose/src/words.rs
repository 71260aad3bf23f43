//! What was found, in plain words.

use crate::bench::Bench;
use crate::confirm::Tried;
use crate::outside::Written;
use crate::report::{Agreement, Cause, CauseEffect, Report, Term, Verdict};

/// The paragraph that a report begins with.
pub fn summary(report: &Report) -> String {
    let mut told = match report.verdict {
        Verdict::None => format!(
            "Nothing is found that the model {} lacks: none of {} effects that were looked for explains more than chance does.",
            report.model,
            report.candidates.len()
        ),
        Verdict::Named => format!(
            "The model {} lacks {}",
            report.model,
            told_cause(&report.causes[0])
        ),
        Verdict::Immaterial => format!(
            "The model {} lacks something real that is too small to matter: {}",
            report.model,
            told_cause(&report.causes[0])
        ),
        Verdict::Ambiguous => {
            let each: Vec<String> = report.causes.iter().map(named).collect();
            format!(
                "The model {} lacks something, and these flights cannot tell which of {} it is: {}. The best of them: {}",
                report.model,
                report.causes.len(),
                each.join("; "),
                told_cause(&report.causes[0])
            )
        }
        Verdict::Outside => match &report.outside {
            Some(outside) if !report.causes.is_empty() => format!(
                "The model {} lacks something that no effect of the catalogue explains. {} A term was written for it: {}.",
                report.model,
                outside.says,
                named(&report.causes[0])
            ),
            Some(outside) => format!(
                "The model {} lacks something that neither an effect of the catalogue nor a term of the grammar explains. {}",
                report.model, outside.says
            ),
            None => format!(
                "The model {} lacks something that no effect of the catalogue explains.",
                report.model
            ),
        },
    };
    if let Some(agreement) = &report.agreement {
        told.push_str(&agreed(agreement));
    }
    if let Some(gain) = &report.gain {
        let how = match gain.held_out_by_dataset {
            true => "flights that were held out",
            false => "flights that the fit had not seen",
        };
        told.push_str(&format!(
            " On {how} the error of prediction goes from {} to {} (the noise is {}).",
            millimetres(gain.held_out_rms_before_m),
            millimetres(gain.held_out_rms_after_m),
            millimetres(gain.noise_floor_m)
        ));
        if gain.without > 0 {
            told.push_str(&format!(
                " Of these {}, {} contradict it in their first part already, on which their initial state is fitted, and are predicted \
                 without it.",
                gain.flights, gain.without
            ));
        }
    }
    let moved: Vec<String> = report
        .coefficients
        .iter()
        .filter_map(|(name, c)| {
            let before = c.before?;
            let away = (c.value - before) / c.std_error;
            (away.abs() > 3.0)
                .then(|| format!("{name} from {} to {}", figures(before), figures(c.value)))
        })
        .collect();
    if !moved.is_empty() {
        told.push_str(&format!(
            " Without it the fit had bent other coefficients to make up for it: {}.",
            moved.join(", ")
        ));
    }
    told
}

/// How far flights agree on a cause that leaves more than noise.
fn agreed(agreement: &Agreement) -> String {
    let mut told = format!(
        " It is what {} flights agree on (the probability that chance does as much is at most {}).",
        agreement.flights,
        figures(agreement.chance),
    );
    if let Some(part) = agreement.part {
        told.push_str(&format!(
            " It explains {:.0} % of what is more than noise; what it leaves differs from flight to flight, and has no law among all \
             that was looked for. Standard errors are by the scatter of the flights.",
            100.0 * part
        ));
    }
    if !agreement.contradicting.is_empty() {
        told.push_str(&format!(
            " {} other flights contradict it and are left out: look at what was told of them beforehand ({}).",
            agreement.contradicting.len(),
            listed(&agreement.contradicting)
        ));
    }
    told
}

/// Names that are listed at most.
const LISTED: usize = 16;

fn listed(names: &[String]) -> String {
    match names.len().checked_sub(LISTED) {
        Some(more) if more > 0 => format!("{} and {more} more", names[..LISTED].join(", ")),
        _ => names.join(", "),
    }
}

fn named(cause: &Cause) -> String {
    let names: Vec<&str> = cause.effects.iter().map(|e| e.name.as_str()).collect();
    names.join(" with ")
}

fn told_cause(cause: &Cause) -> String {
    let each: Vec<String> = cause.effects.iter().map(told_effect).collect();
    each.join(" And ")
}

fn told_effect(effect: &CauseEffect) -> String {
    let values: Vec<String> = effect
        .estimates
        .iter()
        .map(|(name, e)| {
            let unit = if e.unit == "1" { "" } else { e.unit.as_str() };
            format!(
                "{name} = {} ± {} {unit}",
                figures(e.value),
                figures(e.std_error)
            )
            .trim_end()
            .to_owned()
        })
        .collect();
    let doc = effect.doc.replace('\n', " ");
    let doc = doc.trim().trim_end_matches('.');
    format!(
        "{} ({}): {doc}; {}.",
        effect.name,
        effect.site,
        values.join(", ")
    )
}

/// A number by three figures.
fn figures(value: f64) -> String {
    if value != 0.0 && (value.abs() < 1e-3 || value.abs() >= 1e4) {
        format!("{value:.2e}")
    } else if value.abs() >= 100.0 {
        format!("{value:.0}")
    } else if value.abs() >= 1.0 {
        format!("{value:.2}")
    } else {
        format!("{value:.4}")
    }
}

fn millimetres(value: f64) -> String {
    format!("{:.1} mm", 1e3 * value)
}

/// Why a cause that leaves only noise is not believed.
pub(crate) fn refused(tried: &Tried) -> String {
    let names = tried.extension.effects.join(" with ").replace('_', "-");
    let told = tried.gain.as_ref().map_or_else(String::new, |gain| {
        format!(
            " ({} without, {} with)",
            millimetres(gain.held_out_rms_before_m),
            millimetres(gain.held_out_rms_after_m)
        )
    });
    format!(
        "{names} would leave only noise of the flights that were fitted, but predicts others no better{told}: so supple an explanation \
         is not believed without"
    )
}

/// Where an error sits that no effect of the catalogue explains.
pub fn outside(terms: &Written) -> String {
    let taken: Vec<&Term> = terms.told.iter().filter(|term| term.taken).collect();
    let all: f64 = terms.told.first().map_or(0.0, |term| term.statistic);
    match taken.as_slice() {
        [] => format!(
            "No product of angle of attack, spin, speed, rates, height and time on one of the loads explains more than chance does \
             (the best by chi squared {all:.1})."
        ),
        _ => {
            let each: Vec<String> = taken
                .iter()
                .map(|term| format!("{} by {}", term.site, term.formula))
                .collect();
            let rest = if terms.stands {
                ""
            } else {
                " Something is left that they do not explain."
            };
            let beside = match terms.effects.as_slice() {
                [] => String::new(),
                effects => format!(
                    "Most of it looks like {}, but not all. ",
                    effects.join(" with ").replace('_', "-")
                ),
            };
            format!(
                "{beside}The error sits in {}.{rest}",
                each.join(", and in ")
            )
        }
    }
}

/// The evidence for a term, as the doc of the effect that is written for it.
pub fn evidence(dataset: &str, bench: &Bench, term: Option<&Term>) -> String {
    let flights = bench.observation_sets.len();
    let told = term.map_or_else(String::new, |term| {
        format!(
            " chi squared {:.0}, first estimate {} ± {}",
            term.statistic,
            figures(term.value),
            figures(term.std_error)
        )
    });
    format!(
        "Found in {flights} flights of {dataset}, where no effect of the catalogue explains them:{told}."
    )
}
