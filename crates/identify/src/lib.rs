//! Measured flights: datasets are read and checked, and coefficients are fitted to all flights at once.
//!
//! [`dataset`] reads the folder format and refuses what is malformed, [`fit`](mod@fit) minimises the squared
//! differences between observed and predicted markers with the exact sensitivities of the compiled
//! model, and [`report`] writes what came out.

pub mod dataset;
pub mod error;
pub mod fit;
pub mod levenberg;
pub mod normal;
pub mod predict;
pub mod report;
pub mod start;
