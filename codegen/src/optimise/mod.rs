//! Fewer operations: common factors, common products, common sums, across everything that is computed.
//!
//! Works on a flat list of definitions. Sums carry signs, products none (theirs goes to the user), so
//! that negations mostly disappear.

mod factor;
mod greedy;
mod import;
mod products;
mod signs;
mod sums;

pub use import::import;

use crate::functions::MathFunction;
use crate::graph::{Facts, FastMap, NodeId, Symbol};
use crate::number::Number;

/// Index of a definition.
pub type DefId = u32;

/// A reference with a sign: true for minus.
pub type Signed = (bool, DefId);

/// What a definition computes.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Def {
    /// A leaf.
    Leaf(Symbol),
    /// A constant above 0 (or 0 itself).
    Constant(Number),
    /// Terms, each once, ordered by definition.
    Sum(Vec<Signed>),
    /// Factors, repeated for powers, ordered.
    Product(Vec<DefId>),
    /// Square root of something that is never negative.
    Root(DefId),
    /// Reciprocal, 0 at 0 unless the argument is known not to be 0.
    Recip(DefId),
    /// A function.
    Call(MathFunction, Signed),
    /// Angle of the point (second, first).
    Atan2(Signed, Signed),
    /// The smaller.
    Min(Signed, Signed),
    /// The greater.
    Max(Signed, Signed),
    /// The second where the first is 0, else the third.
    IfZero(DefId, Signed, Signed),
}

impl Def {
    /// Calls `visit` with every operand, as often as it is used.
    pub fn for_operands(&self, mut visit: impl FnMut(DefId)) {
        match self {
            Def::Leaf(_) | Def::Constant(_) => {}
            Def::Sum(terms) => terms.iter().for_each(|&(_, id)| visit(id)),
            Def::Product(factors) => factors.iter().for_each(|&id| visit(id)),
            Def::Root(x) | Def::Recip(x) | Def::Call(_, (_, x)) => visit(*x),
            Def::Atan2((_, a), (_, b)) | Def::Min((_, a), (_, b)) | Def::Max((_, a), (_, b)) => {
                visit(*a);
                visit(*b);
            }
            Def::IfZero(a, (_, b), (_, c)) => {
                visit(*a);
                visit(*b);
                visit(*c);
            }
        }
    }

    /// Every operand, repeated as often as it is used.
    pub fn operands(&self) -> Vec<DefId> {
        let mut operands = Vec::new();
        self.for_operands(|id| operands.push(id));
        operands
    }
}

/// Definitions and what is wanted of them.
#[derive(Clone, Debug, Default)]
pub struct Dag {
    /// The definitions; operands need not come first.
    pub defs: Vec<Def>,
    /// What is known about each.
    pub facts: Vec<Facts>,
    /// The node each stands for, where there is one, and whether with opposite sign.
    pub origin: Vec<Option<(bool, NodeId)>>,
    /// What is wanted, in the order asked for.
    pub roots: Vec<Signed>,
    index: FastMap<Def, DefId>,
}

impl Dag {
    /// A definition, shared if it is there already.
    pub fn define(&mut self, def: Def, facts: Facts, origin: Option<(bool, NodeId)>) -> DefId {
        // passes change definitions in place: what is found may have become another
        if let Some(&id) = self.index.get(&def)
            && self.defs[id as usize] == def
        {
            return id;
        }
        let id = self.defs.len() as DefId;
        self.index.insert(def.clone(), id);
        self.defs.push(def);
        self.facts.push(facts);
        self.origin.push(origin);
        id
    }

    /// Facts of a product.
    fn product_facts(&self, factors: &[DefId]) -> Facts {
        let of = |id: &DefId| self.facts[*id as usize];
        let square = factors.len() == 2 && factors[0] == factors[1];
        Facts {
            fixed: factors.iter().all(|f| of(f).fixed),
            nonneg: square || factors.iter().all(|f| of(f).nonneg),
            nonzero: factors.iter().all(|f| of(f).nonzero),
        }
    }

    /// Facts of a sum.
    fn sum_facts(&self, terms: &[Signed]) -> Facts {
        let of = |id: DefId| self.facts[id as usize];
        let nonneg = terms.iter().all(|&(minus, t)| !minus && of(t).nonneg);
        Facts {
            fixed: terms.iter().all(|&(_, t)| of(t).fixed),
            nonneg,
            nonzero: nonneg && terms.iter().any(|&(_, t)| of(t).nonzero),
        }
    }

    /// A product of these factors; with one factor, the factor itself.
    fn product(&mut self, mut factors: Vec<DefId>) -> DefId {
        factors.sort_unstable();
        match factors.as_slice() {
            [single] => *single,
            _ => {
                let facts = self.product_facts(&factors);
                self.define(Def::Product(factors), facts, None)
            }
        }
    }

    /// How often each definition is used, roots included.
    pub fn uses(&self) -> Vec<u32> {
        let mut uses = vec![0; self.defs.len()];
        let mut live = vec![false; self.defs.len()];
        let mut stack: Vec<DefId> = Vec::new();
        for &(_, root) in &self.roots {
            uses[root as usize] += 1;
            stack.push(root);
        }
        while let Some(id) = stack.pop() {
            if std::mem::replace(&mut live[id as usize], true) {
                continue;
            }
            self.defs[id as usize].for_operands(|operand| {
                uses[operand as usize] += 1;
                stack.push(operand);
            });
        }
        uses
    }

    /// Operations left for the flight, about: what is prepared costs a little too.
    pub fn cost(&self) -> usize {
        let tenths = |id: DefId| {
            let operations = match &self.defs[id as usize] {
                Def::Leaf(_) | Def::Constant(_) => 0,
                Def::Sum(terms) => (terms.len() - 1).max(usize::from(terms.iter().all(|t| t.0))),
                Def::Product(factors) => factors.len() - 1,
                _ => 1,
            };
            let weight = if self.facts[id as usize].fixed { 1 } else { 10 };
            weight * operations
        };
        let negated = self.roots.iter().filter(|(minus, _)| *minus).count();
        10 * negated + self.order().into_iter().map(tenths).sum::<usize>()
    }

    /// All passes, until nothing gets smaller.
    pub fn optimise(&mut self) {
        for _ in 0..4 {
            let before = self.defs.clone();
            factor::factor(self);
            products::share(self);
            sums::share(self);
            if self.defs == before {
                break;
            }
        }
        signs::settle(self);
    }

    /// Definitions that the roots need, operands first, depth first from each root in turn.
    pub fn order(&self) -> Vec<DefId> {
        let mut order = Vec::new();
        let mut state = vec![0_u8; self.defs.len()];
        for &(_, root) in &self.roots {
            let mut stack = vec![(root, false)];
            while let Some((id, done)) = stack.pop() {
                if done {
                    order.push(id);
                } else if state[id as usize] == 0 {
                    state[id as usize] = 1;
                    stack.push((id, true));
                    let first = stack.len();
                    self.defs[id as usize].for_operands(|operand| {
                        if state[operand as usize] == 0 {
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

impl Dag {
    /// Replaces every reference by its target, following chains.
    fn redirect(&mut self, target: &[DefId]) {
        let end = |mut id: DefId| {
            while target[id as usize] != id {
                id = target[id as usize];
            }
            id
        };
        for def in &mut self.defs {
            match def {
                Def::Leaf(_) | Def::Constant(_) => {}
                Def::Sum(terms) => {
                    terms.iter_mut().for_each(|(_, id)| *id = end(*id));
                    cancel(terms);
                    if terms.is_empty() {
                        *def = Def::Constant(Number::ZERO);
                    }
                }
                Def::Product(factors) => {
                    factors.iter_mut().for_each(|id| *id = end(*id));
                    factors.sort_unstable();
                }
                Def::Root(x) | Def::Recip(x) | Def::Call(_, (_, x)) => *x = end(*x),
                Def::Atan2((_, a), (_, b))
                | Def::Min((_, a), (_, b))
                | Def::Max((_, a), (_, b)) => {
                    *a = end(*a);
                    *b = end(*b);
                }
                Def::IfZero(a, (_, b), (_, c)) => {
                    *a = end(*a);
                    *b = end(*b);
                    *c = end(*c);
                }
            }
        }
        for (_, root) in &mut self.roots {
            *root = end(*root);
        }
        for id in 0..self.defs.len() {
            let to = end(id as DefId) as usize;
            if to != id && self.origin[to].is_none() {
                self.origin[to] = self.origin[id];
            }
        }
    }
}

/// Orders terms, and takes away those that are equal but for their sign.
fn cancel(terms: &mut Vec<Signed>) {
    terms.sort_unstable_by_key(|&(minus, def)| (def, minus));
    while let Some(at) = terms
        .windows(2)
        .position(|w| w[0].1 == w[1].1 && w[0].0 != w[1].0)
    {
        terms.drain(at..at + 2);
    }
}
