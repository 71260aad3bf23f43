//! A simulated recording: what a user has when a fit starts, and the true coefficients.

use std::fmt::Write;

use dataset::Dataset;
use identify::Prior;
use model_spec::model::Model;

use super::setting::Setting;
use crate::oracle_flights::disc_constants;
use crate::oracle_flights::{Plan, truth};

/// A dataset with the model and the options with which a user would fit it.
pub(super) struct Recording {
    /// Model that is fitted.
    pub(super) model: Model,
    /// Simulated measurements.
    pub(super) dataset: Dataset,
    /// True value of each coefficient that is judged, SI.
    pub(super) truth: Vec<(String, f64)>,
    /// Coefficients that the user holds, as in [`identify::FitOptions::fixed`].
    pub(super) fixed: Vec<(String, Option<f64>)>,
    /// Effect of the catalogue that describes the mistake of the recording; `None` if there is none.
    pub(super) cause: Option<String>,
    /// Priors that the user states.
    pub(super) priors: Vec<Prior>,
    /// Standard deviation of the noise of a measured position, m; `None` where no position is measured.
    pub(super) sigma: Option<f64>,
    /// Description of the recording: what is measured, number of flights, rate, noise and size of the mistake.
    pub(super) description: String,
}

impl Recording {
    /// Recording of the flights `dataset` under a setting, fitted with the model `model`.
    pub(super) fn of(model: Model, dataset: Dataset, setting: &Setting) -> Self {
        let plan = setting.plan();
        Self {
            truth: truth(&model, &plan),
            sigma: setting.sigma_of_positions(),
            description: setting.description(),
            model,
            dataset,
            fixed: Vec::new(),
            cause: None,
            priors: Vec::new(),
        }
    }

    /// Appends the size of a mistake to the description.
    pub(super) fn note(&mut self, what: impl std::fmt::Display) {
        let _ = write!(self.description, ", {what}");
    }

    /// True value of a coefficient.
    ///
    /// # Panics
    /// If the coefficient is not judged.
    pub(super) fn true_value(&self, name: &str) -> f64 {
        let mut truth = self.truth.iter();
        let found = truth.find(|(own, _)| own == name);
        found.expect("a coefficient of the disc").1
    }

    /// Value of a constant of the model, SI.
    ///
    /// # Panics
    /// If the model has no such constant.
    pub(super) fn constant(&self, name: &str) -> f64 {
        let mut constants = self.model.params.iter();
        let found = constants.find(|constant| constant.name == name);
        found.expect("a constant of the disc").value
    }

    /// Multiplies the true values of coefficients by `factor`: a wrong constant gives estimates that are wrong by this
    /// factor, and no flight shows it.
    pub(super) fn scale_truth(&mut self, factor: f64, is_scaled: impl Fn(&str) -> bool) {
        let scaled = self.truth.iter_mut().filter(|(name, _)| is_scaled(name));
        scaled.for_each(|(_, value)| *value *= factor);
    }
}

/// Values of the constants and coefficients of a disc model, with the true coefficients of a plan.
pub(super) fn constants(model: &Model, plan: &Plan<'_>) -> oracle::Point<f64> {
    disc_constants(model, plan)
}
