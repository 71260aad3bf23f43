//! Round trips: takes are simulated, written, imported, given a marker template and fitted.

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::Duration;

use dataset::takes::{
    Axis, CentreHeight, EstimatedTemplate, FreeFlight, Point, ReadOptions, Take, ThrowOptions,
    Throws, estimate_template, find_throws,
};
use dataset::{Dataset, Flight, Marker};
use diagnose::{DiagnosisOptions, Verdict, diagnose};
use flight::parallel;
use identify::FitOptions;
use model_spec::model::Model;

use super::c3d;
use super::session::{Filmed, FilmedTake, filmed, turned};
use super::text::Writer;
use crate::bounded_fit::{bounded_fit, cancelled_after, on_threads};
use crate::error::StudyError;
use crate::oracle_flights::{TRUTH, disc, empty, file_name};
use crate::progress::{Progress, each_run};

/// Limit of the computing time for fitting one dataset.
const LIMIT: Duration = Duration::from_secs(120);

/// Combinations of inputs with which a session is fitted: releases and ends of the flights "found" by the import or
/// "true", and marker template "estimated" or "true".
pub(super) const GIVEN: [(&str, &str); 4] = [
    ("found", "estimated"),
    ("found", "true"),
    ("true", "estimated"),
    ("true", "true"),
];

/// Settings of one simulated recording session, and the result of importing and fitting its files.
#[derive(Debug)]
pub struct Session {
    /// Seed from which the session is simulated.
    pub seed: u64,
    /// File format in which the session's takes (recordings) are written.
    pub format: &'static str,
    /// Frame rate of the simulated cameras, Hz.
    pub rate: f64,
    /// Number of markers on the body.
    pub markers: usize,
    /// Standard deviation of the noise of each simulated marker coordinate, m.
    pub sigma: f64,
    /// Errors of the import and the fits against the true values, or the error that ended the session.
    pub result: Result<SessionResult, StudyError>,
}

/// Errors of the detected flights, of the estimated marker template and of the fits of one session.
#[derive(Debug)]
pub struct SessionResult {
    /// Errors (detected − true) of the release and the end of each flight, in samples; `None` for a flight that was not
    /// detected.
    pub cuts: Vec<Option<[i64; 2]>>,
    /// Number of detected throws that do not overlap a true flight.
    pub false_throws: usize,
    /// Errors of the marker template that is estimated from the flights between the detected releases and ends.
    pub template: TemplateErrors,
    /// Errors of the marker template that is estimated from the flights between the true releases and ends.
    pub template_of_true_cuts: TemplateErrors,
    /// Errors of four fits, or the error of a fit that failed: with detected flight ends and estimated marker template,
    /// detected ends and true template, true ends and estimated template, true ends and true template.
    pub fits: Vec<Result<FitErrors, StudyError>>,
    /// What a diagnosis with detected ends and estimated template finds in these flights, which lack nothing: its
    /// verdict and the names of its explanations; `None` if it finds nothing.
    pub found: Result<Option<String>, StudyError>,
}

/// Errors (estimated − true) of the coefficients and of the centre-of-mass height in one fit.
#[derive(Clone, Debug)]
pub struct FitErrors {
    /// Errors of the estimated coefficients, in standard errors, and whether their confidence intervals contain the
    /// true values.
    pub coefficients: Vec<CoefficientError>,
    /// Error (estimated − true) of the height of the centre of mass, and the standard error of the estimate, m; `None`
    /// if the fit does not estimate the height.
    pub height: Option<(f64, f64)>,
}

/// Errors (detected − true) of the release and the end of each true flight, in samples; `None` for a flight that was
/// not detected. Also the number of detected throws that overlap no true flight.
pub type SessionCuts = (Vec<Option<[i64; 2]>>, usize);

/// Errors (estimated − true) of a marker template in the body frame, m.
#[derive(Clone, Copy, Debug)]
pub struct TemplateErrors {
    /// Maximum distance between estimated and true position of a marker, perpendicular to the disc's axis, m.
    pub across: f64,
    /// Maximum difference between estimated and true position of a marker along the disc's axis, m, after the mean
    /// difference over the markers is subtracted.
    pub along: f64,
    /// Error of the estimated height of the centre of mass in the marker template (its position along the disc's axis),
    /// m.
    pub height: f64,
    /// Standard error of the height of the centre of mass, m; `None` if the height was not estimated.
    pub height_std_error: Option<f64>,
}

/// Error of one estimated coefficient in the fit of a simulated session.
#[derive(Clone, Debug)]
pub struct CoefficientError {
    /// Name of the aerodynamic coefficient that was estimated.
    pub name: &'static str,
    /// Error (estimate − true value) in standard errors.
    pub z: f64,
    /// Whether the 95 % confidence interval of the coefficient contains the true value.
    pub is_covered: bool,
}

/// Simulates, writes, imports and fits the sessions of `seeds`, `threads` of them in parallel. `python` is a Python
/// interpreter with ezc3d; without it no session is written as C3D. Calls `progress` with the numbers of finished
/// sessions and of all sessions.
pub fn sessions(
    seeds: &[u64],
    python: Option<&Path>,
    threads: usize,
    progress: Progress<'_>,
) -> Vec<Session> {
    let mut writers = vec![Writer::Vicon, Writer::Qualisys, Writer::OptiTrack];
    writers.extend(python.map(|_| Writer::C3d));
    each_run(threads, seeds.len(), progress, |index| {
        let seed = seeds[index];
        let writer = writers[seed as usize % writers.len()];
        session(seed, writer, python)
    })
}

/// Simulates and imports the sessions of `seeds` without fitting them. Returns the errors of the detected releases and
/// ends of all flights, and the number of detected throws that overlap no true flight.
///
/// # Errors
/// [`StudyError::Take`] if a take cannot be read.
pub fn session_cuts(seeds: &[u64], threads: usize) -> Result<SessionCuts, StudyError> {
    let each: Vec<Result<SessionCuts, StudyError>> =
        parallel::each_on(threads, seeds.len(), |index| {
            let filmed = filmed(seeds[index]);
            let text = |take: &FilmedTake| Writer::Vicon.text(&take.rows, filmed.rate);
            let takes = filmed.takes.iter();
            let imported: Result<Vec<(Take, Throws)>, StudyError> =
                takes.map(|take| imported(text(take).as_bytes())).collect();
            Ok(cut_errors(&filmed, &imported?))
        });
    let mut all = (Vec::new(), 0);
    for session in each {
        let (cuts, false_throws) = session?;
        all.0.extend(cuts);
        all.1 += false_throws;
    }
    Ok(all)
}

fn session(seed: u64, writer: Writer, python: Option<&Path>) -> Session {
    let filmed = filmed(seed);
    let files = files(&filmed, writer, python, seed);
    let result = files.and_then(|files| round_trip(&filmed, &files));
    Session {
        seed,
        format: writer.label(),
        rate: filmed.rate,
        markers: filmed.markers.len(),
        sigma: filmed.sigma,
        result,
    }
}

/// Contents of the files to which a session's takes (recordings) are written, in the file format of `writer`.
fn files(
    filmed: &Filmed,
    writer: Writer,
    python: Option<&Path>,
    seed: u64,
) -> Result<Vec<Vec<u8>>, StudyError> {
    let takes = filmed.takes.iter();
    let texts: Vec<String> = takes
        .map(|take| writer.text(&take.rows, filmed.rate))
        .collect();
    match (writer, python) {
        (Writer::C3d, Some(python)) => c3d::written(python, seed, &texts),
        _ => Ok(texts.into_iter().map(String::into_bytes).collect()),
    }
}

fn round_trip(filmed: &Filmed, files: &[Vec<u8>]) -> Result<SessionResult, StudyError> {
    let imported = files
        .iter()
        .map(|file| imported(file))
        .collect::<Result<Vec<(Take, Throws)>, StudyError>>()?;
    let (cuts, false_throws) = cut_errors(filmed, &imported);
    let labels: Vec<String> = (1..=filmed.markers.len())
        .map(|k| format!("m{k}"))
        .collect();
    let [mut found, mut exact] = [0; 2].map(|_| Vec::new());
    for ((take, throws), truth) in imported.iter().zip(&filmed.takes) {
        if !throws.throws.is_empty() && labels.iter().any(|label| !throws.labels.contains(label)) {
            return Err(StudyError::Labels(throws.labels.clone()));
        }
        let ranges = throws.throws.iter().map(dataset::takes::Throw::samples);
        add_flights(take, &labels, ranges, &mut found);
        let ranges = truth.flights.iter().map(|(first, last)| *first..last + 1);
        add_flights(take, &labels, ranges, &mut exact);
    }
    let estimated = |flights: &[Flight]| {
        let flights = flights.iter().map(|flight| FreeFlight {
            times: &flight.times,
            positions: &flight.positions,
        });
        let flights: Vec<FreeFlight<'_>> = flights.collect();
        estimate_template(&labels, &flights, None)
    };
    let template = estimated(&found)?;
    let of_true_cuts = estimated(&exact)?;
    let by = |template: &EstimatedTemplate, flights: &[Flight]| {
        let errors = template_errors(template, &filmed.markers);
        let mut found = fit(&labels, &positions(template), Some(template), flights)?;
        if let Some((shift, _)) = &mut found.height {
            *shift += errors.height;
        }
        Ok::<_, StudyError>(found)
    };
    let fits = [
        by(&template, &found),
        fit(&labels, &filmed.markers, None, &found),
        by(&of_true_cuts, &exact),
        fit(&labels, &filmed.markers, None, &exact),
    ];
    Ok(SessionResult {
        cuts,
        false_throws,
        template: template_errors(&template, &filmed.markers),
        template_of_true_cuts: template_errors(&of_true_cuts, &filmed.markers),
        fits: fits.into(),
        found: diagnosed(&labels, &template, &found),
    })
}

/// Errors (detected − true) of the release and end of each flight, in samples, and the number of detected throws that
/// overlap no true flight. `None` for a flight that was not detected.
fn cut_errors(filmed: &Filmed, imported: &[(Take, Throws)]) -> SessionCuts {
    let mut cuts = Vec::new();
    let mut false_throws = 0;
    for ((_, found), take) in imported.iter().zip(&filmed.takes) {
        let near = |&(first, last): &(usize, usize)| {
            let throws = found.throws.iter();
            throws
                .map(|throw| (throw.release.sample, throw.end.sample))
                .find(|(from, to)| *from < last && first < *to)
        };
        cuts.extend(take.flights.iter().map(|truth| {
            let (from, to) = near(truth)?;
            Some([from as i64 - truth.0 as i64, to as i64 - truth.1 as i64])
        }));
        let is_true = |from: usize, to: usize| {
            let mut all = take.flights.iter();
            all.any(|&(first, last)| from < last && first < to)
        };
        let throws = found.throws.iter();
        false_throws += throws
            .filter(|throw| !is_true(throw.release.sample, throw.end.sample))
            .count();
    }
    (cuts, false_throws)
}

/// Parses the contents of a file as a recording, converts it to axes with z up, and finds the throws in it.
fn imported(file: &[u8]) -> Result<(Take, Throws), StudyError> {
    let take = dataset::takes::parse(&PathBuf::from("take"), file, &ReadOptions::default())?;
    let up = Axis::parse("+y").expect("an axis");
    let take = take.with_z_up(up, false);
    let found = find_throws(&take, &[], &ThrowOptions::default());
    Ok((take, found))
}

/// Appends one flight to `flights` for each range of samples of a take (recording) in `ranges`. The markers of the
/// flights are in the order of `labels`.
fn add_flights(
    take: &Take,
    labels: &[String],
    ranges: impl Iterator<Item = Range<usize>>,
    flights: &mut Vec<Flight>,
) {
    let points = labels
        .iter()
        .map(|label| take.points.iter().find(|point| point.label == *label));
    let points: Vec<Option<&Point>> = points.collect();
    for range in ranges {
        let row = |sample: usize| {
            let each = points.iter().map(|point| (*point)?.positions[sample]);
            each.collect()
        };
        flights.push(Flight {
            file: file_name(flights.len()),
            times: take.times[range.clone()].to_vec(),
            positions: range.map(row).collect(),
            ..Flight::default()
        });
    }
}

fn positions(template: &EstimatedTemplate) -> Vec<[f64; 3]> {
    template.markers.iter().map(|m| m.position).collect()
}

fn template_errors(template: &EstimatedTemplate, markers: &[[f64; 3]]) -> TemplateErrors {
    let truth = turned(markers, template.first);
    let pairs = || template.markers.iter().zip(&truth);
    let height = pairs().map(|(m, t)| m.position[2] - t[2]).sum::<f64>() / truth.len() as f64;
    let across = pairs().map(|(m, t)| (m.position[0] - t[0]).hypot(m.position[1] - t[1]));
    let along = pairs().map(|(m, t)| (m.position[2] - t[2] - height).abs());
    TemplateErrors {
        across: across.fold(0.0, f64::max),
        along: along.fold(0.0, f64::max),
        height,
        height_std_error: match template.height {
            CentreHeight::Estimated { std_error, .. } => Some(std_error),
            _ => None,
        },
    }
}

/// Dataset of a session: its flights with the markers `labels` at the positions `markers`, m, on the body. The errors
/// of these positions are those of `template`, if it was estimated.
fn session_dataset(
    model: &Model,
    labels: &[String],
    markers: &[[f64; 3]],
    template: Option<&EstimatedTemplate>,
    flights: &[Flight],
) -> Dataset {
    let markers = labels.iter().zip(markers).map(|(name, position)| Marker {
        name: name.clone(),
        position: *position,
    });
    Dataset {
        markers: markers.collect(),
        origin_error: template.map(EstimatedTemplate::origin_error),
        axis_error: template.map(EstimatedTemplate::axis_error),
        flights: flights.to_vec(),
        ..empty(model)
    }
}

/// Diagnoses the flights of a session, in which nothing is missing. Returns what the diagnosis finds, `None` if it finds
/// nothing.
fn diagnosed(
    labels: &[String],
    template: &EstimatedTemplate,
    flights: &[Flight],
) -> Result<Option<String>, StudyError> {
    let model = disc();
    let dataset = session_dataset(
        &model,
        labels,
        &positions(template),
        Some(template),
        flights,
    );
    let found = cancelled_after(LIMIT, |token| {
        let options = DiagnosisOptions {
            dataset: "takes",
            fit: FitOptions {
                cancellation: Some(token),
                ..on_threads(1)
            },
            ..DiagnosisOptions::default()
        };
        diagnose(&model, &dataset, &options)
    });
    let report = found?.report;
    let explanations = report.explanations.iter();
    let names: Vec<String> = explanations.map(diagnose::Explanation::name).collect();
    Ok(match report.verdict {
        Verdict::Adequate | Verdict::Negligible => None,
        verdict => Some(format!("{verdict:?}: {}", names.join(", "))),
    })
}

fn fit(
    labels: &[String],
    markers: &[[f64; 3]],
    template: Option<&EstimatedTemplate>,
    flights: &[Flight],
) -> Result<FitErrors, StudyError> {
    let model = disc();
    let dataset = session_dataset(&model, labels, markers, template, flights);
    let report = bounded_fit(&model, &dataset, LIMIT).result?.report;
    let each = TRUTH.iter().map(|(name, truth)| {
        let found = report.coefficients.get(*name);
        let found = found.ok_or_else(|| StudyError::Name {
            of: "fitted model",
            name: (*name).to_owned(),
        })?;
        let [low, high] = found.interval;
        Ok(CoefficientError {
            name,
            z: (found.value - truth) / found.std_error,
            is_covered: (low..=high).contains(truth),
        })
    });
    let shift = report.coefficients.get("offset_3");
    Ok(FitErrors {
        coefficients: each.collect::<Result<_, StudyError>>()?,
        height: shift.map(|shift| (shift.value, shift.std_error)),
    })
}
