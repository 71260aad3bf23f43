//! Fits all forms of the decay to the record.

use std::path::Path;

use model_spec::model::Model;

use super::diagnosis::{Diagnosed, diagnosed};
use super::fit::{DecayFit, fit};
use super::form::Form;
use super::record::Record;
use crate::error::StudyError;

/// Duration of the initial part of the flight that one fit leaves out, to test whether the disc's wobble there affects
/// the result, s.
pub(super) const WOBBLE: f64 = 0.5;

/// Fits of all laws of the torque that slows a disc's spin, and the diagnosis of the same measured flight.
pub(in super::super) struct SpinDecay {
    pub(super) record: Record,
    pub(super) fits: Vec<(Form, DecayFit)>,
    /// Fit of a torque proportional to a power of the spin, without the first [`WOBBLE`] seconds of the flight; `None`
    /// if the fit failed.
    pub(super) power_without_wobble: Option<DecayFit>,
    /// Axial moment of inertia of the disc in the model, kg·m².
    pub(super) axial_inertia: f64,
    /// Value of the spin-damping coefficient C_Nr in the model file, N·m·s.
    pub(super) model_c_nr: f64,
    /// Diagnosis of the gyroscope and accelerometer record with the flight model of the disc (all forces and moments),
    /// not only a law of the spin-down torque.
    pub(super) diagnosed: Diagnosed,
}

impl SpinDecay {
    /// Fits every torque law (variant of [`Form`]) to the gyroscope record in a file, and diagnoses the record.
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

    /// Fit of the torque law `form` to the measured spin; `None` if that fit failed.
    pub(in super::super) fn fit(&self, form: Form) -> Option<&DecayFit> {
        let mut fits = self.fits.iter();
        fits.find(|(of, _)| *of == form).map(|(_, fit)| fit)
    }
}
