//! The tables of flights: those fitted, the worst first where there are many, those held out, and those left out.

use identify::FlightReport;
use identify::dataset::Role;
use serde::Serialize;

use super::FitPage;
use super::numbers::{millimetres, plain};

/// Rows of a table, at most.
const MOST_ROWS: usize = 50;
/// Letters of a note, at most.
const MOST_LETTERS: usize = 300;

/// One table.
#[derive(Serialize)]
pub(super) struct Table {
    /// Flights there are.
    all: usize,
    /// Whether the worst alone are shown.
    worst: bool,
    rows: Vec<Row>,
}

#[derive(Serialize)]
struct Row {
    file: String,
    samples: usize,
    rms: String,
    outliers: usize,
    cut: String,
    notes: String,
}

/// The flights of one role: in their own order, or, where they are many, the worst in order of their rms.
pub(super) fn table(page: &FitPage<'_>, role: Role) -> Table {
    let mut flights: Vec<&FlightReport> = page.report.used(role).collect();
    let number = flights.len();
    let worst = number > MOST_ROWS;
    if worst {
        // A flight without a number is the worst of all.
        let size = |f: &FlightReport| {
            if f.rms().is_nan() {
                f64::INFINITY
            } else {
                f.rms()
            }
        };
        flights.sort_by(|a, b| size(b).total_cmp(&size(a)));
        flights.truncate(MOST_ROWS);
    }
    Table {
        all: number,
        worst,
        rows: flights.into_iter().map(row).collect(),
    }
}

/// The first of the flights that were left out.
pub(super) fn left_out(page: &FitPage<'_>) -> Table {
    Table {
        all: page.report.excluded().count(),
        worst: false,
        rows: page.report.excluded().take(MOST_ROWS).map(row).collect(),
    }
}

fn row(flight: &FlightReport) -> Row {
    let cut = flight.cut.as_ref().map(|cut| {
        let (t, samples) = (plain(cut.t, 3), cut.samples);
        format!(
            "after {t} s, {samples} samples not used: {}",
            short(&cut.why)
        )
    });
    Row {
        file: flight.file.clone(),
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

/// The beginning of a text.
pub(crate) fn short(text: &str) -> String {
    if text.chars().count() <= MOST_LETTERS {
        return text.to_owned();
    }
    text.chars().take(MOST_LETTERS).chain(['…']).collect()
}
