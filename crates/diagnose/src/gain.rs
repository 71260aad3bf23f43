//! What an extension gains on flights that it has not seen.

use flight::batch;
use identify::dataset::{Dataset, Role};
use identify::{CONDITIONING_FRACTION, Fit, FitError, FitOptions, FitReport, fit};
use model_spec::model::Model;

use crate::report::Gain;

/// Where no flight is held out, each half of them is predicted by a fit to the other.
const FOLDS: usize = 2;

/// Mean squared errors of one flight, m².
#[derive(Clone, Copy, Debug)]
struct Pair {
    before: f64,
    after: f64,
    /// Whether it was predicted without the extension, which is not believed of it.
    without: bool,
}

/// Whether an extension is believed of every flight, or of none whose first part contradicts it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Believed {
    /// Of every flight.
    Always,
    /// A flight whose first part, on which its initial state is fitted, is met worse with the extension is predicted without.
    UnlessContradicted,
}

/// The first part of a flight contradicts where its weighted squares grow by more than this.
const WORSE: f64 = 10.0;

/// The gain from fits that have predicted held-out flights.
pub fn by_held_out(before: &FitReport, after: &FitReport, floor: f64) -> Option<Gain> {
    gain(pairs(before, after, |_| false), floor, true)
}

/// The same where the extension is not believed of some flights, by index: they are predicted without.
pub fn by_fits(before: &Fit, after: &Fit, without: &[usize], floor: f64) -> Option<Gain> {
    gain(pairs_of(before, after, without), floor, true)
}

/// The gain where the dataset holds nothing out: by parts of it in turn.
///
/// # Errors
/// [`FitError::Interrupted`].
pub fn by_turns(
    models: [&Model; 2],
    dataset: &Dataset,
    options: &FitOptions<'_>,
    believed: Believed,
    floor: f64,
) -> Result<Option<Gain>, FitError> {
    if dataset.flights.len() < 2 {
        return Ok(None);
    }
    let folds = FOLDS.min(dataset.flights.len());
    let threads = options.threads();
    let alone = FitOptions {
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
        fit(models[index % 2], &part, &alone)
    });
    let mut all = Vec::new();
    for two in fitted.chunks(2) {
        match (&two[0], &two[1]) {
            (Err(FitError::Interrupted), _) | (_, Err(FitError::Interrupted)) => {
                return Err(FitError::Interrupted);
            }
            (Ok(before), Ok(after)) => {
                all.extend(pairs_of(before, after, &believed.without(before, after)))
            }
            // A part that cannot be fitted says nothing.
            _ => {}
        }
    }
    Ok(gain(all, floor, false))
}

fn pairs_of(before: &Fit, after: &Fit, without: &[usize]) -> Vec<Pair> {
    pairs(&before.report, &after.report, |flight| {
        without.contains(&flight)
    })
}

fn pairs(before: &FitReport, after: &FitReport, without: impl Fn(usize) -> bool) -> Vec<Pair> {
    let flights = before.flights.iter().zip(&after.flights).enumerate();
    flights
        .filter(|(_, (b, a))| b.role == Role::HeldOut && b.is_used() && a.is_used())
        .map(|(flight, (b, a))| {
            let without = without(flight);
            let after = if without { b.rms_m } else { a.rms_m };
            Pair {
                before: b.rms_m.powi(2),
                after: after.powi(2),
                without,
            }
        })
        .collect()
}

impl Believed {
    /// Held-out flights, by index, of which the extension is not believed.
    pub fn without(self, before: &Fit, after: &Fit) -> Vec<usize> {
        match self {
            Believed::Always => Vec::new(),
            Believed::UnlessContradicted => contradicting(before, after),
        }
    }
}

/// Held-out flights whose first part is met worse with the extension.
fn contradicting(before: &Fit, after: &Fit) -> Vec<usize> {
    let flights = before.report.flights.iter().enumerate();
    let held_out = flights.filter(|(_, flight)| flight.role == Role::HeldOut);
    let firsts = held_out.filter_map(|(flight, _)| {
        let both = (first_part(before, flight)?, first_part(after, flight)?);
        Some((flight, both))
    });
    let firsts: Vec<(usize, (First, First))> = firsts.collect();
    // The noise of first parts is what the better of both leaves of them.
    let total = |first: &First| first.squares.iter().sum::<f64>();
    let mut noise = First::default();
    for (_, (without, with)) in &firsts {
        let better = if total(with) < total(without) {
            with
        } else {
            without
        };
        noise.count += better.count;
        for axis in 0..3 {
            noise.squares[axis] += better.squares[axis];
        }
    }
    let worse = |(without, with): &(First, First)| -> f64 {
        let variance = |axis: usize| noise.squares[axis] / noise.count.max(1) as f64;
        let of_axis = |axis| (with.squares[axis] - without.squares[axis]) / variance(axis);
        (0..3).map(of_axis).sum()
    };
    let each = firsts.iter().filter(|(_, both)| worse(both) > WORSE);
    each.map(|(flight, _)| *flight).collect()
}

/// Squared residuals of the first part of a flight, by axis, and how many points they are of.
#[derive(Clone, Copy, Debug, Default)]
struct First {
    squares: [f64; 3],
    count: usize,
}

fn first_part(fitted: &Fit, flight: usize) -> Option<First> {
    let evidence = fitted.evidence(flight)?;
    let samples = (evidence.times.len() as f64 * CONDITIONING_FRACTION).ceil() as usize;
    let mut first = First::default();
    for sample in 0..samples.min(evidence.times.len()) {
        for marker in 0..evidence.markers.len() {
            if let Some(residual) = evidence.residual(sample, marker) {
                first.count += 1;
                for (sum, r) in first.squares.iter_mut().zip(residual) {
                    *sum += r * r;
                }
            }
        }
    }
    Some(first)
}

fn gain(pairs: Vec<Pair>, floor: f64, held_out_by_dataset: bool) -> Option<Gain> {
    let count = pairs.len() as f64;
    let rms = |pairs: &[Pair], part: fn(&Pair) -> f64| {
        (pairs.iter().map(part).sum::<f64>() / pairs.len().max(1) as f64).sqrt()
    };
    if pairs.is_empty() {
        return None;
    }
    let difference = |pairs: &[Pair]| rms(pairs, |p| p.before) - rms(pairs, |p| p.after);
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
        held_out_rms_before_m: rms(&pairs, |p| p.before),
        held_out_rms_after_m: rms(&pairs, |p| p.after),
        standard_error_m: if pairs.len() > 1 {
            (spread * (count - 1.0) / count).sqrt()
        } else {
            f64::NAN
        },
        noise_floor_m: floor,
        flights: pairs.len(),
        without: pairs.iter().filter(|pair| pair.without).count(),
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
            .map(|d| Pair {
                before: 0.1_f64.powi(2),
                after: (0.1_f64 - d).powi(2),
                without: false,
            })
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
