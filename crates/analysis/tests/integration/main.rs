//! Integration tests of the analyses: design of throws, modes of the linearised motion, sweeps.

mod bounds;
mod eigenvalues;
mod gradients;
mod spread;
mod steady_flight;
mod support;
#[cfg(feature = "sweep")]
mod sweep_wind;
mod tasks;
mod three_moments;
mod wind;
