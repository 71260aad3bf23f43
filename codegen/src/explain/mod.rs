//! One quantity or derivative from its line in the model to formula, generated code and cost.
//!
//! The formula of a derivative is the chain rule over the model's named quantities; the code is what the
//! compiler makes of that derivative alone. Both come from the same nodes.

mod chain;
mod code;
mod error;
mod find;
#[cfg(test)]
mod tests;

pub use error::ExplainError;

use crate::count::Count;
use model_spec::model::Model;
use std::fmt;

/// Where a quantity comes from and what becomes of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// What is explained: `alpha`, `der(u)`, `force aero`.
    pub quantity: String,
    /// What it is differentiated by, if anything.
    pub wrt: Option<String>,
    /// File and line: `disc.hyz:58`.
    pub place: String,
    /// The lines of its declaration; for what is derived by Newton's and Euler's laws, the body's.
    pub line: String,
    /// Its `///` lines.
    pub doc: String,
    /// The quantity as a formula in LaTeX, `left = right`; one for each component where there is none in vectors.
    pub latex: Vec<String>,
    /// With a derivative: it, and then the derivatives of named quantities that it mentions.
    pub derivative: Vec<String>,
    /// Generated statements that run once per flight, since they depend on parameters alone.
    pub once: String,
    /// Generated statements, in order.
    pub code: String,
    /// Operations of [`Explanation::once`].
    pub cost_once: Count,
    /// Operations of [`Explanation::code`].
    pub cost: Count,
}

/// Explains a quantity (a named one, a component of it such as `air_velocity_1`, a force, a moment, `der(u)`),
/// or its derivative by a state, a parameter, a coefficient or a component of an input.
pub fn explain(
    model: &Model,
    quantity: &str,
    wrt: Option<&str>,
) -> Result<Explanation, ExplainError> {
    let found = find::quantity(model, quantity)?;
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
