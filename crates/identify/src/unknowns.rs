//! What a dataset leaves open besides coefficients, written into the model as effects that are estimated with the rest.

use std::borrow::Cow;

use model_spec::model::Model;

use crate::dataset::Dataset;
use crate::error::FitError;
use crate::fit::{self, Fit};
use crate::options::FitOptions;
use crate::problem::measured;
use crate::unknown_vertical;
use crate::vertical;

/// The model with a quantity for each instrument of the dataset and an effect for what the dataset leaves open, and the dataset
/// that then leaves nothing open.
///
/// # Errors
/// [`FitError::Sensor`] if a sensor does not fit the model; those of [`fit`](fn@fit) if no direction of an unknown vertical can
/// be fitted.
pub fn resolve<'d>(
    model: &Model,
    dataset: &'d Dataset,
    options: &FitOptions<'_>,
) -> Result<(Model, Cow<'d, Dataset>), FitError> {
    let model = measured(model, dataset)?;
    if !dataset.unknown_vertical {
        return Ok((model, Cow::Borrowed(dataset)));
    }
    let known = Dataset {
        unknown_vertical: false,
        ..dataset.clone()
    };
    let model = match vertical::is_in(&model) {
        true => model,
        false => unknown_vertical::with_vertical(&model, &known, options)?,
    };
    Ok((model, Cow::Owned(known)))
}

/// Fits a model to the flights of a dataset.
///
/// # Errors
/// [`FitError::InvalidOption`] for impossible options; [`FitError::UnknownName`], [`FitError::NotEstimated`],
/// [`FitError::NoObservation`], [`FitError::Sensor`] and [`FitError::AttitudeNotObservable`] if model, dataset and options do
/// not match; [`FitError::Flight`] if the known values of a flight do not match the model; [`FitError::NothingToFit`],
/// [`FitError::FaultyData`] and [`FitError::NoUsableFlight`] without usable flights; [`FitError::Interrupted`].
///
/// A flight that cannot be flown or fitted is excluded; its report says why.
pub fn fit(model: &Model, dataset: &Dataset, options: &FitOptions<'_>) -> Result<Fit, FitError> {
    match dataset.unknown_vertical {
        false => fit::fit(model, dataset, options),
        true => {
            options.validate()?;
            let (model, dataset) = resolve(model, dataset, options)?;
            fit::fit(&model, &dataset, options)
        }
    }
}
