//! Profile likelihood of one global parameter.

use model_spec::sort_by_number;

use crate::ids::GlobalId;
use crate::least_squares::{Iterate, Solution, SolveError};
use crate::problem::GlobalParameter;
use crate::report::Profile;

/// 95 % quantile of the χ² distribution with 1 degree of freedom.
const CHI2_95: f64 = 3.841_458_820_694_124;

/// Number of values on each side of the estimate at which the profile likelihood is computed, and their spacing in
/// standard errors of the parameter.
const POINTS: (usize, f64) = (6, 0.5);

/// Profile likelihood of a parameter with standard error `error`: it is fixed at several values, and `fit_at` fits all
/// other unknowns from the given iterate. The profile ends before a point that cannot be fitted.
pub fn profile(
    mut fit_at: impl FnMut(f64, Iterate) -> Result<Solution, SolveError>,
    solution: &Solution,
    global: &[GlobalParameter],
    parameter: GlobalId,
    error: f64,
) -> Profile {
    let index = parameter.index();
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
            let Ok(found) = fit_at(value, point) else {
                break;
            };
            points.push([value, (found.squares - solution.squares).max(0.0)]);
            point = found.iterate;
        }
    }
    sort_by_number(&mut points, |point| point[0]);
    let interval = [crossing(&points, best, -1.0), crossing(&points, best, 1.0)];
    Profile {
        name: global[index].name.clone(),
        points,
        interval,
    }
}

/// Value on one side of `best` (`direction` ±1) at which the deviance reaches its 95 % quantile; `None` if it does not.
/// Its square root, which is nearly linear, is interpolated.
fn crossing(points: &[[f64; 2]], best: f64, direction: f64) -> Option<f64> {
    let mut side: Vec<[f64; 2]> = points
        .iter()
        .copied()
        .filter(|[value, _]| (value - best) * direction >= 0.0)
        .collect();
    sort_by_number(&mut side, |point| point[0] * direction);
    side.windows(2).find_map(|pair| {
        let [[from, low], [to, high]] = [pair[0], pair[1]];
        (low < CHI2_95 && high >= CHI2_95).then(|| {
            let part = (CHI2_95.sqrt() - low.sqrt()) / (high.sqrt() - low.sqrt());
            from + part * (to - from)
        })
    })
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
