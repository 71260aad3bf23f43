//! Computes the refits in parts, each written atomically as CSV; existing parts are read instead.

use std::fs;
use std::path::Path;

use analysis::sweep::folder::PartsFolder;
use anyhow::Result;
use identify::{Fit, FitError, FitOptions};
use report::CsvTable;

/// Number of consecutive refits whose results are stored in one file.
pub(super) const LEN: u64 = 16;

/// One refit: its number and the estimates of the parameters that all flights
/// share, SI; the estimates are `None` if the refit did not converge.
pub type Refit = (u64, Option<Vec<f64>>);

/// Number of parts of a bootstrap, of [`LEN`] refits each (the last may have fewer), into which `refits` refits are
/// divided.
pub(super) fn count(refits: u64) -> u64 {
    refits.div_ceil(LEN)
}

/// Data shared by all parts of a bootstrap: the fit, the folder, and the options of the refits.
pub(super) struct Work<'a> {
    pub fit: &'a Fit,
    pub folder: &'a PartsFolder,
    pub refits: u64,
    pub seed: u64,
    pub options: &'a FitOptions<'a>,
}

impl Work<'_> {
    /// Returns the refits of part number `part`, counted from 0, read from its file or else computed and written.
    /// `progress` is called with the number of refits finished since its last call.
    pub(super) fn part(&self, part: u64, progress: &(dyn Fn(u64) + Sync)) -> Result<Vec<Refit>> {
        let numbers = part * LEN..((part + 1) * LEN).min(self.refits);
        let len = (numbers.end - numbers.start) as usize;
        let path = self.folder.part(part, "csv");
        let width = self.fit.problem().globals.len();
        // A part that cannot be read is computed again.
        if let Some(refits) = read(&path, width)
            && refits.iter().map(|refit| refit.0).eq(numbers.clone())
        {
            progress(len as u64);
            return Ok(refits);
        }
        let refits = refits(self.fit, self.seed, numbers, self.options, progress)?;
        self.folder.write(&path, &table(self.fit, &refits))?;
        Ok(refits)
    }
}

/// Refits with the given numbers. `progress` is called with the number of refits finished since its last call.
///
/// # Errors
/// If a refit fails for another reason than that it does not converge.
pub fn refits(
    fit: &Fit,
    seed: u64,
    numbers: std::ops::Range<u64>,
    options: &FitOptions<'_>,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Vec<Refit>, FitError> {
    // One thread per refit: refits in parallel are faster than the flights of one refit in parallel.
    let alone = FitOptions {
        threads: Some(1),
        ..*options
    };
    let len = (numbers.end - numbers.start) as usize;
    let done = flight::parallel::each_on(options.threads(), len, |i| {
        let number = numbers.start + i as u64;
        let estimates = fit.bootstrap(seed, number, &alone)?;
        progress(1);
        let estimates = estimates.map(|estimates| estimates.iter().copied().collect());
        Ok((number, estimates))
    });
    done.into_iter().collect()
}

/// CSV table of refits of a bootstrap: number, whether it converged, and the estimates, SI, with all digits.
pub fn table(fit: &Fit, refits: &[Refit]) -> String {
    let mut table = CsvTable::of(refits)
        .column("refit", |(number, _)| number.to_string())
        .column("converged", |(_, estimates)| estimates.is_some());
    for (i, global) in fit.problem().globals.iter().enumerate() {
        table = table.column(&global.name, |(_, estimates)| {
            estimates.as_ref().map(|all| format!("{:?}", all[i]))
        });
    }
    table.text()
}

/// Reads the refits of a bootstrap from a CSV table with `width` estimates per line; `None` if the file is missing or
/// does not have this format.
fn read(path: &Path, width: usize) -> Option<Vec<Refit>> {
    let text = fs::read_to_string(path).ok()?;
    let row = |line: &str| {
        let mut cells = line.split(',');
        let number = cells.next()?.parse().ok()?;
        if cells.next()? == "false" {
            return Some((number, None));
        }
        let estimates: Option<Vec<f64>> = cells.map(|cell| cell.parse().ok()).collect();
        let estimates = estimates.filter(|all| all.len() == width)?;
        Some((number, Some(estimates)))
    };
    text.lines().skip(1).map(row).collect()
}
