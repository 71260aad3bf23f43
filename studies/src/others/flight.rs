//! Simulates flights of a model with stated equations, from the oracle's derivatives.

use model_spec::model::Model;
use nalgebra::Vector3;
use ode::Method;
use oracle::{ClaimedBody, Point, Tree, derivatives};

/// Duration of the flights that are simulated with the equations of published simulators, s.
pub const DURATION: f64 = 2.0;
/// Number of equally spaced output times of a simulated flight, including the release and the end.
const INSTANTS: usize = 41;

/// Integrates the model's equations from the time, states and parameters in `from`. Returns the time, states and
/// parameters at equally spaced times, release and end included; `None` if the integration fails.
pub fn fly(model: &Model, from: &Point<f64>) -> Option<Vec<Point<f64>>> {
    let mut at = from.clone();
    let mut moving = ode::rhs_from_fn(&[], |t, x: &Vec<f64>, dx: &mut Vec<f64>| {
        at.time = t;
        at.states.copy_from_slice(x);
        match derivatives(model, &at) {
            Ok(rates) => dx.copy_from_slice(&rates),
            Err(_) => dx.fill(f64::NAN),
        }
    });
    let options = ode::IntegrationOptions {
        method: Method::Dop853,
        ..ode::IntegrationOptions::with_tolerance(1e-10)
    };
    let mut points = vec![from.clone()];
    for k in 1..INSTANTS {
        let last = &points[k - 1];
        let time = DURATION * k as f64 / (INSTANTS - 1) as f64;
        let start = (last.time, &last.states);
        let end = ode::integrate_to_end(&mut moving, start, time, &options, &mut []).ok()?;
        points.push(Point {
            time,
            states: end.state,
            ..from.clone()
        });
    }
    Some(points)
}

/// Position of the body that the model describes, m, at the time, states and parameters in `point`. `None` if the model
/// does not declare a body.
pub fn position(model: &Model, point: &Point<f64>) -> Option<Vector3<f64>> {
    Some(ClaimedBody::of(&Tree::new(model, point))?.position)
}
