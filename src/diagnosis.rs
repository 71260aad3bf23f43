//! Diagnosis of model errors.

use diagnose::diagnosis::{Asked, Diagnosed};
use identify::dataset::Dataset;

use crate::{Error, Model};

pub use diagnose::diagnosis::{Asked as DiagnosisOptions, Diagnosed as Diagnosis};

/// Tests which effects a model lacks, judged by the measured flights of a dataset, and extends it by those that the
/// data support.
///
/// # Errors
/// [`Error::Diagnosis`].
pub fn diagnose(model: &Model, dataset: &Dataset, options: &Asked<'_>) -> Result<Diagnosed, Error> {
    Ok(diagnose::diagnosis::diagnose(
        model.checked(),
        dataset,
        options,
    )?)
}
