//! Rows of a report: the result of each check.

use serde::{Deserialize, Serialize};

/// Outcome of a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Every error is within the tolerance.
    Holds,
    /// An error exceeds the tolerance.
    Refuted,
    /// The check does not apply to this model; the detail says why.
    Skipped,
    /// The check applies and could not be made, or not for all of the model; the detail says why. The model is then not
    /// verified.
    Unverified,
}

/// Measure of a check's errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Measure {
    /// Relative to the sum of the magnitudes of the terms that make up the value.
    Relative,
    /// Units in the last place.
    Ulp,
    /// Units in the last place of the sum of the magnitudes of the terms that make up the value.
    Magnitude,
    /// Number of faults.
    Count,
}

/// Result of one check of a model.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Name of the check.
    pub check: &'static str,
    /// Number of points or cases.
    pub cases: usize,
    /// Largest error over the cases, in units of `measure`.
    pub worst: f64,
    /// Kind of measure of `worst` and `tolerance`.
    pub measure: Measure,
    /// Largest error that is allowed, in units of `measure`.
    pub tolerance: f64,
    /// Outcome of the check.
    pub verdict: Verdict,
    /// Location of the worst error, or the reason of a skip; may have several lines.
    pub detail: String,
    /// What the check leaves out of a model that it lets through; stated below the table.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub remark: Option<String>,
}

impl Row {
    /// Row of a check that holds if its worst relative error is at most `tolerance`.
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
            remark: None,
        }
    }

    /// Row of a check that holds if the list of faults is empty; `holds` is then its detail.
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
            remark: None,
        }
    }

    /// Row of a check that applies to the model and could not be made, with the reason.
    pub fn unverified(check: &'static str, why: impl Into<String>) -> Self {
        Self {
            verdict: Verdict::Unverified,
            ..Self::skipped(check, why)
        }
    }

    /// Row of a check that does not apply to the model, with the reason.
    pub fn skipped(check: &'static str, why: impl Into<String>) -> Self {
        Self {
            check,
            cases: 0,
            worst: 0.0,
            measure: Measure::Count,
            tolerance: 0.0,
            verdict: Verdict::Skipped,
            detail: why.into(),
            remark: None,
        }
    }

    /// Adds a remark on what the check leaves out.
    pub fn remarking(mut self, remark: impl Into<String>) -> Self {
        self.remark = Some(remark.into());
        self
    }

    /// Replaces the detail of the row.
    pub fn saying(mut self, detail: impl Into<String>) -> Self {
        self.detail = detail.into();
        self
    }
}

/// Running maximum of an error, with the location where it occurred.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Worst {
    /// Largest error so far; infinite if any was NaN.
    pub error: f64,
    /// Description of where the largest error occurred.
    pub place: String,
}

impl Worst {
    /// Includes an error in the maximum; `place` is called only for a new maximum.
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
