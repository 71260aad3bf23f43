//! Calls of functions, replaced by copies of the functions.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use super::{Budget, height, of_template, written_out};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::syntax::ast::{Expr, ExprKind, File, Function, Item, ItemKind, Let, Name};
use crate::syntax::print::listed;
use crate::syntax::{MAX_HEIGHT, of_kind};

/// Maximum number of functions that call one another, which bounds the recursion.
const MAX_DEPTH: usize = 32;

pub(super) struct Inliner<'b> {
    functions: HashMap<String, Arc<Function>>,
    /// For each function, the number of the last call.
    calls: HashMap<String, u32>,
    budget: &'b mut Budget,
    diagnostics: Vec<Diagnostic>,
    /// Auxiliary variables of the calls in the current statement, with the spans of the calls.
    added: Vec<(Let, Span)>,
}

impl<'b> Inliner<'b> {
    pub fn new(file: &File, budget: &'b mut Budget) -> Inliner<'b> {
        let mut functions = HashMap::new();
        for own in of_kind!(file.items.iter(), ItemKind::Function) {
            let name = own.name.text.clone();
            functions
                .entry(name)
                .or_insert_with(|| Arc::new(own.clone()));
        }
        let mut calls = HashMap::new();
        // Statements of earlier calls are in a file that was printed, or to which an effect is applied.
        for name in file.declared() {
            if let Some((function, rest)) = name.split_once("__") {
                let number = rest.split('_').next().and_then(|own| own.parse().ok());
                let last: &mut u32 = calls.entry(function.to_owned()).or_default();
                *last = (*last).max(number.unwrap_or(0));
            }
        }
        let mut inliner = Inliner {
            functions,
            calls,
            budget,
            diagnostics: Vec::new(),
            added: Vec::new(),
        };
        inliner.recursion(file);
        inliner
    }

    pub fn finish(self) -> Vec<Diagnostic> {
        self.diagnostics
    }

    /// The statements without calls; `None` if there is none, or if functions have errors.
    pub fn items(&mut self, items: &[Item]) -> Option<Vec<Item>> {
        let has_calls = |item: &Item| {
            let is_function = matches!(item.kind, ItemKind::Function(_));
            !is_function && item.kind.roots().iter().any(|root| self.has_calls(root))
        };
        let called: Vec<bool> = items.iter().map(has_calls).collect();
        if !called.contains(&true) || !self.diagnostics.is_empty() {
            return None;
        }
        let mut out = Vec::with_capacity(items.len());
        for (item, is_called) in items.iter().zip(called) {
            if is_called && self.budget.fault.is_none() {
                out.push(self.item(item));
            } else {
                out.push(vec![item.clone()]);
            }
        }
        Some(merged(out))
    }

    fn has_calls(&self, e: &Expr) -> bool {
        self.calls_in(e).next().is_some()
    }

    /// Calls of functions of the file in an expression: the name of each function, with the span of the call.
    fn calls_in<'e>(&self, e: &'e Expr) -> impl Iterator<Item = (&'e str, Span)> {
        e.nodes().filter_map(|part| match &part.kind {
            ExprKind::Call(name, _) if self.functions.contains_key(&name.text) => {
                Some((name.text.as_str(), part.span))
            }
            _ => None,
        })
    }

    fn item(&mut self, item: &Item) -> Vec<Item> {
        let mut own = written_out(item.clone());
        for root in own.kind.roots_mut() {
            self.expression(root);
            if height(root) > MAX_HEIGHT {
                let message = format!(
                    "with its functions written out, this expression has more than {MAX_HEIGHT} operations in a row"
                );
                let fault = Diagnostic::new(Kind::Limit, root.span, message);
                let help = "give parts of it names with `let`";
                self.diagnostics.push(fault.help(help));
            }
        }
        let added = std::mem::take(&mut self.added).into_iter();
        let mut items: Vec<(Item, Option<Span>)> = added
            .map(|(own, call)| {
                let kind = ItemKind::Let(own);
                let effect = item.effect;
                let made = Item {
                    effect,
                    ..Item::new(kind, "", call)
                };
                (made, Some(call))
            })
            .collect();
        items.push((own, None));
        of_template(item.clone(), items)
    }

    /// Replaces the calls in an expression, arguments first.
    fn expression(&mut self, e: &mut Expr) {
        for child in e.children_mut() {
            self.expression(child);
        }
        if self.budget.fault.is_some() {
            return;
        }
        let ExprKind::Call(name, arguments) = &mut e.kind else {
            return;
        };
        let Some(function) = self.functions.get(&name.text).cloned() else {
            return;
        };
        let arguments = std::mem::take(arguments);
        if arguments.len() != function.parameters.len() {
            let fault = wrong_count(&function, arguments.len(), e.span);
            self.diagnostics.push(fault);
            return;
        }
        let number = self.calls.entry(name.text.clone()).or_default();
        *number += 1;
        let prefix = format!("{}__{number}_", name.text);
        let mut names: HashMap<&str, String> = HashMap::new();
        for (parameter, argument) in function.parameters.iter().zip(arguments) {
            let ascription = function.of_argument(parameter);
            let span = argument.span;
            let kind = ExprKind::Ascribed(Box::new(argument), Arc::new(ascription));
            let local = Name::new(prefix.clone() + &parameter.name.text, parameter.name.span);
            names.insert(&parameter.name.text, local.text.clone());
            self.add(local, None, Expr { kind, span }, e.span);
        }
        for own in &function.lets {
            let value = self.copy(&own.value, &names, e.span);
            let local = Name::new(prefix.clone() + &own.name.text, own.name.span);
            names.insert(&own.name.text, local.text.clone());
            self.add(local, own.unit.clone(), value, e.span);
        }
        let result = self.copy(&function.value, &names, e.span);
        e.kind = ExprKind::Ascribed(Box::new(result), Arc::new(function.of_result()));
    }

    fn add(
        &mut self,
        name: Name,
        unit: Option<crate::syntax::ast::UnitExpr>,
        value: Expr,
        call: Span,
    ) {
        self.added.push((Let::new(name, unit, value), call));
    }

    /// Copy of an expression of a function with the names of this call, and without calls.
    fn copy(&mut self, e: &Expr, names: &HashMap<&str, String>, call: Span) -> Expr {
        let mut own = e.clone();
        if self.budget.spend(own.nodes().count(), call) {
            rename(&mut own, names);
            self.expression(&mut own);
        }
        own
    }

    /// Reports functions that call themselves, and those that call one another too deeply.
    fn recursion(&mut self, file: &File) {
        let mut finished: HashSet<String> = HashSet::new();
        for function in of_kind!(file.items.iter(), ItemKind::Function) {
            let mut path = vec![(function.name.text.clone(), function.name.span)];
            if let Some(fault) = self.deeper(&mut path, &mut finished) {
                self.diagnostics.push(fault);
                return;
            }
        }
    }

    /// The error of the functions that the last one of `path` calls, each with the span of its call.
    fn deeper(
        &self,
        path: &mut Vec<(String, Span)>,
        finished: &mut HashSet<String>,
    ) -> Option<Diagnostic> {
        let (name, at) = path.last()?.clone();
        if finished.contains(&name) {
            return None;
        }
        if path.len() > MAX_DEPTH {
            let message = format!("functions call one another more than {MAX_DEPTH} deep");
            return Some(Diagnostic::new(Kind::Limit, at, message));
        }
        let function = Arc::clone(self.functions.get(&name)?);
        let values = function.lets.iter().map(|own| &own.value);
        let values = values.chain([&function.value]);
        for (called, span) in values.flat_map(|value| self.calls_in(value)) {
            if let Some(start) = path.iter().position(|own| own.0 == called) {
                return Some(self.cycle(&path[start..], span));
            }
            path.push((called.to_owned(), span));
            let fault = self.deeper(path, finished);
            path.pop();
            if fault.is_some() {
                return fault;
            }
        }
        finished.insert(name);
        None
    }

    fn cycle(&self, cycle: &[(String, Span)], last: Span) -> Diagnostic {
        let first = &cycle[0].0;
        let names: Vec<&str> = { cycle.iter().map(|own| own.0.as_str()) }
            .chain([first.as_str()])
            .collect();
        let message = match cycle.len() {
            1 => format!("the function `{first}` calls itself"),
            _ => format!(
                "these functions call one another in a circle: `{}`",
                names.join("` → `")
            ),
        };
        let spans = cycle.iter().skip(1).map(|own| own.1).chain([last]);
        let mut fault = Diagnostic::new(Kind::Cycle, last, message);
        for (span, pair) in spans.zip(names.windows(2)) {
            fault = fault.label(span, format!("`{}` calls `{}`", pair[0], pair[1]));
        }
        fault.help("a function is written out at each call, so that it cannot call itself")
    }
}

/// Error of a call with `found` arguments.
pub(crate) fn wrong_count(function: &Function, found: usize, call: Span) -> Diagnostic {
    let (name, expected) = (&function.name.text, function.parameters.len());
    let plural = if expected == 1 { "" } else { "s" };
    let message = format!("`{name}` takes {expected} argument{plural}, but this call has {found}");
    let parameters = listed(&function.parameters);
    let label = format!("`{name}({parameters})` is declared here");
    Diagnostic::new(Kind::Shape, call, message).label(function.name.span, label)
}

fn rename(e: &mut Expr, names: &HashMap<&str, String>) {
    if let ExprKind::Name(name) = &mut e.kind {
        if let Some(own) = names.get(name.as_str()) {
            name.clone_from(own);
        }
        return;
    }
    for child in e.children_mut() {
        rename(child, names);
    }
}

/// Joins the statements of each item. What was written as one array, and had calls in its elements, stays one template.
fn merged(groups: Vec<Vec<Item>>) -> Vec<Item> {
    let mut out: Vec<Item> = Vec::new();
    let mut groups = groups.into_iter().peekable();
    while let Some(mut group) = groups.next() {
        let Some(array) = array_of(&group) else {
            out.append(&mut group);
            continue;
        };
        while let Some(next) = groups.next_if(|next| array_of(next).is_some_and(|own| own == array))
        {
            group.extend(next);
        }
        let items = group.into_iter().map(|item| {
            let call = item.expanded.as_ref().and_then(|own| own.call);
            (item, call)
        });
        out.extend(of_template(array, items.collect()));
    }
    out
}

/// The array or sum in the text that a statement with calls stood for, before these were replaced.
fn array_of(group: &[Item]) -> Option<Item> {
    let own = group.last()?.expanded.as_ref()?;
    let written = &own.from.written;
    let before = written.expanded.as_ref()?;
    Some(before.from.written.clone())
}
