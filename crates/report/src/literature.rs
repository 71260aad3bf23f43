//! Published values of coefficients, selected by the `reference` of a model.
//!
//! Values for discs are converted to the frames and signs of this repository's models, in which negative `C_Mq` and
//! `C_Nr` damp. Values with an incompatible definition are omitted.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use serde::Deserialize;

/// A publication that contains values of coefficients.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub(crate) struct Source {
    /// Short name, used as the heading of a table column.
    pub(crate) short: String,
    /// Full citation, and how the values were converted to the coordinate frames and sign conventions of the models.
    pub(crate) long: String,
    /// Published values by coefficient, as printed but for the sign, which follows the convention of the models.
    pub(crate) values: BTreeMap<String, String>,
}

/// Publications for the literature reference that a model file declares; empty if it is unknown or `None`.
pub(crate) fn sources(reference: Option<&str>) -> &'static [Source] {
    static ALL: LazyLock<BTreeMap<String, Vec<Source>>> =
        LazyLock::new(|| serde_json::from_str(include_str!("literature.json")).unwrap_or_default());
    let found = reference.and_then(|reference| ALL.get(reference));
    found.map_or(&[], Vec::as_slice)
}
