//! Renders docs/studies/others.md.

use serde::Serialize;

use super::flight::DURATION;
use super::study::{RateInFlight, Stage, Verdicts};
use crate::error::StudyError;
use crate::page::Page;

#[derive(Serialize)]
struct Results<'r> {
    duration: f64,
    simulators: Vec<SimulatorRows<'r>>,
}

#[derive(Serialize)]
struct SimulatorRows<'r> {
    title: &'static str,
    model: &'static str,
    throw: &'static str,
    note: &'static str,
    laws: Vec<LawRow>,
    rates: &'r [RateInFlight],
    stages: Vec<StageRow>,
    published: [f64; 3],
    mended: [f64; 3],
    apart: f64,
    holds: bool,
}

#[derive(Serialize)]
struct LawRow {
    formula: &'static str,
    cause: f64,
    difference: f64,
    is_kept: bool,
}

#[derive(Serialize)]
struct StageRow {
    change: &'static str,
    moved: String,
    broken: String,
    end: [f64; 3],
    /// Distance, m, between the ends of two simulated flights: one with the equations of this table row (as published
    /// or after corrections), and one with the published equations.
    apart: f64,
}

/// Maximum difference between the two sides of a balance law, relative to their magnitude, that is attributed to
/// rounding.
const ROUNDING: f64 = 1e-9;

/// Renders docs/studies/others.md from the verification results of all published simulators.
///
/// # Errors
/// [`StudyError::Page`] if the template cannot be rendered with the results.
pub fn others_page(all: &[Verdicts]) -> Result<Page, StudyError> {
    let results = Results {
        duration: DURATION,
        simulators: all.iter().map(rows).collect(),
    };
    Page::without_figures(include_str!("page.md"), &results)
}

fn rows(verdicts: &Verdicts) -> SimulatorRows<'_> {
    let first = verdicts
        .stages
        .first()
        .map_or_else(Default::default, |s| s.end);
    let last = verdicts.stages.last();
    let mended = last.map_or_else(Default::default, |s| s.end);
    SimulatorRows {
        title: verdicts.simulator.title,
        model: verdicts.simulator.model,
        throw: verdicts.simulator.throw,
        note: verdicts.simulator.note,
        laws: { verdicts.laws.iter() }
            .map(|law| LawRow {
                formula: law.law.formula(),
                cause: law.cause,
                difference: law.difference,
                is_kept: law.difference <= ROUNDING * law.cause,
            })
            .collect(),
        rates: &verdicts.rates,
        stages: { verdicts.stages.iter() }
            .map(|stage| StageRow {
                change: stage.change.unwrap_or("as published"),
                moved: moved(stage),
                broken: broken(stage),
                end: stage.end.into(),
                apart: (stage.end - first).norm(),
            })
            .collect(),
        published: first.into(),
        mended: mended.into(),
        apart: (mended - first).norm(),
        holds: last.is_some_and(|s| s.holds && s.broken.is_empty()),
    }
}

fn moved(stage: &Stage) -> String {
    let rows = stage.moved.iter();
    let rows = rows.map(|(state, _, by)| format!("`der({state})` by {}", short(*by)));
    let rows: Vec<String> = rows.collect();
    if rows.is_empty() {
        return String::from("–");
    }
    rows.join(", ")
}

fn broken(stage: &Stage) -> String {
    let laws = stage
        .broken
        .iter()
        .filter_map(|l| l.split_once(": off by "));
    let laws: Vec<String> = laws.map(|(law, _)| format!("`{law}`")).collect();
    if laws.is_empty() {
        return String::from("none");
    }
    laws.join(", ")
}

/// Formats a number as text with two significant digits.
fn short(value: f64) -> String {
    if (0.01..1e4).contains(&value) {
        let digits = (1 - value.log10().floor() as i32).max(0) as usize;
        return format!("{value:.digits$}");
    }
    format!("{value:.1e}")
}
