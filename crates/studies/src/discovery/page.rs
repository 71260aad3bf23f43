//! Renders docs/discovery.md.

use diagnose::Verdict;
use serde::Serialize;

use super::outcome::Outcome;
use super::rates::{
    Count, MAX_FALSE_ALARMS, MAX_HELD_OUT_RATIO, MAX_UNIQUELY_WRONG, MIN_IN_SET, MIN_IN_SET_STRONG,
    Rates, RowRates, STRONG, Times, answers,
};
use super::row::{Group, Size};
use super::run::RowResult;
use crate::error::StudyError;
use crate::page::{Page, render};
use crate::seeded::unlisted;

/// Maximum number of different answers of the diagnosis that the page lists for a failing row of the table.
const MAX_ANSWERS: usize = 3;

/// Divisor of the number of runs of a row: the row is listed as failing if the diagnosis misses a detectable effect in
/// more than one run of this number.
const MISSED_DIVISOR: usize = 10;

/// Permitted maximum of the median computing time of a diagnosis of 20 disc flights, s.
const MAX_MEDIAN: f64 = 1.0;

/// Permitted maximum of the longest computing time of a diagnosis of 20 disc flights, s.
const MAX_SLOWEST: f64 = 20.0;

#[derive(Serialize)]
struct Results {
    criteria: Vec<Criterion>,
    max_held_out_ratio: f64,
    held_out_pooled: Option<f64>,
    held_out: (usize, usize),
    held_out_median: Option<f64>,
    /// Number of threads on which each diagnosis ran.
    threads: usize,
    times: Vec<TimeLimit>,
    failed: (usize, usize),
    failures: Vec<Failure>,
    several: Vec<SeveralRow>,
    confounded: Vec<ConfoundedRow>,
    unlisted: Vec<UnlistedRow>,
    unlisted_many_flights: Vec<UnlistedRow>,
    input_errors: Vec<InputErrorRow>,
    rows: Vec<TableRow>,
}

/// A measured rate, and the bound that it has to satisfy.
#[derive(Serialize)]
struct Criterion {
    what: String,
    /// Direction of the bound: "at most" or "at least".
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

/// Runs of one row of the table that fail in the same way, and the answers that the diagnosis gave in these runs.
#[derive(Serialize)]
struct Failure {
    row: String,
    what: &'static str,
    count: usize,
    runs: usize,
    answers: Vec<(String, usize)>,
}

/// A computing time and its upper bound, s.
#[derive(Serialize)]
struct TimeLimit {
    what: &'static str,
    limit: f64,
    seconds: Option<f64>,
}

/// Results of a row of the study's table with two or three effects added to the simulated flights, or with one effect
/// of severe size.
#[derive(Serialize)]
struct SeveralRow {
    seeded: String,
    size: &'static str,
    runs: usize,
    detectability: Option<f64>,
    in_set: usize,
    mean_set_size: Option<f64>,
    uniquely_wrong: usize,
    failed: usize,
    /// Maximum over the row's runs of the number of wrong terms: effects of the first hypothesis that were not added to
    /// the simulated flights, plus selected library terms.
    terms_too_many: usize,
    seconds: Option<f64>,
    slowest: f64,
    answer: String,
}

#[derive(Serialize)]
struct ConfoundedRow {
    seeded: String,
    confounded_with: &'static str,
    runs: usize,
    not_identifiable: usize,
    in_a_set: usize,
    alone: usize,
    uniquely_wrong: usize,
}

#[derive(Serialize)]
struct UnlistedRow {
    name: &'static str,
    size: &'static str,
    site: &'static str,
    runs: usize,
    detected: usize,
    in_set: usize,
    /// Number of runs in which the diagnosis selected a library term that acts on the same quantity of the model (site)
    /// as the effect added to the simulated flights.
    at_its_site: usize,
    sites: String,
    uniquely_wrong: usize,
    held_out_change: Option<f64>,
    answer: String,
}

#[derive(Serialize)]
struct InputErrorRow {
    relative_error: f64,
    exchanged: f64,
    runs: usize,
    alone: usize,
    in_a_set: usize,
    outside: usize,
    uniquely_wrong: usize,
    discordant: usize,
    discordant_exchanged: usize,
    held_out_change: Option<f64>,
}

#[derive(Serialize)]
struct TableRow {
    group: &'static str,
    seeded: String,
    size: &'static str,
    noise: &'static str,
    runs: usize,
    detectability: Option<f64>,
    detected: usize,
    /// Number of runs in which the effects added to the simulated flights are among the hypotheses of the diagnosis;
    /// `None` for a row without such effects.
    in_set: Option<usize>,
    mean_set_size: Option<f64>,
    uniquely_wrong: usize,
    held_out_ratio: Option<f64>,
    seconds: Option<f64>,
}

/// Renders docs/discovery.md from the results of all rows of the study's table.
///
/// # Errors
/// [`StudyError::Page`] if the template cannot be rendered with the results.
pub fn discovery_page(results: &[RowResult]) -> Result<Page, StudyError> {
    let rates = Rates::of(results);
    let of = |group: Group| results.iter().filter(move |r| r.row.group == group);
    let results = Results {
        criteria: criteria(&rates),
        max_held_out_ratio: MAX_HELD_OUT_RATIO,
        held_out_pooled: rates.held_out_pooled,
        held_out: (rates.held_out.count, rates.held_out.total),
        held_out_median: rates.held_out_median,
        threads: rates.times.threads,
        times: times(&rates.times),
        failed: (rates.failed.count, rates.failed.total),
        failures: failures(results),
        several: several_rows(results),
        confounded: of(Group::Confounded).map(confounded_row).collect(),
        unlisted: of(Group::Unlisted).map(unlisted_row).collect(),
        unlisted_many_flights: of(Group::UnlistedManyFlights).map(unlisted_row).collect(),
        input_errors: results.iter().filter_map(input_error_row).collect(),
        rows: results.iter().map(table_row).collect(),
    };
    Ok(Page {
        text: render(include_str!("page.md"), results)?,
        figures: Vec::new(),
    })
}

fn times(times: &Times) -> Vec<TimeLimit> {
    let limits = [
        (
            "median time of a diagnosis of 20 flights",
            times.median,
            MAX_MEDIAN,
        ),
        (
            "slowest diagnosis of 20 flights",
            times.slowest,
            MAX_SLOWEST,
        ),
    ];
    let each = limits.into_iter();
    each.map(|(what, seconds, limit)| TimeLimit {
        what,
        limit,
        seconds,
    })
    .collect()
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

/// Failures in all rows of the study's table: runs whose answer is a single wrong hypothesis, and rows in which the
/// diagnosis misses a detectable effect in more than one run of ten.
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

fn count(result: &RowResult, has: impl Fn(&Outcome) -> bool) -> usize {
    result.outcomes.iter().filter(|o| has(o)).count()
}

fn several_rows(results: &[RowResult]) -> Vec<SeveralRow> {
    let rows = results.iter().filter(|result| {
        let row = &result.row;
        matches!(row.group, Group::Several | Group::Pair) || row.size == Some(Size::Severe)
    });
    let rows = rows.map(|result| {
        let (row, outcomes) = (&result.row, &result.outcomes);
        let rates = RowRates::of(outcomes);
        let extra = outcomes.iter().map(Outcome::terms_too_many);
        let answers = answers(outcomes, |_| true);
        SeveralRow {
            seeded: row.seeded(),
            size: row.size.map_or("–", Size::label),
            runs: outcomes.len(),
            detectability: rates.detectability,
            in_set: rates.in_set,
            mean_set_size: rates.mean_set_size,
            uniquely_wrong: rates.uniquely_wrong,
            failed: count(result, |o| o.failure.is_some()),
            terms_too_many: extra.max().unwrap_or(0),
            seconds: rates.seconds,
            slowest: outcomes.iter().map(|o| o.seconds).fold(0.0, f64::max),
            answer: answers.into_iter().next().map_or(String::new(), |(a, _)| a),
        }
    });
    rows.collect()
}

fn confounded_row(result: &RowResult) -> ConfoundedRow {
    ConfoundedRow {
        seeded: result.row.seeded(),
        confounded_with: result.row.confounded_with.unwrap_or(""),
        runs: result.outcomes.len(),
        not_identifiable: count(result, |o| o.not_identifiable && !o.is_detected()),
        in_a_set: count(result, |o| o.hypotheses.len() > 1 && o.in_set),
        alone: count(result, |o| o.hypotheses.len() == 1 && o.in_set),
        uniquely_wrong: count(result, |o| o.uniquely_wrong),
    }
}

fn unlisted_row(result: &RowResult) -> UnlistedRow {
    let name = result.row.unlisted.unwrap_or("");
    let site = unlisted(name).map_or("", |effect| effect.site);
    let rates = RowRates::of(&result.outcomes);
    let sites = result.outcomes.iter().flat_map(|o| &o.sites);
    let mut sites: Vec<&str> = sites.map(String::as_str).collect();
    sites.sort_unstable();
    sites.dedup();
    let answers = answers(&result.outcomes, |_| true);
    UnlistedRow {
        name,
        size: result.row.size.map_or("", Size::label),
        site,
        runs: result.outcomes.len(),
        detected: rates.detected,
        in_set: rates.in_set,
        at_its_site: count(result, |o| o.sites.iter().any(|s| s == site)),
        sites: sites.join(", "),
        uniquely_wrong: rates.uniquely_wrong,
        held_out_change: rates.held_out_change,
        answer: answers.into_iter().next().map_or(String::new(), |(a, _)| a),
    }
}

fn input_error_row(result: &RowResult) -> Option<InputErrorRow> {
    let errors = result.row.input_errors?;
    let sum = |of: fn(&Outcome) -> usize| result.outcomes.iter().map(of).sum();
    Some(InputErrorRow {
        relative_error: errors.relative_error,
        exchanged: errors.exchanged,
        runs: result.outcomes.len(),
        alone: count(result, |o| o.in_set && o.hypotheses.len() == 1),
        in_a_set: count(result, |o| o.in_set && o.hypotheses.len() > 1),
        outside: count(result, |o| o.verdict == Some(Verdict::Unattributed)),
        uniquely_wrong: count(result, |o| o.uniquely_wrong),
        discordant: sum(|o| o.discordant.listed),
        discordant_exchanged: sum(|o| o.discordant.exchanged),
        held_out_change: RowRates::of(&result.outcomes).held_out_change,
    })
}

fn table_row(result: &RowResult) -> TableRow {
    let row = &result.row;
    let rates = RowRates::of(&result.outcomes);
    TableRow {
        group: row.group.label(),
        seeded: row.seeded(),
        size: row.size.map_or("–", Size::label),
        noise: row.noise.name,
        runs: result.outcomes.len(),
        detectability: rates.detectability,
        detected: rates.detected,
        in_set: (row.group != Group::Null).then_some(rates.in_set),
        mean_set_size: rates.mean_set_size,
        uniquely_wrong: rates.uniquely_wrong,
        held_out_ratio: rates.held_out_ratio,
        seconds: rates.seconds,
    }
}
