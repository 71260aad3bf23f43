//! Selects the parameters that are global unknowns of a fit, and the coefficients that are fixed.

use model_spec::layout::{Layout, ParamId};
use model_spec::model::{Model, Parameter};

use crate::error::{FitError, NameSource};
use crate::least_squares::Constraint;
use crate::options::FitOptions;

/// A parameter that is estimated with one common value for all flights.
#[derive(Clone, Debug, PartialEq)]
pub struct GlobalParameter {
    /// Name of the parameter in the model.
    pub name: String,
    /// Index of the parameter in the compiled model's parameter vector.
    pub param: ParamId,
    /// Unit as written in the model.
    pub unit: String,
    /// Bounds and prior of the parameter.
    pub constraint: Constraint,
    /// Initial value, SI: the mean of the prior, or else the value in the dataset, or else the value in the model.
    pub model_value: f64,
    /// Typical magnitude, SI, by which changes of different parameters are made comparable.
    pub x_scale: f64,
}

/// The global parameters that are estimated, and name and value (SI) of each coefficient that is not.
type Selection = (Vec<GlobalParameter>, Vec<(String, f64)>);

/// Selects the global parameters by the options, and writes fixed values into `parameters`; an error for a name that
/// the model does not have or that is not estimated.
pub(super) fn select(
    model: &Model,
    layout: &Layout,
    parameters: &mut [f64],
    options: &FitOptions<'_>,
) -> Result<Selection, FitError> {
    let (mut globals, mut fixed) = coefficients(model, layout, parameters, options)?;
    for name in options.free {
        let param = layout.parameter(name).ok_or_else(|| {
            let available = layout.parameters.clone();
            unknown_name(NameSource::Free, name, model, available)
        })?;
        if globals.iter().any(|global| global.param == param) {
            continue;
        }
        fixed.retain(|(fixed, _)| fixed != name);
        globals.push(freed(
            model,
            name,
            param,
            parameters[param.index()],
            options,
        ));
    }
    add_priors(&mut globals, options)?;
    for name in options.profiles {
        if !globals.iter().any(|global| global.name == *name) {
            return Err(not_estimated(NameSource::Profile, name));
        }
    }
    Ok((globals, fixed))
}

/// Divides the coefficients into global and fixed ones, whose values it writes into `parameters`.
fn coefficients(
    model: &Model,
    layout: &Layout,
    parameters: &mut [f64],
    options: &FitOptions<'_>,
) -> Result<Selection, FitError> {
    for (name, _) in options.fixed {
        if !model.coefficients.iter().any(|c| c.name == *name) {
            let available = model.coefficients.iter().map(|c| c.name.clone());
            return Err(unknown_name(
                NameSource::Fixed,
                name,
                model,
                available.collect(),
            ));
        }
    }
    let (mut globals, mut fixed) = (Vec::new(), Vec::new());
    for (index, coefficient) in model.coefficients.iter().enumerate() {
        let param = layout.coefficient(index);
        // The last of several values for one name applies.
        let mut given = options.fixed.iter().rev();
        match given.find(|(name, _)| *name == coefficient.name) {
            Some((_, value)) => {
                let value = value.unwrap_or(coefficient.value);
                within_bounds(coefficient, value, options)?;
                parameters[param.index()] = value;
                fixed.push((coefficient.name.clone(), value));
            }
            None => globals.push(global(coefficient, param, coefficient.value, options)),
        }
    }
    Ok((globals, fixed))
}

/// An error for a value outside the bounds of a coefficient, where the model does not hold.
fn within_bounds(
    coefficient: &Parameter,
    value: f64,
    options: &FitOptions<'_>,
) -> Result<(), FitError> {
    let bounds = coefficient.bounds.filter(|_| !options.unbounded);
    match bounds {
        Some((low, high)) if !(low..=high).contains(&value) => Err(FitError::InvalidOption {
            option: "the fixed value",
            name: coefficient.name.clone(),
            value,
            expected: "a value within the bounds that the model declares",
        }),
        _ => Ok(()),
    }
}

fn add_priors(globals: &mut [GlobalParameter], options: &FitOptions<'_>) -> Result<(), FitError> {
    for prior in options.priors {
        let global = globals.iter_mut().find(|global| global.name == prior.name);
        let global = global.ok_or_else(|| not_estimated(NameSource::Prior, &prior.name))?;
        global.constraint.prior = Some((prior.value, prior.sigma));
        let (low, high) = global.constraint.bounds;
        global.model_value = prior.value.clamp(low, high);
    }
    Ok(())
}

/// Creates the global parameter for a constant, coefficient or input component that is named in `FitOptions::free`.
fn freed(
    model: &Model,
    name: &str,
    param: ParamId,
    value: f64,
    options: &FitOptions<'_>,
) -> GlobalParameter {
    let mut parameters = model.params.iter().chain(&model.coefficients);
    match parameters.find(|parameter| parameter.name == name) {
        Some(parameter) => global(parameter, param, value, options),
        None => input_component(model, name, param, value),
    }
}

fn global(
    parameter: &Parameter,
    param: ParamId,
    value: f64,
    options: &FitOptions<'_>,
) -> GlobalParameter {
    let bounds = parameter.bounds.filter(|_| !options.unbounded);
    // A default value of 0 gives no magnitude; a tenth of the range between the bounds is used instead.
    let x_scale = match parameter.bounds {
        _ if parameter.value != 0.0 => parameter.value.abs(),
        Some((low, high)) if (high - low).is_finite() => (high - low) / 10.0,
        _ => 1.0,
    };
    GlobalParameter {
        name: parameter.name.clone(),
        param,
        unit: parameter.unit_text.clone(),
        constraint: Constraint {
            bounds: bounds.unwrap_or(Constraint::NONE.bounds),
            prior: None,
        },
        model_value: value,
        x_scale,
    }
}

fn input_component(model: &Model, name: &str, param: ParamId, value: f64) -> GlobalParameter {
    let input = model.inputs.iter().find(|input| {
        let suffix = name.strip_prefix(input.name.as_str());
        suffix.is_some_and(|suffix| ["_x", "_y", "_z"].contains(&suffix))
    });
    GlobalParameter {
        name: name.to_owned(),
        param,
        unit: input
            .map(|input| input.unit_text.clone())
            .unwrap_or_default(),
        constraint: Constraint::NONE,
        model_value: value,
        x_scale: 1.0,
    }
}

fn unknown_name(
    given_in: NameSource,
    name: &str,
    model: &Model,
    available: Vec<String>,
) -> FitError {
    FitError::UnknownName {
        given_in,
        name: name.to_owned(),
        model: model.name.clone(),
        available,
    }
}

fn not_estimated(given_in: NameSource, name: &str) -> FitError {
    FitError::NotEstimated {
        given_in,
        name: name.to_owned(),
    }
}
