//! Unknown positions, origin and vertical of a dataset. They are added to the model as effects whose coefficients are
//! estimated.

use std::borrow::Cow;

use model_spec::LoadError;
use model_spec::compose::{Instrument, ModelTree};
use model_spec::model::Model;

use crate::error::FitError;
use crate::fit::{self, Fit};
use crate::options::{FitOptions, Prior};
use crate::problem::measured;
use crate::unknown_vertical;
use crate::vertical;
use dataset::{Dataset, Sensor, SensorKind};

/// Effect that displaces all markers together on the body: its name and the names of its coefficients, m.
const OFFSET: (&str, [&str; 3]) = ("marker_offset", ["offset_1", "offset_2", "offset_3"]);

/// Effect that tilts the template of the markers on the body: its name and the names of its coefficients, rad.
const TILT: (&str, [&str; 2]) = ("template_tilt", ["tilt_1", "tilt_2"]);

/// Effect that displaces the accelerometer on the body: its name and the names of its coefficients, m.
const LEVER: (&str, [&str; 3]) = (
    "accelerometer_misplaced",
    [
        "accelerometer_by_1",
        "accelerometer_by_2",
        "accelerometer_by_3",
    ],
);

/// Prior standard deviation of each coordinate of an unknown sensor position on the body, m: about the size of a thrown
/// body.
const UNKNOWN: f64 = 0.1;

/// A model and a dataset in which sensor positions, origin and vertical direction count as known: where the original
/// dataset declares them unknown, effects with estimated coefficients represent them.
pub struct Resolved<'d> {
    /// The model, with two kinds of additions: a definition of the quantity that each kind of instrument in the dataset
    /// measures, such as the angular velocity for a gyroscope, unless the model defines it; and an effect for each
    /// sensor position, origin or vertical direction that the dataset declares unknown.
    pub model: Model,
    /// The dataset, with all sensor positions, the origin and the vertical direction marked as known. What it declared
    /// unknown is estimated as coefficients of effects instead.
    pub dataset: Cow<'d, Dataset>,
    /// Priors given in the fit options, and priors of the coefficients that represent what the dataset declares
    /// unknown: sensor positions and the origin.
    pub priors: Vec<Prior>,
    /// Fixed coefficients given in the fit options, and fixed coefficients of the effects that represent what the
    /// dataset declares unknown; `None` fixes a coefficient at the model's value.
    pub fixed: Vec<(String, Option<f64>)>,
}

impl Resolved<'_> {
    /// Adds to the model an effect with a name and coefficients, which displace the markers or the accelerometer on the
    /// body. `errors` are the prior standard deviations of the coefficients about 0, m or rad; 0 fixes a coefficient.
    fn free<const N: usize>(
        &mut self,
        (effect, coefficients): &(&str, [&str; N]),
        errors: [f64; N],
    ) -> Result<(), FitError> {
        if !self.has(effect) {
            self.model = self.extended(effect).map_err(|error| FitError::Sensor {
                model: self.model.name.clone(),
                reason: format!("{effect}, for a position on the body that is not known: {error}"),
            })?;
        }
        for (name, error) in coefficients.iter().zip(errors) {
            match error > 0.0 {
                true => self.priors.push(Prior {
                    name: (*name).to_owned(),
                    value: 0.0,
                    sigma: error,
                }),
                false => self.fixed.push(((*name).to_owned(), None)),
            }
        }
        Ok(())
    }

    fn has(&self, effect: &str) -> bool {
        self.model.effects.iter().any(|own| own.name == effect)
    }

    /// The model with an effect more.
    fn extended(&self, effect: &str) -> Result<Model, LoadError> {
        let extended = ModelTree::of(&self.model).with_named([effect]);
        extended.and_then(|tree| tree.check())
    }

    /// Copy of the fit options `options` in which the priors and fixed coefficients are replaced by those of `self`.
    pub fn options<'o>(&'o self, options: &FitOptions<'o>) -> FitOptions<'o> {
        FitOptions {
            priors: &self.priors,
            fixed: &self.fixed,
            ..*options
        }
    }
}

/// Adds to the model an effect for each quantity that the dataset declares unknown: sensor positions, origin of the
/// markers' positions on the body, direction of the vertical.
///
/// # Errors
/// [`FitError::Sensor`] if a sensor or an uncertain origin does not fit the model; the errors of [`fit`](fn@fit) if no
/// direction of an unknown vertical can be fitted.
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
        resolved.free(&OFFSET, errors)?;
        resolved.dataset.to_mut().origin_error = None;
    }
    if let Some(error) = dataset.axis_error {
        // A model whose markers have no place on the body by name takes the template as it is.
        if resolved.has(TILT.0) || resolved.extended(TILT.0).is_ok() {
            resolved.free(&TILT, [error; 2])?;
        }
        resolved.dataset.to_mut().axis_error = None;
    }
    place_sensors(&mut resolved)?;
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

/// Adds to the model an effect for each sensor whose position on the body is unknown, so that the fit estimates this
/// position, and marks the position as known in the dataset. Sensors whose readings do not depend on their position get
/// no effect.
fn place_sensors(resolved: &mut Resolved<'_>) -> Result<(), FitError> {
    let sensors = resolved.dataset.sensors.iter();
    let unplaced: Vec<Sensor> = sensors
        .filter(|own| own.position_is_unknown)
        .cloned()
        .collect();
    for sensor in &unplaced {
        let refused = |expected: &str| FitError::Sensor {
            model: resolved.model.name.clone(),
            reason: format!(
                "found the position of {} unknown, expected {expected}",
                sensor.name
            ),
        };
        let of_kind = resolved.dataset.sensors.iter();
        let alone = of_kind.filter(|own| own.kind == sensor.kind).count() == 1;
        match sensor.kind {
            SensorKind::Pose if alone && resolved.dataset.markers.is_empty() => {
                resolved.free(&OFFSET, [UNKNOWN; 3])?;
            }
            SensorKind::Pose => {
                return Err(refused("one pose alone, or three markers with positions"));
            }
            SensorKind::Instrument(Instrument::Accelerometer) if alone => {
                resolved.free(&LEVER, [UNKNOWN; 3])?;
            }
            SensorKind::Instrument(Instrument::Accelerometer) => {
                return Err(refused("one accelerometer"));
            }
            // Their readings do not depend on the position on the body.
            SensorKind::Instrument(Instrument::Gyroscope | Instrument::Speed) => {}
        }
    }
    for sensor in unplaced {
        let mut all = resolved.dataset.to_mut().sensors.iter_mut();
        if let Some(own) = all.find(|own| own.name == sensor.name) {
            own.position_is_unknown = false;
        }
    }
    Ok(())
}

/// Fits a model to the flights of a dataset.
///
/// A flight that cannot be integrated or fitted is excluded; its report gives the reason.
///
/// # Errors
/// [`FitError::InvalidOption`] if an option is outside its range; [`FitError::UnknownName`],
/// [`FitError::NotEstimated`], [`FitError::NoObservation`], [`FitError::Sensor`] and
/// [`FitError::AttitudeNotObservable`] if model, dataset and options do not match; [`FitError::Flight`] if the known
/// values of a flight do not match the model; [`FitError::NothingToFit`], [`FitError::FaultyData`] and
/// [`FitError::NoUsableFlight`] if no flight can be used; [`FitError::Interrupted`] if the fit is cancelled.
pub fn fit(model: &Model, dataset: &Dataset, options: &FitOptions<'_>) -> Result<Fit, FitError> {
    let is_placed = dataset
        .sensors
        .iter()
        .all(|sensor| !sensor.position_is_unknown);
    let is_template_exact = dataset.origin_error.is_none() && dataset.axis_error.is_none();
    if is_placed && !dataset.unknown_vertical && is_template_exact {
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
