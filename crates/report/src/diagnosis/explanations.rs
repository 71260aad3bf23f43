//! Tables of the accepted explanations and of the throw that would best
//! distinguish them.

use diagnose::{Explanation, ExplanationEffect, ProposedThrow};
use model_spec::compose::ModelTree;
use serde::Serialize;

use super::{DiagnosisPage, words};
use crate::equation::of_effect;
use crate::fit::flights::short;
use crate::fit::page::sentence;
use crate::numbers::{Digits, millimetres, percent, plain, significant, stated, unit};

/// Maximum number of explanations shown in the HTML report.
pub(super) const MAX_EXPLANATIONS: usize = 12;

/// Accepted explanation, with all values formatted as text.
#[derive(Serialize)]
pub(super) struct Section {
    name: String,
    /// Decrease of the weighted sum of squared residuals, χ², when the effects of the explanation are added to the
    /// model; formatted.
    chi2_decrease: String,
    /// Fraction of the misfit beyond noise that the explanation explains, and RMS of the remaining residuals in excess
    /// of the noise, both formatted; `None` if not computed.
    explained_fraction: Option<[String; 2]>,
    /// The most significant of the candidate effects outside the explanation, tested in the model that includes the
    /// effects of the explanation: name and formatted p-value. `None` if no such candidate can be tested.
    strongest_remaining: Option<[String; 2]>,
    effects: Vec<Effect>,
    /// Table rows of the coefficients of the effects that the explanation adds to the model.
    rows: Vec<Row>,
}

#[derive(Serialize)]
struct Effect {
    name: String,
    doc: String,
    /// Equations that the effect adds to the model or replaces, as MathML.
    equations: Vec<String>,
}

#[derive(Serialize)]
struct Row {
    /// Name of the effect, and number of table rows that the effect occupies. `None` in all rows of an effect but its
    /// first.
    effect: Option<(String, usize)>,
    site: String,
    variables: String,
    score_chi2: String,
    coefficient: String,
    value: String,
    error: String,
    unit: String,
    smallest_effect_of_interest: String,
    is_negligible: bool,
}

/// Formats the accepted explanations of the report, best fit first; at most [`MAX_EXPLANATIONS`].
pub(super) fn explanations(page: &DiagnosisPage<'_>) -> Vec<Section> {
    let explanations = page.report.explanations.iter().take(MAX_EXPLANATIONS);
    explanations.map(|found| section(page, found)).collect()
}

/// Equations that the effect called `name` adds to the model or replaces, as MathML. They are taken from the extended
/// model or, if it lacks the effect, from the model extended by this effect only. Empty if the fits are not available.
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

fn section(page: &DiagnosisPage<'_>, explanation: &Explanation) -> Section {
    let remaining = explanation.strongest_remaining.as_ref();
    let effects = explanation.effects.iter().map(|e| Effect {
        name: words::readable(&e.name),
        equations: equations(page, &e.name),
        doc: match e.description.trim() {
            "" => "It has no description.".to_owned(),
            doc => sentence(&doc.replace('\n', " ")),
        },
    });
    Section {
        name: words::readable(&words::explanation(explanation)),
        chi2_decrease: significant(explanation.chi2_decrease, 4),
        explained_fraction: (explanation.explained_fraction > 0.0).then(|| {
            [
                percent(explanation.explained_fraction),
                millimetres(explanation.remaining_rms_m),
            ]
        }),
        strongest_remaining: remaining.map(|r| [r.name.clone(), words::probability(r.p_value)]),
        effects: effects.collect(),
        rows: explanation.effects.iter().flat_map(rows).collect(),
    }
}

fn rows(effect: &ExplanationEffect) -> Vec<Row> {
    let span = effect.estimates.len().max(1);
    let empty = || Row {
        effect: None,
        site: words::site(&effect.site).to_owned(),
        variables: if effect.variables.is_empty() {
            "–".to_owned()
        } else {
            short(&effect.variables.join(", "))
        },
        score_chi2: significant(effect.score_chi2, 4),
        coefficient: "–".to_owned(),
        value: "–".to_owned(),
        error: "–".to_owned(),
        unit: String::new(),
        smallest_effect_of_interest: String::new(),
        is_negligible: effect.negligible,
    };
    let found = effect.estimates.iter().map(|(name, e)| {
        let digits = Digits::of(e.value, e.std_error);
        Row {
            coefficient: name.clone(),
            value: digits.one(e.value),
            error: digits.one(e.std_error),
            unit: unit(&e.unit),
            smallest_effect_of_interest: e
                .smallest_effect_of_interest
                .map_or("–".to_owned(), stated),
            ..empty()
        }
    });
    let mut all: Vec<Row> = found.collect();
    if all.is_empty() {
        all.push(empty());
    }
    all[0].effect = Some((effect.name.clone(), span));
    all
}

/// Throw that the diagnosis proposes as the next measurement, formatted as text.
#[derive(Serialize)]
pub(super) struct Throw {
    description: String,
    /// Launch conditions of the throw (speed, angles, spin): pairs of name and formatted value.
    rows: Vec<(&'static str, String)>,
    separation: String,
    separation_now: String,
}

/// Formats the throw that would best distinguish the explanations, in the
/// quantities common for disc throws.
pub(super) fn throw(next: &ProposedThrow) -> Throw {
    let degrees = |radians: f64| format!("{}°", plain(radians.to_degrees(), 1));
    let rpm = plain(next.spin / flight::throw::RPM, 0);
    Throw {
        description: sentence(&next.description),
        rows: vec![
            ("speed", format!("{}\u{a0}m/s", plain(next.speed, 1))),
            (
                "launch angle (velocity above the horizontal)",
                degrees(next.launch),
            ),
            ("nose angle (angle of attack)", degrees(next.nose)),
            (
                "hyzer angle (tilt about the velocity, positive: left edge lower)",
                degrees(next.hyzer),
            ),
            (
                "spin (positive: clockwise from above)",
                format!("{rpm}\u{a0}rpm"),
            ),
            (
                "heading, from the x axis to the left",
                degrees(next.heading),
            ),
        ],
        separation: words::equivalent_z(next.separation),
        separation_now: words::equivalent_z(next.separation_now),
    }
}
