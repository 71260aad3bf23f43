//! Releases: initial conditions and end of a flight, and those that are built in.

use std::sync::Arc;

use model_spec::model::{Model, Parameter};

use crate::InputSeries;
use crate::toml_reader::Name;
use crate::wind::WindField;

/// Largest deviation from 1 of the length of an initial attitude quaternion; files state six decimals.
const QUATERNION_TOLERANCE: f64 = 1e-6;

/// Initial conditions, parameters, wind and end of a flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Release {
    /// Name of the model, or its path: one beside the release file is found there.
    pub model: String,
    /// Condition that ends the flight.
    pub stop: Stop,
    /// Values (SI) of parameters that replace the model's defaults, by name.
    pub parameters: Vec<(String, f64)>,
    /// Values (SI) of coefficients that replace the model's defaults, by name.
    pub coefficients: Vec<(String, f64)>,
    /// Name and initial value (SI) of every state, in the model's order.
    pub initial: Vec<(String, f64)>,
    /// Constant wind: velocity of the air in the inertial frame, m/s.
    pub wind: [f64; 3],
    /// Wind by height and gusts; with it, the flight needs the model that [`WindField::compose`] returns.
    pub wind_field: Option<WindField>,
    /// Values (SI) of the model's vector inputs other than the wind, by name; the inputs are known for each flight.
    pub known: Vec<(String, [f64; 3])>,
    /// Scalar inputs that vary during the flight, by name; constant ones are among the parameters.
    pub inputs: Vec<(String, InputSeries)>,
}

/// Condition that ends a flight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stop {
    /// The flight ends after this duration since release, s.
    Duration(f64),
    /// The flight ends when the height, the third coordinate of the place of the body, falls to 0.
    Ground,
}

impl Release {
    /// Maximum duration in a release file, and of a flight that ends at the ground, s.
    pub const MAX_DURATION: f64 = 600.0;

    /// Release of a model with its default values, those of its wind among them, which ends at the ground.
    #[doc(hidden)]
    pub fn of(model: &Model) -> Release {
        let states = model.states.iter();
        Release {
            model: model.name.clone(),
            stop: Stop::Ground,
            parameters: Vec::new(),
            coefficients: Vec::new(),
            initial: states.map(|s| (s.name.clone(), s.value)).collect(),
            wind: own_wind(model),
            wind_field: None,
            known: Vec::new(),
            inputs: Vec::new(),
        }
    }

    /// Initial state vector, SI units, in the model's order of states.
    #[doc(hidden)]
    pub fn state(&self) -> Vec<f64> {
        self.initial.iter().map(|(_, value)| *value).collect()
    }

    /// Why a value of `name` would have no influence on the flight: it has a table over time. `None` if it has none.
    #[doc(hidden)]
    pub fn overruled(&self, name: &str) -> Option<String> {
        let has_table = self.inputs.iter().any(|(own, _)| own == name);
        has_table.then(|| {
            format!(
                "{name} has a table over time in [inputs], which a value does not change; expected a number there, or other values in the table"
            )
        })
    }

    /// Value of the component of a vector input of the model that is called `name`, such as `wind_x`.
    #[doc(hidden)]
    pub fn component_of_input(&mut self, name: &str, model: &Model) -> Option<&mut f64> {
        let (input, axis) = name.rsplit_once('_')?;
        let axis = ["x", "y", "z"].iter().position(|own| *own == axis)?;
        let input = model.inputs.iter().find(|own| own.name == input)?;
        if input.name == "wind" {
            return Some(&mut self.wind[axis]);
        }
        if !self.known.iter().any(|(own, _)| *own == input.name) {
            self.known.push((input.name.clone(), input.value));
        }
        let known = self.known.iter_mut().find(|(own, _)| *own == input.name);
        known.map(|(_, vector)| &mut vector[axis])
    }

    /// Replaces the initial value (SI) of a state; a name that is not a state is ignored.
    pub fn with_initial(mut self, state: &str, value: f64) -> Release {
        let states = self.initial.iter_mut();
        for (_, initial) in states.filter(|(name, _)| name == state) {
            *initial = value;
        }
        self
    }

    /// Sets the value (SI) of a parameter or coefficient, overriding the model's default.
    pub fn with_coefficient(mut self, name: &str, value: f64) -> Release {
        self.parameters.retain(|(known, _)| known != name);
        self.coefficients.retain(|(known, _)| known != name);
        self.coefficients.push((name.to_owned(), value));
        self
    }

    /// Why no body has the inertia tensor of `model` with the values of the release.
    #[doc(hidden)]
    pub fn inertia_fault(&self, model: &Model) -> Option<String> {
        let value = |name: &str, default| self.constants([(name, default)])[0];
        model.inertia_fault(|own| value(&own.name, own.value))
    }

    /// Values of parameters and coefficients in the order of `defaults` (name and value), overridden by the release.
    #[doc(hidden)]
    pub fn constants<'a>(&self, defaults: impl IntoIterator<Item = (&'a str, f64)>) -> Vec<f64> {
        let of_wind = self.wind_field.as_ref().map(WindField::parameters);
        let of_wind = of_wind.unwrap_or_default();
        let set = |name: &str| {
            let all = self.parameters.iter().chain(&self.coefficients);
            all.chain(&of_wind).find(|(n, _)| n == name)
        };
        let defaults = defaults.into_iter();
        defaults
            .map(|(name, value)| set(name).map_or(value, |(_, value)| *value))
            .collect()
    }
}

/// Fault of the first of `quaternions` (state indices) whose length is not 1 in `initial` (name and value).
#[doc(hidden)]
pub fn quaternion_fault(
    initial: &[(String, f64)],
    quaternions: impl IntoIterator<Item = [usize; 4]>,
) -> Option<String> {
    quaternions.into_iter().find_map(|states| {
        let squares = states.map(|i| initial[i].1.powi(2));
        let length = squares.iter().sum::<f64>().sqrt();
        let names = states.map(|i| &*initial[i].0).join(", ");
        let is_unit = (length - 1.0).abs() <= QUATERNION_TOLERANCE || length.is_nan();
        (!is_unit).then(|| format!("the quaternion {names} has length {length}; expected 1"))
    })
}

/// Default value of the input `wind` of a model, m/s; 0 without one.
pub(crate) fn own_wind(model: &Model) -> [f64; 3] {
    let wind = model.inputs.iter().find(|input| input.name == "wind");
    wind.map_or([0.0; 3], |wind| wind.value)
}

/// Names that a model defines and that its release files may use.
#[derive(Clone, Debug, Default)]
pub struct Vocabulary {
    /// Parameters (known constants) of the body and its environment.
    pub parameters: Vec<Name>,
    /// Coefficients of the model, such as aerodynamic coefficients, with their bounds.
    pub coefficients: Vec<Name>,
    /// Names of the states, in the model's order.
    pub states: Vec<String>,
    /// States that a release file may omit, as pairs of state index and default value (SI).
    pub optional: Vec<(usize, f64)>,
    /// Names of the vector inputs, which are known for each flight, such as the wind.
    pub inputs: Vec<String>,
    /// Scalar inputs, which may vary during a flight; they are among the parameters, too.
    pub scalar_inputs: Vec<Name>,
    /// State indices of the four components of each unit quaternion, scalar part first.
    pub quaternions: Vec<[usize; 4]>,
    /// The model, from whose body the states of a throw are derived; without it, `[throw]` is not allowed.
    pub model: Option<Arc<Model>>,
}

impl Vocabulary {
    /// Names of the model with the wind `field`, or why the model cannot fly in it.
    pub(crate) fn in_wind(&self, field: &WindField) -> Result<Vocabulary, String> {
        const NO_MODEL: &str = "found a wind by height or gusts, and no model that could fly in it";
        let model = self.model.as_ref().ok_or(NO_MODEL)?;
        let composed = field.compose(model).map_err(|source| {
            let name = &model.name;
            format!("the model {name} cannot fly in this wind: {source}")
        })?;
        Ok(Vocabulary::of(&composed))
    }

    /// Whether the model computes this parameter from others.
    pub fn is_computed(&self, name: &str) -> bool {
        self.model
            .as_ref()
            .is_some_and(|model| model.is_computed(name))
    }

    /// Collects the names and bounds that a model defines and that its release files may use.
    pub fn of(model: &Model) -> Vocabulary {
        let name = |c: &Parameter| Name {
            name: c.name.clone(),
            bounds: c.bounds,
        };
        let names = |of: &[Parameter]| of.iter().map(name).collect();
        let added = model.added_states().into_iter();
        Vocabulary {
            parameters: names(&model.params),
            coefficients: names(&model.coefficients),
            states: model.states.iter().map(|s| s.name.clone()).collect(),
            optional: added
                .map(|state| (state, model.states[state].value))
                .collect(),
            inputs: model.inputs.iter().map(|i| i.name.clone()).collect(),
            scalar_inputs: model.params.iter().filter(|p| p.varies).map(name).collect(),
            quaternions: model.quaternions().collect(),
            model: Some(Arc::new(model.clone())),
        }
    }
}

/// Names and texts of the built-in releases: two flights of Hubbard & Hummel (2000) and three others.
pub const BUILT_IN: [(&str, &str); 5] = [
    ("fssh3", include_str!("../releases/fssh3.toml")),
    ("bffl8", include_str!("../releases/bffl8.toml")),
    ("backhand", include_str!("../releases/backhand.toml")),
    ("discus", include_str!("../releases/discus.toml")),
    ("serve", include_str!("../releases/serve.toml")),
];

/// TOML text of the built-in release of this name; `None` if there is none.
pub fn built_in(name: &str) -> Option<&'static str> {
    let found = BUILT_IN.iter().find(|(own, _)| *own == name);
    found.map(|(_, text)| *text)
}
