//! From definitions to the one schedule: operands first, what belongs together close together.

mod fuse;
mod naming;
mod order;
pub mod prepare;

pub use naming::{Namer, is_reserved};
use prepare::Prepare;

use crate::functions::MathFunction;
use crate::graph::{FastMap, Graph, Symbol};
use crate::optimise::{Dag, Def, DefId, Signed};
use crate::program::{About, Binary, Op, Operand, Program, Statement, Unary};
use std::f64::consts::PI;

/// Puts the definitions in order.
///
/// `results` are names for the roots. With `prepare`, what depends on parameters alone is left to the function that runs before the flight.
pub fn schedule_named(
    dag: &Dag,
    graph: &Graph,
    namer: &mut Namer,
    prepare: Option<&mut Prepare>,
    results: &[String],
) -> Program {
    for (&(minus, id), name) in dag.roots.iter().zip(results) {
        if !minus {
            namer.suggest(dag, graph, id, name);
        }
    }
    let order = dag.order();
    let mut uses = vec![0_u32; dag.defs.len()];
    for &id in &order {
        // what is prepared is used outside this program
        if prepare.is_some() && dag.facts[id as usize].fixed {
            continue;
        }
        for operand in dag.defs[id as usize].operands() {
            uses[operand as usize] += 1;
        }
    }
    for &(_, root) in &dag.roots {
        uses[root as usize] += 1;
    }
    let mut schedule = Schedule {
        dag,
        graph,
        uses,
        values: vec![None; dag.defs.len()],
        program: Program::default(),
        negated: FastMap::default(),
        namer,
        prepare,
    };
    // What takes long comes first, with what it needs: the rest does not wait for it, nor hold registers meanwhile.
    for &id in &order {
        if takes_long(&dag.defs[id as usize]) {
            schedule.emit(id);
        }
    }
    let mut roots: Vec<Vec<usize>> = vec![Vec::new(); dag.defs.len()];
    for (k, &(_, root)) in dag.roots.iter().enumerate() {
        roots[root as usize].push(k);
    }
    let mut outputs = vec![Operand::Constant(f64::NAN); dag.roots.len()];
    for &id in &order {
        schedule.emit(id);
        for &k in &roots[id as usize] {
            outputs[k] = schedule.root(dag.roots[k], results.get(k));
        }
    }
    schedule.program.outputs = outputs;
    order::order(fuse::fuse(schedule.program))
}

/// Puts the definitions in order, results without names.
pub fn schedule(
    dag: &Dag,
    graph: &Graph,
    namer: &mut Namer,
    prepare: Option<&mut Prepare>,
) -> Program {
    schedule_named(dag, graph, namer, prepare, &[])
}

/// Whether a definition is a function, a root or a reciprocal.
fn takes_long(def: &Def) -> bool {
    matches!(
        def,
        Def::Call(..) | Def::Atan2(..) | Def::Root(_) | Def::Recip(_)
    )
}

struct Schedule<'a> {
    dag: &'a Dag,
    graph: &'a Graph,
    uses: Vec<u32>,
    values: Vec<Option<Operand>>,
    program: Program,
    /// Opposites that have been computed.
    negated: FastMap<DefId, Operand>,
    namer: &'a mut Namer,
    prepare: Option<&'a mut Prepare>,
}

impl Schedule<'_> {
    fn emit(&mut self, id: DefId) {
        if self.values[id as usize].is_some() {
            return;
        }
        let def = &self.dag.defs[id as usize];
        let leaf = match def {
            Def::Leaf(symbol) => Some(leaf(*symbol)),
            Def::Constant(number) => Some(Operand::Constant(number.value())),
            _ => None,
        };
        if leaf.is_some() {
            self.values[id as usize] = leaf;
            return;
        }
        if self.dag.facts[id as usize].fixed
            && let Some(prepare) = self.prepare.as_deref_mut()
        {
            // only what the flight needs gets a place
            if self.uses[id as usize] > 0 {
                let operand = prepare.operand(self.dag, self.graph, id, false);
                if let Operand::Prepared(slot) = operand {
                    // names made of other names are to say what the constant is called
                    self.namer.give(id, &prepare.names()[slot as usize]);
                }
                self.values[id as usize] = Some(operand);
            }
            return;
        }
        let value = match def {
            Def::Leaf(_) | Def::Constant(_) => return,
            Def::Sum(terms) => self.sum(terms, id),
            Def::Product(factors) => self.product(factors, id),
            Def::Root(x) => {
                let x = self.value(*x);
                self.finish(Op::Unary(Unary::Call(MathFunction::Sqrt), x), id)
            }
            Def::Recip(x) => {
                if self.divides(id) {
                    return;
                }
                let never = self.dag.facts[*x as usize].nonzero;
                let x = self.value(*x);
                self.finish(
                    Op::Unary(
                        if never {
                            Unary::Recip
                        } else {
                            Unary::RecipOrZero
                        },
                        x,
                    ),
                    id,
                )
            }
            Def::Call(function, x) => self.call(*function, *x, id),
            Def::Atan2(a, b) => self.binary(Binary::Atan2, *a, *b, id),
            Def::Min(a, b) => self.binary(Binary::Min, *a, *b, id),
            Def::Max(a, b) => self.binary(Binary::Max, *a, *b, id),
            Def::IfZero(c, a, b) => {
                let (c, a, b) = (self.value(*c), self.signed(*a), self.signed(*b));
                self.finish(Op::IfZero(c, a, b), id)
            }
        };
        self.values[id as usize] = Some(value);
    }

    /// A reciprocal of something never zero that is used once is a division where it is used.
    fn divides(&self, id: DefId) -> bool {
        match &self.dag.defs[id as usize] {
            Def::Recip(x) => {
                self.uses[id as usize] == 1
                    && self.dag.facts[*x as usize].nonzero
                    && !self.dag.roots.iter().any(|&(_, root)| root == id)
                    && !(self.prepare.is_some() && self.dag.facts[id as usize].fixed)
                    && self.used_in_product(id)
            }
            _ => false,
        }
    }

    fn used_in_product(&self, id: DefId) -> bool {
        self.dag.defs.iter().enumerate().any(|(user, def)| {
            matches!(def, Def::Product(factors) if factors.contains(&id) && factors.len() > 1)
                && self.uses[user] > 0
        })
    }

    fn value(&mut self, id: DefId) -> Operand {
        self.emit(id);
        self.values[id as usize].unwrap_or(Operand::Constant(f64::NAN))
    }

    fn push(&mut self, op: Op) -> Operand {
        self.program.statements.push(Statement {
            op,
            name: None,
            about: None,
        });
        Operand::Temp(self.program.statements.len() as u32 - 1)
    }

    /// The last operation of a definition: it carries the name.
    fn finish(&mut self, op: Op, id: DefId) -> Operand {
        let value = self.push(op);
        let about: Option<About> = self.namer.about(self.dag, self.graph, id);
        let named = self.namer.has_own_name(self.dag, self.graph, id);
        let last = self.program.statements.len() - 1;
        self.program.statements[last].about = about;
        if named
            || self.uses[id as usize] > 1
            || !matches!(
                op,
                Op::Binary(Binary::Add | Binary::Sub | Binary::Mul | Binary::Div, ..)
            )
        {
            let name = self.namer.name(self.dag, self.graph, id);
            self.program.statements[last].name = Some(name);
        }
        value
    }

    fn signed(&mut self, (minus, id): Signed) -> Operand {
        let value = self.value(id);
        self.negate_if(minus, value, id)
    }

    fn negate_if(&mut self, minus: bool, value: Operand, id: DefId) -> Operand {
        match value {
            _ if !minus => value,
            Operand::Constant(c) => Operand::Constant(-c),
            Operand::Prepared(_) => match self.prepare.as_deref_mut() {
                Some(prepare) => prepare.operand(self.dag, self.graph, id, true),
                None => value,
            },
            _ => {
                if let Some(&known) = self.negated.get(&id) {
                    return known;
                }
                let negated = self.push(Op::Unary(Unary::Neg, value));
                self.negated.insert(id, negated);
                let name = self.namer.negated(self.dag, self.graph, id);
                let last = self.program.statements.len() - 1;
                self.program.statements[last].name = Some(name);
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

    fn binary(&mut self, binary: Binary, a: Signed, b: Signed, id: DefId) -> Operand {
        let (a, b) = (self.signed(a), self.signed(b));
        self.finish(Op::Binary(binary, a, b), id)
    }

    fn call(&mut self, function: MathFunction, x: Signed, id: DefId) -> Operand {
        let x = self.signed(x);
        self.finish(Op::Unary(Unary::Call(function), x), id)
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
        let (mut value, rest) = match first {
            Some(at) => {
                let (_, start) = values.remove(at);
                (start, values)
            }
            None => {
                let (_, start) = values.remove(0);
                // -a - b: one of them has to be turned
                let op = Op::Unary(Unary::Neg, start);
                if values.is_empty() {
                    return self.finish(op, id);
                }
                (self.push(op), values)
            }
        };
        let many = rest.len();
        for (k, (minus, term)) in rest.into_iter().enumerate() {
            let op = Op::Binary(if minus { Binary::Sub } else { Binary::Add }, value, term);
            value = if k + 1 == many {
                self.finish(op, id)
            } else {
                self.push(op)
            };
        }
        value
    }

    fn product(&mut self, factors: &[DefId], id: DefId) -> Operand {
        let mut above = Vec::new();
        let mut below = Vec::new();
        for &factor in factors {
            match &self.dag.defs[factor as usize] {
                Def::Recip(x) if self.divides(factor) => below.push(*x),
                _ => above.push(factor),
            }
        }
        // what does not change comes first, so that it can be prepared or kept
        above.sort_by_key(|&f| !self.dag.facts[f as usize].fixed);
        let mut steps: Vec<(Binary, Operand)> = Vec::new();
        for factor in above {
            let value = self.value(factor);
            steps.push((Binary::Mul, value));
        }
        for divisor in below {
            let value = self.value(divisor);
            steps.push((Binary::Div, value));
        }
        let mut value = match steps.first() {
            Some(&(Binary::Mul, value)) => {
                steps.remove(0);
                value
            }
            _ => Operand::Constant(1.0),
        };
        let many = steps.len();
        if many == 0 {
            return value;
        }
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

fn leaf(symbol: Symbol) -> Operand {
    match symbol {
        Symbol::Time => Operand::Time,
        Symbol::Pi => Operand::Constant(PI),
        Symbol::State(k) => Operand::State(k),
        Symbol::Parameter(k) => Operand::Parameter(k),
        Symbol::Marker(k) => Operand::Marker(k),
        // locals are looked through on import
        Symbol::Local(_) => Operand::Constant(f64::NAN),
    }
}
