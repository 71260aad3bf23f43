//! Distances between the markers of a rigid body, which are constant. If a measured distance differs from the predicted
//! one, a marker is not at the position that the dataset or the model gives.

use super::residual_cache::ResidualCache;
use crate::observations::Observations;
use crate::problem::FitProblem;
use crate::report::MarkerDistance;

/// Minimum difference between the mean measured and the mean predicted distance of two markers, in standard errors, for
/// it to be significant.
const MIN_SIGNIFICANCE: f64 = 5.0;

/// Difference between the mean measured and predicted distance of two markers, in units of the noise standard deviation
/// of a coordinate, above which a significant difference is reported.
const MIN_NOISE_RATIO: f64 = 1.0;

/// Statistics of the differences (measured − predicted) of the distance between two markers in the samples of one
/// flight: their number, their sum, m, and the sum of their squares, m².
#[derive(Clone, Copy, Debug, Default)]
struct Sum {
    count: f64,
    sum: f64,
    squares: f64,
}

impl Sum {
    fn add(&mut self, difference: f64) {
        self.count += 1.0;
        self.sum += difference;
        self.squares += difference * difference;
    }
}

/// Finds pairs of markers whose mean measured distance differs significantly from the predicted one, by more than
/// `noise`, the standard deviation of a coordinate, m. Returns an empty vector for a point mass.
pub fn wrong_distances(
    problem: &FitProblem,
    flights: &[Observations],
    cache: &ResidualCache,
    marker_names: &[String],
    noise: f64,
) -> Vec<MarkerDistance> {
    if !problem.has_attitude {
        return Vec::new();
    }
    let markers = marker_names.len();
    let pairs = (0..markers).flat_map(|one| (one + 1..markers).map(move |other| (one, other)));
    let each = pairs.filter_map(|(one, other)| {
        let sums = flights
            .iter()
            .enumerate()
            .filter_map(|(flight, observations)| {
                let path = cache.path(flights, flight).ok()?;
                let predicted_less_measured = [&path.residuals[one], &path.residuals[other]];
                Some(differences(
                    observations,
                    predicted_less_measured,
                    [one, other],
                    noise,
                ))
            });
        let (difference, std_error) = mean(&sums.collect::<Vec<_>>())?;
        let is_wrong = difference.abs() > MIN_SIGNIFICANCE * std_error
            && difference.abs() > MIN_NOISE_RATIO * noise;
        is_wrong.then(|| MarkerDistance {
            markers: [one, other].map(|marker| marker_names[marker].clone()),
            difference_m: difference,
            std_error_m: std_error,
        })
    });
    each.collect()
}

/// Sums over the samples of one flight of the differences (measured − predicted) of the distance between two markers,
/// m. `residuals` contains the residuals of the two markers by sample, predicted − measured, m. The mean increase of a
/// measured distance by noise is subtracted; `noise` is the standard deviation of a coordinate, m.
fn differences(
    observations: &Observations,
    residuals: [&Vec<Option<[f64; 3]>>; 2],
    markers: [usize; 2],
    noise: f64,
) -> Sum {
    let mut sum = Sum::default();
    for sample in 0..observations.times.len() {
        let measured = markers.map(|marker| observations.inlier(sample, marker));
        let residual = residuals.map(|series| series.get(sample).copied().flatten());
        if let ([Some(a), Some(b)], [Some(ra), Some(rb)]) = (measured, residual) {
            let apart = [0, 1, 2].map(|axis| b[axis] - a[axis]);
            let predicted = [0, 1, 2].map(|axis| apart[axis] + rb[axis] - ra[axis]);
            let norm = |v: [f64; 3]| v.map(|x| x * x).iter().sum::<f64>().sqrt();
            let (apart, predicted) = (norm(apart), norm(predicted));
            // Noise perpendicular to the line between two points increases their distance.
            let by_noise = 2.0 * noise * noise / predicted;
            if by_noise.is_finite() {
                sum.add(apart - predicted - by_noise);
            }
        }
    }
    sum
}

/// Mean over all flights of the differences (measured − predicted) of a marker distance, m, and its standard error: the
/// greater one of the standard errors for independent samples and for independent flights. `None` for fewer than two
/// samples.
fn mean(flights: &[Sum]) -> Option<(f64, f64)> {
    let total = |of: fn(&Sum) -> f64| flights.iter().map(of).sum::<f64>();
    let count = total(|sum| sum.count);
    if count < 2.0 {
        return None;
    }
    let mean = total(|sum| sum.sum) / count;
    let of_samples = (total(|sum| sum.squares) / count - mean * mean) / (count - 1.0);
    let number = flights.iter().filter(|sum| sum.count > 0.0).count() as f64;
    let scatter = flights
        .iter()
        .map(|flight| (flight.sum - flight.count * mean).powi(2));
    let of_flights = match number > 1.0 {
        true => scatter.sum::<f64>() / (count * count) * number / (number - 1.0),
        false => 0.0,
    };
    Some((mean, of_samples.max(of_flights).max(0.0).sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_standard_error_is_that_of_flights_where_they_differ() {
        let flight = |values: &[f64]| {
            let mut sum = Sum::default();
            values.iter().for_each(|value| sum.add(*value));
            sum
        };
        let (alike, of_samples) = mean(&[flight(&[1.0, 3.0]), flight(&[1.0, 3.0])]).unwrap();
        assert_eq!(alike, 2.0);
        assert!((of_samples - (1.0_f64 / 3.0).sqrt()).abs() < 1e-12);
        let (unlike, of_flights) = mean(&[flight(&[1.0, 1.0]), flight(&[3.0, 3.0])]).unwrap();
        assert_eq!(unlike, 2.0);
        assert!((of_flights - 1.0).abs() < 1e-12);
        assert!(mean(&[flight(&[1.0])]).is_none());
    }
}
