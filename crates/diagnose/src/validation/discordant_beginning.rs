//! Held-out flights whose conditioning segment, the first 30 % of the samples, contradicts an extension.

use dataset::Role;
use identify::{CONDITIONING_FRACTION, Fit};

/// Maximum increase of the weighted sum of squares, χ², of the first 30 % of a flight's samples (its conditioning
/// segment) by the effects added to a model. If the increase is larger, the flight contradicts these effects.
const MAX_CHI2_INCREASE: f64 = 10.0;

/// Rule that selects the held-out flights that are predicted with the extension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ApplyTo {
    /// All held-out flights are predicted with the extension.
    AllFlights,
    /// The extension (added effects) is applied to those held-out flights whose conditioning segment, the first 30 % of
    /// the samples, does not contradict it.
    ConcordantFlights,
}

impl ApplyTo {
    /// Dataset indices of the held-out flights to which the extension is not applied. `before` and `after` are the
    /// fits without and with the extension.
    pub fn exceptions(self, before: &Fit, after: &Fit) -> Vec<usize> {
        match self {
            ApplyTo::AllFlights => Vec::new(),
            ApplyTo::ConcordantFlights => contradicted(before, after),
        }
    }
}

/// Sum of squared residuals along each axis, m², and number of measured marker positions, in the conditioning segment
/// of a flight: the first 30 % of the samples, to which the initial state is fitted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct SegmentSquares {
    squares: [f64; 3],
    points: usize,
}

impl SegmentSquares {
    fn new(fit: &Fit, flight: usize) -> Option<Self> {
        let evidence = fit.evidence(identify::FlightId::new(flight))?;
        let samples = (evidence.times.len() as f64 * CONDITIONING_FRACTION).ceil() as usize;
        let mut segment = Self::default();
        for sample in 0..samples.min(evidence.times.len()) {
            for marker in 0..evidence.markers.len() {
                if let Some(residual) = evidence.residual(sample, marker) {
                    segment.points += 1;
                    for (sum, r) in segment.squares.iter_mut().zip(residual) {
                        *sum += r * r;
                    }
                }
            }
        }
        Some(segment)
    }

    fn total(&self) -> f64 {
        self.squares.iter().sum()
    }

    fn add(&mut self, other: &Self) {
        self.points += other.points;
        for (sum, square) in self.squares.iter_mut().zip(other.squares) {
            *sum += square;
        }
    }
}

fn contradicted(before: &Fit, after: &Fit) -> Vec<usize> {
    let flights = before.report.flights.iter().enumerate();
    let held_out = flights.filter(|(_, flight)| flight.role == Role::HeldOut);
    let segments = held_out.filter_map(|(flight, _)| {
        let before = SegmentSquares::new(before, flight)?;
        Some((flight, before, SegmentSquares::new(after, flight)?))
    });
    worse(&segments.collect::<Vec<_>>())
}

/// Dataset indices of the flights that contradict the added effects: their weighted sum of squares in the conditioning
/// segment (first 30 % of the samples) is increased by more than [`MAX_CHI2_INCREASE`]. Each tuple contains a flight's
/// index and its sums of squares without and with these effects. The noise variance of each axis is estimated over all
/// flights, from the smaller of the two sums of each flight.
fn worse(segments: &[(usize, SegmentSquares, SegmentSquares)]) -> Vec<usize> {
    let mut noise = SegmentSquares::default();
    for (_, before, after) in segments {
        noise.add(if after.total() < before.total() {
            after
        } else {
            before
        });
    }
    let increase = |before: &SegmentSquares, after: &SegmentSquares| -> f64 {
        let variance = |axis: usize| noise.squares[axis] / noise.points.max(1) as f64;
        let along = |axis: usize| (after.squares[axis] - before.squares[axis]) / variance(axis);
        (0..3).map(along).sum()
    };
    let each = segments.iter();
    each.filter(|(_, before, after)| increase(before, after) > MAX_CHI2_INCREASE)
        .map(|(flight, ..)| *flight)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_significant_increase_contradicts() {
        let squares = |value: f64| SegmentSquares {
            squares: [value; 3],
            points: 100,
        };
        // Noise of variance 1: the sum of squares of 100 points is about 100 along each axis.
        let segments = [
            (3, squares(400.0), squares(100.0)),
            (5, squares(100.0), squares(102.0)),
            (8, squares(100.0), squares(105.0)),
        ];
        assert_eq!(worse(&segments), [8]);
        assert!(worse(&[]).is_empty());
    }
}
