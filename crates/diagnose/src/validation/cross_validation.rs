//! 2-fold cross-validation over flights.

use dataset::{Dataset, Role};
use flight::parallel;
use identify::{Fit, FitError, FitOptions, fit};
use model_spec::model::Model;

use super::discordant_beginning::ApplyTo;
use super::predictive_gain::{Predictions, PredictiveGain, held_out_gain, predictions, summarize};
use crate::context::Context;

/// Number of folds of the cross-validation. With 2 folds, each half of the flights is predicted by a fit to the other
/// half.
const FOLDS: usize = 2;

/// Out-of-sample gain of the second model over the first by cross-validation: each fold of the flights is predicted by
/// a fit of the other folds. A fold that cannot be fitted is skipped. `None` if there are fewer than two flights, or no
/// flight can be predicted.
///
/// # Errors
/// [`FitError::Interrupted`] if the caller cancelled.
pub(crate) fn cross_validate(
    models: [&Model; 2],
    dataset: &Dataset,
    options: &FitOptions<'_>,
    apply_to: ApplyTo,
    noise_m: f64,
) -> Result<Option<PredictiveGain>, FitError> {
    if dataset.flights.len() < 2 {
        return Ok(None);
    }
    let threads = options.threads();
    let options = FitOptions {
        threads: Some(1.max(threads / (2 * FOLDS))),
        profiles: &[],
        ..*options
    };
    let fits = parallel::each_on(threads, 2 * FOLDS, |index| {
        fit(
            models[index % 2],
            &with_fold_held_out(dataset, index / 2),
            &options,
        )
    });
    let mut all = Predictions::default();
    for pair in fits.chunks(2) {
        match (&pair[0], &pair[1]) {
            (Err(FitError::Interrupted), _) | (_, Err(FitError::Interrupted)) => {
                return Err(FitError::Interrupted);
            }
            (Ok(before), Ok(after)) => {
                let not_applied = apply_to.exceptions(before, after);
                all.join(predictions(&before.report, &after.report, &not_applied));
            }
            _ => {}
        }
    }
    Ok(summarize(all, noise_m, false))
}

/// Out-of-sample gain of the second model over the first, each given with its fit to the flights of the diagnosis: on
/// the held-out flights if the dataset declares some, otherwise by cross-validation. `noise_m` is the standard
/// deviation of the noise of one coordinate, m.
///
/// # Errors
/// [`FitError::Interrupted`] if the caller cancelled.
pub(super) fn out_of_sample_gain(
    context: Context<'_>,
    [before, after]: [(&Model, &Fit); 2],
    noise_m: f64,
) -> Result<Option<PredictiveGain>, FitError> {
    if context.has_held_out() {
        let (before, after) = (&before.1.report, &after.1.report);
        return Ok(held_out_gain(before, after, noise_m));
    }
    let (models, options) = ([before.0, after.0], &context.options.fit);
    let all = ApplyTo::AllFlights;
    cross_validate(models, context.dataset, options, all, noise_m)
}

/// Copy of the dataset in which every [`FOLDS`]th flight, from index `fold` on, is held out and all others are
/// fitted.
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
        let models = [&base, &true_model];
        let gain = cross_validate(models, &dataset, &options, ApplyTo::AllFlights, 0.0015);
        let gain = gain.unwrap().unwrap();
        assert!(!gain.held_out_by_dataset && gain.flights == 10);
        assert!(gain.rms_after_m < gain.rms_before_m, "{gain:?}");
        let one = mystery(1);
        let none = cross_validate(models, &one, &options, ApplyTo::AllFlights, 0.0015);
        assert_eq!(none.unwrap(), None);
    }
}
