//! Whether the tracks of markers were filtered or interpolated, told by the noise of the distances between them.

use std::iter::zip;

use flight::moore_penrose;
use nalgebra::{DMatrix, DVector, Vector3};

use super::marker_distances::{all_apart, marker_count};
use super::state::State;
use crate::observations::Observations;
use dataset::levels::{RANK, SIGNIFICANT};
use dataset::statistics::{median, robust_sigma};

/// Partial autocorrelation of the noise at two samples below which it was filtered. Noise of first order has none;
/// binomial means of three samples have −0.5, cubic interpolation −0.6.
const FILTERED: f64 = -0.25;
/// Relative difference of two intervals between samples up to which they are equal.
const EVEN: f64 = 0.1;

/// Sentence that the tracks were filtered or interpolated; `None` if they were not, or the flights do not tell. The
/// noise of the distances then lacks its high frequencies, or they are shorter in every second, third or fourth sample,
/// since an interpolation cuts corners.
pub fn filtered(state: &State<'_>) -> Option<String> {
    seen_in(state, lengths)?;
    // What turns with the body may look like noise without high frequencies.
    let seen = seen_in(state, deviations)?;
    Some(format!(
        "{seen}: they were filtered or interpolated, which makes the circles of the markers smaller. Use the positions as they were measured"
    ))
}

/// What the series that `of` makes of the distances between two markers show of a filter.
fn seen_in(state: &State<'_>, of: fn(&[Option<Vector3<f64>>]) -> Series) -> Option<String> {
    let mut sums = Sums::default();
    for (place, _, apart) in all_apart(state) {
        let series = of(&apart);
        sums.add(&series, &state.flights[place], state.interval);
        sums.add_phases(&series);
    }
    if let Some(period) = sums.period() {
        return Some(format!(
            "the distances between the markers repeat every {period} samples"
        ));
    }
    let partial = sums.partial_autocorrelation()?;
    // The distances to one marker share its noise.
    let error = (marker_count(state.problem) as f64 / sums.products[2].1).sqrt();
    (partial <= FILTERED.min(-SIGNIFICANT * error)).then(|| {
        format!(
            "the noise of the tracks lacks its high frequencies (partial autocorrelation {partial:.2} at two samples)"
        )
    })
}

/// Number of terms of a distance that turn with the body, and least number of samples for each of them.
const TURNING: (usize, usize) = (17, 3);

/// What a distance may follow if the markers are seen at different times, sit elsewhere, or lengths are distorted: the
/// direction from one marker to the other, modulated by the motion of the body in the part `past` of the flight; the most
/// important terms first.
fn turning(past: f64, direction: Vector3<f64>) -> [f64; TURNING.0] {
    let [x, y, z] = direction.into();
    let (squared, [xx, yy]) = (past * past, [x * x, y * y]);
    [
        1.0,
        x,
        y,
        z,
        past * x,
        past * y,
        past * z,
        past,
        x * y,
        y * z,
        z * x,
        xx,
        yy,
        squared,
        squared * x,
        squared * y,
        squared * z,
    ]
}

/// Share of the squares of a distance that is left where the rest turns with the body. A part that turns looks like noise
/// without high frequencies where it has nine tenths of them or more; the terms take less of filtered noise.
const LEFT: f64 = 0.2;

/// Deviation of the distance of two markers in each sample, m, and the direction from one to the other; `None` where it is
/// not seen or an outlier.
type Series = Vec<Option<(f64, Vector3<f64>)>>;

/// Deviations of the distances from their median.
fn lengths(apart: &[Option<Vector3<f64>>]) -> Series {
    let seen = apart.iter().flatten().map(Vector3::norm);
    let middle = median(&mut seen.clone().collect::<Vec<_>>());
    series(apart, seen.map(|length| length - middle).collect())
}

/// Deviations of the distances from their median or, where most of it turns with the body, from what does.
fn deviations(apart: &[Option<Vector3<f64>>]) -> Series {
    let seen = apart.iter().enumerate();
    let seen = seen.filter_map(|(sample, apart)| Some((sample, (*apart)?)));
    let seen: Vec<(usize, Vector3<f64>)> = seen.collect();
    let terms = (seen.len() / TURNING.1).clamp(1, TURNING.0);
    let rows = seen
        .iter()
        .map(|(sample, own)| turning(*sample as f64 / apart.len() as f64, own.normalize()));
    let rows: Vec<[f64; TURNING.0]> = rows.collect();
    let design = DMatrix::from_fn(seen.len(), terms, |row, term| rows[row][term]);
    let length = DVector::from_iterator(seen.len(), seen.iter().map(|(_, apart)| apart.norm()));
    let plain = length.add_scalar(-median(&mut length.as_slice().to_vec()));
    let left = &length - &design * (moore_penrose(&design, RANK) * &length);
    match left.norm_squared() < LEFT * plain.norm_squared() {
        true => series(apart, left.as_slice().to_vec()),
        false => lengths(apart),
    }
}

/// The `deviations` of the distances that are seen, without outliers.
fn series(apart: &[Option<Vector3<f64>>], deviations: Vec<f64>) -> Series {
    let mut sizes: Vec<f64> = deviations.iter().map(|own| own.abs()).collect();
    let limit = SIGNIFICANT * robust_sigma(&mut sizes);
    let mut deviations = deviations.into_iter();
    let each = apart.iter().map(|apart| {
        let (apart, deviation) = ((*apart)?, deviations.next()?);
        (deviation.abs() <= limit).then(|| (deviation, apart.normalize()))
    });
    each.collect()
}

/// Periods, in samples, with which an interpolation to a higher rate repeats.
const PERIODS: [usize; 3] = [2, 3, 4];
/// Normal score at which the distances repeat with a period.
const REPEATED: f64 = 8.0;

/// Sums of products of deviations 0, 1 and 2 samples apart, with the sums of their weights: the squares of what the two
/// directions, which turn with the body, have in common.
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
    use dataset::synthesize::{Corruption, Plan};
    use dataset::{Dataset, Flight};

    /// Six flights of a disc.
    fn flights(noise: Corruption) -> Dataset {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let plan = Plan {
            flights: 6,
            duration: Some(0.8),
            noise,
            ..Plan::default()
        };
        simulated(&model, "backhand", &plan)
    }

    /// Whether the fit of six flights of a disc says that their tracks were filtered. The noise has the autocorrelation
    /// `ar1`, and `change` is made to each flight.
    fn is_filtered(ar1: f64, change: impl Fn(&mut Flight)) -> bool {
        let mut dataset = flights(Corruption {
            ar1,
            dropouts: 0.02,
            ..Corruption::default()
        });
        dataset.flights.iter_mut().for_each(change);
        tells_filter(&dataset)
    }

    fn tells_filter(dataset: &Dataset) -> bool {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let fitted = fit(&model, dataset, &FitOptions::default()).unwrap();
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

    #[test]
    fn markers_that_are_seen_one_after_the_other_are_not_taken_for_filtered_ones() {
        const LATER: [f64; 3] = [0.0, 0.004, 0.001];
        let exact = flights(Corruption {
            sigma: 0.0,
            ..Corruption::default()
        });
        let mut dataset = flights(Corruption::default());
        for (flight, exact) in dataset.flights.iter_mut().zip(&exact.flights) {
            let samples = flight.times.len();
            for sample in 1..samples - 1 {
                let interval = flight.times[sample + 1] - flight.times[sample - 1];
                for (marker, later) in LATER.into_iter().enumerate() {
                    let [from, to] = [sample - 1, sample + 1].map(|k| exact.positions[k][marker]);
                    let moved = from.zip(to).zip(flight.positions[sample][marker].as_mut());
                    if let Some(((from, to), point)) = moved {
                        *point = [0, 1, 2].map(|k| point[k] + later / interval * (to[k] - from[k]));
                    }
                }
            }
        }
        assert!(!tells_filter(&dataset));
    }
}
