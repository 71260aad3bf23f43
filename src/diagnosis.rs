//! Diagnosis of model errors.

use dataset::Dataset;

use crate::{Error, Model};

pub use diagnose::{Diagnosis, DiagnosisOptions};

/// Tests which effects (possible extensions of its equations) a model lacks, judged by the measured flights of a
/// dataset, and extends the model by the effects that the data support.
///
/// # Errors
/// [`Error::Diagnosis`] if the model cannot be fitted or the options are invalid.
pub fn diagnose(
    model: &Model,
    dataset: &Dataset,
    options: &DiagnosisOptions<'_>,
) -> Result<Diagnosis, Error> {
    Ok(diagnose::diagnose(model.checked(), dataset, options)?)
}
