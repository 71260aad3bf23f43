//! One step of the shared unknowns within their bounds.

use nalgebra::{DMatrix, DVector};

use super::Constraint;

/// The step of the shared unknowns that minimises the quadratic left after the elimination, with priors added and
/// without leaving the bounds; and by how much it decreases the priors' part of the sum of squares. An unknown that
/// wants to leave its bound is held there, and the others step for themselves. None where the matrix is singular.
pub fn constrained_step(
    reduced: &DMatrix<f64>,
    gradient: &DVector<f64>,
    values: &DVector<f64>,
    constraints: &[Constraint],
    damping: f64,
) -> Option<(DVector<f64>, f64)> {
    let size = values.len();
    let (mut matrix, mut gradient) = (reduced.clone(), gradient.clone());
    for (i, constraint) in constraints.iter().enumerate() {
        if let Some((centre, sigma)) = constraint.prior {
            matrix[(i, i)] += sigma.powi(-2);
            gradient[i] += (values[i] - centre) / (sigma * sigma);
        }
    }
    let mut step = DVector::zeros(size);
    let mut held: Vec<bool> = (0..size)
        .map(|i| {
            let (low, high) = constraints[i].bounds;
            (values[i] <= low && gradient[i] > 0.0) || (values[i] >= high && gradient[i] < 0.0)
        })
        .collect();
    // Each pass holds one more unknown, so there are at most as many as unknowns.
    loop {
        let free: Vec<usize> = (0..size).filter(|&i| !held[i]).collect();
        let solved = solve(&matrix, &gradient, &step, &held, &free, damping)?;
        for (&i, &value) in free.iter().zip(solved.iter()) {
            step[i] = value;
        }
        let beyond = free.iter().filter_map(|&i| {
            let (low, high) = constraints[i].bounds;
            let target = values[i] + step[i];
            let bound = if target < low {
                low
            } else if target > high {
                high
            } else {
                return None;
            };
            // The part of the step that stays within.
            let part = (bound - values[i]) / step[i];
            Some((part, i, bound))
        });
        let Some((_, i, bound)) = beyond.min_by(|a, b| a.0.total_cmp(&b.0)) else {
            break;
        };
        held[i] = true;
        step[i] = bound - values[i];
    }
    let gain = constraints.iter().enumerate();
    let gain = gain.map(|(i, constraint)| {
        constraint.squares(values[i]) - constraint.squares(values[i] + step[i])
    });
    Some((step.clone(), gain.sum()))
}

/// The step of the free unknowns, where the held ones step as they do.
fn solve(
    matrix: &DMatrix<f64>,
    gradient: &DVector<f64>,
    step: &DVector<f64>,
    held: &[bool],
    free: &[usize],
    damping: f64,
) -> Option<DVector<f64>> {
    let scale = |i: usize| {
        let root = matrix[(i, i)].max(0.0).sqrt();
        if root > 1e-150 { 1.0 / root } else { 1.0 }
    };
    let size = free.len();
    let mut left = DMatrix::from_fn(size, size, |i, j| {
        matrix[(free[i], free[j])] * scale(free[i]) * scale(free[j])
    });
    for i in 0..size {
        left[(i, i)] += damping;
    }
    let right = DVector::from_fn(size, |i, _| {
        let plus = (0..held.len()).filter(|&j| held[j]);
        let plus: f64 = plus.map(|j| matrix[(free[i], j)] * step[j]).sum();
        -(gradient[free[i]] + plus) * scale(free[i])
    });
    let solved = left.cholesky()?.solve(&right);
    let solved = DVector::from_fn(size, |i, _| solved[i] * scale(free[i]));
    solved
        .iter()
        .all(|value| value.is_finite())
        .then_some(solved)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bounded(low: f64, high: f64) -> Constraint {
        Constraint {
            bounds: (low, high),
            prior: None,
        }
    }

    #[test]
    fn the_others_step_for_themselves_when_one_is_held() {
        // Least of x² + xy + y² − 5x − 4y: at (2, 1); with x held at 1 the least is at y = 1.5.
        let matrix = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, 2.0]);
        let gradient = DVector::from_vec(vec![-5.0, -4.0]);
        let values = DVector::zeros(2);
        let free = [Constraint::NONE; 2];
        let (step, _) = constrained_step(&matrix, &gradient, &values, &free, 0.0).unwrap();
        assert!((step - DVector::from_vec(vec![2.0, 1.0])).norm() < 1e-14);
        let constraints = [bounded(-1.0, 1.0), Constraint::NONE];
        let (step, _) = constrained_step(&matrix, &gradient, &values, &constraints, 0.0).unwrap();
        assert!((step - DVector::from_vec(vec![1.0, 1.5])).norm() < 1e-14);
    }

    #[test]
    fn an_unknown_leaves_its_bound_again() {
        let matrix = DMatrix::identity(1, 1);
        let constraints = [bounded(0.0, 1.0)];
        let values = DVector::from_element(1, 1.0);
        let inward = DVector::from_element(1, 0.5);
        let (step, _) = constrained_step(&matrix, &inward, &values, &constraints, 0.0).unwrap();
        assert_eq!(step[0], -0.5);
        let outward = DVector::from_element(1, -0.5);
        let (step, _) = constrained_step(&matrix, &outward, &values, &constraints, 0.0).unwrap();
        assert_eq!(step[0], 0.0);
    }

    #[test]
    fn a_prior_draws() {
        let constraints = [Constraint {
            prior: Some((3.0, 1.0)),
            ..Constraint::NONE
        }];
        let (matrix, gradient) = (DMatrix::identity(1, 1), DVector::from_element(1, -1.0));
        let (step, gain) =
            constrained_step(&matrix, &gradient, &DVector::zeros(1), &constraints, 0.0).unwrap();
        assert!((step[0] - 2.0).abs() < 1e-14 && (gain - (9.0 - 1.0)).abs() < 1e-13);
    }
}
