//! Power of the score tests: which effects these flights cannot identify, and how small an effect they detect.

mod detectable;

pub(crate) use detectable::detectable;

pub use detectable::{MinDetectableEffect, NotIdentifiable};
