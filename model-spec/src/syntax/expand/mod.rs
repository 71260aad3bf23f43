//! Expansion of functions, arrays and further bodies on the syntax tree, after which a model has neither calls of functions
//! nor indices, and one body.
//!
//! An element `r[3]` becomes the quantity `r_3`. A call becomes the result of its function, with a `let` for each
//! argument and each `let` of the body; their names contain `__`. Functions themselves stay, so that they are checked
//! and effects may call them.

mod bodies;
mod inline;
mod unroll;

use std::collections::HashSet;

use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::syntax::ast::{
    Effect, EffectPart, Expanded, Expr, ExprKind, File, Item, ItemKind, Template,
};
use crate::syntax::reserved::{FIXED, OF_BODY};
use inline::Inliner;
pub(crate) use inline::wrong_count;
use std::sync::Arc;
use unroll::Unroller;

/// Maximum number of operations, names and numbers of the statements that functions and arrays expand to.
const MAX_NODES: usize = 100_000;

/// Expands all statements of a file in place; returns the errors. An expanded file does not change.
pub(crate) fn expand(file: &mut File) -> Vec<Diagnostic> {
    let mut budget = Budget::default();
    let mut unroller = Unroller::new(taken(file), &mut budget);
    let items = std::mem::take(&mut file.items);
    for item in items {
        file.items.extend(unroller.item(item));
    }
    let mut faults = unroller.finish();
    if faults.is_empty() {
        let mut inliner = Inliner::new(file, &mut budget);
        let inlined = inliner.items(&file.items);
        faults = inliner.finish();
        if let Some(items) = inlined {
            file.items = items;
        }
        if faults.is_empty() {
            faults = bodies::write_out(file);
        }
    }
    faults.extend(budget.fault);
    faults
}

/// Writes out the arrays and indices of an effect; returns the errors. `file` is the model that it is applied to.
pub(crate) fn unroll_effect(effect: &mut Effect, file: &File) -> Vec<Diagnostic> {
    let mut budget = Budget::default();
    let mut unroller = Unroller::new(taken(file), &mut budget);
    let parts = std::mem::take(&mut effect.parts);
    for part in parts {
        match part {
            EffectPart::Add(item) => {
                let items = unroller.item(*item).into_iter();
                let items = items.map(|item| EffectPart::Add(Box::new(written_out(item))));
                effect.parts.extend(items);
            }
            EffectPart::Replace(item) => {
                let items = unroller.item(*item).into_iter();
                let items = items.map(|item| EffectPart::Replace(Box::new(written_out(item))));
                effect.parts.extend(items);
            }
            EffectPart::ReplaceInertia(mut inertia, span) => {
                for entry in inertia.rows.iter_mut().flatten().flatten() {
                    unroller.root(entry);
                }
                effect.parts.push(EffectPart::ReplaceInertia(inertia, span));
            }
            other => effect.parts.push(other),
        }
    }
    let mut faults = unroller.finish();
    faults.extend(budget.fault);
    faults
}

/// The statement as if it stood in the text itself.
fn written_out(item: Item) -> Item {
    Item {
        expanded: None,
        ..item
    }
}

/// Whether a file has arrays, elements, sums or further bodies, which only [`expand`] writes out.
pub(crate) fn is_needed(file: &File) -> bool {
    file.items.iter().any(|item| has_indices(&item.kind)) || bodies::is_needed(file)
}

fn has_indices(kind: &ItemKind) -> bool {
    let has_index = |e: &Expr| matches!(e.kind, ExprKind::Element(..) | ExprKind::Sum(..));
    matches!(kind, ItemKind::Array(_))
        || kind
            .roots()
            .into_iter()
            .flat_map(Expr::nodes)
            .any(has_index)
}

/// Names that an index cannot have.
fn taken(file: &File) -> HashSet<String> {
    let mut names = file.declared();
    names.extend(FIXED.iter().chain(&OF_BODY).map(|name| (*name).to_owned()));
    names
}

/// Nodes of the expanded statements so far, and the error if there are more than [`MAX_NODES`].
#[derive(Default)]
struct Budget {
    nodes: usize,
    fault: Option<Diagnostic>,
}

impl Budget {
    /// Counts nodes that the statement at `span` expands to; whether there are still few enough.
    fn spend(&mut self, nodes: usize, span: Span) -> bool {
        self.nodes = self.nodes.saturating_add(nodes);
        if self.nodes > MAX_NODES && self.fault.is_none() {
            let message = format!(
                "written out, the functions and arrays have more than {MAX_NODES} operations, names and numbers"
            );
            self.fault = Some(Diagnostic::new(Kind::Limit, span, message).note(
                "each call has a copy of its function, and each element one of its statement",
            ));
        }
        self.fault.is_none()
    }
}

/// Marks `items`, which the statement `written` was expanded to; `calls` are the spans of the calls that added them.
fn of_template(written: Item, items: Vec<(Item, Option<Span>)>) -> Vec<Item> {
    let expanded = items.iter().map(|(item, _)| item.kind.clone()).collect();
    let from = Arc::new(Template { written, expanded });
    let mark = |(item, call)| Item {
        expanded: Some(Expanded {
            from: Arc::clone(&from),
            call,
        }),
        ..item
    };
    items.into_iter().map(mark).collect()
}

pub(crate) fn height(e: &Expr) -> u32 {
    1 + e.children().into_iter().map(height).max().unwrap_or(0)
}
