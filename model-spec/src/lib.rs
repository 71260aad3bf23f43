//! The language of flight models. A text is parsed, checked for units, frames and singular points, and converted to a
//! [`Model`](model::Model), which the compiler and the oracle read.
//!
//! | task | items |
//! |---|---|
//! | load a model by name or path, with effects | [`load`](mod@load) |
//! | combine a model with many effects | [`compose`]: [`ModelTree`], [`EffectTree`] |
//! | read a checked model | [`model`], [`unit`](mod@unit), [`summary`], [`singular_points`] |
//! | order of states and parameters in arrays | [`layout`]: [`Layout`], [`index`] |
//! | products of variables for unknown effects | [`term_library`] |
//! | read, change and print syntax trees | [`syntax`], [`check`] |
//! | show faults | [`diagnostic`], [`render`], [`location`], [`LoadError`] |
//!
//! ```
//! let model = model_spec::load::load("disc", &["wind"])?;
//! assert_eq!(model.states[3].name, "u");
//! assert_eq!(model.coefficients[1].unit_text, "1/rad");
//! assert_eq!(model.effects[0].site, "wind");
//!
//! let error = model_spec::load::load("dsic", &[]).unwrap_err();
//! assert!(error.to_string().contains("did you mean `disc`?"));
//! # Ok::<(), model_spec::LoadError>(())
//! ```

mod check;
pub mod compose;
pub mod diagnostic;
mod effect;
mod files;
mod fingerprint;
mod format;
pub mod index;
pub mod layout;
pub mod load;
pub mod location;
pub mod model;
mod order;
mod read;
mod render;
mod suggest;
mod summary;
pub mod symbols;
pub mod syntax;
pub mod term_library;
pub mod unit;

// Loading and composition of models.
pub use compose::{EffectTree, ModelTree};
pub use read::LoadError;
// Checks of a syntax tree or of a model.
pub use check::{Checked, SingularPoint, check, singular_points};
pub use effect::{SITES, VARIABLES};
// Order of states and parameters in arrays.
pub use layout::Layout;
// Hash of texts, sorting by numbers.
pub use fingerprint::fingerprint;
pub use order::sort_by_number;
// Text output.
pub use format::format;
pub use render::render;
pub use suggest::nearest as nearest_name;
pub use summary::{knots, summary, with_unit};
