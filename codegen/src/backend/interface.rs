//! Interface of code generation backends.

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
