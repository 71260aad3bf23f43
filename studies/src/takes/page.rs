//! Renders docs/studies/takes.md.

use serde::Serialize;

use super::run::{CoefficientError, GIVEN, Session, SessionResult, TemplateErrors};
use crate::error::StudyError;
use crate::oracle_flights::TRUTH;
use crate::page::Page;
use crate::statistics::median;

/// Maximum error of a detected release or end of a flight that counts as correct, samples.
const CUT: i64 = 3;
/// Maximum error of a marker position in an estimated marker template that counts as correct, m.
const MILLIMETRE: f64 = 0.001;
/// Maximum error of a coefficient that counts as correct, standard errors.
const MAX_Z: f64 = 3.0;
/// Half width of a 95 % interval of a normal variable, in standard deviations.
const NORMAL_95: f64 = 1.96;
/// Maximum number of failed recording sessions that docs/studies/takes.md lists as examples.
const MAX_EXAMPLES: usize = 8;

#[derive(Serialize)]
struct Results {
    sessions: usize,
    failed: usize,
    flights: usize,
    missed: usize,
    false_throws: usize,
    /// Fraction of the simulated recording sessions in which the detected release and end of every flight are right
    /// (within [`CUT`] samples). A session without a result counts as wrong.
    cut_sessions: f64,
    /// Fraction of the flights, over all sessions with a result, whose detected release and end are right (within
    /// [`CUT`] samples).
    cut_flights: f64,
    /// Fraction of the simulated recording sessions in which all estimated marker positions are within 1 mm of the true
    /// ones, perpendicular to the disc's axis. A session without a result counts as wrong.
    across: f64,
    /// Fraction of the simulated recording sessions in which all estimated marker positions are within 1 mm of the true
    /// ones along the disc's axis, after the mean error over the markers is subtracted from each marker's error. A
    /// session without a result counts as wrong.
    along: f64,
    greatest_across: f64,
    /// Statistics of the estimated height of the centre of mass: estimated from flights with the detected releases and
    /// ends, from flights with the true ones, and by the fit of the motion.
    heights: [HeightRow; 3],
    formats: Vec<FormatRow>,
    fits: Vec<FitRow>,
    coefficients: Vec<CoefficientRow>,
    examples: Vec<String>,
    /// Number of sessions that were diagnosed.
    diagnosed: usize,
    /// Seeds of the sessions in which a diagnosis finds something, and what it finds. Nothing is missing in any.
    alarms: Vec<(u64, String)>,
}

/// Statistics of the estimated heights of the centre of mass in the marker template, mm.
#[derive(Serialize)]
struct HeightRow {
    estimated: usize,
    covered: Option<f64>,
    error: Option<f64>,
    std_error: Option<f64>,
}

#[derive(Serialize)]
struct FormatRow {
    name: &'static str,
    sessions: usize,
    cut_flights: f64,
    across: f64,
    covered: f64,
}

/// Statistics of the fits with one combination of releases and ends of the flights (detected or true) and marker
/// template (estimated or true).
#[derive(Serialize)]
struct FitRow {
    cuts: &'static str,
    template: &'static str,
    fits: usize,
    failed: usize,
    covered: f64,
    within: f64,
    max_z: f64,
    rms_z: f64,
}

/// Coverage of the 95 % intervals of one coefficient, for each combination of releases and ends of the flights
/// (detected or true) and marker template (estimated or true).
#[derive(Serialize)]
struct CoefficientRow {
    name: &'static str,
    covered: Vec<f64>,
}

/// Fraction of the values that are true; 0 if `values` is empty.
fn share(values: impl IntoIterator<Item = bool>) -> f64 {
    let (mut holding, mut all) = (0, 0);
    for value in values {
        holding += usize::from(value);
        all += 1;
    }
    f64::from(holding as u32) / f64::from(all.max(1))
}

fn is_cut(cut: &Option<[i64; 2]>) -> bool {
    cut.is_some_and(|ends| ends.iter().all(|end| end.abs() <= CUT))
}

/// Renders docs/studies/takes.md from the results of all simulated recording sessions.
///
/// # Errors
/// [`StudyError::Page`] if the template cannot be rendered with the results.
pub fn takes_page(sessions: &[Session]) -> Result<Page, StudyError> {
    let results: Vec<&SessionResult> = sessions
        .iter()
        .filter_map(|session| session.result.as_ref().ok())
        .collect();
    let cuts = || results.iter().flat_map(|result| &result.cuts);
    let templates = || results.iter().map(|result| result.template);
    // A session without a result counts as wrong in every fraction.
    let of_sessions = |holds: &dyn Fn(&SessionResult) -> bool| {
        share(sessions.iter().map(|s| s.result.as_ref().is_ok_and(holds)))
    };
    let all = Results {
        sessions: sessions.len(),
        failed: sessions.len() - results.len(),
        flights: cuts().count(),
        missed: cuts().filter(|cut| cut.is_none()).count(),
        false_throws: results.iter().map(|result| result.false_throws).sum(),
        cut_sessions: of_sessions(&|result| result.cuts.iter().all(is_cut)),
        cut_flights: share(cuts().map(is_cut)),
        across: of_sessions(&|result| result.template.across <= MILLIMETRE),
        along: of_sessions(&|result| result.template.along <= MILLIMETRE),
        greatest_across: 1e3 * templates().map(|t| t.across).fold(0.0, f64::max),
        heights: [
            heights(templates().filter_map(of_template)),
            heights(
                results
                    .iter()
                    .filter_map(|result| of_template(result.template_of_true_cuts)),
            ),
            heights(
                results
                    .iter()
                    .filter_map(|result| result.fits[0].as_ref().ok()?.height),
            ),
        ],
        formats: formats(sessions),
        fits: (0..GIVEN.len())
            .map(|kind| fit_row(kind, &results))
            .collect(),
        coefficients: TRUTH
            .iter()
            .map(|(name, _)| CoefficientRow {
                name,
                covered: (0..GIVEN.len())
                    .map(|kind| {
                        let errors = errors(kind, &results).filter(|e| e.name == *name);
                        share(errors.map(|error| error.is_covered))
                    })
                    .collect(),
            })
            .collect(),
        examples: examples(sessions),
        diagnosed: results.iter().filter(|result| result.found.is_ok()).count(),
        alarms: alarms(sessions),
    };
    Page::without_figures(include_str!("page.md"), all)
}

/// Error (estimated − true) of the height of the centre of mass in an estimated marker template, and the standard error
/// of this height, m; `None` if the height was not estimated.
fn of_template(errors: TemplateErrors) -> Option<(f64, f64)> {
    Some((errors.height, errors.height_std_error?))
}

fn heights(estimated: impl Iterator<Item = (f64, f64)>) -> HeightRow {
    let estimated: Vec<(f64, f64)> = estimated.collect();
    let each = || estimated.iter();
    let is_covered = |(error, std_error): &(f64, f64)| error.abs() <= NORMAL_95 * std_error;
    HeightRow {
        estimated: estimated.len(),
        covered: (!estimated.is_empty()).then(|| share(each().map(is_covered))),
        error: median(each().map(|(error, _)| 1e3 * error.abs())),
        std_error: median(each().map(|(_, std_error)| 1e3 * std_error)),
    }
}

/// Errors of all estimated coefficients, in standard errors, from the successful fits with one combination of releases
/// and ends of the flights (detected or true) and marker template (estimated or true). `kind` is the index of the
/// combination in `GIVEN`.
fn errors<'r>(
    kind: usize,
    results: &'r [&'r SessionResult],
) -> impl Iterator<Item = &'r CoefficientError> {
    let fits = results.iter().map(move |result| &result.fits[kind]);
    fits.filter_map(|fit| fit.as_ref().ok())
        .flat_map(|fit| &fit.coefficients)
}

fn fit_row(kind: usize, results: &[&SessionResult]) -> FitRow {
    let all = || errors(kind, results);
    let fits = || results.iter().map(|result| &result.fits[kind]);
    let squares: f64 = all().map(|error| error.z * error.z).sum();
    let (cuts, template) = GIVEN[kind];
    FitRow {
        cuts,
        template,
        fits: fits().count(),
        failed: fits().filter(|fit| fit.is_err()).count(),
        covered: share(all().map(|error| error.is_covered)),
        within: share(all().map(|error| error.z.abs() <= MAX_Z)),
        max_z: all().map(|error| error.z.abs()).fold(0.0, f64::max),
        rms_z: (squares / all().count().max(1) as f64).sqrt(),
    }
}

fn formats(sessions: &[Session]) -> Vec<FormatRow> {
    let mut names: Vec<&'static str> = Vec::new();
    for session in sessions {
        if !names.contains(&session.format) {
            names.push(session.format);
        }
    }
    let row = |name: &'static str| {
        let of: Vec<&Session> = sessions.iter().filter(|s| s.format == name).collect();
        let found: Vec<&SessionResult> = of.iter().filter_map(|s| s.result.as_ref().ok()).collect();
        FormatRow {
            name,
            sessions: of.len(),
            cut_flights: share(found.iter().flat_map(|r| &r.cuts).map(is_cut)),
            across: share(found.iter().map(|r| r.template.across <= MILLIMETRE)),
            covered: share(errors(0, &found).map(|error| error.is_covered)),
        }
    };
    names.into_iter().map(row).collect()
}

fn alarms(sessions: &[Session]) -> Vec<(u64, String)> {
    let each = sessions.iter().filter_map(|session| {
        let found = session
            .result
            .as_ref()
            .ok()?
            .found
            .as_ref()
            .ok()?
            .as_ref()?;
        Some((session.seed, found.trim_end_matches(": ").to_owned()))
    });
    each.collect()
}

/// Describes the simulated recording sessions that ended with an error or in which a fit failed: one text with settings
/// and error for each, at most [`MAX_EXAMPLES`].
fn examples(sessions: &[Session]) -> Vec<String> {
    let each = sessions.iter().filter_map(|session| {
        let why = match &session.result {
            Err(error) => error,
            Ok(result) => result.fits.iter().find_map(|fit| fit.as_ref().err())?,
        };
        let (seed, format, rate, markers) =
            (session.seed, session.format, session.rate, session.markers);
        let noise = 1e3 * session.sigma;
        let text = format!(
            "seed {seed}, {format}, {markers} markers at {rate} Hz with {noise:.2} mm: {why}"
        );
        Some(text.replace('\n', " "))
    });
    each.take(MAX_EXAMPLES).collect()
}
