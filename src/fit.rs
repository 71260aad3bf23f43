//! Output-error fits of a model to a dataset.

use dataset::Dataset;
use identify::{DataFault, FitOptions, FitReport};
use statrs::distribution::{ContinuousCDF, Normal};

use crate::{Error, Model};

/// Fits the coefficients of a model to the measured flights of a dataset by the output-error method: maximum
/// likelihood with estimated noise, and a separate initial state for each flight.
///
/// # Errors
/// [`Error::Fit`] if the options are invalid or the model cannot be fitted to the dataset.
pub fn fit(model: &Model, dataset: &Dataset, options: &FitOptions<'_>) -> Result<Fit, Error> {
    let fit = identify::fit(model.checked(), dataset, options)?;
    Ok(Fit { fit })
}

/// Result of fitting a model to a dataset: estimates with standard errors, and the report.
pub struct Fit {
    fit: identify::Fit,
}

impl Fit {
    /// Estimate of a coefficient, or of a parameter that the fit also estimated, by its name; `None` for an unknown
    /// name.
    pub fn coefficient(&self, name: &str) -> Option<Estimate> {
        let coefficient = self.fit.report.coefficients.get(name)?;
        Some(Estimate {
            value: coefficient.value,
            std_error: coefficient.std_error,
            unit: coefficient.unit.clone(),
            at_bound: coefficient.at_bound,
        })
    }

    /// Names and estimates of all coefficients and of the parameters that the fit also estimated, in alphabetical
    /// order.
    pub fn coefficients(&self) -> impl Iterator<Item = (&str, Estimate)> {
        let names = self.fit.report.coefficients.keys();
        names.filter_map(|name| Some((name.as_str(), self.coefficient(name)?)))
    }

    /// Root mean square residual of the measured coordinates over the fitted flights, m.
    pub fn rms(&self) -> f64 {
        self.fit.report.rms()
    }

    /// Whether the iteration of the fit converged; without convergence the estimates are not reliable.
    pub fn converged(&self) -> bool {
        self.fit.report.iterations.converged
    }

    /// Whether the estimates can be relied on; otherwise [`Fit::cautions`] states the reasons.
    pub fn is_reliable(&self) -> bool {
        self.fit.report.reliable
    }

    /// Reasons not to rely on the estimates, such as excluded flights; empty for a reliable fit.
    pub fn cautions(&self) -> &[String] {
        &self.fit.report.cautions
    }

    /// Mistakes found in the measured data, such as exchanged markers or wrong units, each with an instruction for
    /// correcting it.
    pub fn data_faults(&self) -> &[DataFault] {
        &self.fit.report.data_faults
    }

    /// Complete report of the fit: noise, correlations, flights, and coefficients that the flights do not determine.
    pub fn report(&self) -> &FitReport {
        &self.fit.report
    }

    /// The underlying result of the crate `identify`, which includes the estimation problem and gives predictions and
    /// residuals.
    pub fn inner(&self) -> &identify::Fit {
        &self.fit
    }
}

/// Estimated value with its standard error.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Maximum-likelihood estimate, SI.
    pub value: f64,
    /// Standard error (Cramér–Rao), SI; 0 if the value was held fixed.
    pub std_error: f64,
    /// Text of the SI unit of [`Estimate::value`], such as `1`, `1/rad` or `kg*m^2`.
    pub unit: String,
    /// Whether the estimate lies on a bound specified in the model.
    pub at_bound: bool,
}

impl Estimate {
    /// Confidence interval of the given level (between 0 and 1, such as 0.95), assuming a normal distribution.
    ///
    /// # Panics
    /// If the level is not strictly between 0 and 1.
    pub fn interval(&self, level: f64) -> [f64; 2] {
        assert!(0.0 < level && level < 1.0, "a level between 0 and 1");
        let quantile = Normal::standard().inverse_cdf(0.5 + 0.5 * level);
        let half = quantile * self.std_error;
        [self.value - half, self.value + half]
    }
}
