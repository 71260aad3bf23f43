//! Page of the catalogue of effects: description, site, variables, null values and negligible sizes.

use std::fmt::Write;

use model_spec::SITES;
use model_spec::load::{EFFECTS, LoadError, MODELS, from_text, inspect};
use model_spec::model::{AppliedEffect, Model};
use model_spec::with_unit;

/// Effect of the catalogue with the models to which it applies.
#[derive(Clone, Debug, PartialEq)]
pub struct Listed {
    /// Name of the effect, with underscores.
    pub name: String,
    /// First sentence of the effect's documentation.
    pub says: String,
    /// Site of the model (force, moment, measurement) on which the effect acts.
    pub site: String,
    /// Variables on which the effect depends.
    pub variables: Vec<String>,
    /// Coefficients of the effect, followed by its states.
    pub parts: Vec<Part>,
    /// Literature source of the effect.
    pub source: String,
    /// Models to which the effect can be added.
    pub models: Vec<String>,
    /// Whether the effect is built in, rather than declared in a model's own file.
    pub built_in: bool,
}

/// Coefficient or state of an effect; values are in the unit given.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Name of the coefficient or state.
    pub name: String,
    /// Unit; `1` if dimensionless.
    pub unit: String,
    /// Null value: the value at which the effect is absent.
    pub null_value: String,
    /// Smallest departure from the null value that matters in practice.
    pub negligible: Option<String>,
    /// Whether the coefficient has a separate value for every flight.
    pub of_each_flight: bool,
}

/// Lists the effects that can be added to a model, or all built-in effects with the built-in models.
///
/// # Errors
/// If the model cannot be loaded.
pub fn listed(model: Option<&str>) -> Result<Vec<Listed>, LoadError> {
    let texts: Vec<(String, String)> = match model {
        None => MODELS
            .iter()
            .map(|(name, text)| (format!("{name}.hyz"), (*text).to_owned()))
            .collect(),
        Some(name) => {
            let loaded = inspect(name, &[])?;
            let source = loaded.sources.first();
            let text = source.map(|source| (source.name.clone(), source.text.clone()));
            text.into_iter().collect()
        }
    };
    let mut all: Vec<Listed> = Vec::new();
    for (name, text) in &texts {
        let plain = from_text(name, text, &[])?;
        let own = plain.offers.iter().map(|offer| offer.name.as_str());
        let own: Vec<&str> = own.collect();
        let built_in = EFFECTS.iter().map(|(name, _)| *name);
        let built_in = built_in.filter(|name| !own.contains(name));
        for wanted in own.iter().copied().chain(built_in) {
            // An effect made for another model cannot be added.
            let Ok(with) = from_text(name, text, &[wanted]) else {
                continue;
            };
            let Some(effect) = with.effects.first() else {
                continue;
            };
            let effect = Listed {
                built_in: !own.contains(&wanted),
                ..of(&with, effect)
            };
            let same = |known: &&mut Listed| {
                known.name == effect.name && known.built_in == effect.built_in
            };
            match all.iter_mut().find(same) {
                Some(known) => known.models.push(plain.name.clone()),
                None => all.push(effect),
            }
        }
    }
    let place = |effect: &Listed| SITES.iter().position(|site| *site == effect.site);
    all.sort_by(|a, b| (place(a), &a.name).cmp(&(place(b), &b.name)));
    Ok(all)
}

fn of(model: &Model, effect: &AppliedEffect) -> Listed {
    let coefficients = effect.coefficients.iter().map(|own| {
        let constant = &model.coefficients[own.index];
        Part {
            name: constant.name.clone(),
            unit: constant.unit_text.clone(),
            null_value: plain(own.null_value),
            negligible: own.smallest_of_interest.map(plain),
            of_each_flight: false,
        }
    });
    let states = effect.states.iter().map(|own| {
        let state = &model.states[own.index];
        Part {
            name: state.name.clone(),
            unit: state.unit_text.clone(),
            null_value: plain(own.null_value),
            negligible: own.smallest_of_interest.map(plain),
            of_each_flight: true,
        }
    });
    Listed {
        name: effect.name.clone(),
        says: sentence(&effect.doc),
        site: effect.site.clone(),
        variables: effect.variables.clone(),
        parts: coefficients.chain(states).collect(),
        source: effect.citation.clone(),
        models: vec![model.name.clone()],
        built_in: true,
    }
}

/// Formats a number without its unit, as in the summary of a model.
fn plain(value: f64) -> String {
    with_unit(value, "1")
}

/// First sentence of a documentation text, on one line.
fn sentence(doc: &str) -> String {
    let words: Vec<&str> = doc.split_whitespace().collect();
    let end = words.iter().position(|word| word.ends_with('.'));
    words[..end.map_or(words.len(), |end| end + 1)].join(" ")
}

/// Renders the catalogue page in Markdown.
pub fn page(effects: &[Listed], model: Option<&str>) -> String {
    let mut page = String::from("# The effects\n\n");
    match model {
        None => page.push_str(INTRODUCTION),
        Some(model) => {
            let _ = writeln!(page, "Those that can be switched on in {}.", cell(model));
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
    page
}

const INTRODUCTION: &str = "\
<!-- Written by `hyzer effects`; do not edit. -->

What may be missing from a model, one effect a row, by where it acts. `hyzer diagnose` looks for all that go with a model; `--with NAME`
switches one on in `check`, `verify`, `simulate`, `synthesize`, `fit` and `diagnose`. An effect is absent where each of its coefficients has the value
at which it vanishes, and a departure smaller than the negligible one does not matter in practice; both are in the unit that stands beside the
name. How effects are written, and what the words mean, is said in [the language](language.md#effects). This page is made by
`hyzer effects --out docs/effects.md`; `hyzer effects MODEL` lists those of one model, its own among them.
";

const HEAD: &str = "\
| effect | what it says | depends on | coefficient | vanishes at | negligible below | models | source |
|---|---|---|---|---|---|---|---|
";

fn row(page: &mut String, effect: &Listed, linked: bool) {
    let name = match linked {
        true => format!("[`{0}`](../model-spec/effects/{0}.hyz)", effect.name),
        false => format!("`{}`", effect.name),
    };
    let parts = effect.parts.iter().map(|part| {
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
    });
    let vanishes = effect.parts.iter().map(|part| part.null_value.clone());
    let negligible = effect.parts.iter().map(|part| {
        let size = part.negligible.clone();
        size.unwrap_or_else(|| "–".to_owned())
    });
    let _ = writeln!(
        page,
        "| {name} | {} | {} | {} | {} | {} | {} | {} |",
        cell(&effect.says),
        effect.variables.join(", "),
        stacked(parts),
        stacked(vanishes),
        stacked(negligible),
        effect.models.join(", "),
        cell(&effect.source),
    );
}

/// Joins lines within a table cell.
fn stacked(lines: impl Iterator<Item = String>) -> String {
    lines
        .map(|line| cell(&line))
        .collect::<Vec<_>>()
        .join("<br>")
}

/// Escapes a text for a Markdown table cell.
fn cell(text: &str) -> String {
    text.replace('|', "\\|")
        .replace('<', "&lt;")
        .replace('\n', " ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_effect_that_is_built_in_is_listed_with_what_it_takes() {
        let all = listed(None).unwrap();
        let mut names: Vec<&str> = all.iter().map(|effect| effect.name.as_str()).collect();
        names.sort_unstable();
        let wanted: Vec<&str> = EFFECTS.iter().map(|(name, _)| *name).collect();
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
