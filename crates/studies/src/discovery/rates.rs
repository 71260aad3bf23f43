//! Counts and medians over runs, and the bars that they are held against.

use std::collections::BTreeMap;

use diagnose::report::Verdict;

use super::Tried;
use super::plan::Group;
use super::run::Outcome;

/// Runs with one single cause that is wrong, at most, of all.
pub const WRONG: f64 = 0.01;

/// Runs with the true cause in the set, at least, where it has one smallest detectable size or more.
pub const IN_SET: f64 = 0.90;

/// The same where it has five or more.
pub const IN_SET_STRONG: f64 = 0.95;

/// Alarms where nothing is hidden, at most, under each noise.
pub const FALSE_ALARMS: f64 = 0.05;

/// Error on held-out flights over that of the true model, at most.
pub const HELD_OUT: f64 = 1.05;

/// So many smallest detectable sizes are strong.
pub const STRONG: f64 = 5.0;

/// So many of so many.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Part {
    /// So many.
    pub of: usize,
    /// Of them these.
    pub these: usize,
}

impl Part {
    fn count<'a>(
        outcomes: impl Iterator<Item = &'a Outcome>,
        is: impl Fn(&Outcome) -> bool,
    ) -> Self {
        let mut part = Part::default();
        for outcome in outcomes {
            part.of += 1;
            part.these += usize::from(is(outcome));
        }
        part
    }

    /// As a fraction; none of nothing.
    pub fn fraction(&self) -> Option<f64> {
        (self.of > 0).then(|| self.these as f64 / self.of as f64)
    }
}

impl Outcome {
    /// Whether what is hidden has so many smallest detectable sizes; never where nothing of the catalogue is hidden.
    pub fn has(&self, sizes: f64) -> bool {
        self.detectable_sizes.is_some_and(|s| s >= sizes)
    }

    /// What the diagnosis said, in a word and names.
    pub fn said(&self) -> String {
        let causes: Vec<String> = self.causes.iter().map(|cause| cause.join("+")).collect();
        match self.verdict {
            None => "failed".to_owned(),
            Some(Verdict::None) => "nothing".to_owned(),
            Some(verdict) => {
                let word = format!("{verdict:?}").to_lowercase();
                format!("{word}: {}", causes.join(" | "))
            }
        }
    }
}

/// What came of one row.
#[derive(Clone, Debug)]
pub struct RowRates {
    /// Runs whose truth has a smallest detectable size or more.
    pub detectable: usize,
    /// Runs with an alarm.
    pub detected: usize,
    /// Runs with the truth among the causes; from outside the catalogue, those with that verdict.
    pub in_set: usize,
    /// The same of those whose truth is detectable.
    pub in_set_detectable: Part,
    /// Causes of the runs with an alarm, on average.
    pub set_size: Option<f64>,
    /// Runs with one cause that is wrong.
    pub wrong: usize,
    /// Runs whose report says that these flights cannot show the truth.
    pub undetectable: usize,
    /// Median of the truth's size over the smallest detectable.
    pub sizes: Option<f64>,
    /// Median of the error on held-out flights over that of the true model.
    pub held_out: Option<f64>,
    /// Median of the error on held-out flights with the extension over that without.
    pub gain: Option<f64>,
    /// Median of the time, s.
    pub seconds: Option<f64>,
}

impl RowRates {
    /// Of a row's runs.
    pub fn of(outcomes: &[Outcome]) -> Self {
        let count = |is: &dyn Fn(&Outcome) -> bool| outcomes.iter().filter(|o| is(o)).count();
        let alarmed = outcomes.iter().filter(|o| o.alarmed());
        let sizes: Vec<f64> = alarmed.map(|o| o.causes.len() as f64).collect();
        let mean = sizes.iter().sum::<f64>() / sizes.len() as f64;
        Self {
            detectable: count(&|o| o.has(1.0)),
            detected: sizes.len(),
            in_set: count(&|o| o.in_set),
            in_set_detectable: Part::count(outcomes.iter().filter(|o| o.has(1.0)), |o| o.in_set),
            set_size: (!sizes.is_empty()).then_some(mean),
            wrong: count(&|o| o.wrong),
            undetectable: count(&|o| o.undetectable),
            sizes: median(outcomes.iter().filter_map(|o| o.detectable_sizes)),
            held_out: median(outcomes.iter().filter_map(Outcome::held_out_ratio)),
            gain: median(
                outcomes
                    .iter()
                    .map(|o| o.held_out_after / o.held_out_before),
            ),
            seconds: median(outcomes.iter().map(|o| o.seconds)),
        }
    }
}

/// What came of all rows.
#[derive(Clone, Debug)]
pub struct Rates {
    /// One cause and it is wrong, of all runs.
    pub wrong: Part,
    /// The truth in the set, of runs where it is of the catalogue and has a smallest detectable size or more.
    pub in_set: Part,
    /// Where it has [`STRONG`] or more.
    pub in_set_strong: Part,
    /// Alarms where nothing is hidden, by noise.
    pub false_alarms: Vec<(&'static str, Part)>,
    /// Within [`HELD_OUT`] of the true model on held-out flights, of runs with something of the catalogue hidden.
    pub held_out: Part,
    /// The median of that ratio.
    pub held_out_median: Option<f64>,
    /// The root mean square of errors over all those runs, over the same of the true models.
    pub held_out_together: Option<f64>,
    /// Runs that failed.
    pub failed: Part,
    /// Median of the time, s.
    pub seconds: Option<f64>,
}

impl Rates {
    /// Over all rows.
    pub fn of(tried: &[Tried]) -> Self {
        let all = || tried.iter().flat_map(|tried| &tried.outcomes);
        let hidden = || all().filter(|o| !o.case.hidden.effects.is_empty());
        let ratios = || {
            hidden()
                .filter_map(Outcome::held_out_ratio)
                .filter(|r| r.is_finite())
        };
        let nulls = tried.iter().filter(|tried| tried.row.group == Group::Null);
        let false_alarms = nulls.map(|tried| {
            let part = Part::count(tried.outcomes.iter(), Outcome::alarmed);
            (tried.row.noise.name, part)
        });
        let squares = hidden().filter_map(|o| {
            let (after, truly) = (o.held_out_after, o.held_out_true?);
            (after.is_finite() && truly.is_finite()).then_some((after * after, truly * truly))
        });
        let (after, truly) = squares.fold((0.0, 0.0), |sum, (a, t)| (sum.0 + a, sum.1 + t));
        let within = ratios().filter(|ratio| *ratio <= HELD_OUT).count();
        Self {
            wrong: Part::count(all(), |o| o.wrong),
            in_set: Part::count(hidden().filter(|o| o.has(1.0)), |o| o.in_set),
            in_set_strong: Part::count(hidden().filter(|o| o.has(STRONG)), |o| o.in_set),
            false_alarms: false_alarms.collect(),
            held_out: Part {
                of: ratios().count(),
                these: within,
            },
            held_out_median: median(ratios()),
            held_out_together: (truly > 0.0).then(|| f64::sqrt(after / truly)),
            failed: Part::count(all(), |o| o.failed.is_some()),
            seconds: median(all().map(|o| o.seconds)),
        }
    }
}

/// The middle of what is finite.
pub fn median(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    values.sort_by(f64::total_cmp);
    let half = values.len() / 2;
    match values.len() {
        0 => None,
        n if n % 2 == 1 => Some(values[half]),
        _ => Some((values[half - 1] + values[half]) / 2.0),
    }
}

/// What was said of the outcomes that `is` holds of, the most frequent first.
pub fn said(outcomes: &[Outcome], is: impl Fn(&Outcome) -> bool) -> Vec<(String, usize)> {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for outcome in outcomes.iter().filter(|o| is(o)) {
        *counts.entry(outcome.said()).or_default() += 1;
    }
    let mut counts: Vec<(String, usize)> = counts.into_iter().collect();
    counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    counts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_leaves_out_what_is_no_number() {
        assert_eq!(median([3.0, f64::NAN, 1.0, 2.0].into_iter()), Some(2.0));
        assert_eq!(median([4.0, 1.0].into_iter()), Some(2.5));
        assert_eq!(median([f64::NAN].into_iter()), None);
    }
}
