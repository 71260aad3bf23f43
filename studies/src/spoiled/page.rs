//! Renders docs/studies/spoiled.md.

use serde::Serialize;

use super::judge::Judgement;
use super::run::Run;
use crate::cuts::CutSection;
use crate::error::StudyError;
use crate::page::Page;

/// Maximum length of a fit's message that is quoted on the page, characters.
const MAX_QUOTE: usize = 160;

#[derive(Serialize)]
struct Results {
    kinds: usize,
    runs: usize,
    safe: usize,
    blamed: usize,
    slowest: f64,
    rows: Vec<Row>,
    cuts: Option<CutSection>,
}

#[derive(Serialize)]
struct Row {
    name: &'static str,
    what: &'static str,
    which: &'static str,
    runs: usize,
    answers: String,
    safe: usize,
    max_z: Option<f64>,
    blamed: usize,
    seconds: f64,
    description: String,
}

/// Renders docs/studies/spoiled.md from the fits of datasets with recording mistakes. `cuts` is the section on the truncation
/// of flights at the ground; `None` if the study of truncation was not run.
///
/// # Errors
/// [`StudyError::Page`] if the template cannot be rendered with the results.
pub fn spoiled_page(runs: &[Run], cuts: Option<CutSection>) -> Result<Page, StudyError> {
    let mut rows: Vec<Vec<&Run>> = Vec::new();
    for run in runs {
        let same = |row: &Vec<&Run>| row[0].kind.name == run.kind.name && row[0].which == run.which;
        match rows.iter_mut().find(|row| same(row)) {
            Some(row) => row.push(run),
            None => rows.push(vec![run]),
        }
    }
    let mut names: Vec<&str> = runs.iter().map(|run| run.kind.name).collect();
    names.dedup();
    let rows: Vec<Row> = rows.iter().map(|runs| row(runs)).collect();
    let results = Results {
        kinds: names.len(),
        runs: runs.len(),
        safe: rows.iter().map(|row| row.safe).sum(),
        blamed: rows.iter().map(|row| row.blamed).sum(),
        slowest: runs.iter().map(|run| run.seconds).fold(0.0, f64::max),
        rows,
        cuts,
    };
    Page::without_figures(include_str!("page.md"), results)
}

fn row(runs: &[&Run]) -> Row {
    let mut answers: Vec<(Judgement, usize)> = Vec::new();
    for run in runs {
        let judgement = run.judged.judgement;
        match answers.iter_mut().find(|(of, _)| *of == judgement) {
            Some((_, count)) => *count += 1,
            None => answers.push((judgement, 1)),
        }
    }
    answers.sort();
    let answers = answers
        .iter()
        .map(|(judgement, count)| format!("{} {count}", judgement.label()));
    let worst = runs.iter().max_by_key(|run| run.judged.judgement);
    let says = worst.map_or("", |run| run.judged.description.as_str());
    let errors = runs.iter().filter_map(|run| run.judged.max_z);
    Row {
        name: runs[0].kind.name,
        what: runs[0].kind.what,
        which: runs[0].which.label(),
        runs: runs.len(),
        answers: answers.collect::<Vec<_>>().join(", "),
        safe: runs
            .iter()
            .filter(|run| run.judged.judgement.is_safe())
            .count(),
        max_z: errors.reduce(f64::max),
        blamed: runs
            .iter()
            .filter(|run| !run.judged.blamed.is_empty())
            .count(),
        seconds: runs.iter().map(|run| run.seconds).fold(0.0, f64::max),
        description: says
            .chars()
            .take(MAX_QUOTE)
            .collect::<String>()
            .replace('|', "/"),
    }
}
