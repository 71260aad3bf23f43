//! Code generators: from compiled models to source text.
//!
//! All backends follow the schedule of [`Compiled`](crate::Compiled): the statements of each [`Function`](crate::program::Function) in
//! their order, one operation each, so that the results of two backends differ only by the rounding of their
//! arithmetic. A backend prints; it neither reorders nor simplifies.
//!
//! # Adding a backend
//!
//! 1. Write one file with a type that implements [`Backend`].
//! 2. Register it in [`BACKENDS`].
//!
//! `hyzer generate MODEL --out DIR --backend NAME`, its `--check`, and the tests that run over all backends then
//! include it. What is not specific to a language is in `body`: the names of local variables,
//! which statements are written inside others, where inputs are loaded and results stored, and the lines of the model
//! for comments. A C backend consists of one `match` over `body::Step`, which prints declarations and
//! assignments, and one over [`Op`](crate::program::Op), which prints expressions; the unit test of this module is
//! such a backend.

pub(crate) mod body;
mod interface;
pub(crate) mod pairs;
mod registry;
#[cfg(test)]
mod tests;

pub use interface::{Backend, SourceFile};
pub use registry::{BACKENDS, backend};
