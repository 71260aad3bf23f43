//! Weak priors of an initial state for flights without measured positions, which do not determine the initial position
//! and heading.

use nalgebra::DVector;

use crate::least_squares::NormalBlock;
use crate::observations::Observations;
use crate::problem::FitProblem;

/// Prior standard deviation of an initial-state component about 0, given the unit of the state. It is far wider than
/// the uncertainty of any state that the flight determines.
fn deviation(unit: &str) -> f64 {
    match unit {
        "m" => 10.0,
        "m/s" => 100.0,
        "rad" => 3.0,
        "rad/s" => 1000.0,
        _ => 1.0,
    }
}

/// Adds the weak priors of the initial state `local` to `block`, the normal equations of a flight. Each state has the
/// prior mean 0 and the standard deviation that `deviation` gives for its unit.
pub(super) fn add(
    problem: &FitProblem,
    observations: &Observations,
    local: &DVector<f64>,
    block: &mut NormalBlock,
) {
    let states = &problem.model.states;
    let tangent = observations.manifold.tangent(local.as_slice());
    let (locals, globals) = (block.local.nrows(), block.global.nrows());
    let none = DVector::zeros(globals);
    let count = block.count;
    for (index, state) in states.iter().enumerate() {
        let deviation = deviation(&state.unit_text);
        let mut by_local = DVector::zeros(locals);
        for &(of, direction, value) in &tangent {
            if of == index {
                by_local[direction] = value / deviation;
            }
        }
        if by_local.iter().any(|value| *value != 0.0) {
            block.add(local[index] / deviation, &by_local, &none);
        }
    }
    block.count = count;
}
