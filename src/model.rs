//! Models of flying bodies with effects.

use std::sync::{Arc, OnceLock};

use flight::CompiledModel;
use flight::release::{self, Release, Vocabulary};
use model_spec::compose::{EffectTree, ModelTree};
use ode::IntegrationOptions;

use crate::{Error, Flight};

/// Checked model of a flying body, including the effects (optional model extensions) applied to it.
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
    tree: ModelTree,
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

    /// Returns the model extended by an effect: a name (of an effect in the model's own file or built in) or the path
    /// of a file.
    ///
    /// # Errors
    /// [`Error::Load`] if there is no such effect, or the extended model has faults.
    pub fn with_effect(&self, name_or_path: &str) -> Result<Model, Error> {
        let effect = self.tree.find_effect(name_or_path)?;
        Model::check(self.tree.with(&effect)?)
    }

    /// Returns the model extended by an effect (optional model extension) that is given as text, `effect NAME { … }`.
    ///
    /// # Errors
    /// [`Error::Load`] if the text or the extended model has faults.
    pub fn with_effect_text(&self, text: &str) -> Result<Model, Error> {
        let effect = EffectTree::parse("effect", text)?;
        Model::check(self.tree.with(&effect)?)
    }

    fn check(tree: ModelTree) -> Result<Model, Error> {
        Ok(Model {
            checked: tree.check()?,
            tree,
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

    /// Names and default values (SI) of the coefficients, including those of the effects (model extensions) applied.
    pub fn coefficients(&self) -> impl Iterator<Item = (&str, f64)> {
        let coefficients = self.checked.coefficients.iter();
        coefficients.map(|coefficient| (&*coefficient.name, coefficient.value))
    }

    /// Text of the model in the model language, with the effects (model extensions) merged into its equations.
    pub fn text(&self) -> String {
        self.tree.to_text("")
    }

    /// The checked model as the data structure that the compiler and other crates of the workspace use.
    pub fn checked(&self) -> &model_spec::model::Model {
        &self.checked
    }

    /// The compiled model, for evaluating its functions; it is compiled at the first call.
    pub fn compiled(&self) -> &CompiledModel {
        self.compiled
            .get_or_init(|| CompiledModel::new(&self.checked))
    }

    /// Returns a built-in release (initial conditions) of this model by its name, such as `backhand`.
    ///
    /// # Errors
    /// [`Error::UnknownRelease`] if there is no such release, or [`Error::Release`] if it is for a model with other
    /// states.
    pub fn release(&self, name: &str) -> Result<Release, Error> {
        let text = release::built_in(name).ok_or_else(|| Error::UnknownRelease {
            name: name.to_owned(),
            known: release::BUILT_IN.iter().map(|(name, _)| *name).collect(),
        })?;
        self.parse_release(name, text)
    }

    /// Parses a release (launch conditions) of this model from the text of a release file (TOML); the model that the
    /// text names is ignored. `name` is the file name in error messages. Wind profiles over height and gusts are
    /// refused, because they change the model: see [`parse_release_in_wind`](Model::parse_release_in_wind).
    ///
    /// # Errors
    /// [`Error::Release`] if the text has faults.
    pub fn parse_release(&self, name: &str, text: &str) -> Result<Release, Error> {
        let vocabulary = Vocabulary::of(&self.checked);
        Ok(release::read(name, text, |_| Ok(vocabulary))?)
    }

    /// Parses a release as [`parse_release`](Model::parse_release) does, but accepts a wind profile over height and
    /// gusts. Also returns the model extended by this wind, with which the release is to be flown.
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
                tree: ModelTree::of(&composed),
                checked: model_spec::model::Model::clone(&composed),
                compiled: Arc::default(),
            },
            None => self.clone(),
        };
        Ok((model, release))
    }

    /// Simulates the flight from the launch conditions `release`, with relative and absolute tolerances of 1e-9.
    ///
    /// # Errors
    /// As [`fly_with`](Model::fly_with).
    pub fn fly(&self, release: &Release) -> Result<Flight, Error> {
        self.fly_with(release, &IntegrationOptions::with_tolerance(1e-9))
    }

    /// Simulates the flight from the launch conditions `release` with the given tolerances.
    ///
    /// # Errors
    /// [`Error::UnknownName`] if the release sets a parameter or coefficient that the model does not have;
    /// [`Error::Integration`] if the trajectory cannot be computed.
    pub fn fly_with(
        &self,
        release: &Release,
        options: &IntegrationOptions,
    ) -> Result<Flight, Error> {
        let compiled = self.compiled();
        for (name, _) in release.parameters.iter().chain(&release.coefficients) {
            if compiled.layout().parameter(name).is_none() {
                return Err(Error::UnknownName {
                    model: self.name().to_owned(),
                    name: name.clone(),
                });
            }
        }
        let trajectory = flight::simulate(compiled, release, options)?;
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
