//! Models of flying bodies with effects.

use std::sync::{Arc, OnceLock};

use flight::CompiledModel;
use flight::release::{self, Release, Vocabulary, quaternion_fault};
use model_spec::compose::{EffectTree, ModelTree};
use ode::IntegrationOptions;

use crate::{Error, Flight};

/// Named change of a model.
#[derive(Clone)]
pub struct Effect(EffectTree);

impl Effect {
    /// Parses an effect from text, `effect NAME { … }`.
    ///
    /// # Errors
    /// [`Error::Load`] if the text has faults.
    pub fn parse(text: &str) -> Result<Effect, Error> {
        Ok(Effect(EffectTree::parse("effect", text)?))
    }

    /// Reads an effect from a file.
    ///
    /// # Errors
    /// [`Error::Load`] if the file cannot be read or has faults.
    pub fn read(path: &str) -> Result<Effect, Error> {
        Ok(Effect(EffectTree::load(path)?))
    }

    /// Name of the effect in the model language.
    pub fn name(&self) -> &str {
        self.0.name()
    }
}

impl std::fmt::Debug for Effect {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("Effect").field(&self.name()).finish()
    }
}

/// Checked model of a flying body with the effects applied to it.
///
/// ```
/// # fn main() -> Result<(), hyzer::Error> {
/// let disc = hyzer::Model::load("disc")?.with_effect("zero-lift-drag-angle")?;
/// assert!(disc.coefficients().any(|(name, _)| name == "C_La"));
/// # Ok(())
/// # }
/// ```
#[derive(Clone)]
pub struct Model {
    checked: model_spec::model::Model,
    compiled: Arc<OnceLock<CompiledModel>>,
}

impl Model {
    /// Loads a model by path, or a built-in one by name: `disc`, `disc_quaternion`, `discus`, `ball`.
    ///
    /// # Errors
    /// [`Error::Load`] if there is no such model or file, or the text has faults.
    pub fn load(name_or_path: &str) -> Result<Model, Error> {
        Model::check(ModelTree::load(name_or_path)?)
    }

    /// Parses the text of a model; `name` is the file name in error messages.
    ///
    /// # Errors
    /// [`Error::Load`] if the text has faults.
    pub fn parse(name: &str, text: &str) -> Result<Model, Error> {
        Model::check(ModelTree::parse(name, text)?)
    }

    /// The model extended by an effect: a name in its own file or built in, or the path of a file.
    ///
    /// # Errors
    /// [`Error::Load`] if there is no such effect, or the extended model has faults.
    pub fn with_effect(&self, name_or_path: &str) -> Result<Model, Error> {
        let tree = self.tree();
        let effect = tree.find_effect(name_or_path)?;
        Model::check(tree.with(&effect)?)
    }

    /// The model extended by an effect.
    ///
    /// # Errors
    /// [`Error::Load`] if the extended model has faults.
    pub fn with(&self, effect: &Effect) -> Result<Model, Error> {
        Model::check(self.tree().with(&effect.0)?)
    }

    /// The model with an effect that is declared and not applied, which a [`Diagnosis`](crate::Diagnosis) tests like the
    /// built-in ones.
    ///
    /// # Errors
    /// [`Error::Load`] if the effect does not fit the model.
    pub fn with_candidate(&self, effect: &Effect) -> Result<Model, Error> {
        self.tree().with(&effect.0)?.check()?;
        let text = format!("{}\n{}\n", self.text(), effect.0);
        Model::parse(self.name(), &text)
    }

    fn check(tree: ModelTree) -> Result<Model, Error> {
        Ok(Model {
            checked: tree.check()?,
            compiled: Arc::default(),
        })
    }

    /// Name of the model.
    pub fn name(&self) -> &str {
        &self.checked.name
    }

    /// Names of the states, in the order of the state vector.
    pub fn states(&self) -> impl Iterator<Item = &str> {
        self.checked.states.iter().map(|state| &*state.name)
    }

    /// Names and default values (SI) of the coefficients, including those of the effects applied.
    pub fn coefficients(&self) -> impl Iterator<Item = (&str, f64)> {
        let coefficients = self.checked.coefficients.iter();
        coefficients.map(|coefficient| (&*coefficient.name, coefficient.value))
    }

    /// Text of the model in the model language, with the effects merged into its equations.
    pub fn text(&self) -> String {
        self.tree().to_text("")
    }

    fn tree(&self) -> ModelTree {
        ModelTree::of(&self.checked)
    }

    /// The checked model.
    pub(crate) fn checked(&self) -> &model_spec::model::Model {
        &self.checked
    }

    /// The compiled model; it is compiled at the first call.
    pub(crate) fn compiled(&self) -> &CompiledModel {
        self.compiled
            .get_or_init(|| CompiledModel::new(&self.checked))
    }

    /// Names and default values (SI) of the constants of the body and the air.
    pub fn parameters(&self) -> impl Iterator<Item = (&str, f64)> {
        let parameters = self.checked.params.iter();
        parameters.map(|parameter| (&*parameter.name, parameter.value))
    }

    /// Release of this model with the default parameters and an initial state, SI, that ends on the ground.
    pub(crate) fn release_from(&self, state: Vec<f64>) -> Release {
        let names = self.checked.states.iter().map(|state| state.name.clone());
        Release {
            initial: names.zip(state).collect(),
            ..Release::of(&self.checked)
        }
    }

    /// A built-in release of this model, such as `backhand`.
    ///
    /// # Errors
    /// [`Error::UnknownRelease`] for an unknown name, [`Error::Release`] if the model lacks its states.
    pub fn release(&self, name: &str) -> Result<Release, Error> {
        let unknown = || Error::UnknownRelease {
            name: name.to_owned(),
            known: release::BUILT_IN.iter().map(|(name, _)| *name).collect(),
        };
        self.parse_release(name, release::built_in(name).ok_or_else(unknown)?)
    }

    /// Parses the text of a release file (TOML); the model that it names is ignored, and `name` is the file name in error
    /// messages. Winds that change the model are refused: see [`parse_release_in_wind`](Model::parse_release_in_wind).
    ///
    /// # Errors
    /// [`Error::Release`] if the text has faults.
    pub fn parse_release(&self, name: &str, text: &str) -> Result<Release, Error> {
        let vocabulary = Vocabulary::of(&self.checked);
        Ok(release::read(name, text, |_| Ok(vocabulary))?)
    }

    /// Parses a release that may have a wind profile over height and gusts. Also returns the model extended by this wind,
    /// with which the release is to be flown.
    ///
    /// # Errors
    /// [`Error::Release`] if the text has faults.
    ///
    /// ```
    /// # fn main() -> Result<(), hyzer::Error> {
    /// let text = "model = \"ball\"\nuntil = \"ground\"\n[throw]\nspeed = 9.0\nlaunch = 30.0\n\
    ///             [wind]\nprofile = \"log\"\nspeed = 5.0\ndirection = 90.0";
    /// let (ball, release) = hyzer::Model::load("ball")?.parse_release_in_wind("windy", text)?;
    /// let flight = ball.fly(&release)?;
    /// assert!(flight.state("y", flight.duration()).is_some_and(|y| y > 0.2));
    /// # Ok(())
    /// # }
    /// ```
    pub fn parse_release_in_wind(&self, name: &str, text: &str) -> Result<(Model, Release), Error> {
        let vocabulary = Vocabulary::of(&self.checked);
        let (release, vocabulary) = release::read_in_wind(name, text, &[], |_| Ok(vocabulary))?;
        let model = match vocabulary.model.filter(|_| release.wind_field.is_some()) {
            Some(composed) => Model {
                checked: model_spec::model::Model::clone(&composed),
                compiled: Arc::default(),
            },
            None => self.clone(),
        };
        Ok((model, release))
    }

    /// Simulates the flight from a release, with relative and absolute tolerances of 1e-9.
    ///
    /// # Errors
    /// As [`fly_within`](Model::fly_within).
    pub fn fly(&self, release: &Release) -> Result<Flight, Error> {
        self.fly_within(release, 1e-9)
    }

    /// Simulates the flight from a release with the given relative and absolute tolerance of a step.
    ///
    /// # Errors
    /// [`Error::UnknownName`] if the release sets a parameter or coefficient that the model does not have;
    /// [`Error::InitialState`] if a quaternion does not have length 1, or no body has the moments of inertia;
    /// [`Error::Integration`] if the flight cannot be computed.
    pub fn fly_within(&self, release: &Release, tolerance: f64) -> Result<Flight, Error> {
        let compiled = self.compiled();
        for (name, _) in release.parameters.iter().chain(&release.coefficients) {
            if compiled.layout().parameter(name).is_none() {
                return Err(Error::UnknownName {
                    model: self.name().to_owned(),
                    name: name.clone(),
                });
            }
        }
        let quaternions = self.checked.quaternions();
        let fault = quaternion_fault(&release.initial, quaternions);
        if let Some(fault) = fault.or_else(|| release.inertia_fault(&self.checked)) {
            return Err(Error::InitialState(fault));
        }
        let options = IntegrationOptions::with_tolerance(tolerance);
        let trajectory = flight::simulate(compiled, release, &options)?;
        Ok(Flight::new(self.clone(), release, trajectory))
    }
}

impl std::fmt::Debug for Model {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let effects = self.checked.effects.iter().map(|effect| &*effect.name);
        f.debug_struct("Model")
            .field("name", &self.checked.name)
            .field("effects", &effects.collect::<Vec<_>>())
            .finish_non_exhaustive()
    }
}
