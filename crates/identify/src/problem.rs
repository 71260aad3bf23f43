//! A model with what a dataset and a user say of it: what is known, what is estimated.

use std::sync::Arc;

use flight::CompiledModel;
use model_spec::layout::ParamId;
use model_spec::model::{Model, Parameter};

use crate::dataset::{Dataset, KnownValue};
use crate::least_squares::Constraint;
use crate::options::FitOptions;
use crate::pose;
use crate::predict::FINE;
use crate::wording::count;

/// Why a dataset cannot be fitted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// The dataset, the model and the options do not go together.
    #[error("{0}")]
    Mismatch(String),
    /// A flight cannot be used.
    #[error("{file}: {reason}")]
    Flight {
        /// Its file.
        file: String,
        /// In words.
        reason: String,
    },
    /// No flight can be used.
    #[error("none of the flights can be fitted:\n{0}")]
    NoFlight(String),
    /// The work was stopped.
    #[error("interrupted")]
    Interrupted,
}

/// An unknown that all flights share.
#[derive(Clone, Debug, PartialEq)]
pub struct GlobalParameter {
    /// Its name.
    pub name: String,
    /// Its place among the parameters of the layout.
    pub param: usize,
    /// Its unit.
    pub unit: String,
    /// What is known of it beforehand.
    pub constraint: Constraint,
    /// What the model's file, or the dataset, says: where the fit starts.
    pub model_value: f64,
    /// A size that is usual for it.
    pub x_scale: f64,
}

/// Noise that is assumed where the data say nothing of it, m.
const NO_FLOOR: f64 = 1e-3;

/// The model with what is known and what is estimated.
#[derive(Clone)]
pub struct FitProblem {
    /// The model.
    pub model: Arc<Model>,
    /// The model, ready to fly.
    pub body: Arc<CompiledModel>,
    /// Positions of the markers in the frame that they are fixed in, m.
    pub markers: Vec<[f64; 3]>,
    /// Whether the body turns and its markers show how.
    pub has_attitude: bool,
    /// Parameters in the order of the layout, before a flight's own known ones.
    pub parameters: Vec<f64>,
    /// What is estimated.
    pub globals: Vec<GlobalParameter>,
    /// Coefficients that are held: name, value.
    pub fixed: Vec<(String, f64)>,
    /// Standard deviation of one measured coordinate where the dataset says it, m.
    pub sigma: Option<f64>,
    /// A first estimate of it from the tracks alone, m; the integration is far more exact than that.
    pub sigma0: f64,
    /// Tolerance of the integration over that size, per metre, where residuals are weighed by the noise.
    pub tolerance: f64,
}

impl FitProblem {
    /// Puts a dataset and options to a model.
    ///
    /// # Errors
    /// [`FitError::Mismatch`], [`FitError::Flight`].
    pub fn new(
        model: &Model,
        dataset: &Dataset,
        options: &FitOptions<'_>,
    ) -> Result<Self, FitError> {
        Self::with_body(model, CompiledModel::new(model), dataset, options)
    }

    /// The same with the model made ready already.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_body(
        model: &Model,
        body: CompiledModel,
        dataset: &Dataset,
        options: &FitOptions<'_>,
    ) -> Result<Self, FitError> {
        let layout = body.layout();
        let mut parameters = layout.default_parameters();
        for (name, &value) in &dataset.parameters {
            let place = layout.parameter(name).map(ParamId::index);
            let place = place.filter(|&p| p < layout.params);
            let known = model.params.iter().map(|c| c.name.as_str());
            let place =
                place.ok_or_else(|| mismatch("the dataset sets", name, &model.name, known))?;
            parameters[place] = value;
        }
        let markers: Vec<[f64; 3]> = dataset.markers.iter().map(|m| m.position).collect();
        // Markers that move with the body as it turns; those of a point mass stand in the inertial frame.
        let has_attitude = model
            .marker
            .as_ref()
            .is_some_and(|marker| marker.frame != 0);
        if model.observation.is_none() {
            let reason = format!(
                "the model {} does not say what is observed of it",
                model.name
            );
            return Err(FitError::Mismatch(reason));
        }
        if has_attitude && !pose::fix_attitude(&markers) {
            let reason = format!(
                "the model {} turns, and {} do not show how: three are needed that are not in line",
                model.name,
                count(markers.len(), "marker")
            );
            return Err(FitError::Mismatch(reason));
        }
        let (global, held) = unknowns(model, &body, &mut parameters, options)?;
        let problem = Self {
            model: Arc::new(model.clone()),
            body: Arc::new(body),
            markers,
            has_attitude,
            parameters,
            globals: global,
            fixed: held,
            sigma: dataset.sigma,
            sigma0: NO_FLOOR,
            tolerance: FINE,
        };
        for flight in &dataset.flights {
            problem
                .known(&flight.known)
                .map_err(|reason| FitError::Flight {
                    file: flight.file.clone(),
                    reason,
                })?;
        }
        Ok(problem)
    }

    /// What is known of a flight: places and values of parameters, then of states.
    pub fn known(
        &self,
        known: &std::collections::BTreeMap<String, KnownValue>,
    ) -> Result<[Vec<(usize, f64)>; 2], String> {
        let layout = self.body.layout();
        let (mut parameters, mut states) = (Vec::new(), Vec::new());
        for (name, value) in known {
            match value {
                KnownValue::Vector(vector) => {
                    let places = layout.components(name);
                    let places = places.ok_or_else(|| self.not_known(name))?;
                    parameters.extend(places.map(ParamId::index).into_iter().zip(*vector));
                }
                KnownValue::Scalar(value) => match (layout.parameter(name), layout.state(name)) {
                    (Some(place), _) => parameters.push((place.index(), *value)),
                    (None, Some(state)) => states.push((state.index(), *value)),
                    (None, None) => return Err(self.not_known(name)),
                },
            }
        }
        if let Some(global) = self
            .globals
            .iter()
            .find(|global| parameters.iter().any(|(place, _)| *place == global.param))
        {
            return Err(format!(
                "{} is known of it, and it is to be estimated for all flights",
                global.name
            ));
        }
        Ok([parameters, states])
    }

    fn not_known(&self, name: &str) -> String {
        let inputs = self.model.inputs.iter().map(|input| input.name.as_str());
        let layout = self.body.layout();
        let rest = layout.parameters[..layout.params]
            .iter()
            .chain(&layout.states);
        let names: Vec<&str> = inputs.chain(rest.map(String::as_str)).collect();
        format!(
            "{name} is known of it, and the model {} has the vectors and numbers {}",
            self.model.name,
            names.join(", ")
        )
    }
}

/// What is estimated, and what is held: name and value.
type Unknowns = (Vec<GlobalParameter>, Vec<(String, f64)>);

/// Sorts the coefficients, and what is freed beside them, into those.
fn unknowns(
    model: &Model,
    body: &CompiledModel,
    parameters: &mut [f64],
    options: &FitOptions<'_>,
) -> Result<Unknowns, FitError> {
    let layout = body.layout();
    let coefficients = || model.coefficients.iter().map(|c| c.name.as_str());
    let named = |name: &str| model.coefficients.iter().position(|c| c.name == name);
    for (name, _) in options.fixed {
        named(name).ok_or_else(|| mismatch("to be held is", name, &model.name, coefficients()))?;
    }
    let (mut global, mut held) = (Vec::new(), Vec::new());
    for (index, constant) in model.coefficients.iter().enumerate() {
        let place = layout.coefficient(index).index();
        // The last word counts.
        match options
            .fixed
            .iter()
            .rev()
            .find(|(name, _)| *name == constant.name)
        {
            Some((_, value)) => {
                parameters[place] = value.unwrap_or(constant.value);
                held.push((constant.name.clone(), parameters[place]));
            }
            None => global.push(unknown(constant, place, constant.value, options)),
        }
    }
    for name in options.free {
        let place = layout.parameter(name).map(ParamId::index);
        let all = || layout.parameters.iter().map(String::as_str);
        let place = place.ok_or_else(|| mismatch("to be freed is", name, &model.name, all()))?;
        if global
            .iter()
            .any(|global: &GlobalParameter| global.param == place)
        {
            continue;
        }
        held.retain(|(held, _)| held != name);
        let constant = model
            .params
            .iter()
            .chain(&model.coefficients)
            .find(|c| c.name == *name);
        global.push(match constant {
            Some(constant) => unknown(constant, place, parameters[place], options),
            None => of_input(model, name, place, parameters[place]),
        });
    }
    for prior in options.priors {
        let unknown = global.iter_mut().find(|global| global.name == prior.name);
        let unknown = unknown.ok_or_else(|| {
            let reason = format!("a prior for {}, which is not estimated", prior.name);
            FitError::Mismatch(reason)
        })?;
        unknown.constraint.prior = Some((prior.value, prior.sigma));
        let (low, high) = unknown.constraint.bounds;
        unknown.model_value = prior.value.clamp(low, high);
    }
    for name in options.profiles {
        if !global.iter().any(|global| global.name == *name) {
            let reason = format!("a profile of {name}, which is not estimated");
            return Err(FitError::Mismatch(reason));
        }
    }
    Ok((global, held))
}

fn unknown(
    constant: &Parameter,
    place: usize,
    value: f64,
    options: &FitOptions<'_>,
) -> GlobalParameter {
    let bounds = constant.bounds.filter(|_| !options.unbounded);
    // A coefficient that vanishes by default says nothing of its size; a tenth of its range does.
    let usual = match constant.bounds {
        _ if constant.value != 0.0 => constant.value.abs(),
        Some((low, high)) if (high - low).is_finite() => (high - low) / 10.0,
        _ => 1.0,
    };
    GlobalParameter {
        name: constant.name.clone(),
        param: place,
        unit: constant.unit_text.clone(),
        constraint: Constraint {
            bounds: bounds.unwrap_or(Constraint::NONE.bounds),
            prior: None,
        },
        model_value: value,
        x_scale: usual,
    }
}

fn of_input(model: &Model, name: &str, place: usize, value: f64) -> GlobalParameter {
    let input = model.inputs.iter().find(|input| {
        let rest = name.strip_prefix(input.name.as_str());
        rest.is_some_and(|rest| ["_x", "_y", "_z"].contains(&rest))
    });
    GlobalParameter {
        name: name.to_owned(),
        param: place,
        unit: input
            .map(|input| input.unit_text.clone())
            .unwrap_or_default(),
        constraint: Constraint::NONE,
        model_value: value,
        x_scale: 1.0,
    }
}

fn mismatch<'n>(
    what: &str,
    name: &str,
    model: &str,
    known: impl Iterator<Item = &'n str>,
) -> FitError {
    let known: Vec<&str> = known.collect();
    FitError::Mismatch(format!(
        "{what} {name}, and the model {model} has {}",
        known.join(", ")
    ))
}
