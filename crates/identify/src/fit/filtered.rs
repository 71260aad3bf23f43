//! Recognition of tracks that were filtered or interpolated, by the distances between the markers of a rigid body, which
//! do not depend on its motion: their noise lacks its high frequencies, or they are shorter in every second, third or
//! fourth sample, since an interpolation cuts the corners of the circles.

use std::iter::zip;

use nalgebra::Vector3;

use super::rigidity::{apart, markers};
use super::state::State;
use crate::observations::Observations;
use dataset::statistics::{median, robust_sigma};

/// Partial autocorrelation of the noise at two samples below which it was filtered. Noise of a first order, white or
/// correlated, has none; binomial means of three samples have −0.5, and cubic interpolation of every other sample −0.6.
const FILTERED: f64 = -0.25;
/// Number of standard errors by which the partial autocorrelation must differ from zero.
const MIN_ERRORS: f64 = 5.0;
/// Deviation of a distance, in its robust standard deviations, above which it is an outlier.
const OUTLIER: f64 = 5.0;
/// Relative difference of two intervals between samples up to which they are equal.
const EVEN: f64 = 0.1;

/// Sentence that the tracks were filtered or interpolated; `None` if they were not, or the flights do not tell.
pub fn filtered(state: &State<'_>) -> Option<String> {
    let markers = markers(state.problem);
    let mut sums = Sums::default();
    for flight in &state.flights {
        for (place, &one) in markers.iter().enumerate() {
            for &other in &markers[place + 1..] {
                let series = deviations(flight, one, other);
                sums.add(&series, flight, state.interval);
                sums.add_phases(&series);
            }
        }
    }
    let seen = match sums.period() {
        Some(period) => format!("the distances between the markers repeat every {period} samples"),
        None => {
            let partial = sums.partial_autocorrelation()?;
            // The distances to one marker share its noise.
            let error = (markers.len() as f64 / sums.products[2].1).sqrt();
            if partial > FILTERED.min(-MIN_ERRORS * error) {
                return None;
            }
            format!(
                "the noise of the tracks lacks its high frequencies (partial autocorrelation {partial:.2} at two samples)"
            )
        }
    };
    Some(format!(
        "{seen}: they were filtered or interpolated, which makes the circles of the markers smaller. Use the positions as they were measured"
    ))
}

/// Deviation of the distance of two markers from its median in each sample, m, and the direction from one to the other;
/// `None` where one of them is not seen, or the deviation is an outlier.
fn deviations(flight: &Observations, one: usize, other: usize) -> Vec<Option<(f64, Vector3<f64>)>> {
    let apart = apart(flight, one, other);
    let apart: Vec<_> = apart
        .map(|apart| apart.map(|apart| (apart.norm(), apart.normalize())))
        .collect();
    let mut lengths: Vec<f64> = apart.iter().flatten().map(|(length, _)| *length).collect();
    let middle = median(&mut lengths);
    let mut sizes: Vec<f64> = lengths
        .iter()
        .map(|length| (length - middle).abs())
        .collect();
    let limit = OUTLIER * robust_sigma(&mut sizes);
    let each = apart.into_iter().map(|apart| {
        let (length, direction) = apart?;
        let deviation = length - middle;
        (deviation.abs() <= limit).then_some((deviation, direction))
    });
    each.collect()
}

/// Periods, in samples, with which an interpolation to a higher rate repeats.
const PERIODS: [usize; 3] = [2, 3, 4];
/// Normal score at which the distances repeat with a period.
const REPEATED: f64 = 8.0;

/// Sums of the products of deviations that are 0, 1 and 2 samples apart, with the sums of their weights. As the body
/// turns, the distance shows another direction of the noise: the weight of a product is the square of what the two
/// directions have in common.
#[derive(Default)]
struct Sums {
    products: [(f64, f64); 3],
    /// For each of [`PERIODS`], the squares between the means of its phases, m², and their degrees of freedom.
    between: [(f64, f64); 3],
}

impl Sums {
    fn add(
        &mut self,
        series: &[Option<(f64, Vector3<f64>)>],
        flight: &Observations,
        interval: f64,
    ) {
        for (lag, sum) in self.products.iter_mut().enumerate() {
            let times = zip(&flight.times, &flight.times[lag.min(flight.times.len())..]);
            for ((earlier, later), (from, to)) in
                zip(series, &series[lag.min(series.len())..]).zip(times)
            {
                let (Some(earlier), Some(later)) = (earlier, later) else {
                    continue;
                };
                if (to - from - lag as f64 * interval).abs() <= EVEN * interval {
                    let common = earlier.1.dot(&later.1);
                    sum.0 += earlier.0 * later.0 * common;
                    sum.1 += common * common;
                }
            }
        }
    }

    /// Adds the variation of the deviations with the phase of each of [`PERIODS`].
    fn add_phases(&mut self, series: &[Option<(f64, Vector3<f64>)>]) {
        let all = series.iter().flatten().map(|(deviation, _)| *deviation);
        let (total, count) = all.fold((0.0, 0.0), |(sum, n), value| (sum + value, n + 1.0));
        for (period, between) in PERIODS.into_iter().zip(&mut self.between) {
            for phase in 0..period {
                let own = series.iter().skip(phase).step_by(period).flatten();
                let (sum, n) = own.fold((0.0, 0.0), |(sum, n), (value, _)| (sum + value, n + 1.0));
                if n > 0.0 {
                    between.0 += n * (sum / n - total / count).powi(2);
                }
            }
            between.1 += (period - 1) as f64;
        }
    }

    /// Shortest period with which the distances repeat; `None` if they do not.
    fn period(&self) -> Option<usize> {
        let variance = self.products[0].0 / self.products[0].1;
        let repeats = |(_, (squares, freedom)): &(usize, (f64, f64))| {
            (squares / variance - freedom) / (2.0 * freedom).sqrt() > REPEATED
        };
        let mut periods = PERIODS.into_iter().zip(self.between);
        Some(periods.find(repeats)?.0)
    }

    /// Partial autocorrelation at two samples; `None` without deviations.
    fn partial_autocorrelation(&self) -> Option<f64> {
        let [zero, one, two] = self.products.map(|(sum, weight)| sum / weight);
        let (one, two) = (one / zero, two / zero);
        let partial = (two - one * one) / (1.0 - one * one);
        partial.is_finite().then_some(partial)
    }
}

#[cfg(test)]
mod tests {
    use crate::fit::fit;
    use crate::fit::tests::simulated;
    use crate::options::FitOptions;
    use dataset::Flight;
    use dataset::synthesize::{Corruption, Plan};

    /// Whether the fit of six flights of a disc says that their tracks were filtered. The noise has the autocorrelation
    /// `ar1`, and `change` is made to each flight.
    fn is_filtered(ar1: f64, change: impl Fn(&mut Flight)) -> bool {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let noise = Corruption {
            ar1,
            dropouts: 0.02,
            ..Corruption::default()
        };
        let plan = Plan {
            flights: 6,
            duration: Some(0.8),
            noise,
            ..Plan::default()
        };
        let mut dataset = simulated(&model, "backhand", &plan);
        dataset.flights.iter_mut().for_each(change);
        let fitted = fit(&model, &dataset, &FitOptions::default()).unwrap();
        let contradicted = &fitted.report.contradicted;
        contradicted
            .iter()
            .any(|sentence| sentence.contains("filtered"))
    }

    /// Replaces each position, or one of `step`, by the mean of the positions around it with the weights `weights`.
    fn smoothed(flight: &mut Flight, weights: &[f64], step: usize) {
        let (measured, half) = (flight.positions.clone(), weights.len() / 2);
        for sample in (half..measured.len() - half).step_by(step) {
            for (marker, position) in flight.positions[sample].iter_mut().enumerate() {
                let window = &measured[sample - half..];
                let each = weights
                    .iter()
                    .zip(window)
                    .map(|(weight, row)| Some((weight, row[marker]?)));
                let each: Option<Vec<(&f64, [f64; 3])>> = each.collect();
                *position = each.map(|each| {
                    [0, 1, 2].map(|axis| each.iter().map(|(weight, at)| *weight * at[axis]).sum())
                });
            }
        }
    }

    #[test]
    fn filtered_and_interpolated_tracks_are_recognised_and_correlated_noise_is_not() {
        assert!(!is_filtered(0.0, |_| {}));
        assert!(!is_filtered(0.6, |_| {}));
        assert!(!is_filtered(0.95, |_| {}));
        // Binomial weights pass about a quarter of the frequencies.
        let binomial = [1.0, 6.0, 15.0, 20.0, 15.0, 6.0, 1.0].map(|weight| weight / 64.0);
        assert!(is_filtered(0.0, |flight| smoothed(flight, &binomial, 1)));
        // Every other sample by cubic interpolation of the others.
        let cubic = [-1.0, 0.0, 9.0, 0.0, 9.0, 0.0, -1.0].map(|weight| weight / 16.0);
        assert!(is_filtered(0.0, |flight| smoothed(flight, &cubic, 2)));
    }
}
