//! Internal crate of hyzer: what follows from a model that flies. [`design`] searches for throws for a purpose,
//! [`stability`] linearises the motion, and [`sweep`] flies many flights by a plan.

#![forbid(unsafe_code)]

pub mod design;
#[cfg(feature = "sweep")]
mod parquet_table;
pub mod stability;
#[cfg(feature = "sweep")]
pub mod sweep;

#[cfg(feature = "sweep")]
pub use parquet_table::{Cells, parquet_table};

/// Why nothing that uses the estimates of a fit is to be relied on, from its `report.json`; `None` if the fit is reliable.
pub fn doubt_of_fit(report: &serde_json::Value) -> Option<String> {
    (report["reliable"] == false).then(|| {
        let first = report["cautions"][0].as_str().unwrap_or("see its report");
        format!("this fit is not reliable, and its errors may be far larger: {first}")
    })
}
