//! Simulates flights with added effects, some of them from the catalogue (in hand-written formulas, see
//! [`law`]) and some that are in no catalogue.
//!
//! Neither the compiler nor the text of an effect is used: forces, integration and observation are implemented by the
//! oracle and this crate.

pub mod ball;
mod disc;
mod effects;
mod flight;
mod input_errors;
pub mod law;
mod strength;
mod unlisted;
mod world;

pub use disc::{dataset, greatest_angle_of_attack};
pub use effects::SeededEffects;
pub use input_errors::InputErrors;
pub use strength::{STRENGTHS, Strength, strength};
pub use unlisted::{UNLISTED, UnlistedEffect, unlisted};
pub(crate) use world::SeededWorld;
