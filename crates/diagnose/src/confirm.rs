//! Causes that could explain nearly anything are believed where they predict.
//!
//! What each flight has for itself, and many effects at once, bend to what lies outside the catalogue and leave only noise of the flights
//! that they were fitted to. What is so explains flights that were not fitted, too.

use identify::dataset::Role;
use identify::{Fit, fit};

use crate::bench::Bench;
use crate::catalogue::underscored;
use crate::causes::Cause;
use crate::diagnosis::DiagnosisError;
use crate::extend::Extension;
use crate::gain::{self, Believed};
use crate::outside::Place;
use crate::report::Gain;

/// Effects at once that are believed without.
const FEW: usize = 2;

/// A model with a cause.
pub(crate) struct Tried {
    /// The model.
    pub extension: Extension,
    /// Its fit.
    pub fitted: Fit,
    /// What it gains; none where there is no flight to say.
    pub gain: Option<Gain>,
}

impl Tried {
    /// Whether flights that were not fitted are predicted better with it.
    pub fn predicts(&self) -> bool {
        let better = |gain: &Gain| {
            let gained = gain.held_out_rms_before_m - gain.held_out_rms_after_m;
            gained > gain.standard_error_m
        };
        self.gain.as_ref().is_none_or(better)
    }
}

impl Bench {
    /// Whether a cause could explain nearly anything.
    pub(crate) fn is_supple(&self, cause: &Cause) -> bool {
        let mut each = cause.effects.iter();
        cause.effects.len() > FEW || each.any(|&e| !self.candidates[e].states.is_empty())
    }

    /// The model with a cause.
    ///
    /// # Errors
    /// Where its effects cannot be switched on together.
    pub(crate) fn extension(
        &self,
        place: Place<'_>,
        cause: &Cause,
    ) -> Result<Extension, DiagnosisError> {
        let each = cause.effects.iter();
        let names = each.map(|&e| underscored(&self.candidates[e].candidate.name));
        let with = place.asked.with;
        Ok(Extension::new(
            place.model,
            with,
            names.collect(),
            Vec::new(),
        )?)
    }

    /// Tries a cause on flights that are not fitted.
    ///
    /// # Errors
    /// Where the flights cannot be fitted with it.
    pub(crate) fn tried(
        &self,
        place: Place<'_>,
        cause: &Cause,
        before: &Fit,
        floor: f64,
    ) -> Result<Tried, DiagnosisError> {
        let Place {
            model,
            dataset,
            asked,
        } = place;
        let extension = self.extension(place, cause)?;
        let fitted = fit(&extension.model, dataset, &asked.fit)?;
        let held_out = dataset.flights.iter().any(|f| f.role == Role::HeldOut);
        let gain = if held_out {
            gain::by_held_out(&before.report, &fitted.report, floor)
        } else {
            let models = [model, &extension.model];
            gain::by_turns(models, dataset, &asked.fit, Believed::Always, floor)?
        };
        Ok(Tried {
            extension,
            fitted,
            gain,
        })
    }
}
