//! HTML page of a fit, rendered from a template.

use dataset::Role;
use identify::FitReport;
use identify::wording::count;
use minijinja::syntax::SyntaxConfig;
use minijinja::value::{Serde, Value};
use minijinja::{AutoEscape, Environment, UndefinedBehavior, context};
use model_spec::sort_by_number;
use serde::Serialize;

use super::{Drawn, Figure, Figures, FitPage, coefficients, flights, noise, words};
use crate::data_faults;
use crate::figures::svg::{STYLE, without_style};
use crate::literature::sources;
use crate::numbers::{percent, plain};

/// Number of flights whose figures of the states over time are expanded when the page is opened.
const OPEN: usize = 3;
/// Number of flights whose figures of marker paths are expanded when the page is opened.
const OPEN_TRACKS: usize = 6;
/// Maximum number of non-identifiable directions in parameter space that are listed in the report of a fit.
const MAX_UNDETERMINED: usize = 20;

/// Non-identifiable direction in parameter space, with all values formatted as text.
#[derive(Serialize)]
struct Undetermined {
    names: String,
    /// Linear combination of coefficients, such as `0.71 C_L0 − 0.70 C_La`; empty for a single coefficient.
    direction: String,
    error: String,
    why: String,
}

/// Renders the HTML page of the report of a fit with the given figures.
pub(super) fn written(page: &FitPage<'_>, figures: &Figures) -> String {
    let (first, rest) = figures.states.split_at(OPEN.min(figures.states.len()));
    let (tracks, more_tracks) = figures
        .tracks
        .split_at(OPEN_TRACKS.min(figures.tracks.len()));
    let report = page.report;
    let caption = |drawn: &[Drawn]| drawn.first().map(|d| d.figure.caption.clone());
    let seconds = report.seconds.iter().filter(|(_, s)| s.is_finite());
    let seconds: Vec<String> = seconds
        .map(|(what, s)| format!("{what} {} s", plain(*s, 2)))
        .collect();
    let context = context! {
        model => &report.model,
        dataset => page.dataset,
        effects => words::names(&report.effects),
        summary => plain_values(&words::summary(page)),
        opening => plain_values(&words::opening(page)),
        precision => figures.precision.iter().map(|f| one(&reached(f))).collect::<Vec<_>>(),
        predictions => shown(&figures.predictions),
        alarms => plain_values(&words::alarms(page)),
        cautions => plain_values(&cautions(report)),
        faults => plain_values(&data_faults::table(&report.data_faults)),
        coefficients => plain_values(&coefficients::rows(page)),
        clustered => report.coefficients.values().any(|c| c.std_error_cluster_robust.is_some()),
        sources => plain_values(&sources(page.model.reference.as_deref()).iter().map(|s| (s.short, s.long)).collect::<Vec<_>>()),
        undetermined => plain_values(&undetermined(page)),
        profiles => shown(&figures.profiles),
        tracks => shown(tracks),
        more_tracks => shown(more_tracks),
        tracks_caption => caption(&figures.tracks),
        drawn => figures.tracks.len(),
        residuals => shown(&figures.residuals),
        states => shown(first),
        more_states => shown(rest),
        correlations => figures.correlations.iter().map(one).collect::<Vec<_>>(),
        whiteness => shown(&figures.whiteness),
        whiteness_caption => caption(&figures.whiteness),
        histogram => figures.histogram.iter().map(one).collect::<Vec<_>>(),
        fitted => plain_values(&flights::table(page, Role::Fit)),
        held_out => plain_values(&flights::table(page, Role::HeldOut)),
        left_out => plain_values(&flights::left_out(page)),
        noise => plain_values(&noise::rows(report)),
        noise_how => if report.leading_noise().estimated { "estimated" } else { "given by the dataset" },
        estimated => report.leading_noise().estimated,
        interval => crate::numbers::significant(1e3 * report.leading_noise().interval_s, 3),
        points => report.leading_noise().points,
        outliers => report.leading_noise().outliers,
        outlier_share => percent(report.leading_noise().outlier_fraction),
        dropouts => report.leading_noise().missing,
        schema => &report.schema,
        steps => count(report.iterations.steps, "step"),
        rounds => count(report.iterations.rounds, "time"),
        converged => report.iterations.converged,
        seconds => seconds.join(", "),
    };
    rendered(include_str!("page.html"), context)
}

/// Reasons not to rely on the fit, as sentences; empty if the fit is reliable.
fn cautions(report: &FitReport) -> Vec<String> {
    match report.reliable {
        true => Vec::new(),
        false => report
            .cautions
            .iter()
            .map(|reason| capitalized(reason))
            .collect(),
    }
}

/// Renders a template of this crate with the given values; panics if the template is invalid. The values `css` and
/// `style` default to the style sheets of the report of a fit and of figures.
pub(crate) fn rendered(template: &str, context: Value) -> String {
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment.set_auto_escape_callback(|_| AutoEscape::Html);
    let syntax = SyntaxConfig::builder()
        .trim_blocks(true)
        .lstrip_blocks(true)
        .build();
    environment.set_syntax(syntax.unwrap_or_default());
    environment.add_global("version", env!("CARGO_PKG_VERSION"));
    for (name, sheet) in [("css", include_str!("page.css")), ("style", STYLE)] {
        environment.add_global(name, Value::from_safe_string(sheet.to_owned()));
    }
    let shared = [
        ("data_faults.html", include_str!("../data_faults.html")),
        ("document.html", include_str!("../document.html")),
        ("macros.html", include_str!("../macros.html")),
    ];
    let mut added = shared.into_iter();
    added
        .try_for_each(|(name, text)| environment.add_template(name, text))
        .and_then(|()| environment.render_str(template, context))
        .unwrap_or_else(|fault| {
            panic!("the page's own template, which its tests render: {fault:#}")
        })
}

/// Converts a serializable value to a value for the HTML templates. The template engine escapes all strings in it as
/// plain text.
pub(crate) fn plain_values(of: &impl Serialize) -> Value {
    Value::from(Serde(of))
}

pub(crate) fn shown(drawn: &[Drawn]) -> Vec<Value> {
    drawn.iter().map(one).collect()
}

/// Copy of a figure in which the points with tooltips can receive the keyboard focus, so that their values can be read
/// without a pointer.
pub(crate) fn reached(drawn: &Drawn) -> Drawn {
    let reached = |svg: &str| svg.replace("tabindex=\"-1\"", "tabindex=\"0\"");
    Drawn {
        figure: Figure {
            svg: reached(&drawn.figure.svg),
            ..drawn.figure.clone()
        },
        narrow: drawn.narrow.as_deref().map(reached),
    }
}

pub(crate) fn one(drawn: &Drawn) -> Value {
    // The SVG writer has already escaped all external text.
    let safe = |svg: &String| Value::from_safe_string(without_style(svg));
    let figure = &drawn.figure;
    context! {
        name => &figure.name,
        title => &figure.title,
        caption => &figure.caption,
        svg => safe(&figure.svg),
        narrow => drawn.narrow.as_ref().map(safe),
        csv => table_link(figure),
    }
}

/// Maximum size in bytes of a CSV table that is embedded in the HTML report; the report links to the file of a larger
/// table.
const MAX_EMBEDDED: usize = 10_000;

/// Link to the CSV table of a figure: a data URI, or the path of the file if the table is large.
fn table_link(figure: &Figure) -> String {
    match figure.csv.len() <= MAX_EMBEDDED {
        true => format!("data:text/csv;charset=utf-8,{}", encoded(&figure.csv)),
        false => format!("figure-data/{}.csv", figure.name),
    }
}

/// Percent-encodes the characters that a data URI must not contain; control characters are dropped.
fn encoded(text: &str) -> String {
    let mut encoded = String::with_capacity(text.len() + text.len() / 8);
    for c in text.chars() {
        match c {
            '%' | '#' | '"' | '<' | '>' | ' ' | '&' | '\'' | '\n' | '\r' => {
                encoded += &format!("%{:02X}", u32::from(c));
            }
            c if c.is_control() => {}
            c => encoded.push(c),
        }
    }
    encoded
}

/// Truncates a text to 300 characters (the maximum length of a note in a report), and appends a full stop unless the
/// text ends with a punctuation mark that ends a sentence. A colon at the end is removed.
pub(crate) fn sentence(text: &str) -> String {
    let text = flights::short(text.trim_end().trim_end_matches(':'));
    if text.ends_with(['.', '…', '!', '?']) {
        text
    } else {
        text + "."
    }
}

/// Formats a text as a sentence that begins with a capital letter and ends with a full stop.
pub(crate) fn capitalized(text: &str) -> String {
    let sentence = sentence(text);
    let mut letters = sentence.chars();
    let first: String = letters
        .next()
        .into_iter()
        .flat_map(char::to_uppercase)
        .collect();
    first + letters.as_str()
}

fn undetermined(page: &FitPage<'_>) -> Vec<Undetermined> {
    let found = page.report.not_identifiable.iter().take(MAX_UNDETERMINED);
    found
        .map(|u| {
            let mut weights: Vec<(&String, f64)> = u.weights.iter().map(|(n, w)| (n, *w)).collect();
            weights.retain(|(_, w)| w.is_finite() && w.abs() >= 0.05);
            sort_by_number(&mut weights, |weight| -weight.1.abs());
            weights.truncate(8);
            let mut direction = String::new();
            for (i, (name, weight)) in weights.iter().enumerate() {
                let sign = match (i, *weight < 0.0) {
                    (0, false) => "",
                    (0, true) => "−",
                    (_, false) => " + ",
                    (_, true) => " − ",
                };
                direction += &format!("{sign}{} {name}", plain(weight.abs(), 2));
            }
            if weights.len() < 2 {
                direction.clear();
            }
            Undetermined {
                names: words::names(&u.combination),
                direction,
                error: percent(u.relative_error),
                why: sentence(&u.reason),
            }
        })
        .collect()
}
