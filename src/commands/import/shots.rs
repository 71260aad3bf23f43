//! The export of a launch monitor as a dataset of summaries.

use std::fmt::Write;

use anyhow::bail;
use dataset::{ShotOptions, read_shots};

use super::{DECISIONS, Imported};
use crate::cli::Import;

/// Reads a launch monitor's table.
///
/// # Errors
/// If an option or the table is faulty.
pub(super) fn imported(options: &Import) -> anyhow::Result<Imported> {
    let [file] = options.takes.as_slice() else {
        bail!(
            "--launch-monitor: found {} files, expected one table of shots",
            options.takes.len()
        );
    };
    let columns = options.column.iter().map(|text| column(text));
    let columns = columns.collect::<anyhow::Result<_>>()?;
    let model = options.model.clone();
    let made = read_shots(file, &ShotOptions { model, columns })?;
    let mut decisions = format!("{}\n", file.display());
    for line in &made.decisions {
        let _ = writeln!(decisions, "  {line}");
    }
    Ok(Imported {
        dataset: made.dataset,
        beside: vec![(DECISIONS.to_owned(), decisions.clone())],
        comments: Vec::new(),
        decisions,
        recordings: Vec::new(),
    })
}

/// Reads HEADER=IS or HEADER=IS,UNIT.
fn column(text: &str) -> anyhow::Result<(String, String, Option<String>)> {
    let Some((header, is)) = text.rsplit_once('=') else {
        bail!("--column: found {text:?}, expected HEADER=IS,UNIT, as in \"Carry=carry,yd\"");
    };
    let (is, unit) = match is.split_once(',') {
        Some((is, unit)) => (is, Some(unit.trim().to_owned())),
        None => (is, None),
    };
    Ok((header.trim().to_owned(), is.trim().to_owned(), unit))
}
