//! All forms of the decay, fitted to the record.

use std::path::Path;

use model_spec::model::Model;

use super::diagnosis::{Diagnosed, diagnosed};
use super::fit::{DecayFit, fit};
use super::form::Form;
use super::record::Record;
use crate::error::StudyError;

/// Start of the flight that is left out to see whether its wobble matters, s.
pub(super) const WOBBLE: f64 = 0.5;

/// Results on the decay of the spin.
pub(in super::super) struct SpinDecay {
    pub(super) record: Record,
    pub(super) fits: Vec<(Form, DecayFit)>,
    /// [`Form::Power`] fitted without the first [`WOBBLE`] seconds.
    pub(super) power_without_wobble: Option<DecayFit>,
    /// Axial moment of inertia of the model, kg·m².
    pub(super) axial_inertia: f64,
    /// C_Nr of the model, N·m·s.
    pub(super) model_c_nr: f64,
    /// The ordinary diagnosis of gyroscope and accelerometer.
    pub(super) diagnosed: Diagnosed,
}

impl SpinDecay {
    /// Fits every form to the record in a file.
    pub(in super::super) fn of(file: &Path, disc: &Model) -> Result<Self, StudyError> {
        let record = Record::read(file)?;
        let fits = Form::ALL.iter();
        let fits = fits.filter_map(|form| Some((*form, fit(*form, &record)?)));
        let value = |name: &str| {
            let mut constants = disc.params.iter().chain(&disc.coefficients);
            let found = constants.find(|c| c.name == name).map(|c| c.value);
            found.ok_or_else(|| StudyError::Name {
                of: "model of the disc",
                name: name.to_owned(),
            })
        };
        Ok(Self {
            power_without_wobble: fit(Form::Power, &record.from(WOBBLE)),
            fits: fits.collect(),
            axial_inertia: value("I_a")?,
            model_c_nr: value("C_Nr")?,
            diagnosed: diagnosed(file)?,
            record,
        })
    }

    /// The fit of a form.
    pub(in super::super) fn fit(&self, form: Form) -> Option<&DecayFit> {
        let mut fits = self.fits.iter();
        fits.find(|(of, _)| *of == form).map(|(_, fit)| fit)
    }
}
