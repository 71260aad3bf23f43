//! Output-error fits of a model to a dataset.

use identify::dataset::Dataset;
use identify::{DataFault, FitOptions, FitReport};
use statrs::distribution::{ContinuousCDF, Normal};

use crate::{Error, Model};

/// Fits the coefficients of a model to the measured flights of a dataset, each flight with its own initial state, by
/// the output-error method: maximum likelihood with estimated noise.
///
/// # Errors
/// [`Error::Fit`].
pub fn fit(model: &Model, dataset: &Dataset, options: &FitOptions<'_>) -> Result<Fit, Error> {
    let fit = identify::fit(model.checked(), dataset, options)?;
    Ok(Fit { fit })
}

/// Result of a fit.
pub struct Fit {
    fit: identify::Fit,
}

impl Fit {
    /// Estimate of a coefficient, or of a freed parameter, by its name; `None` for an unknown name.
    pub fn coefficient(&self, name: &str) -> Option<Estimate> {
        let coefficient = self.fit.report.coefficients.get(name)?;
        Some(Estimate {
            value: coefficient.value,
            std_error: coefficient.std_error,
            unit: coefficient.unit.clone(),
            at_bound: coefficient.at_bound,
        })
    }

    /// Names and estimates of all coefficients and freed parameters, in alphabetical order.
    pub fn coefficients(&self) -> impl Iterator<Item = (&str, Estimate)> {
        let names = self.fit.report.coefficients.keys();
        names.filter_map(|name| Some((name.as_str(), self.coefficient(name)?)))
    }

    /// Root mean square residual of a measured coordinate over the fitted flights, m.
    pub fn rms(&self) -> f64 {
        self.fit.report.rms_m
    }

    /// Whether the iteration converged; estimates of a fit that did not are not reliable.
    pub fn converged(&self) -> bool {
        self.fit.report.iterations.converged
    }

    /// Whether the estimates can be relied on; [`Fit::reasons_against`] says why not.
    pub fn is_reliable(&self) -> bool {
        self.fit.report.reliable
    }

    /// Reasons not to rely on the estimates, such as flights that were excluded; empty for a reliable fit.
    pub fn reasons_against(&self) -> &[String] {
        &self.fit.report.why
    }

    /// Mistakes found in the measured data, such as exchanged markers or wrong units, each with its mend.
    pub fn data_faults(&self) -> &[DataFault] {
        &self.fit.report.data_faults
    }

    /// Complete report: noise, correlations, flights, coefficients that the flights do not determine.
    pub fn report(&self) -> &FitReport {
        &self.fit.report
    }

    /// Fit of the `identify` crate with its estimation problem, for predictions and residuals.
    pub fn inner(&self) -> &identify::Fit {
        &self.fit
    }
}

/// Estimated value with its standard error.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Maximum-likelihood estimate, SI.
    pub value: f64,
    /// Standard error (Cramér–Rao), SI; 0 where the value was fixed.
    pub std_error: f64,
    /// Unit, as the model writes it.
    pub unit: String,
    /// Whether the estimate lies on a bound of the model.
    pub at_bound: bool,
}

impl Estimate {
    /// Confidence interval of the given level (0 to 1, such as 0.95) of a normal distribution.
    ///
    /// # Panics
    /// Where the level is not between 0 and 1.
    pub fn interval(&self, level: f64) -> [f64; 2] {
        assert!(0.0 < level && level < 1.0, "a level between 0 and 1");
        let quantile = Normal::standard().inverse_cdf(0.5 + 0.5 * level);
        let half = quantile * self.std_error;
        [self.value - half, self.value + half]
    }
}
