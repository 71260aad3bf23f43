//! Comparison of the residuals with the noise that the rigidity of the body shows: the scatter of the distances between
//! its markers, which needs neither a model of the motion nor smoothness.

use super::state::State;
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::problem::FitProblem;
use dataset::statistics::median;
use nalgebra::Vector3;

/// Ratio of the standard deviation of the residuals to that of the noise by rigidity, above which the residuals are not
/// noise. What moves all markers together, the model's error above all, leaves their distances alone.
const MAX_RATIO: f64 = 1.3;
/// Number of standard errors of the ratio by which it must exceed 1.
const MIN_ERRORS: f64 = 5.0;
/// Standard error of a standard deviation by the median absolute deviation, relative, times the root of the number of
/// values.
const MAD_ERROR: f64 = 1.17;
/// Median absolute deviation of a normal variable, in standard deviations.
const MAD: f64 = 0.6745;
/// Minimum number of distances of a pair of markers in a flight.
const MIN_DISTANCES: usize = 10;
/// Maximum number of markers whose distances are compared.
const MAX_MARKERS: usize = 6;

/// Channels of the markers whose distances are compared.
pub fn markers(problem: &FitProblem) -> Vec<usize> {
    let channels = problem.channels.iter().enumerate();
    let markers = channels.filter(|(_, channel)| channel.is_marker());
    markers.map(|(index, _)| index).take(MAX_MARKERS).collect()
}

/// Vector from one marker to another in each sample, m; `None` where one of them is not seen.
pub fn apart(
    flight: &Observations,
    one: usize,
    other: usize,
) -> impl Iterator<Item = Option<Vector3<f64>>> {
    (0..flight.times.len()).map(move |sample| {
        let one = Vector3::from(flight.inlier(sample, one)?);
        Some(Vector3::from(flight.inlier(sample, other)?) - one)
    })
}

/// Sentence that the residuals exceed the noise by rigidity; `None` if they do not, or the flights do not tell.
pub fn excess(state: &State<'_>, noise: &NoiseModel) -> Option<String> {
    let markers = markers(state.problem);
    // Squared scatter of each pair's distances, and what the residuals let expect.
    let (mut found, mut expected, mut count) = (Vec::new(), Vec::new(), 0);
    for flight in &state.flights {
        for (place, &one) in markers.iter().enumerate() {
            for &other in &markers[place + 1..] {
                let apart: Vec<Vector3<f64>> = apart(flight, one, other).flatten().collect();
                if apart.len() < MIN_DISTANCES {
                    continue;
                }
                let variances = |channel: usize| noise.of(channel).sigma.map(|s| s * s);
                let both = Vector3::from(variances(one)) + Vector3::from(variances(other));
                let along = apart
                    .iter()
                    .map(|a| a.component_mul(a).dot(&both) / a.norm_squared());
                expected.push(along.sum::<f64>() / apart.len() as f64);
                let mut lengths: Vec<f64> = apart.iter().map(Vector3::norm).collect();
                let middle = median(&mut lengths);
                lengths
                    .iter_mut()
                    .for_each(|length| *length = (*length - middle).abs());
                found.push((median(&mut lengths) / MAD).powi(2));
                count += lengths.len();
            }
        }
    }
    if found.is_empty() {
        return None;
    }
    let [found, expected] = [found, expected].map(|mut all| median(&mut all));
    let ratio = (expected / found).sqrt();
    let by_chance = 1.0 + MIN_ERRORS * MAD_ERROR / (count as f64).sqrt();
    (ratio.is_finite() && ratio > MAX_RATIO.max(by_chance)).then(|| {
        format!(
            "the residuals are {ratio:.2} times the noise that the distances between the markers show: the model does not move all markers as they moved"
        )
    })
}
