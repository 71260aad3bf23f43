//! Where a fit starts: position and velocity at the first sample, from the samples alone.

use nalgebra::{DMatrix, DVector};

use crate::dataset::Flight;

/// Samples that the start is taken from: enough to average the noise, few enough for a parabola.
const SAMPLES: usize = 16;

/// Position (m) and velocity (m/s) of a single tracked point at the flight's first time.
///
/// # Errors
/// In words, where fewer than four samples were seen.
pub fn of_point(flight: &Flight) -> Result<([f64; 3], [f64; 3]), String> {
    let origin = flight.times[0];
    let seen = flight.times.iter().zip(&flight.positions);
    let seen = seen.filter_map(|(&time, row)| {
        row.first()
            .copied()
            .flatten()
            .map(|position| (time - origin, position))
    });
    let samples: Vec<(f64, [f64; 3])> = seen.take(SAMPLES).collect();
    if samples.len() < 4 {
        return Err(format!(
            "only {} samples were seen, and a start needs 4",
            samples.len()
        ));
    }
    let design = DMatrix::from_fn(samples.len(), 3, |row, power| {
        samples[row].0.powi(power as i32)
    });
    let factor = design.svd(true, true);
    let (mut position, mut velocity) = ([0.0; 3], [0.0; 3]);
    for axis in 0..3 {
        let heights = DVector::from_fn(samples.len(), |row, _| samples[row].1[axis]);
        let parabola = factor.solve(&heights, 1e-12).map_err(str::to_owned)?;
        position[axis] = parabola[0];
        velocity[axis] = parabola[1];
    }
    Ok((position, velocity))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::Role;

    fn flight(times: &[f64]) -> Flight {
        let point = |&t: &f64| vec![Some([1.0 + 2.0 * t, -t, 3.0 * t - 4.9 * t * t])];
        Flight {
            file: "made.csv".into(),
            role: Role::Fit,
            known: Default::default(),
            times: times.iter().map(|t| t + 5.0).collect(),
            positions: times.iter().map(point).collect(),
        }
    }

    #[test]
    fn a_parabola_is_found_again() {
        let mut flight = flight(&[0.0, 0.1, 0.25, 0.3, 0.4]);
        flight.positions[1] = vec![None];
        let (position, velocity) = of_point(&flight).unwrap();
        for (found, expected) in position
            .iter()
            .chain(&velocity)
            .zip([1.0, 0.0, 0.0, 2.0, -1.0, 3.0])
        {
            assert!(
                (found - expected).abs() < 1e-10,
                "{position:?} {velocity:?}"
            );
        }
    }

    #[test]
    fn three_samples_are_too_few() {
        assert!(of_point(&flight(&[0.0, 0.1, 0.2])).is_err());
    }
}
