//! Noise of the measured coordinates, and time-varying loads that the model does not explain.

mod estimate_noise;
mod random_walk_loads;

pub(crate) use estimate_noise::DAMPING;
pub(crate) use random_walk_loads::random_walk_loads;

pub use random_walk_loads::LoadHistory;
