//! Accepted explanations and the throw that would best distinguish them.

use diagnose::{Estimate, Explanation, ExplanationEffect, ProposedThrow, Report, Verdict};
use model_spec::compose::ModelTree;

use super::{DiagnosisPage, words};
use crate::equation::of_effect;
use crate::html::Html;
use crate::table::Table;
use crate::thin::MAX_FLIGHTS;
use identify::numbers::{
    Digits, equivalent_z, millimetres, percent, plain, probability, significant, stated, unit,
};
use identify::wording::{sentence, short};

/// The accepted explanations, best first, and the proposed throw.
pub(super) fn section(page: &DiagnosisPage<'_>) -> Html {
    let report = page.report;
    let number = report.explanations.len();
    let mut content = Html::new();
    if number == 0 {
        content.paragraph(match report.verdict {
            Verdict::Adequate => {
                "No effect of the catalogue is needed: the residuals are compatible with the noise."
            }
            Verdict::Unattributed if report.unattributed.is_some() => {
                "No effect of the catalogue explains the residuals; see the section on terms outside it."
            }
            Verdict::Unattributed => "No effect of the catalogue explains the residuals.",
            _ => "No effect is named.",
        });
    }
    if number > 1 {
        let throw = match report.proposed_throw {
            Some(_) => "; a throw that would distinguish them is proposed below",
            None => "",
        };
        content.paragraph(format!(
            "These flights cannot distinguish the following explanations: each alone explains the residuals, and the \
             data reject none. The best is first{throw}."
        ));
    }
    let shown = report.explanations.iter().take(MAX_FLIGHTS);
    for (i, found) in shown.enumerate() {
        let mut name = words::readable(&found.name());
        if number > 1 {
            name = format!("{}. {name}", i + 1);
        }
        content.element("div", "card", card(page, found, &name));
    }
    if number > MAX_FLIGHTS {
        let more = number - MAX_FLIGHTS;
        content.note(format!("{more} more explanations are in report.json."));
    }
    if let Some(next) = &report.proposed_throw {
        content.element_with_id("div", "next-throw", "card", throw(next));
    }
    content
}

fn card(page: &DiagnosisPage<'_>, explanation: &Explanation, name: &str) -> Html {
    let is_joint = explanation.effects.len() > 1;
    let mut card = Html::from("\n");
    card.heading(name);
    for effect in &explanation.effects {
        let mut text = Html::new();
        if is_joint {
            text = Html::strong(words::readable(&effect.name)).then(": ");
        }
        card.paragraph(text.then(effect.sentence()));
        for equation in equations(page, &effect.name) {
            card.scrolled("div", "equation", Html::trusted(equation));
        }
    }
    card.table(&estimates(explanation));
    card.note(share(page.report, explanation));
    card
}

/// Sentences on what the explanation takes away, and what remains.
pub(super) fn share(report: &Report, explanation: &Explanation) -> String {
    let is_joint = explanation.effects.len() > 1;
    let with = if is_joint { "them" } else { "it" };
    let mut explained = String::new();
    if explanation.explained_fraction > 0.0 {
        let left = explanation.remaining_rms_m;
        let left = match &report.lack_of_fit {
            Some(test) if !test.has_length => {
                format!("{} times the noise", significant(left / test.noise_m, 2))
            }
            _ => format!("{} rms", millimetres(left)),
        };
        explained = format!(
            " It explains {} of the misfit; {left} remain beyond the noise.",
            percent(explanation.explained_fraction)
        );
    }
    let remaining = match &explanation.strongest_remaining {
        Some(effect) => format!(
            "The strongest remaining effect is {} (p = {}).",
            effect.name,
            probability(effect.p_value)
        ),
        None => "No other effect remains.".to_owned(),
    };
    format!(
        "With {with} the weighted sum of squares falls by {}.{explained} {remaining}",
        significant(explanation.chi2_decrease, 4)
    )
}

/// Equations that an effect adds or replaces, as MathML: in the extended model, or in the model with this effect alone.
fn equations(page: &DiagnosisPage<'_>, name: &str) -> Vec<String> {
    let Some(fits) = &page.fits else {
        return Vec::new();
    };
    let identifier = diagnose::identifier(name);
    let extended = fits.after.map(|fit| &*fit.problem().model);
    let found = extended.map_or_else(Vec::new, |model| of_effect(model, &identifier));
    if !found.is_empty() {
        return found;
    }
    let tree = ModelTree::of(&fits.before.problem().model);
    let alone = tree.with_named([&identifier]).and_then(|tree| tree.check());
    alone.map_or_else(|_| Vec::new(), |model| of_effect(&model, &identifier))
}

/// Table of the coefficients of an explanation; an effect without coefficients has one row.
pub(super) fn estimates(explanation: &Explanation) -> Table {
    let is_joint = explanation.effects.len() > 1;
    let mut rows: Vec<(&ExplanationEffect, Option<(&String, &Estimate)>)> = Vec::new();
    for effect in &explanation.effects {
        let estimates = effect.estimates.iter();
        rows.extend(estimates.map(|estimate| (effect, Some(estimate))));
        if effect.estimates.is_empty() {
            rows.push((effect, None));
        }
    }
    let digits = |e: &Estimate| Digits::of(e.value, e.std_error);
    let site = |effect: &ExplanationEffect| {
        let mut site = Html::from(words::site(&effect.site));
        if effect.negligible {
            site.push(" ");
            site.push(Html::tag("below the smallest effect of interest"));
        }
        site
    };
    let variables = |effect: &ExplanationEffect| {
        let names = short(&effect.variables.join(", "));
        Some(names).filter(|names| !names.is_empty())
    };
    let interest = |e: &Estimate| e.smallest_effect_of_interest.map_or("–".to_owned(), stated);
    let unit = |e: &Estimate| unit(&e.unit);
    Table::of(rows)
        .when(is_joint, |rows| {
            rows.name("effect", |(effect, _)| &effect.name)
        })
        .plain("coefficient", |(_, e)| e.map(|(name, _)| name.clone()))
        .number("value", |(_, e)| e.map(|(_, e)| digits(e).one(e.value)))
        .number("standard error", |(_, e)| {
            e.map(|(_, e)| digits(e).one(e.std_error))
        })
        .plain("unit", |(_, e)| {
            e.map_or_else(String::new, |(_, e)| unit(e))
        })
        .number("smallest effect of interest", |(_, e)| {
            e.map_or_else(String::new, |(_, e)| interest(e))
        })
        .plain("acts on", |(effect, _)| site(effect))
        .text("depends on", |(effect, _)| variables(effect))
        .number("score χ²", |(effect, _)| {
            significant(effect.score_chi2, 4)
        })
        .table()
        .stacked()
}

fn throw(next: &ProposedThrow) -> Html {
    let degrees = |radians: f64| format!("{}°", plain(radians.to_degrees(), 1));
    let speed = format!("{}\u{a0}m/s", plain(next.speed, 1));
    let spin = format!("{}\u{a0}rpm", plain(next.spin / flight::throw::RPM, 0));
    let hyzer = "hyzer angle (tilt about the velocity, positive: left edge lower)";
    let quantities = [
        ("speed", speed),
        (
            "launch angle (velocity above the horizontal)",
            degrees(next.launch),
        ),
        ("nose angle (angle of attack)", degrees(next.nose)),
        (hyzer, degrees(next.hyzer)),
        ("spin (positive: clockwise from above)", spin),
        (
            "heading, from the x axis to the left",
            degrees(next.heading),
        ),
    ];
    let table = Table::of(&quantities)
        .name("", |(name, _)| *name)
        .plain("", |(_, value)| value)
        .table();
    let mut card = Html::from("\n");
    card.heading("The next throw");
    card.paragraph(format!(
        "{} With it the smallest difference between two explanations would be {} standard deviations; it is {} now.",
        sentence(&next.description),
        equivalent_z(next.separation),
        equivalent_z(next.separation_now)
    ));
    card.table(&table);
    card
}
