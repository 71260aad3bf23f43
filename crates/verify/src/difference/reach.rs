//! Which statements determine each compared row of a model: derivative, component of the observation, validity limit.

use super::statements::{Change, Key, Statement, keyed, value};
use super::terms::words;
use model_spec::model::Model;
use model_spec::syntax::ast::{Expr, ExprKind, ItemKind};
use std::collections::{BTreeMap, BTreeSet};

/// Whether a row depends directly on a statement. The rates of the attitude count as depending on the moments.
fn is_root(model: &Model, row: usize, (class, name): &Key) -> bool {
    let Some(state) = model.states.get(row) else {
        let observed = if model.observation.is_some() { 3 } else { 0 };
        return match (row - model.states.len()).checked_sub(observed) {
            None => ["observe", "marker", "frame"].contains(class),
            Some(limit) => *class == "limit" && *name == (limit + 1).to_string(),
        };
    };
    if *class == "clock" {
        return true;
    }
    let mut unknowns = model.systems.iter().flat_map(|system| &system.unknowns);
    if unknowns.any(|unknown| unknown.state == Some(row)) {
        return *class == "solve";
    }
    if model.equations.iter().any(|e| e.state == row) {
        return *class == "der" && *name == state.name;
    }
    let load = match &model.body {
        Some(body) if body.position.contains(&row) => "body",
        Some(body) if body.velocity.contains(&row) => "force",
        _ => "moment",
    };
    ["body", "frame", load].contains(class)
}

/// For each row of a model, the statements on which it depends.
pub struct Reach {
    uses: BTreeMap<Key, BTreeSet<Key>>,
    roots: BTreeMap<String, BTreeSet<Key>>,
}

impl Reach {
    /// Dependencies of the statements of a model and of the rows with these names.
    pub fn of(model: &Model, rows: &[String]) -> Self {
        let items = keyed(&model.tree);
        let by_name = |name: &str| -> Vec<Key> {
            let classes = ["let", "table", "constant", "input", "frame", "state", "der"];
            let found = items.iter().filter(|(key, item)| match &item.kind {
                ItemKind::Solve(own) => own.unknowns.iter().any(|own| own.name.text == name),
                _ => key.1 == name && classes.contains(&key.0),
            });
            found.map(|(key, _)| key.clone()).collect()
        };
        let mut uses = BTreeMap::new();
        for (key, item) in &items {
            let text = item.kind.to_string();
            let words = words(&text);
            let mut found: BTreeSet<Key> = words.iter().flat_map(|w| by_name(w)).collect();
            found.remove(key);
            if item.is_of_call() {
                let function = key.1.split("__").next().unwrap_or_default();
                found.insert(("function", function.to_owned()));
            }
            // Only `der(…)` refers to the equation of a state; the name of the state does not.
            let sides: Vec<&Expr> = match (value(item), &item.kind) {
                (None, ItemKind::Solve(own)) => own.sides().collect(),
                (value, _) => value.into_iter().collect(),
            };
            let parts = sides.into_iter().flat_map(Expr::nodes);
            let used: BTreeSet<&str> = parts.filter_map(derivative).collect();
            found.retain(|k| k.0 != "der" || used.contains(k.1.as_str()));
            uses.insert(key.clone(), found);
        }
        let roots = rows.iter().enumerate().map(|(k, row)| {
            let keys = items.iter().map(|(key, _)| key);
            let own = keys.filter(|key| is_root(model, k, key));
            (row.clone(), own.cloned().collect())
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

fn derivative(e: &Expr) -> Option<&str> {
    match &e.kind {
        ExprKind::Derivative(state) => Some(&state.text),
        _ => None,
    }
}

/// Added, removed and changed statements on which the row depends in one of the models, with their terms that differ.
pub fn causes(statements: &[Statement], reach: &[Reach; 2], row: &str) -> Vec<String> {
    let reached = reach.each_ref().map(|reach| reach.of_row(row));
    let is_cause = |s: &&Statement| {
        matches!(s.change, Change::Added | Change::Removed | Change::Changed)
            && reached.iter().any(|keys| keys.contains(&s.key))
    };
    let mut all: Vec<String> = statements
        .iter()
        .filter(is_cause)
        .map(Statement::cause)
        .collect();
    all.dedup();
    all
}
