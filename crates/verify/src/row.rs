//! Rows of a report: the result of each check.

use std::sync::OnceLock;

use comfy_table::{ContentArrangement, Table};
use nalgebra::Vector3;
use oracle::PhysicalRate;
use serde::{Deserialize, Serialize};

/// Verdict of a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Every error is within the tolerance, and the check found no fault.
    Holds,
    /// An error exceeds the tolerance, or the check found a fault.
    Refuted,
    /// The check does not apply to this model.
    Skipped,
    /// The check applies but could not be carried out for the whole model, so the model is not verified.
    Unverified,
}

impl Verdict {
    /// [`Self::Holds`] if `holds`, otherwise [`Self::Refuted`].
    pub fn of(holds: bool) -> Self {
        if holds { Self::Holds } else { Self::Refuted }
    }

    /// Verdict in words for messages.
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
    /// Error relative to the sum of the magnitudes of the terms of the value.
    Relative,
    /// Spacing of f64 numbers at the compared value.
    Ulp,
    /// Spacing of f64 numbers at the sum of the magnitudes of the terms of the value.
    Magnitude,
    /// Number of faults.
    Count,
}

/// Result of one check of a model.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Name of the check in reports.
    pub check: &'static str,
    /// Number of tested points or other items, such as flights or check cases.
    pub cases: usize,
    /// Maximum error over all tested points or cases, in the unit given by `measure`.
    pub worst: f64,
    /// Unit of `worst` and `tolerance`.
    pub measure: Measure,
    /// Maximum error that is allowed, in the unit given by `measure`.
    pub tolerance: f64,
    /// Verdict of the check.
    pub verdict: Verdict,
    /// Place of the maximum error, faults, or reason why the check was not made; may have several lines.
    pub detail: String,
    /// What the check does not cover, printed below the table.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub remark: Option<String>,
}

impl Row {
    /// Result of a check that holds if its maximum relative error is at most `tolerance`.
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

    /// Result of a check that holds, with the detail `holds`, if there are no faults.
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

    /// Result of a check that could not be carried out, with the reason.
    pub fn unverified(check: &'static str, why: impl Into<String>) -> Self {
        Self {
            verdict: Verdict::Unverified,
            ..Self::skipped(check, why)
        }
    }

    /// Result of a check that does not apply to the model, with the reason.
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

    /// The result with the remark `remark`.
    pub fn with_remark(mut self, remark: impl Into<String>) -> Self {
        self.remark = Some(remark.into());
        self
    }

    /// The result with the detail `detail`.
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
    /// Replaces the maximum if `error` is larger; `place` is called only then.
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

/// Width of the tables, characters.
static WIDTH: OnceLock<u16> = OnceLock::new();

/// States the width of the terminal that tables are to fit, once for a process; 150 characters without it.
pub fn set_table_width(characters: u16) {
    WIDTH.get_or_init(|| characters);
}

/// Creates a text table with the given header, without colours; long cells are wrapped.
pub(crate) fn plain_table(header: &[&str]) -> Table {
    let mut table = Table::new();
    table.load_style(comfy_table::presets::ASCII_MARKDOWN);
    table
        .set_content_arrangement(ContentArrangement::Dynamic)
        .set_width(WIDTH.get().copied().unwrap_or(150));
    table.set_header(header.to_vec());
    table
}

/// Relative differences of the rates of two bodies, by name of the quantity.
pub fn rate_differences(a: &PhysicalRate, b: &PhysicalRate) -> [(&'static str, f64); 4] {
    let turning = (a.angular_acceleration, b.angular_acceleration);
    [
        ("velocity", (a.velocity, b.velocity)),
        ("acceleration", (a.acceleration, b.acceleration)),
        ("angular velocity", (a.angular_velocity, b.angular_velocity)),
        ("angular acceleration", turning),
    ]
    .map(|(what, (a, b))| (what, relative_difference(a, b)))
}

/// Norm of the difference of two vectors, relative to the sum of their norms and 1, SI: far below a typical fault.
pub fn relative_difference(a: Vector3<f64>, b: Vector3<f64>) -> f64 {
    (a - b).norm() / (a.norm() + b.norm() + 1.0)
}
