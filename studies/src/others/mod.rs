//! Study of other disc simulators: which laws of motion their equations violate, which changes correct them, and how
//! the changes alter a throw. Writes docs/studies/others.md.
//!
//! Each simulator's equations are a built-in model that claims a body. [`Simulator`] lists the changes that correct
//! them, as edits of the model's text. The verdicts are those of `hyzer verify`; flights are integrated from the
//! oracle's derivatives.

mod flight;
mod page;
mod simulator;
mod study;

pub use page::others_page;
pub use simulator::{Change, SIMULATORS, Simulator};
pub use study::{LawInFlight, RateInFlight, Stage, Verdicts, judge, others};
