//! Simulates many flights of a model as specified by a plan.

use std::path::Path;

use analysis::sweep::{SweepOptions, plan, run};
use serde_json::Value;

use crate::Error;

/// Simulates the flights of the plan in a file, and writes `flights.parquet` and `summary.json` to the folder `out`: a new
/// or empty one, or that of an earlier call with the same plan, which is continued.
///
/// # Errors
/// [`Error::Release`] if the plan has faults; [`Error::Sweep`] if it cannot be computed or the results cannot be written.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let plan = folder.path().join("plan.toml");
/// let text = "model = \"ball\"\nuntil = \"ground\"\n[throw]\nspeed = 30.0\n[vary]\nlaunch = { values = [20.0, 30.0, 40.0] }";
/// std::fs::write(&plan, text)?;
/// let sweep = hyzer::sweep(&plan, &folder.path().join("swept"), 2)?;
/// assert_eq!(sweep.flights(), 3);
/// assert!(sweep.mean("range").is_some_and(|range| range > 10.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sweep(plan: &Path, out: &Path, threads: usize) -> Result<Sweep, Error> {
    let plan = plan::read_file(plan)?;
    let options = SweepOptions {
        threads,
        share: None,
        csv: false,
        progress: &|_| {},
        is_cancelled: &|| false,
    };
    let summary = run(&plan, out, &options)?.unwrap_or(Value::Null);
    Ok(Sweep { summary })
}

/// Summary statistics of a completed sweep, as in `summary.json`.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    summary: Value,
}

impl Sweep {
    /// Number of flights, including those that did not reach the ground.
    pub fn flights(&self) -> u64 {
        self.summary["flights"].as_u64().unwrap_or(0)
    }

    /// Number of flights with a status, such as `landed` or `time` (reached the final time).
    pub fn count(&self, status: &str) -> u64 {
        self.summary["statuses"][status].as_u64().unwrap_or(0)
    }

    /// Mean of a column of the table of flights over those that reached the intended end; `None` for an unknown column or
    /// without such flights.
    pub fn mean(&self, column: &str) -> Option<f64> {
        self.summary["columns"][column]["mean"].as_f64()
    }

    /// Sample standard deviation of a column, as for [`mean`](Sweep::mean); 0 for a single flight.
    pub fn standard_deviation(&self, column: &str) -> Option<f64> {
        self.summary["columns"][column]["sd"].as_f64()
    }

    /// The summary statistics as JSON, as in the file `summary.json`.
    pub fn summary(&self) -> &Value {
        &self.summary
    }
}
