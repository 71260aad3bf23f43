//! Outlier detection: a value is an outlier if its residual is far from the line through the neighbouring residuals.
//! Model error is smooth in time, and the line removes it.

use std::ops::Range;

use flight::parallel;

use crate::noise::{NoiseModel, OUTLIER_LIMIT, group_count};
use crate::observations::Observations;
use crate::problem::FitProblem;
use dataset::levels::NEIGHBOURS as SIDE;
use dataset::statistics::{median, median_of, robust_sigma};

/// Minimum number of measured values of a channel for outlier detection.
const MIN_POINTS: usize = 5;

/// Residuals of a flight as `[channel][sample]`, m; `None` for a missing value.
pub type Residuals = [Vec<Option<[f64; 3]>>];

/// Local residuals `[channel][sample]`, m: the difference of each residual from the line through its neighbours (by
/// least squares, or Theil and Sen for possible outliers), scaled to the noise of one residual. `None` for a missing
/// value and for channels with fewer than `MIN_POINTS` values.
fn local_residuals(times: &[f64], residuals: &Residuals) -> Vec<Vec<Option<[f64; 3]>>> {
    let all: Vec<Series> = residuals
        .iter()
        .map(|series| Series::of(times, series))
        .collect();
    let mut local_residuals: Vec<Vec<Option<[f64; 3]>>> = all
        .iter()
        .map(|series| series.local_residuals(residuals[0].len()))
        .collect();
    // The Theil–Sen line is expensive, and only possible outliers need it.
    let limit = robust_scale(local_residuals.iter()).map(|scale| THEIL_SEN_LIMIT * scale);
    let mut space = Vec::with_capacity(SIDE * (2 * SIDE - 1));
    for (series, local_residuals) in all.iter().zip(&mut local_residuals) {
        for (index, &sample) in series.samples.iter().enumerate() {
            let Some(local_residual) = &mut local_residuals[sample] else {
                continue;
            };
            for axis in 0..3 {
                if local_residual[axis].abs() > limit[axis] {
                    local_residual[axis] = series.local_residual(index, axis, &mut space);
                }
            }
        }
    }
    local_residuals
}

/// Local residual, in robust standard deviations, above which it is computed with the expensive Theil–Sen line.
const THEIL_SEN_LIMIT: f64 = 2.5;

const WINDOW: usize = 2 * SIDE + 1;

/// Measured values of one channel.
struct Series {
    times: Vec<f64>,
    samples: Vec<usize>,
    residuals: Vec<[f64; 3]>,
}

impl Series {
    fn of(times: &[f64], series: &[Option<[f64; 3]>]) -> Self {
        let mut samples = Vec::with_capacity(series.len());
        samples.extend((0..series.len()).filter(|sample| series[*sample].is_some()));
        Self {
            times: samples.iter().map(|sample| times[*sample]).collect(),
            residuals: samples
                .iter()
                .filter_map(|sample| series[*sample])
                .collect(),
            samples,
        }
    }

    /// Differences from least-squares lines, scaled, by sample; `None` for missing values or fewer than `MIN_POINTS`.
    fn local_residuals(&self, samples: usize) -> Vec<Option<[f64; 3]>> {
        let mut local_residuals = vec![None; samples];
        if self.samples.len() < MIN_POINTS {
            return local_residuals;
        }
        let mut line = Line::default();
        for (index, sample) in self.samples.iter().enumerate() {
            let window = self.window(index);
            line.through(&self.times[window.clone()], index - window.start);
            let mut beyond = [0.0; 3];
            for (weight, value) in line.weights.iter().zip(&self.residuals[window]) {
                for axis in 0..3 {
                    beyond[axis] += weight * value[axis];
                }
            }
            local_residuals[*sample] = Some(beyond.map(|beyond| beyond / line.spread));
        }
        local_residuals
    }

    /// Indices of the value at `index` and its neighbours; near an end, more of them are on one side.
    fn window(&self, index: usize) -> Range<usize> {
        let count = self.samples.len();
        // At the ends, the number of neighbours is the same, but they are on one side.
        let first = index.saturating_sub(SIDE).min(count.saturating_sub(WINDOW));
        first..(first + WINDOW).min(count)
    }

    /// Scaled difference of one value from the Theil–Sen line along one axis, m; `space` is scratch memory.
    fn local_residual(&self, index: usize, axis: usize, space: &mut Vec<f64>) -> f64 {
        let window = self.window(index);
        let mut points = [(0.0, 0.0); 2 * SIDE];
        let mut count = 0;
        let neighbours = window.clone().filter(|neighbour| *neighbour != index);
        for (point, neighbour) in points.iter_mut().zip(neighbours) {
            let since = self.times[neighbour] - self.times[index];
            *point = (since, self.residuals[neighbour][axis]);
            count += 1;
        }
        let mut line = Line::default();
        line.through(&self.times[window.clone()], index - window.start);
        (self.residuals[index][axis] - at_zero(&points[..count], space)) / line.spread
    }
}

/// Least-squares line through the neighbours of a value in its window.
#[derive(Default)]
struct Line {
    /// Times of the values in the window relative to the value to be tested, s.
    times: [f64; WINDOW],
    count: usize,
    /// Weights of the values whose sum is the difference of the tested value from the line.
    weights: [f64; WINDOW],
    /// Standard deviation of this difference, in units of the standard deviation of a value.
    spread: f64,
}

/// Relative difference of equal time offsets, for which weights are reused: times may be rounded.
const SAME_TIME: f64 = 1e-3;

impl Line {
    /// Computes the weights of a window; `own` is the index of the tested value.
    fn through(&mut self, times: &[f64], own: usize) {
        let time = times[own];
        let mut is_same = times.len() == self.count;
        for (known, other) in self.times.iter().zip(times) {
            is_same &= (other - time - known).abs() <= SAME_TIME * known.abs();
        }
        if is_same {
            return;
        }
        self.count = times.len();
        for (known, other) in self.times.iter_mut().zip(times) {
            *known = other - time;
        }
        // The value to be tested is at time 0 and adds nothing to the sums of the neighbours' times.
        let (times, neighbours) = (&self.times[..self.count], self.count as f64 - 1.0);
        let middle = times.iter().sum::<f64>() / neighbours;
        let squares: f64 = times.iter().map(|time| time * time).sum();
        let part = middle / (squares - neighbours * middle * middle);
        for (weight, time) in self.weights.iter_mut().zip(times) {
            *weight = (time - middle) * part - 1.0 / neighbours;
        }
        self.weights[own] = 1.0;
        self.spread = (1.0 + 1.0 / neighbours + middle * part).sqrt();
    }
}

/// Value at time 0 of the Theil–Sen line through points (time, value); `space` is scratch memory.
fn at_zero(points: &[(f64, f64)], space: &mut Vec<f64>) -> f64 {
    space.clear();
    for (i, (earlier, from)) in points.iter().enumerate() {
        let later = points[i + 1..].iter();
        space.extend(later.map(|(later, to)| (to - from) / (later - earlier)));
    }
    let slope = median(space);
    space.clear();
    space.extend(points.iter().map(|(time, value)| value - slope * time));
    median(space)
}

/// Flags the outliers of a flight by its residuals, indexed as [`Observations::outlier`]. `group_of` is the noise group
/// of each channel, `rounding` has the standard deviations of the rounding errors of each group.
pub fn outlier_mask(
    times: &[f64],
    residuals: &Residuals,
    group_of: &[usize],
    rounding: &[[f64; 3]],
) -> Vec<bool> {
    let local_residuals = local_residuals(times, residuals);
    let own = group_scales(&local_residuals, group_of);
    let scales = judged_scales(&[own], rounding).concat();
    let mut mask = vec![false; residuals.iter().map(Vec::len).sum()];
    for (place, _) in candidates(&local_residuals, &scales, group_of) {
        mask[place] = true;
    }
    mask
}

/// At convergence, at most one in this number of values may still change its outlier flag.
const POINTS_PER_CHANGED_MARK: usize = 10_000;

/// Marks the outliers of all flights, and estimates the noise of the other residuals after a fit of `unknowns`
/// unknowns, for a sampling interval in s. Returns it, and whether more flags changed than at convergence.
pub fn estimate_noise(
    problem: &FitProblem,
    flights: &mut [Observations],
    residuals: &[&Residuals],
    (unknowns, interval): (usize, f64),
    threads: usize,
) -> (NoiseModel, bool) {
    let group_of = problem.noise_groups();
    let found = parallel::each_on(threads, flights.len(), |flight| {
        let local_residuals = local_residuals(&flights[flight].times, residuals[flight]);
        let scales = group_scales(&local_residuals, &group_of);
        // The greater scales by which they are judged make no further value an outlier.
        let candidates = candidates(&local_residuals, &scales, &group_of);
        (scales, candidates)
    });
    let (own, candidates): (Vec<_>, Vec<_>) = found.into_iter().unzip();
    let scales = judged_scales(&own, &problem.rounding_of_groups());
    let marked = parallel::each_on(threads, flights.len(), |flight| {
        let observations = &flights[flight];
        let mut outlier = vec![false; observations.measured.len()];
        for (place, local_residual) in &candidates[flight] {
            let scale = scales[flight][group_of[place % observations.channels]];
            outlier[*place] = is_outlier(local_residual, scale);
        }
        let mut moments = problem.no_moments();
        for (channel, series) in residuals[flight].iter().enumerate() {
            let inliers = series.iter().enumerate().map(|(sample, residual)| {
                residual.filter(|_| !outlier[sample * observations.channels + channel])
            });
            let inliers: Vec<Option<[f64; 3]>> = inliers.collect();
            moments[group_of[channel]].add(&observations.times, &inliers, interval);
        }
        (outlier, moments)
    });
    let mut sums = problem.no_moments();
    let mut changed = 0;
    for (observations, (outlier, moments)) in flights.iter_mut().zip(marked) {
        let marks = observations.outlier.iter().zip(&outlier);
        changed += marks.filter(|(before, now)| before != now).count();
        observations.outlier = outlier;
        for (sum, of_flight) in sums.iter_mut().zip(&moments) {
            sum.join(of_flight);
        }
    }
    let points: usize = sums.iter().map(|sum| sum.count).sum();
    let noise = problem.noise_of(&sums, unknowns, interval);
    (noise, changed > points / POINTS_PER_CHANGED_MARK)
}

/// Robust standard deviation of the local residuals of each group of channels, along each axis, m.
fn group_scales(local_residuals: &Residuals, group_of: &[usize]) -> Vec<[f64; 3]> {
    let of_group = |group: usize| {
        let series = local_residuals.iter().zip(group_of);
        robust_scale(series.filter(|(_, own)| **own == group).map(|(own, _)| own))
    };
    (0..group_count(group_of)).map(of_group).collect()
}

/// Robust standard deviation along each axis of the local residuals of channels together, m.
fn robust_scale<'r>(
    local_residuals: impl Iterator<Item = &'r Vec<Option<[f64; 3]>>> + Clone,
) -> [f64; 3] {
    [0, 1, 2].map(|axis| {
        let all = local_residuals.clone().flatten().flatten();
        let mut sizes: Vec<f64> = all
            .map(|local_residual| local_residual[axis].abs())
            .collect();
        robust_sigma(&mut sizes)
    })
}

/// Standard deviations with which outliers are detected, m, by flight, group and axis: that of the flight in `own`, or
/// the median over the flights or that of rounding, by group, if it is greater.
fn judged_scales(own: &[Vec<[f64; 3]>], rounding: &[[f64; 3]]) -> Vec<Vec<[f64; 3]>> {
    let usual = |(group, least): (usize, &[f64; 3])| {
        [0, 1, 2].map(|axis| {
            let usual = median_of(own.iter().map(|scales| scales[group][axis]));
            usual.unwrap_or(0.0).max(least[axis])
        })
    };
    let usual: Vec<[f64; 3]> = rounding.iter().enumerate().map(usual).collect();
    let of_flight = |scales: &Vec<[f64; 3]>| {
        let pairs = scales.iter().zip(&usual);
        let greater = pairs.map(|(own, usual)| [0, 1, 2].map(|axis| usual[axis].max(own[axis])));
        greater.collect()
    };
    own.iter().map(of_flight).collect()
}

/// Outliers of a flight: index as in [`Observations::outlier`], and local residual, m. `scales` contains the standard
/// deviations by noise group, m.
fn candidates(
    local_residuals: &Residuals,
    scales: &[[f64; 3]],
    group_of: &[usize],
) -> Vec<(usize, [f64; 3])> {
    let channels = local_residuals.len();
    let mut candidates = Vec::new();
    for (channel, series) in local_residuals.iter().enumerate() {
        for (sample, local_residual) in series.iter().enumerate() {
            let outlier = local_residual.filter(|own| is_outlier(own, scales[group_of[channel]]));
            candidates.extend(outlier.map(|own| (sample * channels + channel, own)));
        }
    }
    candidates
}

fn is_outlier(local_residual: &[f64; 3], scale: [f64; 3]) -> bool {
    (0..3).any(|axis| local_residual[axis].abs() > OUTLIER_LIMIT * scale[axis])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smooth_misfit_is_no_outlier_and_a_spike_is() {
        let misfit = |i: usize| 0.2 * (i as f64 / 40.0).powi(2);
        let noise = |i: usize| 0.001 * ((i * 7919) as f64).sin();
        let mut series: Vec<Option<[f64; 3]>> = (0..80)
            .map(|i| Some([misfit(i) + noise(i), noise(i + 7), noise(i + 3)]))
            .collect();
        series[20].as_mut().unwrap()[0] += 0.03;
        series[22].as_mut().unwrap()[1] -= 0.03;
        series[50] = None;
        series[0].as_mut().unwrap()[2] += 0.05;
        series[79].as_mut().unwrap()[0] -= 0.05;
        let times: Vec<f64> = (0..80).map(f64::from).collect();
        let outlier_mask = outlier_mask(&times, &[series], &[0], &[[0.0; 3]]);
        let found: Vec<usize> = (0..80).filter(|&i| outlier_mask[i]).collect();
        assert_eq!(found, [0, 20, 22, 79]);
    }
}
