//! How the likelihood falls off as one coefficient is held and all else is fitted again.

use nalgebra::DVector;

use crate::least_squares::NormalBlock;
use crate::least_squares::{
    Constraint, LeastSquaresProblem, Solution, SolveError, StoppingCriteria, solve,
};
use crate::problem::GlobalParameter;
use crate::report::Profile;

/// Deviance at the ends of the interval of 95 %.
const LIMIT: f64 = 3.841_458_820_694_124;

/// Points on either side of the estimate, and how far apart they are, over the standard error.
const POINTS: (usize, f64) = (6, 0.5);

/// Profiles one shared unknown around a solution.
///
/// # Errors
/// [`SolveError::Stopped`]; a point that cannot be fitted is left out.
pub fn profile(
    problem: &impl LeastSquaresProblem,
    solution: &Solution,
    global: &[GlobalParameter],
    index: usize,
    error: f64,
) -> Result<Profile, SolveError> {
    let best = solution.iterate.global[index];
    let (low, high) = global[index].constraint.bounds;
    let mut points = vec![[best, 0.0]];
    for direction in [-1.0, 1.0] {
        let mut point = solution.iterate.clone();
        for k in 1..=POINTS.0 {
            let value = best + direction * k as f64 * POINTS.1 * error;
            if !(low..=high).contains(&value) {
                break;
            }
            point.global[index] = value;
            let mut constraints = problem.constraints().to_vec();
            constraints[index].bounds = (value, value);
            let held = Constrained {
                problem,
                constraints,
            };
            match solve(&held, point.clone(), StoppingCriteria::CONVERGED) {
                Ok(found) => {
                    points.push([value, (found.squares - solution.squares).max(0.0)]);
                    point = found.iterate;
                }
                Err(SolveError::Stopped) => return Err(SolveError::Stopped),
                Err(_) => break,
            }
        }
    }
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let interval = [crossing(&points, best, -1.0), crossing(&points, best, 1.0)];
    Ok(Profile {
        name: global[index].name.clone(),
        points,
        interval,
    })
}

/// Where the deviance reaches its limit on one side, by the root of it, which is nearly straight.
fn crossing(points: &[[f64; 2]], best: f64, direction: f64) -> Option<f64> {
    let mut side: Vec<[f64; 2]> = points
        .iter()
        .copied()
        .filter(|[value, _]| (value - best) * direction >= 0.0)
        .collect();
    side.sort_by(|a, b| (a[0] * direction).total_cmp(&(b[0] * direction)));
    side.windows(2).find_map(|pair| {
        let [[from, low], [to, high]] = [pair[0], pair[1]];
        (low < LIMIT && high >= LIMIT).then(|| {
            let part = (LIMIT.sqrt() - low.sqrt()) / (high.sqrt() - low.sqrt());
            from + part * (to - from)
        })
    })
}

/// The problem with other things known.
struct Constrained<'a, P> {
    problem: &'a P,
    constraints: Vec<Constraint>,
}

impl<P: LeastSquaresProblem> LeastSquaresProblem for Constrained<'_, P> {
    fn flights(&self) -> usize {
        self.problem.flights()
    }
    fn linearise(
        &self,
        flight: usize,
        global: &DVector<f64>,
        local: &DVector<f64>,
    ) -> Result<NormalBlock, String> {
        self.problem.linearise(flight, global, local)
    }
    fn plus(&self, flight: usize, local: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        self.problem.plus(flight, local, step)
    }
    fn constraints(&self) -> &[Constraint] {
        &self.constraints
    }
    fn threads(&self) -> usize {
        self.problem.threads()
    }
    fn is_stopped(&self) -> bool {
        self.problem.is_stopped()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_crosses_at_1_96_standard_errors() {
        let points: Vec<[f64; 2]> = (-6..=6)
            .map(|k| f64::from(k) * 0.5)
            .map(|x| [x, x * x])
            .collect();
        assert!((crossing(&points, 0.0, 1.0).unwrap() - 1.959_964).abs() < 1e-6);
        assert!((crossing(&points, 0.0, -1.0).unwrap() + 1.959_964).abs() < 1e-6);
        assert_eq!(crossing(&points[4..9], 0.0, 1.0), None);
    }
}
