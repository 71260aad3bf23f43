//! Minimum of a convex quadratic function in a box, by an active-set method.

use nalgebra::{DMatrix, DVector};

/// Step δ between `low` and `high`, which enclose 0, that minimizes ½ δᵀHδ + gᵀδ for a nearly positive definite H.
pub fn minimum(
    hessian: &DMatrix<f64>,
    slope: &DVector<f64>,
    low: &DVector<f64>,
    high: &DVector<f64>,
) -> DVector<f64> {
    let n = slope.len();
    let mut step = DVector::zeros(n);
    let mut held: Vec<bool> = (0..n)
        .map(|k| outward(slope[k], step[k], low[k], high[k]))
        .collect();
    // Each active set is visited at most once; in practice only a few are.
    for _ in 0..20 * (n + 1) {
        let free: Vec<usize> = (0..n).filter(|k| !held[*k]).collect();
        let gradient = hessian * &step + slope;
        let newton = newton(hessian, &gradient, &free);
        let mut length = 1.0;
        let mut blocking = None;
        for (k, direction) in free.iter().zip(newton.iter()) {
            let bound = if *direction > 0.0 { high[*k] } else { low[*k] };
            if *direction != 0.0 && (bound - step[*k]) / direction < length {
                length = ((bound - step[*k]) / direction).max(0.0);
                blocking = Some((*k, bound));
            }
        }
        for (k, direction) in free.iter().zip(newton.iter()) {
            step[*k] = (step[*k] + length * direction).clamp(low[*k], high[*k]);
        }
        if let Some((k, bound)) = blocking {
            step[k] = bound;
            held[k] = true;
            continue;
        }
        let gradient = hessian * &step + slope;
        let inward = |k: &usize| held[*k] && !outward(gradient[*k], step[*k], low[*k], high[*k]);
        let steepest = (0..n).filter(inward);
        match steepest.max_by(|a, b| gradient[*a].abs().total_cmp(&gradient[*b].abs())) {
            Some(k) if gradient[k].abs() > 1e-12 * slope.amax() => held[k] = false,
            _ => break,
        }
    }
    step
}

/// Whether a variable is at a bound, and a descent by `slope` would move it beyond.
fn outward(slope: f64, step: f64, low: f64, high: f64) -> bool {
    step <= low && slope >= 0.0 || step >= high && slope <= 0.0
}

/// Newton step −H⁻¹g of the variables `free`, with a ridge where the Hessian is not positive definite.
fn newton(hessian: &DMatrix<f64>, gradient: &DVector<f64>, free: &[usize]) -> DVector<f64> {
    let m = free.len();
    let part = DMatrix::from_fn(m, m, |i, j| hessian[(free[i], free[j])]);
    let right = DVector::from_fn(m, |i, _| -gradient[free[i]]);
    let scale = (0..m).map(|i| part[(i, i)].abs()).fold(1e-300, f64::max);
    let mut ridge = 0.0;
    for _ in 0..12 {
        let damped = &part + DMatrix::identity(m, m) * ridge;
        if let Some(factor) = damped.cholesky() {
            return factor.solve(&right);
        }
        ridge = (ridge * 100.0).max(1e-14 * scale);
    }
    right / scale
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_minimum_meets_the_conditions_of_the_box() {
        // Deterministic positive definite matrices of several sizes.
        for n in 1..8 {
            for case in 0..40 {
                let number =
                    |i: usize, j: usize| ((i * 7 + j * 13 + case * 29 + 3) % 17) as f64 / 8.5 - 1.0;
                let root = DMatrix::from_fn(n, n, number);
                let hessian = root.tr_mul(&root) + DMatrix::identity(n, n) * 1e-3;
                let slope = DVector::from_fn(n, |i, _| number(i, 5) * 3.0);
                let low = DVector::from_fn(n, |i, _| -0.1 - 0.1 * number(i, 2).abs());
                let high = DVector::from_fn(n, |i, _| 0.2 * number(i, 3).abs());
                let step = minimum(&hessian, &slope, &low, &high);
                let gradient = &hessian * &step + &slope;
                for k in 0..n {
                    assert!(low[k] <= step[k] && step[k] <= high[k]);
                    let free = low[k] < step[k] && step[k] < high[k];
                    let held = outward(gradient[k], step[k], low[k], high[k]);
                    assert!(
                        held || free && gradient[k].abs() < 1e-8,
                        "{n} {case} {k}: {gradient}"
                    );
                }
            }
        }
    }
}
