//! The estimation problem: a model and a dataset, with known and estimated parameters.

mod global_parameters;

use std::collections::BTreeMap;
use std::sync::Arc;

use flight::CompiledModel;
use model_spec::compose::Instrument;
use model_spec::layout::{Layout, ParamId, StateId};
use model_spec::model::Model;
use nalgebra::DVector;

use crate::channel::{self, Channel, ChannelKind};
use crate::error::{FitError, FlightError, NameSource};
use crate::noise::{Moments, NoiseModel, group_count};
use crate::options::FitOptions;
use crate::tolerance::FINE_TOLERANCE;
use dataset::pose;
use dataset::{Dataset, KnownValue, SensorKind, points_on_body};
pub use global_parameters::GlobalParameter;

/// Standard deviation of the noise of one measured coordinate, m, assumed initially if the samples do not determine it.
const DEFAULT_SIGMA0: f64 = 1e-3;

/// Ratio of the standard deviation of the residuals to the initial noise estimate `sigma0`, above which the model is
/// considered wrong or the minimum a local one.
const MISFIT_RATIO: f64 = 3.0;

/// A model with the data and options of a fit: measured channels, known parameters and global parameters to be
/// estimated.
#[derive(Clone)]
pub struct FitProblem {
    /// Model whose parameters are estimated.
    pub model: Arc<Model>,
    /// The compiled model, with its equations of motion and the measurement equation of a body-fixed point.
    pub body: Arc<CompiledModel>,
    /// Points from which the pose is determined: their positions in the frame in which markers are fixed, m. The first
    /// points are the markers. If the markers do not determine the attitude, body-fixed points follow, whose measured
    /// positions are computed from the pose that a sensor measures.
    pub markers: Vec<[f64; 3]>,
    /// Measurement channels: the markers, then the channels of the sensors. Each channel has its own residuals.
    pub channels: Vec<Channel>,
    /// For each kind of instrument among the sensors, the compiled model whose measurement equation is the quantity
    /// that it measures.
    pub instruments: Vec<(Instrument, Arc<CompiledModel>)>,
    /// Whether the body of the model has an attitude; `false` for a point mass.
    pub has_attitude: bool,
    /// Values of all parameters in the order of the compiled model's parameter vector, SI. Values that are known for
    /// single flights only are not included.
    pub parameters: Vec<f64>,
    /// Global parameters, which are estimated from all flights together.
    pub globals: Vec<GlobalParameter>,
    /// Names and values (SI) of the coefficients that are not estimated.
    pub fixed: Vec<(String, f64)>,
    /// Standard deviation of the noise of one measured coordinate, m; `None` if the dataset does not give it.
    pub sigma: Option<f64>,
    /// Initial estimate, from the samples alone, of the standard deviation of the noise of one measured coordinate, m.
    pub sigma0: f64,
    /// Integration tolerance for computing whitened residuals, in units of the initial noise estimate `sigma0`.
    pub tolerance: f64,
}

/// Parameters and initial states whose values are known for one flight.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct KnownValues {
    /// Indices and values (SI) of the known parameters.
    pub parameters: Vec<(ParamId, f64)>,
    /// Indices and values (SI) of the states that are known at the first sample.
    pub states: Vec<(StateId, f64)>,
}

impl FitProblem {
    /// Compiles the model, with derivatives with respect to the estimated parameters, and combines it with a dataset
    /// and options.
    ///
    /// # Errors
    /// [`FitError::UnknownName`] if the dataset or the options contain a name that the model does not have;
    /// [`FitError::NotEstimated`] for a prior or profile of a fixed parameter; [`FitError::NoObservation`] if the model
    /// has no measurement equation; [`FitError::Sensor`] if it has none for a sensor;
    /// [`FitError::AttitudeNotObservable`] if the markers do not determine the attitude; [`FitError::Flight`] if a
    /// flight's known values do not match the model.
    pub fn new(
        model: &Model,
        dataset: &Dataset,
        options: &FitOptions<'_>,
    ) -> Result<Self, FitError> {
        let layout = Layout::new(model);
        let selected = known_constants(model, &layout, dataset)
            .and_then(|mut known| global_parameters::select(model, &layout, &mut known, options));
        // The same error is returned by `with_body`, in the order of its checks.
        let globals = selected.map_or_else(|_| Vec::new(), |(globals, _)| globals);
        let by = globals.iter().map(|global| global.param.index()).collect();
        let body = CompiledModel::with_derivatives_by(model, by);
        Self::with_body(model, body, dataset, options)
    }

    /// Combines a model, which is already compiled as `body`, with a dataset and options.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new).
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

    /// Whether all channels are markers.
    pub(crate) fn sees_markers_alone(&self) -> bool {
        self.channels.iter().all(Channel::is_marker)
    }

    /// Whether the pose is determined from markers only. Otherwise, it is also determined from body-fixed points, whose
    /// positions are computed from the pose that a sensor measures.
    pub(crate) fn is_shown_by_markers(&self) -> bool {
        let markers = self.channels.iter().filter(|channel| channel.is_marker());
        markers.count() == self.markers.len()
    }

    /// Initial values of the global parameters, SI, in the order of [`globals`](Self::globals).
    pub(crate) fn model_values(&self) -> DVector<f64> {
        let values = self.globals.iter().map(|global| global.model_value);
        DVector::from_iterator(self.globals.len(), values)
    }

    /// For each channel, the index of its noise group. The channels of a group have the same standard deviations and
    /// autocorrelations of the noise.
    pub fn noise_groups(&self) -> Vec<usize> {
        self.channels.iter().map(|channel| channel.group).collect()
    }

    /// Estimates the noise of each group from `moments`, the sums of squares and products of its residuals after a fit
    /// of `unknowns` unknowns, for a sampling interval in s. Standard deviations that the dataset gives replace the
    /// estimated ones.
    pub fn noise_of(&self, moments: &[Moments], unknowns: usize, interval: f64) -> NoiseModel {
        let all: usize = moments.iter().map(|sum| sum.count).sum();
        let groups = moments.iter().enumerate().map(|(group, sum)| {
            let of_group = self.channels.iter().find(|channel| channel.group == group);
            let given = of_group.and_then(|channel| Some(channel.sigma? * channel.scale));
            // The unknowns are distributed over the groups in proportion to their residuals.
            let unknowns = (unknowns * sum.count).div_ceil(all.max(1));
            sum.noise(unknowns, interval, given)
        });
        NoiseModel::of_groups(groups.collect(), self.noise_groups())
    }

    /// Creates empty sums of squares and products of residuals, one `Moments` for each noise group.
    pub fn no_moments(&self) -> Vec<Moments> {
        vec![Moments::default(); group_count(&self.noise_groups())]
    }

    /// Whether positions of the body are measured. If not, the data do not determine the initial position and heading
    /// of the body, which then have weak priors.
    pub(crate) fn sees_positions(&self) -> bool {
        self.channels.iter().any(Channel::is_position)
    }

    /// Whether the residuals of a channel count in the root mean square residual of a flight. Markers count; without
    /// markers, positions of pose sensors; without measured positions, all channels.
    pub fn is_scored(&self, channel: usize) -> bool {
        let own = &self.channels[channel];
        match self.channels.iter().any(Channel::is_marker) {
            true => own.is_marker(),
            false => own.is_position() || !self.sees_positions(),
        }
    }

    /// Copies the initial noise estimate and the scales of the channels from another problem of the same dataset.
    pub fn take_scales(&mut self, other: &FitProblem) {
        self.sigma0 = other.sigma0;
        for (channel, other) in self.channels.iter_mut().zip(&other.channels) {
            channel.scale = other.scale;
        }
    }

    /// Whether residuals of standard deviation `scale`, m, are far above the measurement noise, because the model is
    /// wrong or the minimum is a local one.
    pub(crate) fn is_misfit(&self, scale: f64) -> bool {
        scale > MISFIT_RATIO * self.sigma0
    }

    /// Finds the parameters and states that are known for one flight, by their names.
    ///
    /// # Errors
    /// [`FlightError::UnknownKnownValue`] for a name that the model does not have; [`FlightError::PartialQuaternion`]
    /// if only some components of a quaternion are known; [`FlightError::KnownAndEstimated`] if a known parameter is
    /// also a global unknown.
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

    /// Returns an error if only some components of a quaternion are known, because these and the default values of
    /// the others together would in general not have norm 1.
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

/// Returns the model with the quantity that each kind of instrument in the dataset measures, such as the angular
/// velocity for a gyroscope. If the model does not define this quantity, its default definition is added.
///
/// # Errors
/// [`FitError::Sensor`] if the model can have no such quantity; a point mass, for example, has no angular velocity.
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

/// Compiles, for each kind of instrument, the model whose measurement equation is the quantity that it measures, with
/// derivatives with respect to all parameters.
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

/// Values of all parameters, SI: the defaults, overridden by the known constants of the dataset.
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
