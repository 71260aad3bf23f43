//! Models by name or path, with effects applied.

use crate::compose::{ModelTree, model_text};
use crate::diagnostic::{Diagnostic, Source};
use crate::model::Model;
use crate::syntax::ast::File;

pub use crate::error::LoadError;
pub use crate::library::{EFFECTS, MODELS, REFUTED};
pub use crate::read::decode;

/// A model that was loaded, with its faults.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The model, if nothing but units is at fault.
    pub model: Option<Model>,
    /// The syntax tree, with the effects applied.
    pub file: File,
    /// The faults.
    pub diagnostics: Vec<Diagnostic>,
    /// The texts, indexed by the `source` of a span.
    pub sources: Vec<Source>,
}

/// Loads a model without faults. A path wins over a built-in name; `with` lists effects to apply: of the model's own file,
/// built-in ones, or paths.
///
/// # Errors
/// [`LoadError`], if a file is missing or anything is at fault.
pub fn load(name_or_path: &str, with: &[&str]) -> Result<Model, LoadError> {
    let (name, text) = model_text(name_or_path)?;
    from_text(&name, &text, with)
}

/// Loads a model without faults from its text; `name` is shown in messages.
///
/// # Errors
/// As [`load`].
pub fn from_text(name: &str, text: &str, with: &[&str]) -> Result<Model, LoadError> {
    let loaded = inspect_text(name, text, with)?;
    match loaded.model {
        Some(model) if loaded.diagnostics.is_empty() => Ok(model),
        _ => Err(LoadError::Faults {
            diagnostics: loaded.diagnostics,
            sources: loaded.sources,
        }),
    }
}

/// Loads a model and reports its faults; finds models that are refuted on purpose by name too.
///
/// # Errors
/// [`LoadError`], if the model or an effect is missing, or an effect's own file is at fault.
pub fn inspect(name_or_path: &str, with: &[&str]) -> Result<Loaded, LoadError> {
    let (name, text) = model_text(name_or_path)?;
    inspect_text(&name, &text, with)
}

/// Loads a model from its text and reports its faults.
///
/// # Errors
/// As [`inspect`].
pub fn inspect_text(name: &str, text: &str, with: &[&str]) -> Result<Loaded, LoadError> {
    let (mut tree, mut diagnostics) = ModelTree::parse_with_faults(name, text);
    for wanted in with {
        let effect = match tree.find_effect(wanted) {
            Err(error) if !diagnostics.is_empty() => return Err(after(tree, diagnostics, error)),
            found => found?,
        };
        if let Err(faults) = tree.apply(&effect) {
            diagnostics.extend(faults);
        }
    }
    // A tree with holes would be reported a second time for what is missing from it.
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

/// Faults of a model followed by those of an effect's text, if the error is one of a text.
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
    }
    all.extend(sources);
    earlier.extend(diagnostics);
    LoadError::Faults {
        diagnostics: earlier,
        sources: all,
    }
}
