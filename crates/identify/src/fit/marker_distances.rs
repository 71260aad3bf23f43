//! Distances between the markers of a rigid body, which do not depend on its motion. If a mean distance differs from the
//! predicted one, a marker is not at its stated position. Their scatter shows the noise without a model of the motion.

use nalgebra::Vector3;

use super::residual_cache::ResidualCache;
use super::state::State;
use crate::observations::Observations;
use crate::problem::FitProblem;
use crate::report::MarkerDistance;
use dataset::levels::{LEAST_NOISE, NEAR_NOISE, ROBUST_ERROR, SIGNIFICANT};
use dataset::statistics::median;

/// Number of samples over which differences are summed: the noise of different sums is independent.
const SPAN: usize = 12;

/// Difference of a distance that counts, as a fraction of the noise of a coordinate: positions of markers are rounded.
const MIN_DIFFERENCE: f64 = 0.1;

/// Number and sum, m, of differences (measured − predicted) of a distance.
#[derive(Clone, Copy, Debug, Default)]
struct Sum {
    count: f64,
    sum: f64,
}

impl std::iter::Sum for Sum {
    fn sum<I: Iterator<Item = Self>>(sums: I) -> Self {
        sums.fold(Self::default(), |a, b| Self {
            count: a.count + b.count,
            sum: a.sum + b.sum,
        })
    }
}

/// Pairs of markers whose mean distance differs significantly and by more than a part of `noise`, that of a coordinate,
/// m; empty for a point mass.
pub fn wrong_distances(
    problem: &FitProblem,
    flights: &[Observations],
    cache: &ResidualCache,
    marker_names: &[String],
    noise: f64,
) -> Vec<MarkerDistance> {
    if !problem.points.has_attitude {
        return Vec::new();
    }
    let markers = marker_names.len();
    let pairs = (0..markers).flat_map(|one| (one + 1..markers).map(move |other| [one, other]));
    let each = pairs.filter_map(|pair| {
        let sums = flights.iter().enumerate().filter_map(|(place, flight)| {
            let path = cache.path(flights, place).ok()?;
            let residuals = pair.map(|marker| &path.residuals[marker][..]);
            Some(differences(flight, residuals, pair, noise))
        });
        let (difference, std_error) = mean(&sums.collect::<Vec<_>>(), noise)?;
        let is_wrong = difference.abs() > (SIGNIFICANT * std_error).max(MIN_DIFFERENCE * noise);
        is_wrong.then(|| MarkerDistance {
            markers: pair.map(|marker| marker_names[marker].clone()),
            difference_m: difference,
            std_error_m: std_error,
        })
    });
    each.collect()
}

/// Sums over the spans of one flight of the differences (measured − predicted) of a distance, m, less the mean increase
/// of a distance by noise. `residuals` are those of the two markers by sample, predicted − measured, m.
fn differences(
    observations: &Observations,
    residuals: [&[Option<[f64; 3]>]; 2],
    [one, other]: [usize; 2],
    noise: f64,
) -> Vec<Sum> {
    let mut spans = vec![Sum::default(); observations.times.len().div_ceil(SPAN)];
    for (sample, apart) in apart(observations, one, other).enumerate() {
        let residual = residuals.map(|series| series.get(sample).copied().flatten());
        if let (Some(apart), [Some(of_one), Some(of_other)]) = (apart, residual) {
            let moved = Vector3::from(of_other) - Vector3::from(of_one);
            let predicted = (apart + moved).norm();
            // Noise perpendicular to the line between two points increases their distance.
            let by_noise = 2.0 * noise * noise / predicted;
            if by_noise.is_finite() {
                spans[sample / SPAN].count += 1.0;
                spans[sample / SPAN].sum += apart.norm() - predicted - by_noise;
            }
        }
    }
    spans
}

/// Mean difference over all flights, m, and its standard error: the greatest one of those for independent spans,
/// independent flights, and white noise of size `noise`. `None` for fewer than two spans.
fn mean(flights: &[Vec<Sum>], noise: f64) -> Option<(f64, f64)> {
    let spans: Vec<Sum> = flights.iter().flatten().copied().collect();
    let flights: Vec<Sum> = flights.iter().map(|f| f.iter().copied().sum()).collect();
    let total: Sum = flights.iter().copied().sum();
    let mean = total.sum / total.count;
    let variance = |sums: &[Sum]| {
        let number = sums.iter().filter(|sum| sum.count > 0.0).count() as f64;
        let scatter = sums.iter().map(|own| (own.sum - own.count * mean).powi(2));
        (number > 1.0).then(|| scatter.sum::<f64>() / total.count.powi(2) * number / (number - 1.0))
    };
    let of_flights = variance(&flights).unwrap_or(0.0);
    let of_noise = 2.0 * noise * noise / total.count;
    Some((mean, variance(&spans)?.max(of_flights).max(of_noise).sqrt()))
}

const MIN_DISTANCES: usize = 10;
const MAX_MARKERS: usize = 6;

/// Vectors between the markers of each pair in each flight, by sample; the flight is told by its place.
pub(super) fn all_apart(
    state: &State<'_>,
) -> impl Iterator<Item = (usize, [usize; 2], Vec<Option<Vector3<f64>>>)> {
    let markers = marker_count(state.problem);
    let flights = state.flights.iter().enumerate();
    flights.flat_map(move |(place, flight)| {
        let pairs = (0..markers).flat_map(move |one| (one + 1..markers).map(move |b| [one, b]));
        pairs.map(move |[one, other]| (place, [one, other], apart(flight, one, other).collect()))
    })
}

pub(super) fn marker_count(problem: &FitProblem) -> usize {
    let markers = problem.channels.iter().filter(|own| own.is_marker());
    markers.count().min(MAX_MARKERS)
}

/// Vector from one marker to another in each sample, m; `None` where one of them is not seen.
fn apart(
    flight: &Observations,
    one: usize,
    other: usize,
) -> impl Iterator<Item = Option<Vector3<f64>>> {
    (0..flight.times.len()).map(move |sample| {
        let one = Vector3::from(flight.inlier(sample, one)?);
        Some(Vector3::from(flight.inlier(sample, other)?) - one)
    })
}

/// Sentence that the residuals exceed the noise that the scatter of the distances shows; `None` if they do not, or the
/// flights do not tell. What moves all markers together, the model's error above all, leaves their distances alone. Each
/// pair of markers in each flight is compared with itself, as noise differs between them.
pub fn excess(state: &State<'_>, cache: &ResidualCache) -> Option<String> {
    let (mut ratios, mut count) = (Vec::new(), 0);
    for (place, pair, apart) in all_apart(state) {
        let Ok(path) = cache.path(&state.flights, place) else {
            continue;
        };
        // The distance, and the residuals of both markers along the line between them.
        let (mut lengths, mut along) = (Vec::new(), [Vec::new(), Vec::new()]);
        for (sample, apart) in apart.iter().enumerate() {
            let residual = pair.map(|marker| path.residual(sample, marker));
            if let (Some(apart), [Some(one), Some(other)]) = (apart, residual) {
                let line = apart.normalize();
                lengths.push(apart.norm());
                along[0].push(line.dot(&Vector3::from(one)));
                along[1].push(line.dot(&Vector3::from(other)));
            }
        }
        if lengths.len() < MIN_DISTANCES {
            continue;
        }
        count += lengths.len();
        let mean = lengths.iter().sum::<f64>() / lengths.len() as f64;
        lengths.iter_mut().for_each(|length| *length -= mean);
        // Mean squares add up whatever the distribution of the noise is.
        let mean_square = |own: &[f64]| own.iter().map(|v| v * v).sum::<f64>() / own.len() as f64;
        let expected: f64 = along.iter().map(|own| mean_square(own)).sum();
        // Of the difference of two coordinates.
        let least = 2.0 * LEAST_NOISE * LEAST_NOISE;
        ratios.push(expected / mean_square(&lengths).max(least));
    }
    if ratios.is_empty() {
        return None;
    }
    let ratio = median(&mut ratios).sqrt();
    let by_chance = 1.0 + SIGNIFICANT * ROBUST_ERROR / (count as f64).sqrt();
    (ratio.is_finite() && ratio > NEAR_NOISE.max(by_chance)).then(|| {
        format!(
            "the residuals are {ratio:.2} times the noise that the distances between the markers show: the model does not move all markers as they moved"
        )
    })
}

#[cfg(test)]
mod tests {
    use std::iter::zip;

    use super::*;
    use crate::fit::fit;
    use crate::fit::tests::simulated;
    use crate::options::FitOptions;
    use dataset::synthesize::{Corruption, Plan};

    #[test]
    fn the_standard_error_is_that_of_flights_where_they_differ() {
        let flight = |values: &[f64]| -> Vec<Sum> {
            let each = values.iter().map(|&sum| Sum { count: 1.0, sum });
            each.collect()
        };
        let (alike, of_spans) = mean(&[flight(&[1.0, 3.0]), flight(&[1.0, 3.0])], 0.1).unwrap();
        assert_eq!(alike, 2.0);
        assert!((of_spans - (1.0_f64 / 3.0).sqrt()).abs() < 1e-12);
        let (unlike, of_flights) = mean(&[flight(&[1.0, 1.0]), flight(&[3.0, 3.0])], 0.1).unwrap();
        assert_eq!(unlike, 2.0);
        assert!((of_flights - 1.0).abs() < 1e-12);
        let (_, of_noise) = mean(&[flight(&[1.0, 1.0])], 3.0).unwrap();
        assert_eq!(of_noise, 3.0);
        assert!(mean(&[flight(&[1.0])], 0.1).is_none());
    }

    #[test]
    fn flights_without_noise_are_not_held_against_it() {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let plan = Plan {
            flights: 4,
            duration: Some(0.8),
            noise: Corruption {
                sigma: 0.0,
                ..Corruption::default()
            },
            ..Plan::default()
        };
        let mut dataset = simulated(&model, "backhand", &plan);
        // As of another integration, written with six decimals.
        for flight in &mut dataset.flights {
            for (time, row) in flight.times.iter().zip(&mut flight.positions) {
                let error = 5e-6 * (40.0 * time).sin();
                for point in row.iter_mut().flatten() {
                    *point = point.map(|own| ((own + error) * 1e6).round() / 1e6);
                }
            }
        }
        let fitted = fit(&model, &dataset, &FitOptions::default()).unwrap();
        assert_eq!(fitted.report.cautions, Vec::<String>::new());
    }

    #[test]
    fn noise_that_differs_from_flight_to_flight_is_no_fault_and_a_wrong_motion_is() {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let plan = Plan {
            flights: 6,
            duration: Some(0.8),
            ..Plan::default()
        };
        let exact = Plan {
            noise: Corruption {
                sigma: 0.0,
                ..Corruption::default()
            },
            ..plan.clone()
        };
        // The noise of each flight is 0.3 to 5 times that of the plan.
        let (mut dataset, exact) = (
            simulated(&model, "backhand", &plan),
            simulated(&model, "backhand", &exact),
        );
        for (index, (flight, exact)) in zip(&mut dataset.flights, &exact.flights).enumerate() {
            let size = [0.3, 0.6, 1.2, 2.5, 5.0, 0.6][index];
            let points = zip(flight.positions.iter_mut(), &exact.positions);
            for (point, exact) in points.flat_map(|(row, exact)| zip(row, exact)) {
                let (Some(point), Some(exact)) = (point, exact) else {
                    continue;
                };
                for (own, exact) in zip(point, exact) {
                    *own = exact + size * (*own - exact);
                }
            }
        }
        let told = |dataset: &dataset::Dataset| {
            let fitted = fit(&model, dataset, &FitOptions::default()).unwrap();
            fitted.report.excess.is_some()
        };
        assert!(!told(&dataset));
        for flight in &mut dataset.flights {
            for (time, row) in zip(&flight.times, &mut flight.positions) {
                let shaken = 0.01 * (60.0 * time).sin();
                row.iter_mut()
                    .flatten()
                    .for_each(|point| point[0] += shaken);
            }
        }
        assert!(told(&dataset));
    }
}
