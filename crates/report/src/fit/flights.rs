//! Tables of the flights on the fit page: fitted flights, held-out flights, and excluded flights.

use dataset::Role;
use identify::FlightReport;
use model_spec::sort_by_number;
use serde::Serialize;

use super::FitPage;
use crate::numbers::{millimetres, plain};

/// Maximum number of flights that a table of the report lists.
const MAX_ROWS: usize = 50;
/// Maximum number of characters of a note on a flight; longer notes are truncated.
const MAX_LETTERS: usize = 300;

/// Table of the flights of a fit, as input of the HTML template.
#[derive(Serialize)]
pub(super) struct Table {
    /// Total number of flights, including those that the table does not list.
    all: usize,
    /// Whether only the flights with the largest RMS residuals are listed, in descending order.
    worst: bool,
    rows: Vec<Row>,
}

#[derive(Serialize)]
struct Row {
    file: String,
    /// Links to the figures of the flight on the same page: pairs of anchor name and link text.
    figures: Vec<(String, &'static str)>,
    samples: usize,
    rms: String,
    outliers: usize,
    cut: String,
    notes: String,
}

/// Table of the flights with one role (fitted or held out), in dataset order. If there are more than [`MAX_ROWS`], only
/// the flights with the largest RMS residuals, in descending order.
pub(super) fn table(page: &FitPage<'_>, role: Role) -> Table {
    let mut flights: Vec<&FlightReport> = page.report.used(role).collect();
    let number = flights.len();
    let worst = number > MAX_ROWS;
    if worst {
        // A flight without a finite RMS residual ranks as the worst.
        let size = |f: &FlightReport| {
            if f.rms().is_nan() {
                f64::INFINITY
            } else {
                f.rms()
            }
        };
        sort_by_number(&mut flights, |flight| -size(flight));
        flights.truncate(MAX_ROWS);
    }
    Table {
        all: number,
        worst,
        rows: flights.into_iter().map(|f| row(page, f)).collect(),
    }
}

/// Table of the flights that were excluded from the fit, limited to [`MAX_ROWS`] rows.
pub(super) fn left_out(page: &FitPage<'_>) -> Table {
    Table {
        all: page.report.excluded().count(),
        worst: false,
        rows: page
            .report
            .excluded()
            .take(MAX_ROWS)
            .map(|f| row(page, f))
            .collect(),
    }
}

/// Links to the figures of a flight on the same page: pairs of anchor name and link text; empty if the flight is not
/// drawn.
fn figures(page: &FitPage<'_>, file: &str) -> Vec<(String, &'static str)> {
    let drawn = || page.evidence.iter().take(super::draw::MAX_FLIGHTS);
    let mut figures = Vec::new();
    if let Some(at) = drawn().position(|f| f.file == file) {
        figures.push((format!("tracks-{:02}", at + 1), "paths"));
        figures.push((format!("states-{:02}", at + 1), "states"));
    }
    figures
}

fn row(page: &FitPage<'_>, flight: &FlightReport) -> Row {
    let cut = flight.cut.as_ref().map(|cut| {
        let (t, samples) = (plain(cut.t, 3), cut.samples);
        format!(
            "after {t} s, {samples} samples not used: {}",
            short(&cut.reason)
        )
    });
    Row {
        file: flight.file.clone(),
        figures: figures(page, &flight.file),
        samples: flight.samples,
        rms: if flight.is_used() {
            millimetres(flight.rms())
        } else {
            "–".to_owned()
        },
        outliers: flight.outliers,
        cut: cut.unwrap_or_default(),
        notes: short(&flight.notes.join("; ")),
    }
}

/// Truncates a text to [`MAX_LETTERS`] characters, for a note in a table.
pub(crate) fn short(text: &str) -> String {
    if text.chars().count() <= MAX_LETTERS {
        return text.to_owned();
    }
    text.chars().take(MAX_LETTERS).chain(['…']).collect()
}
