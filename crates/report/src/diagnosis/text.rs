//! Text of a diagnosis for a terminal.

use diagnose::{LackOfFit, Report};

use super::{evidence, explanations, page, words};
use crate::faults::cautions;
use crate::text::wrapped;

const MAX_TESTS: usize = 10;

/// Text of a diagnosis: sentences and tables of the page.
pub fn text(report: &Report) -> String {
    let mut text = cautions("diagnosis", &report.cautions, &report.data_faults);
    text += &wrapped(&format!("{}: {}", report.verdict, report.summary));
    for (i, explanation) in report.explanations.iter().enumerate() {
        text += &format!("\nexplanation {}: {}\n", i + 1, explanation.name());
        text += &explanations::estimates(explanation).text(usize::MAX);
        text += &wrapped(&explanations::share(report, explanation));
    }
    text.push('\n');
    let mut sentences: Vec<String> = Vec::new();
    sentences.extend(report.lack_of_fit.as_ref().map(LackOfFit::sentence));
    sentences.push(words::noise(report));
    sentences.extend(report.notes.iter().map(|note| format!("Note: {note}")));
    let throw = report.proposed_throw.as_ref();
    sentences.extend(throw.map(|throw| format!("Proposed throw: {}", throw.description)));
    sentences.extend(report.verified.as_ref().map(|verified| {
        let holds = if verified.holds { "passes" } else { "FAILS" };
        let checks = verified.checks.len();
        format!("The extended model {holds} its checks ({checks}).")
    }));
    text.extend(sentences.iter().map(|sentence| wrapped(sentence)));
    text += &format!("\n{}", evidence::scores(report).text(MAX_TESTS));
    let hidden = page::not_identifiable(report);
    if !hidden.is_empty() {
        let table = hidden.text(usize::MAX);
        text += &format!("\nnot identifiable from these flights:\n{table}");
    }
    text
}
