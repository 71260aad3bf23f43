//! Names that are not there.

use model_spec::nearest_name;
use std::fmt;

/// Why nothing can be explained.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ExplainError {
    /// No such quantity.
    Quantity {
        /// What was asked for.
        wanted: String,
        /// What was probably meant.
        nearest: Option<String>,
        /// All there are.
        known: Vec<String>,
    },
    /// Nothing of that name to differentiate by.
    Wrt {
        /// What was asked for.
        wanted: String,
        /// What was probably meant.
        nearest: Option<String>,
        /// All there are.
        known: Vec<String>,
    },
    /// A force and a moment have this name.
    Ambiguous {
        /// What was asked for.
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

/// The known name that was probably meant: a part of a longer one, or the nearest.
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
