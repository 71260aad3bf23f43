//! Weak priors of an initial state of which no position is measured: place and heading are then free.

use nalgebra::DVector;

use crate::least_squares::NormalBlock;
use crate::observations::Observations;
use crate::problem::FitProblem;

/// Standard deviation of a state about 0 by its unit: far wider than what a flight tells of a state that it tells of.
fn deviation(unit: &str) -> f64 {
    match unit {
        "m" => 10.0,
        "m/s" => 100.0,
        "rad" => 3.0,
        "rad/s" => 1000.0,
        _ => 1.0,
    }
}

/// Adds the priors to the normal equations of a flight.
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
