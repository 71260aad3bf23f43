//! The estimation problem: a model and a dataset, with the parameters that are known and those that are estimated.

mod global_parameters;

use std::collections::BTreeMap;
use std::sync::Arc;

use flight::CompiledModel;
use model_spec::compose::Instrument;
use model_spec::layout::{Layout, ParamId, StateId};
use model_spec::model::Model;

use crate::channel::{self, Channel, ChannelKind};
use crate::dataset::{Dataset, KnownValue, SensorKind, points_on_body};
use crate::error::{FitError, FlightError, NameSource};
use crate::noise::{Moments, NoiseModel, group_count};
use crate::options::FitOptions;
use crate::pose;
use crate::tolerance::FINE_TOLERANCE;
pub use global_parameters::GlobalParameter;

/// Initial standard deviation of one coordinate if the samples do not determine it, m.
const DEFAULT_SIGMA0: f64 = 1e-3;

/// Ratio of the residuals to the noise of the samples above which a fit is a misfit.
const MISFIT_RATIO: f64 = 3.0;

/// A model with the data and options of a fit: known parameters, global parameters to be estimated, markers.
#[derive(Clone)]
pub struct FitProblem {
    /// The model.
    pub model: Arc<Model>,
    /// The compiled model.
    pub body: Arc<CompiledModel>,
    /// Positions of the points that show the pose, in the frame that markers are fixed in, m: the markers, or points that
    /// stand for a pose sensor where there are too few.
    pub markers: Vec<[f64; 3]>,
    /// What residuals are of: the markers, then the channels of the sensors.
    pub channels: Vec<Channel>,
    /// Models whose measurement equation is the quantity of an instrument among the sensors.
    pub instruments: Vec<(Instrument, Arc<CompiledModel>)>,
    /// Whether the body has an attitude, which its markers determine; false for a point mass.
    pub has_attitude: bool,
    /// Values of all parameters in the order of the layout, SI, without those known for a single flight.
    pub parameters: Vec<f64>,
    /// Global parameters, which are estimated from all flights together.
    pub globals: Vec<GlobalParameter>,
    /// Names and values (SI) of coefficients that are fixed.
    pub fixed: Vec<(String, f64)>,
    /// Standard deviation of one measured coordinate if the dataset gives it, m.
    pub sigma: Option<f64>,
    /// Initial estimate, from the samples alone, of the standard deviation of one measured coordinate, m.
    pub sigma0: f64,
    /// Integration tolerance for whitened residuals, in units of `sigma0`.
    pub tolerance: f64,
}

/// Known values of one flight.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct KnownValues {
    /// Known parameter values, SI.
    pub parameters: Vec<(ParamId, f64)>,
    /// Known states at the first sample, SI.
    pub states: Vec<(StateId, f64)>,
}

impl FitProblem {
    /// Compiles the model, with derivatives by the parameters that are estimated, and combines it with a dataset and
    /// options.
    ///
    /// # Errors
    /// [`FitError::UnknownName`], [`FitError::NotEstimated`], [`FitError::NoObservation`],
    /// [`FitError::AttitudeNotObservable`]; [`FitError::Flight`] if a flight's known values do not match the model.
    pub fn new(
        model: &Model,
        dataset: &Dataset,
        options: &FitOptions<'_>,
    ) -> Result<Self, FitError> {
        let layout = Layout::new(model);
        let selected = known_constants(model, &layout, dataset)
            .and_then(|mut known| global_parameters::select(model, &layout, &mut known, options));
        // An error is found again below, in its order among the others.
        let globals = selected.map_or_else(|_| Vec::new(), |(globals, _)| globals);
        let by = globals.iter().map(|global| global.param.index()).collect();
        let body = CompiledModel::with_derivatives_by(model, by);
        Self::with_body(model, body, dataset, options)
    }

    /// As [`new`](Self::new), with a model that is compiled already.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_body(
        model: &Model,
        body: CompiledModel,
        dataset: &Dataset,
        options: &FitOptions<'_>,
    ) -> Result<Self, FitError> {
        let mut parameters = known_constants(model, body.layout(), dataset)?;
        let mut markers: Vec<[f64; 3]> = dataset.markers.iter().map(|m| m.position).collect();
        // Markers of a point mass are fixed in the inertial frame, which is frame 0.
        let marker = model.marker.as_ref();
        let has_attitude = marker.is_some_and(|marker| marker.frame != 0);
        if model.observation.is_none() {
            let model = model.name.clone();
            return Err(FitError::NoObservation { model });
        }
        let (channels, kinds) = channel::of_dataset(dataset);
        let instruments = instruments(model, &kinds)?;
        if has_attitude && !pose::fix_attitude(&markers) {
            let poses = dataset.sensors.iter();
            let poses = poses.filter(|sensor| sensor.kind == SensorKind::Pose);
            markers.extend(poses.flat_map(|sensor| points_on_body(sensor.position)));
        }
        let is_seen_by_instruments = markers.is_empty() && !instruments.is_empty();
        if !has_attitude
            && let Some(pose) = channels.iter().find(|c| c.kind == ChannelKind::Attitude)
        {
            return Err(FitError::Sensor {
                model: model.name.clone(),
                reason: format!("{} is a pose, and a point mass has no attitude", pose.name),
            });
        }
        if has_attitude && !is_seen_by_instruments && !pose::fix_attitude(&markers) {
            return Err(FitError::AttitudeNotObservable {
                model: model.name.clone(),
                markers: markers.len(),
            });
        }
        let (globals, fixed) =
            global_parameters::select(model, body.layout(), &mut parameters, options)?;
        let problem = Self {
            model: Arc::new(model.clone()),
            body: Arc::new(body),
            markers,
            channels,
            instruments,
            has_attitude,
            parameters,
            globals,
            fixed,
            sigma: dataset.sigma,
            sigma0: DEFAULT_SIGMA0,
            tolerance: FINE_TOLERANCE,
        };
        for flight in &dataset.flights {
            let known = problem.known_values(&flight.known);
            known.map_err(|reason| FitError::Flight {
                file: flight.file.clone(),
                reason,
            })?;
        }
        Ok(problem)
    }

    /// Whether markers alone are measured.
    pub(crate) fn sees_markers_alone(&self) -> bool {
        let mut channels = self.channels.iter();
        channels.all(|channel| matches!(channel.kind, ChannelKind::Marker(_)))
    }

    /// Whether the points that show the pose are markers, and not points that stand for a pose sensor.
    pub(crate) fn is_shown_by_markers(&self) -> bool {
        let markers = self.channels.iter();
        let markers = markers.filter(|channel| matches!(channel.kind, ChannelKind::Marker(_)));
        markers.count() == self.markers.len()
    }

    /// Group of each channel whose noise is one process.
    pub fn noise_groups(&self) -> Vec<usize> {
        self.channels.iter().map(|channel| channel.group).collect()
    }

    /// Noise of the groups by sums over their residuals after a fit of this number of unknowns; standard deviations that the
    /// dataset states replace the estimated ones.
    pub fn noise_of(&self, moments: &[Moments], unknowns: usize, interval: f64) -> NoiseModel {
        let all: usize = moments.iter().map(|sum| sum.count).sum();
        let groups = moments.iter().enumerate().map(|(group, sum)| {
            let of_group = self.channels.iter().find(|channel| channel.group == group);
            let given = of_group.and_then(|channel| Some(channel.sigma? * channel.scale));
            // Each group bears its part of the unknowns.
            let unknowns = (unknowns * sum.count).div_ceil(all.max(1));
            sum.noise(unknowns, interval, given)
        });
        NoiseModel::of_groups(groups.collect(), self.noise_groups())
    }

    /// Empty sums for each group.
    pub fn no_moments(&self) -> Vec<Moments> {
        vec![Moments::default(); group_count(&self.noise_groups())]
    }

    /// Whether positions of the body are measured; otherwise its place and heading are free, and have weak priors.
    pub(crate) fn sees_positions(&self) -> bool {
        self.channels.iter().any(Channel::is_position)
    }

    /// Whether the residuals of a channel count in the root mean square of a flight: those of markers, m; without markers
    /// those of pose sensors; without positions all.
    pub fn is_scored(&self, channel: usize) -> bool {
        let is_marker = |channel: &Channel| matches!(channel.kind, ChannelKind::Marker(_));
        match (self.channels.iter().any(is_marker), self.sees_positions()) {
            (true, _) => is_marker(&self.channels[channel]),
            (false, true) => self.channels[channel].is_position(),
            (false, false) => true,
        }
    }

    /// Takes the initial noise estimate and the scales of the channels from another problem of the same dataset.
    pub fn take_scales(&mut self, other: &FitProblem) {
        self.sigma0 = other.sigma0;
        for (channel, other) in self.channels.iter_mut().zip(&other.channels) {
            channel.scale = other.scale;
        }
    }

    /// Whether residuals of this scale, m, are far above the noise of the samples: the model is wrong, or the minimum is.
    pub(crate) fn is_misfit(&self, scale: f64) -> bool {
        scale > MISFIT_RATIO * self.sigma0
    }

    /// Finds the parameters and states that are known for one flight.
    ///
    /// # Errors
    /// [`FlightError::UnknownKnownValue`], [`FlightError::PartialQuaternion`], [`FlightError::KnownAndEstimated`].
    pub(crate) fn known_values(
        &self,
        known: &BTreeMap<String, KnownValue>,
    ) -> Result<KnownValues, FlightError> {
        let layout = self.body.layout();
        let mut found = KnownValues::default();
        for (name, value) in known {
            match value {
                KnownValue::Vector(vector) => {
                    let ids = layout.components(name);
                    let ids = ids.ok_or_else(|| self.unknown_known_value(name))?;
                    found.parameters.extend(ids.into_iter().zip(*vector));
                }
                KnownValue::Scalar(value) => match (layout.parameter(name), layout.state(name)) {
                    (Some(id), _) => found.parameters.push((id, *value)),
                    (None, Some(id)) => found.states.push((id, *value)),
                    (None, None) => return Err(self.unknown_known_value(name)),
                },
            }
        }
        self.check_quaternions(&found.states)?;
        let is_known = |id: ParamId| found.parameters.iter().any(|(known, _)| *known == id);
        match self.globals.iter().find(|global| is_known(global.param)) {
            Some(global) => Err(FlightError::KnownAndEstimated {
                name: global.name.clone(),
            }),
            None => Ok(found),
        }
    }

    /// Returns an error if only some components of a quaternion are known: the norm would not be 1.
    fn check_quaternions(&self, known: &[(StateId, f64)]) -> Result<(), FlightError> {
        let is_known = |state: &usize| known.iter().any(|(id, _)| id.index() == *state);
        let names = &self.body.layout().states;
        for components in self.model.quaternions() {
            let first_known = components.iter().find(|state| is_known(state));
            if let Some(&state) = first_known
                && !components.iter().all(is_known)
            {
                return Err(FlightError::PartialQuaternion {
                    known: names[state].clone(),
                    components: components.map(|state| names[state].clone()).to_vec(),
                });
            }
        }
        Ok(())
    }

    fn unknown_known_value(&self, name: &str) -> FlightError {
        let inputs = self.model.inputs.iter().map(|input| &input.name);
        let layout = self.body.layout();
        let constants = &layout.parameters[..layout.params];
        FlightError::UnknownKnownValue {
            name: name.to_owned(),
            model: self.model.name.clone(),
            available: inputs
                .chain(constants)
                .chain(&layout.states)
                .cloned()
                .collect(),
        }
    }
}

/// The model with a quantity for each instrument among the sensors of a dataset: its own, or the usual one.
///
/// # Errors
/// [`FitError::Sensor`] if the model has no such quantity, as a point mass has no angular velocity.
pub fn measured(model: &Model, dataset: &Dataset) -> Result<Model, FitError> {
    let (_, kinds) = channel::of_dataset(dataset);
    with_instruments(model, &kinds)
}

fn with_instruments(model: &Model, kinds: &[Instrument]) -> Result<Model, FitError> {
    let measured = model.with_instruments(kinds);
    measured.map_err(|error| FitError::Sensor {
        model: model.name.clone(),
        reason: error.to_string(),
    })
}

/// The models that instruments observe, with derivatives by all parameters.
fn instruments(
    model: &Model,
    kinds: &[Instrument],
) -> Result<Vec<(Instrument, Arc<CompiledModel>)>, FitError> {
    if kinds.is_empty() {
        return Ok(Vec::new());
    }
    let measured = with_instruments(model, kinds)?;
    let parameters: Vec<usize> = (0..Layout::new(&measured).parameters.len()).collect();
    let each = kinds.iter().map(|kind| {
        let compiled = CompiledModel::observing(&measured, kind.name(), parameters.clone());
        let missing = || FitError::Sensor {
            model: model.name.clone(),
            reason: format!("it has no quantity `{}`", kind.name()),
        };
        let compiled = compiled.ok_or_else(missing)?;
        Ok((*kind, Arc::new(compiled)))
    });
    each.collect()
}

/// Default parameters, overridden by the known constants of the dataset, SI.
fn known_constants(
    model: &Model,
    layout: &Layout,
    dataset: &Dataset,
) -> Result<Vec<f64>, FitError> {
    let mut parameters = layout.default_parameters();
    for (name, &value) in &dataset.parameters {
        let id = layout.parameter(name);
        let id = id.filter(|id| id.index() < layout.params);
        let id = id.ok_or_else(|| FitError::UnknownName {
            given_in: NameSource::DatasetParameters,
            name: name.clone(),
            model: model.name.clone(),
            available: model.params.iter().map(|c| c.name.clone()).collect(),
        })?;
        parameters[id.index()] = value;
    }
    Ok(parameters)
}
