//! Many flights of one model: [`plan`] specifies the quantities that vary; [`run`] integrates the flights in SIMD
//! lanes on several threads and writes a Parquet table with a row per flight, and a summary.
//!
//! Each flight depends on the plan and its own number alone, so the results have the same bits for any number of
//! threads and any division of the work. Flights are grouped in parts, each written to a file as a whole; a run
//! continues where an earlier, interrupted run ended.

pub mod folder;
mod inputs;
pub mod plan;
mod rows;
mod run;
mod sketch;
mod summary;
mod table;

pub use plan::Plan;
pub use rows::STATUSES;
pub use run::{SweepError, SweepOptions, landings, run};
