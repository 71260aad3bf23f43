//! Renders docs/studies/wild.md.

use serde::Serialize;

use super::case::Group;
use super::run::{LIMIT, Outcome};
use crate::error::StudyError;
use crate::page::Page;
use crate::statistics::median;

/// Maximum length of a quoted text on the page, in characters.
const MAX_QUOTE: usize = 240;

/// Maximum processor time of a fit or a diagnosis, s.
const MAX_SECONDS: f64 = 20.0;

/// Non-centrality by hidden physics that a test sees in half of the cases: of one that knows what is hidden, at the level
/// of 1 %; and of the most significant of the fit's score tests of some 284 terms, at 1 % of all together.
const HALF_SEEN: [f64; 2] = [6.6, 17.1];

#[derive(Serialize)]
struct Results {
    seeds: u64,
    diagnose_every: u64,
    /// Limit of the elapsed time of a fit or diagnosis, s.
    limit: u64,
    half_seen: [f64; 2],
    total: Counts,
    clean: Counts,
    mistakes: Counts,
    hidden: Counts,
    classes: Vec<Counts>,
    datasets: Vec<Row>,
}

/// Counts of datasets.
#[derive(Serialize)]
struct Counts {
    name: String,
    fits: usize,
    reliable: usize,
    confidently_wrong: usize,
    vetoed: usize,
    /// Fits that are not reliable and wrong, with nothing wrong in the dataset.
    missed: usize,
    no_result: usize,
    diagnoses: usize,
    wrong_cause: usize,
    false_all_clear: usize,
    median: Option<f64>,
    slowest: f64,
    slowest_diagnosis: f64,
    slow: usize,
    /// Fits that are confidently wrong with a non-centrality below those of [`HALF_SEEN`].
    invisible: [usize; 2],
}

#[derive(Serialize)]
struct Row {
    class: String,
    run: u64,
    description: String,
    judgement: &'static str,
    coefficient: String,
    z: Option<f64>,
    reasons: String,
    answer: String,
    diagnosis: &'static str,
    misfit: Option<f64>,
    chi2: Option<f64>,
    seconds: f64,
    diagnosis_seconds: Option<f64>,
}

/// Renders docs/studies/wild.md from the outcomes of the datasets. `seeds` and `diagnose_every` are the numbers with which
/// the datasets and those to be diagnosed were selected.
///
/// # Errors
/// [`StudyError::Page`] if the template cannot be rendered with the results.
pub fn wild_page(
    outcomes: &[Outcome],
    seeds: u64,
    diagnose_every: u64,
) -> Result<Page, StudyError> {
    let all: Vec<&Outcome> = outcomes.iter().collect();
    let of = |group: Group| -> Counts {
        let of = all.iter().filter(|o| o.case.group() == group);
        counts(group.label(), &of.copied().collect::<Vec<_>>())
    };
    let mut names: Vec<String> = Vec::new();
    for outcome in outcomes {
        let row = outcome.case.row();
        if !names.contains(&row) {
            names.push(row);
        }
    }
    let classes = names.iter().map(|name| {
        let of = all.iter().filter(|o| o.case.row() == *name);
        counts(name, &of.copied().collect::<Vec<_>>())
    });
    let results = Results {
        seeds,
        diagnose_every,
        limit: LIMIT.as_secs(),
        half_seen: HALF_SEEN,
        total: counts("all", &all),
        clean: of(Group::Clean),
        mistakes: of(Group::Mistake),
        hidden: of(Group::Hidden),
        classes: classes.collect(),
        datasets: outcomes.iter().map(row).collect(),
    };
    Page::without_figures(include_str!("page.md"), results)
}

fn counts(name: &str, of: &[&Outcome]) -> Counts {
    let number = |is: &dyn Fn(&Outcome) -> bool| of.iter().filter(|o| is(o)).count();
    let diagnoses = || of.iter().filter_map(|o| o.diagnosed.as_ref());
    let fits = of.iter().map(|o| o.fitted.seconds);
    let of_diagnoses = diagnoses().map(|found| found.seconds);
    let slow = |seconds: &f64| *seconds > MAX_SECONDS;
    Counts {
        name: name.to_owned(),
        fits: of.len(),
        reliable: number(&|o| o.fitted.reliable),
        confidently_wrong: number(&|o| o.fitted.is_confidently_wrong()),
        vetoed: number(&Outcome::is_vetoed),
        missed: number(&Outcome::is_missed),
        no_result: number(&|o| o.fitted.worst.is_none()),
        diagnoses: diagnoses().count(),
        wrong_cause: diagnoses().filter(|found| found.is_wrong_cause).count(),
        false_all_clear: diagnoses().filter(|found| found.is_false_all_clear).count(),
        median: median(fits.clone()),
        slowest: fits.clone().fold(0.0, f64::max),
        slowest_diagnosis: of_diagnoses.clone().fold(0.0, f64::max),
        slow: fits.filter(slow).count()
            + of_diagnoses.filter(slow).count()
            + number(&|o| o.fitted.interrupted && o.fitted.seconds <= MAX_SECONDS),
        invisible: HALF_SEEN
            .map(|limit| number(&|o| o.fitted.misfit.is_some_and(|misfit| misfit.chi2 < limit))),
    }
}

fn row(outcome: &Outcome) -> Row {
    let fitted = &outcome.fitted;
    let diagnosed = outcome.diagnosed.as_ref();
    let judgement = match () {
        () if fitted.is_confidently_wrong() => "confidently wrong",
        () if outcome.is_vetoed() => "vetoed",
        () if outcome.is_missed() => "wrong, not reliable",
        () if fitted.worst.is_none() => "no result",
        () if fitted.reliable => "reliable",
        () => "not reliable",
    };
    let worst = fitted.worst.as_ref();
    let misfit = fitted.misfit.or(diagnosed.and_then(|found| found.misfit));
    Row {
        class: outcome.case.class(),
        run: outcome.case.run,
        description: outcome.description.clone(),
        judgement,
        coefficient: worst.map_or_else(String::new, |(name, _)| name.clone()),
        z: worst.map(|(_, z)| *z),
        reasons: quote(&fitted.reasons),
        answer: diagnosed.map_or_else(String::new, |found| quote(&found.answer)),
        diagnosis: match diagnosed {
            None => "",
            Some(found) if found.is_wrong_cause => "wrong cause",
            Some(found) if found.is_false_all_clear => "false all-clear",
            Some(_) => "not wrong",
        },
        misfit: misfit.map(|misfit| misfit.ratio),
        chi2: misfit.map(|misfit| misfit.chi2),
        seconds: fitted.seconds,
        diagnosis_seconds: diagnosed.map(|found| found.seconds),
    }
}

/// Beginning of a text, without the characters that end a cell of a table.
fn quote(text: &str) -> String {
    let mut quoted: String = text.chars().take(MAX_QUOTE).collect();
    if quoted.len() < text.len() {
        quoted.push('…');
    }
    quoted.replace('|', "/")
}
