//! Out-of-sample gain of extended models, by 2-fold cross-validation over flights or on held-out ones.

use flight::parallel;
use identify::{CONDITIONING_FRACTION, Fit, FitOptions, FlightId, Moments, fit, refit};
use model_spec::model::Model;

use super::predictive_gain::{Predictions, PredictiveGain, held_out_gain, predictions, summarize};
use crate::context::{Context, ScoreTestModel, identifier};
use crate::error::DiagnosisError;
use crate::extension::ExtendedModel;
use crate::selection::{Hypothesis, StepwiseModel};
use dataset::{Dataset, Role};

const FOLDS: usize = 2;

/// Gain of the second model over the first, each with its fit to all flights: each fold is predicted by a fit of the
/// others, which starts there. `None` for fewer than two flights, or if none is predicted.
pub(crate) fn cross_validate(
    models: [(&Model, &Fit); 2],
    dataset: &Dataset,
    options: &FitOptions<'_>,
    apply_to: ApplyTo,
    noise_m: f64,
) -> Option<PredictiveGain> {
    if dataset.flights.len() < 2 {
        return None;
    }
    let threads = options.threads();
    let options = FitOptions {
        threads: Some(1.max(threads / (2 * FOLDS))),
        profiles: &[],
        ..*options
    };
    let fits = parallel::each_on(threads, 2 * FOLDS, |index| {
        let (model, to_all) = models[index % 2];
        let split = with_fold_held_out(dataset, index / 2);
        refit(model, &split, &options, to_all)
    });
    let mut all = Predictions::default();
    for pair in fits.chunks(2) {
        if let [Ok(before), Ok(after)] = pair {
            let not_applied = apply_to.exceptions(before, after);
            let (before, after) = (&before.report, &after.report);
            all.join(predictions(before, after, &not_applied, noise_m));
        }
    }
    summarize(all, noise_m, false)
}

/// Gain of the second model over the first, each with its fit: on held-out flights of the dataset, or else by
/// cross-validation. `noise_m` is that of a coordinate, m.
pub(super) fn out_of_sample_gain(
    context: Context<'_>,
    models: [(&Model, &Fit); 2],
    noise_m: f64,
) -> Option<PredictiveGain> {
    if context.has_held_out() {
        let [before, after] = models.map(|(_, fit)| &fit.report);
        return held_out_gain(before, after, noise_m);
    }
    let (options, all) = (&context.options.fit, ApplyTo::AllFlights);
    cross_validate(models, context.dataset, options, all, noise_m)
}

/// Copy in which every [`FOLDS`]th flight from `fold` on is held out.
fn with_fold_held_out(dataset: &Dataset, fold: usize) -> Dataset {
    let mut split = dataset.clone();
    for (index, flight) in split.flights.iter_mut().enumerate() {
        flight.role = match index % FOLDS == fold {
            true => Role::HeldOut,
            false => Role::Fit,
        };
    }
    split
}

// Number of library terms that improve out-of-sample predictions.

/// Number of selected terms that are retained: the first, and each further one that reduces the out-of-sample error by
/// more than the standard error.
pub(crate) fn predictive_terms(
    context: Context<'_>,
    stepwise: &StepwiseModel,
    noise_m: f64,
) -> usize {
    let mut count = stepwise.fitted.len().min(1);
    for pair in stepwise.fitted.windows(2) {
        if context.is_out_of_time() {
            break;
        }
        let models = [&pair[0], &pair[1]].map(|terms| (&terms.extension.model, &terms.fit));
        let gain = out_of_sample_gain(context, models, noise_m);
        if !gain.is_some_and(|gain| gain.is_improvement()) {
            break;
        }
        count += 1;
    }
    count
}

// Validation of overflexible hypotheses, which fit misfits of any origin: a true one also improves predictions.

/// Model extended by the effects that the diagnosis chose, before its fit and out-of-sample gain are completed.
pub(crate) struct ChosenExtension {
    pub extension: ExtendedModel,
    /// Fit of the extended model; `None` if not yet fitted.
    pub fit: Option<Fit>,
    /// Out-of-sample gain; `None` if not yet measured, or no flight can be predicted.
    pub gain: Option<PredictiveGain>,
    /// Decrease of the weighted sum of squares, χ², by effects created from library terms; 0 for other effects.
    pub chi2_decrease: f64,
}

impl ChosenExtension {
    pub fn unfitted(extension: ExtendedModel) -> Self {
        Self {
            extension,
            fit: None,
            gain: None,
            chi2_decrease: 0.0,
        }
    }

    /// Fits the model extended by the effects of a hypothesis and measures its out-of-sample gain.
    pub fn validated(
        model: &ScoreTestModel<'_>,
        hypothesis: &Hypothesis,
        before: &Fit,
        noise_m: f64,
    ) -> Result<Self, DiagnosisError> {
        let context = model.context;
        let extension = hypothesis.extension(model)?;
        let fit = fit(&extension.model, context.dataset, &context.options.fit)?;
        let models = [(context.model, before), (&extension.model, &fit)];
        let gain = out_of_sample_gain(context, models, noise_m);
        Ok(Self {
            fit: Some(fit),
            gain,
            ..Self::unfitted(extension)
        })
    }

    /// Whether predictions improve by more than the standard error, or none can be made.
    pub fn improves_predictions(&self) -> bool {
        let gain = self.gain.as_ref();
        gain.is_none_or(PredictiveGain::is_improvement)
    }
}

impl Hypothesis {
    pub fn extension(&self, model: &ScoreTestModel<'_>) -> Result<ExtendedModel, DiagnosisError> {
        let effects = self.effects.iter();
        let names = effects.map(|&id| identifier(&model.candidate(id).name));
        let names: Vec<String> = names.collect();
        Ok(ExtendedModel::new(model.context.model, &names, &[])?)
    }
}

// Held-out flights whose conditioning segment, the first 30 % of the samples, contradicts an extension.

/// Increase of the χ² of a conditioning segment above which its flight contradicts the effects.
const MAX_CHI2_INCREASE: f64 = 10.0;

/// Rule that selects the held-out flights that are predicted with the extension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ApplyTo {
    /// All held-out flights are predicted with the extension.
    AllFlights,
    /// Those whose conditioning segment does not contradict the extension.
    ConcordantFlights,
}

impl ApplyTo {
    /// Held-out flights (dataset indices) to which the extension is not applied.
    pub fn exceptions(self, before: &Fit, after: &Fit) -> Vec<usize> {
        match self {
            ApplyTo::AllFlights => Vec::new(),
            ApplyTo::ConcordantFlights => contradicted(before, after),
        }
    }
}

/// Sums over the residuals of the positions in the conditioning segment of a flight; `None` if it was not used.
fn segment(fit: &Fit, flight: usize) -> Option<Moments> {
    let evidence = fit.evidence(FlightId::new(flight))?;
    let samples = (evidence.times.len() as f64 * CONDITIONING_FRACTION).ceil() as usize;
    let mut sums = Moments::default();
    for marker in 0..evidence.markers.len() {
        let residuals =
            (0..samples.min(evidence.times.len())).map(|k| evidence.residual(k, marker));
        sums.add(
            &evidence.times,
            &residuals.collect::<Vec<_>>(),
            f64::INFINITY,
        );
    }
    Some(sums)
}

fn contradicted(before: &Fit, after: &Fit) -> Vec<usize> {
    let flights = before.report.flights.iter().enumerate();
    let held_out = flights.filter(|(_, flight)| flight.role == Role::HeldOut);
    let segments = held_out.filter_map(|(flight, _)| {
        Some((flight, segment(before, flight)?, segment(after, flight)?))
    });
    worse(&segments.collect::<Vec<_>>())
}

/// Flights whose χ² increases by more than [`MAX_CHI2_INCREASE`]; each tuple has the index and the squares without and
/// with the effects. The noise is that of the smaller squares over all flights.
fn worse(segments: &[(usize, Moments, Moments)]) -> Vec<usize> {
    let mut noise = Moments::default();
    let total = |sums: &Moments| sums.squares.iter().sum::<f64>();
    for (_, before, after) in segments {
        let is_less = total(after) < total(before);
        noise.join(if is_less { after } else { before });
    }
    let increase = |before: &Moments, after: &Moments| -> f64 {
        let variance = |axis: usize| noise.squares[axis] / noise.count.max(1) as f64;
        let along = |axis: usize| (after.squares[axis] - before.squares[axis]) / variance(axis);
        (0..3).map(along).sum()
    };
    let each = segments.iter();
    each.filter(|(_, before, after)| increase(before, after) > MAX_CHI2_INCREASE)
        .map(|(flight, ..)| *flight)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_support::mystery;

    #[test]
    fn every_flight_is_held_out_once() {
        let dataset = mystery(5);
        let mut held_out = [0; 5];
        for fold in 0..FOLDS {
            let split = with_fold_held_out(&dataset, fold);
            for (count, flight) in held_out.iter_mut().zip(&split.flights) {
                *count += usize::from(flight.role == Role::HeldOut);
            }
        }
        assert_eq!(held_out, [1; 5]);
    }

    #[test]
    fn the_true_model_predicts_better() {
        let dataset = mystery(10);
        let [base, true_model] =
            [&[][..], &["stall"]].map(|with| model_spec::load::load("disc", with).unwrap());
        let options = FitOptions::default();
        let fits = [&base, &true_model].map(|model| fit(model, &dataset, &options).unwrap());
        let models = [(&base, &fits[0]), (&true_model, &fits[1])];
        let gain = cross_validate(models, &dataset, &options, ApplyTo::AllFlights, 0.0015);
        let gain = gain.unwrap();
        assert!(!gain.held_out_by_dataset && gain.flights == 10);
        assert!(gain.rms_after_m < gain.rms_before_m, "{gain:?}");
        let one = mystery(1);
        let none = cross_validate(models, &one, &options, ApplyTo::AllFlights, 0.0015);
        assert_eq!(none, None);
    }

    #[test]
    fn only_a_significant_increase_contradicts() {
        let squares = |value: f64| Moments {
            squares: [value; 3],
            count: 100,
            ..Moments::default()
        };
        // Noise of variance 1: the sum of squares of 100 points is about 100 along each axis.
        let segments = [
            (3, squares(400.0), squares(100.0)),
            (5, squares(100.0), squares(102.0)),
            (8, squares(100.0), squares(105.0)),
        ];
        assert_eq!(worse(&segments), [8]);
        assert!(worse(&[]).is_empty());
    }
}
