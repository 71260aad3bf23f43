//! Loading of models by name or path, with effects applied.

use crate::compose::{ModelTree, model_text};
use crate::diagnostic::{Diagnostic, Source};
use crate::model::Model;
use crate::syntax::ast::File;

pub use crate::files::Open;
pub use crate::read::LoadError;
pub use crate::read::{BODIES, EFFECTS, MODELS, REFUTED, WINDS};
pub use crate::read::{decode, read};

/// Result of loading a model that may have errors.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The checked model; `None` if there is any error other than a unit error.
    pub model: Option<Model>,
    /// Syntax tree of the model with the effects applied.
    pub file: File,
    /// Errors of the model and of its effects.
    pub diagnostics: Vec<Diagnostic>,
    /// Source texts to which the spans of [`Loaded::file`] and [`Loaded::diagnostics`] refer.
    pub sources: Vec<Source>,
}

impl Loaded {
    /// The model, and the messages on its units.
    ///
    /// # Errors
    /// [`LoadError::Faults`] if it has other errors.
    pub fn model_and_messages(self) -> Result<(Model, Vec<String>), LoadError> {
        let messages = self.diagnostics.iter().map(|fault| fault.message.clone());
        let messages = messages.collect();
        match self.model {
            Some(model) => Ok((model, messages)),
            None => Err(LoadError::Faults {
                diagnostics: self.diagnostics,
                sources: self.sources,
            }),
        }
    }
}

/// Loads a model from a path or by the name of a built-in model; an existing file takes precedence. `with` lists the
/// effects to apply, each by path or by name, as in [`ModelTree::find_effect`]: an effect of the model's file, a
/// built-in effect, or an effect created from an equation `der(STATE) = …` of the model.
pub fn load(name_or_path: &str, with: &[&str]) -> Result<Model, LoadError> {
    let (name, text) = model_text(name_or_path)?;
    from_text(&name, &text, with)
}

/// Loads a model from text and applies the effects `with`; fails if any text has an error. Messages refer to the text
/// as `name`. The files that the text names are read if `name` is the path of a file, beside it.
pub fn from_text(name: &str, text: &str, with: &[&str]) -> Result<Model, LoadError> {
    let mut loaded = inspect_text(name, text, with)?;
    loaded.model.take_if(|_| !loaded.diagnostics.is_empty());
    Ok(loaded.model_and_messages()?.0)
}

/// Loads a model and applies the effects `with`, as [`load`](load()) does, but returns the model's errors as
/// [`Loaded::diagnostics`].
pub fn inspect(name_or_path: &str, with: &[&str]) -> Result<Loaded, LoadError> {
    let (name, text) = model_text(name_or_path)?;
    inspect_text(&name, &text, with)
}

/// Loads a model from text and applies the effects `with`, as [`from_text`] does, but returns the model's errors as
/// [`Loaded::diagnostics`]. Messages refer to the text as `name`.
pub fn inspect_text(name: &str, text: &str, with: &[&str]) -> Result<Loaded, LoadError> {
    let (tree, diagnostics) = ModelTree::parse_with_faults(name, text);
    inspect_tree(tree, diagnostics, with)
}

/// Loads a model from text as [`inspect_text`] does without effects. Of a file that it names, the text is what `open`
/// returns for its path, if anything, in place of what is stored.
pub fn inspect_open(name: &str, text: &str, open: &Open<'_>) -> Result<Loaded, LoadError> {
    let (tree, diagnostics) = ModelTree::parse_open(name, text, open);
    inspect_tree(tree, diagnostics, &[])
}

/// Model of the statements of a text that have no error, for editors; `None` if these are no model. Files count as in
/// [`inspect_open`].
pub fn sound_part(name: &str, text: &str, open: &Open<'_>) -> Option<Model> {
    let (tree, _) = ModelTree::parse_open(name, text, open);
    tree.check_sound()
}

fn inspect_tree(
    mut tree: ModelTree,
    mut diagnostics: Vec<Diagnostic>,
    with: &[&str],
) -> Result<Loaded, LoadError> {
    for wanted in with {
        let effect = match tree.find_effect(wanted) {
            Err(error) if !diagnostics.is_empty() => return Err(after(tree, diagnostics, error)),
            found => found?,
        };
        tree = tree.with_instruments(&effect.instruments());
        if let Err(faults) = tree.apply(&effect) {
            diagnostics.extend(faults);
        }
    }
    // Checking an incomplete tree would report missing statements that only failed to parse.
    let mut model = None;
    if diagnostics.is_empty() {
        let checked = tree.check_with_faults();
        (model, diagnostics) = (checked.model, checked.diagnostics);
    }
    Ok(Loaded {
        model,
        file: tree.file().clone(),
        diagnostics,
        sources: tree.sources().to_vec(),
    })
}

/// Joins the errors of a model and those in an effect's text, so that all are reported.
fn after(tree: ModelTree, mut earlier: Vec<Diagnostic>, error: LoadError) -> LoadError {
    let LoadError::Faults {
        mut diagnostics,
        sources,
    } = error
    else {
        return error;
    };
    let mut all = tree.sources().to_vec();
    let first = u16::try_from(all.len()).unwrap_or(u16::MAX);
    for fault in &mut diagnostics {
        fault.span.source += first;
        fault.labels.iter_mut().for_each(|l| l.span.source += first);
        fault
            .fix
            .iter_mut()
            .for_each(|fix| fix.span.source += first);
    }
    all.extend(sources);
    earlier.extend(diagnostics);
    LoadError::Faults {
        diagnostics: earlier,
        sources: all,
    }
}
