//! Compiles flight models to Rust modules in build scripts.
//!
//! A crate lists this one under `[build-dependencies]` and compiles its models in `build.rs`:
//!
//! ```no_run
//! fn main() -> Result<(), codegen::build::BuildError> {
//!     codegen::build::Config::new()
//!         .model("models/kite.hyz")
//!         .model("disc")
//!         .with("wind_by_height")
//!         .compile()?;
//!     Ok(())
//! }
//! ```
//!
//! Each model becomes one file in `OUT_DIR`, named after the model, which the crate includes as a module:
//!
//! ```ignore
//! mod kite {
//!     include!(concat!(env!("OUT_DIR"), "/kite.rs"));
//! }
//!
//! let mut prepared = [0.0; kite::PREPARED.len()];
//! kite::prepare(&kite::DEFAULTS, &mut prepared);
//! let mut dx = [0.0; kite::STATES.len()];
//! kite::f(0.0, &kite::INITIAL, &kite::DEFAULTS, &prepared, &mut dx);
//! ```
//!
//! The generated code computes with `f64` and has no dependencies. [`Config::lanes`] makes it generic over
//! `lanes::Real`.

use crate::backend::{Backend, SourceFile};
use crate::generate;
use crate::rust::{LanesRust, PlainRust};
use model_spec::load;
use model_spec::load::LoadError;
use model_spec::model::Model;
use std::path::{Path, PathBuf};
use std::{env, io};

/// Builder that compiles flight models to Rust modules. It holds the models, their effects and the output directory.
#[derive(Clone, Debug, Default)]
pub struct Config {
    models: Vec<ModelSource>,
    /// Effects passed to [`Config::with`] before any model was added; [`Config::compile`] reports them as an error.
    orphans: Vec<String>,
    out_dir: Option<PathBuf>,
    lanes: bool,
}

#[derive(Clone, Debug)]
struct ModelSource {
    /// Name of a built-in model, or path of a model file.
    model: String,
    effects: Vec<String>,
}

impl Config {
    /// Creates a configuration without models, for `f64` and the directory `OUT_DIR`.
    pub fn new() -> Config {
        Config::default()
    }

    /// Adds a model: the path of a `.hyz` file, relative to the root of the package, or the name of a built-in model.
    pub fn model(&mut self, name_or_path: impl Into<String>) -> &mut Config {
        self.models.push(ModelSource {
            model: name_or_path.into(),
            effects: Vec::new(),
        });
        self
    }

    /// Applies an effect, by path or name, to the model that was added last.
    pub fn with(&mut self, effect: impl Into<String>) -> &mut Config {
        match self.models.last_mut() {
            Some(model) => model.effects.push(effect.into()),
            None => self.orphans.push(effect.into()),
        }
        self
    }

    /// Sets the output directory; the default is the value of the environment variable `OUT_DIR`.
    pub fn out_dir(&mut self, directory: impl Into<PathBuf>) -> &mut Config {
        self.out_dir = Some(directory.into());
        self
    }

    /// Sets whether the generated code is generic over `lanes::Real` instead of using `f64` (default: `false`).
    pub fn lanes(&mut self, lanes: bool) -> &mut Config {
        self.lanes = lanes;
        self
    }

    /// Compiles the models and returns the paths of their modules, in order of the models.
    ///
    /// In a build script, the function also asks cargo to run the script again when one of the model or effect files
    /// changes. Output files whose content is unchanged keep their modification time.
    ///
    /// # Errors
    /// [`BuildError::Model`] if a model or effect is missing or invalid, with diagnostics; the other variants if the
    /// configuration is invalid or a file cannot be written.
    pub fn compile(&self) -> Result<Vec<PathBuf>, BuildError> {
        if let Some(effect) = self.orphans.first() {
            return Err(BuildError::NoModel {
                effect: effect.clone(),
            });
        }
        let out_dir = self.out_dir.clone();
        let out_dir = out_dir
            .or_else(|| env::var_os("OUT_DIR").map(PathBuf::from))
            .ok_or(BuildError::NoOutDir)?;
        let files = self.generate()?;
        generate::write_files(&out_dir, &files).map_err(|source| BuildError::Write {
            directory: out_dir.clone(),
            source,
        })?;
        Ok(files.iter().map(|file| out_dir.join(&file.path)).collect())
    }

    fn generate(&self) -> Result<Vec<SourceFile>, BuildError> {
        let backend: &dyn Backend = if self.lanes { &LanesRust } else { &PlainRust };
        let mut files: Vec<SourceFile> = Vec::new();
        for ModelSource { model, effects } in &self.models {
            let effects: Vec<&str> = effects.iter().map(String::as_str).collect();
            let loaded = load::load(model, &effects).map_err(|source| BuildError::Model {
                model: model.clone(),
                source: Box::new(source),
            })?;
            Self::request_reruns(&loaded);
            for file in generate::generate_with(backend, &[loaded]) {
                if files.iter().any(|other| other.path == file.path) {
                    return Err(BuildError::SamePath { path: file.path });
                }
                files.push(file);
            }
        }
        Ok(files)
    }

    /// In a build script, prints `cargo::rerun-if-changed` for each file of a model, those that it includes among them.
    fn request_reruns(model: &Model) {
        if env::var_os("OUT_DIR").is_none() {
            return;
        }
        let names = model.sources.iter().map(|source| &source.name);
        for path in names.filter(|name| Path::new(name).is_file()) {
            println!("cargo::rerun-if-changed={path}");
        }
    }
}

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
