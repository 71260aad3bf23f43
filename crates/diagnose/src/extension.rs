//! The model extended by the effects that a diagnosis selected.

use model_spec::LoadError;
use model_spec::compose::{EffectTree, ModelTree};
use model_spec::model::Model;

/// The model under test extended by the effects that a diagnosis selected.
#[derive(Clone, Debug)]
pub struct ExtendedModel {
    /// Identifiers of the added effects: existing ones, then those created from library terms.
    pub effects: Vec<String>,
    /// The model with the added effects switched on.
    pub model: Model,
    /// Source texts of the effects created from library terms, the last ones of `effects`.
    pub written: Vec<String>,
}

impl ExtendedModel {
    /// Extends `base` by the effects in `names`, and then by `written`. An error if they cannot be combined.
    pub(crate) fn new(
        base: &Model,
        names: &[String],
        written: &[EffectTree],
    ) -> Result<Self, LoadError> {
        let mut tree = ModelTree::of(base).with_named(names)?;
        for effect in written {
            tree = tree.with(effect)?;
        }
        let written_names = written.iter().map(|effect| effect.name().to_owned());
        Ok(Self {
            effects: names.iter().cloned().chain(written_names).collect(),
            model: tree.check()?,
            written: written.iter().map(EffectTree::to_string).collect(),
        })
    }

    /// Source text with every effect merged into the equations; `note` is appended to its first comment.
    pub fn text(&self, note: &str) -> String {
        ModelTree::of(&self.model).to_text(note)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use model_spec::load;

    #[test]
    fn the_text_is_a_model_with_the_effect_in_its_equations() {
        let base = load::load("disc", &[]).unwrap();
        let extended = ExtendedModel::new(&base, &["stall".to_owned()], &[]).unwrap();
        let text = extended.text("Extended by stall.");
        assert!(text.contains("Extended by stall."));
        let again = load::from_text("extended", &text, &[]).unwrap();
        let names: Vec<&str> = again.coefficients.iter().map(|c| c.name.as_str()).collect();
        assert!(names.contains(&"C_Ls") && again.effects.is_empty());
    }
}
