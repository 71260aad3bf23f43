//! How often a diagnosis finds what was hidden.
//!
//! The oracle makes flights with something hidden in them ([`crate::seeded`]); the diagnosis is given the flights and
//! the model without it. Neither the flights nor the right answer pass through anything that is tested.

pub mod case;
pub mod page;
pub mod peers;
pub mod plan;
pub mod rates;
pub mod run;

use flight::batch;

use case::Case;
use plan::Row;
use run::{Outcome, Truths};

/// A row of the plan with what came of its runs.
#[derive(Clone, Debug)]
pub struct Tried {
    /// The row.
    pub row: Row,
    /// Its runs, in the order of their numbers.
    pub outcomes: Vec<Outcome>,
}

/// Tries every run of every row, side by side; `watch` hears how many of how many are done.
pub fn discovery(rows: &[Row], watch: &(dyn Fn(usize, usize) + Sync)) -> Vec<Tried> {
    let truths = Truths::default();
    let runs = rows.iter().enumerate();
    let runs: Vec<(usize, usize)> = runs
        .flat_map(|(row, of)| (0..of.runs).map(move |run| (row, run)))
        .collect();
    let done = std::sync::atomic::AtomicUsize::new(0);
    let mut outcomes = batch::each(runs.len(), |at| {
        let (row, run) = runs[at];
        let outcome = run::run(&Case::of(&rows[row], run), &truths);
        let done = 1 + done.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        watch(done, runs.len());
        outcome
    })
    .into_iter();
    let tried = rows.iter().map(|row| Tried {
        row: row.clone(),
        outcomes: outcomes.by_ref().take(row.runs).collect(),
    });
    tried.collect()
}

/// For every run that missed what can be seen, though it raised an alarm: what rejects the truth once it is switched on.
pub fn rejections(tried: &[Tried]) -> Vec<Vec<Option<String>>> {
    let truths = Truths::default();
    let all: Vec<&Outcome> = tried.iter().flat_map(|tried| &tried.outcomes).collect();
    let mut told = batch::each(all.len(), |at| {
        let outcome = all[at];
        let missed = outcome.alarmed() && !outcome.in_set && outcome.has(1.0);
        missed.then(|| run::rejected_by(&outcome.case, &truths))?
    })
    .into_iter();
    let rows = tried.iter().map(|tried| {
        let own = told.by_ref().take(tried.outcomes.len());
        own.collect()
    });
    rows.collect()
}
