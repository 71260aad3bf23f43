//! HTML page of a fit.

use dataset::Role;
use identify::FitReport;
use identify::wording::count;
use model_spec::sort_by_number;

use super::{Figures, FitPage, coefficients, flights, words};
use crate::figure::Figure;
use crate::html::Html;
use crate::page::{Page, heading, watch};
use crate::table::Table;
use crate::thin::{MAX_FLIGHTS, MAX_ROWS};
use identify::numbers::{percent, plain, quantity};
use identify::wording::{durations, names, sentence};

/// Number of flights whose figures of the states over time are expanded when the page is opened.
const OPEN: usize = 3;
/// Number of flights whose figures of marker paths are expanded when the page is opened.
const OPEN_TRACKS: usize = 6;
/// Maximum number of non-identifiable directions that the summary names.
const MAX_NAMED: usize = 3;

/// Renders the HTML page of the report of a fit with the given figures.
pub(super) fn written(page: &FitPage<'_>, figures: &Figures) -> String {
    let report = page.report;
    let mut body = Html::new();
    if !report.reliable {
        body.unreliable(&report.cautions, "fit");
    }
    body.push(summary(page, figures));
    body.data_faults(&report.data_faults);
    body.section("coefficients", "Coefficients", coefficients::section(page));
    body.section("undetermined", "Not identifiable", undetermined(report));
    body.push(evidence(page, figures));
    body.section(
        "flights",
        "Flights",
        flights::section(page, figures.histogram.as_ref()),
    );
    body.section("noise", "Noise", noise(report));
    body.section("how", "How it was computed", how(report));
    Page {
        kind: "hyzer fit",
        title: format!("{} fitted to {}", report.model, page.dataset),
        heading: heading(&report.model, "fitted to", page.dataset),
        body,
    }
    .html()
}

fn summary(page: &FitPage<'_>, figures: &Figures) -> Html {
    let report = page.report;
    let mut lead = Html::new();
    for (i, text) in words::opening(page).into_iter().enumerate() {
        lead.element("p", if i == 0 { "finding" } else { "" }, text);
    }
    for text in words::summary(page) {
        lead.element("p", "", text);
    }
    let unknown = report.not_identifiable.iter();
    let mut unknown = unknown.map(|u| names(&u.combination));
    let named: Vec<String> = unknown.by_ref().take(MAX_NAMED).collect();
    if !named.is_empty() {
        let more = if unknown.next().is_some() {
            ", and more"
        } else {
            ""
        };
        let mut text = Html::from("Not identifiable from these flights: ");
        for (i, names) in named.iter().enumerate() {
            text.push(if i == 0 { "" } else { "; " });
            text.push(names);
            text.push(" (");
            text.push(Html::link("#undetermined", "why"));
            text.push(")");
        }
        lead.element("p", "", text.then(more).then("."));
    }
    let alarms = words::alarms(page);
    if alarms.is_empty() && report.cautions.is_empty() {
        lead.element("p", "calm", words::NO_WARNINGS);
    }
    lead.alarms("Warnings", alarms);
    lead.element("p", "", watch());
    let mut picture = Html::new();
    let precision = figures.precision.clone().map(Figure::reachable);
    picture.figures(&precision, true);
    let mut opening = Html::from("\n");
    opening.element("div", "words lead", Html::from("\n").then(lead));
    opening.element("div", "picture", picture);
    let mut section = Html::new();
    section.element_with_id("section", "summary", "opening", opening);
    section
}

/// Non-identifiable directions in parameter space.
fn undetermined(report: &FitReport) -> Html {
    let mut content = Html::new();
    let found = report.not_identifiable.iter().take(MAX_ROWS);
    let items = found.map(|u| {
        let mut text = Html::strong(names(&u.combination));
        text.push(format!(": {}", sentence(&u.reason)));
        let direction = direction(u.weights.iter().map(|(name, weight)| (name, *weight)));
        if let Some(direction) = direction {
            text.push(format!(
                " The direction is {direction}, each divided by its typical magnitude."
            ));
        }
        text.then(format!(
            " Along it the standard error is {} of the typical magnitude.",
            percent(u.relative_error)
        ))
    });
    content.list("words", items);
    content
}

/// Linear combination of coefficients, such as `0.71 C_L0 − 0.70 C_La`; `None` for a single coefficient.
fn direction<'a>(weights: impl Iterator<Item = (&'a String, f64)>) -> Option<String> {
    let mut weights: Vec<_> = weights.collect();
    weights.retain(|(_, w)| w.is_finite() && w.abs() >= 0.05);
    sort_by_number(&mut weights, |weight| -weight.1.abs());
    weights.truncate(8);
    let mut direction = String::new();
    for (i, (name, weight)) in weights.iter().enumerate() {
        direction += match (i, *weight < 0.0) {
            (0, false) => "",
            (0, true) => "−",
            (_, false) => " + ",
            (_, true) => " − ",
        };
        direction += &format!("{} {name}", plain(weight.abs(), 2));
    }
    (weights.len() > 1).then_some(direction)
}

/// Sections of figures.
fn evidence(page: &FitPage<'_>, figures: &Figures) -> Html {
    let all = figures.correlations.iter().chain(&figures.whiteness);
    let has_checks = all.count() > 0;
    let section = |figures: &[Figure], open: usize, note: &str, captioned: bool| {
        let mut content = Html::new();
        if !figures.is_empty() {
            content.note(note);
        }
        content.grid(figures, open, captioned);
        content
    };
    let caption = |figures: &[Figure]| figures.first().map_or("", |f| &f.caption).to_owned();
    let report = page.report;
    let flights = report
        .used(Role::Fit)
        .chain(report.used(Role::HeldOut))
        .count();
    let drawn = figures.tracks.len();
    let mut tracks = caption(&figures.tracks);
    if flights > drawn {
        tracks += &format!(" {drawn} of {flights} flights are drawn, here and below.");
    }
    let mut body = Html::new();
    let profiles = section(&figures.profiles, MAX_FLIGHTS, words::PROFILES, true);
    body.section("profiles", "Profile likelihoods", profiles);
    let predictions = caption(&figures.predictions);
    let predictions = section(&figures.predictions, MAX_FLIGHTS, &predictions, false);
    body.section("predictions", words::PREDICTIONS, predictions);
    let tracks = section(&figures.tracks, OPEN_TRACKS, &tracks, false);
    body.section("tracks", "Measured and predicted", tracks);
    let mut residuals = Html::new();
    residuals.figures(&figures.residuals, true);
    body.section("residuals", words::RESIDUALS, residuals);
    let states = section(&figures.states, OPEN, words::STATES, false);
    body.section("states", "States over time", states);
    if has_checks {
        let mut grid = Html::from("\n");
        grid.figures(&figures.whiteness, false);
        grid.figures(figures.correlations.iter(), true);
        let mut content = Html::new();
        if !figures.whiteness.is_empty() {
            content.note(caption(&figures.whiteness));
        }
        content.element("div", "grid", grid);
        body.section("checks", "Residual diagnostics", content);
    }
    body
}

fn noise(report: &FitReport) -> Html {
    let mut content = Html::new();
    content.table(&noise_table(report));
    content.note(words::noise(report));
    for sensor in words::sensors(report) {
        content.note(sensor);
    }
    content
}

/// Table of the measurement noise: one row for each axis, then one for all axes together.
pub(super) fn noise_table(report: &FitReport) -> Table {
    let noise = report.leading_noise();
    let axes = noise.axes.iter().take(3);
    let axes = axes.map(|(axis, n)| (axis.as_str(), n.sigma, n.lag1_autocorrelation));
    let all = ("all", noise.sigma, noise.lag1_autocorrelation);
    Table::of(axes.chain([all]))
        .name("axis", |row| row.0)
        .number("standard deviation", |row| quantity(row.1, &noise.unit))
        .number("lag-1 autocorrelation", |row| plain(row.2, 2))
        .number("correlation time", |row| {
            correlation_time(row.2, noise.interval_s)
        })
        .table()
}

/// Lag at which the autocorrelation of the noise has fallen to 1/e; `–` if the noise is nearly uncorrelated.
fn correlation_time(ar1: f64, interval: f64) -> String {
    let time = -interval / ar1.ln();
    if ar1 > 0.05 && time.is_finite() {
        format!("{} ms", plain(1e3 * time, 1))
    } else {
        "–".to_owned()
    }
}

fn how(report: &FitReport) -> Html {
    let iterations = &report.iterations;
    let weights = if report.leading_noise().estimated {
        format!(
            "which was estimated with them ({})",
            count(iterations.rounds, "time")
        )
    } else {
        "which the dataset gives".to_owned()
    };
    let outcome = if iterations.converged {
        "converged"
    } else {
        "did not converge"
    };
    let mut content = Html::new();
    content.paragraph(format!(
        "Output-error method: the markers of each flight are predicted by integrating the model from an initial state \
         of that flight; coefficients and initial states minimise the sum of squared residuals, weighted by the noise \
         above, {weights}. The iteration took {} and {outcome}. Standard errors follow from the linearised model at \
         the solution; the intervals have a coverage of 95 % if the model is correct.",
        count(iterations.steps, "step"),
    ));
    let mut facts = vec![
        format!("Schema {}", report.schema),
        format!("hyzer {}", env!("CARGO_PKG_VERSION")),
    ];
    if !report.effects.is_empty() {
        facts.push(format!("effects: {}", names(&report.effects)));
    }
    let seconds = durations(&report.seconds);
    if !seconds.is_empty() {
        facts.push(format!("time: {seconds}"));
    }
    content.note(format!(
        "SI units unless stated otherwise. {}. The numbers are in report.json, coefficients.csv and flights.csv.",
        facts.join("; ")
    ));
    content
}
