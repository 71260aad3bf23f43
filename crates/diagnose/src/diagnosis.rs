//! Stages of a diagnosis, from the fit of the model under test to the report.

mod analysis;
mod beyond_single_effects;

use std::time::Instant;

use dataset::{Dataset, Role};
use identify::{Fit, FitOptions};
use model_spec::model::Model;

use analysis::Analysis;

use crate::base_fit::BaseFit;
use crate::context::{Context, DiagnosisOptions, of_missing_poses, of_stated_inputs};
use crate::error::DiagnosisError;
use crate::extension::ExtendedModel;
use crate::report::{self, Consensus, Report, Verdict, Verified};

/// Result of a diagnosis: the report, the fits, and the model extended by the effects found, if any.
pub struct Diagnosis {
    /// Report of the diagnosis, as written to `report.json`.
    pub report: Report,
    /// Fit of the model under test, without added effects.
    pub before: Fit,
    /// The model extended by the missing effects that were found, and its fit; `None` if the model is not extended.
    pub after: Option<(ExtendedModel, Fit)>,
}

impl Diagnosis {
    /// Records the result of verifying the extended model. A refuted model makes the diagnosis unreliable.
    pub fn set_verified(&mut self, verified: Option<Verified>) {
        let after = self.after.as_ref().map(|(_, fit)| fit);
        self.report.assess(&self.before, after, verified);
    }
}

/// Tests a model against the flights of a dataset, identifies effects that it lacks, and measures how far they reduce
/// the out-of-sample prediction error.
///
/// # Errors
/// [`DiagnosisError`] if an option is invalid, the flights cannot be fitted, or the caller cancelled.
pub fn diagnose(
    model: &Model,
    dataset: &Dataset,
    options: &DiagnosisOptions<'_>,
) -> Result<Diagnosis, DiagnosisError> {
    options.validate(model)?;
    let started = Instant::now();
    // Effects on sensor readings need the quantities that the instruments measure.
    let resolved = identify::resolve(model, dataset, &options.fit)?;
    let (model, dataset) = (&resolved.model, &*resolved.dataset);
    let mut without = of_stated_inputs(model, dataset);
    without.extend(of_missing_poses(dataset));
    without.extend_from_slice(options.without);
    let options = &DiagnosisOptions {
        fit: resolved.options(&options.fit),
        without: &without,
        ..*options
    };
    let base = BaseFit::new(Context {
        model,
        dataset,
        options,
    })?;
    // Later fits reuse the data faults that the screening of the first fit found.
    let report = &base.fit.report;
    let faults = report.data_faults.clone();
    // What makes up for a constant in another unit is no effect that the model lacks.
    let deadline = match report.has_misstated_constant() {
        true => Some(started),
        false => options.fit.deadline,
    };
    let options = &DiagnosisOptions {
        fit: FitOptions {
            known_faults: Some(&faults),
            trust_data: options.fit.trust_data || base.is_despite_faults,
            deadline,
            ..options.fit
        },
        ..*options
    };
    let context = Context {
        model,
        dataset,
        options,
    };
    let analysis = Analysis::new(context, base)?;
    if let Some(discordant) = &analysis.discordant
        && let Some(mut done) = without_discordant(context, discordant)?
    {
        let total = started.elapsed().as_secs_f64();
        done.report.seconds.insert("total".to_owned(), total);
        return Ok(done);
    }
    analysis.finish()
}

/// Discordant flights: they contradict the explanation that holds for all other flights.
struct Discordant {
    files: Vec<String>,
    p_value: f64,
}

/// Repeats a diagnosis without the discordant flights; `None` if nothing explains the others.
fn without_discordant(
    context: Context<'_>,
    discordant: &Discordant,
) -> Result<Option<Diagnosis>, DiagnosisError> {
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
    let base = BaseFit::new(context)?;
    let mut found = Analysis::new(context, base)?.finish()?;
    let report = &mut found.report;
    if report.verdict == Verdict::Unattributed || report.explanations.is_empty() {
        return Ok(None);
    }
    let explained_fraction = report
        .consensus
        .as_ref()
        .and_then(|consensus| consensus.explained_fraction);
    report.consensus = Some(Consensus {
        flights: fitted,
        explained_fraction,
        p_value: discordant.p_value,
        discordant: discordant.files.clone(),
    });
    report.summary = report::summary(report);
    Ok(Some(found))
}
