//! Levenberg–Marquardt over all flights at once.

use nalgebra::DVector;

use crate::normal::{Block, Eliminated, Singular, eliminate};

/// A sum of squares with unknowns shared by all flights and unknowns of each flight.
pub trait Problem {
    /// How many flights there are.
    fn flights(&self) -> usize;

    /// Residuals of a flight and their derivatives, as normal equations.
    ///
    /// # Errors
    /// In words, where the flight cannot be predicted from these values.
    fn linearise(
        &self,
        flight: usize,
        shared: &DVector<f64>,
        own: &DVector<f64>,
    ) -> Result<Block, String>;

    /// Sum of squared residuals of a flight; infinite where it cannot be predicted.
    fn squares(&self, flight: usize, shared: &DVector<f64>, own: &DVector<f64>) -> f64;

    /// Least and greatest value of each shared unknown.
    fn bounds(&self) -> &[(f64, f64)];
}

/// Values of all unknowns.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Shared by all flights.
    pub shared: DVector<f64>,
    /// Each flight's own.
    pub own: Vec<DVector<f64>>,
}

/// Where the iteration ended.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The unknowns.
    pub point: Point,
    /// Normal equations there.
    pub blocks: Vec<Block>,
    /// Steps that were tried.
    pub iterations: usize,
    /// Whether the steps had become negligible.
    pub converged: bool,
}

/// Why there is no solution.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Failure {
    /// A flight cannot be predicted from its starting values.
    #[error("flight {flight} cannot be predicted from its starting values: {reason}")]
    Start {
        /// Index of the flight.
        flight: usize,
        /// In words.
        reason: String,
    },
    /// The unknowns are not determined.
    #[error(transparent)]
    Singular(#[from] Singular),
}

/// Damping at which no step is tried any more.
const MOST_DAMPING: f64 = 1e8;

/// Steps after which the iteration is given up.
const MOST_STEPS: usize = 100;

/// A step that promises a smaller part of the squares than this is negligible: far below their statistical spread,
/// far above the error of the integration.
const NEGLIGIBLE: f64 = 1e-9;

/// Minimises the sum of squares from a starting point.
///
/// # Errors
/// See [`Failure`].
pub fn solve(problem: &impl Problem, start: Point) -> Result<Solution, Failure> {
    let mut point = start;
    let mut blocks = linearise(problem, &point)?;
    let mut damping = 1e-6;
    let mut iterations = 0;
    let mut converged = false;
    while iterations < MOST_STEPS && !converged {
        iterations += 1;
        let before: f64 = blocks.iter().map(|block| block.squares).sum();
        let (candidate, promised) = match eliminate(&blocks, damping) {
            Ok(system) => stepped(problem, &point, &system),
            Err(_) if damping < MOST_DAMPING => {
                damping = (damping * 10.0).max(1e-9);
                continue;
            }
            Err(_) => break,
        };
        if promised <= NEGLIGIBLE * before {
            converged = true;
        } else if squares(problem, &candidate) < before {
            point = candidate;
            blocks = linearise(problem, &point)?;
            damping = (damping * 0.1).max(1e-14);
        } else if damping < MOST_DAMPING {
            damping = (damping * 10.0).max(1e-9);
        } else {
            break;
        }
    }
    // Undamped: what the data do not determine must be told, not damped away.
    eliminate(&blocks, 0.0)?;
    Ok(Solution {
        point,
        blocks,
        iterations,
        converged,
    })
}

fn linearise(problem: &impl Problem, point: &Point) -> Result<Vec<Block>, Failure> {
    (0..problem.flights())
        .map(|flight| {
            let block = problem.linearise(flight, &point.shared, &point.own[flight]);
            block.map_err(|reason| Failure::Start { flight, reason })
        })
        .collect()
}

fn squares(problem: &impl Problem, point: &Point) -> f64 {
    (0..problem.flights())
        .map(|flight| problem.squares(flight, &point.shared, &point.own[flight]))
        .sum()
}

/// The point after a step that is cut at the bounds of the shared unknowns, and the decrease of the squares that
/// the step promises.
fn stepped(problem: &impl Problem, point: &Point, system: &Eliminated<'_>) -> (Point, f64) {
    let (step, _) = system.step();
    let mut shared = &point.shared + step;
    for (value, &(low, high)) in shared.iter_mut().zip(problem.bounds()) {
        *value = value.clamp(low, high);
    }
    let step = &shared - &point.shared;
    let own = system.own_steps(&step);
    let promised = system.promised(&step, &own);
    let own = point
        .own
        .iter()
        .zip(own)
        .map(|(value, step)| value + step)
        .collect();
    (Point { shared, own }, promised)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Flights `y = own * exp(-shared t)`.
    struct Decay {
        data: Vec<Vec<(f64, f64)>>,
        bounds: [(f64, f64); 1],
    }

    impl Problem for Decay {
        fn flights(&self) -> usize {
            self.data.len()
        }

        fn linearise(
            &self,
            flight: usize,
            shared: &DVector<f64>,
            own: &DVector<f64>,
        ) -> Result<Block, String> {
            let mut block = Block::zero(1, 1);
            for &(t, y) in &self.data[flight] {
                let e = (-shared[0] * t).exp();
                let by_shared = DVector::from_element(1, -t * own[0] * e);
                block.add(own[0] * e - y, &DVector::from_element(1, e), &by_shared);
            }
            Ok(block)
        }

        fn squares(&self, flight: usize, shared: &DVector<f64>, own: &DVector<f64>) -> f64 {
            self.linearise(flight, shared, own)
                .map_or(f64::INFINITY, |block| block.squares)
        }

        fn bounds(&self) -> &[(f64, f64)] {
            &self.bounds
        }
    }

    fn decay(bounds: (f64, f64)) -> Decay {
        let flight = |amplitude: f64| {
            (0..20)
                .map(|i| f64::from(i) * 0.1)
                .map(|t| (t, amplitude * (-1.3 * t).exp()))
                .collect()
        };
        Decay {
            data: vec![flight(2.0), flight(-5.0)],
            bounds: [bounds],
        }
    }

    fn start() -> Point {
        Point {
            shared: DVector::from_element(1, 0.0),
            own: vec![DVector::from_element(1, 1.0); 2],
        }
    }

    #[test]
    fn exact_data_give_the_exact_unknowns() {
        let solution = solve(&decay((-10.0, 10.0)), start()).unwrap();
        assert!(solution.converged);
        assert!((solution.point.shared[0] - 1.3).abs() < 1e-8);
        assert!((solution.point.own[1][0] + 5.0).abs() < 1e-8);
    }

    #[test]
    fn bounds_hold() {
        let solution = solve(&decay((-10.0, 1.0)), start()).unwrap();
        assert_eq!(solution.point.shared[0], 1.0);
    }
}
