//! Names that are not there.

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

/// The known name with the fewest differences, if they are few.
pub(super) fn nearest(wanted: &str, known: &[String]) -> Option<String> {
    let lower = wanted.to_lowercase();
    let allowed = wanted.chars().count().div_ceil(3);
    known
        .iter()
        .map(|name| {
            let starts = wanted.len() >= 3 && name.starts_with(wanted);
            let inside = name.ends_with(&format!(" {wanted}")) || *name == format!("der({wanted})");
            let near = starts || inside || name.to_lowercase() == lower;
            (if near { 0 } else { distance(wanted, name) }, name)
        })
        .filter(|&(distance, _)| distance <= allowed)
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, name)| name.clone())
}

/// Letters to insert, drop or exchange.
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().take(64).collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().take(64).enumerate() {
        let mut corner = row[0];
        row[0] = i + 1;
        for (j, &y) in b.iter().enumerate() {
            let change = corner + usize::from(x != y);
            corner = row[j + 1];
            row[j + 1] = change.min(row[j] + 1).min(corner + 1);
        }
    }
    row[b.len()]
}
