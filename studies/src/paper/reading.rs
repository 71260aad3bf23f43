//! Readings of the paper's tables: combinations of hypotheses on their meaning.

use super::columns::{Columns, PRINTED, describe, interchanges};
use super::conventions::Conventions;

/// One interpretation of Table 1 of the paper (Hubbard & Hummel, 2000): a combination of hypotheses on its signs, units
/// and columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Reading {
    /// Signs and units that this interpretation of Table 1 of Hubbard & Hummel (2000) assumes.
    pub conventions: Conventions,
    /// Order of the lift and drag columns in Table 1 of Hubbard & Hummel (2000) that this interpretation assumes for
    /// flight fssh3.
    pub fssh3: Columns,
    /// Order of the lift and drag columns in Table 1 of Hubbard & Hummel (2000) that this interpretation assumes for
    /// flight bffl8.
    pub bffl8: Columns,
}

impl Reading {
    /// Interpretation of Table 1 of Hubbard & Hummel (2000) as printed, without any hypothesis.
    pub const PRINTED: Self = Self {
        conventions: Conventions::PRINTED,
        fssh3: PRINTED,
        bffl8: PRINTED,
    };

    /// Number of hypotheses, that is of assumed deviations from the printed Table 1 of Hubbard & Hummel (2000). An
    /// interchange of columns that applies to both flights counts once.
    pub fn hypotheses(&self) -> usize {
        let columns = if self.fssh3 == self.bffl8 {
            interchanges(self.fssh3)
        } else {
            interchanges(self.fssh3) + interchanges(self.bffl8)
        };
        columns + self.conventions.hypotheses().len()
    }

    /// Descriptions (of `self`, of `other`) of the difference between two interpretations of Table 1 of Hubbard &
    /// Hummel (2000). If they differ only in signs and units, each description is the one hypothesis that the other
    /// interpretation lacks, or "as printed" if there is none. If they differ only in the order of columns, it
    /// describes the order. `None` if they differ in both, or if one has several hypotheses that the other lacks.
    pub(super) fn difference(&self, other: &Self) -> Option<(String, String)> {
        let columns = |reading: &Self| {
            let reading = Self {
                conventions: Conventions::PRINTED,
                ..*reading
            };
            reading.description()
        };
        let without = |of: &Conventions, other: &Conventions| -> Vec<&'static str> {
            let mut hypotheses = of.hypotheses();
            hypotheses.retain(|hypothesis| !other.hypotheses().contains(hypothesis));
            hypotheses
        };
        let first = |hypotheses: &[&str]| hypotheses.first().unwrap_or(&"as printed").to_string();
        let here = without(&self.conventions, &other.conventions);
        let there = without(&other.conventions, &self.conventions);
        let same_columns = (self.fssh3, self.bffl8) == (other.fssh3, other.bffl8);
        match (same_columns, here.len(), there.len()) {
            (true, 0..=1, 0..=1) => Some((first(&here), first(&there))),
            (false, 0, 0) => Some((columns(self), columns(other))),
            _ => None,
        }
    }

    /// Describes the hypotheses (assumed deviations from the printed Table 1 of Hubbard & Hummel, 2000) of this
    /// interpretation; "as printed" if it has none.
    pub fn description(&self) -> String {
        let mut parts: Vec<String> = Vec::new();
        let mut columns = |flights: &str, order: Columns| {
            parts.extend(describe(order).map(|order| format!("{flights}: {order}")));
        };
        if self.fssh3 == self.bffl8 {
            columns("both flights", self.fssh3);
        } else {
            columns("fssh3", self.fssh3);
            columns("bffl8", self.bffl8);
        }
        let conventions = self.conventions.hypotheses();
        parts.extend(conventions.iter().map(|&hypothesis| hypothesis.to_owned()));
        if parts.is_empty() {
            "as printed".to_owned()
        } else {
            parts.join("; ")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_print_uses_no_hypothesis() {
        assert_eq!(Reading::PRINTED.hypotheses(), 0);
        assert_eq!(Reading::PRINTED.description(), "as printed");
        let swapped = Reading {
            fssh3: [1, 0, 2, 3],
            bffl8: [1, 0, 2, 3],
            ..Reading::PRINTED
        };
        assert_eq!(swapped.hypotheses(), 1);
        assert_eq!(swapped.description(), "both flights: C_L0 ↔ C_La");
    }
}
