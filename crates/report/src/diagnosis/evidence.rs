//! Evidence of a diagnosis: score tests, predictions, residuals, coefficient curves, and the flights one by one.
use dataset::Role;
use diagnose::{CandidateTest, FlightGain, LackOfFit, Report};
use identify::SmoothMisfit;
use identify::numbers::{
    equivalent_z, percent, plain, probability, probability_of_ln, quantity, significant,
};
use identify::wording::{count, names, short};

use super::{DiagnosisPage, OPEN, draw, words};
use crate::figure::Figure;
use crate::fit::draw::{inputs, residuals};
use crate::fit::words::{PREDICTIONS, RESIDUALS};
use crate::html::Html;
use crate::page::flight_link;
use crate::table::{Cell, Table};
use crate::thin::{MAX_ROWS, largest_first};

const MAX_ESTIMATES: usize = 6;

pub(super) fn section(page: &DiagnosisPage<'_>) -> Html {
    let report = page.report;
    let mut content = Html::new();
    score_tests(&mut content, report);
    let predictions = draw::held_out(page);
    if let Some(first) = predictions.first() {
        content.heading(PREDICTIONS);
        content.note(&first.caption);
        content.grid(predictions, usize::MAX, false);
    }
    let residuals = residuals(page.before, page.after, report.leading_noise());
    if !residuals.is_empty() {
        content.heading(RESIDUALS);
        content.figures(residuals, true);
    }
    let inputs = inputs(page.before);
    if let Some(first) = inputs.first() {
        content.heading("Inputs over time");
        content.note(&first.caption);
        content.grid(inputs, OPEN, false);
    }
    let curves = draw::curves(report);
    if content.is_empty() && curves.is_empty() && report.flights.is_empty() {
        return content;
    }
    let test = report.lack_of_fit.as_ref();
    if let Some(test) = test.filter(|test| !test.largest_misfits.is_empty()) {
        let title = "Lack of fit: where the residuals are not noise";
        content.element_with_id("h3", "lack-of-fit", "", title);
        content.table(&misfits(test));
    }
    if !curves.is_empty() {
        let unchanged = match names(&draw::unmoved(page)).as_str() {
            "" => String::new(),
            names => format!("Unchanged by the extension: {names}. "),
        };
        content.heading("Coefficient curves of the model");
        content.note(format!(
            "{unchanged}Medians of the flights’ samples; where there are few samples, a curve is mostly an extrapolation."
        ));
        content.grid(curves, OPEN, false);
    }
    if !report.flights.is_empty() {
        content.heading("Flight by flight");
        content.grid(draw::flights(report).into_iter().collect(), 1, true);
        let all = report.flights.len();
        let mut worst = String::new();
        if all > MAX_ROWS {
            worst = format!("The worst {MAX_ROWS} of ");
        }
        let mut table = Html::new();
        table.table(&flights(page, &content.figures));
        content.folded(format!("{worst}{} in numbers", count(all, "flight")), table);
    }
    content
}

/// Figures and table of the score tests; the figures are folded if the explanations account for them.
fn score_tests(content: &mut Html, report: &Report) {
    let tested = count(report.tests.len(), "effect");
    let alarms = report.tests.iter().filter(|c| c.significant).count();
    let shown = draw::score_tests(report).into_iter();
    let shown = shown.chain(draw::score_correlations(report));
    let mut drawn = Html::new();
    drawn.figures(shown, true);
    if !drawn.is_empty() {
        let mut two = Html::new();
        two.element("div", "two", Html::from("\n").then(drawn));
        let accounts = match report.explanations.len() {
            1 => "the explanation accounts",
            _ => "each explanation accounts",
        };
        if report.explanations.is_empty() || alarms == 0 {
            content.push(two);
        } else {
            let summary = format!(
                "{alarms} of {tested} are significant when tested alone; {accounts} for the others"
            );
            content.folded(summary, two);
        }
    }
    let mut table = Html::new();
    table.table(&scores(report));
    if !table.is_empty() {
        table.note(
            "* significant. z is the standard normal quantile of equal p. The tolerance is the identifiable fraction of the effect: the \
             part of its squared signature in the measurements that no estimated coefficient is confounded with; d.o.f. \
             counts its identifiable directions.",
        );
    }
    let summary = format!("Score tests of {tested}, {alarms} significant");
    content.folded(summary, table);
}

pub(super) fn scores(report: &Report) -> Table {
    let estimates = |test: &CandidateTest| {
        let estimates = test.one_step_estimates.iter().take(MAX_ESTIMATES);
        let estimates = estimates.map(|(name, estimate)| estimate.text(name));
        estimates.collect::<Vec<_>>().join("; ")
    };
    let mark = |test: &CandidateTest| if test.significant { " *" } else { "" };
    Table::of(report.tests.iter().take(MAX_ROWS))
        .name("effect", |test| format!("{}{}", test.name, mark(test)))
        .number("z", |test| equivalent_z(test.z))
        .number("χ²", |test| significant(test.score_chi2, 4))
        .number("d.o.f.", |test| test.degrees_of_freedom)
        .number("p", |test| probability_of_ln(test.ln_p_value))
        .number("tolerance", |test| percent(test.tolerance))
        .plain("acts on", |test| words::site(&test.site))
        .detail("one-step estimate", |test| estimates(test))
        .detail("meaning", |test| test.description.replace('\n', " "))
        .table()
}

fn misfits(test: &LackOfFit) -> Table {
    let size = |misfit: &SmoothMisfit| quantity(misfit.size_m, &misfit.unit);
    Table::of(test.largest_misfits.iter().take(MAX_ROWS))
        .file("flight", |misfit| &misfit.file)
        .plain("coordinate", |misfit| &misfit.coordinate)
        .number("from, s", |misfit| plain(misfit.from_s, 2))
        .number("to, s", |misfit| plain(misfit.to_s, 2))
        .number("largest departure", |misfit| size(misfit))
        .number("p", |misfit| probability(misfit.p_value))
        .table()
}

/// Table of the flights, the worst first if there are more than [`MAX_ROWS`].
fn flights(page: &DiagnosisPage<'_>, figures: &[Figure]) -> Table {
    let report = page.report;
    let all: Vec<&FlightGain> = report.flights.iter().collect();
    let all = largest_first(all, MAX_ROWS, |flight| flight.rms_before_m);
    let tested = report.lack_of_fit.as_ref().map(|test| &test.flights);
    let p = |flight: &FlightGain| tested?.get(&flight.file).copied();
    let gain = |flight: &FlightGain| Some(flight.rms_before_m? - flight.rms_after_m?);
    let rms = |value: f64| quantity(value, &report.leading_noise().unit);
    Table::of(all.into_iter().take(MAX_ROWS))
        .file("flight", |flight| links(page, figures, &flight.file))
        .number("rms before", |flight| flight.rms_before_m.map(rms))
        .number("rms extended", |flight| flight.rms_after_m.map(rms))
        .number("gain", |flight| {
            let is_loss = gain(flight).is_some_and(|gain| gain < 0.0);
            Cell::from(gain(flight).map(rms)).doubtful_if(is_loss)
        })
        .number("lack of fit, p", |flight| p(flight).map(probability))
        .text("", |flight| remarks(report, flight))
        .table()
}

fn links(page: &DiagnosisPage<'_>, figures: &[Figure], file: &str) -> Html {
    let is_extended = !page.after.is_empty();
    let by = if is_extended { " · extended" } else { "" };
    let mut links = flight_link(&format!("{file}{by}"), file);
    for figure in figures.iter().filter(|f| f.title == file) {
        links.push(" ");
        links.push(Html::link(&format!("#{}", figure.name), "prediction"));
    }
    links
}

/// Whether a flight is held out, set apart or excluded.
fn remarks(report: &Report, flight: &FlightGain) -> Html {
    let mut remarks = Html::new();
    if flight.role == Role::HeldOut {
        remarks.push(Html::tag("held out").then(" "));
    }
    let mut gain = report.predictive_gain.iter();
    if gain.any(|gain| gain.set_apart.contains(&flight.file)) {
        remarks.push(Html::warning_tag("set apart").then(" "));
    }
    if let Some(reason) = flight.outcome.reason() {
        remarks.push(Html::warning_tag("excluded").then(" ").then(short(reason)));
    }
    remarks
}
