//! Evidence of a diagnosis: score tests, predictions, residuals, coefficient curves, and the flights one by one.

use dataset::Role;
use diagnose::{CandidateTest, FlightGain, LackOfFit, Report};
use identify::SmoothMisfit;
use identify::wording::count;

use super::draw::{Figures, unmoved};
use super::{DiagnosisPage, OPEN, words};
use crate::fit::words::{PREDICTIONS, RESIDUALS};
use crate::html::Html;
use crate::page::flight_link;
use crate::table::{Cell, Table};
use crate::thin::{MAX_ROWS, largest_first};
use identify::numbers::{
    equivalent_z, millimetres, percent, plain, probability, probability_of_ln, quantity,
    significant,
};
use identify::wording::{names, short};

/// Maximum number of one-step estimates that a row of the table of score tests shows.
const MAX_ESTIMATES: usize = 6;

/// The section's content; empty without evidence.
pub(super) fn section(page: &DiagnosisPage<'_>, figures: &Figures) -> Html {
    let report = page.report;
    let mut content = Html::new();
    score_tests(&mut content, report, figures);
    if let Some(first) = figures.predictions.first() {
        content.heading(PREDICTIONS);
        content.note(&first.caption);
        content.grid(&figures.predictions, usize::MAX, false);
    }
    if !figures.residuals.is_empty() {
        content.heading(RESIDUALS);
        content.figures(&figures.residuals, true);
    }
    if content.is_empty() && figures.curves.is_empty() && report.flights.is_empty() {
        return content;
    }
    if let Some(test) = report
        .lack_of_fit
        .as_ref()
        .filter(|t| !t.largest_misfits.is_empty())
    {
        let title = "Lack of fit: where the residuals are not noise";
        content.element_with_id("h3", "lack-of-fit", "", title);
        content.table(&misfits(test));
    }
    if !figures.curves.is_empty() {
        let unchanged = match names(&unmoved(page)).as_str() {
            "" => String::new(),
            names => format!("Unchanged by the extension: {names}. "),
        };
        content.heading("Coefficient curves of the model");
        content.note(format!(
            "{unchanged}Medians of the flights’ samples; where there are few samples, a curve is mostly an extrapolation."
        ));
        content.grid(&figures.curves, OPEN, false);
    }
    if !report.flights.is_empty() {
        content.heading("Flight by flight");
        content.grid(figures.flights.clone().as_slice(), 1, true);
        let all = report.flights.len();
        let worst = if all > MAX_ROWS {
            format!("The worst {MAX_ROWS} of ")
        } else {
            String::new()
        };
        let mut table = Html::new();
        table.table(&flights(page, figures));
        content.folded(format!("{worst}{} in numbers", count(all, "flight")), table);
    }
    content
}

/// Figures and table of the score tests; the figures are folded if the explanations account for the significant tests.
fn score_tests(content: &mut Html, report: &Report, figures: &Figures) {
    let tested = count(report.tests.len(), "effect");
    let alarms = report.tests.iter().filter(|c| c.significant).count();
    let shown = figures
        .score_tests
        .iter()
        .chain(&figures.score_correlations);
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
            content.folded(
                format!("{alarms} of {tested} are significant when tested alone; {accounts} for the others"),
                two,
            );
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
    content.folded(
        format!("Score tests of {tested}, {alarms} significant"),
        table,
    );
}

/// Table of the score tests of candidate effects, in the order of the report: the most significant candidate first.
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

/// Table of the largest smooth deviations of the residuals from zero, smallest p-value first.
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

/// Table of the flights, in dataset order. If there are more than [`MAX_ROWS`], only the flights with the largest RMS
/// residuals, in descending order.
fn flights(page: &DiagnosisPage<'_>, figures: &Figures) -> Table {
    let report = page.report;
    let all: Vec<&FlightGain> = report.flights.iter().collect();
    let all = largest_first(all, MAX_ROWS, |flight| flight.rms_before_m);
    let tested = report.lack_of_fit.as_ref().map(|test| &test.flights);
    let p = |flight: &FlightGain| tested?.get(&flight.file).copied();
    let gain = |flight: &FlightGain| Some(flight.rms_before_m? - flight.rms_after_m?);
    Table::of(all.into_iter().take(MAX_ROWS))
        .file("flight", |flight| links(page, figures, &flight.file))
        .number("rms before", |flight| flight.rms_before_m.map(millimetres))
        .number("rms extended", |flight| flight.rms_after_m.map(millimetres))
        .number("gain", |flight| {
            let is_loss = gain(flight).is_some_and(|gain| gain < 0.0);
            Cell::from(gain(flight).map(millimetres)).doubtful_if(is_loss)
        })
        .number("lack of fit, p", |flight| p(flight).map(probability))
        .text("", |flight| remarks(report, flight))
        .table()
}

/// Links to the flight in three dimensions and to the figure of its prediction.
fn links(page: &DiagnosisPage<'_>, figures: &Figures, file: &str) -> Html {
    let by = if page.after.is_empty() {
        ""
    } else {
        " · extended"
    };
    let mut links = flight_link(&format!("{file}{by}"), file);
    for figure in figures.predictions.iter().filter(|f| f.title == file) {
        links.push(" ");
        links.push(Html::link(&format!("#{}", figure.name), "prediction"));
    }
    links
}

/// Remarks on a flight: whether it is held out, left out of the comparison of prediction errors, or excluded.
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
