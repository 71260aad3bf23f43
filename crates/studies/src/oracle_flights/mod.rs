//! Flights computed by the oracle, with an integrator and throws of this crate.

pub mod dataset;
pub mod integrate;
pub mod paper_flight;
pub mod throws;
