//! Renders docs/studies/fits.md.

use model_spec::sort_by_number;
use serde::Serialize;

use super::run::FitOutcome;
use crate::error::StudyError;
use crate::page::Page;
use crate::statistics::median;

/// Maximum number of failed fits that docs/studies/fits.md lists.
const MAX_LISTED: usize = 40;

/// Boundaries, m, of the ranges of marker displacement (caused by the added effects) by which the fits are grouped in a
/// table.
const CLASSES: [f64; 5] = [0.0, 0.005, 0.05, 0.3, f64::INFINITY];

#[derive(Serialize)]
struct Results {
    threads: usize,
    #[serde(flatten)]
    all: Class,
    not_converged: usize,
    by_number: Vec<Class>,
    by_displacement: Vec<Class>,
    failures: Vec<Row>,
    more: usize,
    slow: Vec<Row>,
}

/// Number, success rate and computing times of a group of fits, such as the fits of datasets with two added effects.
#[derive(Serialize)]
struct Class {
    name: String,
    fits: usize,
    reached: usize,
    aborted: usize,
    median: Option<f64>,
    slowest: f64,
}

#[derive(Serialize)]
struct Row {
    seed: u64,
    effects: String,
    displacement: f64,
    ratio: Option<f64>,
    seconds: f64,
    what: String,
}

/// Renders docs/studies/fits.md from the outcomes of fits of datasets with randomly drawn effects.
///
/// # Errors
/// [`StudyError::Page`] if the template cannot be rendered with the results.
pub fn fits_page(outcomes: &[FitOutcome]) -> Result<Page, StudyError> {
    let all: Vec<&FitOutcome> = outcomes.iter().collect();
    let by_number = (1..=3).map(|number| {
        let of = all.iter().filter(|o| o.case.effects.len() == number);
        class(number.to_string(), &of.copied().collect::<Vec<_>>())
    });
    let by_displacement = CLASSES.windows(2).map(|limits| {
        let of = all
            .iter()
            .filter(|o| (limits[0]..limits[1]).contains(&o.case.displacement));
        let name = match limits[1].is_finite() {
            true => format!("{} to {} m", limits[0], limits[1]),
            false => format!("over {} m", limits[0]),
        };
        class(name, &of.copied().collect::<Vec<_>>())
    });
    let mut failures: Vec<&FitOutcome> = outcomes.iter().filter(|o| !o.is_reached()).collect();
    sort_by_number(&mut failures, |run| -severity(run));
    let more = failures.len().saturating_sub(MAX_LISTED);
    let mut slow = all.clone();
    sort_by_number(&mut slow, |run| -run.seconds);
    let not_converged = |o: &&&FitOutcome| o.status.is_some_and(|status| !status.converged());
    let results = Results {
        threads: outcomes.first().map_or(1, |outcome| outcome.threads),
        all: class(String::new(), &all),
        not_converged: all.iter().filter(not_converged).count(),
        by_number: by_number.collect(),
        by_displacement: by_displacement.collect(),
        failures: failures.into_iter().take(MAX_LISTED).map(row).collect(),
        more,
        slow: slow.into_iter().take(5).map(row).collect(),
    };
    Page::without_figures(include_str!("page.md"), results)
}

fn class(name: String, of: &[&FitOutcome]) -> Class {
    let seconds = of.iter().map(|o| o.seconds);
    Class {
        name,
        fits: of.len(),
        reached: of.iter().filter(|o| o.is_reached()).count(),
        aborted: of.iter().filter(|o| o.failure.is_some()).count(),
        median: median(seconds.clone()),
        slowest: seconds.fold(0.0, f64::max),
    }
}

/// Key by which failed fits are sorted in descending order: RMS residual / RMS residual expected of the true model, or
/// infinity for a fit that ended with an error.
fn severity(outcome: &FitOutcome) -> f64 {
    outcome.ratio.unwrap_or(f64::INFINITY)
}

fn row(outcome: &FitOutcome) -> Row {
    let mut what = Vec::new();
    if let Some(failure) = &outcome.failure {
        what.push(format!("no result: {}", failure.replace('\n', " ")));
    }
    let [excluded, cut] = outcome.lost;
    let counts = [(excluded, "excluded"), (cut, "truncated")];
    let lost = counts.iter().filter(|(count, _)| *count > 0);
    what.extend(lost.map(|(count, how)| format!("{count} flights {how}")));
    if outcome.outliers > 0.001 {
        what.push(format!("{:.1} % outliers", 100.0 * outcome.outliers));
    }
    if let Some(status) = outcome.status.filter(|status| !status.converged()) {
        what.push(format!("{status:?}"));
    }
    let effects = outcome.case.effects.iter().map(|(name, values)| {
        let values: Vec<String> = values.iter().map(|v| format!("{v:.3e}")).collect();
        format!("`{name}` ({})", values.join(", "))
    });
    Row {
        seed: outcome.case.seed,
        effects: effects.collect::<Vec<_>>().join(", "),
        displacement: outcome.case.displacement,
        ratio: outcome.ratio,
        seconds: outcome.seconds,
        what: what.join("; "),
    }
}
