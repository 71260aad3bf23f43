//! Simulation of disc flights with ground contact: rigid-body impulses with restitution and Coulomb friction.

mod fly;
mod impulse;

pub(crate) use fly::{Touched, fly};
pub(crate) use impulse::Surface;
