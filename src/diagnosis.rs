//! Diagnosis of model errors.

use dataset::Dataset;
use diagnose::{DiagnosisOptions, Explanation, PredictiveGain, Report, Verdict};
use identify::{CancellationToken, Progress};

use crate::{Error, Fit, FitBuilder, Model};

/// Options of a diagnosis, from [`Diagnosis::of`].
#[derive(Clone, Debug)]
pub struct DiagnosisBuilder {
    fit: FitBuilder,
    name: String,
    without: Vec<String>,
}

impl DiagnosisBuilder {
    /// Names the dataset, as the report shows it.
    pub fn named(mut self, dataset: &str) -> Self {
        dataset.clone_into(&mut self.name);
        self
    }

    /// Leaves out a candidate effect, by its name.
    pub fn without(mut self, effect: &str) -> Self {
        self.without.push(effect.to_owned());
        self
    }

    /// Fixes a coefficient at a value, SI, in all fits.
    pub fn fix(mut self, name: &str, value: f64) -> Self {
        self.fit = self.fit.fix(name, value);
        self
    }

    /// Sets a Gaussian prior of a coefficient in all fits: mean and standard deviation, SI.
    pub fn prior(mut self, name: &str, value: f64, sigma: f64) -> Self {
        self.fit = self.fit.prior(name, value, sigma);
        self
    }

    /// Sets the number of threads; by default that of the processors. The result does not depend on it.
    pub fn threads(mut self, threads: usize) -> Self {
        self.fit = self.fit.threads(threads);
        self
    }

    /// Sets the token with which another thread can cancel the diagnosis.
    pub fn cancellation(mut self, token: &CancellationToken) -> Self {
        self.fit = self.fit.cancellation(token);
        self
    }

    /// Tests the model against the flights of a dataset, and extends it by the effects that the data support.
    ///
    /// # Errors
    /// [`Error::Diagnosis`] if an option is invalid or the model cannot be fitted.
    pub fn run(&self, dataset: &Dataset) -> Result<Diagnosis, Error> {
        self.run_on(dataset, None)
    }

    /// Runs the diagnosis as [`run`](Self::run) does, and reports the progress.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn run_with(&self, dataset: &Dataset, progress: &dyn Progress) -> Result<Diagnosis, Error> {
        self.run_on(dataset, Some(progress))
    }

    fn run_on(
        &self,
        dataset: &Dataset,
        progress: Option<&dyn Progress>,
    ) -> Result<Diagnosis, Error> {
        let options = DiagnosisOptions {
            dataset: &self.name,
            without: &self.without,
            fit: self.fit.options(progress),
            ..DiagnosisOptions::default()
        };
        let found = diagnose::diagnose(self.fit.model().checked(), dataset, &options)?;
        let extended = match found.after {
            Some((extension, fit)) => Some(Fit::new(fit, &extension.model, dataset)?),
            None => None,
        };
        Ok(Diagnosis {
            report: found.report,
            extended,
        })
    }
}

/// Result of a diagnosis: the verdict with its explanations, and the model extended by the effects found.
pub struct Diagnosis {
    report: Report,
    extended: Option<Fit>,
}

impl Diagnosis {
    /// Prepares a test of which effects a model lacks, among the built-in effects and those that the model's own text
    /// declares ([`Model::with_candidate`]).
    ///
    /// ```no_run
    /// # fn main() -> Result<(), hyzer::Error> {
    /// let disc = hyzer::Model::load("disc")?;
    /// let data = hyzer::read_dataset("examples/mystery")?;
    /// let found = hyzer::Diagnosis::of(&disc).without("stall").run(&data)?;
    /// println!("{:?}: {}", found.verdict(), found.summary());
    /// if let Some(fit) = found.extended() {
    ///     std::fs::write("extended.hyz", fit.fitted_text()).expect("a file");
    /// }
    /// # Ok(())
    /// # }
    /// ```
    pub fn of(model: &Model) -> DiagnosisBuilder {
        DiagnosisBuilder {
            fit: Fit::of(model),
            name: String::new(),
            without: Vec::new(),
        }
    }

    /// Whether the model has an error, and whether its cause is identified.
    pub fn verdict(&self) -> Verdict {
        self.report.verdict
    }

    /// Summary of the result, one paragraph of text.
    pub fn summary(&self) -> &str {
        &self.report.summary
    }

    /// Whether the result can be relied on; otherwise [`Diagnosis::cautions`] states the reasons.
    pub fn is_reliable(&self) -> bool {
        self.report.reliable
    }

    /// Reasons not to rely on the result; empty for a reliable diagnosis.
    pub fn cautions(&self) -> &[String] {
        &self.report.cautions
    }

    /// Fit of the extended model, whose text is [`Fit::fitted_text`]; `None` if the model is not extended.
    pub fn extended(&self) -> Option<&Fit> {
        self.extended.as_ref()
    }

    /// Every explanation that the data do not reject, the best first; empty for an adequate model.
    pub fn explanations(&self) -> &[Explanation] {
        &self.report.explanations
    }

    /// Prediction errors on flights that were not fitted, without and with the effects found; `None` if the model is
    /// not extended or no flight can be predicted.
    pub fn predictive_gain(&self) -> Option<&PredictiveGain> {
        self.report.predictive_gain.as_ref()
    }

    /// The whole report as JSON, `hyzer.diagnosis/2`, as in the file `report.json` of the program.
    ///
    /// # Errors
    /// [`Error::Json`] if a value has no form in JSON.
    pub fn to_json(&self) -> Result<String, Error> {
        Ok(serde_json::to_string_pretty(&self.report)?)
    }
}
