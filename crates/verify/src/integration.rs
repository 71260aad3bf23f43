//! Integration of equations of motion: the flights of the checks. One instantiation of the integrator serves all.

use ode::{IntegrationError, IntegrationOptions};
use oracle::Point;

/// Right-hand side of a differential equation: writes dx/dt at a time and state, its first two arguments, to the third.
pub type RightHandSide<'a> = dyn FnMut(f64, &[f64], &mut [f64]) + 'a;

/// Final state of dx/dt = `rhs` from the state `start` at time 0, after `seconds`.
pub fn integrate(
    rhs: &mut RightHandSide<'_>,
    start: &[f64],
    seconds: f64,
    options: &IntegrationOptions,
) -> Result<Vec<f64>, IntegrationError> {
    let mut rhs = ode::rhs_from_fn(&[], |t, x: &Vec<f64>, dx: &mut Vec<f64>| rhs(t, x, dx));
    let start = (0.0, &start.to_vec());
    ode::integrate_to_end(&mut rhs, start, seconds, options, &mut []).map(|end| end.state)
}

/// Final point of a flight; `rates` evaluates the derivatives of the states.
pub fn fly(
    rates: &dyn Fn(&Point<f64>) -> Vec<f64>,
    from: &Point<f64>,
    seconds: f64,
    options: &IntegrationOptions,
) -> Result<Point<f64>, IntegrationError> {
    let mut at = from.clone();
    let mut rhs = |t: f64, x: &[f64], dx: &mut [f64]| {
        at.time = from.time + t;
        at.states.copy_from_slice(x);
        dx.copy_from_slice(&rates(&at));
    };
    let states = integrate(&mut rhs, &from.states, seconds, options)?;
    Ok(Point {
        time: from.time + seconds,
        states,
        ..from.clone()
    })
}
