//! Catalogue page of the effects: description, site, variables, null values and smallest sizes of interest.

use std::fmt::Write;

use model_spec::SITES;
use model_spec::compose::{KnownEffect, ModelTree, Origin, Refused, known_effects};
use model_spec::load::{LoadError, MODELS, load};
use model_spec::model::{AppliedEffect, EffectUnknown, Model};
use model_spec::with_unit;

/// An effect, built in or declared in a model file, with the models to which it applies.
#[derive(Clone, Debug, PartialEq)]
pub struct Listed {
    /// Name of the effect, with underscores.
    pub name: String,
    /// First sentence of the documentation of the effect.
    pub says: String,
    /// Component of the model that the effect changes, such as `lift`, `pitch` or `clock`: one of [`SITES`].
    pub site: String,
    /// Kinds of variables on which the magnitude of the effect depends, such as `alpha` or `speed`: elements of
    /// `model_spec::VARIABLES`.
    pub variables: Vec<String>,
    /// Coefficients that the effect adds to a model, followed by the states that it adds.
    pub parts: Vec<Part>,
    /// Literature reference for the effect, as text.
    pub source: String,
    /// Names of the models, among those for which the list is made, for which a diagnosis tests the effect. Empty if
    /// more specific effects replace this effect for all of them.
    pub models: Vec<String>,
    /// Quantities that a model must define for the effect to be applied, with their units.
    pub needs: Vec<String>,
    /// More specific effects that replace this general effect: it is not tested for a model to which one of them
    /// applies.
    pub without: Vec<String>,
    /// Origin of the effect: declared in the model's file, built in, or generated for a differential equation that is
    /// written explicitly in the model file.
    pub origin: Origin,
}

/// Coefficient or state that an effect adds to a model; all values are in `unit`.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Name of the added coefficient or state.
    pub name: String,
    /// Unit of the coefficient or state, as text; `1` if dimensionless.
    pub unit: String,
    /// Null value of the coefficient or state, formatted: the value at which the effect is absent.
    pub null_value: String,
    /// Smallest effect size of interest, formatted: a smaller difference of the coefficient from its null value is
    /// negligible. `None` if the effect declares none.
    pub negligible: Option<String>,
    /// Whether each flight has its own value of the coefficient or state; otherwise one value applies to all flights.
    pub of_each_flight: bool,
}

/// An effect that a diagnosis does not test for a model, with the reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotOffered {
    /// Name of the effect, with underscores.
    pub name: String,
    /// Reason why a diagnosis does not test the effect, as text.
    pub why: String,
}

/// Lists the effects that a diagnosis tests for `model`, or, if `None`, all built-in effects with the built-in models
/// to which they apply.
///
/// # Errors
/// [`LoadError`] if the model cannot be loaded.
pub fn listed(model: Option<&str>) -> Result<Vec<Listed>, LoadError> {
    let names: Vec<&str> = match model {
        None => MODELS.iter().map(|(name, _)| *name).collect(),
        Some(name) => vec![name],
    };
    let mut all: Vec<Listed> = Vec::new();
    for name in names {
        // Effects on sensor readings are listed for a model with every instrument that it can carry.
        let plain = match model {
            None => load(name, &[])?.with_every_instrument(),
            Some(_) => load(name, &[])?,
        };
        let tree = ModelTree::of(&plain);
        for known in known_effects(&plain) {
            let is_offered = match known.refused {
                None => true,
                // A general effect is listed with its requirements, even if a specific one replaces it for this
                // model.
                Some(Refused::Covered { .. }) => false,
                Some(_) => continue,
            };
            if model.is_some() && !is_offered {
                continue;
            }
            if model.is_none() && known.origin == Origin::Equation {
                continue;
            }
            let with = tree.with(&known.effect)?.check()?;
            let Some(effect) = with.effects.last() else {
                continue;
            };
            let same =
                |listed: &&mut Listed| listed.name == effect.name && listed.origin == known.origin;
            let listed = match all.iter_mut().find(same) {
                Some(listed) => listed,
                None => {
                    all.push(of(&with, effect, &known));
                    let last = all.len() - 1;
                    &mut all[last]
                }
            };
            if is_offered {
                listed.models.push(plain.name.clone());
            }
        }
    }
    let place = |effect: &Listed| SITES.iter().position(|site| *site == effect.site);
    all.sort_by(|a, b| (place(a), &a.name).cmp(&(place(b), &b.name)));
    Ok(all)
}

/// Lists the effects that a diagnosis does not test for a model, with the reasons.
///
/// # Errors
/// [`LoadError`] if the model cannot be loaded.
pub fn not_offered(model: &str) -> Result<Vec<NotOffered>, LoadError> {
    let known = known_effects(&load(model, &[])?);
    let refused = known.into_iter().filter_map(|known| {
        Some(NotOffered {
            name: known.effect.name().to_owned(),
            why: known.refused?.to_string(),
        })
    });
    Ok(refused.collect())
}

fn of(model: &Model, effect: &AppliedEffect, known: &KnownEffect) -> Listed {
    let part = |own: &EffectUnknown, name: &str, unit: &str, of_each_flight: bool| Part {
        name: name.to_owned(),
        unit: unit.to_owned(),
        null_value: plain(own.null_value),
        negligible: own.smallest_effect_of_interest.map(plain),
        of_each_flight,
    };
    let coefficients = effect.coefficients.iter().map(|own| {
        let constant = &model.coefficients[own.index];
        part(own, &constant.name, &constant.unit_text, false)
    });
    let states = effect.states.iter().map(|own| {
        let state = &model.states[own.index];
        part(own, &state.name, &state.unit_text, true)
    });
    Listed {
        name: effect.name.clone(),
        says: sentence(&effect.doc),
        site: effect.site.clone(),
        variables: effect.variables.clone(),
        parts: coefficients.chain(states).collect(),
        source: effect.citation.clone(),
        models: Vec::new(),
        without: known.effect.generalises().map(str::to_owned).collect(),
        needs: known.effect.needs().map(ToString::to_string).collect(),
        origin: known.origin,
    }
}

/// Formats a number without a unit, because it is dimensionless or its unit is shown elsewhere. The text has as many
/// digits as needed to read the same number back, in exponential notation for magnitudes below 10⁻³.
fn plain(value: f64) -> String {
    with_unit(value, "1")
}

/// First sentence of a documentation text, joined to one line.
fn sentence(doc: &str) -> String {
    let words: Vec<&str> = doc.split_whitespace().collect();
    let end = words.iter().position(|word| word.ends_with('.'));
    words[..end.map_or(words.len(), |end| end + 1)].join(" ")
}

/// Renders the list of effects as a Markdown page. If `model` is given, the introduction names it. `not_offered` are
/// listed with their reasons at the end.
pub fn page(effects: &[Listed], model: Option<&str>, not_offered: &[NotOffered]) -> String {
    let mut page = String::from("# The effects\n\n");
    match model {
        None => page.push_str(INTRODUCTION),
        Some(model) => {
            let _ = writeln!(
                page,
                "Those that `hyzer diagnose` considers for {}, and that `--with NAME` switches on.",
                cell(model)
            );
        }
    }
    for site in SITES {
        let here: Vec<&Listed> = effects.iter().filter(|e| e.site == site).collect();
        if here.is_empty() {
            continue;
        }
        let _ = write!(page, "\n## {site}\n\n{HEAD}");
        for effect in here {
            row(&mut page, effect, model.is_none());
        }
    }
    if !not_offered.is_empty() {
        page.push_str("\n## Not considered\n\n| effect | why |\n|---|---|\n");
        for effect in not_offered {
            let _ = writeln!(page, "| `{}` | {} |", effect.name, cell(&effect.why));
        }
    }
    page
}

const INTRODUCTION: &str = "\
<!-- Written by `hyzer effects`; do not edit. -->

What may be missing from a model, one effect a row, by where it acts. An effect goes with every model that has what it needs: a body
for a force, one that turns for a moment, an observation, and quantities by name, kind and unit. The general effects go with any such
model, and are not considered where a specific one says the same. A model whose equations are stated has one effect more for each of them:
a rate that is missing, steady (`rate_of_X`), growing with time (`rate_of_X_by_time`) or in proportion to the state (`rate_of_X_by_itself`).
Forces of general effects are given over the mass, moments over a moment of inertia, so that what is negligible is so for any body: 0.003 m/s²,
0.03 % of gravity, 0.02 rad/s², a thousandth of a stated rate's unit in a second. `hyzer diagnose` looks for all that go with a model; `--with NAME`
switches one on in `check`, `verify`, `simulate`, `synthesize`, `fit` and `diagnose`. An effect is absent where each of its coefficients has the value
at which it vanishes, and a departure smaller than the negligible one does not matter in practice; both are in the unit that stands beside the
name. How effects are written, and what the words mean, is said in [the language](language.md#effects). This page is made by
`hyzer effects --out docs/reference/effects.md`; `hyzer effects MODEL` lists those of one model, its own among them.
";

const HEAD: &str = "\
| effect | what it says | depends on | coefficient | vanishes at | negligible below | needs | models | source |
|---|---|---|---|---|---|---|---|---|
";

fn row(page: &mut String, effect: &Listed, linked: bool) {
    let name = match linked {
        true => format!("[`{0}`](../../model-spec/effects/{0}.hyz)", effect.name),
        false => format!("`{}`", effect.name),
    };
    let part = |part: &Part| {
        let unit = match part.unit.as_str() {
            "1" => String::new(),
            unit => format!(" in {unit}"),
        };
        let each = if part.of_each_flight {
            ", of each flight its own"
        } else {
            ""
        };
        format!("`{}`{unit}{each}", part.name)
    };
    let negligible = |part: &Part| part.negligible.clone().unwrap_or_else(|| "–".to_owned());
    let parts = || effect.parts.iter();
    let _ = writeln!(
        page,
        "| {name} | {} | {} | {} | {} | {} | {} | {} | {} |",
        cell(&effect.says),
        effect.variables.join(", "),
        stacked(parts().map(part)),
        stacked(parts().map(|part| part.null_value.clone())),
        stacked(parts().map(negligible)),
        stacked(effect.needs.iter().map(|need| format!("`{need}`"))),
        models(effect),
        cell(&effect.source),
    );
}

/// Text on the models for which a diagnosis tests an effect: their names, or for a general effect any model without the
/// specific effects that replace it.
fn models(effect: &Listed) -> String {
    if effect.origin != Origin::General {
        return effect.models.join(", ");
    }
    let without: Vec<String> = effect.without.iter().map(|n| format!("`{n}`")).collect();
    match without.is_empty() {
        true => "any".to_owned(),
        false => format!("any without {}", without.join(", ")),
    }
}

/// Joins lines of text for one table cell, separated by HTML line breaks.
fn stacked(lines: impl Iterator<Item = String>) -> String {
    lines
        .map(|line| cell(&line))
        .collect::<Vec<_>>()
        .join("<br>")
}

/// Escapes a text for use in a Markdown table cell.
fn cell(text: &str) -> String {
    text.replace('|', "\\|")
        .replace('<', "&lt;")
        .replace('\n', " ")
}

#[cfg(test)]
mod tests {
    use model_spec::load::EFFECTS;

    use super::*;

    #[test]
    fn every_effect_that_is_built_in_is_listed_with_what_it_takes() {
        let all = listed(None).unwrap();
        let mut names: Vec<&str> = all.iter().map(|effect| effect.name.as_str()).collect();
        names.sort_unstable();
        let mut wanted: Vec<&str> = EFFECTS.iter().map(|(name, _)| *name).collect();
        wanted.sort_unstable();
        assert_eq!(names, wanted);
        for effect in &all {
            assert!(
                !effect.says.is_empty() && !effect.source.is_empty(),
                "{effect:?}"
            );
            assert!(
                !effect.variables.is_empty() && !effect.parts.is_empty(),
                "{effect:?}"
            );
            assert!(
                effect.parts.iter().all(|part| part.negligible.is_some()),
                "{effect:?}"
            );
        }
    }

    #[test]
    fn a_model_has_those_that_go_with_it() {
        let of_ball = listed(Some("ball")).unwrap();
        let has = |name: &str| of_ball.iter().any(|effect| effect.name == name);
        assert!(has("magnus") && !has("stall"));
        assert!(of_ball.iter().all(|effect| effect.models == ["ball"]));
        assert!(listed(Some("no such model")).is_err());
        let why = |name: &str| {
            let refused = not_offered("ball").unwrap();
            let found = refused.into_iter().find(|effect| effect.name == name);
            found.expect("not offered").why
        };
        assert_eq!(why("stall"), "it needs a number `C_L`");
        assert_eq!(why("stream_wind"), "`wind` says it of this model");
    }

    #[test]
    fn a_cell_stays_one_cell_and_a_sentence_one_sentence() {
        assert_eq!(cell("a | b\n<c>"), "a \\| b &lt;c>");
        assert_eq!(
            sentence("One of 0.5 m\nand more. Two."),
            "One of 0.5 m and more."
        );
    }
}
