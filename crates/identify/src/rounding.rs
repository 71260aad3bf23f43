//! Rounding of readings: the common step of their values, and the noise below which no estimate of theirs can be. Where
//! rounded readings stay the same, their scatter shows no noise, and they are wrong by up to half a step nevertheless.

use crate::channel::{Channel, ChannelKind};
use crate::noise::NoiseModel;
use dataset::Dataset;
use dataset::levels::MIN_SERIES;

/// Remainder of an exact division, in units of the largest value: printed numbers have seven digits or more, and the
/// remainders of a division add the errors of ten.
const EXACT: f64 = 5e-6;

/// Least step in units of the largest value; a smaller one could not be told from [`EXACT`].
const LEAST_STEP: f64 = 100.0 * EXACT;

/// Ratio of the noise to that of rounding from which rounding errors are random, as the noise beside them is half a step
/// or more (B. Widrow and I. Kollár, "Quantization Noise", 2008): √(1/4 + 1/12)·√12.
const RANDOM: f64 = 2.0;

/// Sets the rounding of the channels of positions and instruments, markers first, from all flights.
pub fn set(channels: &mut [Channel], dataset: &Dataset) {
    let markers = dataset.markers.len();
    for (index, channel) in channels.iter_mut().enumerate() {
        let is_rounded = matches!(
            channel.kind,
            ChannelKind::Marker(_) | ChannelKind::Position | ChannelKind::Instrument(_)
        );
        if !is_rounded {
            continue;
        }
        let values = |axis: usize| {
            let flights = dataset.flights.iter();
            flights.flat_map(move |flight| {
                (0..flight.times.len()).filter_map(move |sample| match index.checked_sub(markers) {
                    None => Some(flight.positions.get(sample)?[index]?[axis]),
                    Some(reading) => Some((*flight.readings.get(sample)?.get(reading)?)?[axis]),
                })
            })
        };
        let own = [0, 1, 2].map(|axis| deviation(values(axis)));
        // An axis whose readings are all the same is read by the same instrument.
        let others = own.iter().flatten().fold(0.0_f64, |a, b| a.max(*b));
        channel.rounding = own.map(|own| own.unwrap_or(others));
        let mut rounded = (0..3).filter(|axis| own[*axis].is_some());
        channel.repeats = rounded.any(|axis| {
            let pairs = values(axis).zip(values(axis).skip(1));
            let (same, all) = pairs.fold((0, 0), |(same, all), (one, next)| {
                (same + usize::from(one == next), all + 1)
            });
            2 * same > all
        });
    }
}

impl Channel {
    /// Whether what a fit with this noise leaves of the channel is the error of rounding, which is neither random nor a
    /// lack of the model.
    pub(crate) fn shows_rounding(&self, noise: &NoiseModel) -> bool {
        let sigma = noise.groups()[self.group].sigma;
        let mut axes = sigma.into_iter().zip(self.rounding);
        let is_below = |(sigma, rounding): (f64, f64)| sigma < RANDOM * rounding * self.scale;
        self.repeats && axes.any(is_below)
    }
}

/// Standard deviation of the rounding errors of a noise group along each axis, m: the greatest of its channels.
pub fn of_group(channels: &[Channel], group: usize) -> [f64; 3] {
    let channels = channels.iter().filter(|own| own.group == group);
    channels.fold([0.0; 3], |most: [f64; 3], own| {
        [0, 1, 2].map(|axis| most[axis].max(own.rounding[axis] * own.scale))
    })
}

/// Standard deviation of the rounding errors of values; `None` if they are all the same. 0 if they have no step, or are
/// too few to tell.
fn deviation(values: impl Iterator<Item = f64> + Clone) -> Option<f64> {
    let first = values.clone().next()?;
    let largest = values.clone().fold(0.0_f64, |a, b| a.max(b.abs()));
    let (mut step, mut count) = (0.0, 0);
    for value in values {
        step = common_divisor(step, (value - first).abs(), EXACT * largest);
        count += 1;
        if step > 0.0 && step < LEAST_STEP * largest {
            return Some(0.0);
        }
    }
    match step > 0.0 {
        true if count >= MIN_SERIES => Some(step / 12.0_f64.sqrt()),
        true => Some(0.0),
        false => None,
    }
}

/// Greatest common divisor by Euclid's algorithm; a remainder up to `exact` is none.
fn common_divisor(mut one: f64, mut other: f64, exact: f64) -> f64 {
    while other > exact {
        (one, other) = (other, (one - (one / other).round() * other).abs());
    }
    one
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::tests::balls;
    use crate::options::FitOptions;
    use crate::problem::FitProblem;

    #[test]
    fn what_is_left_is_rounding_where_values_repeat_and_no_noise_is_above_their_step() {
        let (model, dataset) = balls(1, 0.2);
        let problem = FitProblem::new(&model, &dataset, &FitOptions::default()).unwrap();
        let mut channel = problem.channels[0].clone();
        for (rounding, repeats) in [(1.0, true), (1.0, false), (1e-9, true), (1e-9, false)] {
            channel.rounding = [rounding; 3];
            channel.repeats = repeats;
            let found = channel.shows_rounding(&NoiseModel::white(1e-3, 0.01));
            assert_eq!(found, rounding == 1.0 && repeats, "{rounding} {repeats}");
        }
    }

    #[test]
    fn the_step_is_found_whatever_the_readings_miss_of_it() {
        let rounded = |step: f64| (0..50).map(move |i| step * f64::from([34, 37, 39, 44][i % 4]));
        for step in [1.0, 0.5, 2.0_f64.to_radians(), 0.3048 / 8.0] {
            let printed = |value: f64| format!("{value:.6e}").parse::<f64>().unwrap();
            let found = deviation(rounded(step).map(printed)).unwrap();
            assert!((found * 12.0_f64.sqrt() / step - 1.0).abs() < 1e-3);
        }
    }

    #[test]
    fn readings_without_a_step_have_no_rounding() {
        assert_eq!(deviation((0..50).map(|i| f64::from(i).sin())), Some(0.0));
        assert_eq!(deviation((0..50).map(|_| 17.0)), None);
        assert_eq!(deviation((0..5).map(f64::from)), Some(0.0));
    }
}
