//! The model extended by the effects that a diagnosis selected.

use model_spec::LoadError;
use model_spec::compose::{EffectTree, ModelTree};
use model_spec::model::Model;

/// The model under test extended by the effects that a diagnosis selected.
#[derive(Clone, Debug)]
pub struct ExtendedModel {
    /// Identifiers of the added effects: first existing effects (built in or from the model's file), then effects that
    /// the diagnosis created from library terms.
    pub effects: Vec<String>,
    /// The model with the added effects switched on.
    pub model: Model,
    /// Source texts, in the model language, of the effects created from library terms. The order is that of the last
    /// entries of `effects`, which are the identifiers of these effects.
    pub written: Vec<String>,
    tree: ModelTree,
}

impl ExtendedModel {
    /// Extends the model `base` by the effects in `names`, from the model's own file or built in, and then by the
    /// effects `written`, which are created from library terms.
    ///
    /// # Errors
    /// [`LoadError`] if the effects cannot be combined with the model or with one another.
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
            tree,
        })
    }

    /// Syntax tree of the extended model, with the effects merged into its equations.
    pub fn tree(&self) -> &ModelTree {
        &self.tree
    }

    /// Source text of the extended model, with every effect merged into its equations. `note` is appended to the
    /// first comment of the text.
    pub fn text(&self, note: &str) -> String {
        self.tree.to_text(note)
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
