//! What a dataset leaves open besides coefficients, written into the model as effects that are estimated with the rest.

use std::borrow::Cow;

use model_spec::compose::ModelTree;
use model_spec::model::Model;

use crate::dataset::Dataset;
use crate::error::FitError;
use crate::fit::{self, Fit};
use crate::options::{FitOptions, Prior};
use crate::problem::measured;
use crate::unknown_vertical;
use crate::vertical;

/// Name of the effect by which all markers sit off together, and of its coefficients, m.
const OFFSET: (&str, [&str; 3]) = ("marker_offset", ["offset_1", "offset_2", "offset_3"]);

/// A fit that leaves nothing open.
pub struct Resolved<'d> {
    /// The model with a quantity for each instrument of the dataset and an effect for what the dataset leaves open.
    pub model: Model,
    /// The dataset, which leaves nothing open any more.
    pub dataset: Cow<'d, Dataset>,
    /// Priors of the options and of what is open.
    pub priors: Vec<Prior>,
    /// Fixed coefficients of the options and of what is open.
    pub fixed: Vec<(String, Option<f64>)>,
}

impl Resolved<'_> {
    /// The options with these priors and fixed coefficients.
    pub fn options<'o>(&'o self, options: &FitOptions<'o>) -> FitOptions<'o> {
        FitOptions {
            priors: &self.priors,
            fixed: &self.fixed,
            ..*options
        }
    }
}

/// Writes into the model what the dataset leaves open.
///
/// # Errors
/// [`FitError::Sensor`] if a sensor or an uncertain origin does not fit the model; those of [`fit`](fn@fit) if no direction of an
/// unknown vertical can be fitted.
pub fn resolve<'d>(
    model: &Model,
    dataset: &'d Dataset,
    options: &FitOptions<'_>,
) -> Result<Resolved<'d>, FitError> {
    let mut resolved = Resolved {
        model: measured(model, dataset)?,
        dataset: Cow::Borrowed(dataset),
        priors: options.priors.to_vec(),
        fixed: options.fixed.to_vec(),
    };
    if let Some(errors) = dataset.origin_error {
        resolved.model = with_offset(&resolved.model)?;
        for (name, error) in OFFSET.1.into_iter().zip(errors) {
            match error > 0.0 {
                true => resolved.priors.push(Prior {
                    name: name.to_owned(),
                    value: 0.0,
                    sigma: error,
                }),
                false => resolved.fixed.push((name.to_owned(), None)),
            }
        }
        resolved.dataset.to_mut().origin_error = None;
    }
    if dataset.unknown_vertical {
        resolved.dataset.to_mut().unknown_vertical = false;
        if !vertical::is_in(&resolved.model) {
            let options = resolved.options(options);
            let found =
                unknown_vertical::with_vertical(&resolved.model, &resolved.dataset, &options);
            resolved.model = found?;
        }
    }
    Ok(resolved)
}

/// The model with an offset of all markers.
fn with_offset(model: &Model) -> Result<Model, FitError> {
    if model.effects.iter().any(|own| own.name == OFFSET.0) {
        return Ok(model.clone());
    }
    let extended = ModelTree::of(model).with_named([OFFSET.0]);
    let extended = extended.and_then(|tree| tree.check());
    extended.map_err(|error| FitError::Sensor {
        model: model.name.clone(),
        reason: format!("origin_error of its template: {error}"),
    })
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
    if !dataset.unknown_vertical && dataset.origin_error.is_none() {
        return fit::fit(model, dataset, options);
    }
    options.validate()?;
    let resolved = resolve(model, dataset, options)?;
    fit::fit(
        &resolved.model,
        &resolved.dataset,
        &resolved.options(options),
    )
}
