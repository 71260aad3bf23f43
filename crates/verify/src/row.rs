//! Rows of a report: the result of each check.

use serde::{Deserialize, Serialize};

/// Verdict of a check: whether it holds, is refuted, does not apply or could not be carried out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Every error is within the tolerance, and the check found no fault.
    Holds,
    /// An error exceeds the tolerance, or the check found a fault.
    Refuted,
    /// The check does not apply to this model; the detail of the result gives the reason.
    Skipped,
    /// The check applies but could not be carried out, or not for the whole model; the detail of the result gives the
    /// reason. The model is then not verified.
    Unverified,
}

impl Verdict {
    /// Verdict of a check that was carried out for the whole model: [`Self::Holds`] if `holds`, otherwise
    /// [`Self::Refuted`].
    pub fn of(holds: bool) -> Self {
        if holds { Self::Holds } else { Self::Refuted }
    }

    /// Verdict in words for messages: `holds`, `refuted`, `skipped` or `not verified`.
    pub fn words(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::Refuted => "refuted",
            Self::Skipped => "skipped",
            Self::Unverified => "not verified",
        }
    }
}

/// Unit in which the errors of a check are expressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Measure {
    /// Absolute error divided by the sum of the magnitudes of the terms that are added to give the value.
    Relative,
    /// Spacing of f64 numbers at the compared value.
    Ulp,
    /// Spacing of f64 numbers at the sum of the magnitudes of the terms that are added to give the value.
    Magnitude,
    /// Number of faults found, for a check that has no numerical error.
    Count,
}

/// Result of one check of a model.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Name of the check in reports.
    pub check: &'static str,
    /// Number of tested points or, for a check that does not draw points, of other tested items, such as flights or the
    /// check cases in the model file.
    pub cases: usize,
    /// Maximum error over all tested points or cases, in the unit given by `measure`.
    pub worst: f64,
    /// Unit of `worst` and `tolerance`.
    pub measure: Measure,
    /// Maximum error that is allowed, in the unit given by `measure`.
    pub tolerance: f64,
    /// Whether the check holds, is refuted, does not apply or could not be carried out.
    pub verdict: Verdict,
    /// Where the maximum error occurred, which faults were found, or why the check was skipped or could not be carried
    /// out; may have several lines.
    pub detail: String,
    /// What the check does not cover for this model, printed below the table; `None` if there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub remark: Option<String>,
}

impl Row {
    /// Creates the result of a check that holds if its maximum relative error is at most `tolerance`.
    pub fn judged(check: &'static str, cases: usize, worst: &Worst, tolerance: f64) -> Self {
        Self {
            cases,
            worst: worst.error,
            measure: Measure::Relative,
            tolerance,
            verdict: Verdict::of(worst.error <= tolerance),
            ..Self::skipped(check, worst.place.clone())
        }
    }

    /// Creates the result of a check that holds if the list of faults is empty. The detail is the text `holds` in that
    /// case, otherwise the faults. `cases` is the number of points or cases that were tested.
    pub fn counted(check: &'static str, cases: usize, faults: &[String], holds: &str) -> Self {
        let detail = match faults {
            [] => holds.to_owned(),
            _ => faults.join("\n"),
        };
        Self {
            cases,
            worst: faults.len() as f64,
            verdict: Verdict::of(faults.is_empty()),
            ..Self::skipped(check, detail)
        }
    }

    /// Creates the result of a check that applies to the model but could not be carried out; `why` is the reason.
    pub fn unverified(check: &'static str, why: impl Into<String>) -> Self {
        Self {
            verdict: Verdict::Unverified,
            ..Self::skipped(check, why)
        }
    }

    /// Creates the result of a check that does not apply to the model; `why` is the reason.
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

    /// Returns the result with its remark set to a text on what the check does not cover.
    pub fn with_remark(mut self, remark: impl Into<String>) -> Self {
        self.remark = Some(remark.into());
        self
    }

    /// Returns the result of the check with its detail text replaced by `detail`.
    pub fn with_detail(mut self, detail: impl Into<String>) -> Self {
        self.detail = detail.into();
        self
    }
}

/// Running maximum of an error, with a description of where it occurred.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Worst {
    /// Maximum of all errors so far; infinite if any error was NaN.
    pub error: f64,
    /// Description of where the maximum error occurred.
    pub place: String,
}

impl Worst {
    /// Replaces the maximum if `error` is larger. `place` describes where the error occurred and is called only in this
    /// case.
    pub fn update(&mut self, error: f64, place: impl FnOnce() -> String) {
        let error = if error.is_nan() { f64::INFINITY } else { error };
        if error > self.error {
            *self = Self {
                error,
                place: place(),
            };
        }
    }
}
