//! Page of a fit.
use std::collections::BTreeMap;

use dataset::Role;
use identify::FitReport;
use identify::numbers::{percent, plain, quantity};
use identify::wording::{count, durations, names, sentence};
use model_spec::sort_by_number;

use super::{FitPage, coefficients, draw, flights, words};
use crate::figure::Figure;
use crate::html::Html;
use crate::page::{Page, heading, watch};
use crate::table::Table;
use crate::thin::{MAX_FLIGHTS, MAX_ROWS};

/// Number of figures of states over time that are open.
const OPEN: usize = 3;
/// Number of figures of marker paths that are open.
const OPEN_TRACKS: usize = 6;
const MAX_NAMED: usize = 3;

/// The page of the report of a fit.
pub fn page(page: &FitPage<'_>) -> Page {
    let report = page.report;
    let mut body = Html::new();
    if !report.reliable {
        body.unreliable(&report.cautions, "fit");
    }
    body.push(summary(page));
    body.data_faults(&report.data_faults);
    body.section("coefficients", "Coefficients", coefficients::section(page));
    body.section("undetermined", "Not identifiable", undetermined(report));
    body.push(evidence(page));
    body.section("flights", "Flights", flights::section(page));
    body.section("noise", "Noise", noise(report));
    body.section("how", "How it was computed", how(report));
    Page {
        kind: "hyzer fit",
        title: format!("{} fitted to {}", report.model, page.dataset),
        heading: heading(&report.model, "fitted to", page.dataset),
        body,
    }
}

fn summary(page: &FitPage<'_>) -> Html {
    let report = page.report;
    let mut lead = Html::new();
    let (opening, summary) = (words::opening(page), words::summary(page));
    for (i, text) in opening.iter().enumerate() {
        lead.element("p", if i == 0 { "finding" } else { "" }, text);
    }
    for text in summary {
        lead.element("p", "", text);
    }
    let unknown = report.not_identifiable.iter();
    let mut unknown = unknown.map(|u| names(&u.combination));
    let named: Vec<String> = unknown.by_ref().take(MAX_NAMED).collect();
    if !named.is_empty() {
        let has_more = unknown.next().is_some();
        let more = if has_more { ", and more" } else { "" };
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
    picture.leading_figure(draw::precision(page));
    let mut opening = Html::from("\n");
    opening.element("div", "words lead", Html::from("\n").then(lead));
    opening.element("div", "picture", picture);
    let mut section = Html::new();
    section.element_with_id("section", "summary", "opening", opening);
    section
}

fn undetermined(report: &FitReport) -> Html {
    let mut content = Html::new();
    let found = report.not_identifiable.iter().take(MAX_ROWS);
    let items = found.map(|u| {
        let mut text = Html::strong(names(&u.combination));
        text.push(format!(": {}", sentence(&u.reason)));
        if let Some(direction) = direction(&u.weights) {
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
fn direction(weights: &BTreeMap<String, f64>) -> Option<String> {
    let mut weights: Vec<(&String, f64)> = weights.iter().map(|(n, w)| (n, *w)).collect();
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

fn evidence(page: &FitPage<'_>) -> Html {
    let caption = |figures: &[Figure]| figures.first().map_or("", |f| &f.caption).to_owned();
    let section = |figures: Vec<Figure>, open: usize, note: &str, captioned: bool| {
        let mut content = Html::new();
        if !figures.is_empty() {
            content.note(note);
        }
        content.grid(figures, open, captioned);
        content
    };
    let report = page.report;
    let mut body = Html::new();
    let profiles = draw::profiles(report);
    let profiles = section(profiles, MAX_FLIGHTS, words::PROFILES, true);
    body.section("profiles", "Profile likelihoods", profiles);
    let predictions = page
        .fit
        .map(|fit| draw::predictions(fit, page.evidence, &[]));
    let predictions = predictions.unwrap_or_default();
    let note = caption(&predictions);
    let predictions = section(predictions, MAX_FLIGHTS, &note, false);
    body.section("predictions", words::PREDICTIONS, predictions);
    let tracks = draw::tracks(page.evidence);
    let flights = report.used(Role::Fit).count() + report.used(Role::HeldOut).count();
    let (drawn, mut note) = (tracks.len(), caption(&tracks));
    if flights > drawn {
        note += &format!(" {drawn} of {flights} flights are drawn, here and below.");
    }
    let tracks = section(tracks, OPEN_TRACKS, &note, false);
    body.section("tracks", "Measured and predicted", tracks);
    let mut residuals = Html::new();
    residuals.figures(
        draw::residuals(page.evidence, &[], report.leading_noise()),
        true,
    );
    body.section("residuals-over-time", words::RESIDUALS, residuals);
    let states = draw::states(page.evidence, page.model);
    let states = section(states, OPEN, words::STATES, false);
    body.section("states", "States over time", states);
    let whiteness = draw::whiteness(report);
    let (mut checks, mut grid) = (Html::new(), Html::from("\n"));
    if !whiteness.is_empty() {
        checks.note(caption(&whiteness));
    }
    grid.figures(whiteness, false);
    grid.figures(draw::correlations(page), true);
    if !grid.figures.is_empty() {
        checks.element("div", "grid", grid);
    }
    body.section("checks", "Residual diagnostics", checks);
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

/// Table of the measurement noise: a row for each axis, and one for all.
pub(super) fn noise_table(report: &FitReport) -> Table {
    let noise = report.leading_noise();
    if super::summaries::only(report) {
        return Table::default();
    }
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

/// Lag at which the autocorrelation has fallen to 1/e; `–` if there is nearly none.
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
    let converged = iterations.converged;
    let outcome = if converged {
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
