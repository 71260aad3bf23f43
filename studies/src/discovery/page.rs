//! Renders docs/studies/discovery.md.

use serde::Serialize;

use super::outcome::Outcome;
use super::rates::{
    Count, MAX_FALSE_ALARMS, MAX_HELD_OUT_RATIO, MAX_UNIQUELY_WRONG, MIN_IN_SET, MIN_IN_SET_STRONG,
    Rates, RowRates, STRONG, Times, answers,
};
use super::row::{Group, Row, Size};
use super::run::RowResult;
use crate::error::StudyError;
use crate::page::Page;
use crate::seeded::InputErrors;

/// Maximum number of different results of the diagnosis (verdict and hypotheses) that docs/studies/discovery.md lists for a
/// combination of simulation settings under which the diagnosis fails.
const MAX_ANSWERS: usize = 3;

/// A combination of simulation settings is listed as failing if the diagnosis misses a detectable effect in more than
/// one of every `MISSED_DIVISOR` of its runs.
const MISSED_DIVISOR: usize = 10;

/// Permitted maximum of the median computing time of a diagnosis of 20 disc flights, s.
const MAX_MEDIAN: f64 = 1.0;

/// Permitted maximum of the longest computing time of a diagnosis of 20 disc flights, s.
const MAX_SLOWEST: f64 = 20.0;

#[derive(Serialize)]
struct Results<'r> {
    criteria: Vec<Criterion>,
    max_held_out_ratio: f64,
    rates: &'r Rates,
    times: [TimeLimit; 2],
    failures: Vec<Failure>,
    /// Table rows of the runs with two or three effects added to the simulated flights, or with one effect of severe
    /// size.
    several: Vec<&'r TableRow>,
    confounded: Vec<&'r TableRow>,
    unlisted: Vec<&'r TableRow>,
    unlisted_many_flights: Vec<&'r TableRow>,
    input_errors: Vec<&'r TableRow>,
    rows: &'r [TableRow],
}

/// Table row: a rate found by the study, and the upper or lower bound that it is required to satisfy.
#[derive(Serialize)]
struct Criterion {
    what: String,
    /// Direction of the required bound of the rate: "at most" or "at least".
    relation: &'static str,
    bound: f64,
    rate: Option<f64>,
    count: usize,
    total: usize,
    is_met: bool,
}

impl Criterion {
    fn at_most(what: impl Into<String>, bound: f64, count: &Count) -> Self {
        let is_met = |rate| rate <= bound;
        Self::new(what.into(), "at most", bound, count, &is_met)
    }

    fn at_least(what: impl Into<String>, bound: f64, count: &Count) -> Self {
        let is_met = |rate| rate >= bound;
        Self::new(what.into(), "at least", bound, count, &is_met)
    }

    fn new(
        what: String,
        relation: &'static str,
        bound: f64,
        count: &Count,
        is_met: &dyn Fn(f64) -> bool,
    ) -> Self {
        Self {
            what,
            relation,
            bound,
            rate: count.fraction(),
            count: count.count,
            total: count.total,
            is_met: count.fraction().is_some_and(is_met),
        }
    }
}

/// Runs of one combination of simulation settings in which the diagnosis fails in the same way: it gives a single,
/// wrong hypothesis, or misses a detectable effect. Includes the verdicts and hypotheses in these runs.
#[derive(Serialize)]
struct Failure {
    row: String,
    what: &'static str,
    count: usize,
    runs: usize,
    answers: Vec<(String, usize)>,
}

/// Table row: a computing time of the diagnosis and its required upper bound, s.
#[derive(Serialize)]
struct TimeLimit {
    what: &'static str,
    limit: f64,
    seconds: Option<f64>,
}

/// Table row: one combination of simulation settings, and statistics over its runs (simulated and diagnosed datasets).
#[derive(Serialize)]
struct TableRow {
    group: &'static str,
    seeded: String,
    size: &'static str,
    noise: &'static str,
    runs: usize,
    /// Whether an effect is added to the simulated flights.
    has_effect: bool,
    confounded_with: Option<&'static str>,
    /// Quantity of the model (site) on which the effect outside the built-in effects catalogue acts; empty for a row
    /// without such an effect.
    site: &'static str,
    input_errors: Option<InputErrors>,
    #[serde(flatten)]
    rates: RowRates,
}

impl TableRow {
    fn of(result: &RowResult) -> Self {
        let row = &result.row;
        let site = row.site();
        Self {
            group: row.group.label(),
            seeded: row.seeded(),
            size: row.size.map_or("–", Size::label),
            noise: row.noise.name,
            runs: result.outcomes.len(),
            has_effect: row.group != Group::Null,
            confounded_with: row.confounded_with,
            site,
            input_errors: row.input_errors,
            rates: RowRates::of(&result.outcomes, site),
        }
    }
}

/// Renders docs/studies/discovery.md from the results of all rows of the study's table.
///
/// # Errors
/// [`StudyError::Page`] if the template cannot be rendered with the results.
pub fn discovery_page(results: &[RowResult]) -> Result<Page, StudyError> {
    let rates = Rates::of(results);
    let rows: Vec<TableRow> = results.iter().map(TableRow::of).collect();
    let rows_with = |has: &dyn Fn(&Row) -> bool| -> Vec<&TableRow> {
        let pairs = results.iter().zip(&rows);
        let selected = pairs.filter(|(result, _)| has(&result.row));
        selected.map(|(_, row)| row).collect()
    };
    let in_group = |group: Group| rows_with(&|row| row.group == group);
    let results = Results {
        criteria: criteria(&rates),
        max_held_out_ratio: MAX_HELD_OUT_RATIO,
        times: times(&rates.times),
        rates: &rates,
        failures: failures(results),
        several: rows_with(&|row| {
            matches!(row.group, Group::Several | Group::Pair) || row.size == Some(Size::Severe)
        }),
        confounded: in_group(Group::Confounded),
        unlisted: in_group(Group::Unlisted),
        unlisted_many_flights: in_group(Group::UnlistedManyFlights),
        input_errors: rows_with(&|row| row.input_errors.is_some()),
        rows: &rows,
    };
    Page::without_figures(include_str!("page.md"), results)
}

fn times(times: &Times) -> [TimeLimit; 2] {
    [
        TimeLimit {
            what: "median time of a diagnosis of 20 flights",
            limit: MAX_MEDIAN,
            seconds: times.median,
        },
        TimeLimit {
            what: "slowest diagnosis of 20 flights",
            limit: MAX_SLOWEST,
            seconds: times.slowest,
        },
    ]
}

fn criteria(rates: &Rates) -> Vec<Criterion> {
    let mut criteria = vec![
        Criterion::at_most(
            "one single hypothesis, wrong",
            MAX_UNIQUELY_WRONG,
            &rates.uniquely_wrong,
        ),
        Criterion::at_least(
            "truth in the set, detectable effects",
            MIN_IN_SET,
            &rates.in_set,
        ),
        Criterion::at_least(
            format!("truth in the set, {STRONG} times detectable or more"),
            MIN_IN_SET_STRONG,
            &rates.in_set_strong,
        ),
    ];
    let several = rates.in_set_several.iter();
    criteria.extend(several.map(|(number, least, count)| {
        let what = format!("truth in the set, {number} detectable effects at once");
        Criterion::at_least(what, *least, count)
    }));
    let false_alarms = rates.false_alarms.iter();
    criteria.extend(false_alarms.map(|(noise, count)| {
        Criterion::at_most(format!("false alarms, {noise}"), MAX_FALSE_ALARMS, count)
    }));
    criteria
}

/// Failures of the diagnosis under all simulation settings: runs in which it gives a single, wrong hypothesis, and
/// settings under which it misses a detectable effect in more than one run of ten.
fn failures(results: &[RowResult]) -> Vec<Failure> {
    let wrong = results.iter().filter_map(|result| {
        let failure = failure(result, "one single hypothesis, wrong,", |o| {
            o.uniquely_wrong
        });
        (failure.count > 0).then_some(failure)
    });
    let missed = results.iter().filter_map(|result| {
        let failure = failure(result, "detectable truth not in the set", |o| {
            !o.uniquely_wrong && !o.in_set && o.is_detectable(1.0)
        });
        (failure.count > result.outcomes.len() / MISSED_DIVISOR).then_some(failure)
    });
    wrong.chain(missed).collect()
}

fn failure(result: &RowResult, what: &'static str, has: impl Fn(&Outcome) -> bool) -> Failure {
    let row = &result.row;
    let size = row
        .size
        .map_or(String::new(), |size| format!(", {}", size.label()));
    let mut answers = answers(&result.outcomes, has);
    let count = answers.iter().map(|(_, count)| count).sum();
    answers.truncate(MAX_ANSWERS);
    Failure {
        row: format!(
            "`{}`{size}, {} ({})",
            row.seeded(),
            row.noise.name,
            row.group.label()
        ),
        what,
        count,
        runs: result.outcomes.len(),
        answers,
    }
}
