//! Judges what a fit and a diagnosis say of a dataset.

use diagnose::{Report, Verdict};
use identify::{Fit, FitError};

use super::case::{Case, Group};
use super::recording::Recording;

/// Maximum error of an estimated coefficient, in standard errors, of a fit that is not confidently wrong.
pub(super) const MAX_Z: f64 = 4.0;

/// What a fit says of a dataset.
#[derive(Clone, Debug)]
pub struct Fitted {
    /// Whether the fit states that its estimates are reliable; false if it ended with an error.
    pub reliable: bool,
    /// Name of the estimated coefficient with the largest error, and this error in standard errors; infinite without a
    /// standard error. `None` if the fit ended with an error.
    pub worst: Option<(String, f64)>,
    /// Reasons why the estimates are not reliable, or the error that ended the fit.
    pub reasons: String,
    /// What hidden physics leaves in a fit of the flights without noise; only for a fit that is confidently wrong.
    pub misfit: Option<Misfit>,
    /// Whether the fit was cancelled at the limit of its time.
    pub interrupted: bool,
    /// Processor time of the fit on one thread, s.
    pub seconds: f64,
}

impl Fitted {
    pub(super) fn of(result: &Result<Fit, FitError>, recording: &Recording, seconds: f64) -> Self {
        let report = match result {
            Ok(fit) => &fit.report,
            Err(error) => {
                return Self {
                    reliable: false,
                    worst: None,
                    reasons: format!("no result: {}", error.to_string().replace('\n', " ")),
                    misfit: None,
                    interrupted: matches!(error, FitError::Interrupted),
                    seconds,
                };
            }
        };
        let errors = recording.truth.iter().filter_map(|(name, truth)| {
            let found = report.coefficients.get(name)?;
            let z = (found.value - truth).abs() / found.std_error;
            let z = if z.is_finite() { z } else { f64::INFINITY };
            (!found.fixed).then(|| (name.clone(), z))
        });
        Self {
            reliable: report.reliable,
            worst: errors.max_by(|a, b| a.1.total_cmp(&b.1)),
            reasons: report.cautions.join("; ").replace('\n', " "),
            misfit: None,
            interrupted: false,
            seconds,
        }
    }

    /// Whether no estimate is wrong by more than four standard errors.
    pub fn is_right(&self) -> bool {
        self.worst.as_ref().is_some_and(|(_, z)| *z <= MAX_Z)
    }

    /// Whether the fit states that it is reliable although an estimate is wrong.
    pub fn is_confidently_wrong(&self) -> bool {
        self.reliable && !self.is_right()
    }
}

/// Residuals of a fit of flights without noise.
#[derive(Clone, Copy, Debug)]
pub struct Misfit {
    /// Their root mean square, as a multiple of the noise.
    pub ratio: f64,
    /// Their sum of squares over the variance of the noise: the non-centrality of a score test for what is missing.
    pub chi2: f64,
}

/// What a diagnosis says of a dataset.
#[derive(Clone, Debug)]
pub struct Diagnosed {
    /// Verdict and names of the effects found, or the error that ended the diagnosis.
    pub answer: String,
    /// Whether the diagnosis identifies one cause that is not that of the dataset.
    pub is_wrong_cause: bool,
    /// Whether the diagnosis finds nothing although the hidden physics leaves residuals of more than twice the noise.
    pub is_false_all_clear: bool,
    /// What the hidden physics leaves in a fit of the flights without noise; `None` without hidden physics, or if that fit
    /// has no result.
    pub misfit: Option<Misfit>,
    /// Processor time of the diagnosis on one thread, s.
    pub seconds: f64,
}

/// Minimum RMS residual by hidden physics, as a multiple of the noise, that a diagnosis may not overlook.
const CLEAR: f64 = 2.0;

impl Diagnosed {
    pub(super) fn of(
        result: Result<Report, String>,
        case: &Case,
        cause: Option<&str>,
        misfit: Option<Misfit>,
        seconds: f64,
    ) -> Self {
        let mut found = Self {
            answer: String::new(),
            is_wrong_cause: false,
            is_false_all_clear: false,
            misfit,
            seconds,
        };
        let report = match result {
            Ok(report) => report,
            Err(error) => {
                found.answer = format!("no result: {}", error.replace('\n', " "));
                return found;
            }
        };
        let first = report.explanations.first();
        let effects = first.map_or(&[][..], |first| &first.effects);
        let mut names: Vec<String> = effects.iter().map(|e| e.name.replace('-', "_")).collect();
        names.sort();
        let sites: Vec<String> = effects.iter().map(|effect| effect.site.clone()).collect();
        let identified = report.verdict == Verdict::Identified;
        found.is_wrong_cause = identified && !case.is_cause(cause, &names, &sites);
        let is_clear = misfit.is_some_and(|misfit| misfit.ratio > CLEAR);
        let finds_nothing = report.verdict == Verdict::Adequate;
        found.is_false_all_clear = case.group() == Group::Hidden && finds_nothing && is_clear;
        let faults = report.data_faults.len();
        found.answer = format!("{:?}: {}", report.verdict, names.join(" + "));
        if !report.reliable {
            found.answer += "; not reliable";
        }
        if faults > 0 {
            found.answer += &format!("; {faults} faults in the data");
        }
        found
    }

    /// Whether the answer misleads a user.
    pub fn is_wrong(&self) -> bool {
        self.is_wrong_cause || self.is_false_all_clear
    }
}
