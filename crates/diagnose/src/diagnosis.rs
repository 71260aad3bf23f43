//! The stages of a diagnosis, from the fit of the model to the report.

use std::collections::BTreeMap;
use std::time::Instant;

use flight::batch;
use identify::dataset::{Dataset, Role};
use identify::{Fit, FlightEvidence, FlightId, Iterate, fit};
use model_spec::model::Model;

use crate::consensus::consensus;
use crate::context::{Context, DiagnosisOptions, EncompassingModel, ScoreTestModel};
use crate::error::DiagnosisError;
use crate::extension::ExtendedModel;
use crate::lack_of_fit::LackOfFit;
use crate::noise::random_walk_loads;
use crate::optimal_design::next_throw;
use crate::report::{self, Consensus, Report, Verdict};
use crate::selection::{Search, StepwiseModel, select_by_bic, stepwise_terms};
use crate::validation::{ApplyTo, PredictiveGain, Validated, cross_validate, gain_of_fits};

/// Greatest number of unknowns of a single-effect hypothesis exempt from the BIC comparison.
const FREE_UNKNOWNS: usize = 6;

/// Result of a diagnosis.
pub struct Diagnosis {
    /// The report.
    pub report: Report,
    /// Fit of the model under test, without an extension.
    pub before: Fit,
    /// The extended model and its fit; `None` if the model is not extended.
    pub after: Option<(ExtendedModel, Fit)>,
}

/// Tests a model for errors in the flights of a dataset, identifies missing effects, and measures the out-of-sample
/// gain of the extended model.
///
/// # Errors
/// [`DiagnosisError`] if an option cannot be used, the flights cannot be fitted, or the caller cancelled.
pub fn diagnose(
    model: &Model,
    dataset: &Dataset,
    options: &DiagnosisOptions<'_>,
) -> Result<Diagnosis, DiagnosisError> {
    diagnose_with(model, dataset, options, |_| ()).map(|(diagnosis, _)| diagnosis)
}

/// Runs [`diagnose`], and calls `on_extension` with the extended model, if any, while its gain is measured.
///
/// # Errors
/// Those of [`diagnose`].
pub fn diagnose_with<R: Send>(
    model: &Model,
    dataset: &Dataset,
    options: &DiagnosisOptions<'_>,
    on_extension: impl Fn(&ExtendedModel) -> R + Sync,
) -> Result<(Diagnosis, Option<R>), DiagnosisError> {
    options.validate(model)?;
    let context = Context {
        model,
        dataset,
        options,
    };
    let started = Instant::now();
    let analysis = Analysis::new(context)?;
    if let Some(discordant) = &analysis.discordant
        && let Some(mut done) = without_discordant(context, discordant, &on_extension)?
    {
        let total = started.elapsed().as_secs_f64();
        done.0.report.seconds.insert("total".to_owned(), total);
        return Ok(done);
    }
    analysis.finish(&on_extension)
}

/// Discordant flights, and the explanation that holds for all other flights.
struct Discordant {
    files: Vec<String>,
    p_value: f64,
}

/// Repeats a diagnosis without the discordant flights; `None` if the remaining flights are not explained either.
fn without_discordant<R: Send>(
    context: Context<'_>,
    discordant: &Discordant,
    on_extension: &(impl Fn(&ExtendedModel) -> R + Sync),
) -> Result<Option<(Diagnosis, Option<R>)>, DiagnosisError> {
    let mut concordant = context.dataset.clone();
    let flights = &mut concordant.flights;
    flights.retain(|flight| !discordant.files.contains(&flight.file));
    let fitted = flights
        .iter()
        .filter(|flight| flight.role == Role::Fit)
        .count();
    let context = Context {
        dataset: &concordant,
        ..context
    };
    let mut found = Analysis::new(context)?.finish(on_extension)?;
    let report = &mut found.0.report;
    if report.verdict == Verdict::Unattributed || report.causes.is_empty() {
        return Ok(None);
    }
    let explained = report
        .consensus
        .as_ref()
        .and_then(|consensus| consensus.explained);
    report.consensus = Some(Consensus {
        flights: fitted,
        explained,
        p_value: discordant.p_value,
        discordant: discordant.files.clone(),
    });
    report.summary = report::summary(report);
    Ok(Some(found))
}

/// Computing time by stage.
struct Clock {
    started: Instant,
    seconds: BTreeMap<String, f64>,
}

impl Clock {
    fn start() -> Self {
        Self {
            started: Instant::now(),
            seconds: BTreeMap::new(),
        }
    }

    /// Records the time since the stage's start under its name.
    fn record(&mut self, stage: &str) {
        let elapsed = self.started.elapsed().as_secs_f64();
        self.seconds.insert(stage.to_owned(), elapsed);
    }
}

/// State of a diagnosis whose explanations are found but not yet validated.
struct Analysis<'a> {
    context: Context<'a>,
    clock: Clock,
    before: Fit,
    /// Test of the residuals of the model under test.
    residuals: Option<LackOfFit>,
    model: ScoreTestModel,
    /// The fit of the model under test, in the score-test model.
    base: Iterate,
    search: Search<'a>,
    stepwise: Option<StepwiseModel>,
    consensus: Option<Consensus>,
    discordant: Option<Discordant>,
}

/// Model that was chosen as the extension of the model under test.
struct Chosen {
    extension: ExtendedModel,
    /// Fit of the extended model; `None` if not yet fitted.
    fit: Option<Fit>,
    /// Out-of-sample gain; `None` if not yet measured.
    gain: Option<PredictiveGain>,
    /// Decrease of the weighted sum of squares, χ²; used for effects generated from library terms.
    chi2_decrease: f64,
}

impl<'a> Analysis<'a> {
    /// Fits the model under test, tests all candidates and searches for explanations.
    fn new(context: Context<'a>) -> Result<Self, DiagnosisError> {
        let mut clock = Clock::start();
        let Context {
            model,
            dataset,
            options,
        } = context;
        let (encompassing, before) = join(
            options.fit.threads(),
            || EncompassingModel::new(model, options.without),
            || fit(model, dataset, &options.fit),
        );
        let (before, encompassing) = (before?, encompassing?);
        clock.record("fit");
        let (mut model, base) = ScoreTestModel::new(encompassing, context, &before)?;
        let threads = options.fit.threads();
        let (search, residuals) = join(
            threads,
            || Search::new(&mut model, &base, before.noise(), context),
            || LackOfFit::of_fit(&before, threads),
        );
        let (mut search, residuals) = (search?, residuals?);
        let unexplained = residuals
            .as_ref()
            .filter(|residuals| residuals.p < options.alpha_detect);
        if let Some(residuals) = unexplained
            && !search.is_significant()
        {
            // The noise that the model leaves hides what the noise floor shows.
            search = Search::with_noise(&mut model, &base, residuals.noise, context)?;
        }
        let mut analysis = Self {
            context,
            clock,
            before,
            residuals,
            model,
            base,
            search,
            stepwise: None,
            consensus: None,
            discordant: None,
        };
        if analysis.search.is_significant() && analysis.search.accepted.is_empty() {
            analysis.search_beyond_single_effects()?;
        } else {
            analysis.select_by_bic(FREE_UNKNOWNS);
        }
        Ok(analysis)
    }

    fn select_by_bic(&mut self, free: usize) {
        let accepted = std::mem::take(&mut self.search.accepted);
        let stepwise = self.stepwise.as_ref();
        self.search.accepted = select_by_bic(&self.model, accepted, stepwise, free);
    }

    fn has_adequate_terms(&self) -> bool {
        let stepwise = self.stepwise.as_ref();
        stepwise.is_some_and(|stepwise| stepwise.is_adequate)
    }

    /// Searches for explanations if no single candidate is adequate: library terms, several candidates, or agreement
    /// between flights.
    fn search_beyond_single_effects(&mut self) -> Result<(), DiagnosisError> {
        let (context, model) = (self.context, &self.model);
        self.stepwise = stepwise_terms(context, model, &self.search, None)?;
        let few = |effects: &[_]| model.unknowns_of(effects) <= FREE_UNKNOWNS;
        let single = self.search.rejected.iter().find(|h| few(&h.effects));
        // What no term alone explains may be the best candidate with terms beside it.
        if let (Some(single), false) = (single, self.has_adequate_terms()) {
            let beside = stepwise_terms(context, model, &self.search, Some(single))?;
            self.stepwise = StepwiseModel::better(self.stepwise.take(), beside);
        }
        self.search.add_effect(model)?;
        if self.search.accepted.is_empty() && !self.has_adequate_terms() {
            self.search.add_effect(model)?;
        }
        self.select_by_bic(0);
        if self.search.accepted.is_empty() && !self.has_adequate_terms() {
            self.search_consensus()?;
        }
        Ok(())
    }

    /// Accepts hypotheses on which the flights agree, if there are any.
    fn search_consensus(&mut self) -> Result<(), DiagnosisError> {
        let found = consensus(self.context, &self.model, &self.search, &self.base)?;
        let Some(found) = found else {
            return Ok(());
        };
        if !found.discordant.is_empty() {
            let files = found.discordant.iter();
            self.discordant = Some(Discordant {
                files: files
                    .map(|&flight| self.model.flights[flight].file.clone())
                    .collect(),
                p_value: found.p_value,
            });
        }
        if !found.hypotheses.is_empty() {
            self.search.accepted = found.hypotheses;
            self.consensus = Some(Consensus {
                flights: self.model.flights.len(),
                explained: Some(found.explained),
                p_value: found.p_value,
                discordant: Vec::new(),
            });
        }
        Ok(())
    }

    /// Validates the explanations, extends the model and writes the report.
    fn finish<R: Send>(
        mut self,
        on_extension: &(impl Fn(&ExtendedModel) -> R + Sync),
    ) -> Result<(Diagnosis, Option<R>), DiagnosisError> {
        let (validated, refused) = self.validate_overflexible()?;
        self.clock.record("search");
        let (context, search) = (self.context, &self.search);
        let fitted = (&self.before, self.residuals.as_ref());
        let mut report = report::build_report(context, fitted, &self.model, search);
        report.consensus = self.consensus.take();
        report.notes.extend(refused);
        report.next_throw = next_throw(&self.model, search, &context.options.throws)?;
        let chosen = self.choose(validated, &mut report)?;
        let (mut after, mut made) = (None, None);
        if let Some(chosen) = chosen {
            let before = &self.before;
            let (extended, from_extension) =
                measure(context, before, &mut report, chosen, on_extension)?;
            let residuals = LackOfFit::of_fit(&extended.1, context.options.fit.threads())?;
            report::add_residuals(&mut report, residuals);
            after = Some(extended);
            made = Some(from_extension);
        }
        report::describe_departures(&mut report);
        report.summary = report::summary(&report);
        self.clock.record("total");
        report.seconds = self.clock.seconds;
        let diagnosis = Diagnosis {
            report,
            before: self.before,
            after,
        };
        Ok((diagnosis, made))
    }

    /// Validates the best explanation if it is overflexible. Returns it if it improves predictions; otherwise drops
    /// such explanations and returns the reason as the second value.
    fn validate_overflexible(
        &mut self,
    ) -> Result<(Option<Validated>, Option<String>), DiagnosisError> {
        let (context, model) = (self.context, &self.model);
        let best = self.search.accepted.first();
        let Some(best) = best.filter(|best| best.is_overflexible(model)) else {
            return Ok((None, None));
        };
        let noise = self.search.noise.overall();
        let validated = Validated::new(context, model, best, &self.before, noise)?;
        if validated.is_accepted() {
            return Ok((Some(validated), None));
        }
        self.search.accepted.retain(|h| !h.is_overflexible(model));
        if self.search.accepted.is_empty() && self.stepwise.is_none() {
            self.stepwise = stepwise_terms(context, model, &self.search, None)?;
        }
        Ok((None, Some(report::refused(&validated))))
    }

    /// Chooses the extension: the best explanation, or library terms if there is none, which are then added to the
    /// report.
    fn choose(
        &mut self,
        validated: Option<Validated>,
        report: &mut Report,
    ) -> Result<Option<Chosen>, DiagnosisError> {
        if let Some(validated) = validated {
            return Ok(Some(Chosen {
                extension: validated.extension,
                fit: Some(validated.fit),
                gain: validated.gain,
                chi2_decrease: 0.0,
            }));
        }
        if let Some(best) = self.search.accepted.first() {
            return Ok(Some(Chosen {
                extension: best.extension(self.context, &self.model)?,
                fit: None,
                gain: None,
                chi2_decrease: 0.0,
            }));
        }
        let Some(stepwise) = self.stepwise.take() else {
            return Ok(None);
        };
        let (model, search) = (&self.model, &self.search);
        let histories = random_walk_loads(model, &self.base, &search.noise);
        let found = report::unattributed_report(model, search, &stepwise, histories);
        report.unattributed = Some(found);
        let chi2_decrease = (search.squares - stepwise.squares).max(0.0);
        Ok(stepwise.fitted.map(|(extension, fit)| Chosen {
            extension,
            fit: Some(fit),
            gain: None,
            chi2_decrease,
        }))
    }
}

/// Fits the extended model if not yet fitted, measures its gain, adds both to the report, and calls `on_extension`.
fn measure<R: Send>(
    context: Context<'_>,
    before: &Fit,
    report: &mut Report,
    chosen: Chosen,
    on_extension: &(impl Fn(&ExtendedModel) -> R + Sync),
) -> Result<((ExtendedModel, Fit), R), DiagnosisError> {
    let Context {
        model,
        dataset,
        options,
    } = context;
    let threads = options.fit.threads();
    let noise_floor = report.noise.sigma_m;
    let apply_to = match report.consensus {
        Some(_) => ApplyTo::ConcordantFlights,
        None => ApplyTo::AllFlights,
    };
    let has_held_out = context.has_held_out();
    let Chosen {
        extension,
        fit: known_fit,
        gain: known_gain,
        chi2_decrease,
    } = chosen;
    // None of the three depends on another.
    let (cross_validated, (made, after)) = join(
        threads,
        || match has_held_out || known_gain.is_some() {
            true => Ok(known_gain.clone()),
            false => {
                let models = [model, &extension.model];
                cross_validate(models, dataset, &options.fit, apply_to, noise_floor)
            }
        },
        || {
            join(
                threads,
                || on_extension(&extension),
                || known_fit.map_or_else(|| fit(&extension.model, dataset, &options.fit), Ok),
            )
        },
    );
    let after = after?;
    report::add_extension(report, (&extension, chi2_decrease), before, &after);
    if report.consensus.is_some() {
        report::use_clustered_errors(report, &after);
    }
    report.gain = match has_held_out {
        true => {
            let not_applied = apply_to.exceptions(before, &after);
            report::note_not_applied(report, &not_applied);
            gain_of_fits(before, &after, &not_applied, noise_floor)
        }
        false => cross_validated?,
    };
    let [was, is] = [before, &after].map(|fit| evidence(context, fit));
    report.curves = report::curves(model, &was, &is);
    Ok(((extension, after), made))
}

/// Measured and predicted samples of the fitted flights.
fn evidence(context: Context<'_>, fit: &Fit) -> Vec<FlightEvidence> {
    let flights = context.dataset.flights.iter().enumerate();
    let fitted = flights.filter(|(_, flight)| flight.role == Role::Fit);
    let fitted: Vec<FlightId> = fitted.map(|(index, _)| FlightId::new(index)).collect();
    let threads = context.options.fit.threads();
    let each = batch::each_on(threads, fitted.len(), |k| fit.evidence(fitted[k]));
    each.into_iter().flatten().collect()
}

/// Calls both functions, in parallel if `threads` exceeds 1, and returns both results.
fn join<A: Send, B: Send>(
    threads: usize,
    first: impl FnOnce() -> A + Send,
    second: impl FnOnce() -> B + Send,
) -> (A, B) {
    match threads <= 1 {
        true => (first(), second()),
        false => rayon::join(first, second),
    }
}
