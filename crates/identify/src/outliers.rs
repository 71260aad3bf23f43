//! Outliers: points whose residual stands out from those around it.
//!
//! A model's own error is smooth in time and must not be taken for outliers: so a residual is held against
//! a line through its neighbours, and not against 0.

use crate::noise::{OUTLIER, median, robust_sigma};

/// Neighbours on either side that a residual is held against: two of all may be outliers too.
const SIDE: usize = 4;

/// Neighbours, with the point itself, that are needed to judge it.
const LEAST: usize = 5;

/// Residuals of a flight by marker and sample, m.
pub type Residuals = [Vec<Option<[f64; 3]>>];

/// How far each point's residual lies from where its neighbours would have it, by marker and sample, m. Where they
/// lie to one side, and say less, the distance counts for less.
pub fn local_residuals(times: &[f64], residuals: &Residuals) -> Vec<Vec<Option<[f64; 3]>>> {
    let seen: Vec<Series> = residuals
        .iter()
        .map(|series| Series::of(times, series))
        .collect();
    let mut local_residuals: Vec<Vec<Option<[f64; 3]>>> = seen
        .iter()
        .map(|series| series.local_residuals(residuals[0].len()))
        .collect();
    // Only what may be an outlier deserves the line that outliers do not move.
    let limit = scale(&local_residuals).map(|scale| SUSPECT * scale);
    let mut space = Vec::with_capacity(SIDE * (2 * SIDE - 1));
    for (series, local_residuals) in seen.iter().zip(&mut local_residuals) {
        for (index, &(_, sample, _)) in series.0.iter().enumerate() {
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

/// A departure by least squares beyond this many times the usual one is looked at again.
const SUSPECT: f64 = 2.5;

/// Times, samples and residuals of a marker where it was seen.
struct Series(Vec<(f64, usize, [f64; 3])>);

impl Series {
    fn of(times: &[f64], series: &[Option<[f64; 3]>]) -> Self {
        let mut seen = Vec::with_capacity(series.len());
        let each = series.iter().enumerate();
        seen.extend(each.filter_map(|(sample, r)| Some((times[sample], sample, (*r)?))));
        Self(seen)
    }

    /// By lines of least squares.
    fn local_residuals(&self, samples: usize) -> Vec<Option<[f64; 3]>> {
        let mut local_residuals = vec![None; samples];
        if self.0.len() < LEAST {
            return local_residuals;
        }
        let mut line = Line::default();
        for (index, &(time, sample, value)) in self.0.iter().enumerate() {
            line.through(self.neighbours(index).map(|(t, ..)| t - time));
            let mut beyond = value;
            for (weight, (.., value)) in line.weights().iter().zip(self.neighbours(index)) {
                beyond = [0, 1, 2].map(|axis| beyond[axis] - weight * value[axis]);
            }
            local_residuals[sample] = Some(beyond.map(|beyond| beyond / line.spread));
        }
        local_residuals
    }

    /// The neighbours that a point is held against.
    fn neighbours(&self, index: usize) -> impl Iterator<Item = &(f64, usize, [f64; 3])> + Clone {
        let seen = &self.0;
        // As many neighbours at the ends, all to one side.
        let first = index
            .saturating_sub(SIDE)
            .min(seen.len().saturating_sub(2 * SIDE + 1));
        let last = (first + 2 * SIDE + 1).min(seen.len());
        seen[first..index].iter().chain(&seen[index + 1..last])
    }

    /// How far a point lies along an axis from the line that outliers do not move.
    fn local_residual(&self, index: usize, axis: usize, space: &mut Vec<f64>) -> f64 {
        let (time, _, value) = self.0[index];
        let mut points = [(0.0, 0.0); 2 * SIDE];
        let mut count = 0;
        for (point, &(t, _, value)) in points.iter_mut().zip(self.neighbours(index)) {
            *point = (t - time, value[axis]);
            count += 1;
        }
        let points = &points[..count];
        let mut line = Line::default();
        line.through(points.iter().map(|&(time, _)| time));
        (value[axis] - at_zero(points, space)) / line.spread
    }
}

/// Where a line of least squares through points at some times passes time 0.
#[derive(Default)]
struct Line {
    times: [f64; 2 * SIDE],
    count: usize,
    weights: [f64; 2 * SIDE],
    /// The standard deviation of a new value at time 0 less that of the line there, over that of one value.
    spread: f64,
}

/// Times that differ by less than this part of the first are the same: samples at an even rate have the same lines.
const SAME: f64 = 1e-9;

impl Line {
    /// Draws it through points at these times, no more than twice as many as stand on a side.
    fn through(&mut self, times: impl Iterator<Item = f64> + Clone) {
        let near = |(time, drawn): (f64, &f64)| (time - drawn).abs() <= SAME * drawn.abs();
        if times.clone().count() == self.count && times.clone().zip(&self.times).all(near) {
            return;
        }
        self.count = 0;
        for (place, time) in self.times.iter_mut().zip(times) {
            *place = time;
            self.count += 1;
        }
        let (times, count) = (&self.times[..self.count], self.count as f64);
        let middle = times.iter().sum::<f64>() / count;
        let width: f64 = times.iter().map(|time| (time - middle).powi(2)).sum();
        let part = middle / width;
        for (weight, time) in self.weights.iter_mut().zip(times) {
            *weight = 1.0 / count - (time - middle) * part;
        }
        self.spread = (1.0 + 1.0 / count + middle * part).sqrt();
    }

    /// What each point's value counts for.
    fn weights(&self) -> &[f64] {
        &self.weights[..self.count]
    }
}

/// Where a line through points (time, value) passes time 0: by the medians of all slopes and of all intercepts, which
/// outliers do not move (Theil and Sen).
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

/// The usual size of departures along each axis, m.
pub fn scale(local_residuals: &Residuals) -> [f64; 3] {
    let mut sizes = Vec::with_capacity(local_residuals.iter().map(Vec::len).sum());
    [0, 1, 2].map(|axis| {
        let all = local_residuals.iter().flatten().flatten();
        sizes.clear();
        sizes.extend(all.map(|local_residual| local_residual[axis].abs()));
        robust_sigma(&mut sizes)
    })
}

/// The scale that is usual over flights.
pub fn usual(scales: &[[f64; 3]]) -> [f64; 3] {
    [0, 1, 2].map(|axis| {
        let mut values: Vec<f64> = scales.iter().map(|scale| scale[axis]).collect();
        median(&mut values)
    })
}

/// Points that stand out at a scale: places as [`Observations::outlier`](crate::track::Track::outlier) has them, and departures.
pub fn outlier_candidates(local_residuals: &Residuals, scale: [f64; 3]) -> Vec<(usize, [f64; 3])> {
    let markers = local_residuals.len();
    let mut outlier_candidates = Vec::new();
    for (marker, series) in local_residuals.iter().enumerate() {
        for (sample, local_residual) in series.iter().enumerate() {
            if let Some(local_residual) =
                local_residual.filter(|local_residual| is_outlier(local_residual, scale))
            {
                outlier_candidates.push((sample * markers + marker, local_residual));
            }
        }
    }
    outlier_candidates
}

/// Whether a departure is an outlier's.
pub fn is_outlier(local_residual: &[f64; 3], scale: [f64; 3]) -> bool {
    (0..3).any(|axis| local_residual[axis].abs() > OUTLIER * scale[axis])
}

/// Which points stand out, by sample and marker as [`Observations::outlier`](crate::track::Track::outlier) has them.
pub fn outlier_mask(local_residuals: &Residuals, scale: [f64; 3]) -> Vec<bool> {
    let mut outlier_mask = vec![false; local_residuals.iter().map(Vec::len).sum()];
    for (place, _) in outlier_candidates(local_residuals, scale) {
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
        let scale = scale(&local_residuals);
        let outlier_mask = outlier_mask(&local_residuals, scale);
        let found: Vec<usize> = (0..80).filter(|&i| outlier_mask[i]).collect();
        assert_eq!(found, [0, 20, 22, 79]);
    }
}
