//! The language of flight models: a text is parsed, checked for units, frames and singular points,
//! and becomes a [`Model`](model::Model) that the compiler and the oracle both read.
//!
//! ```
//! let model = model_spec::load::load("disc", &[]).unwrap();
//! assert_eq!(model.states[3].name, "u");
//! assert_eq!(model.coefficients[1].unit_text, "1/rad");
//! ```

pub mod check;
pub mod compose;
pub mod diagnostic;
pub mod effect;
mod error;
pub mod index;
pub mod layout;
mod library;
pub mod load;
pub mod model;
mod read;
mod render;
mod source;
pub mod suggest;
pub mod summary;
pub mod syntax;
pub mod term_library;
pub mod unit;

pub use error::LoadError;
pub use render::render;
