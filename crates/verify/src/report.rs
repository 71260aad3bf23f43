//! Report of a verification, as a table and as JSON.

use crate::refute::Refutation;
use crate::row::plain_table;
pub use crate::row::{Measure, Row, Verdict, Worst};
use comfy_table::Cell;
use serde::{Deserialize, Serialize};

/// Combined outcome of all checks of one model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// Every check that applies to the model was carried out and holds.
    Verified,
    /// No check was refuted, but at least one applicable check could not be carried out.
    NotVerified,
    /// At least one check found that the model or its code is wrong.
    Refuted,
}

impl Outcome {
    /// Combined outcome of checks; not verified if there is none.
    pub(crate) fn of(verdicts: impl Iterator<Item = Verdict>) -> Self {
        let outcomes = verdicts.map(|verdict| match verdict {
            Verdict::Holds | Verdict::Skipped => Self::Verified,
            Verdict::Unverified => Self::NotVerified,
            Verdict::Refuted => Self::Refuted,
        });
        outcomes.max().unwrap_or(Self::NotVerified)
    }

    /// Outcome in words for messages.
    pub(crate) fn words(self) -> &'static str {
        match self {
            Self::Verified => "verified",
            Self::NotVerified => "NOT VERIFIED",
            Self::Refuted => "REFUTED",
        }
    }
}

/// Results of all checks of one model.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Name of the verified model.
    pub model: String,
    /// Seed of all random numbers of the verification.
    pub seed: u64,
    /// Results of the checks, one entry per check.
    pub rows: Vec<Row>,
    /// Equations that disagree with the reference law or the laws of motion, with corrections if any were found.
    pub refuted: Vec<Refutation>,
    /// Results of mutation testing; `None` if not requested.
    pub mutants: Option<crate::mutants::MutationMatrix>,
}

impl Report {
    /// Whether no check was refuted; checks that could not be carried out are allowed.
    pub fn holds(&self) -> bool {
        self.rows.iter().all(|row| row.verdict != Verdict::Refuted)
    }

    /// Combined outcome of all checks.
    pub fn outcome(&self) -> Outcome {
        Outcome::of(self.rows.iter().map(|row| row.verdict))
    }

    /// Names of the checks that apply to the model but could not be carried out.
    pub fn unverified(&self) -> Vec<&'static str> {
        let rows = self.rows.iter();
        rows.filter(|row| row.verdict == Verdict::Unverified)
            .map(|row| row.check)
            .collect()
    }

    /// Formats the report as a text table with one row per check, followed by remarks, refuted equations and mutants.
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
                Verdict::Refuted => Cell::new("REFUTED"),
                Verdict::Skipped => Cell::new("skipped"),
                Verdict::Unverified => Cell::new("NOT VERIFIED"),
            };
            let [worst, allowed] = match (row.verdict, row.measure) {
                (Verdict::Skipped | Verdict::Unverified, _) => [String::new(), String::new()],
                (_, Measure::Count) => [format!("{:.0} faults", row.worst), String::from("0")],
                (_, Measure::Ulp) => [
                    format!("{:.0} ulp", row.worst),
                    format!("{:.0} ulp", row.tolerance),
                ],
                (_, Measure::Magnitude) => [
                    format!("{:.1} ulp", row.worst),
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
        let mut text = format!(
            "{} (seed {}): {}\n{table}\n",
            self.model,
            self.seed,
            self.outcome().words()
        );
        let open = self.unverified();
        if !open.is_empty() {
            text.push_str(&format!("\nNOT VERIFIED: {}\n", open.join(", ")));
        }
        for remark in self.rows.iter().filter_map(|row| row.remark.as_ref()) {
            text.push_str(&format!("\n{remark}\n"));
        }
        for refuted in &self.refuted {
            let (sentence, equation) = (refuted.sentence(), &refuted.equation);
            text.push_str(&format!("\n{sentence}\n    {equation}\n"));
        }
        if let Some(kills) = &self.mutants {
            text.push('\n');
            text.push_str(&kills.table());
        }
        text
    }
}
