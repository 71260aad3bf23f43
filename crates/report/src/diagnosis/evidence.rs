//! Evidence of a diagnosis: score tests, predictions, residuals, coefficient curves, and the flights one by one.

use dataset::Role;
use diagnose::{FlightGain, LackOfFit, Report};
use identify::wording::count;
use model_spec::sort_by_number;

use super::draw::{Figures, unmoved};
use super::{DiagnosisPage, MAX_ROWS, OPEN, words};
use crate::fit::words::{PREDICTIONS, RESIDUALS};
use crate::html::Html;
use crate::page::flight_link;
use crate::table::{Cell, Column, Table};
use identify::numbers::{
    equivalent_z, millimetres, percent, plain, probability, probability_of_ln, significant,
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
    use Column::{Detail, Name, Number, Plain};
    let mut table = Table::new()
        .with(Name, &["effect"])
        .with(Number, &["z", "χ²", "d.o.f.", "p", "tolerance"])
        .with(Plain, &["acts on"])
        .with(Detail, &["one-step estimate", "meaning"]);
    for test in report.tests.iter().take(MAX_ROWS) {
        let estimates = test.one_step_estimates.iter().take(MAX_ESTIMATES);
        let estimates = estimates.map(|(name, estimate)| estimate.text(name));
        let mark = if test.significant { " *" } else { "" };
        table.row([
            format!("{}{mark}", test.name).into(),
            equivalent_z(test.z).into(),
            significant(test.score_chi2, 4).into(),
            test.degrees_of_freedom.to_string().into(),
            probability_of_ln(test.ln_p_value).into(),
            percent(test.tolerance).into(),
            words::site(&test.site).into(),
            estimates.collect::<Vec<_>>().join("; ").into(),
            test.description.replace('\n', " ").into(),
        ]);
    }
    table
}

/// Table of the largest smooth deviations of the residuals from zero, smallest p-value first.
fn misfits(test: &LackOfFit) -> Table {
    use Column::{File, Number, Plain};
    let mut table = Table::new()
        .with(File, &["flight"])
        .with(Plain, &["coordinate"])
        .with(Number, &["from, s", "to, s", "largest departure", "p"]);
    for misfit in test.largest_misfits.iter().take(MAX_ROWS) {
        let size = match misfit.unit.as_str() {
            "" | "m" => millimetres(misfit.size_m),
            unit => format!("{} {unit}", significant(misfit.size_m, 3)),
        };
        table.row([
            (&misfit.file).into(),
            (&misfit.coordinate).into(),
            plain(misfit.from_s, 2).into(),
            plain(misfit.to_s, 2).into(),
            size.into(),
            probability(misfit.p_value).into(),
        ]);
    }
    table
}

/// Table of the flights, in dataset order. If there are more than [`MAX_ROWS`], only the flights with the largest RMS
/// residuals, in descending order.
fn flights(page: &DiagnosisPage<'_>, figures: &Figures) -> Table {
    use Column::{File, Number, Text};
    let report = page.report;
    let mut all: Vec<&FlightGain> = report.flights.iter().collect();
    if all.len() > MAX_ROWS {
        let size = |f: &FlightGain| match f.rms_before_m {
            Some(rms) if rms.is_nan() => f64::INFINITY,
            Some(rms) => rms,
            None => f64::NEG_INFINITY,
        };
        sort_by_number(&mut all, |flight| -size(flight));
        all.truncate(MAX_ROWS);
    }
    let tested = report.lack_of_fit.as_ref().map(|test| &test.flights);
    let length = |rms: Option<f64>| Cell::from(rms.map_or("–".to_owned(), millimetres));
    let mut table = Table::new()
        .with(File, &["flight"])
        .with(
            Number,
            &["rms before", "rms extended", "gain", "lack of fit, p"],
        )
        .with(Text, &[""]);
    for flight in all {
        let gain = flight.rms_before_m.zip(flight.rms_after_m);
        let gain = gain.map(|(before, after)| before - after);
        let p = tested.and_then(|tested| tested.get(&flight.file));
        table.row([
            links(page, figures, &flight.file).into(),
            length(flight.rms_before_m),
            length(flight.rms_after_m),
            length(gain).doubtful_if(gain.is_some_and(|gain| gain < 0.0)),
            p.map_or("–".to_owned(), |p| probability(*p)).into(),
            remarks(report, flight).into(),
        ]);
    }
    table
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
