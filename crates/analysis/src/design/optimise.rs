//! Smooth optimization problems of a few variables in the unit box, with equality and inequality constraints.
//! Gauss–Newton steps lead to the constraints; then steps along them, by a damped BFGS matrix of the Lagrangian, are
//! each followed by a return to the constraints. Both use a trust region in the maximum norm (Nocedal and Wright,
//! "Numerical Optimization", chapters 4, 10 and 18). The iterates satisfy the constraints, which suits flights: a
//! step along a curved set of throws that land at one point may be long.

use flight::moore_penrose;
use nalgebra::{DMatrix, DVector};

use crate::design::box_quadratic::minimum;

/// Objective and constraints of an optimization problem at a point, with derivatives with respect to the variables.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// Objective, to be minimized.
    pub objective: f64,
    /// Equality constraints, to be 0; 1 is a large violation.
    pub equalities: DVector<f64>,
    /// Inequality constraints, to be nonnegative; −1 is a large violation.
    pub margins: DVector<f64>,
    /// Gradient of the objective.
    pub gradient: DVector<f64>,
    /// Jacobian of the equality constraints: a row per constraint.
    pub equalities_by: DMatrix<f64>,
    /// Jacobian of the inequality constraints: a row per constraint.
    pub margins_by: DMatrix<f64>,
}

impl Values {
    /// Root sum square of the violations of all constraints.
    pub fn violation(&self) -> f64 {
        let short = self.margins.iter().map(|margin| margin.min(0.0).powi(2));
        (self.equalities.norm_squared() + short.sum::<f64>()).sqrt()
    }

    /// The problem to minimize [`Values::violation`] without constraints, at the same point.
    pub fn violation_alone(&self) -> Values {
        let n = self.gradient.len();
        let violation = self.violation();
        let mut slope = self.equalities_by.tr_mul(&self.equalities);
        for (row, margin) in self.margins.iter().enumerate() {
            slope += self.margins_by.row(row).transpose() * margin.min(0.0);
        }
        Values {
            objective: violation,
            gradient: slope / violation.max(1e-300),
            equalities: DVector::zeros(0),
            margins: DVector::zeros(0),
            equalities_by: DMatrix::zeros(0, n),
            margins_by: DMatrix::zeros(0, n),
        }
    }

    fn is_finite(&self) -> bool {
        let equalities = self.equalities.iter().chain(&self.equalities_by);
        let margins = self.margins.iter().chain(&self.margins_by);
        let mut all = equalities.chain(margins).chain(&self.gradient);
        self.objective.is_finite() && all.all(|v| v.is_finite())
    }
}

/// An optimization problem: objective and constraints at a point of the unit box, or `None` if they cannot be computed
/// there. The objective is not needed if the second argument is `false`.
pub type Problem<'p> = &'p dyn Fn(&DVector<f64>, bool) -> Option<Values>;

/// Point reached by an optimization.
#[derive(Clone, Debug)]
pub struct Arrival {
    /// The point in the unit box.
    pub at: DVector<f64>,
    /// Objective and constraints there.
    pub values: Values,
}

/// Initial radius of the trust region, for variables scaled to [0, 1].
const TRUST: f64 = 0.15;
/// Radius of the trust region below which an optimization ends.
const MIN_TRUST: f64 = 1e-6;
/// Maximum numbers of evaluations: of the first way to the constraints, and of the return to them after each step.
const MAX_EVALUATIONS: (usize, usize) = (40, 5);
const MAX_STEPS: usize = 25;
/// Predicted decrease of the objective, relative to 1 plus its magnitude, below which a minimization ends.
const SETTLED: f64 = 1e-6;
/// Constraint violation up to which a point satisfies the constraints, and margin below which a constraint is active.
const ON: f64 = 1e-4;
/// Singular value, relative to the greatest, up to which constraints count as the same.
const RANK_TOLERANCE: f64 = 1e-9;
/// Weight of the linearized constraints relative to the curvature of the Lagrangian in the quadratic model.
const STIFF: f64 = 1e6;

/// Minimizes the violation of the constraints by Gauss–Newton steps in a trust region; `None` if not finite at first.
pub fn meet(problem: Problem<'_>, from: &DVector<f64>) -> Option<Arrival> {
    let at = from.map(|v| v.clamp(0.0, 1.0));
    let values = problem(&at, false).filter(Values::is_finite)?;
    let start = Arrival { at, values };
    Some(meet_from(problem, start, MAX_EVALUATIONS.0))
}

fn meet_from(problem: Problem<'_>, start: Arrival, most: usize) -> Arrival {
    let Arrival { mut at, mut values } = start;
    let mut trust = TRUST;
    for _ in 0..most {
        let (hessian, slope) = gauss_newton(&values);
        let (low, high) = room(&at, trust);
        let step = minimum(&hessian, &slope, &low, &high);
        let predicted = -(slope.dot(&step) + 0.5 * (&hessian * &step).dot(&step));
        if predicted <= 1e-16 || trust < MIN_TRUST {
            break;
        }
        let there = (&at + &step).map(|v| v.clamp(0.0, 1.0));
        let Some(new) = problem(&there, false).filter(Values::is_finite) else {
            trust *= 0.25;
            continue;
        };
        let gained = 0.5 * (values.violation().powi(2) - new.violation().powi(2));
        let (ratio, longest) = (gained / predicted, step.amax());
        if ratio > 1e-3 {
            (at, values) = (there, new);
        }
        trust = resized(trust, ratio, longest);
    }
    Arrival { at, values }
}

/// Radius of the trust region after a step of the size `longest` that gained the part `ratio` of what was predicted.
fn resized(trust: f64, ratio: f64, longest: f64) -> f64 {
    match ratio {
        _ if ratio < 0.25 => 0.35 * longest,
        _ if ratio > 0.7 && longest > 0.9 * trust => (2.0 * trust).min(1.0),
        _ => trust,
    }
}

/// Gauss–Newton approximation of the Hessian, and the gradient, of half the squared violation of the constraints.
fn gauss_newton(values: &Values) -> (DMatrix<f64>, DVector<f64>) {
    let n = values.gradient.len();
    let mut hessian = values.equalities_by.tr_mul(&values.equalities_by);
    let mut slope = values.equalities_by.tr_mul(&values.equalities);
    for (row, margin) in values.margins.iter().enumerate() {
        if *margin < 0.0 {
            let by = values.margins_by.row(row).transpose();
            slope += &by * *margin;
            hessian += &by * by.transpose();
        }
    }
    let largest = hessian.diagonal().amax();
    (
        hessian + DMatrix::identity(n, n) * (1e-10 * largest + 1e-300),
        slope,
    )
}

/// Bounds of a step from `at` that stays in the unit box and in the trust region.
fn room(at: &DVector<f64>, trust: f64) -> (DVector<f64>, DVector<f64>) {
    (
        at.map(|v| (-v).max(-trust)),
        at.map(|v| (1.0 - v).min(trust)),
    )
}

/// Minimizes the objective from a point that satisfies the constraints. Each iteration steps along the constraints by a
/// quadratic model of the Lagrangian and then returns to them; a step that does not decrease the objective is refused.
/// `None` if the problem has no finite values at `from`.
pub fn descend(problem: Problem<'_>, from: &DVector<f64>) -> Option<Arrival> {
    let values = problem(from, true).filter(Values::is_finite)?;
    let mut now = Arrival {
        at: from.clone(),
        values,
    };
    let n = from.len();
    let mut curvature = DMatrix::identity(n, n) * now.values.gradient.norm().max(1e-3);
    let mut trust = TRUST;
    for _ in 0..MAX_STEPS {
        let (low, high) = room(&now.at, trust);
        let step = along(&now.values, &curvature, &low, &high);
        let slope = &now.values.gradient;
        let predicted = -(slope.dot(&step) + 0.5 * (&curvature * &step).dot(&step));
        if predicted <= SETTLED * (1.0 + now.values.objective.abs()) || trust < MIN_TRUST {
            break;
        }
        let there = (&now.at + &step).map(|v| v.clamp(0.0, 1.0));
        let Some(new) = reached(problem, there) else {
            trust = 0.25 * step.amax();
            continue;
        };
        let multipliers = multipliers(&new.values);
        let change = lagrangian(&new.values, &multipliers) - lagrangian(&now.values, &multipliers);
        update(&mut curvature, &(&new.at - &now.at), &change);
        let ratio = (now.values.objective - new.values.objective) / predicted;
        let longest = step.amax();
        if ratio > 1e-3 {
            now = new;
        }
        trust = resized(trust, ratio, longest);
    }
    Some(now)
}

/// Moves a point to the constraints and evaluates the objective there; `None` if [`ON`] is not reached.
fn reached(problem: Problem<'_>, there: DVector<f64>) -> Option<Arrival> {
    let first = problem(&there, false).filter(Values::is_finite)?;
    let is_free = first.equalities.len() + first.margins.len() == 0;
    let mut met = Arrival {
        at: there,
        values: first,
    };
    if met.values.violation() > ON {
        met = meet_from(problem, met, MAX_EVALUATIONS.1);
    }
    if met.values.violation() > ON {
        return None;
    }
    if is_free {
        return Some(met);
    }
    let values = problem(&met.at, true).filter(Values::is_finite)?;
    Some(Arrival { at: met.at, values })
}

/// Step between `low` and `high` that minimizes the quadratic model with a penalty on the linearized constraints.
fn along(
    values: &Values,
    curvature: &DMatrix<f64>,
    low: &DVector<f64>,
    high: &DVector<f64>,
) -> DVector<f64> {
    let weight = |rows: &DMatrix<f64>| STIFF * curvature.norm() / rows.norm_squared().max(1e-300);
    let mut hessian = curvature.clone();
    if values.equalities_by.nrows() > 0 {
        hessian +=
            values.equalities_by.tr_mul(&values.equalities_by) * weight(&values.equalities_by);
    }
    let mut slope = values.gradient.clone();
    let mut step = minimum(&hessian, &slope, low, high);
    for (row, margin) in values.margins.iter().enumerate() {
        let by = values.margins_by.row(row).transpose();
        if margin + by.dot(&step) < 0.0 {
            let weight = weight(&values.margins_by);
            slope += &by * (margin * weight);
            hessian += &by * by.transpose() * weight;
            step = minimum(&hessian, &slope, low, high);
        }
    }
    step
}

/// Least-squares Lagrange multipliers of the constraints, in the order of the rows of [`stacked`].
fn multipliers(values: &Values) -> DVector<f64> {
    let rows = stacked(values);
    if rows.nrows() == 0 {
        return DVector::zeros(0);
    }
    moore_penrose(&rows.transpose(), RANK_TOLERANCE) * -&values.gradient
}

/// Jacobian of the equality, then of the inequality constraints; the rows of inactive inequalities are 0.
fn stacked(values: &Values) -> DMatrix<f64> {
    let (m, k, n) = (
        values.equalities.len(),
        values.margins.len(),
        values.gradient.len(),
    );
    DMatrix::from_fn(m + k, n, |i, j| match i < m {
        true => values.equalities_by[(i, j)],
        false if values.margins[i - m] < ON => values.margins_by[(i - m, j)],
        false => 0.0,
    })
}

fn lagrangian(values: &Values, multipliers: &DVector<f64>) -> DVector<f64> {
    &values.gradient + stacked(values).tr_mul(multipliers)
}

/// Powell's damped BFGS update of a Hessian approximation.
fn update(matrix: &mut DMatrix<f64>, step: &DVector<f64>, change: &DVector<f64>) {
    let moved = &*matrix * step;
    let along = step.dot(&moved);
    let sy = step.dot(change);
    if along <= 1e-300 || !sy.is_finite() {
        return;
    }
    let curved = sy >= 0.2 * along;
    let theta = if curved {
        1.0
    } else {
        0.8 * along / (along - sy)
    };
    let change = change * theta + &moved * (1.0 - theta);
    let curvature = step.dot(&change);
    *matrix += &change * change.transpose() / curvature - &moved * moved.transpose() / along;
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rosenbrock's function on the circle x² + y² = 1 with x ≤ 0.7, in the box [-2, 2]².
    fn valley(u: &DVector<f64>, _: bool) -> Option<Values> {
        let (x, y) = (4.0 * u[0] - 2.0, 4.0 * u[1] - 2.0);
        let bend = y - x * x;
        Some(Values {
            objective: 10.0 * bend * bend + (1.0 - x) * (1.0 - x),
            equalities: DVector::from_vec(vec![x * x + y * y - 1.0]),
            margins: DVector::from_vec(vec![0.7 - x]),
            gradient: DVector::from_vec(vec![
                4.0 * (-40.0 * bend * x - 2.0 * (1.0 - x)),
                4.0 * 20.0 * bend,
            ]),
            equalities_by: DMatrix::from_row_slice(1, 2, &[8.0 * x, 8.0 * y]),
            margins_by: DMatrix::from_row_slice(1, 2, &[-4.0, 0.0]),
        })
    }

    #[test]
    fn a_constrained_valley_is_followed_to_its_margin() {
        let start = DVector::from_vec(vec![0.62, 0.9]);
        let met = meet(&valley, &start).expect("values everywhere");
        assert!(met.values.violation() < 1e-8);
        let found = descend(&valley, &met.at).expect("values everywhere");
        assert!(found.values.violation() < ON);
        let (x, y) = (4.0 * found.at[0] - 2.0, 4.0 * found.at[1] - 2.0);
        // On the circle the minimum without the inequality is at x = 0.786, outside the constraint.
        assert!(
            (x - 0.7).abs() < 1e-3 && (y - 0.51f64.sqrt()).abs() < 1e-3,
            "{x} {y}"
        );
    }

    #[test]
    fn what_cannot_be_met_is_met_as_nearly_as_the_box_allows() {
        // x + y = 3 cannot be met in the unit box.
        let far = |u: &DVector<f64>, _: bool| {
            Some(Values {
                objective: 0.0,
                equalities: DVector::from_vec(vec![u[0] + u[1] - 3.0]),
                margins: DVector::zeros(0),
                gradient: DVector::zeros(2),
                equalities_by: DMatrix::from_row_slice(1, 2, &[1.0, 1.0]),
                margins_by: DMatrix::zeros(0, 2),
            })
        };
        let found = meet(&far, &DVector::from_vec(vec![0.1, 0.3])).expect("values");
        assert!((found.values.violation() - 1.0).abs() < 1e-9);
    }
}
