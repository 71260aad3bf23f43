//! Composition of a model with effects on the syntax tree: the model is parsed once; each combination of effects is
//! applied to a copy of its tree and checked.
//!
//! ```
//! use model_spec::compose::ModelTree;
//!
//! let disc = ModelTree::load("disc")?;
//! let wind = disc.find_effect("wind")?;
//! let lift = disc.find_effect("lift-by-spin")?;
//!
//! // Many candidates on one base: nothing is parsed again.
//! for effect in [&wind, &lift] {
//!     let model = disc.with(effect)?.check()?;
//!     assert_eq!(model.effects[0].name, effect.name());
//! }
//!
//! // The extended model as a file of its own.
//! let extended = disc.with(&wind)?.with(&lift)?;
//! let text = extended.to_text("Extended by wind and lift by spin.");
//! let model = model_spec::load::from_text("extended.hyz", &text, &[])?;
//! assert_eq!(model.coefficients.len(), extended.check()?.coefficients.len());
//! # Ok::<(), model_spec::LoadError>(())
//! ```

mod effect_tree;
mod input_effects;
mod known;
mod rates;
mod sensors;
mod unknown;
mod values;

use crate::check::{self, Checked};
use crate::diagnostic::{self, Diagnostic, Kind, Source};
use crate::effect;
use crate::files::{self, Open};
use crate::model::Model;
use crate::read::{BODIES, LoadError, MODELS, REFUTED, find, read};
use crate::syntax::ast::{File, ItemKind};
pub use effect_tree::{EffectTree, Instrument};
pub use known::{KnownEffect, Origin, Refused, known_effects};
use std::collections::HashSet;
use std::sync::Arc;
pub use unknown::UnknownError;
pub use values::ValueError;

/// Syntax tree of a model to which effects can be applied, and the source texts that its spans refer to.
#[derive(Clone, Debug)]
pub struct ModelTree {
    file: Arc<File>,
    sources: Vec<Source>,
}

impl ModelTree {
    /// Parses a model from a file path or the name of a built-in model.
    ///
    /// # Errors
    /// Any variant of [`LoadError`] except [`LoadError::UnknownEffect`].
    pub fn load(name_or_path: &str) -> Result<ModelTree, LoadError> {
        let (name, text) = model_text(name_or_path)?;
        ModelTree::parse(&name, &text)
    }

    /// Parses the text of a model; messages refer to the text as `name`. The files that the text names are read if
    /// `name` is the path of a file, beside it.
    pub fn parse(name: &str, text: &str) -> Result<ModelTree, LoadError> {
        let (tree, diagnostics) = ModelTree::parse_with_faults(name, text);
        if diagnostics.is_empty() {
            Ok(tree)
        } else {
            Err(tree.faults(diagnostics))
        }
    }

    /// Returns the syntax tree of a checked model, including the applied effects.
    pub fn of(model: &Model) -> ModelTree {
        ModelTree {
            file: Arc::clone(&model.tree),
            sources: model.sources.clone(),
        }
    }

    /// Parses a model. Returns the tree without the statements that have syntax errors, and the errors.
    pub(crate) fn parse_with_faults(name: &str, text: &str) -> (ModelTree, Vec<Diagnostic>) {
        ModelTree::parse_open(name, text, &|_| None)
    }

    /// Parses a model as [`ModelTree::parse_with_faults`] does; texts of files that are `open` count in their place.
    pub(crate) fn parse_open(
        name: &str,
        text: &str,
        open: &Open<'_>,
    ) -> (ModelTree, Vec<Diagnostic>) {
        let complete = files::parse_with(name, text, 0, open);
        let tree = ModelTree {
            file: Arc::new(complete.file),
            sources: complete.sources,
        };
        (tree, complete.diagnostics)
    }

    /// Syntax tree of the model with the applied effects.
    pub fn file(&self) -> &File {
        &self.file
    }

    /// Source texts that the tree's spans refer to.
    pub fn sources(&self) -> &[Source] {
        &self.sources
    }

    /// Names of the effects declared in the model's file, then of the built-in effects, specific and general.
    pub fn effect_names(&self) -> impl Iterator<Item = &str> {
        let own = self.file.effects().map(|effect| effect.name.text.as_str());
        own.chain(EffectTree::built_in().iter().map(EffectTree::name))
    }

    /// Finds an effect by file path, or by name (with `_` or `-` between words). A name is searched among the effects
    /// of the model's file, then the built-in effects, then the effects created from the equations `der(STATE) = …` and
    /// the scalar inputs of the model.
    ///
    /// # Errors
    /// [`LoadError::UnknownEffect`] if no effect has the name; for a path, the errors of [`EffectTree::load`].
    pub fn find_effect(&self, name_or_path: &str) -> Result<EffectTree, LoadError> {
        if std::path::Path::new(name_or_path).is_file() {
            return EffectTree::load(name_or_path);
        }
        let name = name_or_path.replace('-', "_");
        if let Some(own) = self.file.effects().find(|effect| effect.name.text == name) {
            return Ok(EffectTree::of_model(own.clone()));
        }
        let mut built_in = EffectTree::built_in().iter();
        if let Some(effect) = built_in.find(|effect| effect.name() == name) {
            return Ok(effect.clone());
        }
        let mut made = made_effects(&self.file).into_iter();
        let made = made.find(|effect| effect.name() == name);
        made.ok_or_else(|| LoadError::UnknownEffect {
            wanted: name_or_path.to_owned(),
            known: self.effect_names().map(str::to_owned).collect(),
        })
    }

    /// Applies an effect to a copy of the tree; coefficients of the effect follow those of the model.
    pub fn with(&self, effect: &EffectTree) -> Result<ModelTree, LoadError> {
        let mut extended = self.clone();
        match extended.apply(effect) {
            Ok(()) => Ok(extended),
            Err(diagnostics) => Err(extended.faults(diagnostics)),
        }
    }

    /// Applies effects in order to a copy of the tree. Each effect is given by name or path as in
    /// [`ModelTree::find_effect`]. If an effect needs the quantity that an [`Instrument`] measures, and the model does
    /// not declare that quantity, the default definition of the quantity is added first.
    pub fn with_named<S: AsRef<str>>(
        &self,
        names_or_paths: impl IntoIterator<Item = S>,
    ) -> Result<ModelTree, LoadError> {
        let mut extended = self.clone();
        for name in names_or_paths {
            let effect = extended.find_effect(name.as_ref())?;
            extended = extended
                .with_instruments(&effect.instruments())
                .with(&effect)?;
        }
        Ok(extended)
    }

    /// Applies an effect in place; its text joins the sources even if it has errors.
    pub(crate) fn apply(&mut self, effect: &EffectTree) -> Result<(), Vec<Diagnostic>> {
        let tree = effect.in_sources(&mut self.sources);
        self.file = Arc::new(effect::apply(&self.file, &tree)?);
        Ok(())
    }

    /// Checks names, shapes, frames, units and singular points of the model and of the effects that its file declares.
    pub fn check(&self) -> Result<Model, LoadError> {
        match self.check_with_faults() {
            Checked {
                model: Some(model),
                diagnostics,
            } if diagnostics.is_empty() => Ok(model),
            Checked { diagnostics, .. } => Err(self.faults(diagnostics)),
        }
    }

    /// Checks the model, which is `None` if there is any error but a unit error.
    pub(crate) fn check_with_faults(&self) -> Checked {
        let mut checked = check::check(&self.file, &self.sources);
        if checked.diagnostics.is_empty() {
            checked.diagnostics = offer_faults(&self.file, &self.sources);
        }
        checked
    }

    /// The model without the statements that have errors and those that need them; `None` if what is left is no model.
    pub(crate) fn check_sound(mut self) -> Option<Model> {
        for _ in 0..MAX_SOUND_ROUNDS {
            let Checked { model, diagnostics } = check::check(&self.file, &self.sources);
            if model.is_some() {
                return model;
            }
            let items = &mut Arc::make_mut(&mut self.file).items;
            let before = items.len();
            let faults = || diagnostics.iter().filter(|fault| fault.kind != Kind::Unit);
            items.retain(|item| !faults().any(|fault| item.span.contains(fault.span)));
            if items.len() == before {
                return None;
            }
        }
        None
    }

    /// Text of the model with its effects merged and without states for unknowns; `note` ends its documentation.
    pub fn to_text(&self, note: &str) -> String {
        let mut file = File::clone(&self.file);
        unknown::restore(&mut file);
        let is_applied = |name: &str| self.file.applied.iter().any(|a| a.name.text == name);
        file.items.retain(|item| match &item.kind {
            ItemKind::Effect(effect) => !is_applied(&effect.name.text),
            _ => true,
        });
        if !note.is_empty() {
            file.doc = format!("{}\n\n{note}", file.doc.trim_end());
        }
        file.to_string()
    }

    pub(crate) fn faults(&self, diagnostics: Vec<Diagnostic>) -> LoadError {
        LoadError::Faults {
            diagnostics,
            sources: self.sources.clone(),
        }
    }
}

/// Effects created for the equations and the scalar inputs of a model.
fn made_effects(file: &File) -> Vec<EffectTree> {
    let mut made = rates::rate_effects(file);
    made.extend(input_effects::input_effects(file));
    made
}

/// Display name and text of a model, which is given by path or by built-in name; an existing file takes precedence.
pub(crate) fn model_text(name_or_path: &str) -> Result<(String, String), LoadError> {
    let path = std::path::Path::new(name_or_path);
    if path.is_file() {
        return Ok((name_or_path.to_owned(), read(name_or_path)?));
    }
    let name = name_or_path.replace('-', "_");
    let tables = [MODELS, BODIES, REFUTED];
    if let Some(text) = tables.iter().find_map(|table| find(table, &name)) {
        return Ok((format!("{name}.hyz"), text.to_owned()));
    }
    if path.exists() {
        return Err(LoadError::Folder {
            path: name_or_path.to_owned(),
        });
    }
    Err(LoadError::UnknownModel {
        wanted: name_or_path.to_owned(),
        known: { MODELS.iter().chain(BODIES) }
            .map(|(name, _)| (*name).to_owned())
            .collect(),
    })
}

const MAX_CHECKED_OFFERS: usize = 50;

/// Number of checks in search of statements without errors: each finds those that need what the last one has left out.
const MAX_SOUND_ROUNDS: usize = 10;

/// Errors of the effects of a file, each applied alone to a copy of the model.
fn offer_faults(file: &File, sources: &[Source]) -> Vec<Diagnostic> {
    let model = file.model().map_or("", |name| &name.text);
    let mut diagnostics = Vec::new();
    let mut names: HashSet<&str> = HashSet::new();
    for offered in file.effects() {
        let name = &offered.name;
        if !names.insert(&name.text) {
            let message = format!("there are two effects `{}`", name.text);
            let fault = Diagnostic::new(Kind::Duplicate, name.span, message);
            diagnostics.push(fault.help("rename one of them"));
            continue;
        }
        let is_applied = file.applied.iter().any(|a| a.name.text == name.text);
        if is_applied || offered.excludes(model) || names.len() > MAX_CHECKED_OFFERS {
            continue;
        }
        match effect::apply(file, offered) {
            Ok(changed) => diagnostics.extend(check::check(&changed, sources).diagnostics),
            Err(faults) => diagnostics.extend(faults),
        }
    }
    diagnostic::sort(&mut diagnostics);
    diagnostics
}
