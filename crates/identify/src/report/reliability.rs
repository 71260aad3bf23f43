//! Whether a fit can be relied on, with the reasons why not.

use super::{FitReport, FitStatus};
use crate::dataset::Role;
use crate::wording::count;

/// Share of the flights to be fitted above which their exclusion makes a fit unreliable.
const MAX_EXCLUDED: f64 = 1.0 / 3.0;

/// Reasons not to rely on a fit; empty for a reliable one.
pub(crate) fn reasons_against(report: &FitReport) -> Vec<String> {
    let mut reasons = Vec::new();
    reasons.extend(not_converged(report));
    reasons.extend(excluded_flights(report));
    reasons
}

fn not_converged(report: &FitReport) -> Option<String> {
    let steps = count(report.iterations.steps, "step");
    match report.iterations.status {
        FitStatus::Converged => None,
        FitStatus::Deadline => Some(format!(
            "the time limit was reached after {steps}, before the fit converged"
        )),
        FitStatus::MaxSteps | FitStatus::NoDescent | FitStatus::NoiseNotConverged => {
            Some(format!("the fit did not converge in {steps}"))
        }
    }
}

fn excluded_flights(report: &FitReport) -> Option<String> {
    let to_fit = report.flights.iter().filter(|f| f.role == Role::Fit);
    let (all, used) = (to_fit.count(), report.used(Role::Fit).count());
    let excluded = all - used;
    (excluded as f64 > MAX_EXCLUDED * all as f64).then(|| {
        format!(
            "{excluded} of {} to be fitted were left out",
            count(all, "flight")
        )
    })
}
