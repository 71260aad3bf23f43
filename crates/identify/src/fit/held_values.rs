//! Test of the values that a user holds: each held coefficient is estimated in turn, from the fit with all of them held.

use super::{Fit, FitError, fit_within};
use crate::numbers::Digits;
use crate::options::FitOptions;
use crate::report::MAX_PRIOR_CONFLICT;
use dataset::Dataset;
use model_spec::model::Model;

/// Sentences on held coefficients whose value the data contradict: with the coefficient free, its estimate is more than
/// [`MAX_PRIOR_CONFLICT`] standard errors away. A coefficient that cannot be estimated too is not contradicted.
///
/// # Errors
/// [`FitError::Interrupted`] if the work is cancelled.
pub fn conflicts(
    model: &Model,
    dataset: &Dataset,
    options: &FitOptions<'_>,
    held: &Fit,
) -> Result<Vec<String>, FitError> {
    let mut conflicts = Vec::new();
    for (place, (name, _)) in options.fixed.iter().enumerate() {
        let Some((_, value)) = held.problem.fixed.iter().find(|(own, _)| own == name) else {
            continue;
        };
        let mut others = options.fixed.to_vec();
        others.remove(place);
        let freed = FitOptions {
            fixed: &others,
            profiles: &[],
            known_faults: Some(&held.report.data_faults),
            ..*options
        };
        let fit = match fit_within(model, dataset, &freed, Some(held)) {
            Err(FitError::Interrupted) => return Err(FitError::Interrupted),
            found => found.ok(),
        };
        let Some(free) = fit.and_then(|fit| fit.report.coefficients.get(name).cloned()) else {
            continue;
        };
        let error = free
            .std_error
            .max(free.std_error_cluster_robust.unwrap_or(0.0));
        let conflict = (free.value - value).abs() / error;
        if conflict > MAX_PRIOR_CONFLICT {
            let digits = Digits::of(free.value, error);
            conflicts.push(format!(
                "the data contradict the held value {name} = {value}: they give {}, {conflict:.1} standard errors away",
                digits.one(free.value)
            ));
        }
    }
    Ok(conflicts)
}
