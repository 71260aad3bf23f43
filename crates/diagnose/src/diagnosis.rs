//! The diagnosis from fit to report.

use std::collections::BTreeMap;
use std::time::Instant;

use flight::batch;
use identify::dataset::{Dataset, Role};
use identify::{Fit, FitError, FitOptions, FlightEvidence, Observations, fit};
use model_spec::load::LoadError;
use model_spec::model::Model;

use crate::agree::agreed;
use crate::bench::Bench;
use crate::beside::both;
use crate::catalogue::Catalogue;
use crate::causes::{Cause, search, search_on};
use crate::curves::curves;
use crate::extend::Extension;
use crate::gain::Believed;
use crate::outside;
use crate::report::{Agreement, Gain, Outside, Report, Verdict};
use crate::telling::{by_scatter, not_believed, take_over, told};
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
    pub fit: FitOptions<'a>,
}

/// A diagnosis.
pub struct Diagnosed {
    /// What was found.
    pub report: Report,
    /// The fit of the model.
    pub before: Fit,
    /// The extended model and its fit, where there is one.
    pub after: Option<(Extension, Fit)>,
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
    beside: impl Fn(&Extension) -> R + Sync,
) -> Result<(Diagnosed, Option<R>), DiagnosisError> {
    looked(model, dataset, asked, &beside, true)
}

/// The same without the flights that contradict what most agree on, where that explains the others.
fn without<R: Send>(
    model: &Model,
    dataset: &Dataset,
    asked: &Asked<'_>,
    beside: &(impl Fn(&Extension) -> R + Sync),
    (contradicting, chance): (Vec<String>, f64),
) -> Result<Option<(Diagnosed, Option<R>)>, DiagnosisError> {
    let mut rest = dataset.clone();
    rest.flights
        .retain(|flight| !contradicting.contains(&flight.file));
    let (mut found, made) = looked(model, &rest, asked, beside, false)?;
    let report = &mut found.report;
    if report.verdict == Verdict::Outside || report.causes.is_empty() {
        return Ok(None);
    }
    let fitted = rest
        .flights
        .iter()
        .filter(|flight| flight.role == Role::Fit);
    report.agreement = Some(Agreement {
        flights: fitted.count(),
        part: report
            .agreement
            .as_ref()
            .and_then(|agreement| agreement.part),
        chance,
        contradicting,
    });
    report.summary = words::summary(report);
    Ok(Some((found, made)))
}

fn looked<R: Send>(
    model: &Model,
    dataset: &Dataset,
    asked: &Asked<'_>,
    beside: &(impl Fn(&Extension) -> R + Sync),
    may_leave_out: bool,
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
    let place = outside::Place {
        model,
        dataset,
        asked,
    };
    let mut written = None;
    let mut agreement = None;
    if found.alarmed && found.causes.is_empty() {
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
        if found.causes.is_empty()
            && !written.as_ref().is_some_and(|written| written.stands)
            && let Some(agreed) = agreed(&bench, &found, &base)?
        {
            let file = |&flight: &usize| bench.observation_sets[flight].file.clone();
            let contradicting: Vec<String> = agreed.contradicting.iter().map(file).collect();
            if !contradicting.is_empty()
                && may_leave_out
                && let Some(mut done) = without(
                    model,
                    dataset,
                    asked,
                    beside,
                    (contradicting, agreed.chance),
                )?
            {
                let all = clock.elapsed().as_secs_f64();
                done.0.report.seconds.insert("total".to_owned(), all);
                return Ok(done);
            }
            if !agreed.causes.is_empty() {
                found.causes = agreed.causes;
                agreement = Some(Agreement {
                    flights: bench.observation_sets.len(),
                    part: Some(agreed.part),
                    chance: agreed.chance,
                    contradicting: Vec::new(),
                });
            }
        }
    } else {
        found.causes = by_size(&bench, found.causes, None, FEW);
    }
    let mut tried = None;
    let mut refused = None;
    if let Some(best) = found.causes.first().filter(|best| bench.is_supple(best)) {
        let with_it = bench.tried(place, best, &before, found.noise.overall())?;
        if with_it.predicts() {
            tried = Some(with_it);
        } else {
            found.causes.retain(|cause| !bench.is_supple(cause));
            refused = Some(words::refused(&with_it));
            if found.causes.is_empty() && written.is_none() {
                written = outside::write(place, &bench, &found, None)?;
            }
        }
    }
    seconds.insert("search".to_owned(), clock.elapsed().as_secs_f64());

    let mut report = told(model, asked, &before, &bench, &found);
    report.agreement = agreement;
    report.notes.extend(refused);
    if found.causes.len() > 1 {
        let blocks = bench.look(
            &found.causes[0].problem,
            &found.causes[0].point,
            &found.noise,
        )?;
        report.next_throw = next_throw(&bench, &found.causes, &blocks, &found.noise, 1);
    }
    let mut chosen = None;
    let mut gained = 0.0;
    let mut known_gain = None;
    if let Some(tried) = tried {
        known_gain = tried.gain;
        chosen = Some((tried.extension, Some(tried.fitted)));
    } else if let Some(best) = found.causes.first() {
        chosen = Some((bench.extension(place, best)?, None));
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
    let (mut after, mut made) = (None, None);
    if let Some(chosen) = chosen {
        let (extended, besides) = measured(
            place,
            &before,
            &mut report,
            (chosen, gained, known_gain),
            beside,
        )?;
        after = Some(extended);
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

/// Fits the extended model where that was not done, measures what it gains, and puts both into the report; and what `beside`
/// makes of it.
fn measured<R: Send>(
    place: outside::Place<'_>,
    before: &Fit,
    report: &mut Report,
    ((extension, fitted), gained, known_gain): ((Extension, Option<Fit>), f64, Option<Gain>),
    beside: &(impl Fn(&Extension) -> R + Sync),
) -> Result<((Extension, Fit), R), DiagnosisError> {
    let outside::Place {
        model,
        dataset,
        asked,
    } = place;
    let threads = asked.fit.threads();
    let floor = report.noise.sigma_m;
    let believed = match report.agreement {
        Some(_) => Believed::UnlessContradicted,
        None => Believed::Always,
    };
    let held_out = dataset.flights.iter().any(|f| f.role == Role::HeldOut);
    // None of the three needs what another finds.
    let (by_turns, (besides, fitted)) = both(
        threads,
        || match held_out || known_gain.is_some() {
            true => Ok(known_gain),
            false => {
                let models = [model, &extension.model];
                gain::by_turns(models, dataset, &asked.fit, believed, floor)
            }
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
    take_over(report, (&extension, gained), before, &fitted);
    if report.agreement.is_some() {
        by_scatter(report, &fitted);
    }
    report.gain = match held_out {
        true => {
            let without = believed.without(before, &fitted);
            not_believed(report, &without);
            gain::by_fits(before, &fitted, &without, floor)
        }
        false => by_turns?,
    };
    let fits: Vec<usize> = (0..dataset.flights.len())
        .filter(|&k| dataset.flights[k].role == Role::Fit)
        .collect();
    let evidence = |fitted: &Fit| -> Vec<FlightEvidence> {
        let each = batch::each_on(threads, fits.len(), |k| fitted.evidence(fits[k]));
        each.into_iter().flatten().collect()
    };
    report.curves = curves(model, &evidence(before), &evidence(&fitted));
    Ok(((extension, fitted), besides))
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

/// Sums of squares that differ by less say the same.
const ALIKE: f64 = 1.0;

/// Of causes of several effects those that are as good as the best once their unknowns are paid for (Schwarz): with more effects at
/// once, and some that each flight has for itself, nearly anything can be explained. None where terms that were
/// written explain it better. Causes of no more than `free` unknowns do not pay.
fn by_size(
    bench: &Bench,
    causes: Vec<Cause>,
    written: Option<&outside::Written>,
    free: usize,
) -> Vec<Cause> {
    let seen = |observations: &Observations| observations.measured.iter().flatten().count();
    let residuals = 3 * bench.observation_sets.iter().map(seen).sum::<usize>();
    let price = (residuals.max(2) as f64).ln();
    let cost = |cause: &Cause| cause.squares + price * bench.size_of(&cause.effects) as f64;
    let of_terms = written.filter(|written| written.stands);
    let of_terms = of_terms.map_or(f64::INFINITY, |terms| {
        terms.squares + price * (terms.taken.len() + terms.beside) as f64
    });
    let of_causes = causes.iter().map(cost).fold(f64::INFINITY, f64::min);
    // An effect of the catalogue that is a term under another name goes before it.
    if of_terms < of_causes - ALIKE {
        return Vec::new();
    }
    let least = of_causes.min(of_terms);
    let kept = |cause: &Cause| bench.size_of(&cause.effects) <= free || cost(cause) < least + WORSE;
    causes.into_iter().filter(kept).collect()
}
