//! Study of fits and diagnoses of datasets as they occur in practice: recordings of many kinds, mistakes of a laboratory,
//! and physics that the model lacks. Writes docs/studies/wild.md.
//!
//! The flights are integrated by this crate from the oracle's laws of motion.

mod case;
mod classes;
mod fly;
mod hidden;
mod judge;
mod mistakes;
mod page;
mod recording;
mod run;
mod setting;
mod signal;

pub use case::{Case, Group, cases};
pub use judge::{Diagnosed, Fitted};
pub use page::wild_page;
pub use run::{Outcome, wild};
