//! Error type of the compilation of models.

use model_spec::load::LoadError;
use std::io;
use std::path::PathBuf;

/// Error of compiling flight models to Rust modules by [`Config::compile`](crate::build::Config::compile).
#[derive(thiserror::Error)]
pub enum BuildError {
    /// No output directory: `OUT_DIR` is set only while cargo runs a build script.
    #[error("OUT_DIR is not set: call `compile` in a build script, or set `out_dir`")]
    NoOutDir,
    /// [`Config::with`](crate::build::Config::with) was called before a model was added.
    #[error("effect `{effect}` has no model: call `with` after `model`")]
    NoModel {
        /// Name or path of the effect, as passed to [`Config::with`](crate::build::Config::with).
        effect: String,
    },
    /// A model, or an effect applied to it, is missing or invalid.
    #[error("model `{model}`:\n{source}")]
    Model {
        /// Name or path of the model, as passed to [`Config::model`](crate::build::Config::model).
        model: String,
        /// Error of loading the model, with diagnostics that state file, line and column.
        source: Box<LoadError>,
    },
    /// Two models have the same name, so both would be written to the same file.
    #[error("two models would be written to `{path}`: rename one of them")]
    SamePath {
        /// Path of the file, relative to the output directory.
        path: String,
    },
    /// A generated file cannot be written.
    #[error("cannot write generated code to `{}`: {source}", directory.display())]
    Write {
        /// Output directory, in which the file was to be written.
        directory: PathBuf,
        /// Error that the operating system returned when the file was written.
        source: io::Error,
    },
}

/// Prints as `Display` does, because a build script prints its error by `Debug`.
impl std::fmt::Debug for BuildError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Display::fmt(self, f)
    }
}
