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
pub fn departures(times: &[f64], residuals: &Residuals) -> Vec<Vec<Option<[f64; 3]>>> {
    let seen: Vec<Series> = residuals
        .iter()
        .map(|series| Series::of(times, series))
        .collect();
    let mut departures: Vec<Vec<Option<[f64; 3]>>> = seen
        .iter()
        .map(|series| series.departures(residuals[0].len()))
        .collect();
    // Only what may be an outlier deserves the line that outliers do not move.
    let limit = scale(&departures).map(|scale| SUSPECT * scale);
    let mut space = Vec::with_capacity(SIDE * (2 * SIDE - 1));
    for (series, departures) in seen.iter().zip(&mut departures) {
        for (index, &(_, sample, _)) in series.0.iter().enumerate() {
            let Some(departure) = &mut departures[sample] else {
                continue;
            };
            for axis in 0..3 {
                if departure[axis].abs() > limit[axis] {
                    departure[axis] = series.departure(index, axis, &mut space);
                }
            }
        }
    }
    departures
}

/// A departure by least squares beyond this many times the usual one is looked at again.
const SUSPECT: f64 = 2.0;

/// Times, samples and residuals of a marker where it was seen.
struct Series(Vec<(f64, usize, [f64; 3])>);

impl Series {
    fn of(times: &[f64], series: &[Option<[f64; 3]>]) -> Self {
        let seen = series.iter().enumerate();
        Self(
            seen.filter_map(|(sample, residual)| residual.map(|r| (times[sample], sample, r)))
                .collect(),
        )
    }

    /// By lines of least squares.
    fn departures(&self, samples: usize) -> Vec<Option<[f64; 3]>> {
        let mut departures = vec![None; samples];
        if self.0.len() < LEAST {
            return departures;
        }
        for (index, &(time, sample, value)) in self.0.iter().enumerate() {
            let neighbours = self
                .neighbours(index)
                .map(|&(t, _, value)| (t - time, value));
            let (at_zero, spread) = least_squares_at_zero(neighbours);
            departures[sample] = Some([0, 1, 2].map(|axis| (value[axis] - at_zero[axis]) / spread));
        }
        departures
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
    fn departure(&self, index: usize, axis: usize, space: &mut Vec<f64>) -> f64 {
        let (time, _, value) = self.0[index];
        let mut points = [(0.0, 0.0); 2 * SIDE];
        let mut count = 0;
        for (point, &(t, _, value)) in points.iter_mut().zip(self.neighbours(index)) {
            *point = (t - time, value[axis]);
            count += 1;
        }
        let points = &points[..count];
        let all = points.iter().map(|&(time, _)| (time, [0.0; 3]));
        let (_, spread) = least_squares_at_zero(all);
        (value[axis] - at_zero(points, space)) / spread
    }
}

/// Where the lines of least squares through points (time, values) pass time 0; and the standard deviation of a new value
/// less that, over that of one value.
fn least_squares_at_zero(points: impl Iterator<Item = (f64, [f64; 3])> + Clone) -> ([f64; 3], f64) {
    let (mut count, mut time, mut value) = (0.0, 0.0, [0.0; 3]);
    for (t, values) in points.clone() {
        count += 1.0;
        time += t;
        value = [0, 1, 2].map(|axis| value[axis] + values[axis]);
    }
    let (time, value) = (time / count, value.map(|sum| sum / count));
    let (mut width, mut slope) = (0.0, [0.0; 3]);
    for (t, values) in points {
        let from = t - time;
        width += from * from;
        slope = [0, 1, 2].map(|axis| slope[axis] + from * (values[axis] - value[axis]));
    }
    let part = time / width;
    let at_zero = [0, 1, 2].map(|axis| value[axis] - slope[axis] * part);
    (at_zero, (1.0 + 1.0 / count + time * part).sqrt())
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
pub fn scale(departures: &Residuals) -> [f64; 3] {
    [0, 1, 2].map(|axis| {
        let all = departures.iter().flatten().flatten();
        let mut sizes: Vec<f64> = all.map(|departure| departure[axis].abs()).collect();
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

/// Points that stand out at a scale: places as [`Track::outlier`](crate::track::Track::outlier) has them, and departures.
pub fn suspects(departures: &Residuals, scale: [f64; 3]) -> Vec<(usize, [f64; 3])> {
    let markers = departures.len();
    let mut suspects = Vec::new();
    for (marker, series) in departures.iter().enumerate() {
        for (sample, departure) in series.iter().enumerate() {
            if let Some(departure) = departure.filter(|departure| stands_out(departure, scale)) {
                suspects.push((sample * markers + marker, departure));
            }
        }
    }
    suspects
}

/// Whether a departure is an outlier's.
pub fn stands_out(departure: &[f64; 3], scale: [f64; 3]) -> bool {
    (0..3).any(|axis| departure[axis].abs() > OUTLIER * scale[axis])
}

/// Which points stand out, by sample and marker as [`Track::outlier`](crate::track::Track::outlier) has them.
pub fn marks(departures: &Residuals, scale: [f64; 3]) -> Vec<bool> {
    let mut marks = vec![false; departures.iter().map(Vec::len).sum()];
    for (place, _) in suspects(departures, scale) {
        marks[place] = true;
    }
    marks
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
        let departures = departures(&times, &[series]);
        let scale = scale(&departures);
        let marks = marks(&departures, scale);
        let found: Vec<usize> = (0..80).filter(|&i| marks[i]).collect();
        assert_eq!(found, [0, 20, 22, 79]);
    }
}
