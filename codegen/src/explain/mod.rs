//! Explanation of one quantity or derivative: model source line, formula, generated code and operation count.
//!
//! Derivative formulas follow the chain rule over the model's auxiliary variables. The code is compiled for the
//! requested quantity or derivative alone. Formula and code derive from the same graph nodes.

mod chain;
mod code;
mod find;
#[cfg(test)]
mod tests;

pub use find::ExplainError;

use crate::count::Count;
use model_spec::model::Model;
use model_spec::syntax::spelling::joined;
use std::fmt;

/// Explanation of a quantity of a model or of its derivative: source, formulas, generated code and operation counts.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// Name of the explained quantity: `alpha`, `der(u)`, `force aero`.
    pub quantity: String,
    /// Symbol of the derivative; `None` if the quantity itself is explained.
    pub wrt: Option<String>,
    /// Source file and line of the declaration of the quantity, as in `disc.hyz:58`.
    pub place: String,
    /// Source lines of the declaration: that of the body for a derivative that follows from it.
    pub line: String,
    /// Doc comment (`///` lines) of the declaration of the quantity in the model file; may be empty.
    pub doc: String,
    /// LaTeX formula `left = right` of the quantity; one formula per component if there is no vector formula.
    pub latex: Vec<String>,
    /// LaTeX formulas of the derivative and of those to which it refers.
    pub derivative: Vec<String>,
    /// Generated statements that depend on parameters alone and run once per flight.
    pub once: String,
    /// Generated statements that run in every evaluation, in order.
    pub code: String,
    /// Operation count of the generated statements that run once per flight.
    pub cost_once: Count,
    /// Operation count of the generated statements that run in every evaluation.
    pub cost: Count,
}

/// Explains a quantity, such as `air_velocity_1` or `der(u)`, or its derivative with respect to a symbol.
pub fn explain(
    model: &Model,
    quantity: &str,
    wrt: Option<&str>,
) -> Result<Explanation, ExplainError> {
    let (quantity, wrt) = (joined(quantity), wrt.map(joined));
    let wrt = wrt.as_deref();
    let found = find::quantity(model, &quantity)?;
    let symbol = wrt.map(|wrt| find::symbol(model, wrt)).transpose()?;
    let by = symbol.zip(wrt);
    let made = code::generate(&found, by);
    let formulas = chain::formulas(model, &found, by);
    Ok(Explanation {
        quantity: found.label,
        wrt: wrt.map(str::to_string),
        place: found.place,
        line: found.line,
        doc: found.doc,
        latex: found.latex.map_or(formulas.values, |latex| vec![latex]),
        derivative: formulas.derivatives,
        once: made.once,
        code: made.code,
        cost_once: made.cost_once,
        cost: made.cost,
    })
}

impl fmt::Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.wrt {
            Some(wrt) => writeln!(f, "{} by {wrt}, {}", self.quantity, self.place)?,
            None => writeln!(f, "{}, {}", self.quantity, self.place)?,
        }
        for line in self.doc.lines() {
            writeln!(f, "    {}", format!("/// {}", line.trim()).trim_end())?;
        }
        indented(f, self.line.lines())?;
        writeln!(f, "\nformula")?;
        indented(f, self.latex.iter().map(String::as_str))?;
        if !self.derivative.is_empty() {
            writeln!(f, "\nderivative")?;
            indented(f, self.derivative.iter().map(String::as_str))?;
        }
        if !self.once.is_empty() {
            writeln!(f, "\ncode, once per flight: {}", self.cost_once)?;
            indented(f, self.once.lines())?;
        }
        writeln!(f, "\ncode: {}", self.cost)?;
        indented(f, self.code.lines())
    }
}

fn indented<'a>(f: &mut fmt::Formatter<'_>, lines: impl Iterator<Item = &'a str>) -> fmt::Result {
    for line in lines {
        writeln!(f, "{}", format!("    {line}").trim_end())?;
    }
    Ok(())
}
