//! An open text, and what is known about it.

use std::cell::OnceCell;
use std::path::Path;

use model_spec::LoadError;
use model_spec::compose::{EffectTree, ModelTree};
use model_spec::diagnostic::{Diagnostic, Source};
use model_spec::load::{Open, inspect_open, sound_part};
use model_spec::model::Model;
use model_spec::symbols::Symbols;
use model_spec::syntax::ast::{self, ItemKind};
use model_spec::syntax::{MAX_SOURCE_BYTES, parse};
use serde_json::Value;

use super::computed;
use super::positions::Lines;
use super::uri;

/// Greatest length of an open text, bytes; a longer one is cut, which is longer than a model may be.
const MAX_TEXT_BYTES: usize = 4 * MAX_SOURCE_BYTES;

/// An open text.
pub struct Document {
    /// Name by which the client knows it.
    pub uri: String,
    /// Path of the file, or the name where it is none.
    pub path: String,
    /// Version that the client states with each change.
    pub version: Value,
    /// The text.
    pub text: String,
    /// Its lines.
    pub lines: Lines,
    analysis: Analysis,
    /// Whether the text, or one that it includes, has changed since.
    is_stale: bool,
    /// The model of the last text that had one; until then, of the statements that have no error.
    model: Option<Model>,
    /// Whether a text has been a model without errors of grammar and names.
    was_whole: bool,
    /// Operations for each quantity of that model, once they are asked for.
    operations: OnceCell<Vec<usize>>,
}

/// What is known about a text.
#[derive(Default)]
pub struct Analysis {
    /// Names.
    pub symbols: Symbols,
    /// Errors.
    pub faults: Vec<Diagnostic>,
    /// Texts to which the spans of the errors refer: this one, then files that it includes.
    pub sources: Vec<Source>,
}

impl Document {
    /// Opens a text.
    pub fn new(uri: &str, version: Value, text: &str) -> Document {
        let mut document = Document {
            uri: uri.to_owned(),
            path: uri::path(uri),
            version,
            text: String::new(),
            lines: Lines::default(),
            analysis: Analysis::default(),
            is_stale: true,
            model: None,
            was_whole: false,
            operations: OnceCell::new(),
        };
        document.set(text.to_owned());
        document
    }

    fn set(&mut self, mut text: String) {
        text.truncate(text.floor_char_boundary(MAX_TEXT_BYTES));
        if text.starts_with('\u{FEFF}') {
            text.remove(0);
        }
        self.lines = Lines::of(&text);
        self.text = text;
        self.is_stale = true;
    }

    /// Applies a change: the whole text, or the text of a range.
    pub fn change(&mut self, change: &Value) {
        let text = change["text"].as_str().unwrap_or_default();
        if change["range"].is_null() {
            return self.set(text.to_owned());
        }
        let range = self.lines.offsets(&self.text, &change["range"]);
        let mut changed = std::mem::take(&mut self.text);
        changed.replace_range(range, text);
        self.set(changed);
    }

    /// States that a file on which the text depends may have changed.
    pub fn forget(&mut self) {
        self.is_stale = true;
    }

    /// What was found out last; of a text that has changed since, the files that it includes are used.
    pub fn known(&self) -> &Analysis {
        &self.analysis
    }

    /// Whether the text, or one that it includes, has changed since the last analysis.
    pub fn is_stale(&self) -> bool {
        self.is_stale
    }

    /// The model of the last text that had one; until then, of the statements that have no error.
    pub fn model(&self) -> Option<&Model> {
        self.model.as_ref()
    }

    /// Operations for each auxiliary variable of the model, by its index; none if they are not known.
    pub fn operations(&self) -> &[usize] {
        let model = self.model.as_ref();
        let count = || model.map_or_else(Vec::new, computed::of_quantities);
        self.operations.get_or_init(count)
    }

    /// Checks the text; of the files that are `open`, these texts count.
    pub fn check(&self, open: &Open<'_>) -> Checked {
        let mut found = checked(&self.path, &self.text, open);
        found.is_whole = found.model.is_some();
        if !found.is_whole && !self.was_whole {
            found.model = sound_part(&self.path, &self.text, open);
        }
        found
    }

    /// Takes over what [`Document::check`] found.
    pub fn learn(&mut self, found: Checked) {
        self.was_whole |= found.is_whole;
        if let Some(model) = found.model {
            self.model = Some(model);
            self.operations = OnceCell::new();
        }
        let symbols = match self.text.len() {
            0..=MAX_SOURCE_BYTES => Symbols::of(&self.text),
            _ => Symbols::default(),
        };
        self.analysis = Analysis {
            symbols,
            faults: found.faults,
            sources: found.sources,
        };
        self.is_stale = false;
    }
}

/// What a check of a text finds out.
#[derive(Default)]
pub struct Checked {
    faults: Vec<Diagnostic>,
    /// Texts to which the errors refer.
    sources: Vec<Source>,
    model: Option<Model>,
    /// Whether the model is that of the whole text.
    is_whole: bool,
}

impl Checked {
    fn new(faults: Vec<Diagnostic>, sources: Vec<Source>, model: Option<Model>) -> Checked {
        Checked {
            faults,
            sources,
            model,
            is_whole: false,
        }
    }
}

fn checked(path: &str, text: &str, open: &Open<'_>) -> Checked {
    let parsed = parse(path, text);
    let items = &parsed.file.items;
    let is_effect = |item: &ast::Item| matches!(item.kind, ItemKind::Effect(_));
    if !items.is_empty() && items.iter().all(is_effect) {
        return of_effect(path, text, parsed.diagnostics);
    }
    match inspect_open(path, text, open) {
        Ok(mut loaded) => {
            let model = loaded.model.as_ref();
            if let Some(model) = model.filter(|_| loaded.diagnostics.is_empty()) {
                loaded.diagnostics = computed::failing_checks(model);
            }
            Checked::new(loaded.diagnostics, loaded.sources, loaded.model)
        }
        Err(LoadError::Faults {
            diagnostics,
            sources,
        }) => Checked::new(diagnostics, sources, None),
        Err(_) => Checked::default(),
    }
}

/// Checks an effect by the first model that it names, a file beside it or a built-in one.
fn of_effect(path: &str, text: &str, faults: Vec<Diagnostic>) -> Checked {
    let none = |faults| Checked::new(faults, Vec::new(), None);
    if !faults.is_empty() {
        return none(faults);
    }
    // Several effects, none with the name of the file, are no error.
    let Ok(effect) = EffectTree::parse(path, text) else {
        return none(Vec::new());
    };
    let Some(on) = effect.tree().on.first() else {
        return none(Vec::new());
    };
    let beside = Path::new(path).with_file_name(format!("{}.hyz", on.text));
    let beside = ModelTree::load(&beside.to_string_lossy());
    let Ok(tree) = beside.or_else(|_| ModelTree::load(&on.text)) else {
        return none(Vec::new());
    };
    match tree.with(&effect).and_then(|extended| extended.check()) {
        Ok(model) => Checked::new(Vec::new(), Vec::new(), Some(model)),
        Err(error) => Checked::new(in_source(error, path), Vec::new(), tree.check().ok()),
    }
}

/// Errors in the text of this name, as if it were alone.
fn in_source(error: LoadError, path: &str) -> Vec<Diagnostic> {
    let LoadError::Faults {
        mut diagnostics,
        sources,
    } = error
    else {
        return Vec::new();
    };
    let own = sources.iter().rposition(|source| source.name == path);
    let own = own.and_then(|own| u16::try_from(own).ok()).unwrap_or(0);
    diagnostics.retain(|fault| fault.span.source == own);
    for fault in &mut diagnostics {
        fault.labels.retain(|label| label.span.source == own);
        fault.fix.take_if(|fix| fix.span.source != own);
        fault.span.source = 0;
        fault
            .labels
            .iter_mut()
            .for_each(|label| label.span.source = 0);
        fault.fix.iter_mut().for_each(|fix| fix.span.source = 0);
    }
    diagnostics
}
