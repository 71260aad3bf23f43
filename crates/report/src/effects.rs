//! Catalogue page of the effects: description, site, variables, null values and smallest sizes of interest.

use std::fmt::Write;

use model_spec::compose::{KnownEffect, ModelTree, Origin, Refused, known_effects};
use model_spec::load::{LoadError, MODELS, load};
use model_spec::model::{AppliedEffect, EffectUnknown, Model};
use model_spec::{SITES, with_unit};

use crate::Table;
use crate::text::wrapped;

/// An effect, with the models for which a diagnosis tests it.
#[derive(Clone, Debug)]
pub struct Listed {
    known: KnownEffect,
    effect: AppliedEffect,
    /// Of each coefficient, then state: name and unit, value without the effect, and the smallest size of interest.
    parts: Vec<[String; 3]>,
    models: Vec<String>,
}

/// Effects that a diagnosis tests for `model`, or else all built-in ones with the built-in models to which they apply.
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
        let mut plain = load(name, &[])?;
        if model.is_none() {
            // Effects on sensor readings are listed for a model with every instrument that it can carry.
            plain = plain.with_every_instrument();
        }
        let tree = ModelTree::of(&plain);
        for known in known_effects(&plain) {
            // A general effect is listed with its requirements, even if a specific one replaces it for this model.
            let is_offered = known.refused.is_none();
            let is_covered = matches!(known.refused, Some(Refused::Covered { .. }));
            let is_listed = match model {
                Some(_) => is_offered,
                None => (is_offered || is_covered) && known.origin != Origin::Equation,
            };
            if !is_listed {
                continue;
            }
            let with = tree.with(&known.effect)?.check()?;
            let Some(effect) = with.effects.last() else {
                continue;
            };
            let is_same =
                |own: &Listed| own.effect.name == effect.name && own.known.origin == known.origin;
            let at = all.iter().position(is_same).unwrap_or(all.len());
            if at == all.len() {
                all.push(Listed {
                    parts: parts(&with, effect),
                    effect: effect.clone(),
                    known,
                    models: Vec::new(),
                });
            }
            if is_offered {
                all[at].models.push(plain.name.clone());
            }
        }
    }
    let place = |own: &Listed| SITES.iter().position(|site| *site == own.effect.site);
    all.sort_by(|a, b| (place(a), &a.effect.name).cmp(&(place(b), &b.effect.name)));
    Ok(all)
}

/// Names of the effects that a diagnosis does not test for a model, with the reasons.
///
/// # Errors
/// [`LoadError`] if the model cannot be loaded.
pub fn not_offered(model: &str) -> Result<Vec<(String, String)>, LoadError> {
    let known = known_effects(&load(model, &[])?).into_iter();
    let refused = known
        .filter_map(|known| Some((known.effect.name().to_owned(), known.refused?.to_string())));
    Ok(refused.collect())
}

fn parts(model: &Model, effect: &AppliedEffect) -> Vec<[String; 3]> {
    let part = |own: &EffectUnknown, name: &str, unit: &str, each: &str| {
        let unit = match unit {
            "1" => String::new(),
            unit => format!(" in {unit}"),
        };
        let interest = own.smallest_effect_of_interest;
        [
            format!("`{name}`{unit}{each}"),
            plain(own.null_value),
            interest.map_or_else(|| "–".to_owned(), plain),
        ]
    };
    let coefficients = effect.coefficients.iter().map(|own| {
        let constant = &model.coefficients[own.index];
        part(own, &constant.name, &constant.unit_text, "")
    });
    let states = effect.states.iter().map(|own| {
        let state = &model.states[own.index];
        part(
            own,
            &state.name,
            &state.unit_text,
            ", of each flight its own",
        )
    });
    coefficients.chain(states).collect()
}

/// A dimensionless number with as many digits as needed to read it back.
fn plain(value: f64) -> String {
    with_unit(value, "1")
}

/// First sentence of a text, on one line.
fn sentence(doc: &str) -> String {
    let words: Vec<&str> = doc.split_whitespace().collect();
    let end = words.iter().position(|word| word.ends_with('.'));
    words[..end.map_or(words.len(), |end| end + 1)].join(" ")
}

/// The effects as a Markdown page, with those that are not offered at the end.
pub fn page(effects: &[Listed], model: Option<&str>, not_offered: &[(String, String)]) -> String {
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
        let here: Vec<&Listed> = effects.iter().filter(|e| e.effect.site == site).collect();
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
        for (name, why) in not_offered {
            let _ = writeln!(page, "| `{name}` | {} |", cell(why));
        }
    }
    page
}

/// The effects as text for a terminal, with those that are not offered at the end.
pub fn text(effects: &[Listed], model: Option<&str>, not_offered: &[(String, String)]) -> String {
    let mut text = match model {
        None => "Built-in effects, by where they act".to_owned(),
        Some(model) => format!("Effects that a diagnosis of {model} considers, by where they act"),
    };
    text = wrapped(&format!("{text}; --with NAME switches one on."));
    for site in SITES {
        let here = effects.iter().filter(|e| e.effect.site == site);
        let rows = here.flat_map(|own| own.parts.iter().enumerate().map(move |part| (own, part)));
        let of_first = |(_, (i, _)): &(&Listed, (usize, &[String; 3])), text: String| match i {
            0 => text,
            _ => String::new(),
        };
        let part = |row: &(&Listed, (usize, &[String; 3])), at: usize| row.1.1[at].replace('`', "");
        let table = Table::of(rows)
            .name("effect", |row| of_first(row, row.0.effect.name.clone()))
            .text("what it says", |row| {
                of_first(row, sentence(&row.0.effect.doc))
            })
            .text("coefficient", |row| part(row, 0))
            .number("vanishes at", |row| part(row, 1))
            .number("negligible below", |row| part(row, 2))
            .table();
        if !table.is_empty() {
            text += &format!("\n{site}\n{}", table.text(usize::MAX));
        }
    }
    if !not_offered.is_empty() {
        let table = Table::of(not_offered)
            .name("effect", |(name, _)| name)
            .text("why", |(_, why)| why.replace('`', ""))
            .table();
        text += &format!("\nnot considered\n{}", table.text(usize::MAX));
    }
    text
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

fn row(page: &mut String, listed: &Listed, linked: bool) {
    let effect = &listed.effect;
    let mut name = format!("`{}`", effect.name);
    if linked {
        name = format!("[{name}](../../model-spec/effects/{}.hyz)", effect.name);
    }
    let parts = |at: usize| stacked(listed.parts.iter().map(|part| part[at].clone()));
    let needs = listed.known.effect.needs();
    let _ = writeln!(
        page,
        "| {name} | {} | {} | {} | {} | {} | {} | {} | {} |",
        cell(&sentence(&effect.doc)),
        effect.variables.join(", "),
        parts(0),
        parts(1),
        parts(2),
        stacked(needs.map(|need| format!("`{need}`"))),
        models(listed),
        cell(&effect.citation),
    );
}

/// Models for which a diagnosis tests an effect; any without the specific ones for a general effect.
fn models(listed: &Listed) -> String {
    if listed.known.origin != Origin::General {
        return listed.models.join(", ");
    }
    let without = listed.known.effect.generalises();
    let without: Vec<String> = without.map(|name| format!("`{name}`")).collect();
    if without.is_empty() {
        return "any".to_owned();
    }
    format!("any without {}", without.join(", "))
}

/// Lines in one cell.
fn stacked(lines: impl Iterator<Item = String>) -> String {
    let lines = lines.map(|line| cell(&line));
    lines.collect::<Vec<_>>().join("<br>")
}

fn cell(text: &str) -> String {
    let text = text.replace('|', "\\|").replace('<', "&lt;");
    text.replace('\n', " ")
}

#[cfg(test)]
mod tests {
    use model_spec::load::EFFECTS;

    use super::*;

    #[test]
    fn every_effect_that_is_built_in_is_listed_with_what_it_takes() {
        let all = listed(None).unwrap();
        let mut names: Vec<&str> = all.iter().map(|own| own.effect.name.as_str()).collect();
        names.sort_unstable();
        let mut wanted: Vec<&str> = EFFECTS.iter().map(|(name, _)| *name).collect();
        wanted.sort_unstable();
        assert_eq!(names, wanted);
        for own in &all {
            let effect = &own.effect;
            assert!(
                !sentence(&effect.doc).is_empty() && !effect.citation.is_empty(),
                "{own:?}"
            );
            assert!(
                !effect.variables.is_empty() && !own.parts.is_empty(),
                "{own:?}"
            );
            assert!(own.parts.iter().all(|part| part[2] != "–"), "{own:?}");
        }
    }

    #[test]
    fn a_model_has_those_that_go_with_it() {
        let of_ball = listed(Some("ball")).unwrap();
        let has = |name: &str| of_ball.iter().any(|own| own.effect.name == name);
        assert!(has("magnus") && !has("stall"));
        assert!(of_ball.iter().all(|effect| effect.models == ["ball"]));
        assert!(listed(Some("no such model")).is_err());
        let why = |name: &str| {
            let refused = not_offered("ball").unwrap();
            let found = refused.into_iter().find(|(own, _)| own == name);
            found.expect("not offered").1
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
