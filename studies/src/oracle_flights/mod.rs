//! Flights simulated with the oracle's laws of motion, an integrator of this crate, and random throws.

mod conditions;
mod constants;
mod dataset;
mod integrate;
mod paper_flight;
mod throws;

pub use conditions::{NoiseCondition, TRUTH, TWELVE, noise_conditions};
pub(crate) use constants::{CurveCoefficients, angle_of_attack, reference_of};
pub use dataset::{Plan, disc, flights, truth};
pub(crate) use dataset::{
    add_noise, disc_constants, empty, even_times, file_name, marker_flight, sample_times,
};
pub(crate) use integrate::{
    Derivatives, integrate, integrate_law, integrate_with_constants, marker_positions,
};
pub use paper_flight::paper_flight;
pub(crate) use paper_flight::{SAMPLE_RATE, release_angle_of_attack};
pub use throws::Throws;
