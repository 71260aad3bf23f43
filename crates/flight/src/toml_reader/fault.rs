//! Faults in a release file, with their locations.

use std::fmt;

/// Error for an invalid release file, with all faults of the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReleaseError {
    /// Name of the release file.
    pub file: String,
    /// Faults in order of location; at least one.
    pub faults: Vec<Fault>,
}

/// A single fault in a release file, which contains the initial conditions of a flight.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Line and column, from 1, in characters; `None` for a fault of the whole file.
    pub location: Option<(usize, usize)>,
    /// What was found and what was expected, as a sentence.
    pub message: String,
}

impl ReleaseError {
    pub(super) fn new(file: &str, mut faults: Vec<Fault>) -> Self {
        faults.sort_by_key(|fault| fault.location);
        let file = file.to_owned();
        Self { file, faults }
    }
}

impl fmt::Display for ReleaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, fault) in self.faults.iter().enumerate() {
            let newline = if i > 0 { "\n" } else { "" };
            match fault.location {
                Some((line, column)) => write!(
                    f,
                    "{newline}{}:{line}:{column}: {}",
                    self.file, fault.message
                )?,
                None => write!(f, "{newline}{}: {}", self.file, fault.message)?,
            }
        }
        Ok(())
    }
}

impl std::error::Error for ReleaseError {}

/// End of a message on an unknown name: `; did you mean "…"?` if a valid one is similar, otherwise all valid names.
pub fn suggestion<'a>(found: &str, names: impl Iterator<Item = &'a str> + Clone) -> String {
    let near = names
        .clone()
        .map(|name| (distance(found, name), name))
        .min();
    match near {
        Some((distance, name)) if is_near(distance, name.chars().count()) => {
            format!("; did you mean {name:?}?")
        }
        Some(_) => format!("; expected one of {}", names.collect::<Vec<_>>().join(", ")),
        None => "; expected none".into(),
    }
}

/// Whether a name of `length` characters is meant by one at this distance: not every letter may be another.
fn is_near(distance: usize, length: usize) -> bool {
    distance <= 1 + length / 4 && distance < length
}

/// Levenshtein distance between two strings, in characters, ignoring case.
fn distance(a: &str, b: &str) -> usize {
    // Bounds the cost on hostile input; valid names are shorter.
    if a.len() > 64 {
        return a.len();
    }
    let b: Vec<char> = b.to_lowercase().chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.to_lowercase().chars().enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], i + 1);
        for (j, y) in b.iter().enumerate() {
            let change = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = change.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn similar_names_are_suggested() {
        let names = ["theta", "thetadot", "C_La"];
        assert_eq!(
            suggestion("thetadott", names.into_iter()),
            "; did you mean \"thetadot\"?"
        );
        assert_eq!(
            suggestion("c_la", names.into_iter()),
            "; did you mean \"C_La\"?"
        );
        assert_eq!(
            suggestion("banana", names.into_iter()),
            "; expected one of theta, thetadot, C_La"
        );
    }
}
