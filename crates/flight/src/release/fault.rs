//! What is wrong with a release, and where.

use std::fmt;

/// A release that was refused, with everything that is wrong with it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReleaseError {
    /// The file's name.
    pub file: String,
    /// Every fault, in order of place.
    pub faults: Vec<Fault>,
}

/// One fault.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Line and column, from 1, in characters; none where the file as a whole is at fault.
    pub place: Option<(usize, usize)>,
    /// What was found and what was expected.
    pub message: String,
}

impl fmt::Display for ReleaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, fault) in self.faults.iter().enumerate() {
            let newline = if i > 0 { "\n" } else { "" };
            match fault.place {
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

/// Line and column, from 1, of a byte of a text.
pub(super) fn place(text: &str, byte: usize) -> (usize, usize) {
    let before = &text.as_bytes()[..byte.min(text.len())];
    let line_start = before
        .iter()
        .rposition(|b| *b == b'\n')
        .map_or(0, |i| i + 1);
    let line = 1 + before.iter().filter(|b| **b == b'\n').count();
    // Bytes that go on a character begin with the bits 10.
    let column = 1 + before[line_start..]
        .iter()
        .filter(|b| **b & 0xc0 != 0x80)
        .count();
    (line, column)
}

/// `; did you mean "…"?` for a name that is nearly one of these, else what they are.
pub(super) fn suggestion<'a>(found: &str, names: impl Iterator<Item = &'a str> + Clone) -> String {
    let near = names
        .clone()
        .map(|name| (distance(found, name), name))
        .min();
    match near {
        Some((distance, name)) if distance <= 1 + name.chars().count() / 4 => {
            format!("; did you mean {name:?}?")
        }
        Some(_) => format!("; expected one of {}", names.collect::<Vec<_>>().join(", ")),
        None => "; expected none".into(),
    }
}

/// How many letters must be put in, left out or changed, case not counted.
fn distance(a: &str, b: &str) -> usize {
    // Whoever writes more is not near any name.
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
    fn places_count_characters() {
        assert_eq!(place("a\nαβ = 1\n", 2), (2, 1));
        assert_eq!(place("a\nαβ = 1\n", 6), (2, 3));
        assert_eq!(place("a", 9), (1, 2));
    }

    #[test]
    fn near_names_are_suggested() {
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
