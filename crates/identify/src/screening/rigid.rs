//! Determines which distances between markers are fixed by the template. A distance is not fixed if it depends on an
//! estimated parameter of the measurement, such as a marker's offset, its clock or the scale of the axes.

use super::distances::marker_pairs;
use crate::marker_observers::MarkerConditions;
use crate::problem::FitProblem;

/// Threshold below which the derivative of a distance between markers with respect to an estimated parameter counts as
/// zero, relative to the derivatives of the markers' positions.
const MIN_DERIVATIVE: f64 = 1e-9;

/// For each pair of markers: whether the declared positions of the markers fix its distance independently of all
/// estimated parameters. The pairs are in the order of [`marker_pairs`].
pub fn rigid_pairs(problem: &FitProblem) -> Vec<bool> {
    let pairs = marker_pairs(problem.markers.len());
    let parameters = &problem.parameters;
    let conditions = MarkerConditions::new(&problem.body, parameters, problem.markers.len());
    let mut observers = conditions.observers();
    // The default state may be at rest or level, where derivatives vanish: a clock error has no effect on a body at
    // rest.
    let states = problem.body.layout().default_states().into_iter();
    let state: Vec<f64> = states
        .enumerate()
        .map(|(index, value)| value + 0.3 + 0.1 * index as f64)
        .collect();
    let estimated = |param: usize| {
        let mut globals = problem.globals.iter();
        globals.position(|global| global.param.index() == param)
    };
    // Position of each marker and its derivatives with respect to the estimated parameters.
    let seen: Vec<([f64; 3], Vec<[f64; 3]>)> = (problem.markers.iter().enumerate())
        .map(|marker| {
            let (position, jacobians) = observers.linearise(0.0, &state, marker);
            let mut by_global = vec![[0.0; 3]; problem.globals.len()];
            let entries = jacobians.by_parameter_pattern.iter();
            for (&(row, param), value) in entries.zip(jacobians.by_parameter) {
                if let Some(global) = estimated(param) {
                    by_global[global][row] = *value;
                }
            }
            (position, by_global)
        })
        .collect();
    let is_rigid = |&(i, j): &(usize, usize)| {
        let ((a, by_a), (b, by_b)) = (&seen[i], &seen[j]);
        by_a.iter().zip(by_b).all(|(by_a, by_b)| {
            let change = (0..3).map(|k| (b[k] - a[k]) * (by_b[k] - by_a[k]));
            let size = (0..3).map(|k| (b[k] - a[k]).abs() * (by_b[k].abs() + by_a[k].abs()));
            // The comparison is false if a value is not finite: the distance is then unknown.
            change.sum::<f64>().abs() <= MIN_DERIVATIVE * size.sum::<f64>()
        })
    };
    pairs.iter().map(is_rigid).collect()
}
