//! Measured flights: datasets are read and checked, and coefficients are fitted to all flights at once.
//!
//! [`dataset`] reads the formats and refuses what is malformed. [`fit`](mod@fit) finds its starts by itself ([`start`]),
//! minimises what is left of the observed markers once the model's prediction is taken away, weighed by a noise that
//! it estimates ([`noise`], [`outlier`]), with the exact sensitivities of the compiled model ([`predict`]), and says
//! what its estimates are worth ([`uncertainty`]). [`report`] is what comes out. [`synthesize`] makes datasets whose truth is known.

pub mod chart;
mod cut;
pub mod dataset;
pub mod error;
pub mod fit;
pub mod levenberg;
pub mod noise;
pub mod normal;
pub mod options;
pub mod outlier;
pub mod pose;
pub mod predict;
pub mod report;
pub mod rows;
pub mod setting;
pub mod sight;
pub mod start;
pub mod synthesize;
pub mod track;
pub mod uncertainty;
