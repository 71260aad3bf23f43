//! Code generators: from compiled models to source text.
//!
//! All backends follow the schedule of [`Compiled`]: the statements of each [`Function`](crate::program::Function) in
//! their order, one operation each, so that the results of two backends differ only by the rounding of their
//! arithmetic. A backend prints; it neither reorders nor simplifies.
//!
//! # Adding a backend
//!
//! 1. Write one file with a type that implements [`Backend`].
//! 2. Register it in [`BACKENDS`].
//!
//! `hyzer generate MODEL --out DIR --backend NAME`, its `--check`, the build-script interface and the tests that run
//! over all backends then include it. What is not specific to a language is in [`body`]: the names of local variables,
//! which statements are written inside others, where inputs are loaded and results stored, and the lines of the model
//! for comments. A C backend consists of one `match` over [`Step`](body::Step), which prints declarations and
//! assignments, and one over [`Op`](crate::program::Op), which prints expressions.

pub(crate) mod body;
pub(crate) mod pairs;

use crate::compile::Compiled;
use crate::rust;
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

/// All backends, the default first.
pub static BACKENDS: &[&dyn Backend] = &[&rust::PlainRust, &rust::LanesRust];

/// The backend with a given name.
pub fn backend(name: &str) -> Option<&'static dyn Backend> {
    BACKENDS
        .iter()
        .copied()
        .find(|backend| backend.name() == name)
}
