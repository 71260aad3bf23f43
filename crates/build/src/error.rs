//! Why models cannot be compiled.

use model_spec::load::LoadError;
use std::io;
use std::path::PathBuf;

/// Error of [`Config::compile`](crate::Config::compile).
#[derive(Debug, thiserror::Error)]
pub enum BuildError {
    /// No output directory: `OUT_DIR` is set only while cargo runs a build script.
    #[error("OUT_DIR is not set: call `compile` in a build script, or set `out_dir`")]
    NoOutDir,
    /// An effect precedes all models.
    #[error("effect `{effect}` has no model: call `with` after `model`")]
    NoModel {
        /// Name or path of the effect.
        effect: String,
    },
    /// A model, or an effect for it, is missing or invalid.
    #[error("model `{model}`:\n{source}")]
    Model {
        /// Name or path of the model.
        model: String,
        /// Diagnostics with file, line and column.
        source: Box<LoadError>,
    },
    /// Two models have the same name.
    #[error("two models would be written to `{path}`: rename one of them")]
    SamePath {
        /// Path below the output directory.
        path: String,
    },
    /// A generated file cannot be written.
    #[error("cannot write generated code to `{}`: {source}", directory.display())]
    Write {
        /// Output directory.
        directory: PathBuf,
        /// Cause.
        source: io::Error,
    },
}
