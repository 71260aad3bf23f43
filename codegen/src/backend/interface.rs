//! What a backend is.

use crate::compile::Compiled;
use model_spec::model::Model;

/// A generated source file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct SourceFile {
    /// Path below the output directory, with `/` as separator.
    pub path: String,
    /// The whole text.
    pub text: String,
}

/// A generator of source code in one language.
pub trait Backend: Sync {
    /// Name on the command line.
    fn name(&self) -> &'static str;

    /// One line about the generated code, for help texts.
    fn description(&self) -> &'static str;

    /// The files of one model. Equal arguments give equal text.
    fn emit(&self, model: &Model, compiled: &Compiled) -> Vec<SourceFile>;
}
