//! Noise groups of markers. Markers whose noise is alike share one noise process; a marker whose noise is far from that
//! of the others, such as one that glints, has a noise process of its own.
//!
//! The variance of the distance of two markers of a rigid body is the sum of the variances of their noise along the line
//! between them, whatever the motion of the body is. The variances of all pairs give those of the markers by least
//! squares.

use dataset::pose::distance;
use dataset::statistics::{median_of, robust_sigma};
use nalgebra::{DMatrix, DVector};

use crate::noise::{NoiseModel, group_count};
use crate::numbers::quantity;
use crate::observations::Observations;
use crate::problem::FitProblem;
use dataset::levels::{LEAST_NOISE, ROBUST_ERROR, ROUGHLY_NOISE, SIGNIFICANT};

/// Maximum number of markers whose noise is compared; further ones share the noise of most.
const MAX_MARKERS: usize = 32;

/// Gives each marker whose noise differs from the usual one a noise group of its own. Does nothing if the dataset states
/// the noise of the markers, or there are fewer than three, whose distances do not tell which one is noisy.
pub fn set_groups<'o>(
    problem: &mut FitProblem,
    flights: impl Iterator<Item = &'o Observations> + Clone,
) {
    let markers = problem.channels.iter().filter(|own| own.is_marker());
    let markers = markers.count().min(MAX_MARKERS);
    if markers < 3 || problem.sigma.is_some() {
        return;
    }
    for marker in unlike(markers, flights).unwrap_or_default() {
        problem.channels[marker].group = group_count(&problem.noise_groups());
    }
}

/// Sentences on the markers whose noise differs from the usual one, with both.
pub fn notes(problem: &FitProblem, noise: &NoiseModel) -> Vec<String> {
    let channels = problem.channels.iter().enumerate();
    let unlike = channels.filter(|(_, own)| own.is_marker() && own.group != 0);
    let each = unlike.map(|(channel, own)| {
        format!(
            "the noise of marker {}, {}, is estimated by itself: that of the other markers is {}",
            own.name,
            quantity(noise.of(channel).overall(), own.unit),
            quantity(noise.overall(), own.unit),
        )
    });
    each.collect()
}

/// Variance of a distance, m², with its standard error.
#[derive(Clone, Copy, Debug)]
struct Variance {
    value: f64,
    std_error: f64,
}

/// Markers whose noise is significantly, and more than [`ROUGHLY_NOISE`] times, above or below the median; `None` if the
/// distances do not determine the noise of each marker.
fn unlike<'o>(
    markers: usize,
    flights: impl Iterator<Item = &'o Observations> + Clone,
) -> Option<Vec<usize>> {
    let mut normal = DMatrix::zeros(markers, markers);
    let (mut sums, mut errors) = (DVector::zeros(markers), vec![0.0; markers]);
    for one in 0..markers {
        for other in one + 1..markers {
            let Some(variance) = distance_variance([one, other], flights.clone()) else {
                continue;
            };
            for (row, column) in [(one, other), (other, one)] {
                normal[(row, row)] += 1.0;
                normal[(row, column)] += 1.0;
                sums[row] += variance.value;
                errors[row] += variance.std_error.powi(2);
            }
        }
    }
    let variances = normal.clone().cholesky()?.solve(&sums);
    let usual = median_of(variances.iter().copied())?.max(LEAST_NOISE.powi(2));
    let limit = ROUGHLY_NOISE.powi(2);
    let is_unlike = |&marker: &usize| {
        let own = variances[marker];
        let std_error = errors[marker].sqrt() / normal[(marker, marker)];
        (own > limit * usual || own * limit < usual)
            && (own - usual).abs() > SIGNIFICANT * std_error
    };
    Some((0..markers).filter(is_unlike).collect())
}

/// Robust variance of the distance of two markers about its median in each flight; `None` if no flight sees both.
fn distance_variance<'o>(
    [one, other]: [usize; 2],
    flights: impl Iterator<Item = &'o Observations>,
) -> Option<Variance> {
    let mut deviations = Vec::new();
    for flight in flights {
        let samples = 0..flight.times.len();
        let lengths: Vec<f64> = samples
            .filter_map(|sample| {
                Some(distance(
                    flight.value(sample, one)?,
                    flight.value(sample, other)?,
                ))
            })
            .collect();
        let Some(middle) = median_of(lengths.iter().copied()) else {
            continue;
        };
        deviations.extend(lengths.iter().map(|length| (length - middle).abs()));
    }
    let count = deviations.len() as f64;
    let value = robust_sigma(&mut deviations).powi(2);
    (count > 0.0).then(|| Variance {
        value,
        std_error: 2.0 * ROBUST_ERROR / count.sqrt() * value,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::tests::jitter;
    use crate::fit::tests::simulated;
    use crate::options::FitOptions;
    use dataset::synthesize::Plan;

    /// Fewer samples may differ as much by chance.
    #[test]
    fn a_noisy_marker_is_unlike_the_others_if_there_are_enough_samples() {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let found = |duration: f64| {
            let plan = Plan {
                flights: 1,
                duration: Some(duration),
                ..Plan::default()
            };
            let mut dataset = simulated(&model, "backhand", &plan);
            for (sample, row) in dataset.flights[0].positions.iter_mut().enumerate() {
                for (axis, coordinate) in row[1].iter_mut().flatten().enumerate() {
                    *coordinate += 0.01 * jitter(3 * sample + axis);
                }
            }
            let problem = FitProblem::new(&model, &dataset, &FitOptions::default()).unwrap();
            let flight = Observations::new(&problem, &dataset.flights[0]).unwrap();
            unlike(dataset.markers.len(), [flight].iter())
        };
        assert_eq!(found(1.5), Some(vec![1]));
        assert_eq!(found(0.13), Some(vec![]));
    }
}
