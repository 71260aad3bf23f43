//! Flights with seeded effects: some of the catalogue, by the oracle's implementation, and some that no catalogue lists.
//!
//! Neither the compiler nor the text of an effect takes part: forces, integration and observation are the oracle's and
//! this crate's own.

pub mod ball;
mod disc;
mod effects;
mod flight;
mod input_errors;
mod strength;
mod unlisted;
mod world;

pub use disc::{dataset, greatest_angle_of_attack};
pub use effects::SeededEffects;
pub use input_errors::InputErrors;
pub use strength::{STRENGTHS, Strength, strength};
pub use unlisted::{UNLISTED, UnlistedEffect, unlisted};
