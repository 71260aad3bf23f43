//! The language of flight models: a text is parsed, checked for units, frames and singular points,
//! and becomes a [`Model`](model::Model) that the compiler and the oracle both read.

pub mod diagnostic;
pub mod model;
pub mod unit;
