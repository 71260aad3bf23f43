//! Static single assignment (SSA) form: one definition per value, and passes that reduce the operation count:
//! factoring, common-subexpression elimination, sign placement.
//!
//! Terms of sums have signs; products have none, since the sign of a product moves to its users. Most negations
//! disappear that way.

mod build;
mod cse;
mod factor;
mod signs;

pub use build::build;

use crate::functions::{BinaryFunction, MathFunction};
use crate::graph::{ExprGraph, FastMap, NodeId, Symbol, ValueFacts};
use crate::number::Number;
use model_spec::index::IndexVec;

model_spec::index_type!(
    /// Index of a definition in an [`Ssa`].
    pub struct DefId;
);

/// Signed reference to a definition: `true` means negated.
pub type Signed = (bool, DefId);

/// Operation of an SSA definition, with its operands.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum SsaDef {
    /// Leaf symbol such as a state or parameter.
    Leaf(Symbol),
    /// Nonnegative numerical constant; a negative constant is a negated reference to its absolute value.
    Constant(Number),
    /// Sum of signed terms, ordered by definition.
    Sum(Vec<Signed>),
    /// Product of two or more factors, sorted by index; a factor to the power n is listed n times.
    Product(Vec<DefId>),
    /// Square root of a nonnegative operand.
    Root(DefId),
    /// Reciprocal of the operand; 0 at 0 unless the operand is known to be nonzero.
    Recip(DefId),
    /// Elementary function of a signed operand.
    Call(MathFunction, Signed),
    /// Function of two signed operands.
    Call2(BinaryFunction, Signed, Signed),
    /// Selection: the second operand where the first is 0, else the third operand.
    IfZero(DefId, Signed, Signed),
}

impl SsaDef {
    /// Calls `visit` for each operand, once per use.
    pub fn for_operands(&self, mut visit: impl FnMut(DefId)) {
        match self {
            SsaDef::Leaf(_) | SsaDef::Constant(_) => {}
            SsaDef::Sum(terms) => terms.iter().for_each(|&(_, id)| visit(id)),
            SsaDef::Product(factors) => factors.iter().for_each(|&id| visit(id)),
            SsaDef::Root(x) | SsaDef::Recip(x) | SsaDef::Call(_, (_, x)) => visit(*x),
            SsaDef::Call2(_, (_, a), (_, b)) => {
                visit(*a);
                visit(*b);
            }
            SsaDef::IfZero(a, (_, b), (_, c)) => {
                visit(*a);
                visit(*b);
                visit(*c);
            }
        }
    }

    /// Direct operands, repeated once per use.
    pub fn operands(&self) -> Vec<DefId> {
        let mut operands = Vec::new();
        self.for_operands(|id| operands.push(id));
        operands
    }
}

/// SSA program: the definitions, and the roots.
#[derive(Clone, Debug, Default)]
pub struct Ssa {
    /// Definitions by index; operands may have larger indices than their users.
    pub defs: IndexVec<DefId, SsaDef>,
    /// Value facts of each definition: constant during a flight, nonnegative, nonzero.
    pub facts: IndexVec<DefId, ValueFacts>,
    /// Graph node with the value of each definition, and whether it is negated.
    pub origin: IndexVec<DefId, Option<(bool, NodeId)>>,
    /// Results to compute, with signs, in the requested order.
    pub roots: Vec<Signed>,
    index: FastMap<SsaDef, DefId>,
}

impl Ssa {
    pub fn define(
        &mut self,
        def: SsaDef,
        facts: ValueFacts,
        origin: Option<(bool, NodeId)>,
    ) -> DefId {
        if let Some(id) = self.find(&def) {
            return id;
        }
        self.index.insert(def.clone(), self.defs.next_index());
        let id = self.defs.push(def);
        self.facts.push(facts);
        self.origin.push(origin);
        id
    }

    /// Creates a table with one entry for each definition, filled with copies of `entry`.
    pub fn side_table<T: Clone>(&self, entry: T) -> IndexVec<DefId, T> {
        vec![entry; self.defs.len()].into()
    }

    /// Index of an identical existing definition; `None` if there is none.
    pub fn find(&self, def: &SsaDef) -> Option<DefId> {
        // passes change definitions in place, so the indexed definition may have changed
        let &id = self.index.get(def)?;
        (self.defs[id] == *def).then_some(id)
    }

    fn product_facts(&self, factors: &[DefId]) -> ValueFacts {
        let of = |id: &DefId| self.facts[*id];
        let square = factors.len() == 2 && factors[0] == factors[1];
        ValueFacts {
            fixed: factors.iter().all(|f| of(f).fixed),
            nonneg: square || factors.iter().all(|f| of(f).nonneg),
            nonzero: factors.iter().all(|f| of(f).nonzero),
        }
    }

    fn sum_facts(&self, terms: &[Signed]) -> ValueFacts {
        let of = |id: DefId| self.facts[id];
        let nonneg = terms.iter().all(|&(minus, t)| !minus && of(t).nonneg);
        ValueFacts {
            fixed: terms.iter().all(|&(_, t)| of(t).fixed),
            nonneg,
            nonzero: nonneg && terms.iter().any(|&(_, t)| of(t).nonzero),
        }
    }

    /// Definition of the product of the factors, which is added if missing; a single factor is returned unchanged.
    fn product(&mut self, mut factors: Vec<DefId>) -> DefId {
        factors.sort_unstable();
        match factors.as_slice() {
            [single] => *single,
            _ => {
                let facts = self.product_facts(&factors);
                self.define(SsaDef::Product(factors), facts, None)
            }
        }
    }

    pub fn expression(
        &self,
        id: DefId,
        graph: &mut ExprGraph,
        of: &dyn Fn(DefId) -> NodeId,
    ) -> NodeId {
        let signed = |graph: &mut ExprGraph, (minus, x): Signed| {
            let node = of(x);
            if minus { graph.neg(node) } else { node }
        };
        match &self.defs[id] {
            SsaDef::Leaf(symbol) => graph.symbol(*symbol),
            SsaDef::Constant(number) => graph.number(*number),
            SsaDef::Sum(terms) => {
                let terms = terms
                    .iter()
                    .map(|&(minus, term)| (Number::sign(minus), of(term)));
                graph.sum(terms.collect(), Number::ZERO)
            }
            SsaDef::Product(factors) => {
                graph.product(factors.iter().map(|&factor| (of(factor), 2)).collect())
            }
            SsaDef::Root(x) => graph.sqrt(of(*x)),
            SsaDef::Recip(x) => {
                let x_node = of(*x);
                if self.facts[id].nonzero || self.facts[*x].nonzero {
                    graph.assume_nonzero(x_node);
                }
                graph.power(x_node, -2)
            }
            SsaDef::Call(function, x) => {
                let x = signed(graph, *x);
                graph.call(*function, x)
            }
            SsaDef::Call2(function, a, b) => {
                let (a, b) = (signed(graph, *a), signed(graph, *b));
                graph.call2(*function, a, b)
            }
            SsaDef::IfZero(condition, a, b) => {
                let (a, b) = (signed(graph, *a), signed(graph, *b));
                graph.if_zero(of(*condition), a, b)
            }
        }
    }

    /// Number of uses of each definition by reachable definitions and by roots; 0 if unreachable.
    pub fn uses(&self) -> IndexVec<DefId, u32> {
        let mut uses = self.side_table(0);
        let mut live = self.side_table(false);
        let mut stack: Vec<DefId> = Vec::new();
        for &(_, root) in &self.roots {
            uses[root] += 1;
            stack.push(root);
        }
        while let Some(id) = stack.pop() {
            if std::mem::replace(&mut live[id], true) {
                continue;
            }
            self.defs[id].for_operands(|operand| {
                uses[operand] += 1;
                stack.push(operand);
            });
        }
        uses
    }

    /// Cost in tenths of an operation; an operation on parameters only costs one tenth.
    pub fn cost(&self) -> usize {
        let tenths = |id: DefId| {
            let operations = match &self.defs[id] {
                SsaDef::Leaf(_) | SsaDef::Constant(_) => 0,
                SsaDef::Sum(terms) => (terms.len() - 1).max(usize::from(terms.iter().all(|t| t.0))),
                SsaDef::Product(factors) => factors.len() - 1,
                _ => 1,
            };
            let weight = if self.facts[id].fixed { 1 } else { 10 };
            weight * operations
        };
        let negated = self.roots.iter().filter(|(minus, _)| *minus).count();
        10 * negated + self.order().into_iter().map(tenths).sum::<usize>()
    }

    /// Factors and shares until nothing changes, at most 4 times, then settles signs.
    pub fn optimise(&mut self) {
        for _ in 0..4 {
            let before = self.defs.clone();
            factor::factor(self);
            cse::share_products(self);
            cse::share_sums(self);
            if self.defs == before {
                break;
            }
        }
        signs::settle(self);
    }

    /// Definitions on which the roots depend, in depth-first order, operands before users.
    pub fn order(&self) -> Vec<DefId> {
        let mut order = Vec::new();
        let mut state = self.side_table(0_u8);
        for &(_, root) in &self.roots {
            let mut stack = vec![(root, false)];
            while let Some((id, done)) = stack.pop() {
                if done {
                    order.push(id);
                } else if state[id] == 0 {
                    state[id] = 1;
                    stack.push((id, true));
                    let first = stack.len();
                    self.defs[id].for_operands(|operand| {
                        if state[operand] == 0 {
                            stack.push((operand, false));
                        }
                    });
                    stack[first..].reverse();
                }
            }
        }
        order
    }
}

impl Ssa {
    /// Replaces references to `id` by `target[id]`, along chains of targets.
    fn redirect(&mut self, target: &IndexVec<DefId, DefId>) {
        let end = |mut id: DefId| {
            while target[id] != id {
                id = target[id];
            }
            id
        };
        for def in self.defs.iter_mut() {
            match def {
                SsaDef::Leaf(_) | SsaDef::Constant(_) => {}
                SsaDef::Sum(terms) => {
                    terms.iter_mut().for_each(|(_, id)| *id = end(*id));
                    cancel(terms);
                    if terms.is_empty() {
                        *def = SsaDef::Constant(Number::ZERO);
                    }
                }
                SsaDef::Product(factors) => {
                    factors.iter_mut().for_each(|id| *id = end(*id));
                    factors.sort_unstable();
                }
                SsaDef::Root(x) | SsaDef::Recip(x) | SsaDef::Call(_, (_, x)) => *x = end(*x),
                SsaDef::Call2(_, (_, a), (_, b)) => {
                    *a = end(*a);
                    *b = end(*b);
                }
                SsaDef::IfZero(a, (_, b), (_, c)) => {
                    *a = end(*a);
                    *b = end(*b);
                    *c = end(*c);
                }
            }
        }
        for (_, root) in &mut self.roots {
            *root = end(*root);
        }
        for id in self.defs.indices() {
            let to = end(id);
            if to != id && self.origin[to].is_none() {
                self.origin[to] = self.origin[id];
            }
        }
    }
}

/// Sorts the terms of a sum by definition, positive terms first.
fn sort_terms(terms: &mut [Signed]) {
    terms.sort_unstable_by_key(|&(minus, def)| (def, minus));
}

/// Sorts the terms of a sum with [`sort_terms`], and removes pairs of equal terms with opposite signs.
fn cancel(terms: &mut Vec<Signed>) {
    sort_terms(terms);
    if terms
        .windows(2)
        .all(|pair| pair[0].1 != pair[1].1 || pair[0].0 == pair[1].0)
    {
        return;
    }
    let mut remaining: Vec<Signed> = Vec::with_capacity(terms.len());
    for &term in terms.iter() {
        match remaining.last() {
            Some(last) if last.1 == term.1 && last.0 != term.0 => {
                remaining.pop();
            }
            _ => remaining.push(term),
        }
    }
    *terms = remaining;
}
