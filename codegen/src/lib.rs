//! Compiler of flight models: from a checked model to scalar expressions, exact Jacobians, and programs for several
//! backends.
//!
//! Pipeline: `lower` turns the model's vector equations into scalar nodes of one expression [`graph`];
//! `differentiate` adds partial derivatives and `specialize` substitutes constants; `ssa` eliminates common
//! subexpressions and lists the definitions; `schedule` orders the definitions as the statements of a [`program`].

pub mod backend;
pub mod build;
mod cases;
pub mod compile;
pub mod count;
mod differentiate;
pub mod explain;
pub mod functions;
pub mod generate;
pub mod graph;
pub mod ir;
pub mod latex;
mod lower;
pub mod number;
pub mod program;
#[cfg(test)]
mod random_expressions_tests;
mod registry;
pub mod rust;
mod schedule;
mod specialize;
mod ssa;
pub mod switches;
pub mod table;
pub mod tape;
pub mod tape_model;

pub use cases::{Comparison, check_cases};
pub use compile::{
    Compiled, Effort, EveryValue, Selection, compile, compile_at, compile_every_value, compile_for,
    compile_values,
};
pub use model_spec::layout::{self, Layout};
pub use registry::{BACKENDS, backend};
pub use tape_model::TapeModel;
