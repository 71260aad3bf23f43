//! The estimation problem: a model and a dataset, with known and estimated parameters.

mod global_parameters;
mod noise;
mod tolerances;

use std::sync::Arc;

use flight::CompiledModel;
use model_spec::compose::Instrument;
use model_spec::layout::{Layout, ParamId, StateId};
use model_spec::model::Model;
use nalgebra::DVector;

use crate::channel::{self, Channel, ChannelKind};
use crate::error::{FitError, FlightError, NameSource};
use crate::options::FitOptions;
use crate::rounding;
use crate::summary::{self, SummaryModel};
use dataset::levels::FAR_ABOVE;
use dataset::pose::fix_attitude;
use dataset::{AXES, Dataset, Flight, KnownValue, PosePoints};
pub use global_parameters::GlobalParameter;
pub use tolerances::{FINE_TOLERANCE, RESIDUAL_TOLERANCE, robust_tolerance, whitened_tolerance};

/// Standard deviation of the noise of one measured coordinate, m, assumed initially if the samples do not determine it.
const DEFAULT_SIGMA0: f64 = 1e-3;

/// A model with the data and options of a fit: channels, known parameters, and those to be estimated.
#[derive(Clone)]
pub struct FitProblem {
    /// Model whose parameters are estimated.
    pub model: Arc<Model>,
    /// The compiled model, with its equations of motion and the measurement equation of a body-fixed point.
    pub body: Arc<CompiledModel>,
    /// Points of the body that show its pose.
    pub points: PosePoints,
    /// Measurement channels: the markers, then the channels of the sensors. Each channel has its own residuals.
    pub channels: Vec<Channel>,
    /// For each kind of instrument, the compiled model that observes the quantity it measures.
    pub instruments: Vec<(Instrument, Arc<CompiledModel>)>,
    /// Functions of the model for summaries; `None` if the dataset has none.
    pub summary: Option<Arc<SummaryModel>>,
    /// Values of all parameters in the order of the compiled model, SI, but for those known for single flights.
    pub parameters: Vec<f64>,
    /// Global parameters, which are estimated from all flights together.
    pub globals: Vec<GlobalParameter>,
    /// Names and values (SI) of the coefficients that are not estimated.
    pub fixed: Vec<(String, f64)>,
    /// Standard deviation of the noise of one measured coordinate, m; `None` if the dataset does not give it.
    pub sigma: Option<f64>,
    /// Initial estimate, from the samples alone, of the standard deviation of the noise of one measured coordinate, m.
    pub sigma0: f64,
    /// Quantities that are estimated for each flight by itself.
    pub unknown: Vec<String>,
    /// Integration tolerance for computing whitened residuals, in units of the initial noise estimate `sigma0`.
    pub tolerance: f64,
}

/// Parameters and initial states whose values are known for one flight.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct KnownValues {
    pub parameters: Vec<(ParamId, f64)>,
    pub states: Vec<(StateId, f64)>,
    pub priors: Vec<StatePrior>,
}

/// Gaussian prior of a state at the first sample of a flight, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StatePrior {
    /// The state.
    pub state: StateId,
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub sigma: f64,
    /// Whether the value was measured with this standard deviation; otherwise it is unknown, and the prior is wide.
    pub is_measured: bool,
}

/// Where a known value belongs.
enum Place {
    Parameter(ParamId),
    State(StateId),
}

fn components(value: &KnownValue) -> Vec<f64> {
    match value {
        KnownValue::Scalar(value) => vec![*value],
        KnownValue::Vector(vector) => vector.to_vec(),
    }
}

/// Prior standard deviation about 0 by the unit of a state, far wider than what a flight determines.
pub(crate) fn wide_deviation(unit: &str) -> f64 {
    match unit {
        "m" => 10.0,
        "m/s" => 100.0,
        "rad" => 3.0,
        "rad/s" => 1000.0,
        _ => 1.0,
    }
}

/// Standard deviation of the prior of an unknown quantity, over the model's value of it.
const WIDE: f64 = 10.0;

impl FitProblem {
    /// Compiles the model, with derivatives by the estimated parameters, for a dataset and options.
    ///
    /// # Errors
    /// [`FitError::UnknownName`] for a name that the model does not have; [`FitError::NotEstimated`] for a prior or
    /// profile of a fixed parameter; [`FitError::Constraint`] for one in a constraint; [`FitError::NoObservation`] without a measurement equation; [`FitError::Sensor`]
    /// without one for a sensor; [`FitError::AttitudeNotObservable`] if the markers do not determine the attitude;
    /// [`FitError::Flight`] if the known values of a flight do not match; [`FitError::Inertia`] for moments of inertia of
    /// no body.
    pub fn new(
        model: &Model,
        dataset: &Dataset,
        options: &FitOptions<'_>,
    ) -> Result<Self, FitError> {
        Self::with_body(model, dataset, options, |globals| {
            let by = globals.iter().map(|global| global.param.index()).collect();
            CompiledModel::with_derivatives_by(model, by)
        })
    }

    /// [`new`](Self::new) for a model that `compile` compiles, given what is estimated.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new).
    pub fn with_body(
        model: &Model,
        dataset: &Dataset,
        options: &FitOptions<'_>,
        compile: impl FnOnce(&[GlobalParameter]) -> CompiledModel,
    ) -> Result<Self, FitError> {
        let layout = Layout::new(model);
        let mut parameters = known_constants(model, &layout, dataset)?;
        let points = PosePoints::new(model, dataset);
        let has_attitude = points.has_attitude;
        if model.observation.is_none() {
            let model = model.name.clone();
            return Err(FitError::NoObservation { model });
        }
        let (mut channels, kinds) = channel::of_dataset(dataset);
        rounding::set(&mut channels, dataset);
        let instruments = instruments(model, &kinds)?;
        let is_summary = channels
            .iter()
            .all(|own| summary::event(own.kind).is_some());
        let summary = summary::of_channels(model, dataset, &mut channels)?;
        let is_seen_by_instruments = points.markers.is_empty() && !instruments.is_empty();
        if !has_attitude
            && let Some(pose) = channels.iter().find(|c| c.kind == ChannelKind::Attitude)
        {
            return Err(FitError::Sensor {
                model: model.name.clone(),
                reason: format!("{} is a pose, and a point mass has no attitude", pose.name),
            });
        }
        let is_seen = is_seen_by_instruments || is_summary;
        if has_attitude && !is_seen && !fix_attitude(&points.markers) {
            return Err(FitError::AttitudeNotObservable {
                model: model.name.clone(),
                markers: dataset.markers.len(),
            });
        }
        let (globals, fixed) = global_parameters::select(model, &layout, &mut parameters, options)?;
        let body = compile(&globals);
        if let Some(constraints) = body.constraints() {
            let indices = globals.iter().map(|global| global.param.index());
            let mut held = indices.filter(|&index| constraints.depend_on(&parameters, index));
            if let Some(index) = held.next() {
                let (model, name) = (model.name.clone(), body.layout().parameters[index].clone());
                return Err(FitError::Constraint { model, name });
            }
        }
        let problem = Self {
            model: Arc::new(model.clone()),
            body: Arc::new(body),
            points,
            channels,
            instruments,
            summary,
            parameters,
            globals,
            fixed,
            sigma: dataset.sigma,
            sigma0: DEFAULT_SIGMA0,
            unknown: dataset.unknown.clone(),
            tolerance: FINE_TOLERANCE,
        };
        for flight in &dataset.flights {
            let known = problem.known_values(flight, &dataset.unknown);
            known.map_err(|reason| FitError::Flight {
                file: flight.file.clone(),
                reason,
            })?;
        }
        Ok(problem)
    }

    /// Indices of the global parameters among those of the model.
    pub fn global_parameters(&self) -> Vec<ParamId> {
        self.globals.iter().map(|global| global.param).collect()
    }

    pub(crate) fn sees_markers_alone(&self) -> bool {
        self.channels.iter().all(Channel::is_marker)
    }

    /// Initial values of the global parameters, SI, in the order of [`globals`](Self::globals).
    pub(crate) fn model_values(&self) -> DVector<f64> {
        let values = self.globals.iter().map(|global| global.model_value);
        DVector::from_iterator(self.globals.len(), values)
    }

    /// Whether positions are measured. If not, initial position and heading are open and have weak priors.
    pub(crate) fn sees_positions(&self) -> bool {
        self.channels.iter().any(Channel::is_position)
    }

    /// Whether the channel counts in the rms residual: markers; else positions of poses; else all.
    pub fn is_scored(&self, channel: usize) -> bool {
        let own = &self.channels[channel];
        if self.channels.iter().any(Channel::is_marker) {
            own.is_marker()
        } else {
            own.is_position() || !self.sees_positions()
        }
    }

    /// Copies the initial noise estimate, and scales and noise groups of the channels, from another problem of the same
    /// dataset.
    pub fn take_scales(&mut self, other: &FitProblem) {
        self.sigma0 = other.sigma0;
        for (channel, other) in self.channels.iter_mut().zip(&other.channels) {
            (channel.scale, channel.group) = (other.scale, other.group);
        }
    }

    /// Whether residuals of standard deviation `scale`, m, are far above the noise.
    pub(crate) fn is_misfit(&self, scale: f64) -> bool {
        scale > FAR_ABOVE * self.sigma0
    }

    /// The parameters and states that are known for one flight; `unknown` are the quantities that no flight knows.
    pub(crate) fn known_values(
        &self,
        flight: &Flight,
        unknown: &[String],
    ) -> Result<KnownValues, FlightError> {
        let mut found = KnownValues::default();
        let sigma_of = |name: &str| flight.known.get(&format!("{name}{}", KnownValue::SIGMA));
        let is_sigma = |name: &str| {
            let of = name.strip_suffix(KnownValue::SIGMA);
            of.is_some_and(|of| flight.known.contains_key(of))
        };
        for (name, value) in flight.known.iter().filter(|(name, _)| !is_sigma(name)) {
            let values = components(value);
            let places = self.places(name, values.len());
            let places = places.ok_or_else(|| self.unknown_known_value(name))?;
            let sigmas = sigma_of(name).map(components);
            for (k, (place, value)) in places.into_iter().zip(values).enumerate() {
                match (place, sigmas.as_ref().and_then(|all| all.get(k))) {
                    (Place::Parameter(id), None) => found.parameters.push((id, value)),
                    (Place::State(id), None) => found.states.push((id, value)),
                    (Place::State(state), Some(&sigma)) => found.priors.push(StatePrior {
                        state,
                        mean: value,
                        sigma,
                        is_measured: true,
                    }),
                    (Place::Parameter(_), Some(_)) => {
                        return Err(FlightError::SigmaOfConstant { name: name.clone() });
                    }
                }
            }
        }
        if !found.parameters.is_empty() {
            let mut all = self.parameters.clone();
            { found.parameters.iter() }.for_each(|(id, value)| all[id.index()] = *value);
            let fault = inertia_fault(&self.model, self.body.layout(), &all);
            fault.map_or(Ok(()), |fault| Err(FlightError::Inertia(fault)))?;
        }
        self.free_unknowns(flight, unknown, &mut found);
        self.check_quaternions(&found.states)?;
        let is_known = |id: ParamId| found.parameters.iter().any(|(known, _)| *known == id);
        match self.globals.iter().find(|global| is_known(global.param)) {
            Some(global) => Err(FlightError::KnownAndEstimated {
                name: global.name.clone(),
            }),
            None => Ok(found),
        }
    }

    /// Of the states that stand for quantities unknown in some flight, those that this one does not know get a wide
    /// prior, the others keep the model's value, or 0 beside an input over time.
    fn free_unknowns(&self, flight: &Flight, unknown: &[String], found: &mut KnownValues) {
        let states = &self.model.states;
        for (name, of) in self.model.unknown_states() {
            let id = StateId::new(of);
            let is_given = found.states.iter().any(|(state, _)| *state == id)
                || found.priors.iter().any(|prior| prior.state == id);
            if is_given {
                continue;
            }
            let mean = states[of].value;
            if flight.inputs.iter().any(|(own, _)| *own == name) {
                found.states.push((id, 0.0));
            } else if unknown.contains(&name) || flight.unknown.contains(&name) {
                let wide = wide_deviation(&states[of].unit_text);
                found.priors.push(StatePrior {
                    state: id,
                    mean,
                    sigma: wide.max(WIDE * mean.abs()),
                    is_measured: false,
                });
            } else {
                found.states.push((id, mean));
            }
        }
    }

    /// Parameters or states that `name` speaks of: one, or the three components of a vector.
    fn places(&self, name: &str, count: usize) -> Option<Vec<Place>> {
        let layout = self.body.layout();
        let unknown = self.model.unknown_states().into_iter();
        let unknown = unknown.filter(|(own, _)| own == name);
        let states: Vec<Place> = unknown
            .map(|(_, of)| Place::State(StateId::new(of)))
            .collect();
        if states.len() == count {
            return Some(states);
        }
        let place = |name: &str| match (layout.parameter(name), layout.state(name)) {
            (Some(id), _) => Some(Place::Parameter(id)),
            (None, Some(id)) => Some(Place::State(id)),
            (None, None) => None,
        };
        match count {
            1 => Some(vec![place(name)?]),
            _ => AXES
                .iter()
                .map(|axis| place(&format!("{name}_{axis}")))
                .collect(),
        }
    }

    /// A quaternion known in part would not have norm 1 in general.
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

/// The model with the quantity that each kind of instrument measures, by default definition if it lacks it.
///
/// # Errors
/// [`FitError::Sensor`] if the model can have no such quantity, as a point mass no angular velocity.
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

/// Compiles, for each kind of instrument, the model that observes its quantity, with derivatives by all parameters.
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
    match inertia_fault(model, layout, &parameters).filter(|_| !dataset.parameters.is_empty()) {
        Some(fault) => Err(FitError::Inertia(fault)),
        None => Ok(parameters),
    }
}

/// Why no body has the inertia tensor of the model with the values `parameters`.
fn inertia_fault(model: &Model, layout: &Layout, parameters: &[f64]) -> Option<String> {
    model.inertia_fault(|own| {
        let id = layout.parameter(&own.name);
        id.map_or(own.value, |id| parameters[id.index()])
    })
}
