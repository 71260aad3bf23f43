//! The folder of a sweep: what was begun, the parts that are whole, and the results.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::atomic::{Durability, UNFINISHED, write_atomic};
use crate::error::SweepError;
use crate::plan::Plan;

/// File that says which plan the parts belong to.
const BEGUN: &str = "sweep.json";

/// Folder of the results of one plan.
pub(crate) struct Folder {
    path: PathBuf,
    fingerprint: String,
}

impl Folder {
    /// Opens a new or empty folder, or that of the same plan.
    pub(crate) fn open(path: &Path, plan: &Plan) -> Result<Folder, SweepError> {
        let at = |source| SweepError::Io {
            path: path.to_path_buf(),
            source,
        };
        fs::create_dir_all(path).map_err(at)?;
        let folder = Folder {
            path: path.to_path_buf(),
            fingerprint: plan.fingerprint(),
        };
        let begun = path.join(BEGUN);
        match fs::read_to_string(&begun) {
            Ok(text) => {
                let json: Value = serde_json::from_str(&text).unwrap_or(Value::Null);
                if json["fingerprint"].as_str() != Some(&folder.fingerprint) {
                    return Err(SweepError::OtherPlan {
                        path: path.to_path_buf(),
                    });
                }
            }
            Err(e) if e.kind() == io::ErrorKind::NotFound => {
                let mut entries = fs::read_dir(path).map_err(at)?;
                let is_foreign = |entry: io::Result<fs::DirEntry>| {
                    entry.is_ok_and(|e| !e.file_name().to_string_lossy().starts_with(UNFINISHED))
                };
                // Another process may begin the same sweep at the same time.
                if entries.any(is_foreign) && !begun.is_file() {
                    return Err(SweepError::Foreign {
                        path: path.to_path_buf(),
                    });
                }
                let json = json!({
                    "schema": "hyzer.sweep-parts/1",
                    "fingerprint": folder.fingerprint,
                    "flights": plan.flights,
                    "parts": plan.parts(),
                    "flights_per_part": plan.part_len(),
                });
                folder.write_json(&begun, &json)?;
            }
            Err(e) => return Err(at(e)),
        }
        fs::create_dir_all(path.join("parts")).map_err(at)?;
        Ok(folder)
    }

    /// File of a part.
    pub(crate) fn part(&self, part: u64) -> PathBuf {
        self.path.join("parts").join(format!("{part:06}.parquet"))
    }

    /// Table of all flights.
    pub(crate) fn flights(&self) -> PathBuf {
        self.path.join("flights.parquet")
    }

    /// The same as CSV.
    pub(crate) fn csv(&self) -> PathBuf {
        self.path.join("flights.csv")
    }

    /// The summary, if the sweep is complete.
    pub(crate) fn summary(&self) -> Option<Value> {
        let text = fs::read_to_string(self.path.join("summary.json")).ok()?;
        let json: Value = serde_json::from_str(&text).ok()?;
        let is_own = json["fingerprint"].as_str() == Some(&self.fingerprint);
        (is_own && self.flights().is_file()).then_some(json)
    }

    /// Writes the summary: the sweep is complete then.
    pub(crate) fn write_summary(&self, json: &Value) -> Result<(), SweepError> {
        self.write_json(&self.path.join("summary.json"), json)
    }

    fn write_json(&self, path: &Path, json: &Value) -> Result<(), SweepError> {
        let write = |file: &mut fs::File| writeln!(file, "{json:#}");
        write_atomic(path, Durability::Synced, write).map_err(|source| SweepError::Io {
            path: path.to_path_buf(),
            source,
        })
    }

    /// Removes the parts, which the results replace, and what a kill left unfinished.
    pub(crate) fn discard_parts(&self) {
        // What remains is removed by the next run.
        let _ = fs::remove_dir_all(self.path.join("parts"));
        for entry in fs::read_dir(&self.path).into_iter().flatten().flatten() {
            if entry.file_name().to_string_lossy().starts_with(UNFINISHED) {
                let _ = fs::remove_file(entry.path());
            }
        }
    }
}
