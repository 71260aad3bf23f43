//! Releases: how a body is let go, by name or from a TOML file.

mod fault;
mod read;

pub use fault::{Fault, ReleaseError};
pub use read::{read, read_file};

/// How a body is let go, and until when it is watched.
#[derive(Clone, Debug, PartialEq)]
pub struct Release {
    /// The model, by name or by path, as the release says it.
    pub model: String,
    /// When the flight ends.
    pub stop: Stop,
    /// Parameters that differ from the model's defaults, SI.
    pub parameters: Vec<(String, f64)>,
    /// Coefficients that differ from the model's defaults, SI.
    pub coefficients: Vec<(String, f64)>,
    /// Every state at the release, in the model's order, SI.
    pub initial: Vec<(String, f64)>,
    /// Velocity of the air in N, m/s.
    pub wind: [f64; 3],
    /// Other inputs of the model that are known of this flight, SI.
    pub known: Vec<(String, [f64; 3])>,
}

/// When a flight ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stop {
    /// After so many seconds.
    Duration(f64),
    /// Where its height `z` falls to 0.
    Ground,
}

impl Release {
    /// Maximum duration of a release and of a flight to the ground, s.
    pub const MAX_DURATION: f64 = 600.0;

    /// The states alone, in the model's order.
    pub fn state(&self) -> Vec<f64> {
        self.initial.iter().map(|(_, value)| *value).collect()
    }

    /// The release with another value (SI) of an initial state; a name that is not a state is ignored.
    pub fn with_initial(mut self, state: &str, value: f64) -> Release {
        let states = self.initial.iter_mut();
        for (_, initial) in states.filter(|(name, _)| name == state) {
            *initial = value;
        }
        self
    }

    /// The release with a value (SI) of a parameter or coefficient, in place of the model's default.
    pub fn with_coefficient(mut self, name: &str, value: f64) -> Release {
        self.parameters.retain(|(known, _)| known != name);
        self.coefficients.retain(|(known, _)| known != name);
        self.coefficients.push((name.to_owned(), value));
        self
    }

    /// The model's constants with this release's values put in: `defaults` by name, in their order.
    pub fn constants<'a>(&self, defaults: impl IntoIterator<Item = (&'a str, f64)>) -> Vec<f64> {
        let set = |name: &str| {
            self.parameters
                .iter()
                .chain(&self.coefficients)
                .find(|(n, _)| n == name)
        };
        defaults
            .into_iter()
            .map(|(name, value)| set(name).map_or(value, |(_, value)| *value))
            .collect()
    }
}

/// The names of a model that a release may speak of.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Vocabulary {
    /// Parameters.
    pub parameters: Vec<Name>,
    /// Coefficients.
    pub coefficients: Vec<Name>,
    /// States, in order.
    pub states: Vec<String>,
    /// States that a release need not say, with the value that each has then.
    pub optional: Vec<(usize, f64)>,
    /// Inputs: vectors that are given with each flight.
    pub inputs: Vec<String>,
    /// Groups of four states that are a quaternion's, whose length is 1.
    pub quaternions: Vec<[usize; 4]>,
}

/// A name of a constant, with the values that it may have.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// The name.
    pub name: String,
    /// Least and greatest value, SI.
    pub bounds: Option<(f64, f64)>,
}

impl Vocabulary {
    /// The names of a model.
    pub fn of(model: &model_spec::model::Model) -> Vocabulary {
        let names = |of: &[model_spec::model::Parameter]| {
            of.iter()
                .map(|c| Name {
                    name: c.name.clone(),
                    bounds: c.bounds,
                })
                .collect()
        };
        Vocabulary {
            parameters: names(&model.params),
            coefficients: names(&model.coefficients),
            states: model.states.iter().map(|s| s.name.clone()).collect(),
            optional: model
                .added_states()
                .into_iter()
                .map(|state| (state, model.states[state].value))
                .collect(),
            inputs: model.inputs.iter().map(|i| i.name.clone()).collect(),
            quaternions: model.quaternions().collect(),
        }
    }
}

/// The releases that are built in, by name: two flights of Hubbard & Hummel (2000), a full backhand, a discus, a
/// table-tennis ball.
pub const BUILT_IN: [(&str, &str); 5] = [
    ("fssh3", include_str!("../../releases/fssh3.toml")),
    ("bffl8", include_str!("../../releases/bffl8.toml")),
    ("backhand", include_str!("../../releases/backhand.toml")),
    ("discus", include_str!("../../releases/discus.toml")),
    ("serve", include_str!("../../releases/serve.toml")),
];

/// The text of a built-in release.
pub fn built_in(name: &str) -> Option<&'static str> {
    BUILT_IN
        .iter()
        .find(|(n, _)| *n == name)
        .map(|(_, text)| *text)
}
