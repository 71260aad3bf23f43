//! Study of models that a user wrote: whether effects hidden in their flights are detected, and attributed to the right
//! site. Writes docs/studies/own-models.md.
//!
//! The flights are integrated by this crate from the model's vector tree, as the oracle evaluates it, with each hidden
//! effect added in hand-written code.

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
pub(crate) use world::dataset as flights;
