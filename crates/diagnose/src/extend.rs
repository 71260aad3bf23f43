//! The extension: the model with what was found written into it, as a file of its own.

use model_spec::load::{self, LoadError};
use model_spec::model::Model;
use model_spec::syntax::ast::ItemKind;

/// A model with what was found.
#[derive(Clone, Debug)]
pub struct Extension {
    /// Names of the effects that were added, with underscores.
    pub effects: Vec<String>,
    /// The model with them switched on.
    pub model: Model,
    /// Texts of effects that were written for it; those of the catalogue have none here.
    pub written: Vec<String>,
}

impl Extension {
    /// Switches effects on: `with` are those that were on before, by name or path; `written` are the texts of effects that are
    /// not of the catalogue.
    ///
    /// # Errors
    /// Where they cannot be applied together.
    pub fn new(
        base: &Model,
        with: &[String],
        effects: Vec<String>,
        written: Vec<String>,
    ) -> Result<Self, LoadError> {
        let source = &base.sources[0];
        let text = with_texts(&source.text, &written);
        let names: Vec<&str> = with.iter().chain(&effects).map(String::as_str).collect();
        let model = load::from_text(&source.name, &text, &names)?;
        Ok(Self {
            effects,
            model,
            written,
        })
    }

    /// The text of the extended model, every effect written into its equations. `told` are lines to begin with.
    ///
    /// # Errors
    /// Where the text would not be a model.
    pub fn text(&self, base: &Model, with: &[String], told: &str) -> Result<String, LoadError> {
        let source = &base.sources[0];
        let text = with_texts(&source.text, &self.written);
        let names: Vec<&str> = with
            .iter()
            .chain(&self.effects)
            .map(String::as_str)
            .collect();
        let mut file = load::inspect_text(&source.name, &text, &names)?.file;
        // What is written in need not be offered any more.
        let applied: Vec<String> = file.applied.iter().map(|a| a.name.text.clone()).collect();
        file.items.retain(|item| match &item.kind {
            ItemKind::Effect(effect) => !applied.contains(&effect.name.text),
            _ => true,
        });
        file.doc = format!("{}\n\n{told}", file.doc.trim_end());
        Ok(file.to_string())
    }
}

fn with_texts(base: &str, written: &[String]) -> String {
    let mut text = base.to_owned();
    for effect in written {
        text.push('\n');
        text.push_str(effect);
    }
    text
}
