//! Writing out of arrays, elements and sums: each value of an index becomes a number.

use std::collections::HashSet;

use super::{Budget, height, of_template};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::syntax::ast::{Array, BinaryOp, Expr, ExprKind, Index, Item, ItemKind, Name};
use crate::syntax::{MAX_ELEMENTS, MAX_HEIGHT, element_name};

pub(super) struct Unroller<'b> {
    /// Names that an index cannot have.
    taken: HashSet<String>,
    /// Indices in scope with their values, the innermost last.
    scope: Vec<(String, u32)>,
    budget: &'b mut Budget,
    diagnostics: Vec<Diagnostic>,
}

impl<'b> Unroller<'b> {
    pub fn new(taken: HashSet<String>, budget: &'b mut Budget) -> Unroller<'b> {
        Unroller {
            taken,
            scope: Vec::new(),
            budget,
            diagnostics: Vec::new(),
        }
    }

    pub fn finish(self) -> Vec<Diagnostic> {
        self.diagnostics
    }

    fn report(&mut self, fault: Diagnostic) {
        if !self.diagnostics.contains(&fault) {
            self.diagnostics.push(fault);
        }
    }

    /// Statements that a statement expands to; itself if it has no index.
    pub fn item(&mut self, mut item: Item) -> Vec<Item> {
        if let ItemKind::Array(array) = &item.kind {
            let elements = self.elements(array, &item);
            return of_template(item, elements);
        }
        if !super::has_indices(&item.kind) {
            return vec![item];
        }
        let written = item.clone();
        for root in item.kind.roots_mut() {
            self.root(root);
        }
        of_template(written, vec![(item, None)])
    }

    fn elements(&mut self, array: &Array, item: &Item) -> Vec<(Item, Option<Span>)> {
        let counts = array
            .indices
            .iter()
            .map(|index| index.values.clone().count());
        let count = counts.fold(1_usize, usize::saturating_mul);
        let Some(name) = array.statement.array_name() else {
            return Vec::new();
        };
        if count > MAX_ELEMENTS as usize {
            let message = format!(
                "the array `{}` has {count} elements; at most {MAX_ELEMENTS} are possible",
                name.text
            );
            self.report(Diagnostic::new(Kind::Limit, name.span, message));
            return Vec::new();
        }
        array.indices.iter().for_each(|index| self.is_free(index));
        let mut elements = Vec::with_capacity(count);
        let mut names = HashSet::new();
        for number in 0..count {
            let mut rest = number;
            let depth = self.scope.len();
            for index in array.indices.iter().rev() {
                let values = index.values.clone().count();
                let value = index.values.start() + (rest % values) as u32;
                self.scope.push((index.name.text.clone(), value));
                rest /= values;
            }
            let element = self.element(&name.text, &array.subscripts);
            if let Some(text) = element {
                if !names.insert(text.clone()) {
                    let message = format!("`{text}` is declared more than once by this array");
                    let fault = Diagnostic::new(Kind::Duplicate, name.span, message);
                    self.report(fault.help("use each index of `for` as an index of the name"));
                }
                elements.push((self.statement(array, item, number, text), None));
            }
            self.scope.truncate(depth);
            if self.budget.fault.is_some() {
                break;
            }
        }
        elements
    }

    /// Statement for the element `number` of an array, which is called `name`.
    fn statement(&mut self, array: &Array, item: &Item, number: usize, name: String) -> Item {
        let mut kind = ItemKind::clone(&array.statement);
        if let Some(own) = kind.array_name_mut() {
            own.text = name;
        }
        if let (ItemKind::Parameter(own), Some(value)) = (&mut kind, array.values.get(number)) {
            own.value.number.clone_from(value);
        }
        self.budget.spend(1, item.span);
        for root in kind.roots_mut() {
            self.root(root);
        }
        Item {
            kind,
            ..item.clone()
        }
    }

    /// Reports an index that has the name of a quantity.
    fn is_free(&mut self, index: &Index) {
        let Name { text, span } = &index.name;
        if self.taken.contains(text) {
            let message = format!("the index `{text}` has the name of a quantity");
            let fault = Diagnostic::new(Kind::Duplicate, *span, message);
            self.report(fault.help("choose another name for the index"));
        }
    }

    /// Writes out an expression that is not part of another one.
    pub fn root(&mut self, e: &mut Expr) {
        self.expression(e);
        if self.budget.fault.is_none() && height(e) > MAX_HEIGHT {
            let message = format!(
                "written out, this expression has more than {MAX_HEIGHT} operations in a row"
            );
            let fault = Diagnostic::new(Kind::Limit, e.span, message);
            self.report(fault.help("give parts of it names with `let`"));
        }
    }

    fn expression(&mut self, e: &mut Expr) {
        if !self.budget.spend(1, e.span) {
            return;
        }
        let written_out = match &mut e.kind {
            ExprKind::Name(name) => self.value(name).map(|value| number(value, e.span)),
            ExprKind::Element(array, subscripts) => {
                let name = self.element(array, subscripts);
                name.map(ExprKind::Name)
            }
            ExprKind::Sum(index, of) => {
                self.is_free(index);
                self.sum(index, of, e.span)
            }
            ExprKind::Call(name, arguments) if name.text == "der" => match &arguments[..] {
                [
                    Expr {
                        kind: ExprKind::Element(array, subscripts),
                        span,
                    },
                ] => {
                    let state = self.element(array, subscripts);
                    state.map(|state| ExprKind::Derivative(Name::new(state, *span)))
                }
                _ => {
                    for child in e.children_mut() {
                        self.expression(child);
                    }
                    None
                }
            },
            _ => {
                for child in e.children_mut() {
                    self.expression(child);
                }
                None
            }
        };
        if let Some(kind) = written_out {
            e.kind = kind;
        }
    }

    /// Sum over the values of an index, as a balanced tree of additions in their order.
    fn sum(&mut self, index: &Index, of: &Expr, span: Span) -> Option<ExprKind> {
        let mut terms = Vec::new();
        for value in index.values.clone() {
            self.scope.push((index.name.text.clone(), value));
            let mut term = of.clone();
            self.expression(&mut term);
            self.scope.pop();
            if self.budget.fault.is_some() {
                return None;
            }
            terms.push(term);
        }
        Some(added(terms, span)?.kind)
    }

    fn value(&self, index: &str) -> Option<u32> {
        let mut scope = self.scope.iter().rev();
        scope.find(|(name, _)| name == index).map(|own| own.1)
    }

    /// Name of an element; `None`, with an error reported, if a subscript is not a whole number.
    fn element(&mut self, array: &str, subscripts: &[Expr]) -> Option<String> {
        let mut values = Vec::with_capacity(subscripts.len());
        for subscript in subscripts {
            let value = self.subscript(subscript);
            match value {
                Some(value) if (0..=i64::from(u32::MAX)).contains(&value) => values.push(value),
                Some(value) => {
                    let message = format!("`{array}` has no element {value}");
                    let scope: Vec<String> = { self.scope.iter() }
                        .map(|(name, value)| format!("{name} = {value}"))
                        .collect();
                    let mut fault = Diagnostic::new(Kind::Value, subscript.span, message);
                    if !scope.is_empty() {
                        fault = fault.note(format!("for {}", scope.join(", ")));
                    }
                    self.report(fault);
                    return None;
                }
                None => {
                    let message = format!("`{subscript}` is not an index of `{array}`");
                    let fault = Diagnostic::new(Kind::Value, subscript.span, message);
                    self.report(fault.note(
                        "an index is made of whole numbers and of the indices of `for` and `sum`, as in `r[i + 1]`",
                    ));
                    return None;
                }
            }
        }
        Some(element_name(array, &values))
    }

    fn subscript(&self, e: &Expr) -> Option<i64> {
        match &e.kind {
            ExprKind::Number(own) if own.unit.is_none() => {
                own.number.text.parse::<u32>().ok().map(i64::from)
            }
            ExprKind::Name(name) => self.value(name).map(i64::from),
            ExprKind::Neg(of) => self.subscript(of)?.checked_neg(),
            ExprKind::Binary(op, a, b) => {
                let (a, b) = (self.subscript(a)?, self.subscript(b)?);
                match op {
                    BinaryOp::Add => a.checked_add(b),
                    BinaryOp::Sub => a.checked_sub(b),
                    BinaryOp::Mul | BinaryOp::Dot | BinaryOp::Cross => a.checked_mul(b),
                    BinaryOp::Div | BinaryOp::Pow => None,
                }
            }
            _ => None,
        }
    }
}

fn number(value: u32, span: Span) -> ExprKind {
    Expr::number(value.to_string(), span).kind
}

/// Sum of terms in their order, none if there are none.
pub(super) fn added(mut terms: Vec<Expr>, span: Span) -> Option<Expr> {
    if terms.len() < 2 {
        return terms.pop();
    }
    let second = terms.split_off(terms.len() / 2);
    let (a, b) = (added(terms, span)?, added(second, span)?);
    let kind = ExprKind::Binary(BinaryOp::Add, Box::new(a), Box::new(b));
    Some(Expr { kind, span })
}
