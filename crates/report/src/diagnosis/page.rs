//! Page of a diagnosis.

use dataset::Role;
use diagnose::{Coefficient, NotIdentifiable, Report, StepwiseTerm};
use identify::numbers::{Digits, plain, significant, unit};
use identify::wording::{counted, durations, names, sentence, short, truncated};
use model_spec::sort_by_number;

use super::finding::{Finding, finding};
use super::{DiagnosisPage, draw, evidence, explanations, words};
use crate::figure::Figure;
use crate::html::Html;
use crate::page::{Page, heading, watch};
use crate::table::{Cell, Table};
use crate::thin::MAX_ROWS;

const MAX_TEXT: usize = 60_000;

/// The page of the report of a diagnosis.
pub fn page(page: &DiagnosisPage<'_>) -> Page {
    let report = page.report;
    let (finding, mut picture) = finding(page);
    let mut channels = draw::channels(report);
    // Without a figure of the finding, the first missing load opens the page.
    let is_opened = picture.is_none() && !channels.is_empty();
    if is_opened {
        picture = Some(channels.remove(0));
    }
    let mut body = Html::new();
    body.unreliable(&report.cautions, "diagnosis");
    let summary = summary(report, &finding, picture);
    body.element_with_id("section", "summary", "", summary);
    body.data_faults(&report.data_faults);
    let title = match report.explanations.len() {
        0 => "No explanation",
        1 => "Explanation",
        _ => "Possible explanations",
    };
    body.section("explanations", title, explanations::section(page));
    body.section("evidence", "Evidence", evidence::section(page));
    body.section("coefficients", "Coefficients", coefficients(report));
    body.section("limits", "Limits of these flights", limits(report));
    if report.unattributed.is_some() {
        let title = "Terms outside the catalogue";
        body.section(
            "unattributed",
            title,
            unattributed(report, channels, is_opened),
        );
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
}

fn summary(report: &Report, finding: &Finding, figure: Option<Figure>) -> Html {
    let verdict = format!("verdict {}", report.verdict);
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
    let (mut picture, mut gain) = (Html::new(), Html::new());
    picture.leading_figure(figure);
    gain.leading_figure(draw::gain(report));
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
    content.opening(lead, picture, gain);
    content.element("div", "words", more);
    content
}

/// Loads and terms outside the catalogue; the first load is not among `channels` if it opens the page.
fn unattributed(report: &Report, mut channels: Vec<Figure>, is_opened: bool) -> Html {
    let mut content = Html::new();
    let Some(found) = &report.unattributed else {
        return content;
    };
    let description = found.description.trim();
    if !description.is_empty() {
        content.paragraph(description);
    }
    let open = super::OPEN - usize::from(is_opened);
    let rest = channels.split_off(channels.len().min(open));
    for (i, figure) in channels.into_iter().enumerate() {
        content.figure(figure, i == 0 && !is_opened);
    }
    let summary = format!("{} more", rest.len());
    let mut more = Html::new();
    more.figures(rest, false);
    content.folded(summary, more);
    let terms = terms(&found.terms);
    if !terms.is_empty() {
        content.heading("Candidate terms");
        content.table(&terms);
    }
    content
}

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

/// Minimum change of an estimate by the added effects, in standard errors, for the estimate without them to be biased.
const BIASED: f64 = 3.0;

/// Coefficients of the model under test, then those of the added effects.
fn coefficients(report: &Report) -> Html {
    let is_extended = report.coefficients.values().any(|c| c.before.is_some());
    let mut all: Vec<_> = report.coefficients.iter().collect();
    sort_by_number(&mut all, |(_, found)| f64::from(found.before.is_none()));
    let digits = |c: &Coefficient| Digits::of(c.value, c.std_error);
    let change = |c: &Coefficient| {
        let change = (c.value - c.before?) / c.std_error;
        Some(change).filter(|change| change.is_finite() && c.std_error > 0.0)
    };
    let sign = |change: f64| if change >= 0.05 { "+" } else { "" };
    let standard_errors = |c: f64| format!("{}{}", sign(c), plain(c, 1));
    let value = if is_extended { "extended" } else { "value" };
    let table = Table::of(all)
        .name("", |(name, _)| *name)
        .when(is_extended, |rows| {
            rows.number("before", |(_, c)| c.before.map(|v| digits(c).one(v)))
        })
        .number(value, |(_, c)| digits(c).one(c.value))
        .when(is_extended, |rows| {
            rows.number("change, σ", |(_, c)| {
                let is_biased = change(c).is_some_and(|c| c.abs() > BIASED);
                Cell::from(change(c).map(standard_errors)).doubtful_if(is_biased)
            })
        })
        .number("standard error", |(_, c)| digits(c).one(c.std_error))
        .plain("unit", |(_, c)| unit(&c.unit))
        .when(is_extended, |rows| {
            rows.plain("", |(_, c)| match c.before {
                Some(_) => Html::new(),
                None => Html::tag("added"),
            })
        })
        .table();
    let mut content = Html::new();
    content.table(&table);
    if is_extended {
        content.note(
            "The change is in standard errors of the extended fit. A missing effect biases the other coefficients \
             (omitted-variable bias) while their standard errors stay small; changes above 3 are marked.",
        );
    }
    content
}

/// Number of effects that are not identifiable above which their table is folded.
const MAX_OPEN: usize = 12;

fn limits(report: &Report) -> Html {
    let mut content = Html::new();
    let hidden = &report.not_identifiable;
    if hidden.is_empty() {
        content.paragraph("Every tested effect is identifiable, if it is large enough.");
    } else {
        content.paragraph(
            "These flights cannot show whether the following effects act: they are not identifiable, being confounded \
             with others.",
        );
        let table = not_identifiable(report);
        let mut shown = Html::new();
        shown.table(&table);
        if table.len() > MAX_OPEN {
            content.folded(format!("{} effects", table.len()), shown);
        } else {
            content.push(shown);
        }
    }
    let table = Table::of(report.minimum_detectable_effects.iter().take(MAX_ROWS))
        .name("effect", |effect| &effect.name)
        .plain("coefficient", |effect| &effect.coefficient)
        .number("minimum", |effect| significant(effect.value, 2))
        .plain("unit", |effect| unit(&effect.unit))
        .table();
    let mut detectable = Html::new();
    detectable.table(&table);
    if !detectable.is_empty() {
        detectable.note(
            "The size at which the score test is significant with a probability of 0.9 in these flights.",
        );
    }
    content.folded("Minimum detectable effects", detectable);
    content
}

pub(super) fn not_identifiable(report: &Report) -> Table {
    let by = |effect: &NotIdentifiable| match names(&effect.confounded_with).as_str() {
        "" => "nothing: it has no influence in these flights".to_owned(),
        names => names.to_owned(),
    };
    Table::of(report.not_identifiable.iter().take(MAX_ROWS))
        .name("effect", |effect| &effect.name)
        .text("confounded with", |effect| by(effect))
        .table()
}

fn terms(terms: &[StepwiseTerm]) -> Table {
    let digits = |term: &StepwiseTerm| Digits::of(term.value, term.std_error);
    Table::of(terms.iter().take(MAX_ROWS))
        .code("term", |term| &term.formula)
        .plain("acts on", |term| words::site(&term.site))
        .number("χ²", |term| significant(term.score_chi2, 4))
        .number("coefficient", |term| digits(term).one(term.value))
        .number("standard error", |term| digits(term).one(term.std_error))
        .plain("", |term| {
            if term.selected {
                Html::tag("selected")
            } else {
                Html::default()
            }
        })
        .table()
}
