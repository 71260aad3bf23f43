//! Study of models that a user wrote: whether effects hidden in their flights are detected, and found at the right site.
//! Writes docs/own-models.md.
//!
//! The flights are those of the model's vector tree, which the oracle evaluates, with each hidden effect added by hand
//! and an integrator of this crate.

mod hidden;
mod hidden_lists;
mod page;
mod run;
mod subjects;
mod world;

pub use hidden::Hidden;
pub use hidden_lists::hidden_of;
pub use page::own_models_page;
pub use run::{Outcome, Task, own_models, tasks};
pub use subjects::{SUBJECTS, Subject};
