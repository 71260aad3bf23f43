//! What was checked and what came out, as a table and as JSON.

use crate::refute::Refutation;
use comfy_table::{Attribute, Cell, ContentArrangement, Table};
use serde::Serialize;

/// How a check ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// It holds.
    Holds,
    /// It does not.
    Refuted,
    /// It cannot be made of this model; the detail says why.
    Skipped,
}

/// What an error is measured in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Measure {
    /// Against the sum of the magnitudes of the terms that make up the value.
    Relative,
    /// Steps between neighbouring numbers.
    Ulp,
    /// Faults, counted.
    Count,
}

/// One check.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// What was checked.
    pub check: &'static str,
    /// At how many points or in how many cases.
    pub cases: usize,
    /// The worst error.
    pub worst: f64,
    /// What it is measured in.
    pub measure: Measure,
    /// The greatest error allowed.
    pub tolerance: f64,
    /// How it ended.
    pub verdict: Verdict,
    /// Where the worst was, or why; more lines where there is more to say.
    pub detail: String,
}

impl Row {
    /// A check by its worst error, which must be a number no greater than `tolerance`.
    pub fn judged(check: &'static str, cases: usize, worst: &Worst, tolerance: f64) -> Self {
        let holds = worst.error <= tolerance;
        Self {
            check,
            cases,
            worst: worst.error,
            measure: Measure::Relative,
            tolerance,
            verdict: if holds {
                Verdict::Holds
            } else {
                Verdict::Refuted
            },
            detail: worst.place.clone(),
        }
    }

    /// A check by the faults that it found.
    pub fn counted(check: &'static str, cases: usize, faults: &[String], holds: &str) -> Self {
        Self {
            check,
            cases,
            worst: faults.len() as f64,
            measure: Measure::Count,
            tolerance: 0.0,
            verdict: if faults.is_empty() {
                Verdict::Holds
            } else {
                Verdict::Refuted
            },
            detail: if faults.is_empty() {
                holds.to_owned()
            } else {
                faults.join("\n")
            },
        }
    }

    /// A check that cannot be made.
    pub fn skipped(check: &'static str, why: impl Into<String>) -> Self {
        Self {
            check,
            cases: 0,
            worst: 0.0,
            measure: Measure::Count,
            tolerance: 0.0,
            verdict: Verdict::Skipped,
            detail: why.into(),
        }
    }

    /// The same with something else to say.
    pub fn saying(mut self, detail: impl Into<String>) -> Self {
        self.detail = detail.into();
        self
    }
}

/// The worst error so far, and where it was.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Worst {
    /// The error; infinite where something was no number.
    pub error: f64,
    /// Where.
    pub place: String,
}

impl Worst {
    /// Takes note of an error.
    pub fn see(&mut self, error: f64, place: impl FnOnce() -> String) {
        let error = if error.is_nan() { f64::INFINITY } else { error };
        if error > self.error {
            *self = Self {
                error,
                place: place(),
            };
        }
    }
}

/// Everything that was checked of one model.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// The model's name.
    pub model: String,
    /// Seed of every random number.
    pub seed: u64,
    /// One row a check.
    pub rows: Vec<Row>,
    /// Stated equations that the reference refuses, and the terms that are at fault.
    pub refuted: Vec<Refutation>,
    /// What became of the mutants, where they were made.
    pub mutants: Option<crate::mutants::MutationMatrix>,
}

impl Report {
    /// Whether nothing was refuted.
    pub fn holds(&self) -> bool {
        self.rows.iter().all(|row| row.verdict != Verdict::Refuted)
    }

    /// The table for people.
    pub fn table(&self) -> String {
        let mut table = plain_table(&[
            "check",
            "cases",
            "worst error",
            "allowed",
            "verdict",
            "detail",
        ]);
        for row in &self.rows {
            let verdict = match row.verdict {
                Verdict::Holds => Cell::new("holds"),
                Verdict::Refuted => Cell::new("REFUTED").add_attribute(Attribute::Bold),
                Verdict::Skipped => Cell::new("skipped"),
            };
            let [worst, allowed] = match (row.verdict, row.measure) {
                (Verdict::Skipped, _) => [String::new(), String::new()],
                (_, Measure::Count) => [format!("{:.0} faults", row.worst), String::from("0")],
                (_, Measure::Ulp) => [
                    format!("{:.0} ulp", row.worst),
                    format!("{:.0} ulp", row.tolerance),
                ],
                (_, Measure::Relative) => [
                    format!("{:.1e}", row.worst),
                    format!("{:.0e}", row.tolerance),
                ],
            };
            table.add_row(vec![
                Cell::new(row.check),
                Cell::new(row.cases),
                Cell::new(worst),
                Cell::new(allowed),
                verdict,
                Cell::new(&row.detail),
            ]);
        }
        let mut text = format!("{} (seed {})\n{table}\n", self.model, self.seed);
        for refuted in &self.refuted {
            text.push_str(&format!(
                "\n{}\n    {}\n",
                refuted.sentence(),
                refuted.equation
            ));
        }
        if let Some(kills) = &self.mutants {
            text.push('\n');
            text.push_str(&kills.table());
        }
        text
    }
}

/// A table without colours, whose long cells are wrapped.
pub(crate) fn plain_table(header: &[&str]) -> Table {
    let mut table = Table::new();
    table.load_style(comfy_table::presets::ASCII_MARKDOWN);
    table
        .set_content_arrangement(ContentArrangement::Dynamic)
        .set_width(150)
        .force_no_tty();
    table.set_header(header.to_vec());
    table
}
