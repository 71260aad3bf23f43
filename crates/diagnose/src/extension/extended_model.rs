//! A model with the effects that a diagnosis selected.

use model_spec::load::{self, LoadError};
use model_spec::model::Model;
use model_spec::syntax::ast::ItemKind;

/// A model with the effects that a diagnosis selected.
#[derive(Clone, Debug)]
pub struct ExtendedModel {
    /// Identifiers of the effects that were added.
    pub effects: Vec<String>,
    /// The model with them switched on.
    pub model: Model,
    /// Texts of the effects that the diagnosis wrote, in the order of their names in `effects`.
    pub written: Vec<String>,
}

impl ExtendedModel {
    /// Switches effects on. `with` are those that were on before, by name or path; `written` are the texts of effects that
    /// are neither built in nor in the model's file.
    ///
    /// # Errors
    /// [`LoadError`] if the effects cannot be applied together.
    pub(crate) fn new(
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

    /// The text of the extended model, every effect written into its equations. `header` is added to its first comment.
    ///
    /// # Errors
    /// [`LoadError`] if the text would not be a model.
    pub fn text(&self, base: &Model, with: &[String], header: &str) -> Result<String, LoadError> {
        let source = &base.sources[0];
        let text = with_texts(&source.text, &self.written);
        let names = with.iter().chain(&self.effects);
        let names: Vec<&str> = names.map(String::as_str).collect();
        let mut file = load::inspect_text(&source.name, &text, &names)?.file;
        // An effect that is part of the equations is not offered any more.
        let applied: Vec<String> = file.applied.iter().map(|a| a.name.text.clone()).collect();
        file.items.retain(|item| match &item.kind {
            ItemKind::Effect(effect) => !applied.contains(&effect.name.text),
            _ => true,
        });
        file.doc = format!("{}\n\n{header}", file.doc.trim_end());
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_text_is_a_model_with_the_effect_in_its_equations() {
        let base = load::load("disc", &[]).unwrap();
        let effects = vec!["stall".to_owned()];
        let extended = ExtendedModel::new(&base, &[], effects, Vec::new()).unwrap();
        let text = extended.text(&base, &[], "Extended by stall.").unwrap();
        assert!(text.contains("Extended by stall."));
        let again = load::from_text("extended", &text, &[]).unwrap();
        let names: Vec<&str> = again.coefficients.iter().map(|c| c.name.as_str()).collect();
        assert!(names.contains(&"C_Ls") && again.effects.is_empty());
    }
}
