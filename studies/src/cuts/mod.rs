//! Study of truncation at ground contact: flights that touch nothing, and flights that bounce. Writes a section of
//! docs/studies/spoiled.md.

mod bounces;
mod free;
mod section;

pub(crate) use bounces::bouncing_flight;

pub use bounces::{Bounce, bounces};
pub use free::{FreeFlight, free_flights};
pub use section::CutSection;
