//! Errors of explanations: unknown or ambiguous names.

use model_spec::nearest_name;
use std::fmt;

/// Reason why a quantity or derivative cannot be explained.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ExplainError {
    /// No quantity has the requested name.
    Quantity {
        /// Name that the caller requested.
        wanted: String,
        /// Name of the quantity whose name is most similar to `wanted`; `None` if no quantity has a similar name.
        nearest: Option<String>,
        /// Names of all quantities of the model for which formulas and generated code can be shown.
        known: Vec<String>,
    },
    /// No symbol of this name, with respect to which to differentiate.
    Wrt {
        /// Name that the caller requested.
        wanted: String,
        /// Name of the symbol whose name is most similar to `wanted`; `None` if no symbol has a similar name.
        nearest: Option<String>,
        /// Names of all symbols of the model with respect to which a quantity can be differentiated.
        known: Vec<String>,
    },
    /// Both a force and a moment have the requested name.
    Ambiguous {
        /// Name that the caller requested.
        wanted: String,
    },
}

impl fmt::Display for ExplainError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (what, wanted, nearest, known) = match self {
            ExplainError::Ambiguous { wanted } => {
                return write!(
                    f,
                    "a force and a moment are called `{wanted}`: write `force {wanted}` or `moment {wanted}`"
                );
            }
            ExplainError::Quantity {
                wanted,
                nearest,
                known,
            } => ("quantity", wanted, nearest, known),
            ExplainError::Wrt {
                wanted,
                nearest,
                known,
            } => (
                "state, parameter, coefficient or component of an input",
                wanted,
                nearest,
                known,
            ),
        };
        write!(f, "there is no {what} `{wanted}`")?;
        if let Some(nearest) = nearest {
            write!(f, "; did you mean `{nearest}`?")?;
        }
        write!(f, "\nthere are: {}", known.join(", "))
    }
}

impl std::error::Error for ExplainError {}

/// Name most similar to `wanted`: one that contains it as a load, derivative or beginning, else the nearest by edits.
pub(super) fn nearest(wanted: &str, known: &[String]) -> Option<String> {
    let part = |name: &&String| {
        let starts = wanted.len() >= 3 && name.starts_with(wanted);
        starts || name.ends_with(&format!(" {wanted}")) || **name == format!("der({wanted})")
    };
    let near = || nearest_name(wanted, known.iter().map(String::as_str));
    known
        .iter()
        .find(part)
        .cloned()
        .or_else(|| near().map(str::to_owned))
}
