//! Output-error fits of a model to a dataset.

use std::time::Instant;

use dataset::Dataset;
use identify::{CancellationToken, DataFault, FitOptions, FitReport, Prior, Progress};
use statrs::distribution::{ContinuousCDF, Normal};

use crate::{Error, Flight, Model, Release};

/// Options of a fit, from [`Fit::of`]: which parameters are estimated, with which priors, and how the work is run.
#[derive(Clone, Debug)]
pub struct FitBuilder {
    model: Model,
    fixed: Vec<(String, Option<f64>)>,
    free: Vec<String>,
    priors: Vec<Prior>,
    unbounded: bool,
    trust_data: bool,
    threads: Option<usize>,
    cancellation: Option<CancellationToken>,
    deadline: Option<Instant>,
}

impl FitBuilder {
    /// Fixes a coefficient at a value, SI, within its bounds in the model unless the fit is [unbounded](Self::unbounded).
    pub fn fix(mut self, name: &str, value: f64) -> Self {
        self.fixed.push((name.to_owned(), Some(value)));
        self
    }

    /// Estimates a parameter, or a component of an input such as `wind_x`, with one value for all flights.
    pub fn free(mut self, name: &str) -> Self {
        self.free.push(name.to_owned());
        self
    }

    /// Sets a Gaussian prior of a coefficient or a free parameter: mean and standard deviation, SI.
    pub fn prior(mut self, name: &str, value: f64, sigma: f64) -> Self {
        let name = name.to_owned();
        self.priors.push(Prior { name, value, sigma });
        self
    }

    /// Lets estimates leave the bounds that the model gives for its coefficients.
    pub fn unbounded(mut self) -> Self {
        self.unbounded = true;
        self
    }

    /// Fits flights with a [`DataFault`] too; without it they are excluded.
    pub fn trust_data(mut self) -> Self {
        self.trust_data = true;
        self
    }

    /// Sets the number of threads; by default that of the processors. The result does not depend on it.
    pub fn threads(mut self, threads: usize) -> Self {
        self.threads = Some(threads);
        self
    }

    /// Sets the token with which another thread can cancel the fit.
    pub fn cancellation(mut self, token: &CancellationToken) -> Self {
        self.cancellation = Some(token.clone());
        self
    }

    /// Sets the time at which the iteration stops with the best estimates so far.
    pub fn deadline(mut self, deadline: Instant) -> Self {
        self.deadline = Some(deadline);
        self
    }

    /// Fits the model to the flights of a dataset.
    ///
    /// # Errors
    /// [`Error::Fit`] if an option is invalid or the model cannot be fitted to the dataset.
    pub fn run(&self, dataset: &Dataset) -> Result<Fit, Error> {
        self.run_on(dataset, None)
    }

    /// Fits as [`run`](Self::run) does, and reports the progress.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn run_with(&self, dataset: &Dataset, progress: &dyn Progress) -> Result<Fit, Error> {
        self.run_on(dataset, Some(progress))
    }

    fn run_on(&self, dataset: &Dataset, progress: Option<&dyn Progress>) -> Result<Fit, Error> {
        let options = self.options(progress);
        let fit = identify::fit(self.model.checked(), dataset, &options)?;
        let fit = fit.with_lack_of_fit(options.threads())?;
        Fit::new(fit, self.model.checked(), dataset)
    }

    pub(crate) fn options<'a>(&'a self, progress: Option<&'a dyn Progress>) -> FitOptions<'a> {
        FitOptions {
            fixed: &self.fixed,
            free: &self.free,
            priors: &self.priors,
            unbounded: self.unbounded,
            trust_data: self.trust_data,
            threads: self.threads,
            progress,
            cancellation: self.cancellation.as_ref(),
            deadline: self.deadline,
            ..FitOptions::default()
        }
    }

    pub(crate) fn model(&self) -> &Model {
        &self.model
    }
}

/// Result of fitting a model to a dataset: estimates with standard errors, the fitted model, and the report.
pub struct Fit {
    report: FitReport,
    model: Model,
}

impl Fit {
    /// Prepares an output-error fit: maximum likelihood with estimated noise, and an initial state for each flight.
    ///
    /// ```no_run
    /// # fn main() -> Result<(), hyzer::Error> {
    /// let disc = hyzer::Model::load("disc")?;
    /// let data = hyzer::read_dataset("examples/disc")?;
    /// let fit = hyzer::Fit::of(&disc).fix("C_D0", 0.1).prior("C_La", 2.0, 0.5).run(&data)?;
    /// println!("{:?} {:?}", fit.coefficient("C_Ma"), fit.cautions());
    /// # Ok(())
    /// # }
    /// ```
    pub fn of(model: &Model) -> FitBuilder {
        FitBuilder {
            model: model.clone(),
            fixed: Vec::new(),
            free: Vec::new(),
            priors: Vec::new(),
            unbounded: false,
            trust_data: false,
            threads: None,
            cancellation: None,
            deadline: None,
        }
    }

    pub(crate) fn new(
        fit: identify::Fit,
        model: &model_spec::model::Model,
        dataset: &Dataset,
    ) -> Result<Fit, Error> {
        let text = fit.fitted_text(model, dataset, "")?;
        Ok(Fit {
            model: Model::parse("fitted", &text)?,
            report: fit.report,
        })
    }

    /// Estimate of a coefficient or a freed parameter; `None` for an unknown name.
    pub fn coefficient(&self, name: &str) -> Option<Estimate> {
        let coefficient = self.report.coefficients.get(name)?;
        Some(Estimate {
            value: coefficient.value,
            std_error: coefficient.std_error,
            unit: coefficient.unit.clone(),
            at_bound: coefficient.at_bound,
        })
    }

    /// Names and estimates of all coefficients and freed parameters, in alphabetical order.
    pub fn coefficients(&self) -> impl Iterator<Item = (&str, Estimate)> {
        let names = self.report.coefficients.keys();
        names.filter_map(|name| Some((name.as_str(), self.coefficient(name)?)))
    }

    /// Root mean square residual of a kind of sensor over the fitted flights, such as `marker` (m); `None` without such
    /// measurements.
    pub fn residual_rms(&self, kind: &str) -> Option<f64> {
        self.report.residual_rms.get(kind).map(|rms| rms.value)
    }

    /// Whether the estimates can be relied on; otherwise [`Fit::cautions`] states the reasons.
    pub fn is_reliable(&self) -> bool {
        self.report.reliable
    }

    /// Reasons not to rely on the estimates, such as excluded flights; empty for a reliable fit.
    pub fn cautions(&self) -> &[String] {
        &self.report.cautions
    }

    /// Mistakes found in the measured data, such as exchanged markers or wrong units, each with its correction.
    pub fn data_faults(&self) -> &[DataFault] {
        &self.report.data_faults
    }

    /// The model with the estimates, and the known parameters of the dataset, as its default values.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Text of [`Fit::model`] in the model language.
    pub fn fitted_text(&self) -> String {
        self.model.text()
    }

    /// Flies a release with the fitted model.
    ///
    /// # Errors
    /// As [`Model::fly`].
    pub fn predict(&self, release: &Release) -> Result<Flight, Error> {
        self.model.fly(release)
    }

    /// The whole report as JSON, `hyzer.fit/2`, as in the file `report.json` of the program.
    ///
    /// # Errors
    /// [`Error::Json`] if a value has no form in JSON.
    pub fn to_json(&self) -> Result<String, Error> {
        Ok(serde_json::to_string_pretty(&self.report)?)
    }

    /// Complete report of the fit: noise, correlations, flights, and coefficients that the flights do not determine.
    pub fn report(&self) -> &FitReport {
        &self.report
    }
}

/// Estimated value with its standard error.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Estimate {
    /// Maximum-likelihood estimate, SI.
    pub value: f64,
    /// Standard error (Cramér–Rao), SI; 0 if the value was fixed, NaN at a bound.
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
