//! The compiler: a checked Model becomes a shared graph, exact derivatives, and code in several forms.
//!
//! Stages, each in its own module: [`derive`](mod@derive) (vectors to scalar nodes of a [`graph`]), [`optimise`]
//! (fewer operations), [`differentiate`] (exact, sparse), [`schedule`] (one order for all backends).

pub mod backend;
pub mod compile;
pub mod count;
pub mod derive;
pub mod differentiate;
pub mod explain;
pub mod functions;
pub mod generate;
pub mod graph;
pub mod latex;
pub mod number;
pub mod optimise;
pub mod program;
pub mod rust;
pub mod schedule;
pub mod tape;
pub mod tape_model;

pub use compile::{Compiled, Effort, Selection, compile, compile_at, compile_for};
pub use model_spec::layout::{self, Layout};
pub use tape_model::TapeModel;
