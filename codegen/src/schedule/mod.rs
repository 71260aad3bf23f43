//! Scheduling: translates SSA definitions to one-operation statements, in an order that hides latency.

mod contract_fma;
mod hoist;
mod list_schedule;
mod names;
pub(crate) mod pairs;

pub use hoist::Hoisted;
pub use names::Namer;

use crate::functions::{BinaryFunction, MathFunction};
use crate::graph::{ExprGraph, FastMap, Symbol};
use crate::program::{Binary, Op, Operand, Program, Statement, Unary};
use crate::ssa::{DefId, Signed, Ssa, SsaDef};
use hoist::HoistedNodes;
use model_spec::index::IndexVec;
use std::f64::consts::PI;

/// Orders the SSA definitions on which the roots depend as the statements of a program.
///
/// `results` contains names of the roots in order, and may be empty. If `hoisted` is given, expressions that depend
/// only on parameters are hoisted: they become results of `prepare`, which the program reads as inputs. If `None`, the
/// program computes these expressions.
pub fn schedule(
    ssa: &Ssa,
    graph: &mut ExprGraph,
    namer: &mut Namer,
    hoisted: Option<&mut Hoisted>,
    results: &[String],
) -> Program {
    for (&(minus, id), name) in ssa.roots.iter().zip(results) {
        if !minus {
            namer.suggest(ssa, graph, id, name);
        }
    }
    let order = ssa.order();
    let mut schedule = Schedule {
        uses: Uses::of(ssa, &order, hoisted.is_some()),
        ssa,
        values: ssa.side_table(None),
        program: Program {
            tables: graph.tables().clone(),
            ..Program::default()
        },
        graph,
        negated: FastMap::default(),
        namer,
        hoisted,
        hoisted_nodes: HoistedNodes::default(),
    };
    // High-latency definitions come first, with their operands, so that other work overlaps them.
    for &id in &order {
        if takes_long(&ssa.defs[id]) {
            schedule.emit(id);
        }
    }
    schedule.emit_roots(&order, results);
    list_schedule::list_schedule(contract_fma::contract_fma(schedule.program))
}

/// Whether a definition has high latency: a function call, a square root or a reciprocal.
fn takes_long(def: &SsaDef) -> bool {
    matches!(
        def,
        SsaDef::Call(..)
            | SsaDef::Call2(BinaryFunction::Atan2 | BinaryFunction::Table(_), ..)
            | SsaDef::Root(_)
            | SsaDef::Recip(_)
    )
}

struct Uses {
    /// Number of uses of each definition, as operand or root.
    count: IndexVec<DefId, u32>,
    is_root: IndexVec<DefId, bool>,
    /// Whether each definition is a factor of a product that is used and has at least two factors.
    in_product: IndexVec<DefId, bool>,
}

impl Uses {
    /// Counts the uses of each definition, without those in hoisted definitions.
    fn of(ssa: &Ssa, order: &[DefId], hoisting: bool) -> Uses {
        let mut uses = Uses {
            count: ssa.side_table(0),
            is_root: ssa.side_table(false),
            in_product: ssa.side_table(false),
        };
        for &(_, root) in &ssa.roots {
            uses.count[root] += 1;
            uses.is_root[root] = true;
        }
        for &id in order {
            if hoisting && ssa.facts[id].fixed {
                continue;
            }
            ssa.defs[id].for_operands(|operand| uses.count[operand] += 1);
        }
        for &id in order {
            if let SsaDef::Product(factors) = &ssa.defs[id]
                && factors.len() > 1
                && uses.count[id] > 0
            {
                factors
                    .iter()
                    .for_each(|&factor| uses.in_product[factor] = true);
            }
        }
        uses
    }
}

struct Schedule<'a> {
    ssa: &'a Ssa,
    graph: &'a mut ExprGraph,
    uses: Uses,
    values: IndexVec<DefId, Option<Operand>>,
    program: Program,
    /// For each definition whose negative has been computed, the operand with the value of the negative.
    negated: FastMap<DefId, Operand>,
    namer: &'a mut Namer,
    hoisted: Option<&'a mut Hoisted>,
    hoisted_nodes: HoistedNodes,
}

impl Schedule<'_> {
    /// Emits the definitions, and the roots, named `results`, as outputs.
    fn emit_roots(&mut self, order: &[DefId], results: &[String]) {
        let mut outputs: IndexVec<DefId, Vec<usize>> = self.ssa.side_table(Vec::new());
        for (k, &(_, root)) in self.ssa.roots.iter().enumerate() {
            outputs[root].push(k);
        }
        let mut operands = vec![None; self.ssa.roots.len()];
        for &id in order {
            self.emit(id);
            for &k in &outputs[id] {
                operands[k] = Some(self.root(self.ssa.roots[k], results.get(k)));
            }
        }
        // Every root is in the order, hence has an operand.
        self.program.outputs = operands.into_iter().flatten().collect();
        assert_eq!(self.program.outputs.len(), self.ssa.roots.len());
    }

    /// Operand of a hoisted definition; `None` if nothing is hoisted.
    fn hoist(&mut self, signed: Signed) -> Option<Operand> {
        let hoisted = self.hoisted.as_deref_mut()?;
        let operand = hoisted.operand(self.ssa, self.graph, &mut self.hoisted_nodes, signed);
        if let Operand::Prepared(slot) = operand
            && !signed.0
        {
            self.namer.give(signed.1, &hoisted.names()[slot as usize]);
        }
        Some(operand)
    }

    fn is_hoisted(&self, id: DefId) -> bool {
        self.hoisted.is_some() && self.ssa.facts[id].fixed
    }

    /// Emits the statements that compute the definition `id`, after those of its operands, unless already emitted.
    fn emit(&mut self, id: DefId) {
        if self.values[id].is_some() {
            return;
        }
        let def = &self.ssa.defs[id];
        let is_leaf = matches!(def, SsaDef::Leaf(_) | SsaDef::Constant(_));
        if !is_leaf && self.is_hoisted(id) {
            // A value that only hoisted expressions use needs no slot.
            if self.uses.count[id] > 0 {
                self.values[id] = self.hoist((false, id));
            }
        } else if !self.divides(id) {
            self.values[id] = Some(self.operation(def, id));
        }
    }

    fn operation(&mut self, def: &SsaDef, id: DefId) -> Operand {
        match def {
            SsaDef::Leaf(symbol) => leaf(*symbol),
            SsaDef::Constant(number) => Operand::Constant(number.value()),
            SsaDef::Sum(terms) => self.sum(terms, id),
            SsaDef::Product(factors) => self.product(factors, id),
            SsaDef::Root(x) => self.unary(Unary::Call(MathFunction::Sqrt), (false, *x), id),
            SsaDef::Recip(x) if self.ssa.facts[*x].nonzero => {
                self.unary(Unary::Recip, (false, *x), id)
            }
            SsaDef::Recip(x) => self.unary(Unary::RecipOrZero, (false, *x), id),
            SsaDef::Call(function, x) => self.unary(Unary::Call(*function), *x, id),
            SsaDef::Call2(function, a, b) => {
                let op = Op::Binary(Binary::Call(*function), self.signed(*a), self.signed(*b));
                self.finish(op, id)
            }
            SsaDef::IfZero(c, a, b) => {
                let (c, a, b) = (self.value(*c), self.signed(*a), self.signed(*b));
                self.finish(Op::IfZero(c, a, b), id)
            }
        }
    }

    /// Whether a reciprocal is emitted as a division: nonzero, and used by one product.
    fn divides(&self, id: DefId) -> bool {
        let SsaDef::Recip(x) = self.ssa.defs[id] else {
            return false;
        };
        self.uses.count[id] == 1
            && self.ssa.facts[x].nonzero
            && !self.uses.is_root[id]
            && !self.is_hoisted(id)
            && self.uses.in_product[id]
    }

    fn value(&mut self, id: DefId) -> Operand {
        self.emit(id);
        self.values[id]
            .expect("a value that is used is emitted, and divisors are used by products alone")
    }

    fn push(&mut self, op: Op) -> Operand {
        self.push_named(op, None, None)
    }

    fn push_named(&mut self, op: Op, name: Option<String>, about: Option<usize>) -> Operand {
        self.program.statements.push(Statement { op, name, about });
        Operand::Temp(self.program.statements.len() as u32 - 1)
    }

    /// Emits the last operation of a definition and gives its statement the name of the definition.
    fn finish(&mut self, op: Op, id: DefId) -> Operand {
        let (ssa, graph) = (self.ssa, &*self.graph);
        let is_arithmetic = matches!(
            op,
            Op::Binary(Binary::Add | Binary::Sub | Binary::Mul | Binary::Div, ..)
        );
        let named = self.namer.has_own_name(ssa, graph, id);
        let about = self.namer.about(ssa, graph, id);
        let name = (named || self.uses.count[id] > 1 || !is_arithmetic)
            .then(|| self.namer.name(ssa, graph, id));
        self.push_named(op, name, about)
    }

    fn signed(&mut self, (minus, id): Signed) -> Operand {
        let value = self.value(id);
        self.negate_if(minus, value, id)
    }

    fn negate_if(&mut self, minus: bool, value: Operand, id: DefId) -> Operand {
        match value {
            _ if !minus => value,
            Operand::Constant(c) => Operand::Constant(-c),
            Operand::Prepared(_) => self.hoist((true, id)).unwrap_or(value),
            _ => {
                if let Some(&known) = self.negated.get(&id) {
                    return known;
                }
                let name = self.namer.negated(self.ssa, self.graph, id);
                let negated = self.push_named(Op::Unary(Unary::Neg, value), Some(name), None);
                self.negated.insert(id, negated);
                negated
            }
        }
    }

    fn root(&mut self, (minus, id): Signed, name: Option<&String>) -> Operand {
        let value = self.value(id);
        let before = self.program.statements.len();
        let value = self.negate_if(minus, value, id);
        if let (Some(name), Some(negation)) = (name, self.program.statements.get_mut(before)) {
            negation.name = Some(self.namer.rename(negation.name.take(), name));
        }
        value
    }

    fn unary(&mut self, unary: Unary, x: Signed, id: DefId) -> Operand {
        let x = self.signed(x);
        self.finish(Op::Unary(unary, x), id)
    }

    fn sum(&mut self, terms: &[Signed], id: DefId) -> Operand {
        let mut values: Vec<(bool, Operand)> = Vec::with_capacity(terms.len());
        for &(minus, term) in terms {
            let value = self.value(term);
            values.push(match value {
                Operand::Constant(c) if minus && !terms.iter().any(|(minus, _)| !minus) => {
                    (false, Operand::Constant(-c))
                }
                _ => (minus, value),
            });
        }
        let first = values.iter().position(|(minus, _)| !minus);
        let start = match first {
            Some(at) => values.remove(at).1,
            None => {
                let (_, start) = values.remove(0);
                // -a - b needs a negation of the first term.
                let op = Op::Unary(Unary::Neg, start);
                if values.is_empty() {
                    return self.finish(op, id);
                }
                self.push(op)
            }
        };
        let step = |(minus, term)| (if minus { Binary::Sub } else { Binary::Add }, term);
        self.in_turn(start, values.into_iter().map(step).collect(), id)
    }

    fn product(&mut self, factors: &[DefId], id: DefId) -> Operand {
        let mut above = Vec::new();
        let mut below = Vec::new();
        for &factor in factors {
            match &self.ssa.defs[factor] {
                SsaDef::Recip(x) if self.divides(factor) => below.push(*x),
                _ => above.push(factor),
            }
        }
        // Invariant factors come first, so that their product can be hoisted or reused.
        above.sort_by_key(|&f| !self.ssa.facts[f].fixed);
        let mut steps: Vec<(Binary, Operand)> = Vec::new();
        for factor in above {
            let value = self.value(factor);
            steps.push((Binary::Mul, value));
        }
        for divisor in below {
            let value = self.value(divisor);
            steps.push((Binary::Div, value));
        }
        // An input stands before what is computed, as in `C_Da * alpha`.
        if let [(_, Operand::Temp(_)), (Binary::Mul, second), ..] = steps[..]
            && is_input(second)
        {
            steps.swap(0, 1);
        }
        let start = match steps.first() {
            Some(&(Binary::Mul, value)) => {
                steps.remove(0);
                value
            }
            _ => Operand::Constant(1.0),
        };
        self.in_turn(start, steps, id)
    }

    /// Applies operations in turn to `value`; the last one computes the definition `id`.
    fn in_turn(&mut self, mut value: Operand, steps: Vec<(Binary, Operand)>, id: DefId) -> Operand {
        let many = steps.len();
        for (k, (binary, operand)) in steps.into_iter().enumerate() {
            let op = Op::Binary(binary, value, operand);
            value = if k + 1 == many {
                self.finish(op, id)
            } else {
                self.push(op)
            };
        }
        value
    }
}

fn is_input(operand: Operand) -> bool {
    !matches!(operand, Operand::Temp(_) | Operand::Constant(_))
}

fn leaf(symbol: Symbol) -> Operand {
    match symbol {
        Symbol::Time => Operand::Time,
        Symbol::Pi => Operand::Constant(PI),
        Symbol::State(k) => Operand::State(k),
        Symbol::Parameter(k) => Operand::Parameter(k),
        Symbol::Marker(k) => Operand::Marker(k),
        Symbol::Local(k) => unreachable!("shared value {k} has been replaced by its definition"),
    }
}
