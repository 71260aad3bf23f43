//! The compared rows of a model (derivatives, observation, limits), and which statements determine each.

use model_spec::model::Model;

/// Kind of a scalar function (row) of a model that is compared: state derivative, component of the observation or
/// validity limit. The kind determines the statements on which the function depends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RowKind {
    /// Derivative of the state with this name, defined by an equation written explicitly in the model file.
    Stated(String),
    /// Derivative of a position component of the body, defined by its velocity.
    Position,
    /// Derivative of a velocity component of the body, determined by the forces on it.
    Velocity,
    /// Derivative of an attitude angle, quaternion component or angular velocity component of the body. All of these
    /// count as depending on the moments, although moments affect only angular accelerations.
    Rotation,
    /// Component of the observation, defined by the measurement equation.
    Observation,
    /// Validity limit of the model, by its index in the order of the file, from 1.
    Limit(usize),
}

/// Pairs (name of the row, kind) for all rows of a model. `names` are the names of the rows in this order: state
/// derivatives, components of the observation, validity limits.
pub fn kinds(model: &Model, names: &[String]) -> Vec<(String, RowKind)> {
    let stated = |state: usize| model.equations.iter().any(|e| e.state == state);
    let kind = |row: usize| match model.states.get(row) {
        Some(state) if stated(row) => RowKind::Stated(state.name.clone()),
        Some(_) => match &model.body {
            Some(body) if body.position.contains(&row) => RowKind::Position,
            Some(body) if body.velocity.contains(&row) => RowKind::Velocity,
            _ => RowKind::Rotation,
        },
        None => {
            let seen = if model.observation.is_some() { 3 } else { 0 };
            match (row - model.states.len()).checked_sub(seen) {
                None => RowKind::Observation,
                Some(limit) => RowKind::Limit(limit + 1),
            }
        }
    };
    names
        .iter()
        .cloned()
        .zip((0..names.len()).map(kind))
        .collect()
}
