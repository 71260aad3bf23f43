//! Pages of `docs/studies/`: Markdown templates rendered with the typed results of a study.

use minijinja::syntax::SyntaxConfig;
use minijinja::value::{Serde, Value};
use minijinja::{AutoEscape, Environment, UndefinedBehavior};
use serde::Serialize;

use crate::error::StudyError;

/// A rendered documentation page and its figures.
#[derive(Clone, Debug, PartialEq)]
pub struct Page {
    /// Text of the documentation page, as Markdown.
    pub text: String,
    /// File name, relative to the page, and SVG text of each figure.
    pub figures: Vec<(String, String)>,
}

impl Page {
    /// Renders a documentation page without figures from a minijinja template and the results of a study.
    pub(crate) fn without_figures(
        template: &str,
        results: impl Serialize,
    ) -> Result<Self, StudyError> {
        Ok(Self {
            text: render(template, results)?,
            figures: Vec::new(),
        })
    }
}

/// Text (an en dash) that a documentation page shows in place of a missing result.
const NONE: &str = "–";

/// Renders a template with results; the text ends in one line feed.
///
/// Filters: `three` (three significant digits), `percent` (a fraction, one decimal), `fixed(n)` and `signed(n)` (`n`
/// decimals), `plain` (shortest decimal). Each prints an en dash for `none`.
pub(crate) fn render(template: &str, results: impl Serialize) -> Result<String, StudyError> {
    let mut environment = Environment::new();
    environment.set_auto_escape_callback(|_| AutoEscape::None);
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    let syntax = SyntaxConfig::builder()
        .trim_blocks(true)
        .lstrip_blocks(true)
        .build()?;
    environment.set_syntax(syntax);
    environment.add_filter("three", |number: &Value| or_dash(number, three));
    environment.add_filter("percent", |number: &Value| {
        or_dash(number, |fraction| format!("{:.1} %", 100.0 * fraction))
    });
    environment.add_filter("fixed", |number: &Value, decimals: usize| {
        or_dash(number, |number| format!("{number:.decimals$}"))
    });
    environment.add_filter("signed", |number: &Value, decimals: usize| {
        or_dash(number, |number| format!("{number:+.decimals$}"))
    });
    environment.add_filter("plain", |number: &Value| {
        or_dash(number, |number| number.to_string())
    });
    let text = environment.render_str(template, Value::from(Serde(results)))?;
    Ok(text.trim_end().to_owned() + "\n")
}

/// Formats a number in a page template with the function `text`; returns an en dash if the value is `none`.
fn or_dash(number: &Value, text: impl Fn(f64) -> String) -> Result<String, minijinja::Error> {
    match number.is_none() {
        true => Ok(NONE.to_owned()),
        false => Ok(text(f64::try_from(number.clone())?)),
    }
}

/// Formats a value with three significant digits.
fn three(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let exponent = value.abs().log10().floor() as i32;
    if !(-3..5).contains(&exponent) {
        return format!("{value:.2e}");
    }
    format!("{value:.*}", (2 - exponent).max(0) as usize)
}

#[cfg(test)]
mod tests {
    use minijinja::context;

    use super::*;

    #[test]
    fn numbers_are_printed_with_the_digits_that_a_filter_states() {
        let text = "{{ a|three }} {{ b|three }} {{ c|percent }} {{ a|fixed(1) }} {{ a|signed(2) }} {{ d|plain }} {{ none|three }}";
        let results = context! { a => 12.345, b => 1.5e-7, c => 0.9512, d => -0.00005 };
        let page = render(text, results).expect("a page");
        assert_eq!(page, "12.3 1.50e-7 95.1 % 12.3 +12.35 -0.00005 –\n");
    }

    #[test]
    fn a_result_that_is_missing_is_an_error() {
        assert!(render("{{ absent|three }}", context! {}).is_err());
    }
}
