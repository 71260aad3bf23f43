//! Error messages about units, which state the unit of each operand and the declarations that determine it.

use super::term::Term;
use super::{Checker, Typed, UnitOf};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{Expr, ExprKind, Shape};
use crate::syntax::ast::{self, BinaryOp};
use crate::unit::{Unit, symbol};

const MAX_LABELS: usize = 8;

const MAX_LEAVES: usize = 64;

struct Leaf {
    name: String,
    term: Term,
    /// Source span of the name's declaration, or of the literal.
    span: Span,
    /// Whether the operand is declared in the file; `false` for literals and predefined names.
    declared: bool,
}

/// Span of the parts of an expression if it begins and ends beyond them.
fn narrowed(span: Span, parts: impl Iterator<Item = Span>) -> Span {
    let all = parts.reduce(|all, part| Span {
        start: all.start.min(part.start),
        end: all.end.max(part.end),
        ..all
    });
    all.filter(|all| span.start < all.start && all.end < span.end)
        .unwrap_or(span)
}

impl Checker<'_> {
    /// Description of a unit for messages, such as `a force (N = kg·m/s²)`.
    pub fn described(&self, term: &Term) -> String {
        self.described_as(term, false)
    }

    fn described_as(&self, term: &Term, many: bool) -> String {
        let term = self.units.resolve(term);
        let Some(unit) = term.unit() else {
            let known = term.known_part().unit().unwrap_or_default();
            let unknown: Vec<String> = term
                .unknowns()
                .map(|u| format!("`{}`", self.units.name(u)))
                .collect();
            return format!(
                "{} with the still unknown unit of {}",
                known.tidy().pretty(),
                unknown.join(" and ")
            );
        };
        match unit.quantity() {
            Some(("a pure number", ..)) if unit == Unit::ONE && many => "pure numbers".to_owned(),
            Some(("a pure number", ..)) if unit == Unit::ONE => "a pure number".to_owned(),
            Some((_, noun)) if many => format!("{noun} ({})", unit.explained()),
            Some((noun, _)) => format!("{noun} ({})", unit.explained()),
            None => format!("in {}", unit.explained()),
        }
    }

    /// Text of a unit, such as `m/s`, or `still unknown` if it is not yet inferred.
    fn symbol_of(&self, term: &Term) -> String {
        match self.units.resolve(term).unit() {
            Some(unit) => unit.tidy().pretty(),
            None => "still unknown".to_owned(),
        }
    }

    /// Error for expressions of unequal units; a group has the indices of those with one unit.
    pub fn mismatch(
        &mut self,
        terms: &[Typed],
        groups: &[Vec<usize>],
        span: Span,
        rule: &str,
    ) -> Diagnostic {
        let sides: Vec<String> = groups
            .iter()
            .map(|group| {
                let names: Vec<String> = group
                    .iter()
                    .map(|&i| self.text(terms[i].expr.span))
                    .collect();
                let verb = if group.len() > 1 { "are" } else { "is" };
                let what = self.described_as(&term_of(&terms[group[0]]), group.len() > 1);
                format!("{} {verb} {what}", crate::diagnostic::listed(&names))
            })
            .collect();
        let sides = sides.join(if sides.len() == 2 { ", but " } else { "; " });
        let message = format!("{rule}: {sides}");
        let unequal = groups.iter().flatten().map(|&i| terms[i].expr.span);
        // The terms that a sum over an index is made of stand within it.
        let span = match self.text(span).starts_with("sum") {
            true => narrowed(span, unequal),
            false => span,
        };
        let mut fault = Diagnostic::new(Kind::Unit, span, message);
        if self.is_reported(&fault) {
            return fault;
        }
        for group in groups {
            for &i in group {
                let what = self.described(&term_of(&terms[i]));
                fault = fault.label(terms[i].expr.span, what);
            }
        }
        let firsts: Vec<&Typed> = groups.iter().map(|g| &terms[g[0]]).collect();
        fault = self.origins(fault, &firsts);
        let advice = self.advice(terms, groups);
        fault.help_if(advice)
    }

    /// Requires the unit `expected`, else reports an error that begins with `rule`; returns whether it fits.
    pub fn must_be(&mut self, typed: &Typed, expected: &Term, rule: &str) -> bool {
        let UnitOf::Term(found) = &typed.unit else {
            return !matches!(typed.unit, UnitOf::Faulty);
        };
        let span = typed.expr.span;
        if self.units.equate(found, expected, span).is_ok() {
            return true;
        }
        let is = self.described(found);
        let message = format!("{rule}, but `{}` is {is}", self.text(span));
        let fault = Diagnostic::new(Kind::Unit, span, message).label(span, is);
        if self.is_reported(&fault) {
            self.report(fault);
            return false;
        }
        let mut fault = self.origins(fault, &[typed]);
        if let (Some(found), Some(expected)) = (
            self.units.resolve(found).unit(),
            self.units.resolve(expected).unit(),
        ) {
            let advice = self.missing_factor(typed, found, expected);
            fault = fault.help_if(advice);
        }
        self.report(fault);
        false
    }

    fn origins(&mut self, mut fault: Diagnostic, sides: &[&Typed]) -> Diagnostic {
        self.suspect_unitless(fault.span, sides);
        let mut shown: Vec<Span> = Vec::new();
        for side in sides {
            let mut leaves = Vec::new();
            self.leaves(&side.expr, &mut leaves);
            // Dimensionless operands do not affect the unit.
            let is_pure = |term: &Term| self.units.resolve(term).unit().is_some_and(Unit::is_pure);
            leaves.retain(|leaf| !is_pure(&leaf.term));
            let alone = matches!(&leaves[..], [leaf] if leaf.name == self.text(side.expr.span));
            if !alone && !leaves.is_empty() {
                let part = |l: &Leaf| format!("`{}` in {}", l.name, self.symbol_of(&l.term));
                let parts: Vec<String> = leaves.iter().map(part).collect();
                let text = self.text(side.expr.span);
                fault = fault.note(format!("in `{text}`: {}", parts.join(", ")));
            }
            for leaf in leaves {
                if !leaf.declared {
                    if !alone {
                        fault = self.unit_or_name(fault, &leaf);
                    }
                } else if shown.len() < MAX_LABELS
                    && !shown.contains(&leaf.span)
                    && leaf.span != fault.span
                {
                    shown.push(leaf.span);
                    let mut text = format!("`{}` is {}", leaf.name, self.described(&leaf.term));
                    let determined = leaf
                        .term
                        .unknowns()
                        .find_map(|u| self.units.determined_at(u));
                    if let Some(at) = determined {
                        text += &format!(", as follows from `{}`", self.text(at));
                    }
                    fault = fault.label(leaf.span, text);
                    let items = self.searched().iter();
                    let is_own = |name: &ast::Name| name.span == leaf.span;
                    let own = { items }.find(|item| item.kind.declared().is_some_and(is_own));
                    let values = own.map_or_else(Vec::new, |item| item.kind.roots());
                    if let Some(note) = values
                        .into_iter()
                        .flat_map(ast::Expr::nodes)
                        .find_map(|e| self.cut_unit(e))
                    {
                        fault = fault.note(note);
                    }
                }
            }
        }
        fault
    }

    /// Notes at a literal such as `2 g`, where a variable `g` is declared, that it means two grams.
    fn unit_or_name(&self, fault: Diagnostic, leaf: &Leaf) -> Diagnostic {
        match leaf.name.split_once(' ') {
            Some((number, symbol)) if self.scope.find(symbol).is_some() => fault
                .note(format!(
                    "a name behind a number is its unit: `{}` is {}",
                    leaf.name,
                    self.described(&leaf.term)
                ))
                .help(format!(
                    "if the quantity `{symbol}` is meant, write `{number}*{symbol}`"
                )),
            _ => fault,
        }
    }

    /// Note at `40 kg*m^2`, where a quantity `m` is declared, that the unit ends before it.
    fn cut_unit(&self, e: &ast::Expr) -> Option<String> {
        let ast::ExprKind::Binary(BinaryOp::Mul | BinaryOp::Div | BinaryOp::Dot, a, b) = &e.kind
        else {
            return None;
        };
        let name = power_of_name(b).filter(|name| symbol::find(name).is_some())?;
        let number = last_number(a)?;
        let (start, from) = (number.span, number.unit.as_ref()?.span);
        let [whole, first] = [e.span, start].map(|end| self.text(start.to(end)));
        let [digits, unit] =
            [(start, number.number.span), (from, e.span)].map(|(from, to)| self.text(from.to(to)));
        Some(format!(
            "`{whole}` is `{first}` times the quantity `{name}`: with a unit of several factors write `{digits} [{unit}]`"
        ))
    }

    /// Name, place and unit of the declared quantity that a leaf of an expression is; no unit if it has an error.
    pub fn declared(&self, leaf: &ExprKind) -> Option<(&str, Span, Option<&Term>)> {
        let model = &self.model;
        Some(match leaf {
            ExprKind::Param(i) => {
                let own = &model.params[*i];
                (&own.name, own.span, Some(&self.params[*i]))
            }
            ExprKind::Coefficient(i) => {
                let own = &model.coefficients[*i];
                (&own.name, own.span, Some(&self.coefficients[*i]))
            }
            ExprKind::State(i) => {
                let own = &model.states[*i];
                (&own.name, own.span, Some(&self.states[*i]))
            }
            ExprKind::Input(i) => {
                let own = &model.inputs[*i];
                (&own.name, own.span, Some(&self.inputs[*i]))
            }
            ExprKind::AuxVariable(i) => {
                let own = &model.aux_variables[*i];
                let term = match &self.variables[*i].unit {
                    UnitOf::Term(term) => Some(term),
                    _ => None,
                };
                (&own.name, own.span, term)
            }
            _ => return None,
        })
    }

    /// Appends to `out` the operands (names and literals) of an expression with their units, without duplicates.
    fn leaves(&self, e: &Expr, out: &mut Vec<Leaf>) {
        let written = |term: Term| (self.text(e.span), term, e.span, false);
        let (name, term, span, declared) = match &e.kind {
            ExprKind::Number { .. } => written(Term::known(e.unit)),
            ExprKind::Time => written(Term::known(Unit::SECOND)),
            ExprKind::Position | ExprKind::Marker => written(Term::known(Unit::METRE)),
            ExprKind::Velocity => written(Term::known(Unit::SPEED)),
            ExprKind::AngularVelocity => written(Term::known(Unit::RATE)),
            ExprKind::SpecificForce => written(Term::known(Unit::ACCELERATION)),
            ExprKind::AngularAcceleration => written(Term::known(Unit::ANGULAR_ACCELERATION)),
            kind => match self.declared(kind) {
                Some((name, span, Some(term))) => (name.to_owned(), term.clone(), span, true),
                Some((.., None)) => return,
                None => {
                    for child in e.children() {
                        self.leaves(child, out);
                    }
                    return;
                }
            },
        };
        if out.len() < MAX_LEAVES && !out.iter().any(|l| l.name == name) {
            out.push(Leaf {
                name,
                term,
                span,
                declared,
            });
        }
    }

    fn advice(&self, terms: &[Typed], groups: &[Vec<usize>]) -> Option<String> {
        let [a, b] = groups else { return None };
        // The unit of the group with more terms is assumed to be the expected one.
        let (odd, even) = if a.len() <= b.len() { (a, b) } else { (b, a) };
        let unit = |i: usize| self.units.resolve(&term_of(&terms[i])).unit();
        self.missing_factor(&terms[odd[0]], unit(odd[0])?, unit(even[0])?)
    }

    fn missing_factor(&self, typed: &Typed, found: Unit, expected: Unit) -> Option<String> {
        let text = self.text(typed.expr.span);
        let excess = found.checked_div(expected)?;
        let mut leaves = Vec::new();
        self.leaves(&typed.expr, &mut leaves);
        let has = |term: &Term, unit: Unit| {
            let own = self.units.resolve(term).unit();
            own.is_some_and(|own| own.agrees(unit))
        };
        let compound = leaves.len() > 1;
        if compound && let Some(leaf) = leaves.iter().find(|l| l.declared && has(&l.term, excess)) {
            let noun = self.described(&Term::known(expected));
            return Some(format!(
                "without `{}` ({}) the term `{text}` would be {noun}",
                leaf.name,
                excess.tidy().pretty()
            ));
        }
        let inverse = excess.checked_powi(-1)?;
        let params = self.model.params.iter().zip(&self.params);
        for (param, term) in params {
            // A quantity over itself is 1, whatever it is.
            if has(term, excess) && param.name != text {
                return Some(format!(
                    "divided by `{}` ({}) it would agree: `{}`",
                    param.name,
                    excess.tidy().pretty(),
                    self.quotient_text(typed, &param.name)
                ));
            }
            if has(term, inverse) {
                return Some(multiplied_by(&param.name, inverse));
            }
        }
        let named = self.model.aux_variables.iter().zip(&self.variables);
        for (variable, own) in named.filter(|(v, _)| v.value.shape == Shape::Scalar) {
            let UnitOf::Term(term) = &own.unit else {
                continue;
            };
            if has(term, inverse) {
                return Some(multiplied_by(&variable.name, inverse));
            }
        }
        None
    }

    fn quotient_text(&self, typed: &Typed, by: &str) -> String {
        let text = self.text(typed.expr.span);
        match typed.expr.kind {
            ExprKind::Add(..) | ExprKind::Sub(..) if !text.starts_with('(') => {
                format!("({text})/{by}")
            }
            _ => format!("{text}/{by}"),
        }
    }
}

/// The name in `m` or `m^2`.
fn power_of_name(e: &ast::Expr) -> Option<&str> {
    match &e.kind {
        ast::ExprKind::Name(name) => Some(name),
        ast::ExprKind::Binary(BinaryOp::Pow, base, _) => power_of_name(base),
        _ => None,
    }
}

/// The number with which a product ends.
fn last_number(e: &ast::Expr) -> Option<&ast::Quantity> {
    match &e.kind {
        ast::ExprKind::Number(own) => Some(own),
        ast::ExprKind::Binary(BinaryOp::Mul | BinaryOp::Div | BinaryOp::Dot, _, b) => {
            last_number(b)
        }
        _ => None,
    }
}

fn multiplied_by(name: &str, unit: Unit) -> String {
    let unit = unit.tidy().pretty();
    format!("multiplied by `{name}` ({unit}) it would agree")
}

fn term_of(typed: &Typed) -> Term {
    match &typed.unit {
        UnitOf::Term(term) => term.clone(),
        _ => Term::one(),
    }
}
