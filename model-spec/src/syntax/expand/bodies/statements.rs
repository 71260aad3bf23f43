//! Statements that are made for a body, out of texts of formulas.

use super::on_body;
use crate::location::Span;
use crate::syntax::ast::{
    Balance, Equation, Expr, ExprKind, Item, ItemKind, Let, Limit, Load, LoadClass, Name, Quantity,
    State, UnitExpr,
};
use crate::syntax::body_parts::Triple;
use crate::syntax::parser::Parser;
use crate::unit::Unit;

/// A statement, and the span by which it is hidden from tables and reports.
pub type Statement = (Item, Option<Span>);

/// Statements that are being made for a body, all at its name.
pub struct Statements {
    span: Span,
    pub list: Vec<Statement>,
}

impl Statements {
    pub fn at(span: Span) -> Self {
        let list = Vec::new();
        Self { span, list }
    }

    fn push(&mut self, kind: ItemKind, is_hidden: bool) {
        let item = Item::new(kind, "", self.span);
        self.list.push((item, is_hidden.then_some(self.span)));
    }

    pub fn states(&mut self, (names, _, initial): Triple<'_>, unit: Unit) {
        for (k, name) in names.iter().enumerate() {
            let value = match initial {
                Some(initial) => Quantity {
                    number: initial.values[k].clone(),
                    unit: initial.unit.clone(),
                    span: initial.span,
                },
                None => Quantity::new("0", Some(UnitExpr::of(unit, name.span)), name.span),
            };
            self.state(name, value);
        }
    }

    pub fn state(&mut self, name: &Name, value: Quantity) {
        let name = name.clone();
        self.push(ItemKind::State(State { name, value }), false);
    }

    pub fn vector(&mut self, name: String, (names, frame, _): Triple<'_>) {
        let [x, y, z] = names.each_ref().map(|name| name.text.as_str());
        let value = format!("({x}, {y}, {z}) in {}", frame.text);
        self.formula(name, &value, false);
    }

    pub fn quantity(&mut self, name: String, unit: Unit, value: Expr) {
        let own = self.definition(name, Some(unit), value);
        self.push(ItemKind::Let(own), false);
    }

    pub fn formula(&mut self, name: String, value: &str, is_hidden: bool) {
        let own = self.definition(name, None, expression(value, self.span));
        self.push(ItemKind::Let(own), is_hidden);
    }

    pub fn constant(&mut self, name: String, unit: Unit, value: Expr) {
        let is_hidden = name.contains("__");
        let own = Let {
            is_constant: true,
            ..self.definition(name, Some(unit), value)
        };
        self.push(ItemKind::Let(own), is_hidden);
    }

    fn definition(&self, name: String, unit: Option<Unit>, value: Expr) -> Let {
        let unit = unit.map(|unit| UnitExpr::of(unit, self.span));
        Let::new(Name::new(name, self.span), unit, value)
    }

    pub fn load(&mut self, body: &str, load: &Load, item: &Item) {
        let unit = match load.class {
            LoadClass::Force => Unit::NEWTON,
            LoadClass::Moment => Unit::NEWTON_METRE,
        };
        let span = load.name.span;
        let own = Let {
            name: Name::new(on_body(load, body), span),
            ..self.definition(String::new(), Some(unit), load.value.clone())
        };
        let made = Item::new(ItemKind::Let(own), item.doc.clone(), item.span);
        self.list.push((
            Item {
                effect: item.effect,
                ..made
            },
            None,
        ));
    }

    pub fn equation(&mut self, state: &Name, value: &str) {
        let value = expression(value, self.span);
        let state = state.clone();
        self.push(ItemKind::Equation(Equation { state, value }), false);
    }

    pub fn positive(&mut self, value: &str, reason: String) {
        self.limit(value, "0", reason);
    }

    pub fn limit(&mut self, value: &str, bound: &str, reason: String) {
        let limit = Limit {
            value: expression(value, self.span),
            bound: Quantity::new(bound, None, self.span),
            reason,
        };
        self.push(ItemKind::Limit(limit), false);
    }

    pub fn claim(&mut self, quantity: &str, change: &str) {
        let [quantity, change] = [quantity, change].map(|text| expression(text, self.span));
        self.push(ItemKind::Balance(Balance { quantity, change }), false);
    }
}

/// The expression of a text made of names, all of which stands at `span`.
pub fn expression(text: &str, span: Span) -> Expr {
    let mut parser = Parser::new(text, span.source);
    // The text itself is no name that a model has: what cannot be read is reported.
    let mut e = parser.expr().unwrap_or_else(|_| Expr::name(text, span));
    place(&mut e, span);
    e
}

fn place(e: &mut Expr, span: Span) {
    e.span = span;
    match &mut e.kind {
        ExprKind::Components(_, name) | ExprKind::Call(name, _) | ExprKind::Derivative(name) => {
            name.span = span;
        }
        _ => {}
    }
    for child in e.children_mut() {
        place(child, span);
    }
}
