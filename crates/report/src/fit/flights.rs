//! Tables of the flights on the page of a fit.

use dataset::Role;
use identify::FlightReport;

use super::{FitPage, draw};
use crate::html::Html;
use crate::page::flight_link;
use crate::table::Table;
use crate::thin::{MAX_FLIGHTS, MAX_ROWS, largest_first};
use identify::numbers::plain;
use identify::wording::short;

pub(super) fn section(page: &FitPage<'_>) -> Html {
    let mut content = Html::new();
    content.grid(draw::histogram(page.report).into_iter().collect(), 1, true);
    // Summaries have a table of their own; those with a remark are listed here as well.
    let is_listed = |flight: &&FlightReport| !flight.is_summary || !flight.notes.is_empty();
    let fitted: Vec<_> = page.report.used(Role::Fit).filter(is_listed).collect();
    let held_out: Vec<_> = page.report.used(Role::HeldOut).filter(is_listed).collect();
    let excluded: Vec<_> = page.report.excluded().collect();
    if page.report.flights.is_empty() {
        content.paragraph("None.");
    }
    if page.report.flights.iter().any(|flight| flight.is_summary) {
        content.heading("Seen → predicted");
        content.note("All values are in summaries.csv.");
        content.table(&super::summaries::table(page.report));
    }
    if !fitted.is_empty() {
        content.heading("Fitted");
        worst(&mut content, page, fitted);
    }
    if !held_out.is_empty() {
        content.heading("Held out");
        content.note(
            "These flights were not used to estimate the coefficients. The initial state of each was fitted to the \
             first 30 % of its samples with the coefficients fixed; the rms is the prediction error of the rest.",
        );
        worst(&mut content, page, held_out);
    }
    if !excluded.is_empty() {
        content.heading("Excluded");
        content.table(&table(page, &excluded));
        let all = excluded.len();
        if all > MAX_ROWS {
            content.note(format!(
                "The first {MAX_ROWS} of {all}; all are in flights.csv."
            ));
        }
    }
    content
}

fn worst(content: &mut Html, page: &FitPage<'_>, flights: Vec<&FlightReport>) {
    let all = flights.len();
    let flights = largest_first(flights, MAX_ROWS, |flight| Some(flight.rms()));
    content.table(&table(page, &flights));
    if all > MAX_ROWS {
        content.note(format!(
            "The {MAX_ROWS} with the largest rms, of {all}; all are in flights.csv."
        ));
    }
}

pub(super) fn table(page: &FitPage<'_>, flights: &[&FlightReport]) -> Table {
    let cut = |flight: &FlightReport| {
        let cut = flight.cut.as_ref()?;
        let (t, samples) = (plain(cut.t, 3), cut.samples);
        let reason = short(&cut.reason);
        Some(format!("after {t} s, {samples} samples not used: {reason}"))
    };
    Table::of(flights.iter().take(MAX_ROWS))
        .file("flight", |flight| links(page, &flight.file))
        .number("samples", |flight| flight.samples)
        .number("rms", |flight| flight.is_used().then(|| flight.rms_text()))
        .number("outliers", |flight| flight.outliers)
        .text("cut", |flight| cut(flight).unwrap_or_default())
        .text("notes", |flight| short(&flight.notes.join("; ")))
        .table()
}

/// Links to the flight in three dimensions and to its figures, where they are drawn.
fn links(page: &FitPage<'_>, file: &str) -> Html {
    let mut links = flight_link(file, file);
    let mut drawn = page.evidence.iter().take(MAX_FLIGHTS);
    if let Some(at) = drawn.position(|f| f.file == file) {
        for (name, text) in [("tracks", "paths"), ("states", "states")] {
            links.push(" ");
            links.push(Html::link(&format!("#{name}-{:02}", at + 1), text));
        }
    }
    links
}
