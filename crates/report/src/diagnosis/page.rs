//! HTML page of a diagnosis, rendered from a template.

use dataset::Role;
use diagnose::{Report, Verified};
use identify::wording::count;
use minijinja::context;
use minijinja::value::Value;

use super::draw::{self, Figures};
use super::finding::Finding;
use super::{DiagnosisPage, coefficients, explanations, limits, words};
use crate::data_faults;
use crate::figures::svg::STYLE;
use crate::fit::Drawn;
use crate::fit::flights::short;
use crate::fit::page::{capitalized, one, plain_values, reached, rendered, sentence, shown};
use crate::fit::words::names;
use crate::numbers::{millimetres, percent, plain};

/// Maximum number of characters of the extended model's text shown in the HTML report.
const MAX_TEXT: usize = 60_000;
/// Maximum number of notes shown in the HTML report of a diagnosis. The same maximum applies to the list of
/// verification checks of the extended model.
const MAX_NOTES: usize = 40;
/// Maximum number of figures of the loads that the model lacks (one for each force or moment component) that are
/// expanded when the page is opened. The same maximum applies to figures of coefficient curves.
const OPEN: usize = 6;

/// Renders the self-contained HTML page of the diagnosis.
pub(super) fn html(page: &DiagnosisPage<'_>, finding: &Finding, figures: &Figures) -> String {
    let report = page.report;
    let (curves, more_curves) = split(&figures.curves);
    let (channels, more_channels) = split(&figures.channels);
    let seconds = report.seconds.iter().filter(|(_, s)| s.is_finite());
    let seconds: Vec<String> = seconds
        .map(|(what, s)| format!("{what} {} s", plain(*s, 2)))
        .collect();
    let notes: Vec<String> = report
        .notes
        .iter()
        .take(MAX_NOTES)
        .map(|n| sentence(n))
        .collect();
    let reasons = page.report.cautions.iter();
    let cautions: Vec<String> = reasons.map(|reason| capitalized(reason)).collect();
    let number = |role| report.flights.iter().filter(|f| f.role == role).count();
    let looked_for = report.tests.len();
    let alarms = report.tests.iter().filter(|c| c.significant).count();
    let unattributed = report.unattributed.as_ref();
    let context = context! {
        css => Value::from_safe_string(include_str!("../fit/page.css").to_owned() + include_str!("page.css")),
        style => Value::from_safe_string(STYLE.to_owned() + draw::STYLE),
        model => &report.model,
        dataset => &report.dataset,
        effects => names(&report.effects),
        kind => words::verdict_name(report.verdict),
        verdict => words::verdict(report),
        summary => report.summary.trim(),
        finding => plain_values(finding),
        finding_figure => figures.finding.iter().map(|f| one(&reached(f))).collect::<Vec<_>>(),
        gain => words::gain(report),
        paired => report.predictive_gain.as_ref().and_then(words::paired),
        lack_of_fit => report.lack_of_fit.as_ref().map(|test| plain_values(&limits::lack_of_fit(test))),
        notes => plain_values(&notes),
        cautions => plain_values(&cautions),
        faults => plain_values(&data_faults::table(&report.data_faults)),
        gain_figure => figures.gain.iter().map(|f| one(&reached(f))).collect::<Vec<_>>(),
        explanations => plain_values(&explanations::explanations(page)),
        more_explanations => report.explanations.len().saturating_sub(explanations::MAX_EXPLANATIONS),
        throw => report.proposed_throw.as_ref().map(|t| plain_values(&explanations::throw(t))),
        candidates => figures.score_tests.iter().map(one).collect::<Vec<_>>(),
        score_correlations => figures.score_correlations.iter().map(one).collect::<Vec<_>>(),
        scores => plain_values(&limits::scores(report)),
        looked_for => count(looked_for, "effect"),
        alarms,
        predictions => shown(&figures.predictions),
        residuals => shown(&figures.residuals),
        curves => shown(curves),
        more_curves => shown(more_curves),
        unmoved => names(&draw::unmoved(page)),
        flights_figure => figures.flights.iter().map(one).collect::<Vec<_>>(),
        flights => plain_values(&limits::flights(report)),
        shown_by => if page.after.is_empty() { "" } else { " · extended" },
        fitted => number(Role::Fit),
        held_out => number(Role::HeldOut),
        coefficients => plain_values(&coefficients::rows(report)),
        extended => coefficients::extended(report),
        not_identifiable => plain_values(&limits::not_identifiable(report)),
        detectable => plain_values(&limits::detectable(report)),
        unattributed => unattributed.map(|o| o.description.trim()),
        channels => shown(channels),
        more_channels => shown(more_channels),
        terms => unattributed.map(|o| plain_values(&limits::terms(&o.terms))),
        extended_model => &report.extended_model,
        extended_text => page.extended.map(beginning),
        verified => report.verified.as_ref().map(verified),
        noise => noise(report),
        schema => &report.schema,
        seconds => seconds.join(", "),
    };
    rendered(include_str!("page.html"), context)
}

fn split(drawn: &[Drawn]) -> (&[Drawn], &[Drawn]) {
    drawn.split_at(OPEN.min(drawn.len()))
}

/// Truncates the text of a model file to [`MAX_TEXT`] characters.
fn beginning(text: &str) -> String {
    let mut shown: String = text.chars().take(MAX_TEXT).collect();
    if shown.len() < text.len() {
        shown.push('…');
    }
    shown
}

fn verified(found: &Verified) -> Value {
    let checks = found.checks.iter().take(MAX_NOTES);
    let checks: Vec<(String, String)> = checks
        .map(|(name, says)| (short(name), short(says)))
        .collect();
    context! { holds => found.holds, checks => plain_values(&checks) }
}

/// Sentence for the report that states the estimated measurement noise.
fn noise(report: &Report) -> String {
    let noise = report.leading_noise();
    format!(
        "The noise per coordinate is {} (standard deviation), with a lag-1 autocorrelation of {}; {} of the points were \
         classified as outliers.",
        millimetres(noise.sigma),
        plain(noise.lag1_autocorrelation, 2),
        percent(noise.outlier_fraction)
    )
}
