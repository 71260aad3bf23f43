//! Study of other simulators of discs: which laws of motion their equations break, which changes mend them, and what that
//! does to a throw. Writes docs/others.md.
//!
//! Each simulator's equations are a built-in model that claims a body; [`Simulator`] lists the changes that mend it, each an
//! edit of the model's text. The judgement is that of `hyzer verify`; flights are integrated from the oracle's derivatives.

mod flight;
mod page;
mod simulator;
mod study;

pub use page::others_page;
pub use simulator::{Change, SIMULATORS, Simulator};
pub use study::{LawInFlight, RateInFlight, Stage, Verdicts, judge, others};
