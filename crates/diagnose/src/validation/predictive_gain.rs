//! Out-of-sample error reduction.

use identify::dataset::Role;
use identify::{Fit, FitReport};
use serde::{Deserialize, Serialize};

/// Prediction errors on held-out flights, whose initial state is fitted on their first 30 %, without and with an
/// extension.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PredictiveGain {
    /// RMS error without the extension, m.
    pub held_out_rms_before_m: f64,
    /// RMS error with the extension, m.
    pub held_out_rms_after_m: f64,
    /// Standard error of the difference, by the jackknife over flights, m.
    pub standard_error_m: f64,
    /// Standard deviation of the noise of one coordinate, m: the least error possible.
    pub noise_floor_m: f64,
    /// Number of predicted flights.
    pub flights: usize,
    /// Number of flights among them to which the extension is not applied, because it contradicts their beginning.
    #[serde(default)]
    pub without: usize,
    /// Whether the dataset declares the held-out flights; otherwise every flight is predicted by a fit of the others.
    pub held_out_by_dataset: bool,
}

impl PredictiveGain {
    /// Decrease of the RMS error, m.
    pub fn error_reduction_m(&self) -> f64 {
        self.held_out_rms_before_m - self.held_out_rms_after_m
    }

    /// Whether the decrease exceeds its standard error.
    pub(crate) fn is_improvement(&self) -> bool {
        self.error_reduction_m() > self.standard_error_m
    }
}

/// Mean squared errors of one flight.
#[derive(Clone, Copy, Debug)]
pub(super) struct FlightErrors {
    /// Mean squared error without the extension, m².
    before: f64,
    /// Mean squared error with the extension, or without it where the extension is not applied, m².
    after: f64,
    is_applied: bool,
}

/// The gain on the held-out flights of two fits; none if there are none. `noise_floor_m` is the noise of one coordinate, m.
pub fn held_out_gain(
    before: &FitReport,
    after: &FitReport,
    noise_floor_m: f64,
) -> Option<PredictiveGain> {
    summarize(errors(before, after, &[]), noise_floor_m, true)
}

/// Gain on the held-out flights of two fits; the extension is not applied to flights in `not_applied` (dataset
/// indices).
pub(crate) fn gain_of_fits(
    before: &Fit,
    after: &Fit,
    not_applied: &[usize],
    noise_floor_m: f64,
) -> Option<PredictiveGain> {
    let errors = errors(&before.report, &after.report, not_applied);
    summarize(errors, noise_floor_m, true)
}

/// Errors of the held-out flights that both fits predict.
pub(super) fn errors(
    before: &FitReport,
    after: &FitReport,
    not_applied: &[usize],
) -> Vec<FlightErrors> {
    let flights = before.flights.iter().zip(&after.flights).enumerate();
    let predicted =
        flights.filter(|(_, (b, a))| b.role == Role::HeldOut && b.is_used() && a.is_used());
    predicted
        .map(|(flight, (before, after))| {
            let is_applied = !not_applied.contains(&flight);
            let after = if is_applied {
                after.rms()
            } else {
                before.rms()
            };
            FlightErrors {
                before: before.rms().powi(2),
                after: after.powi(2),
                is_applied,
            }
        })
        .collect()
}

/// RMS errors over flights, and the jackknife standard error of their difference.
pub(super) fn summarize(
    flights: Vec<FlightErrors>,
    noise_floor_m: f64,
    held_out_by_dataset: bool,
) -> Option<PredictiveGain> {
    if flights.is_empty() {
        return None;
    }
    let count = flights.len() as f64;
    let rms = |flights: &[FlightErrors], error: fn(&FlightErrors) -> f64| {
        (flights.iter().map(error).sum::<f64>() / flights.len().max(1) as f64).sqrt()
    };
    let difference =
        |flights: &[FlightErrors]| rms(flights, |f| f.before) - rms(flights, |f| f.after);
    let leave_one_out: Vec<f64> = (0..flights.len())
        .map(|index| {
            let mut others = flights.clone();
            others.remove(index);
            difference(&others)
        })
        .collect();
    let mean = leave_one_out.iter().sum::<f64>() / count;
    let spread: f64 = leave_one_out.iter().map(|d| (d - mean).powi(2)).sum();
    Some(PredictiveGain {
        held_out_rms_before_m: rms(&flights, |f| f.before),
        held_out_rms_after_m: rms(&flights, |f| f.after),
        standard_error_m: match flights.len() {
            1 => f64::NAN,
            _ => (spread * (count - 1.0) / count).sqrt(),
        },
        noise_floor_m,
        flights: flights.len(),
        without: flights.iter().filter(|flight| !flight.is_applied).count(),
        held_out_by_dataset,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_jackknife_error_is_that_of_the_mean_for_small_differences() {
        // Differences of 1 to 4 mm about their mean of 2.5 mm: 1.29 mm / √4, as all errors before are equal.
        let flights: Vec<FlightErrors> = [1e-3, 2e-3, 3e-3, 4e-3]
            .iter()
            .map(|d| FlightErrors {
                before: 0.1_f64.powi(2),
                after: (0.1_f64 - d).powi(2),
                is_applied: true,
            })
            .collect();
        let found = summarize(flights, 0.001, true).unwrap();
        assert!((found.held_out_rms_before_m - 0.1).abs() < 1e-12);
        assert!(
            (found.standard_error_m - 0.000_645).abs() < 2e-5,
            "{found:?}"
        );
        assert!(found.is_improvement());
        assert!(summarize(Vec::new(), 0.0, true).is_none());
    }
}
