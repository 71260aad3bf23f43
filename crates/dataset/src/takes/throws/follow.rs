//! Following of a free flight sample by sample: each sample is compared with its prediction from the preceding ones.

use std::ops::Range;

use super::cut::{FlightEnd, Stop, beyond};
use super::path::Path;
use super::windows::half;
use super::{FINEST, ThrowOptions};
use crate::statistics::robust_sigma;

/// Difference of a position from its prediction, in standard deviations, above which the sample deviates.
const STRANGE: f64 = 4.5;
/// Consecutive deviating samples after which it is examined whether the flight ends there.
const CONSECUTIVE: usize = 2;
/// Rate of change of the acceleration in free flight, m/s³, that is tolerated in a prediction by a quadratic in time.
const JERK: f64 = 60.0;

impl Path<'_> {
    /// Follows a flight backwards and forwards from the middle of `run`; returns why it ended on either side.
    pub fn follow(&self, run: &Range<usize>, options: &ThrowOptions) -> (Stop, Stop) {
        let noise = self.noise(run);
        let middle = (run.start + run.end) / 2;
        let half = half(self.track);
        let around = middle.saturating_sub(half)..(middle + half + 1).min(self.points.len());
        let mut backwards: Vec<usize> = around.clone().collect();
        backwards.reverse();
        (
            self.extend(backwards, false, noise, options),
            self.extend(around.collect(), true, noise, options),
        )
    }

    /// Follows a flight from the samples `inside` in one direction of time.
    fn extend(
        &self,
        mut inside: Vec<usize>,
        forward: bool,
        noise: f64,
        options: &ThrowOptions,
    ) -> Stop {
        let times = &self.track.times;
        let length = inside.len();
        // Across a shorter gap the time of a change is located; half an interval allows for rounded times.
        let located = (beyond(self.track) as f64 + 0.5) * self.track.step;
        let step = |i: usize, by: usize| match forward {
            true => Some(i + by).filter(|&next| next < times.len()),
            false => i.checked_sub(by),
        };
        loop {
            let Some((last, next)) = inside.last().and_then(|&last| Some((last, step(last, 1)?)))
            else {
                return Stop::Data;
            };
            let end = || FlightEnd::new(self, last, !forward);
            // A slight touch may cause no deviation from the prediction.
            if forward && self.is_ground && end().touches() {
                return Stop::Touch { last };
            }
            let recent = &inside[inside.len() - length.min(inside.len())..];
            let gap = (times[next] - times[last]).abs();
            let stopped_by_gap = Stop::Gap {
                from: last,
                to: next,
            };
            if gap > options.longest_gap {
                return stopped_by_gap;
            }
            let mut following = (1..=CONSECUTIVE).filter_map(|by| step(last, by));
            let good = following.find(|&index| self.is_predicted(recent, index, noise));
            match good.or_else(|| (!end().is_break()).then_some(next)) {
                Some(good) => inside.push(good),
                None if gap > located => return stopped_by_gap,
                None => return Stop::Deviation { last },
            }
        }
    }

    /// Whether a sample agrees with the extrapolation of a quadratic in time fitted to the samples `recent`.
    fn is_predicted(&self, recent: &[usize], index: usize, noise: f64) -> bool {
        let times = &self.track.times;
        let t0 = times[index];
        let [first, last] = [times[recent[0]], times[recent[recent.len() - 1]]];
        let scale = (first - last).abs().max(self.track.step);
        let fitted = self.quadratic(recent.iter().copied(), t0, scale);
        fitted.is_some_and(|(coefficients, factor)| {
            let leverage = factor.inverse()[(0, 0)];
            let ahead = (t0 - last).abs();
            let allowed = STRANGE * noise * (1.0 + leverage).sqrt() + JERK * ahead.powi(3) / 6.0;
            let off = coefficients.row(0).transpose() - self.points[index];
            off.iter().all(|part| part.abs() <= allowed)
        })
    }

    /// Robust standard deviation of a measured position in a range of samples, m, from third differences.
    fn noise(&self, run: &Range<usize>) -> f64 {
        let (half, times) = (half(self.track), &self.track.times);
        let wide = run.start.saturating_sub(half / 2)..(run.end + half / 2).min(times.len());
        let near = |i: &usize| times[*i] - times[i - 3] <= 3.5 * self.track.step;
        let sizes = (wide.start + 3..wide.end).filter(near).flat_map(|i| {
            let [a, b, c, d] = [0, 1, 2, 3].map(|back| self.points[i - back]);
            // The variance of a third difference is 20 times that of a sample.
            let third = (a - b * 3.0 + c * 3.0 - d).abs() / 20.0_f64.sqrt();
            [third.x, third.y, third.z]
        });
        robust_sigma(&mut sizes.collect::<Vec<f64>>()).max(FINEST)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::takes::throws::windows::tests::track;
    use nalgebra::Vector3;

    /// As between the hand and the ground.
    #[test]
    fn the_noise_is_that_of_the_flight_and_not_of_what_is_before_and_after() {
        let flight = 1000..1020;
        let track = track(0.0, |k| if flight.contains(&k) { 1e-3 } else { 2e-2 });
        let noise = Path::new(&track, Vector3::zeros()).noise(&flight);
        assert!((0.5e-3..3e-3).contains(&noise), "{noise}");
    }
}
