//! The diagnosis from fit to report.

use std::collections::BTreeMap;
use std::time::Instant;

use flight::batch;
use identify::dataset::{Dataset, Role};
use identify::fit::{FitError, Fitted, fit};
use identify::options::Options;
use identify::report::FlightEvidence;
use identify::track::Track;
use model_spec::load::LoadError;
use model_spec::model::Model;

use crate::bench::Bench;
use crate::beside::both;
use crate::catalogue::{Catalogue, hyphened, underscored};
use crate::causes::{Cause, Found, search, search_on};
use crate::chance::normal_size;
use crate::curves::curves;
use crate::detect::detectable;
use crate::extend::Extension;
use crate::outside;
use crate::report::{
    Alike, CandidateScore, CauseEffect, Coefficient, Estimate, FlightGain, Noise, Outside, Report,
    Rival, Threshold, Verdict,
};
use crate::scores::correlations;
use crate::throw::next_throw;
use crate::{gain, histories, words};

/// What is asked of a diagnosis beside its dataset and its model.
#[derive(Clone, Copy, Debug, Default)]
pub struct Asked<'a> {
    /// The dataset as it was named, for the report.
    pub dataset: &'a str,
    /// Effects that are on, by name or path.
    pub with: &'a [String],
    /// Effects that are not looked for.
    pub without: &'a [String],
    /// What is asked of its fits.
    pub fit: Options<'a>,
}

/// A diagnosis.
pub struct Diagnosed {
    /// What was found.
    pub report: Report,
    /// The fit of the model.
    pub before: Fitted,
    /// The extended model and its fit, where there is one.
    pub after: Option<(Extension, Fitted)>,
}

/// Why there is none.
#[derive(Debug, thiserror::Error)]
pub enum DiagnosisError {
    /// The flights cannot be fitted.
    #[error(transparent)]
    Fit(#[from] FitError),
    /// The model cannot be loaded.
    #[error("{0}")]
    Load(#[from] LoadError),
}

/// Finds what a model gets wrong of a dataset's flights.
///
/// # Errors
/// Where the flights cannot be fitted.
pub fn diagnose(
    model: &Model,
    dataset: &Dataset,
    asked: &Asked<'_>,
) -> Result<Diagnosed, DiagnosisError> {
    diagnose_beside(model, dataset, asked, |_| ()).map(|(diagnosed, _)| diagnosed)
}

/// The same, with what `beside` makes of the extension, where there is one, while its gain is measured.
///
/// # Errors
/// Where the flights cannot be fitted.
pub fn diagnose_beside<R: Send>(
    model: &Model,
    dataset: &Dataset,
    asked: &Asked<'_>,
    beside: impl FnOnce(&Extension) -> R + Send,
) -> Result<(Diagnosed, Option<R>), DiagnosisError> {
    let threads = asked.fit.threads();
    let clock = Instant::now();
    let mut seconds = BTreeMap::new();
    // The candidates are made ready while the flights are fitted.
    let (catalogue, before) = both(
        threads,
        || Catalogue::new(model, asked.with, asked.without),
        || fit(model, dataset, &asked.fit),
    );
    let (before, catalogue) = (before?, catalogue?);
    seconds.insert("fit".to_owned(), clock.elapsed().as_secs_f64());
    let (mut bench, base) = Bench::new(&catalogue, dataset, &before, &asked.fit)?;
    let mut found = search(&mut bench, &base, before.noise())?;
    let mut written = None;
    if found.alarmed && found.causes.is_empty() {
        let place = outside::Place {
            model,
            dataset,
            asked,
        };
        let single = found
            .nearest
            .iter()
            .find(|c| bench.size_of(&c.effects) <= FEW);
        written = outside::write(place, &bench, &found, None)?;
        // What no term alone explains may be the best effect with terms beside it.
        if let (Some(single), false) = (single, written.as_ref().is_some_and(|w| w.stands)) {
            let beside = outside::write(place, &bench, &found, Some(single))?;
            written = better(written, beside);
        }
        search_on(&bench, &mut found)?;
        if found.causes.is_empty() && !written.as_ref().is_some_and(|written| written.stands) {
            search_on(&bench, &mut found)?;
        }
        found.causes = by_size(&bench, found.causes, written.as_ref(), 0);
    } else {
        found.causes = by_size(&bench, found.causes, None, FEW);
    }
    seconds.insert("search".to_owned(), clock.elapsed().as_secs_f64());

    let mut report = told(model, asked, &before, &bench, &found);
    if found.causes.len() > 1 {
        let blocks = bench.look(
            &found.causes[0].setting,
            &found.causes[0].point,
            &found.noise,
        )?;
        report.next_throw = next_throw(&bench, &found.causes, &blocks, &found.noise, 1);
    }
    let mut chosen = None;
    let mut gained = 0.0;
    if let Some(best) = found.causes.first() {
        let each = best.effects.iter();
        let names = each.map(|&e| underscored(&bench.candidates[e].candidate.name));
        let extension = Extension::new(model, asked.with, names.collect(), Vec::new())?;
        chosen = Some((extension, None));
    } else if let Some(written) = written {
        let mut channels = outside::channels(&bench, &found.scores);
        histories::fill(&mut channels, &bench, &base, &found.noise);
        report.outside = Some(Outside {
            says: words::outside(&written),
            channels,
            terms: written.told,
        });
        gained = (found.squares - written.squares).max(0.0);
        chosen = written
            .model
            .map(|(extension, fitted)| (extension, Some(fitted)));
    }
    let mut after = None;
    let mut made = None;
    if let Some((extension, fitted)) = chosen {
        let floor = report.noise.sigma_m;
        let held_out = dataset.flights.iter().any(|f| f.role == Role::HeldOut);
        // None of the three needs what another finds.
        let (by_turns, (besides, fitted)) = both(
            threads,
            || match held_out {
                true => Ok(None),
                false => gain::by_turns([model, &extension.model], dataset, &asked.fit, floor),
            },
            || {
                both(
                    threads,
                    || beside(&extension),
                    || fitted.map_or_else(|| fit(&extension.model, dataset, &asked.fit), Ok),
                )
            },
        );
        let fitted = fitted?;
        take_over(&mut report, (&extension, gained), &before, &fitted);
        report.gain = match held_out {
            true => gain::by_held_out(&before.report, &fitted.report, floor),
            false => by_turns?,
        };
        let fits: Vec<usize> = (0..dataset.flights.len())
            .filter(|&k| dataset.flights[k].role == Role::Fit)
            .collect();
        let evidence = |fitted: &Fitted| -> Vec<FlightEvidence> {
            let each = batch::each_on(bench.threads, fits.len(), |k| fitted.evidence(fits[k]));
            each.into_iter().flatten().collect()
        };
        report.curves = curves(model, &evidence(&before), &evidence(&fitted));
        after = Some((extension, fitted));
        made = Some(besides);
    }
    report.summary = words::summary(&report);
    seconds.insert("total".to_owned(), clock.elapsed().as_secs_f64());
    report.seconds = seconds;
    let diagnosed = Diagnosed {
        report,
        before,
        after,
    };
    Ok((diagnosed, made))
}

/// The report of what was found, before anything is extended.
fn told(model: &Model, asked: &Asked<'_>, before: &Fitted, bench: &Bench, found: &Found) -> Report {
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
    let (points, outliers) = bench
        .tracks
        .iter()
        .fold((0, 0), |(points, outliers), track| {
            (
                points + track.seen.iter().flatten().count(),
                outliers + track.outlier.iter().filter(|o| **o).count(),
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
                let name = bench.setting.shared[unknown].name.clone();
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
    let known = bench.setting.shared.len();
    let at: Vec<usize> = (0..scores.columns.len())
        .filter(|&i| scores.columns[i] < known && scores.information[(i, i)] > 1e-8)
        .collect();
    let matrix = correlations(&scores.information);
    Alike {
        names: at
            .iter()
            .map(|&i| bench.setting.shared[scores.columns[i]].name.clone())
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
        for (part, &unknown) in columns.candidate.coefficients.iter().zip(&columns.shared) {
            let value = cause.point.shared[unknown];
            let departure = (value - part.vanishes_at).abs();
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
            let own = cause
                .point
                .own
                .iter()
                .map(|own| own[part.index] - part.vanishes_at);
            let count = cause.point.own.len().max(1) as f64;
            let value = (own.map(|v| v * v).sum::<f64>() / count).sqrt();
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

/// Of two that were written the one that stands, or else the one that leaves less.
fn better(
    one: Option<outside::Written>,
    other: Option<outside::Written>,
) -> Option<outside::Written> {
    let rank = |written: &outside::Written| (!written.stands, written.squares);
    match (one, other) {
        (Some(one), Some(other)) if rank(&other) < rank(&one) => Some(other),
        (one, other) => one.or(other),
    }
}

/// A single cause of no more unknowns does not pay for them.
const FEW: usize = 6;

/// Causes that are so much worse than the best, once their unknowns are paid for, are none.
const WORSE: f64 = 12.0;

/// Of causes of several effects those that are as good as the best once their unknowns are paid for (Schwarz): with more effects at
/// once, and some that each flight has for itself, nearly anything can be explained. None where terms that were
/// written explain it better. Causes of no more than `free` unknowns do not pay.
fn by_size(
    bench: &Bench,
    causes: Vec<Cause>,
    written: Option<&outside::Written>,
    free: usize,
) -> Vec<Cause> {
    let seen = |track: &Track| track.seen.iter().flatten().count();
    let residuals = 3 * bench.tracks.iter().map(seen).sum::<usize>();
    let price = (residuals.max(2) as f64).ln();
    let cost = |cause: &Cause| cause.squares + price * bench.size_of(&cause.effects) as f64;
    let of_terms = written
        .filter(|written| written.stands)
        .map_or(f64::INFINITY, |w| w.squares + price * w.taken.len() as f64);
    let least = causes.iter().map(cost).fold(of_terms, f64::min);
    if of_terms <= least {
        return Vec::new();
    }
    let kept = |cause: &Cause| bench.size_of(&cause.effects) <= free || cost(cause) < least + WORSE;
    causes.into_iter().filter(kept).collect()
}

/// Takes the extended model's fit into the report.
fn take_over(
    report: &mut Report,
    (extension, gained): (&Extension, f64),
    before: &Fitted,
    after: &Fitted,
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
                .filter_map(|own| {
                    let constant = &extension.model.coefficients[own.index];
                    let found = after.report.coefficients.get(&constant.name)?;
                    let estimate = Estimate {
                        value: found.value,
                        std_error: found.std_error,
                        unit: constant.unit_text.clone(),
                        negligible: own.negligible,
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
