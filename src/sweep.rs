//! Many flights of a model by a plan.

use std::path::Path;

use ::sweep::{SweepOptions, plan, run};
use serde_json::Value;

use crate::Error;

/// Flies the plan in a file over a number of threads and writes `flights.parquet` and `summary.json` to a folder: a new or
/// an empty one, or that of an earlier call with the same plan, which is gone on with.
///
/// # Errors
/// [`Error::Release`] for a plan with faults, [`Error::Sweep`].
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
    };
    let summary = run(&plan, out, &options)?.unwrap_or(Value::Null);
    Ok(Sweep { summary })
}

/// Summary of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    summary: Value,
}

impl Sweep {
    /// Number of flights, those without a landing included.
    pub fn flights(&self) -> u64 {
        self.summary["flights"].as_u64().unwrap_or(0)
    }

    /// Number of flights that ended in this way: `landed`, `time`, `limit`, … .
    pub fn count(&self, status: &str) -> u64 {
        self.summary["statuses"][status].as_u64().unwrap_or(0)
    }

    /// Mean of a column over the flights that came to their end; `None` for an unknown column or without such flights.
    pub fn mean(&self, column: &str) -> Option<f64> {
        self.summary["columns"][column]["mean"].as_f64()
    }

    /// Standard deviation of a column over the flights that came to their end.
    pub fn standard_deviation(&self, column: &str) -> Option<f64> {
        self.summary["columns"][column]["sd"].as_f64()
    }

    /// All of `summary.json`.
    pub fn summary(&self) -> &Value {
        &self.summary
    }
}
