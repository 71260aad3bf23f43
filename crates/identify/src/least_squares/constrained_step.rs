//! Computes one step of the global parameters within their bounds.

use nalgebra::{DMatrix, DVector};

use super::scaled_cholesky::ScaledCholesky;

/// Adds the priors of parameters with the given values to JᵀJ and the gradient Jᵀr.
pub fn add_priors<'c>(
    (matrix, gradient): (&mut DMatrix<f64>, &mut DVector<f64>),
    values: &DVector<f64>,
    constraints: impl IntoIterator<Item = &'c Constraint>,
) {
    for (i, constraint) in constraints.into_iter().enumerate() {
        if let Some((mean, sigma)) = constraint.prior {
            matrix[(i, i)] += sigma.powi(-2);
            gradient[i] += (values[i] - mean) / (sigma * sigma);
        }
    }
}

/// Step of the global parameters that minimises the quadratic model of the sum of squares plus the priors, within the
/// bounds. Active-set method: a parameter that would cross a bound is set to it, and the others step again. Returns the
/// step and the decrease of the priors' squares; `None` if the matrix is singular.
pub fn constrained_step(
    reduced: &DMatrix<f64>,
    gradient: &DVector<f64>,
    values: &DVector<f64>,
    constraints: &[Constraint],
    damping: f64,
) -> Option<(DVector<f64>, f64)> {
    let size = values.len();
    let (mut matrix, mut gradient) = (reduced.clone(), gradient.clone());
    add_priors((&mut matrix, &mut gradient), values, constraints);
    let mut step = DVector::zeros(size);
    let mut active: Vec<bool> = (0..size)
        .map(|i| {
            let (low, high) = constraints[i].bounds;
            (values[i] <= low && gradient[i] > 0.0) || (values[i] >= high && gradient[i] < 0.0)
        })
        .collect();
    // Each pass adds a parameter to the active set, so there are at most as many passes as parameters.
    loop {
        let free: Vec<usize> = (0..size).filter(|&i| !active[i]).collect();
        let solved = free_step(&matrix, &gradient, &step, &active, &free, damping)?;
        for (&i, &value) in free.iter().zip(solved.iter()) {
            step[i] = value;
        }
        let Some((i, bound)) = first_bound(&free, values, &step, constraints) else {
            break;
        };
        active[i] = true;
        step[i] = bound - values[i];
    }
    let reductions = constraints.iter().enumerate().map(|(i, constraint)| {
        constraint.squares(values[i]) - constraint.squares(values[i] + step[i])
    });
    let reduction = reductions.sum();
    Some((step, reduction))
}

/// Bound that the step of a free parameter reaches first (index, value); `None` if none.
fn first_bound(
    free: &[usize],
    values: &DVector<f64>,
    step: &DVector<f64>,
    constraints: &[Constraint],
) -> Option<(usize, f64)> {
    let crossed = free.iter().filter_map(|&i| {
        let (low, high) = constraints[i].bounds;
        let target = values[i] + step[i];
        let bound = match target {
            _ if target < low => low,
            _ if target > high => high,
            _ => return None,
        };
        let fraction = (bound - values[i]) / step[i];
        Some((fraction, i, bound))
    });
    let (_, i, bound) = crossed.min_by(|a, b| a.0.total_cmp(&b.0))?;
    Some((i, bound))
}

/// Newton step of the free parameters, if the active ones change by their entries in `step`.
fn free_step(
    matrix: &DMatrix<f64>,
    gradient: &DVector<f64>,
    step: &DVector<f64>,
    active: &[bool],
    free: &[usize],
    damping: f64,
) -> Option<DVector<f64>> {
    let size = free.len();
    let selected = DMatrix::from_fn(size, size, |i, j| matrix[(free[i], free[j])]);
    let right = DVector::from_fn(size, |i, _| {
        let active = (0..active.len()).filter(|&j| active[j]);
        let moved: f64 = active.map(|j| matrix[(free[i], j)] * step[j]).sum();
        -(gradient[free[i]] + moved)
    });
    let solved = ScaledCholesky::new(&selected, damping)?.solve(&right);
    let finite = solved.iter().all(|value| value.is_finite());
    finite.then_some(solved)
}

// Bounds and prior of a global parameter.

/// Bounds and Gaussian prior of a global parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constraint {
    /// Lower and upper bound; infinite if the parameter is unbounded.
    pub bounds: (f64, f64),
    /// Mean and standard deviation of the Gaussian prior; `None` without a prior.
    pub prior: Option<(f64, f64)>,
}

impl Constraint {
    /// Constraint without bounds and prior.
    pub const NONE: Constraint = Constraint {
        bounds: (f64::NEG_INFINITY, f64::INFINITY),
        prior: None,
    };

    /// Squared distance of a value from the prior mean, in prior standard deviations; 0 without a prior.
    pub(super) fn squares(&self, value: f64) -> f64 {
        let squares = |(mean, sigma): (f64, f64)| ((value - mean) / sigma).powi(2);
        self.prior.map_or(0.0, squares)
    }
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
        // The minimum of x² + xy + y² − 5x − 4y is at (2, 1); with x fixed at 1, it is at y = 1.5.
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
