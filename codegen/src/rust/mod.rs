//! Rust source from the schedule, for reading as much as for running.
//!
//! The text is put together here, not printed from syntax trees, because those lose comments, and the
//! model's line stands beside what came of it. Every line fits the width of rustfmt, so that
//! formatting changes nothing.

mod expression;
mod function;
mod table;
mod width;

pub use table::{library, source_hash};

use crate::compile::Compiled;
use model_spec::model::Model;

/// Widest line.
pub(crate) const WIDTH: usize = 100;

/// The files of one model, relative to `src`: `disc/mod.rs`, `disc/f.rs`, …
pub fn emit(compiled: &Compiled, model: &Model) -> Vec<(String, String)> {
    let folder = &compiled.name;
    let mut files = vec![(format!("{folder}/mod.rs"), table::module(compiled, model))];
    for function in compiled.functions() {
        let text = function::emit(compiled, function);
        files.push((format!("{folder}/{}.rs", function.name), text));
    }
    files
}

/// A string as a Rust literal.
pub(crate) fn quoted(text: &str) -> String {
    format!("{text:?}")
}
