//! Power of the score tests: effects that these flights cannot identify, and minimum detectable sizes of the others.

mod detectable;

pub(crate) use detectable::detectable;

pub use detectable::{MinDetectableEffect, NotIdentifiable};
