//! Equations as MathML, which browsers render without a script, and as plain text.

use codegen::latex;
use model_spec::model::Model;
use pulldown_latex::config::DisplayMode;
use pulldown_latex::{Parser, RenderConfig, Storage, push_mathml};

use identify::numbers::significant;

use crate::{Html, plain_formula};

/// Converts LaTeX to MathML on a line of its own; `None` if the LaTeX contains unsupported syntax.
pub(crate) fn mathml(latex: &str) -> Option<String> {
    converted(latex, DisplayMode::Block)
}

/// A sentence whose formulas are LaTeX between dollar signs, with plain formulas.
pub(crate) fn plain_sentence(text: &str) -> String {
    let parts = text.split('$').enumerate();
    let parts = parts.map(|(i, part)| match i % 2 {
        0 => part.to_owned(),
        _ => plain_formula(part),
    });
    parts.collect()
}

/// A sentence whose formulas are LaTeX between dollar signs, with MathML.
pub(crate) fn sentence(text: &str) -> Html {
    let mut html = Html::new();
    for (i, part) in text.split('$').enumerate() {
        let formula = match i % 2 {
            0 => None,
            _ => converted(part, DisplayMode::Inline),
        };
        match formula {
            Some(formula) => html.push(Html::trusted(formula)),
            None => html.push(part),
        }
    }
    html
}

fn converted(latex: &str, display_mode: DisplayMode) -> Option<String> {
    let storage = Storage::new();
    let mut text = String::new();
    let config = RenderConfig {
        display_mode,
        ..RenderConfig::default()
    };
    push_mathml(&mut text, Parser::new(latex, &storage), config).ok()?;
    // A parser that stops at an error writes the error into the text.
    let is_whole = !text.contains("<merror");
    // The space of LaTeX's `~` comes out escaped twice.
    is_whole.then(|| text.replace("&amp;nbsp;", "\u{a0}"))
}

/// Equations that an effect added or replaced, as MathML; empty if it is not switched on.
pub(crate) fn of_effect(model: &Model, effect: &str) -> Vec<String> {
    let Some(index) = model.effects.iter().position(|known| known.name == effect) else {
        return Vec::new();
    };
    let is_own = |of: Option<usize>| of == Some(index);
    let variables = model.aux_variables.iter().filter(|v| is_own(v.effect));
    let variables = variables.map(|v| v.name.clone());
    let forces = model.forces.iter().filter(|load| is_own(load.effect));
    let forces = forces.map(|load| format!("force {}", load.name));
    let moments = model.moments.iter().filter(|load| is_own(load.effect));
    let moments = moments.map(|load| format!("moment {}", load.name));
    let names = variables.chain(forces).chain(moments);
    let equations = names.filter_map(|name| latex::definition(model, &name));
    equations
        .filter_map(|latex| mathml(&rounded(&latex)))
        .collect()
}

/// Rounds the numbers in a LaTeX text to at most six significant digits, such as 0.139626 for 8 degrees in rad.
fn rounded(latex: &str) -> String {
    let (mut text, mut number) = (String::new(), String::new());
    for c in latex.chars().chain(['\0']) {
        if c.is_ascii_digit() || (c == '.' && !number.is_empty()) {
            number.push(c);
            continue;
        }
        match number.parse::<f64>() {
            Ok(value) if number.len() > 8 => text += &significant(value, 6),
            _ => text += &number,
        }
        number.clear();
        text.extend(Some(c).filter(|c| *c != '\0'));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_equation_of_an_effect_is_mathml() {
        let model = model_spec::load::load("disc", &["stall"]).unwrap();
        let equations = of_effect(&model, "stall");
        assert_eq!(equations.len(), 1);
        assert!(equations[0].starts_with("<math") && equations[0].contains("<mi>max</mi>"));
        assert!(of_effect(&model, "wind").is_empty());
    }

    #[test]
    fn a_sentence_has_its_formulas_in_both_notations() {
        let text = r"the spin, $\nu^2 + 2a\delta > \kappa$: holds & <more>";
        assert_eq!(
            plain_sentence(text),
            "the spin, ν² + 2aδ > κ: holds & <more>"
        );
        let html = sentence(text);
        assert!(html.as_str().contains("<math") && html.as_str().contains("&amp; &lt;more&gt;"));
    }

    #[test]
    fn long_numbers_are_rounded() {
        assert_eq!(
            rounded(r"\alpha_0 - 0.13962634015954634^2"),
            r"\alpha_0 - 0.139626^2"
        );
    }

    /// Every equation of every built-in model and effect can be converted to MathML.
    #[test]
    fn all_equations_are_understood() {
        for (name, _) in model_spec::load::MODELS {
            let model = model_spec::load::load(name, &[]).unwrap();
            for variable in &model.aux_variables {
                let latex = latex::definition(&model, &variable.name).unwrap();
                assert!(mathml(&latex).is_some(), "{name}: {latex}");
            }
        }
        assert_eq!(mathml(r"\left( x"), None);
        let spaced = mathml(r"\mathrm{normal~load}").unwrap();
        assert!(
            spaced.contains('\u{a0}') && !spaced.contains("nbsp"),
            "{spaced}"
        );
    }
}
