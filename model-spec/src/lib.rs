//! The language of flight models: a text is parsed, checked for units, frames and singular points,
//! and becomes a [`Model`](model::Model) that the compiler and the oracle both read.
//!
//! ```
//! let model = model_spec::load::load("disc", &[]).unwrap();
//! assert_eq!(model.states[3].name, "u");
//! assert_eq!(model.coefficients[1].unit_text, "1/rad");
//! ```

pub mod check;
pub mod diagnostic;
pub mod effect;
pub mod index;
pub mod layout;
pub mod load;
pub mod model;
mod render;
pub mod suggest;
pub mod summary;
pub mod syntax;
pub mod unit;
