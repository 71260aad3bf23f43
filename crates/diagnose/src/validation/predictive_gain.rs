//! Out-of-sample error reduction by an extension.

use std::cmp::Ordering;

use dataset::Role;
use dataset::statistics::median_of;
use identify::{Fit, FitReport, FlightReport};
use serde::{Deserialize, Serialize};

/// Prediction errors on held-out flights, whose initial state is fitted on the first 30 %, without and with the
/// extension; without flights that neither model follows.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PredictiveGain {
    /// RMS error of one coordinate without the added effects, m, over all predicted flights.
    pub rms_before_m: f64,
    /// RMS prediction error of one coordinate by the extended model, m; the mean is over all predicted flights.
    pub rms_after_m: f64,
    /// Jackknife standard error of the reduction, over flights, m; NaN for a single flight.
    pub std_error_m: f64,
    /// Standard deviation of the noise of one coordinate, m: the smallest possible prediction error.
    pub noise_m: f64,
    /// SI unit of the errors, in place of m: `m` for positions; without positions, that of the first kind of instrument.
    #[doc(hidden)]
    #[serde(default)]
    pub unit: String,
    /// Whether errors of summaries are among them: those are in units of the noise of their columns, times `noise_m`.
    #[doc(hidden)]
    #[serde(default)]
    pub has_summaries: bool,
    /// Number of flights predicted both without and with the added effects; flights in `set_apart` are not counted.
    pub flights: usize,
    /// Number of flights whose first samples contradict the effects, which are not applied.
    pub without: usize,
    /// Whether the dataset declares held-out flights; if not, by 2-fold cross-validation.
    pub held_out_by_dataset: bool,
    /// Number of flights whose RMS prediction error is smaller with the added effects than without them.
    pub improved: usize,
    /// Number of flights whose RMS prediction error is larger with the added effects than without them.
    pub worsened: usize,
    /// Median over the flights of the RMS error without the added effects, m.
    pub median_before_m: f64,
    /// Median, over the predicted flights, of the RMS prediction error of a flight by the extended model, m.
    pub median_after_m: f64,
    /// One-sided p-value of the sign test of `improved` flights.
    pub sign_test_p_value: f64,
    /// Number of flights that only the extended model predicts, not among `flights`.
    pub predicted_only_after: usize,
    /// Number of flights that only the model without the added effects predicts. They are not among the `flights`.
    pub predicted_only_before: usize,
    /// File names of the flights that are excluded from the statistics because neither model predicts them.
    pub set_apart: Vec<String>,
}

impl PredictiveGain {
    /// RMS prediction error without the added effects minus RMS prediction error with them, m.
    #[doc(hidden)]
    pub fn error_reduction_m(&self) -> f64 {
        self.rms_before_m - self.rms_after_m
    }

    /// Whether predictions improve: the error falls by more than its standard error, or more flights can be predicted
    /// and the error does not grow as much.
    pub(crate) fn is_improvement(&self) -> bool {
        self.change() == Ordering::Greater
    }

    /// Whether predictions become worse, by the same rule.
    pub(crate) fn is_worse(&self) -> bool {
        self.change() == Ordering::Less
    }

    /// Whether predictions speak against the effects: much worse, by their standard error or of most flights too, or of
    /// fewer flights.
    pub(crate) fn contradicts(&self) -> bool {
        // Where both models err far above the noise, the initial states limit what they predict, not the effects.
        let least = self.rms_before_m.min(self.rms_after_m);
        let much = CONTRADICTING_ERROR * least.max(self.noise_m);
        let is_much = -self.error_reduction_m() > much;
        // Of a few flights, the worse they are predicted, the greater is the standard error.
        let is_worse_of_most = self.median_after_m - self.median_before_m > much;
        is_much && is_worse_of_most
            || self.is_worse()
                && (is_much || self.predicted_only_before > self.predicted_only_after)
    }

    /// Whether the predictions with the added effects are better (`Greater`) or worse (`Less`) than those without.
    fn change(&self) -> Ordering {
        let (reduction, error) = (self.error_reduction_m(), self.std_error_m);
        let by_errors = match reduction {
            _ if reduction > error => Ordering::Greater,
            _ if reduction < -error => Ordering::Less,
            _ => Ordering::Equal,
        };
        let by_flights = self.predicted_only_after.cmp(&self.predicted_only_before);
        match by_flights {
            Ordering::Equal => by_errors,
            // The errors of the flights that both models predict say the opposite.
            _ if by_errors == by_flights.reverse() => Ordering::Equal,
            _ => by_flights,
        }
    }

    /// Whether both models predict practically the same.
    pub(crate) fn changes_nothing(&self) -> bool {
        let same = SAME_ERROR * self.noise_m;
        self.predicted_only_after + self.predicted_only_before == 0
            && self.error_reduction_m().abs() < same
            && self.std_error_m < same
    }
}

/// Difference of RMS errors of equal predictions, as a fraction of the noise.
const SAME_ERROR: f64 = 1e-3;

/// Increase of the RMS error that contradicts an effect, as a fraction of the smaller error, or of the noise; effects on
/// single sensors hardly change positions.
const CONTRADICTING_ERROR: f64 = 0.5;

/// Ratio of a flight's smaller error to the median, or to the noise, above which neither model predicts it, and number of
/// predicted flights from which flights are set apart.
const SET_APART_ABOVE: (f64, usize) = (6.0, 4);

/// Prediction errors of one flight, without and with the effects added to the model.
#[derive(Clone, Debug)]
pub(super) struct FlightErrors {
    file: String,
    /// Mean squared prediction error of one coordinate by the model without the added effects, m².
    before: f64,
    /// Mean squared error of the extended model, m²; `before` if it is not applied.
    after: f64,
    is_summary: bool,
    is_applied: bool,
}

/// Predictions of held-out flights without and with the effects added to the model.
#[derive(Clone, Debug, Default)]
pub(super) struct Predictions {
    errors: Vec<FlightErrors>,
    unit: String,
    only_before: usize,
    only_after: usize,
}

impl Predictions {
    pub fn join(&mut self, others: Self) {
        self.errors.extend(others.errors);
        self.unit = others.unit;
        self.only_before += others.only_before;
        self.only_after += others.only_after;
    }
}

/// Reduction of the out-of-sample error from `before` to `after` on the held-out flights; `None` if none is predicted.
/// `noise_m` is that of a coordinate, m.
pub fn held_out_gain(
    before: &FitReport,
    after: &FitReport,
    noise_m: f64,
) -> Option<PredictiveGain> {
    summarize(predictions(before, after, &[], noise_m), noise_m, true)
}

/// [`held_out_gain`] without the extension on the flights in `not_applied` (dataset indices).
pub(crate) fn gain_of_fits(
    before: &Fit,
    after: &Fit,
    not_applied: &[usize],
    noise_m: f64,
) -> Option<PredictiveGain> {
    let predictions = predictions(&before.report, &after.report, not_applied, noise_m);
    summarize(predictions, noise_m, true)
}

/// Mean squared prediction error of a flight, m². That of a summary is in units of the noise of its values in `before`,
/// times that of a coordinate.
fn error(flight: &FlightReport, before: &FlightReport, noise_m: f64) -> f64 {
    match flight.mean_square_by_noise_of(before) {
        None => flight.rms().powi(2),
        Some(mean_square) => noise_m * noise_m * mean_square,
    }
}

/// Predictions of the held-out flights; `noise_m` is that of a coordinate, m; in `not_applied`, that of `before` counts
/// for both.
pub(super) fn predictions(
    before: &FitReport,
    after: &FitReport,
    not_applied: &[usize],
    noise_m: f64,
) -> Predictions {
    let mut predictions = Predictions {
        unit: before.leading_noise().unit.clone(),
        ..Predictions::default()
    };
    let flights = before.flights.iter().zip(&after.flights).enumerate();
    for (flight, (before, after)) in flights.filter(|(_, (b, _))| b.role == Role::HeldOut) {
        let is_applied = !not_applied.contains(&flight);
        let after = if is_applied { after } else { before };
        match (before.is_used(), after.is_used()) {
            (true, true) => predictions.errors.push(FlightErrors {
                file: before.file.clone(),
                before: error(before, before, noise_m),
                after: error(after, before, noise_m),
                is_summary: !before.seen.is_empty(),
                is_applied,
            }),
            (true, false) => predictions.only_before += 1,
            (false, true) => predictions.only_after += 1,
            (false, false) => {}
        }
    }
    predictions
}

/// Summarizes prediction errors; `None` without flights that both models predict.
pub(super) fn summarize(
    predictions: Predictions,
    noise_m: f64,
    held_out_by_dataset: bool,
) -> Option<PredictiveGain> {
    let (apart, flights) = without_set_apart(predictions.errors, noise_m);
    if flights.is_empty() {
        return None;
    }
    let count = flights.len() as f64;
    let sum = |error: fn(&FlightErrors) -> f64| flights.iter().map(error).sum::<f64>();
    let (before, after) = (sum(|f| f.before), sum(|f| f.after));
    let others = (count - 1.0).max(1.0);
    let rms = |sum: f64, count: f64| (sum.max(0.0) / count).sqrt();
    let without = |f: &FlightErrors| rms(before - f.before, others) - rms(after - f.after, others);
    let leave_one_out: Vec<f64> = flights.iter().map(without).collect();
    let mean = leave_one_out.iter().sum::<f64>() / count;
    let spread: f64 = leave_one_out.iter().map(|d| (d - mean).powi(2)).sum();
    let median = |error: fn(&FlightErrors) -> f64| {
        median_of(flights.iter().map(|f| error(f).sqrt())).unwrap_or(0.0)
    };
    let improved = flights.iter().filter(|f| f.after < f.before).count();
    let worsened = flights.iter().filter(|f| f.after > f.before).count();
    Some(PredictiveGain {
        rms_before_m: rms(before, count),
        rms_after_m: rms(after, count),
        std_error_m: match flights.len() {
            1 => f64::NAN,
            _ => (spread * (count - 1.0) / count).sqrt(),
        },
        noise_m,
        unit: predictions.unit,
        has_summaries: flights.iter().any(|flight| flight.is_summary),
        flights: flights.len(),
        without: flights.iter().filter(|flight| !flight.is_applied).count(),
        held_out_by_dataset,
        improved,
        worsened,
        median_before_m: median(|f| f.before),
        median_after_m: median(|f| f.after),
        sign_test_p_value: sign_test(improved, improved + worsened),
        predicted_only_after: predictions.only_after,
        predicted_only_before: predictions.only_before,
        set_apart: apart.into_iter().map(|flight| flight.file).collect(),
    })
}

/// Flights set apart, and all others. A flight is apart if its smaller error is not a number or above the limit; none
/// is if more than a quarter were, or of fewer than [`SET_APART_ABOVE`].
fn without_set_apart(
    flights: Vec<FlightErrors>,
    noise_m: f64,
) -> (Vec<FlightErrors>, Vec<FlightErrors>) {
    if flights.len() < SET_APART_ABOVE.1 {
        return (Vec::new(), flights);
    }
    let least = |flight: &FlightErrors| flight.before.min(flight.after).sqrt();
    let typical = median_of(flights.iter().map(least)).unwrap_or(0.0);
    let limit = SET_APART_ABOVE.0 * typical.max(noise_m);
    let is_apart = |flight: &FlightErrors| least(flight) > limit || least(flight).is_nan();
    if flights.iter().filter(|flight| is_apart(flight)).count() > flights.len() / 4 {
        return (Vec::new(), flights);
    }
    flights.into_iter().partition(is_apart)
}

/// One-sided p-value of the sign test: probability of at least `improved` heads in `count` tosses of a fair coin.
fn sign_test(improved: usize, count: usize) -> f64 {
    let mut probability = 0.0;
    let mut ln_binomial = 0.0;
    for heads in 0..=count {
        if heads > 0 {
            ln_binomial += ((count - heads + 1) as f64 / heads as f64).ln();
        }
        if heads >= improved {
            probability += (ln_binomial - count as f64 * std::f64::consts::LN_2).exp();
        }
    }
    probability.min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of_both(errors: Vec<FlightErrors>) -> Predictions {
        Predictions {
            errors,
            ..Predictions::default()
        }
    }

    #[test]
    fn flights_that_one_model_alone_predicts_count() {
        let gain = |before: f64, after: f64, only_before: usize, only_after: usize| {
            let flight = FlightErrors {
                file: String::new(),
                before: before * before,
                after: after * after,
                is_summary: false,
                is_applied: true,
            };
            let predictions = Predictions {
                errors: vec![flight],
                only_before,
                only_after,
                ..Predictions::default()
            };
            let gain = summarize(predictions, 0.0015, true).unwrap();
            (gain.is_improvement(), gain.is_worse())
        };
        // A single flight has no standard error.
        assert_eq!(gain(0.21, 0.0025, 0, 0), (false, false));
        assert_eq!(gain(0.21, 0.0025, 0, 3), (true, false));
        assert_eq!(gain(0.0025, 0.21, 3, 0), (false, true));
        assert_eq!(gain(0.21, 0.0025, 1, 1), (false, false));
    }

    #[test]
    fn the_flights_of_all_parts_count() {
        let part = |only_before: usize, only_after: usize| Predictions {
            errors: vec![FlightErrors {
                file: String::new(),
                before: 0.04,
                after: 0.01,
                is_summary: false,
                is_applied: true,
            }],
            unit: "m".to_owned(),
            only_before,
            only_after,
        };
        let mut all = Predictions::default();
        all.join(part(1, 0));
        all.join(part(2, 3));
        let gain = summarize(all, 0.001, false).unwrap();
        let only = (gain.predicted_only_before, gain.predicted_only_after);
        assert_eq!((gain.flights, only, gain.unit.as_str()), (2, (3, 3), "m"));
        assert!((gain.rms_before_m - 0.2).abs() < 1e-12);
    }

    #[test]
    fn the_jackknife_error_is_that_of_the_mean_for_small_differences() {
        // Deviations of 1 to 4 mm from their mean of 2.5 mm: 1.29 mm / √4, as all errors without the extension are
        // equal.
        let flights: Vec<FlightErrors> = [1e-3, 2e-3, 3e-3, 4e-3]
            .iter()
            .map(|d| FlightErrors {
                file: String::new(),
                before: 0.1_f64.powi(2),
                after: (0.1_f64 - d).powi(2),
                is_summary: false,
                is_applied: true,
            })
            .collect();
        let found = summarize(of_both(flights), 0.001, true).unwrap();
        assert!((found.rms_before_m - 0.1).abs() < 1e-12);
        assert!((found.std_error_m - 0.000_645).abs() < 2e-5, "{found:?}");
        assert!(found.is_improvement());
        assert!(summarize(Predictions::default(), 0.0, true).is_none());
    }

    #[test]
    fn a_flight_that_no_model_follows_is_set_apart() {
        // 16 of 19 flights improve, and the track of one more flight is off by a metre.
        let flight = |k: usize, before: f64, after: f64| FlightErrors {
            file: format!("f{k}.csv"),
            before: before * before,
            after: after * after,
            is_summary: false,
            is_applied: true,
        };
        let mut flights: Vec<FlightErrors> = (0..19)
            .map(|k| flight(k, 0.041, if k < 16 { 0.028 } else { 0.043 }))
            .collect();
        flights.push(flight(19, 1.0, 1.01));
        let found = summarize(of_both(flights), 0.0015, true).unwrap();
        assert_eq!(found.set_apart, ["f19.csv"]);
        assert_eq!((found.improved, found.worsened, found.flights), (16, 3, 19));
        assert!((found.median_after_m - 0.028).abs() < 1e-12);
        assert!(found.rms_before_m < 0.042);
        // 1160 of 2^19 sequences have at least 16 heads.
        assert!(
            (found.sign_test_p_value - 1160.0 / 524_288.0).abs() < 1e-9,
            "{}",
            found.sign_test_p_value
        );
        // If two of four flights are off by metres, they are not exceptions.
        let half = vec![
            flight(0, 0.1, 0.1),
            flight(1, 0.1, 0.1),
            flight(2, 9.0, 9.0),
            flight(3, 9.0, 9.0),
        ];
        let found = summarize(of_both(half), 0.0015, true).unwrap();
        assert!(found.set_apart.is_empty());
    }

    #[test]
    fn an_extension_that_changes_nothing_is_no_gain() {
        let gain = |after: f64, std_error_m: f64| PredictiveGain {
            rms_before_m: 0.002,
            rms_after_m: after,
            std_error_m,
            noise_m: 0.0015,
            ..PredictiveGain::default()
        };
        assert!(gain(0.002, 1e-9).changes_nothing());
        assert!(!gain(0.002, 1e-4).changes_nothing());
        // A flight that can be computed by one of the models only is a change.
        let predicts_more = PredictiveGain {
            predicted_only_after: 1,
            ..gain(0.002, 1e-9)
        };
        assert!(!predicts_more.changes_nothing());
        assert!(gain(0.0025, 1e-4).is_worse());
        assert!(!gain(0.00201, 1e-4).is_worse());
        // Two flights, of which one is predicted far worse: so is the standard error of the mean.
        let of_two = |median_after_m: f64| PredictiveGain {
            median_before_m: 0.0035,
            median_after_m,
            ..gain(0.007, 0.0051)
        };
        assert!(of_two(0.006).contradicts());
        assert!(!of_two(0.0036).contradicts());
        // Both models err by several times the noise, one a third more: the initial states, not the effect.
        let both_far = |rms_after_m: f64| PredictiveGain {
            rms_before_m: 0.006,
            median_before_m: 0.006,
            median_after_m: rms_after_m,
            ..gain(rms_after_m, 3e-4)
        };
        assert!(both_far(0.008).is_worse() && !both_far(0.008).contradicts());
        assert!(both_far(0.0095).contradicts());
    }
}
