//! Text of a model with the estimates of a fit as its default values.

use dataset::Dataset;
use model_spec::compose::{ModelTree, ValueError};
use model_spec::layout::Layout;

use super::Fit;

impl Fit {
    /// Text of the model `tree` whose default values are the known parameters of the dataset and the estimates; `note`
    /// is appended to its first comment.
    ///
    /// # Errors
    /// [`ValueError`] if the tree with these values is not a valid model.
    pub fn fitted_text(
        &self,
        tree: &ModelTree,
        dataset: &Dataset,
        note: &str,
    ) -> Result<String, ValueError> {
        let given = dataset.parameters.iter();
        let given = given.map(|(name, value)| (name.as_str(), *value));
        // Estimates that belong to the measurement, such as the direction of the vertical, are no parameters of the
        // model.
        let layout = Layout::new(&tree.check()?);
        let found = self.report.coefficients.iter();
        let found = found.filter(|(name, _)| layout.parameter(name).is_some());
        let found = found.map(|(name, coefficient)| (name.as_str(), coefficient.value));
        Ok(tree.with_values(given.chain(found))?.to_text(note))
    }
}
