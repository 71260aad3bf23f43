//! What an extension gains on flights that it has not seen.

use flight::batch;
use identify::dataset::{Dataset, Role};
use identify::fit::{FitError, fit};
use identify::options::Options;
use identify::report;
use model_spec::model::Model;

use crate::report::Gain;

/// Where no flight is held out, each half of them is predicted by a fit to the other.
const FOLDS: usize = 2;

/// Mean squared errors of one flight, without and with the extension, m².
type Pair = (f64, f64);

/// The gain from fits that have predicted held-out flights.
pub fn by_held_out(before: &report::Report, after: &report::Report, floor: f64) -> Option<Gain> {
    gain(pairs(before, after), floor, true)
}

/// The gain where the dataset holds nothing out: by parts of it in turn.
///
/// # Errors
/// [`FitError::Interrupted`].
pub fn by_turns(
    models: [&Model; 2],
    dataset: &Dataset,
    options: &Options<'_>,
    floor: f64,
) -> Result<Option<Gain>, FitError> {
    if dataset.flights.len() < 2 {
        return Ok(None);
    }
    let folds = FOLDS.min(dataset.flights.len());
    let threads = options.threads();
    let alone = Options {
        threads: Some(1.max(threads / (2 * folds))),
        profiles: &[],
        ..*options
    };
    let fitted = batch::each_on(threads, 2 * folds, |index| {
        let mut part = dataset.clone();
        for (k, flight) in part.flights.iter_mut().enumerate() {
            flight.role = match k % folds == index / 2 {
                true => Role::HeldOut,
                false => Role::Fit,
            };
        }
        fit(models[index % 2], &part, &alone).map(|fitted| fitted.report)
    });
    let mut all = Vec::new();
    for two in fitted.chunks(2) {
        match (&two[0], &two[1]) {
            (Err(FitError::Interrupted), _) | (_, Err(FitError::Interrupted)) => {
                return Err(FitError::Interrupted);
            }
            (Ok(before), Ok(after)) => all.extend(pairs(before, after)),
            // A part that cannot be fitted says nothing.
            _ => {}
        }
    }
    Ok(gain(all, floor, false))
}

fn pairs(before: &report::Report, after: &report::Report) -> Vec<Pair> {
    let flights = before.flights.iter().zip(&after.flights);
    flights
        .filter(|(b, a)| b.role == Role::HeldOut && !b.initial.is_empty() && !a.initial.is_empty())
        .map(|(b, a)| (b.rms_m.powi(2), a.rms_m.powi(2)))
        .collect()
}

fn gain(pairs: Vec<Pair>, floor: f64, held_out_by_dataset: bool) -> Option<Gain> {
    let count = pairs.len() as f64;
    let rms = |pairs: &[Pair], part: fn(&Pair) -> f64| {
        (pairs.iter().map(part).sum::<f64>() / pairs.len().max(1) as f64).sqrt()
    };
    if pairs.is_empty() {
        return None;
    }
    let difference = |pairs: &[Pair]| rms(pairs, |p| p.0) - rms(pairs, |p| p.1);
    // The jackknife over flights.
    let without: Vec<f64> = (0..pairs.len())
        .map(|left_out| {
            let mut rest = pairs.clone();
            rest.remove(left_out);
            difference(&rest)
        })
        .collect();
    let mean = without.iter().sum::<f64>() / count;
    let spread: f64 = without.iter().map(|d| (d - mean).powi(2)).sum();
    Some(Gain {
        held_out_rms_before_m: rms(&pairs, |p| p.0),
        held_out_rms_after_m: rms(&pairs, |p| p.1),
        standard_error_m: if pairs.len() > 1 {
            (spread * (count - 1.0) / count).sqrt()
        } else {
            f64::NAN
        },
        noise_floor_m: floor,
        flights: pairs.len(),
        held_out_by_dataset,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_standard_error_is_that_of_the_mean_where_squares_are_small() {
        // Differences 1 to 4 mm about their mean of 2.5 mm: 1.29 mm / √4, nearly, as all before are alike.
        let pairs: Vec<Pair> = [1e-3, 2e-3, 3e-3, 4e-3]
            .iter()
            .map(|d| (0.1_f64.powi(2), (0.1_f64 - d).powi(2)))
            .collect();
        let found = gain(pairs, 0.001, true).unwrap();
        assert!((found.held_out_rms_before_m - 0.1).abs() < 1e-12);
        assert!(
            (found.standard_error_m - 0.000_645).abs() < 2e-5,
            "{found:?}"
        );
        assert!(gain(Vec::new(), 0.0, true).is_none());
    }
}
