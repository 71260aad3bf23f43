//! Diagnosis of model errors.

use identify::dataset::Dataset;

use crate::{Error, Model};

pub use diagnose::{Diagnosis, DiagnosisOptions};

/// Tests which effects a model lacks, judged by the measured flights of a dataset, and extends it by those that the
/// data support.
///
/// # Errors
/// [`Error::Diagnosis`].
pub fn diagnose(
    model: &Model,
    dataset: &Dataset,
    options: &DiagnosisOptions<'_>,
) -> Result<Diagnosis, Error> {
    Ok(diagnose::diagnose(model.checked(), dataset, options)?)
}
