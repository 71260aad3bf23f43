//! Many flights of a model: [`plan`] says what varies, [`run`] flies it in SIMD lanes over threads, and writes a table in
//! Parquet with a row per flight and a summary.
//!
//! A flight depends on the plan and its own number alone: results are the same bits for any number of threads and however the
//! work is divided. Flights are grouped in parts, each written whole; a run goes on where an earlier one was ended.

#![forbid(unsafe_code)]

mod atomic;
mod error;
pub mod folder;
mod inputs;
pub mod plan;
mod rows;
mod run;
mod sketch;
mod summary;
mod table;

pub use error::SweepError;
pub use plan::Plan;
pub use rows::STATUSES;
pub use run::{SweepOptions, run};
