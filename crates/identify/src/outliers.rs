//! Outlier detection: a value is an outlier if its residual is far from the line through the neighbouring residuals.
//!
//! Model error is smooth in time: the line through the neighbours removes it, so that it is not mistaken for outliers.

use std::ops::Range;

use crate::noise::{OUTLIER_LIMIT, group_count};
use dataset::statistics::{median, median_of, robust_sigma};

/// Number of neighbours on each side of a value through which a line is fitted to detect whether the value is an
/// outlier. Two of the neighbours may be outliers.
const SIDE: usize = 4;

/// Minimum number of measured values of a channel for outlier detection.
const MIN_POINTS: usize = 5;

/// Residuals of a flight as `[channel][sample]`, m; `None` for a missing value.
pub type Residuals = [Vec<Option<[f64; 3]>>];

/// Local-linear residuals as `[channel][sample]`, m: the difference of each residual from the line through its
/// neighbours, scaled so that its standard deviation is that of one residual. The line is a least-squares line, or a
/// Theil–Sen line for possible outliers. `None` for a missing value and for channels with fewer than `MIN_POINTS`
/// values.
pub fn local_residuals(times: &[f64], residuals: &Residuals) -> Vec<Vec<Option<[f64; 3]>>> {
    let all: Vec<Series> = residuals
        .iter()
        .map(|series| Series::of(times, series))
        .collect();
    let mut local_residuals: Vec<Vec<Option<[f64; 3]>>> = all
        .iter()
        .map(|series| series.local_residuals(residuals[0].len()))
        .collect();
    // The Theil–Sen line is expensive, and only possible outliers need it.
    let limit = robust_scale(&local_residuals).map(|scale| THEIL_SEN_LIMIT * scale);
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

/// Local residual (difference of a value from the least-squares line through its neighbours), in robust standard
/// deviations, above which it is computed again with a Theil–Sen line, which is robust but expensive.
const THEIL_SEN_LIMIT: f64 = 2.5;

/// Number of values in a window, which contains a value and its neighbours.
const WINDOW: usize = 2 * SIDE + 1;

/// Measured values of one channel.
struct Series {
    /// Time of each value, s.
    times: Vec<f64>,
    /// Sample index of each value.
    samples: Vec<usize>,
    /// Residuals, m.
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

    /// Differences of the values from least-squares lines through their neighbours, m, by sample index. Each is scaled
    /// so that its standard deviation is that of one value. `None` for missing values, and for all values if there are
    /// fewer than `MIN_POINTS`.
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

    /// Indices of the value at `index` of the series and of its neighbours: `SIDE` values before and `SIDE` values after
    /// it. Near an end of the series, more of them are on one side.
    fn window(&self, index: usize) -> Range<usize> {
        let count = self.samples.len();
        // At the ends, the number of neighbours is the same, but they are on one side.
        let first = index.saturating_sub(SIDE).min(count.saturating_sub(WINDOW));
        first..(first + WINDOW).min(count)
    }

    /// Difference of one value from the Theil–Sen line through its neighbours along one axis, m, scaled so that its
    /// standard deviation is that of one value. `space` is scratch memory.
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
    /// Weights of the values in the window whose weighted sum is the difference of the value to be tested from the line
    /// at its time.
    weights: [f64; WINDOW],
    /// Standard deviation of this difference, in units of the standard deviation of a value.
    spread: f64,
}

/// Relative difference up to which time offsets between samples are considered equal, so that evenly spaced samples
/// share the weights of the straight line fitted to their neighbours. Times may be rounded in the data, and a residual
/// changes little within this part of a sampling interval.
const SAME_TIME: f64 = 1e-3;

impl Line {
    /// Computes the weights of the values in a window. `times` are their times, s, at most `WINDOW`, and `own` is the
    /// index of the value to be tested. The weights are kept if the times relative to this value have not changed.
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

/// Value at time 0 of the Theil–Sen line through points (time, value): median slope of all pairs, median intercept.
/// `space` is scratch memory.
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

/// Robust standard deviation of the local residuals of each group of channels, along each axis, m. `group_of` gives the
/// group of each channel.
pub fn group_scales(local_residuals: &Residuals, group_of: &[usize]) -> Vec<[f64; 3]> {
    let groups = group_count(group_of);
    let of_group = |group: usize| {
        let series = local_residuals.iter().zip(group_of);
        let series = series.filter(|(_, own)| **own == group);
        let series: Vec<_> = series.map(|(series, _)| series.clone()).collect();
        robust_scale(&series)
    };
    match groups {
        1 => vec![robust_scale(local_residuals)],
        _ => (0..groups).map(of_group).collect(),
    }
}

/// Robust standard deviation along each axis of the local residuals of all channels together, m.
pub fn robust_scale(local_residuals: &Residuals) -> [f64; 3] {
    let mut sizes = Vec::with_capacity(local_residuals.iter().map(Vec::len).sum());
    [0, 1, 2].map(|axis| {
        let all = local_residuals.iter().flatten().flatten();
        sizes.clear();
        sizes.extend(all.map(|local_residual| local_residual[axis].abs()));
        robust_sigma(&mut sizes)
    })
}

/// Standard deviations of local residuals with which outliers are detected, m, by flight, noise group of channels, and
/// axis. Each is the robust standard deviation of the flight itself (in `own`), or the median over all flights if that
/// is greater. A local residual is the difference of a residual from the line through the neighbouring residuals.
pub fn judged_scales(own: &[Vec<[f64; 3]>]) -> Vec<Vec<[f64; 3]>> {
    let groups = own.first().map_or(0, Vec::len);
    let usual = |group: usize| {
        [0, 1, 2].map(|axis| median_of(own.iter().map(|scales| scales[group][axis])).unwrap_or(0.0))
    };
    let usual: Vec<[f64; 3]> = (0..groups).map(usual).collect();
    let of_flight = |scales: &Vec<[f64; 3]>| {
        let pairs = scales.iter().zip(&usual);
        let greater = pairs.map(|(own, usual)| [0, 1, 2].map(|axis| usual[axis].max(own[axis])));
        greater.collect()
    };
    own.iter().map(of_flight).collect()
}

/// Returns the outliers of a flight: the index `sample * channels + channel` of each value, as in
/// `Observations::outlier`, and its local residual, m (difference of a residual from the line through the neighbouring
/// residuals). `scales` contains the standard deviations of the local residuals by noise group, m.
pub fn outlier_candidates(
    local_residuals: &Residuals,
    scales: &[[f64; 3]],
    group_of: &[usize],
) -> Vec<(usize, [f64; 3])> {
    let channels = local_residuals.len();
    let mut outlier_candidates = Vec::new();
    for (channel, series) in local_residuals.iter().enumerate() {
        let scale = scales[group_of.get(channel).copied().unwrap_or(0)];
        for (sample, local_residual) in series.iter().enumerate() {
            if let Some(local_residual) =
                local_residual.filter(|local_residual| is_outlier(local_residual, scale))
            {
                outlier_candidates.push((sample * channels + channel, local_residual));
            }
        }
    }
    outlier_candidates
}

/// Whether a value is an outlier, given its local residual (difference of its residual from the line through the
/// neighbouring residuals), m, and the standard deviations `scale` (m) of local residuals along the axes.
pub fn is_outlier(local_residual: &[f64; 3], scale: [f64; 3]) -> bool {
    (0..3).any(|axis| local_residual[axis].abs() > OUTLIER_LIMIT * scale[axis])
}

/// Outlier flags of the values of a flight, indexed by `sample * channels + channel` as in `Observations::outlier`.
/// `local_residuals` contains the differences of the residuals from the line through the neighbouring residuals, m, and
/// `scales` their standard deviations by noise group, m.
pub fn outlier_mask(
    local_residuals: &Residuals,
    scales: &[[f64; 3]],
    group_of: &[usize],
) -> Vec<bool> {
    let mut outlier_mask = vec![false; local_residuals.iter().map(Vec::len).sum()];
    for (place, _) in outlier_candidates(local_residuals, scales, group_of) {
        outlier_mask[place] = true;
    }
    outlier_mask
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
        let local_residuals = local_residuals(&times, &[series]);
        let scale = robust_scale(&local_residuals);
        let outlier_mask = outlier_mask(&local_residuals, &[scale], &[0]);
        let found: Vec<usize> = (0..80).filter(|&i| outlier_mask[i]).collect();
        assert_eq!(found, [0, 20, 22, 79]);
    }
}
