//! A compiled model as JSON: what other languages interpret, with the statements that the tape evaluates.
//!
//! The format is described in `docs/reference/ir.md`, and by the JSON Schema beside that page.

mod function;
mod header;
mod text;

use crate::compile::compile;
use model_spec::model::Model;

/// Name and version of the format, the value of `schema`.
pub const SCHEMA: &str = "hyzer.ir/1";

/// Error of writing a model as JSON.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum IrError {
    /// A constant of the model has no JSON.
    #[error(
        "model `{model}`: {place} contains {value}, which JSON cannot hold; expected finite numbers: change the constants of the model that it follows from"
    )]
    NotFinite {
        /// Name of the model.
        model: String,
        /// Function, table or declaration with the constant.
        place: String,
        /// Value of the constant: infinite, or not a number.
        value: f64,
    },
}

/// Compiles a model and returns it as JSON: names, units and default values, then the statements of each function.
/// Equal models give equal text.
///
/// # Errors
/// [`IrError`] if a constant of the model is not finite.
pub fn json(model: &Model) -> Result<String, IrError> {
    let compiled = compile(model);
    let written = || {
        let mut fields = header::fields(model, &compiled.layout)?;
        fields.extend(function::fields(&compiled)?);
        Ok(text::object(&fields, "\n") + "\n")
    };
    written().map_err(|text::NotFinite { place, value }| IrError::NotFinite {
        model: model.name.clone(),
        place,
        value,
    })
}
