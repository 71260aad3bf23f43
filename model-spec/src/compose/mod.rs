//! Composition of a model with effects on the syntax tree: the model is parsed once, and each combination of effects is
//! applied to its tree and checked.
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
mod offers;

use std::sync::Arc;

use crate::check::{self, Checked};
use crate::diagnostic::{Diagnostic, Source};
use crate::effect;
use crate::error::LoadError;
use crate::library::{self, EFFECTS, MODELS, REFUTED};
use crate::model::Model;
use crate::read::read;
use crate::syntax::ast::{File, Item, ItemKind};
use crate::syntax::{self, Parsed};

pub use effect_tree::EffectTree;

/// A model's syntax tree, with the effects applied to it so far and the texts that its spans refer to.
#[derive(Clone, Debug)]
pub struct ModelTree {
    file: Arc<File>,
    sources: Vec<Source>,
}

impl ModelTree {
    /// Parses a model: a file by its path, or a built-in model by its name.
    ///
    /// # Errors
    /// Every variant of [`LoadError`] but `UnknownEffect`.
    pub fn load(name_or_path: &str) -> Result<ModelTree, LoadError> {
        let (name, text) = model_text(name_or_path)?;
        ModelTree::parse(&name, &text)
    }

    /// Parses the text of a model; `name` is shown in messages.
    ///
    /// # Errors
    /// [`LoadError::Faults`] with every fault of the syntax.
    pub fn parse(name: &str, text: &str) -> Result<ModelTree, LoadError> {
        let (tree, diagnostics) = ModelTree::parse_with_faults(name, text);
        if diagnostics.is_empty() {
            Ok(tree)
        } else {
            Err(tree.faults(diagnostics))
        }
    }

    /// The tree that a model was checked from, its effects applied.
    pub fn of(model: &Model) -> ModelTree {
        ModelTree {
            file: Arc::clone(&model.tree),
            sources: model.sources.clone(),
        }
    }

    /// The tree without the statements that have faults, and the faults.
    pub(crate) fn parse_with_faults(name: &str, text: &str) -> (ModelTree, Vec<Diagnostic>) {
        let Parsed {
            file,
            source,
            diagnostics,
        } = syntax::parse(name, text);
        let tree = ModelTree {
            file: Arc::new(file),
            sources: vec![source],
        };
        (tree, diagnostics)
    }

    /// The syntax tree.
    pub fn file(&self) -> &File {
        &self.file
    }

    /// The texts that spans refer to.
    pub fn sources(&self) -> &[Source] {
        &self.sources
    }

    /// Names of the effects that [`ModelTree::find_effect`] knows: of the model's own file, then the built-in ones.
    pub fn effect_names(&self) -> impl Iterator<Item = &str> {
        let own = effects_of(&self.file).map(|effect| effect.name.text.as_str());
        own.chain(EFFECTS.iter().map(|(name, _)| *name))
    }

    /// An effect: a file by its path, or by name (`_` or `-` between words) of the model's own file or a built-in one.
    ///
    /// # Errors
    /// [`LoadError::UnknownEffect`], or those of [`EffectTree::load`] for a path.
    pub fn find_effect(&self, name_or_path: &str) -> Result<EffectTree, LoadError> {
        if std::path::Path::new(name_or_path).is_file() {
            return EffectTree::load(name_or_path);
        }
        let name = name_or_path.replace('-', "_");
        if let Some(own) = effects_of(&self.file).find(|effect| effect.name.text == name) {
            return Ok(EffectTree::of_model(own.clone()));
        }
        EffectTree::built_in(&name).unwrap_or_else(|| {
            Err(LoadError::UnknownEffect {
                wanted: name_or_path.to_owned(),
                known: self.effect_names().map(str::to_owned).collect(),
            })
        })
    }

    /// The tree with an effect applied; its coefficients come last.
    ///
    /// # Errors
    /// [`LoadError::Faults`] if the effect does not fit the model or an effect applied before.
    pub fn with(&self, effect: &EffectTree) -> Result<ModelTree, LoadError> {
        let mut extended = self.clone();
        match extended.apply(effect) {
            Ok(()) => Ok(extended),
            Err(diagnostics) => Err(extended.faults(diagnostics)),
        }
    }

    /// The tree with effects applied in order, each by name or path as in [`ModelTree::find_effect`].
    ///
    /// # Errors
    /// As [`ModelTree::find_effect`] and [`ModelTree::with`].
    pub fn with_named<S: AsRef<str>>(
        &self,
        names_or_paths: impl IntoIterator<Item = S>,
    ) -> Result<ModelTree, LoadError> {
        let mut extended = self.clone();
        for name in names_or_paths {
            extended = extended.with(&extended.find_effect(name.as_ref())?)?;
        }
        Ok(extended)
    }

    /// Applies an effect, unless that gives faults; its text becomes a source in either case.
    pub(crate) fn apply(&mut self, effect: &EffectTree) -> Result<(), Vec<Diagnostic>> {
        let tree = effect.in_sources(&mut self.sources);
        self.file = Arc::new(effect::apply(&self.file, &tree)?);
        Ok(())
    }

    /// Checks names, shapes, frames, units and singular points.
    ///
    /// # Errors
    /// [`LoadError::Faults`] with every fault, also of effects that the model's file offers.
    pub fn check(&self) -> Result<Model, LoadError> {
        match self.check_with_faults() {
            Checked {
                model: Some(model),
                diagnostics,
            } if diagnostics.is_empty() => Ok(model),
            Checked { diagnostics, .. } => Err(self.faults(diagnostics)),
        }
    }

    /// The model, if only its units are at fault, and the faults.
    pub(crate) fn check_with_faults(&self) -> Checked {
        let mut checked = check::check(&self.file, &self.sources);
        if checked.diagnostics.is_empty() {
            checked.diagnostics = offers::faults(&self.file, &self.sources);
        }
        checked
    }

    /// The model as text, with the effects written into its statements; applied effects are no longer offered. `note`
    /// becomes a paragraph at the end of the file's documentation.
    pub fn to_text(&self, note: &str) -> String {
        let mut file = File::clone(&self.file);
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

/// Name for messages and text of a model by name or path; a path wins over a name.
pub(crate) fn model_text(name_or_path: &str) -> Result<(String, String), LoadError> {
    let path = std::path::Path::new(name_or_path);
    if path.is_file() {
        return Ok((name_or_path.to_owned(), read(name_or_path)?));
    }
    let name = name_or_path.replace('-', "_");
    if let Some(text) = library::find(MODELS, &name).or_else(|| library::find(REFUTED, &name)) {
        return Ok((format!("{name}.hyz"), text.to_owned()));
    }
    if path.exists() {
        return Err(LoadError::Folder {
            path: name_or_path.to_owned(),
        });
    }
    Err(LoadError::UnknownModel {
        wanted: name_or_path.to_owned(),
        known: MODELS.iter().map(|(name, _)| (*name).to_owned()).collect(),
    })
}

/// The effects that a file declares.
fn effects_of(file: &File) -> impl Iterator<Item = &crate::syntax::ast::Effect> {
    file.items
        .iter()
        .filter_map(|item: &Item| match &item.kind {
            ItemKind::Effect(effect) => Some(effect),
            _ => None,
        })
}
