//! Declarations without a unit. Their values are dimensionless. If that may have caused a unit error, a second run of
//! the checker infers their units, and the error then shows the declarations with the units that they would need.

use std::collections::HashMap;

use super::term::Term;
use super::{Checker, Typed};
use crate::diagnostic::{Fix, Kind, Label, MAX_SHOWN, Span};
use crate::model::{Expr, ExprKind};
use crate::syntax::ast::{Item, ItemKind, Name, UnitExpr};
use crate::unit::Unit;

const MAX_SUGGESTED: usize = 3;

/// Declarations without a unit, each identified by the source span of the declared name.
#[derive(Default)]
pub(super) struct Unitless {
    /// Whether the unit of a declaration without a unit is an unknown to be inferred (`true`) or 1 (`false`).
    infers: bool,
    /// Unit assumed for each declaration, by the span of its name: 1, or an unknown.
    terms: HashMap<Span, Term>,
    /// For each unit error, its span and the declarations that may have caused it.
    suspects: Vec<(Span, Vec<Span>)>,
}

impl Unitless {
    pub fn inferred() -> Unitless {
        Unitless {
            infers: true,
            ..Unitless::default()
        }
    }

    /// Unit assumed for the declaration of `name`.
    pub fn term(&self, name: Span) -> Term {
        self.terms.get(&name).cloned().unwrap_or_else(Term::one)
    }

    /// Whether any unit error found so far may be caused by a declaration without a unit.
    pub fn is_suspected(&self) -> bool {
        !self.suspects.is_empty()
    }
}

impl<'a> Checker<'a> {
    /// Records the declarations without a unit. Their unknowns come before those of `[?]`: `Units::equate` solves for
    /// the later of two, and `[?]` is to be determined first.
    pub fn declare_unitless(&mut self) {
        let file = self.file;
        for item in &file.items {
            let Some(declared) = Declared::of(item).filter(|d| d.unit.is_none()) else {
                continue;
            };
            let term = if self.unitless.infers {
                self.unknown_unit_of(&declared.name.text)
            } else {
                Term::one()
            };
            self.unitless.terms.insert(declared.name.span, term);
        }
    }

    /// Records the declarations without a unit on which the sides of a unit error depend.
    pub fn suspect_unitless(&mut self, fault: Span, sides: &[&Typed]) {
        if self.unitless.suspects.len() >= MAX_SHOWN || self.unitless.terms.is_empty() {
            return;
        }
        let mut names = Vec::new();
        let mut is_visited = vec![false; self.model.aux_variables.len()];
        let mut pending: Vec<usize> = Vec::new();
        for side in sides {
            self.unitless_operands(&side.expr, &mut pending, &mut names);
        }
        while let Some(i) = pending.pop() {
            if !std::mem::replace(&mut is_visited[i], true) {
                let definition = &self.model.aux_variables[i].value;
                self.unitless_operands(definition, &mut pending, &mut names);
            }
        }
        if !names.is_empty() {
            self.unitless.suspects.push((fault, names));
        }
    }

    pub fn suspect_declaration(&mut self, fault: Span, name: Span) {
        if !self.unitless.terms.contains_key(&name) {
            return;
        }
        match self.unitless.suspects.last_mut() {
            Some((span, names)) if *span == fault => names.push(name),
            _ => self.unitless.suspects.push((fault, vec![name])),
        }
    }

    /// Collects the declarations without a unit and the variables that an expression uses.
    fn unitless_operands(&self, e: &Expr, variables: &mut Vec<usize>, names: &mut Vec<Span>) {
        if let ExprKind::AuxVariable(i) = e.kind {
            // Those of a function that was checked are no longer there.
            variables.extend((i < self.model.aux_variables.len()).then_some(i));
            return;
        }
        let Some((_, name, _)) = self.declared(&e.kind) else {
            for child in e.children() {
                self.unitless_operands(child, variables, names);
            }
            return;
        };
        if self.unitless.terms.contains_key(&name) && !names.contains(&name) {
            names.push(name);
        }
    }

    /// Adds to unit errors the declarations that may have caused them, with the units inferred by `inferring`.
    pub fn suggest_units(&mut self, inferring: &Checker<'_>) {
        let remaining: Vec<Span> = inferring
            .diagnostics
            .iter()
            .filter(|d| d.kind == Kind::Unit)
            .map(|d| d.span)
            .collect();
        for (span, names) in std::mem::take(&mut self.unitless.suspects) {
            // An error that remains although these units are inferred has another cause.
            if remaining.contains(&span) {
                continue;
            }
            let needed: Vec<(Declared<'_>, Unit)> = names
                .iter()
                .filter_map(|name| {
                    let term = inferring.unitless.terms.get(name)?;
                    let unit = inferring.units.resolve(term).known_part().unit()?.tidy();
                    Some((self.declaration(*name)?, unit))
                })
                .filter(|(_, unit)| !unit.is_pure())
                .collect();
            let Some(help) = self.suggestion(&needed) else {
                continue;
            };
            let fault = self.diagnostics.iter_mut();
            if let Some(fault) = { fault }.find(|d| d.span == span && d.kind == Kind::Unit) {
                for (declared, _) in needed.iter().take(MAX_SUGGESTED) {
                    let name = declared.name;
                    let text = format!("`{}` has no unit here: a pure number", name.text);
                    fault.labels.push(Label {
                        span: name.span,
                        text,
                    });
                }
                if let [(declared, unit)] = &needed[..]
                    && let Some(end) = declared.end_of_value()
                {
                    let text = format!(" {}", written(*unit));
                    fault.fix = Some(Box::new(Fix { span: end, text }));
                }
                fault.help = Some(match fault.help.take() {
                    Some(other) => format!("{help}; or: {other}"),
                    None => help,
                });
            }
        }
    }

    fn declaration(&self, name: Span) -> Option<Declared<'a>> {
        let declared = self.file.items.iter().filter_map(Declared::of);
        { declared }.find(|d| d.name.span == name)
    }

    fn suggestion(&self, needed: &[(Declared<'_>, Unit)]) -> Option<String> {
        let listed = |texts: Vec<String>| texts.join(" and ");
        let shown = &needed[..needed.len().min(MAX_SUGGESTED)];
        let are: Vec<String> = shown
            .iter()
            .map(|(d, unit)| format!("`{}` would be needed in {}", d.name.text, unit.pretty()))
            .collect();
        let lines: Vec<String> = shown
            .iter()
            .map(|(d, unit)| format!("`{}`", d.with_unit(*unit)))
            .collect();
        (!shown.is_empty()).then(|| {
            format!(
                "{}, but a number without a unit is a pure number: write {}",
                listed(are),
                listed(lines)
            )
        })
    }
}

struct Declared<'a> {
    item: &'a ItemKind,
    name: &'a Name,
    unit: Option<&'a UnitExpr>,
}

impl<'a> Declared<'a> {
    /// Interprets a statement as a declaration of a parameter, state or input; `None` for other statements.
    fn of(item: &'a Item) -> Option<Declared<'a>> {
        let (name, unit) = match &item.kind {
            ItemKind::Parameter(p) => (&p.name, &p.value.unit),
            ItemKind::State(s) => (&s.name, &s.value.unit),
            ItemKind::Input(i) => (&i.name, &i.unit),
            _ => return None,
        };
        Some(Declared {
            item: &item.kind,
            name,
            unit: unit.as_ref(),
        })
    }

    /// Empty span behind the default value, where its unit belongs; `None` for an input vector.
    fn end_of_value(&self) -> Option<Span> {
        let value = match self.item {
            ItemKind::Parameter(p) => p.value.span,
            ItemKind::State(s) => s.value.span,
            _ => return None,
        };
        Some(value.behind())
    }

    /// Source text of the declaration with `unit` added.
    fn with_unit(&self, unit: Unit) -> String {
        let unit = Some(written(unit));
        let mut item = self.item.clone();
        match &mut item {
            ItemKind::Parameter(p) => p.value.unit = unit,
            ItemKind::State(s) => s.value.unit = unit,
            ItemKind::Input(i) => i.unit = unit,
            _ => {}
        }
        item.to_string()
    }
}

/// Unit expression for model files, by symbol if the unit has one, such as `N`.
fn written(unit: Unit) -> UnitExpr {
    let span = Span::default();
    match unit.named() {
        Some(symbol) if symbol.chars().all(char::is_alphabetic) => UnitExpr::symbol(symbol, span),
        _ => UnitExpr::of(unit, span),
    }
}
