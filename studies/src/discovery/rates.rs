//! Rates and medians over runs, and the bounds that they have to satisfy.

use std::collections::BTreeMap;

use diagnose::Verdict;
use serde::Serialize;

use super::outcome::Outcome;
use super::row::{Body, Group};
use super::run::RowResult;
use crate::statistics::median;

/// Permitted maximum fraction of runs in which the diagnosis gives a single, wrong hypothesis.
pub(super) const MAX_UNIQUELY_WRONG: f64 = 0.005;

/// Required minimum fraction of runs in which the effects added to the simulated flights are among the hypotheses of
/// the diagnosis. Only runs whose effect has at least the minimum detectable size are counted.
pub(super) const MIN_IN_SET: f64 = 0.97;

/// Required minimum fraction of runs in which the effects added to the simulated flights are among the hypotheses of
/// the diagnosis. Only runs whose effect has at least five times the minimum detectable size are counted.
pub(super) const MIN_IN_SET_STRONG: f64 = 0.97;

/// Permitted maximum of the false-alarm rate (fraction of runs without an added effect in which the diagnosis detects
/// one) under each noise condition.
pub(super) const MAX_FALSE_ALARMS: f64 = 0.05;

/// Permitted maximum of the ratio of the RMS prediction errors of two models on held-out flights: the model extended by
/// the effects that the diagnosis found / the model with the effects added to the simulated flights.
pub(super) const MAX_HELD_OUT_RATIO: f64 = 1.05;

/// Required minimum fraction of runs in which the effects added to the simulated flights are among the hypotheses of
/// the diagnosis, for two and for three detectable effects: (number of effects, minimum fraction).
pub(super) const MIN_IN_SET_SEVERAL: [(usize, f64); 2] = [(2, 0.95), (3, 0.85)];

/// An effect counts as strong if its size is at least this multiple of the minimum detectable size.
pub(super) const STRONG: f64 = 5.0;

/// A proportion of runs, such as the runs with a right diagnosis: number of runs examined, and number of those that
/// satisfy the criterion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub(super) struct Count {
    /// Number of runs examined (denominator of the proportion).
    pub(super) total: usize,
    /// Number of the examined runs that satisfy the criterion (numerator of the proportion).
    pub(super) count: usize,
}

impl Count {
    fn of<'a>(outcomes: impl Iterator<Item = &'a Outcome>, has: impl Fn(&Outcome) -> bool) -> Self {
        outcomes.fold(Self::default(), |counted, outcome| Self {
            total: counted.total + 1,
            count: counted.count + usize::from(has(outcome)),
        })
    }

    /// Proportion of the examined runs that satisfy the criterion; `None` if no run was examined.
    pub(super) fn fraction(&self) -> Option<f64> {
        (self.total > 0).then(|| self.count as f64 / self.total as f64)
    }
}

/// Statistics over the runs of one row of the study's table (combination of simulation settings): counts, means and
/// medians.
#[derive(Clone, Debug, Serialize)]
pub(super) struct RowRates {
    /// Number of runs in which the diagnosis detected a deviation from the model (verdict other than `Verdict::Adequate`).
    detected: usize,
    /// Number of runs in which the effects added to the simulated flights are among the hypotheses of the diagnosis.
    in_set: usize,
    /// Mean number of hypotheses over the runs in which the diagnosis detected a deviation from the model; `None`
    /// without such a run.
    mean_set_size: Option<f64>,
    /// Number of runs in which the diagnosis gives a single, wrong hypothesis.
    uniquely_wrong: usize,
    /// Median over the runs of the ratio of effect size in the simulated flights to minimum detectable size; `None` if
    /// no run has this ratio.
    detectability: Option<f64>,
    /// Median over the runs of the ratio of two prediction errors on held-out flights: model extended by the effects
    /// that the diagnosis found / model with the effects added to the simulated flights. `None` if no run has this
    /// ratio.
    held_out_ratio: Option<f64>,
    /// Median over the runs of the ratio of two prediction errors on held-out flights: model extended by the effects
    /// that the diagnosis found / model without added effects. `None` if no run has a finite ratio.
    held_out_change: Option<f64>,
    /// Median elapsed time of a diagnosis, s; `None` if no diagnosis succeeded.
    seconds: Option<f64>,
    /// Maximum, over the runs, of the elapsed time of the diagnosis, s.
    slowest: f64,
    /// Number of runs whose diagnosis ended with an error.
    failed: usize,
    /// Number of runs in which the diagnosis gives a single hypothesis, and this hypothesis consists of the effects
    /// added to the simulated flights.
    alone: usize,
    /// Number of runs in which the diagnosis gives several hypotheses, one of which consists of the effects added to
    /// the simulated flights.
    in_a_set: usize,
    /// Number of runs in which the diagnosis detects no deviation, and reports an effect that was added to the flights
    /// as not identifiable.
    not_identifiable: usize,
    /// Number of runs in which the diagnosis detected a misfit that none of its candidate effects explains (verdict
    /// `Verdict::Unattributed`).
    unattributed: usize,
    /// Number of runs in which the diagnosis selected a term of its library that acts on the same quantity of the model
    /// as the effect added to the simulated flights.
    at_its_site: usize,
    /// Names of the model quantities, such as lift, on which the terms act that the diagnosis selected from its library
    /// in any run.
    sites: String,
    /// Maximum over the runs of the number of wrong terms: effects found by the diagnosis that were not added to the
    /// flights, plus terms selected from the library of force and moment terms.
    terms_too_many: usize,
    /// Number of flights that the reports of all runs list as discordant (contradicting the effect found in most
    /// flights).
    discordant: usize,
    /// Number of the flights listed as discordant into which an error was introduced: their spin in the dataset was
    /// exchanged with that of another flight.
    discordant_exchanged: usize,
    /// Most frequent result of the diagnosis (verdict and hypotheses) over the runs.
    answer: String,
}

impl RowRates {
    /// Computes the statistics of the outcomes of the runs of one row. `site` is the quantity of the model on which the
    /// added effect acts if this effect is outside the built-in effects catalogue, otherwise empty.
    pub(super) fn of(outcomes: &[Outcome], site: &str) -> Self {
        let count = |has: &dyn Fn(&Outcome) -> bool| outcomes.iter().filter(|o| has(o)).count();
        let detected = outcomes.iter().filter(|o| o.is_detected());
        let sizes: Vec<f64> = detected.map(|o| o.hypotheses.len() as f64).collect();
        let mean = sizes.iter().sum::<f64>() / sizes.len() as f64;
        let changes = outcomes
            .iter()
            .map(|o| o.held_out.after / o.held_out.before);
        let seconds = outcomes.iter().map(|o| o.seconds);
        let extra = outcomes.iter().map(Outcome::terms_too_many);
        let sites = outcomes.iter().flat_map(|o| &o.sites);
        let mut sites: Vec<&str> = sites.map(String::as_str).collect();
        sites.sort_unstable();
        sites.dedup();
        let answer = answers(outcomes, |_| true).into_iter().next();
        Self {
            detected: sizes.len(),
            in_set: count(&|o| o.in_set),
            mean_set_size: (!sizes.is_empty()).then_some(mean),
            uniquely_wrong: count(&|o| o.uniquely_wrong),
            detectability: median(outcomes.iter().filter_map(|o| o.detectability)),
            held_out_ratio: median(outcomes.iter().filter_map(Outcome::held_out_ratio)),
            held_out_change: median(changes),
            seconds: median(seconds.clone()),
            slowest: seconds.fold(0.0, f64::max),
            failed: count(&|o| o.failure.is_some()),
            alone: count(&|o| o.in_set && o.hypotheses.len() == 1),
            in_a_set: count(&|o| o.in_set && o.hypotheses.len() > 1),
            not_identifiable: count(&|o| o.not_identifiable && !o.is_detected()),
            unattributed: count(&|o| o.verdict == Some(Verdict::Unattributed)),
            at_its_site: count(&|o| o.sites.iter().any(|s| s == site)),
            sites: sites.join(", "),
            terms_too_many: extra.max().unwrap_or(0),
            discordant: outcomes.iter().map(|o| o.discordant.listed).sum(),
            discordant_exchanged: outcomes.iter().map(|o| o.discordant.exchanged).sum(),
            answer: answer.map_or(String::new(), |(answer, _)| answer),
        }
    }
}

/// Rates of right, wrong and missed diagnoses, and prediction errors, over the runs of all rows of the study's table.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Rates {
    /// Runs in which the diagnosis gives a single, wrong hypothesis, out of all runs.
    pub(super) uniquely_wrong: Count,
    /// Runs in which the effects added to the simulated flights are among the hypotheses of the diagnosis, out of the
    /// runs with effects of the built-in effects catalogue of at least the minimum detectable size.
    pub(super) in_set: Count,
    /// Runs in which the effects added to the simulated flights are among the hypotheses of the diagnosis, out of the
    /// runs with an effect of at least [`STRONG`] times the minimum detectable size.
    pub(super) in_set_strong: Count,
    /// For each number of effects in [`Group::Several`]: this number, the required minimum fraction of right runs, and
    /// the count of right runs. A run is right if the effects added to the simulated flights are among the hypotheses
    /// of the diagnosis. Only runs in which all effects are detectable are counted.
    pub(super) in_set_several: Vec<(usize, f64, Count)>,
    /// For each noise condition: its name, and the runs in which the diagnosis detected a deviation from the model, out
    /// of the runs without an effect added to the simulated flights.
    pub(super) false_alarms: Vec<(&'static str, Count)>,
    /// Runs in which the model extended by the effects that the diagnosis found predicts held-out flights nearly as
    /// well as the model with the effects added to the simulated flights: the ratio of the RMS errors is at most
    /// [`MAX_HELD_OUT_RATIO`]. They are counted out of all runs with an effect of the built-in effects catalogue for
    /// which this ratio is known.
    pub(super) held_out: Count,
    /// Median over the runs of the ratio of the RMS prediction errors of two models on held-out flights: the model
    /// extended by the effects that the diagnosis found / the model with the effects added to the simulated flights.
    /// `None` if no run has this ratio.
    pub(super) held_out_median: Option<f64>,
    /// Ratio of RMS prediction errors on held-out flights, pooled over all runs with an effect of the built-in effects
    /// catalogue. Numerator: models extended by the effects that the diagnosis found. Denominator: models with the
    /// effects added to the simulated flights. `None` if no run has both errors.
    pub(super) held_out_pooled: Option<f64>,
    /// Runs whose diagnosis ended with an error, out of all runs.
    pub(super) failed: Count,
    /// Computing times of the diagnoses of disc datasets with the default number of flights.
    pub(super) times: Times,
}

/// Computing times of diagnoses, s.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Times {
    /// Number of threads on which each diagnosis ran.
    pub(super) threads: usize,
    /// Median time of a diagnosis, s; `None` without a run.
    pub(super) median: Option<f64>,
    /// Maximum time of a diagnosis, s; `None` without a run.
    pub(super) slowest: Option<f64>,
}

impl Times {
    fn of(results: &[RowResult]) -> Self {
        let standard =
            |result: &&RowResult| result.row.flights.is_none() && result.row.body == Body::Disc;
        let outcomes = || {
            results
                .iter()
                .filter(standard)
                .flat_map(|result| &result.outcomes)
        };
        Self {
            threads: outcomes().next().map_or(1, |outcome| outcome.threads),
            median: median(outcomes().map(|outcome| outcome.seconds)),
            slowest: outcomes().map(|outcome| outcome.seconds).reduce(f64::max),
        }
    }
}

impl Rates {
    pub(super) fn of(results: &[RowResult]) -> Self {
        let all = || results.iter().flat_map(|result| &result.outcomes);
        let listed = || all().filter(|o| !o.case.seeded.listed.is_empty());
        let detectable = |ratio: f64| listed().filter(move |o| o.is_detectable(ratio));
        let ratios = listed().filter_map(Outcome::held_out_ratio);
        let ratios: Vec<f64> = ratios.filter(|ratio| ratio.is_finite()).collect();
        let within = ratios.iter().filter(|ratio| **ratio <= MAX_HELD_OUT_RATIO);
        let nulls = results
            .iter()
            .filter(|result| result.row.group == Group::Null);
        let false_alarms = nulls.map(|result| {
            let count = Count::of(result.outcomes.iter(), Outcome::is_detected);
            (result.row.noise.name, count)
        });
        let several = MIN_IN_SET_SEVERAL.iter().map(|(number, least)| {
            let rows = results.iter().filter(|result| {
                result.row.group == Group::Several && result.row.effects.len() == *number
            });
            let runs = rows.flat_map(|result| &result.outcomes);
            let counted = Count::of(runs.filter(|o| o.is_detectable(1.0)), |o| o.in_set);
            (*number, *least, counted)
        });
        Self {
            in_set_several: several.collect(),
            uniquely_wrong: Count::of(all(), |o| o.uniquely_wrong),
            in_set: Count::of(detectable(1.0), |o| o.in_set),
            in_set_strong: Count::of(detectable(STRONG), |o| o.in_set),
            false_alarms: false_alarms.collect(),
            held_out: Count {
                total: ratios.len(),
                count: within.count(),
            },
            held_out_median: median(ratios),
            held_out_pooled: pooled(listed()),
            failed: Count::of(all(), |o| o.failure.is_some()),
            times: Times::of(results),
        }
    }
}

/// Ratio of RMS prediction errors on held-out flights, pooled over all runs. Numerator: models extended by the effects
/// that the diagnosis found. Denominator: models with the effects added to the simulated flights. `None` if no run has
/// both errors.
fn pooled<'a>(outcomes: impl Iterator<Item = &'a Outcome>) -> Option<f64> {
    let squares = outcomes.filter_map(|o| {
        let (after, truth) = (o.held_out.after, o.held_out.truth?);
        (after.is_finite() && truth.is_finite()).then_some((after * after, truth * truth))
    });
    let (after, truth) = squares.fold((0.0, 0.0), |sum, (a, t)| (sum.0 + a, sum.1 + t));
    (truth > 0.0).then(|| f64::sqrt(after / truth))
}

/// Counts how often each result of the diagnosis (verdict and hypotheses as text) occurs among the outcomes for which
/// `has` is true. The most frequent result is first.
pub(super) fn answers(
    outcomes: &[Outcome],
    has: impl Fn(&Outcome) -> bool,
) -> Vec<(String, usize)> {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for outcome in outcomes.iter().filter(|o| has(o)) {
        *counts.entry(outcome.answer()).or_default() += 1;
    }
    let mut counts: Vec<(String, usize)> = counts.into_iter().collect();
    counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    counts
}
