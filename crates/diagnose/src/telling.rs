//! What was found, put into the report.

use std::collections::BTreeMap;

use identify::Fit;
use model_spec::model::Model;

use crate::bench::Bench;
use crate::catalogue::hyphened;
use crate::causes::{Cause, Found};
use crate::chance::normal_size;
use crate::detect::detectable;
use crate::diagnosis::Asked;
use crate::extend::Extension;
use crate::report::{
    Alike, CandidateScore, CauseEffect, Coefficient, Estimate, FlightGain, Noise, Report, Rival,
    Threshold, Verdict,
};
use crate::scores::correlations;

/// The report of what was found, before anything is extended.
pub(crate) fn told(
    model: &Model,
    asked: &Asked<'_>,
    before: &Fit,
    bench: &Bench,
    found: &Found,
) -> Report {
    let causes: Vec<_> = found
        .causes
        .iter()
        .map(|cause| cause_report(bench, found, cause))
        .collect();
    let verdict = if !found.alarmed {
        Verdict::None
    } else if causes.is_empty() {
        Verdict::Outside
    } else if causes
        .iter()
        .all(|c| c.effects.iter().all(|e| e.immaterial))
    {
        Verdict::Immaterial
    } else if causes.len() == 1 {
        Verdict::Named
    } else {
        Verdict::Ambiguous
    };
    let (points, outliers) =
        bench
            .observation_sets
            .iter()
            .fold((0, 0), |(points, outliers), observations| {
                (
                    points + observations.measured.iter().flatten().count(),
                    outliers + observations.outlier.iter().filter(|o| **o).count(),
                )
            });
    let (undetectable, smallest_detectable) = detectable(bench, &found.scores, found.limits.alarm);
    let flights = before.report.flights.iter().map(|flight| FlightGain {
        file: flight.file.clone(),
        role: flight.role,
        rms_before_m: flight.rms_m,
        rms_after_m: None,
    });
    let coefficients = before.report.coefficients.iter().map(|(name, c)| {
        let coefficient = Coefficient {
            value: c.value,
            std_error: c.std_error,
            unit: c.unit.clone(),
            before: None,
        };
        (name.clone(), coefficient)
    });
    Report {
        schema: "hyzer.diagnosis/1".into(),
        dataset: asked.dataset.to_owned(),
        model: model.name.clone(),
        effects: model.effects.iter().map(|e| hyphened(&e.name)).collect(),
        verdict,
        summary: String::new(),
        causes,
        noise: Noise {
            sigma_m: found.noise.overall(),
            ar1: found.noise.ar1.iter().sum::<f64>() / 3.0,
            outlier_fraction: outliers as f64 / points.max(1) as f64,
        },
        gain: None,
        coefficients: coefficients.collect(),
        undetectable,
        smallest_detectable,
        next_throw: None,
        extended_model: None,
        seconds: BTreeMap::new(),
        candidates: candidates(bench, found),
        threshold: Threshold {
            false_alarms: crate::causes::ALARM,
            ln_p: found.limits.alarm,
            sigmas: normal_size(found.limits.alarm),
        },
        alike: alike(bench, found),
        flights: flights.collect(),
        curves: Vec::new(),
        outside: None,
        agreement: None,
        verified: None,
        notes: Vec::new(),
    }
}

fn candidates(bench: &Bench, found: &Found) -> Vec<CandidateScore> {
    let each = bench.candidates.iter().zip(&found.scores.each);
    let mut all: Vec<CandidateScore> = each
        .filter_map(|(columns, score)| Some((columns, score.as_ref()?)))
        .map(|(columns, score)| {
            let expected = score.estimates.iter().map(|&(unknown, value, std_error)| {
                let name = bench.problem.globals[unknown].name.clone();
                let part = columns.candidate.coefficients.iter();
                let part = part.clone().find(|part| part.name == name);
                let estimate = Estimate {
                    value,
                    std_error,
                    unit: part.map(|p| p.unit.clone()).unwrap_or_default(),
                    negligible: part.and_then(|p| p.negligible),
                };
                (name, estimate)
            });
            CandidateScore {
                name: columns.candidate.name.clone(),
                doc: columns.candidate.doc.clone(),
                site: columns.candidate.site.clone(),
                statistic: score.statistic,
                freedom: score.freedom,
                ln_p: score.ln_p,
                sigmas: normal_size(score.ln_p),
                significant: score.freedom > 0 && score.ln_p < found.limits.alarm,
                visible: score.visible,
                expected: expected.collect(),
            }
        })
        .collect();
    all.sort_by(|a, b| a.ln_p.total_cmp(&b.ln_p));
    all
}

fn alike(bench: &Bench, found: &Found) -> Alike {
    let scores = &found.scores;
    let known = bench.problem.globals.len();
    let at: Vec<usize> = (0..scores.columns.len())
        .filter(|&i| scores.columns[i] < known && scores.information[(i, i)] > 1e-8)
        .collect();
    let matrix = correlations(&scores.information);
    Alike {
        names: at
            .iter()
            .map(|&i| bench.problem.globals[scores.columns[i]].name.clone())
            .collect(),
        matrix: at
            .iter()
            .map(|&i| at.iter().map(|&j| matrix[(i, j)]).collect())
            .collect(),
    }
}

fn cause_report(bench: &Bench, found: &Found, cause: &Cause) -> crate::report::Cause {
    let (unknowns, information) = &cause.scores.base;
    let covariance = crate::scores::inverse(information);
    let error = |unknown: usize| {
        let at = unknowns.iter().position(|u| *u == unknown);
        let variance = at.zip(covariance.as_ref()).map(|(at, c)| c[(at, at)]);
        variance.unwrap_or(0.0).max(0.0).sqrt()
    };
    let effects = cause.effects.iter().map(|&index| {
        let columns = &bench.candidates[index];
        let mut estimates = BTreeMap::new();
        let mut immaterial = true;
        for (part, &unknown) in columns.candidate.coefficients.iter().zip(&columns.global) {
            let value = cause.point.global[unknown];
            let departure = (value - part.null_value).abs();
            immaterial &= part.negligible.is_some_and(|size| departure < size);
            let estimate = Estimate {
                value,
                std_error: error(unknown),
                unit: part.unit.clone(),
                negligible: part.negligible,
            };
            estimates.insert(part.name.clone(), estimate);
        }
        for part in &columns.candidate.states {
            let local = cause
                .point
                .local
                .iter()
                .map(|local| local[part.index] - part.null_value);
            let count = cause.point.local.len().max(1) as f64;
            let value = (local.map(|v| v * v).sum::<f64>() / count).sqrt();
            immaterial &= part.negligible.is_some_and(|size| value < size);
            let estimate = Estimate {
                value,
                std_error: value / (2.0 * count).sqrt(),
                unit: part.unit.clone(),
                negligible: part.negligible,
            };
            estimates.insert(part.name.clone(), estimate);
        }
        let score = found.scores.each[index].as_ref();
        CauseEffect {
            name: columns.candidate.name.clone(),
            doc: columns.candidate.doc.clone(),
            site: columns.candidate.site.clone(),
            variables: columns.candidate.variables.clone(),
            estimates,
            statistic: score.map_or(0.0, |score| score.statistic),
            immaterial,
        }
    });
    crate::report::Cause {
        effects: effects.collect(),
        gain: (found.squares - cause.squares).max(0.0),
        rival: cause.rival.map(|(index, ln_p)| Rival {
            name: bench.candidates[index].candidate.name.clone(),
            p: ln_p.exp(),
        }),
    }
}

/// Takes the extended model's fit into the report.
pub(crate) fn take_over(
    report: &mut Report,
    (extension, gained): (&Extension, f64),
    before: &Fit,
    after: &Fit,
) {
    for (flight, after) in report.flights.iter_mut().zip(&after.report.flights) {
        flight.rms_after_m = Some(after.rms_m);
    }
    report.coefficients = after
        .report
        .coefficients
        .iter()
        .map(|(name, c)| {
            let coefficient = Coefficient {
                value: c.value,
                std_error: c.std_error,
                unit: c.unit.clone(),
                before: before.report.coefficients.get(name).map(|b| b.value),
            };
            (name.clone(), coefficient)
        })
        .collect();
    if report.causes.is_empty() {
        // What was written is a cause with a name of its own.
        let each = extension.model.effects.iter();
        let written = each.filter(|effect| extension.effects.contains(&effect.name));
        let effects = written.map(|effect| CauseEffect {
            name: hyphened(&effect.name),
            doc: effect.doc.clone(),
            site: effect.site.clone(),
            variables: effect.variables.clone(),
            estimates: effect
                .coefficients
                .iter()
                .filter_map(|local| {
                    let constant = &extension.model.coefficients[local.index];
                    let found = after.report.coefficients.get(&constant.name)?;
                    let estimate = Estimate {
                        value: found.value,
                        std_error: found.std_error,
                        unit: constant.unit_text.clone(),
                        negligible: local.smallest_of_interest,
                    };
                    Some((constant.name.clone(), estimate))
                })
                .collect(),
            statistic: 0.0,
            immaterial: false,
        });
        let effects: Vec<CauseEffect> = effects.collect();
        report.causes.push(crate::report::Cause {
            effects,
            gain: gained,
            rival: None,
        });
    }
}

/// Where causes leave more than noise, the values of the extended fit, with errors by the scatter of the flights where those are
/// greater: what is left of one flight says nothing of another's, and by the noise alone all would seem too certain.
pub(crate) fn by_scatter(report: &mut Report, after: &Fit) {
    let fitted = |name: &str| {
        let found = after.report.coefficients.get(name)?;
        let clustered = found.std_error_clustered.unwrap_or(0.0);
        Some((found.value, found.std_error.max(clustered)))
    };
    for (name, coefficient) in &mut report.coefficients {
        if let Some((_, error)) = fitted(name) {
            coefficient.std_error = error;
        }
    }
    for effect in report
        .causes
        .iter_mut()
        .take(1)
        .flat_map(|c| &mut c.effects)
    {
        for (name, estimate) in &mut effect.estimates {
            if let Some((value, error)) = fitted(name) {
                (estimate.value, estimate.std_error) = (value, error);
            }
        }
    }
}

/// Held-out flights, by index, of which the extension is not believed are predicted without.
pub(crate) fn not_believed(report: &mut Report, without: &[usize]) {
    let files: Vec<String> = without
        .iter()
        .map(|&flight| {
            let told = &mut report.flights[flight];
            told.rms_after_m = Some(told.rms_before_m);
            told.file.clone()
        })
        .collect();
    if !files.is_empty() {
        report.notes.push(format!(
            "held-out flights that contradict the extension in their first part, and are predicted without: {}",
            files.join(", ")
        ));
    }
}
