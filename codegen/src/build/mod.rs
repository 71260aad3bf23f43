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

mod config;
mod error;

pub use config::Config;
pub use error::BuildError;
