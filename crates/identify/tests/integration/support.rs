//! What tests share.

use flight::release::{Release, Vocabulary, built_in, read};
use model_spec::model::Model;

/// A built-in release, of a model.
pub fn release(name: &str, model: &Model) -> Release {
    let text = built_in(name).expect("built in");
    read(name, text, |_| Ok(Vocabulary::of(model))).expect("a release")
}
