//! Products and logarithms of exponentials in a form that is finite where the exponentials overflow but what is made of
//! them does not: `step(x)*exp(u)` where x is below 0, and `log(1 + exp(u))`.

use super::{ExprGraph, Node, NodeId};
use crate::functions::{BinaryFunction, MathFunction};
use crate::number::Number;

/// Node that is 0 over a whole range, and 1 elsewhere.
struct Switch {
    node: NodeId,
    /// What the node is as a factor of a product, up to its sign.
    factor: NodeId,
}

impl ExprGraph {
    /// The product `id`, in whose factors e^u becomes e^(s u) if another factor is 0 where s is, a switch from 0 to 1: where
    /// the product vanishes its exponentials are 1, and their overflow makes no 0 · ∞ of it or of its derivatives.
    pub fn held_product(&mut self, id: NodeId) -> NodeId {
        let (coefficient, product) = self.split_coefficient(id);
        let Node::Product(factors) = self.node(product).clone() else {
            return id;
        };
        if !self.has_exponentials {
            return id;
        }
        let positive = factors.iter().filter(|(_, exponent)| *exponent > 0);
        let bases: Vec<NodeId> = positive.map(|(base, _)| *base).collect();
        let switches: Vec<Switch> = { bases.iter() }
            .filter_map(|base| self.switch_of(*base))
            .collect();
        if switches.is_empty() {
            return id;
        }
        let held = factors.iter().map(|&(base, exponent)| {
            let base = match exponent > 0 || self.is_exponential(base) {
                true => self.held(base, &switches),
                false => base,
            };
            (base, exponent)
        });
        let held = held.collect();
        let product = self.product(held);
        self.scale(coefficient, product)
    }

    /// Logarithm of `x`: of a positive sum w with one exponential e^u, u + log(e^-u w) where u is above 0.
    pub fn held_logarithm(&mut self, x: NodeId) -> NodeId {
        let plain = self.call(MathFunction::Log, x);
        let facts = self.facts(x);
        let Some(exponential) = self.only_exponential(x) else {
            return plain;
        };
        let Node::Call(_, u) = *self.node(exponential) else {
            return plain;
        };
        if !(facts.nonneg && facts.nonzero) {
            return plain;
        }
        let divided = self.divided_by_exponential(x, exponential, u);
        let rest = self.call(MathFunction::Log, divided);
        let whole = self.add(u, rest);
        let above = self.call(MathFunction::Heaviside, u);
        self.if_zero(above, plain, whole)
    }

    /// A node that is 0 where the factor `base` is 0 over a whole range, and 1 elsewhere; `None` for other factors.
    fn switch_of(&mut self, base: NodeId) -> Option<Switch> {
        let heaviside = MathFunction::Heaviside;
        let of_argument = |graph: &mut ExprGraph, x: NodeId| {
            let node = graph.call(heaviside, x);
            Switch { node, factor: node }
        };
        match self.node(base).clone() {
            Node::Call(MathFunction::Heaviside, x) => Some(of_argument(self, x)),
            // 1 - step(x), or its negative, which is the canonical factor.
            Node::Sum(terms, constant) => {
                let [(c, step)] = *terms else {
                    return None;
                };
                let is_step = matches!(self.node(step), Node::Call(f, _) if *f == heaviside);
                let is_rest = is_step && constant.abs().is_one() && c == constant.opposite();
                is_rest.then(|| Switch {
                    node: self.sum(vec![(Number::MINUS_ONE, step)], Number::ONE),
                    factor: base,
                })
            }
            Node::Call2(BinaryFunction::Max, a, b) => {
                let moving = self.beside_zero(a, b)?;
                Some(of_argument(self, moving))
            }
            Node::Call2(BinaryFunction::Min, a, b) => {
                let moving = self.beside_zero(a, b)?;
                let opposite = self.neg(moving);
                Some(of_argument(self, opposite))
            }
            _ => None,
        }
    }

    /// The other of two nodes, if one is the number 0.
    fn beside_zero(&self, a: NodeId, b: NodeId) -> Option<NodeId> {
        match (self.is_zero(a), self.is_zero(b)) {
            (true, _) => Some(b),
            (_, true) => Some(a),
            _ => None,
        }
    }

    fn is_exponential(&self, id: NodeId) -> bool {
        matches!(self.node(id), Node::Call(MathFunction::Exp, _))
    }

    /// An exponential, or a sum with terms that have exponentials as factors, whose arguments are multiplied by `switches`.
    fn held(&mut self, base: NodeId, switches: &[Switch]) -> NodeId {
        match self.node(base).clone() {
            Node::Call(MathFunction::Exp, u) => {
                let known = self.monomial(self.split_coefficient(u).1);
                let is_new = |own: &&Switch| !known.iter().any(|(factor, _)| *factor == own.factor);
                let mut factors: Vec<_> = { switches.iter() }
                    .filter(is_new)
                    .map(|own| (own.node, 2))
                    .collect();
                if factors.is_empty() {
                    return base;
                }
                factors.push((u, 2));
                let argument = self.product(factors);
                self.call(MathFunction::Exp, argument)
            }
            Node::Sum(terms, constant) => {
                let held = terms.iter().map(|&(c, term)| {
                    let factors = self.monomial(term).into_iter();
                    let factors = factors.map(|(factor, exponent)| {
                        let is_exponential = self.is_exponential(factor);
                        let held = is_exponential.then(|| self.held(factor, switches));
                        (held.unwrap_or(factor), exponent)
                    });
                    let factors = factors.collect();
                    (c, self.product(factors))
                });
                let held = held.collect();
                self.sum(held, constant)
            }
            _ => base,
        }
    }

    /// The exponential that a sum has as factor of its terms, if it is the only one and its exponent there is 1.
    fn only_exponential(&self, sum: NodeId) -> Option<NodeId> {
        let Node::Sum(terms, _) = self.node(sum) else {
            return None;
        };
        let factors = terms.iter().flat_map(|(_, term)| self.monomial(*term));
        let mut exponentials = factors.filter(|(factor, _)| self.is_exponential(*factor));
        let (first, exponent) = exponentials.next()?;
        let is_only = exponent == 2 && exponentials.all(|other| other == (first, 2));
        is_only.then_some(first)
    }
}
