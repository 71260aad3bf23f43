//! State derivatives of a model from its vector tree: stated equations are evaluated directly, those of a body follow
//! from Newton's and Euler's laws in inertial components.

use crate::error::Unsupported;
use crate::newton_euler::{newton_euler, state_derivatives};
use crate::point::Point;
use crate::scalar::Real;
use crate::tree::Tree;
use model_spec::model::Model;

/// Computes the derivative of every state of a model at a point with respect to recorded time.
pub fn derivatives<T: Real>(model: &Model, point: &Point<T>) -> Result<Vec<T>, Unsupported> {
    derivatives_of(&Tree::new(model, point))
}

/// Derivatives of all states by recorded time, at the point of the evaluated `tree`.
pub fn derivatives_of<T: Real>(tree: &Tree<'_, T>) -> Result<Vec<T>, Unsupported> {
    let model = tree.model;
    let mut out = match &model.body {
        None => vec![T::zero(); model.states.len()],
        Some(body) => {
            let (force, moment) = (tree.total(&model.forces), tree.total(&model.moments));
            let properties = tree.mass_properties(body);
            let motion = newton_euler(body, &tree.frames, &properties, force, moment);
            state_derivatives(model, body, &tree.point.states, &tree.frames, &motion)?
        }
    };
    for equation in &model.equations {
        out[equation.state] = tree.scalar(&equation.value);
    }
    if model.clock.is_some() {
        let clock_rate = tree.clock();
        out.iter_mut().for_each(|rate| *rate *= clock_rate);
    }
    Ok(out)
}
