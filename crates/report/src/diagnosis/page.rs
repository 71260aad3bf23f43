//! HTML page of a diagnosis.

use dataset::Role;
use diagnose::Report;

use super::draw::Figures;
use super::finding::Finding;
use super::{DiagnosisPage, coefficients, evidence, explanations, limits, words};
use crate::figure::Figure;
use crate::html::Html;
use crate::page::{Page, heading, watch};
use crate::table::Table;
use crate::thin::MAX_ROWS;
use identify::wording::{counted, durations, names, sentence, short, truncated};

/// Maximum number of characters of the extended model's text shown in the HTML report.
const MAX_TEXT: usize = 60_000;

/// Renders the self-contained HTML page of the diagnosis.
pub(super) fn html(page: &DiagnosisPage<'_>, finding: &Finding, figures: &Figures) -> String {
    let report = page.report;
    let mut body = Html::new();
    body.unreliable(&report.cautions, "diagnosis");
    body.element_with_id("section", "summary", "", summary(page, finding, figures));
    body.data_faults(&report.data_faults);
    let title = match report.explanations.len() {
        0 => "No explanation",
        1 => "Explanation",
        _ => "Possible explanations",
    };
    body.section("explanations", title, explanations::section(page));
    body.section("evidence", "Evidence", evidence::section(page, figures));
    let coefficients = coefficients::section(report);
    body.section("coefficients", "Coefficients", coefficients);
    body.section("limits", "Limits of these flights", limits::section(report));
    if report.unattributed.is_some() {
        let title = "Terms outside the catalogue";
        body.section("unattributed", title, unattributed(report, figures));
    }
    body.section("extension", "Extended model", extension(page));
    body.section("how", "How it was computed", how(report));
    let mut model = Html::from(&report.model);
    if !report.effects.is_empty() {
        model = heading(&report.model, "with", &names(&report.effects));
    }
    Page {
        kind: "hyzer diagnose",
        title: format!("Diagnosis of {} with {}", report.model, report.dataset),
        heading: model.then(heading("", "tested with", &report.dataset)),
        body,
    }
    .html()
}

fn summary(page: &DiagnosisPage<'_>, finding: &Finding, figures: &Figures) -> Html {
    let report = page.report;
    let verdict = format!("verdict {}", report.verdict.name());
    let mut lead = Html::from("\n");
    if !finding.what.is_empty() {
        lead.element("p", "finding", &finding.what);
    }
    let next = Html::from(format!("{} ", finding.next)).then(watch());
    for (what, text) in [
        ("How sure.", Html::from(&finding.sure)),
        ("What it gains.", report.gain_sentences().into()),
        ("What next.", next),
    ] {
        lead.element("p", "", Html::strong(what).then(" ").then(text));
    }
    let mut picture = Html::new();
    let shown = figures.finding.clone().map(Figure::reachable);
    picture.figures(shown.iter().chain(figures.opening_channel()), true);
    let mut gain = Html::new();
    gain.figures(figures.gain.clone().map(Figure::reachable).iter(), true);
    let mut opening = Html::from("\n");
    opening.element("div", "words lead", lead);
    opening.element("div", "picture", picture);
    opening.element("div", "gain", gain);
    let mut more = Html::from("\n");
    if let Some(test) = &report.lack_of_fit {
        more.element("p", "", test.sentence());
    }
    let notes = report.notes.iter().take(MAX_ROWS);
    more.alarms("Notes", notes.map(|note| sentence(note)));
    let summary = report.summary.trim();
    if !summary.is_empty() {
        let text = Html::of("p", "", summary);
        more.folded("Summary, as in report.json", text);
    }
    let mut content = Html::from("\n");
    content.element("p", &verdict, report.verdict_sentence());
    content.element("div", "opening", opening);
    content.element("div", "words", more);
    content
}

/// Loads and terms outside the catalogue of effects in which the misfit lies.
fn unattributed(report: &Report, figures: &Figures) -> Html {
    let mut content = Html::new();
    let Some(found) = &report.unattributed else {
        return content;
    };
    let description = found.description.trim();
    if !description.is_empty() {
        content.paragraph(description);
    }
    let (first, rest) = figures
        .channels
        .split_at(figures.channels.len().min(super::OPEN));
    let opening = figures.opening_channel().count();
    for (i, figure) in first.iter().enumerate().skip(opening) {
        content.figure(figure, i == 0);
    }
    let mut more = Html::new();
    more.figures(rest, false);
    content.folded(format!("{} more", rest.len()), more);
    let terms = limits::terms(&found.terms);
    if !terms.is_empty() {
        content.heading("Candidate terms");
        content.table(&terms);
    }
    content
}

/// Extended model: its file, its text and its verification.
fn extension(page: &DiagnosisPage<'_>) -> Html {
    let mut content = Html::new();
    if let Some(file) = &page.report.extended_model {
        content.paragraph(format!(
            "The extended model is {file}, in the folder of this page; its default values are the estimates."
        ));
    }
    if let Some(text) = page.extended {
        let mut model = Html::new();
        model.scrolled("pre", "model", truncated(text, MAX_TEXT));
        content.folded("Its text", model);
    }
    if let Some(verified) = &page.report.verified {
        let outcome = if verified.holds {
            "It passes all independent checks."
        } else {
            "It fails an independent check: do not rely on it."
        };
        content.element_with_id("p", "verified", "words", outcome);
        let table = Table::of(verified.checks.iter().take(MAX_ROWS))
            .name("check", |(name, _)| short(name))
            .text("result", |(_, result)| short(result))
            .table();
        content.table(&table);
    }
    content
}

fn how(report: &Report) -> Html {
    let number = |role| report.flights.iter().filter(|f| f.role == role).count();
    let held_out = match number(Role::HeldOut) {
        0 => String::new(),
        n => format!(" and {n} held out"),
    };
    let mut content = Html::new();
    content.paragraph(format!(
        "{} {} fitted{held_out}; {} tested.",
        words::noise(report),
        counted(number(Role::Fit), "flight"),
        counted(report.tests.len(), "effect"),
    ));
    let seconds = match durations(&report.seconds).as_str() {
        "" => String::new(),
        seconds => format!("; time: {seconds}"),
    };
    content.note(format!(
        "SI units unless stated otherwise. Schema {}; hyzer {}{seconds}. The numbers are in report.json.",
        report.schema,
        env!("CARGO_PKG_VERSION")
    ));
    content
}
