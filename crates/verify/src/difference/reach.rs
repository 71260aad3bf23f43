//! Which statements determine each compared row of a model: derivative, component of the observation, validity limit.

use super::statements::{Key, keyed, value};
use super::terms::words;
use model_spec::model::Model;
use model_spec::syntax::ast::{Expr, ExprKind};
use std::collections::{BTreeMap, BTreeSet};

/// Kind of a row of a model, which determines the statements on which it depends.
enum RowKind {
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

/// Kind of the row with the index `row`, in this order: state derivatives, components of the observation, validity
/// limits.
fn kind(model: &Model, row: usize) -> RowKind {
    if let Some(state) = model.states.get(row) {
        if model.equations.iter().any(|e| e.state == row) {
            return RowKind::Stated(state.name.clone());
        }
        return match &model.body {
            Some(body) if body.position.contains(&row) => RowKind::Position,
            Some(body) if body.velocity.contains(&row) => RowKind::Velocity,
            _ => RowKind::Rotation,
        };
    }
    let observed = if model.observation.is_some() { 3 } else { 0 };
    match (row - model.states.len()).checked_sub(observed) {
        None => RowKind::Observation,
        Some(limit) => RowKind::Limit(limit + 1),
    }
}

/// For each row of a model, the statements on which it depends.
pub struct Reach {
    uses: BTreeMap<Key, BTreeSet<Key>>,
    roots: BTreeMap<String, BTreeSet<Key>>,
}

impl Reach {
    /// Determines which statements of a model's file depend on which others. `rows` are the names of the rows: state
    /// derivatives, components of the observation, validity limits.
    pub fn of(model: &Model, rows: &[String]) -> Self {
        let items = keyed(&model.tree);
        let by_name = |name: &str| -> Vec<Key> {
            let classes = ["let", "table", "constant", "input", "frame", "state", "der"];
            let is = |key: &Key| key.1 == name && classes.contains(&key.0);
            let found = items.iter().map(|(key, _)| key).filter(|key| is(key));
            found.cloned().collect()
        };
        let mut uses = BTreeMap::new();
        for (key, item) in &items {
            let text = item.kind.to_string();
            let words = words(&text);
            let mut found: BTreeSet<Key> = words.iter().flat_map(|w| by_name(w)).collect();
            found.remove(key);
            // Only `der(…)` refers to the equation of a state; the name of the state does not.
            let mut used = BTreeSet::new();
            if let Some(value) = value(item) {
                derivatives(value, &mut used);
            }
            found.retain(|k| k.0 != "der" || used.contains(&k.1));
            uses.insert(key.clone(), found);
        }
        let of = |classes: &[&str]| -> BTreeSet<Key> {
            let keys = items.iter().map(|(key, _)| key.clone());
            keys.filter(|key| classes.contains(&key.0)).collect()
        };
        let roots = rows.iter().enumerate().map(|(k, row)| {
            let mut roots = match kind(model, k) {
                RowKind::Stated(state) => BTreeSet::from([("der", state)]),
                RowKind::Position => of(&["body", "frame"]),
                RowKind::Velocity => of(&["force", "body", "frame"]),
                RowKind::Rotation => of(&["moment", "body", "frame"]),
                RowKind::Observation => of(&["observe", "marker", "frame"]),
                RowKind::Limit(k) => BTreeSet::from([("limit", k.to_string())]),
            };
            if k < model.states.len() {
                roots.extend(of(&["clock"]));
            }
            (row.clone(), roots)
        });
        Self {
            roots: roots.collect(),
            uses,
        }
    }

    /// All statements on which a row depends, directly or indirectly; empty for an unknown row.
    pub fn of_row(&self, row: &str) -> BTreeSet<Key> {
        let mut out = BTreeSet::new();
        let mut open: Vec<Key> = self.roots.get(row).into_iter().flatten().cloned().collect();
        while let Some(key) = open.pop() {
            if out.insert(key.clone()) {
                open.extend(self.uses.get(&key).into_iter().flatten().cloned());
            }
        }
        out
    }
}

fn derivatives(e: &Expr, out: &mut BTreeSet<String>) {
    if let ExprKind::Derivative(state) = &e.kind {
        out.insert(state.text.clone());
    }
    e.children(&mut |child| derivatives(child, out));
}
