//! The compiler: a checked model becomes expressions, exact derivatives, and programs for several backends.
//!
//! One road: [`lower`](mod@lower) makes scalar expressions of the model's vectors in one [`graph`], which `differentiate`
//! adds the partial derivatives to and `specialize` puts constants into; [`ssa`] lists what is to be computed, with
//! common factors, products and sums computed once; [`schedule`] puts it in order as a [`program`].

pub mod backend;
pub mod compile;
pub mod count;
mod differentiate;
pub mod explain;
pub mod functions;
pub mod generate;
pub mod graph;
pub mod latex;
pub mod lower;
pub mod number;
pub mod program;
#[cfg(test)]
mod random_expressions;
pub mod rust;
pub mod schedule;
mod specialize;
pub mod ssa;
pub mod tape;
pub mod tape_model;

pub use compile::{Compiled, Effort, Selection, compile, compile_at, compile_for, compile_values};
pub use model_spec::layout::{self, Layout};
pub use tape_model::TapeModel;
