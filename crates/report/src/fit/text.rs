//! Text of a fit for a terminal.

use dataset::Role;
use identify::FlightReport;

use super::{FitPage, coefficients, flights, page, words};
use crate::faults::cautions;
use crate::text::{MAX_ROWS, fitted, wrapped};
use crate::thin::largest_first;
use identify::numbers::significant;

/// Text of a fit: sentences and tables of the page.
pub fn text(of: &FitPage<'_>) -> String {
    let report = of.report;
    let mut text = cautions("fit", &report.cautions, &report.data_faults);
    let mut sentences = words::opening(of);
    sentences.extend(words::summary(of));
    sentences.push(words::noise(report));
    sentences.extend(words::sensors(report));
    let hidden = report.not_identifiable.iter();
    sentences.extend(hidden.map(|found| format!("Not identifiable: {}", found.reason)));
    let alarms = words::alarms(of).into_iter();
    sentences.extend(alarms.map(|alarm| format!("Warning: {alarm}")));
    text.extend(sentences.iter().map(|sentence| wrapped(sentence)));
    for profile in &report.profiles {
        let beyond = || "beyond the profiled range".to_owned();
        let shown = |end: Option<f64>| end.map_or_else(beyond, |end| significant(end, 4));
        let [low, high] = profile.interval.map(shown);
        let name = &profile.name;
        text += &format!("{name}: 95 % profile-likelihood interval {low} … {high}\n");
    }
    let coefficients = coefficients::estimates(&of.coefficients());
    let tables = [coefficients, page::noise_table(report)];
    for table in tables.iter().filter(|table| !table.is_empty()) {
        text += &format!("\n{}", table.text(usize::MAX));
    }
    let seen = super::summaries::table(report);
    if !seen.is_empty() {
        text += &format!("\nSeen → predicted\n{}", seen.text(MAX_ROWS));
    }
    let mut add = |what: &str, mut flights: Vec<&FlightReport>| {
        // Summaries have the table above, and those with a remark are listed here as well.
        flights.retain(|flight| !flight.is_summary || !flight.notes.is_empty());
        if !flights.is_empty() {
            let flights = largest_first(flights, MAX_ROWS, |flight| Some(flight.rms()));
            let table = flights::table(of, &flights);
            text += &format!("\n{}{}", fitted(what), table.text(MAX_ROWS));
        }
    };
    add("fitted", report.used(Role::Fit).collect());
    add(
        "held out: initial state fitted to the first 30 % of the samples; rms of the prediction of the rest",
        report.used(Role::HeldOut).collect(),
    );
    add("excluded", report.excluded().collect());
    text
}
