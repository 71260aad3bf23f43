//! Internal crate of hyzer: what follows from a model that flies. [`design`] searches for throws for a purpose,
//! [`stability`] linearises the motion, and [`sweep`] flies many flights by a plan.

#![forbid(unsafe_code)]

pub mod design;
mod estimates;
#[cfg(feature = "sweep")]
mod parquet_table;
pub mod stability;
#[cfg(feature = "sweep")]
pub mod sweep;

pub use estimates::{Estimated, Estimates};
#[cfg(feature = "sweep")]
pub use parquet_table::{Cells, parquet_table};
