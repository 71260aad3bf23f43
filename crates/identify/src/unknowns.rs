//! Unknown positions, origin and vertical of a dataset, added to the model as effects with estimated coefficients.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

use model_spec::LoadError;
use model_spec::compose::{EffectTree, Instrument, ModelTree};
use model_spec::model::Model;

use crate::error::FitError;
use crate::fit::{self, Fit};
use crate::inputs;
use crate::options::{FitOptions, Prior};
use crate::problem::measured;
use crate::vertical;
use crate::vertical::{ANGLES, EFFECT, angles};
use dataset::levels::AT_NOISE;
use dataset::{Dataset, KnownValue, Role, Sensor, SensorKind};

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

/// Prior standard deviation of each coordinate of an unknown position, m: the size of a thrown body.
const UNKNOWN: f64 = 0.1;

/// A model and a dataset without unknowns: effects with estimated coefficients represent them.
pub struct Resolved<'d> {
    /// The model with the quantities that the instruments measure, and an effect for each sensor position, origin or
    /// vertical that is unknown.
    pub model: Model,
    /// The dataset, with all sensor positions, the origin and the vertical marked as known.
    pub dataset: Cow<'d, Dataset>,
    /// Priors of the options and of the added coefficients.
    pub priors: Vec<Prior>,
    /// Fixed coefficients of the options and of the added effects; `None` is the model's value.
    pub fixed: Vec<(String, Option<f64>)>,
}

impl Resolved<'_> {
    /// Adds an effect whose coefficients have the prior standard deviations `errors` about 0; 0 fixes one.
    fn free<const N: usize>(
        &mut self,
        (effect, coefficients): &(&str, [&str; N]),
        errors: [f64; N],
    ) -> Result<(), FitError> {
        if !self.has(effect, coefficients) {
            self.model = self.extended(effect).map_err(|error| FitError::Sensor {
                model: self.model.name.clone(),
                reason: format!("{effect}, for a position on the body that is not known: {error}"),
            })?;
        }
        for (name, error) in coefficients.iter().zip(errors) {
            if self.fixed.iter().any(|(own, _)| own == name) {
                continue;
            }
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

    /// Puts states in the place of the quantities `names`. What the dataset sets of them becomes their default. The error
    /// is the reason, as text for the message.
    fn unknown(&mut self, names: &BTreeSet<String>) -> Result<(), String> {
        let constants = self.model.params.iter().map(|own| &own.name);
        let set = constants.filter(|name| names.contains(*name));
        let set = set.filter_map(|name| self.dataset.parameters.get_key_value(name));
        let set: BTreeMap<String, f64> = set.map(|(name, value)| (name.clone(), *value)).collect();
        if !set.is_empty() {
            let values = set.iter().map(|(name, value)| (name.as_str(), *value));
            let tree = self.model.with_values(values);
            let checked = tree.map_err(|error| error.to_string())?.check();
            self.model = checked.map_err(|error| error.to_string())?;
            let parameters = &mut self.dataset.to_mut().parameters;
            parameters.retain(|name, _| !set.contains_key(name));
        }
        let recorded = inputs::recorded(&self.dataset);
        let model = self.model.with_unknown_or_recorded(names, &recorded);
        self.model = model.map_err(|error| error.to_string())?;
        Ok(())
    }

    /// Whether the model has the effect, by name or written into its text with its coefficients.
    fn has(&self, effect: &str, coefficients: &[&str]) -> bool {
        let is_declared =
            |name: &&str| self.model.coefficients.iter().any(|own| own.name == **name);
        self.model.effects.iter().any(|own| own.name == effect)
            || coefficients.iter().all(is_declared)
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

/// Adds an effect for each unknown of the dataset.
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
    let unknown = quantities(model, dataset);
    if !unknown.is_empty() {
        resolved.unknown(&unknown).map_err(|reason| {
            let model = model.name.clone();
            FitError::Unknown { model, reason }
        })?;
    }
    if let Some(errors) = dataset.origin_error {
        resolved.free(&OFFSET, errors)?;
        resolved.dataset.to_mut().origin_error = None;
    }
    if let Some(error) = dataset.axis_error {
        // A model whose markers have no place on the body by name takes the template as it is.
        if resolved.has(TILT.0, &TILT.1) || resolved.extended(TILT.0).is_ok() {
            resolved.free(&TILT, [error; 2])?;
        }
        resolved.dataset.to_mut().axis_error = None;
    }
    place_sensors(&mut resolved)?;
    if dataset.unknown_vertical {
        resolved.dataset.to_mut().unknown_vertical = false;
        if !vertical::is_in(&resolved.model) {
            let options = resolved.options(options);
            let found = with_vertical(&resolved.model, &resolved.dataset, &options);
            resolved.model = found?;
        }
    }
    Ok(resolved)
}

/// Names of the quantities that are estimated for some flight by itself: unknown, or measured with an error.
fn quantities(model: &Model, dataset: &Dataset) -> BTreeSet<String> {
    let of_flights = dataset.flights.iter().flat_map(|flight| {
        let measured = flight.known.keys().filter_map(|name| {
            let name = name.strip_suffix(KnownValue::SIGMA)?;
            flight.known.contains_key(name).then(|| name.to_owned())
        });
        flight.unknown.iter().cloned().chain(measured)
    });
    // Each row of a summary states the spin of its ball.
    let has_spin = model.inputs.iter().any(|input| input.name == Sensor::SPIN);
    let spin = dataset.sensors.iter().any(Sensor::is_spin) && has_spin;
    let spin = spin.then(|| Sensor::SPIN.to_owned());
    dataset
        .unknown
        .iter()
        .cloned()
        .chain(of_flights)
        .chain(spin)
        .collect()
}

/// Adds an effect for each sensor at an unknown position on which its readings depend.
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
                return Err(refused("a single pose, or three markers with positions"));
            }
            SensorKind::Instrument(Instrument::Accelerometer) if alone => {
                resolved.free(&LEVER, [UNKNOWN; 3])?;
            }
            SensorKind::Instrument(Instrument::Accelerometer) => {
                return Err(refused("one accelerometer"));
            }
            // Their readings do not depend on the position on the body.
            SensorKind::Instrument(Instrument::Gyroscope | Instrument::Speed)
            | SensorKind::Summary(_) => {}
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

/// Fits a model to the flights of a dataset. A flight that cannot be fitted is excluded; its report gives the reason.
///
/// # Errors
/// [`FitError::InvalidOption`] if an option is outside its range; [`FitError::UnknownName`],
/// [`FitError::NotEstimated`], [`FitError::NoObservation`], [`FitError::Sensor`] and
/// [`FitError::AttitudeNotObservable`] if model, dataset and options do not match; [`FitError::Flight`] if the known
/// values of a flight do not; [`FitError::NothingToFit`], [`FitError::FaultyData`] and [`FitError::NoUsableFlight`] if
/// no flight can be used; [`FitError::Interrupted`] if the fit is cancelled.
pub fn fit(model: &Model, dataset: &Dataset, options: &FitOptions<'_>) -> Result<Fit, FitError> {
    let is_placed = dataset
        .sensors
        .iter()
        .all(|sensor| !sensor.position_is_unknown);
    let is_known = quantities(model, dataset).is_empty();
    let is_template_exact = dataset.origin_error.is_none() && dataset.axis_error.is_none();
    if is_placed && is_known && !dataset.unknown_vertical && is_template_exact {
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

// Datasets whose vertical is not known: it is estimated with the other parameters, from several directions.

/// Maximum number of flights that are fitted from each direction.
const TRIED_FLIGHTS: usize = 6;

/// Upward vectors that are tried, along the measured axes and halfway between two of them.
fn directions() -> Vec<[f64; 3]> {
    let all =
        (0..27).map(|index| [index / 9, index / 3 % 3, index % 3].map(|k| f64::from(k) - 1.0));
    let zeros = |v: &[f64; 3]| v.iter().filter(|x| **x == 0.0).count();
    all.filter(|v| (1..=2).contains(&zeros(v))).collect()
}

/// Adds the effect that rotates the measured axes by two estimated angles, about x and then y, rad.
fn turned(model: &Model, [about_x, about_y]: [f64; 2]) -> Result<Model, FitError> {
    let [x, y] = ANGLES;
    let text = format!(
        "/// The axes that positions are measured in are turned from the vertical by angles that are not known.\n\
         effect {EFFECT} {{\n\
         source \"the dataset: its vertical is unknown\";\n\
         site vertical;\n\
         variables position;\n\
         /// turn of the measured axes about x\n\
         coefficient {x} = {about_x:?} rad in -4 .. 4;\n\
         /// turn about the y that they have then\n\
         coefficient {y} = {about_y:?} rad in -4 .. 4;\n\
         negligible {x} 1e-6 rad;\n\
         negligible {y} 1e-6 rad;\n\
         replace observe = (cos({y})*previous.1 - sin({y})*(cos({x})*previous.3 - sin({x})*previous.2),\n\
           cos({x})*previous.2 + sin({x})*previous.3,\n\
           sin({y})*previous.1 + cos({y})*(cos({x})*previous.3 - sin({x})*previous.2)) in inertial;\n}}\n"
    );
    let refused = |error: model_spec::LoadError| FitError::Sensor {
        model: model.name.clone(),
        reason: error.to_string(),
    };
    let effect = EffectTree::parse("unknown_vertical.hyz", &text).map_err(refused)?;
    let tree = ModelTree::of(model).with(&effect).map_err(refused)?;
    tree.check().map_err(refused)
}

/// The model with the effect whose angles fit a few flights best. An error if no fit succeeds, or cancelled.
fn with_vertical(
    model: &Model,
    dataset: &Dataset,
    options: &FitOptions<'_>,
) -> Result<Model, FitError> {
    let mut few = dataset.clone();
    few.flights.retain(|flight| flight.role == Role::Fit);
    few.flights.truncate(TRIED_FLIGHTS);
    let of_few = FitOptions {
        profiles: &[],
        progress: None,
        ..*options
    };
    let mut best: Option<(f64, [f64; 2])> = None;
    let mut failure = FitError::NothingToFit;
    for direction in directions() {
        options.check_cancelled()?;
        let start = angles(direction);
        match fit::fit(&turned(model, start)?, &few, &of_few) {
            Ok(found) => {
                let misfit = misfit(&found);
                if let Some(angles) = estimated(&found).filter(|_| reaches_noise(&found)) {
                    return turned(model, angles);
                }
                if best.is_none_or(|(least, _)| misfit < least)
                    && let Some(angles) = estimated(&found)
                {
                    best = Some((misfit, angles));
                }
            }
            Err(error) => failure = error,
        }
    }
    match best {
        Some((_, angles)) => turned(model, angles),
        None => Err(failure),
    }
}

/// Whether the residuals of a fit are at the level of the measurement noise.
fn reaches_noise(found: &Fit) -> bool {
    let floor = found.report.position_noise().and_then(|noise| noise.floor);
    floor.is_some_and(|floor| misfit(found) < AT_NOISE * floor)
}

/// Measure of a fit, m: rms residual × (1 + number of excluded flights).
fn misfit(found: &Fit) -> f64 {
    let excluded = found.report.excluded().count() as f64;
    found.report.rms() * (1.0 + excluded)
}

/// Estimated angles of the effect, rad.
fn estimated(found: &Fit) -> Option<[f64; 2]> {
    let value = |name: &str| Some(found.report.coefficients.get(name)?.value);
    Some([value(ANGLES[0])?, value(ANGLES[1])?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::FlightOutcome;
    use crate::vertical::upward;

    #[test]
    fn a_fit_that_leaves_flights_out_is_worse() {
        let (model, dataset) = crate::fit::tests::balls(3, 0.4);
        let mut found = fit::fit(&model, &dataset, &FitOptions::default()).unwrap();
        let of_all = misfit(&found);
        assert!(
            (of_all / found.report.rms() - 1.0).abs() < 1e-12 && of_all > 1e-4,
            "{of_all}"
        );
        let reason = "a net".to_owned();
        found.report.flights[0].outcome = FlightOutcome::Excluded { reason };
        assert!((misfit(&found) / found.report.rms() - 2.0).abs() < 1e-12);
    }

    #[test]
    fn angles_and_directions_are_one_another_s_inverse() {
        for direction in directions() {
            let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
            let back = upward(angles(direction));
            for (a, b) in direction.iter().zip(back) {
                assert!((a / length - b).abs() < 1e-12, "{direction:?} {back:?}");
            }
        }
        assert_eq!(directions().len(), 18);
    }
}
