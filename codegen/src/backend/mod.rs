//! Code generators: translate compiled models to source text.
//!
//! All backends follow the schedule of [`Compiled`]: they print the statements of each
//! [`Function`](crate::program::Function) in order, one operation each, so that the results of two backends differ only
//! by the rounding of their arithmetic. A backend only prints; it neither reorders nor simplifies.
//!
//! # Adding a backend
//!
//! 1. Write one file with a type that implements [`Backend`].
//! 2. Register it in [`BACKENDS`](crate::BACKENDS).
//!
//! `hyzer generate MODEL --out DIR --backend NAME`, its `--check`, and the tests that run over all backends then
//! include the new backend. The module `body` contains all that does not depend on the language: the names of local
//! variables, which statements are written inside other statements, where inputs are loaded and results stored, and the
//! lines of the model for comments. A C backend consists of one `match` over `body::Step`, which prints declarations
//! and assignments, and one over [`Op`](crate::program::Op), which prints expressions; the unit test of this module
//! contains such a backend.

pub(crate) mod body;
#[cfg(test)]
mod tests;

use crate::compile::Compiled;
use model_spec::model::Model;

/// Generated source file: path and text.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct SourceFile {
    /// Path relative to the output directory, with `/` as separator.
    pub path: String,
    /// Complete text of the file.
    pub text: String,
}

/// Code generator for one output language.
pub trait Backend: Sync {
    /// Name of the backend in command-line options.
    fn name(&self) -> &'static str;

    /// One-line description of the generated code, for help texts.
    fn description(&self) -> &'static str;

    /// Generates the source files of one model; equal arguments give equal text.
    fn emit(&self, model: &Model, compiled: &Compiled) -> Vec<SourceFile>;
}
