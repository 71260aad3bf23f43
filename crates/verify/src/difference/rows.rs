//! Rows of a model that are compared: derivatives, observation, limits, with what determines each.

use model_spec::model::Model;

/// What determines a row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RowKind {
    /// The stated equation of this state.
    Stated(String),
    /// The velocity of the body.
    Position,
    /// The forces on the body.
    Velocity,
    /// The moments on the body, and its attitude.
    Rotation,
    /// The measurement equation.
    Observation,
    /// The limit of this number, from 1.
    Limit(usize),
}

/// Kind of each row of a model, with its name.
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
