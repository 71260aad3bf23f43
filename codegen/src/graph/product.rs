//! Construction of products: exponents of equal bases are added; coefficients and common factors of sums are extracted.

use super::sum::divide;
use super::{ExprGraph, Node, NodeId};
use crate::functions::MathFunction;
use crate::number::Number;

/// Factorization of a sum: coefficient · monomial of common factors · remaining sum `rest`.
#[derive(Clone, Debug)]
pub(super) struct Content {
    coefficient: Number,
    factors: Box<[(NodeId, i32)]>,
    rest: NodeId,
}

impl ExprGraph {
    /// Node of the product `a b`, simplified.
    pub fn mul(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.product(vec![(a, 2), (b, 2)])
    }

    /// Product `a b`; the other operand unchanged if one is 1.
    pub fn times(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.is_one(a), self.is_one(b)) {
            (true, _) => b,
            (_, true) => a,
            _ => self.mul(a, b),
        }
    }

    /// Quotient `a / b`; `a` unchanged if `b` is 1.
    pub fn over(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if self.is_one(b) { a } else { self.div(a, b) }
    }

    /// Whether a node is the constant 1.
    pub fn is_one(&self, id: NodeId) -> bool {
        matches!(self.node(id), Node::Number(number) if number.is_one())
    }

    /// Node of the quotient `a / b`; 0 where `b` = 0, unless `b` is known to be nonzero.
    pub fn div(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.product(vec![(a, 2), (b, -2)])
    }

    /// Node of `a ^ (doubled / 2)`; if `doubled` is odd, the value is 0 where `a` is negative.
    pub fn power(&mut self, a: NodeId, doubled: i32) -> NodeId {
        if doubled % 2 == 0 {
            return self.product(vec![(a, doubled)]);
        }
        let root = self.sqrt(a);
        self.product(vec![(root, 2 * doubled)])
    }

    /// Node of `a ^ b` = exp(b log a); 0 where `a` ≤ 0.
    pub fn real_power(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let logarithm = self.call(MathFunction::Log, a);
        let exponent = self.mul(b, logarithm);
        let power = self.call(MathFunction::Exp, exponent);
        let above = self.call(MathFunction::Heaviside, a);
        self.mul(above, power)
    }

    /// Product of (base, doubled exponent) factors.
    pub fn product(&mut self, factors: Vec<(NodeId, i32)>) -> NodeId {
        let (coefficient, factors) = self.collect(factors);
        if coefficient.is_zero() {
            return self.number(Number::ZERO);
        }
        if let Some(sum) = self.distributed_exponentials(&factors) {
            return self.scale(coefficient, sum);
        }
        let product = match factors.as_slice() {
            [] => return self.number(coefficient),
            [(single, 2)] => *single,
            _ => self.intern(Node::Product(factors.into())),
        };
        self.scale(coefficient, product)
    }

    fn collect(&mut self, factors: Vec<(NodeId, i32)>) -> (Number, Vec<(NodeId, i32)>) {
        let mut coefficient = Number::ONE;
        let mut pending = factors;
        let mut flat: Vec<(NodeId, i32)> = Vec::new();
        loop {
            while let Some((id, exponent)) = pending.pop() {
                if exponent != 0 && !self.open(id, exponent, &mut coefficient, &mut pending) {
                    flat.push((id, exponent));
                }
            }
            flat = self.merge(flat);
            if !self.unmask(&mut flat, &mut pending) && !self.saturate(&mut flat, &mut pending) {
                return (coefficient, flat);
            }
        }
    }

    /// Splits a factor into a constant and simpler factors; false if it cannot be split.
    fn open(
        &mut self,
        id: NodeId,
        exponent: i32,
        coefficient: &mut Number,
        pending: &mut Vec<(NodeId, i32)>,
    ) -> bool {
        if let Some(&root) = self.root_of.get(&id) {
            pending.push((root, 2 * exponent));
            return true;
        }
        match self.node(id) {
            Node::Number(number) => {
                let power = number.power(exponent.abs() / 2);
                let power = if exponent % 2 == 0 {
                    power
                } else {
                    power.times(number.sqrt())
                };
                // 1/0 is defined as 0 throughout the graph
                let power = if exponent < 0 && !power.is_zero() {
                    power.recip()
                } else {
                    power
                };
                *coefficient = coefficient.times(power);
                true
            }
            Node::Product(inner) if inner.iter().all(|(_, e)| (e * exponent) % 2 == 0) => {
                let inner = inner.clone();
                for &(factor, e) in &inner {
                    // the root of a square is the absolute value
                    let signed = exponent % 2 != 0 && e % 4 == 0 && !self.facts(factor).nonneg;
                    let base = if signed {
                        self.call(MathFunction::Abs, factor)
                    } else {
                        factor
                    };
                    pending.push((base, e * exponent / 2));
                }
                true
            }
            Node::Sum(..) if exponent % 2 == 0 => {
                let content = self.content(id);
                if content.rest == id {
                    return false;
                }
                *coefficient = coefficient.times(content.coefficient.power(exponent / 2));
                pending.extend(
                    content
                        .factors
                        .iter()
                        .map(|&(factor, e)| (factor, e * exponent / 2)),
                );
                pending.push((content.rest, exponent));
                true
            }
            Node::Call(MathFunction::Abs, x) if exponent % 4 == 0 => {
                pending.push((*x, exponent));
                true
            }
            _ => false,
        }
    }

    /// Adds the exponents of equal bases; a base to the power 0 leaves its indicator `NonZero(base)`.
    fn merge(&mut self, mut flat: Vec<(NodeId, i32)>) -> Vec<(NodeId, i32)> {
        flat.sort_unstable();
        let mut merged: Vec<(NodeId, i32)> = Vec::with_capacity(flat.len());
        let mut masks = Vec::new();
        for group in flat.chunk_by(|a, b| a.0 == b.0) {
            let base = group[0].0;
            let total: i32 = group.iter().map(|(_, e)| e).sum();
            if matches!(self.node(base), Node::Call(MathFunction::NonZero, _)) {
                masks.push(base);
            } else if total != 0 {
                merged.push((base, total));
            } else if !self.facts(base).nonzero {
                masks.push(self.call(MathFunction::NonZero, base));
            }
        }
        masks.sort_unstable();
        masks.dedup();
        for mask in masks {
            let Node::Call(_, base) = *self.node(mask) else {
                continue;
            };
            // no mask needed if another factor is zero wherever the mask's argument is
            if !merged
                .iter()
                .any(|&(known, _)| known == base || self.is_component(known, base))
            {
                merged.push((mask, 2));
            }
        }
        merged.sort_unstable();
        merged
    }

    /// Whether `whole` is a sum of squares, or its root, that contains the square of `part`.
    fn is_component(&self, part: NodeId, whole: NodeId) -> bool {
        let sum = self.rooted_sum(whole).unwrap_or(whole);
        let Node::Sum(terms, _) = self.node(sum) else {
            return false;
        };
        self.facts(sum).nonneg
            && terms.iter().any(|&(_, term)| {
                matches!(self.node(term), Node::Product(factors) if factors.as_ref() == [(part, 4)])
            })
    }

    /// Removes indicators `NonZero(X)` from one sum in `flat` where X or its indicator is a factor too; if it did,
    /// moves all factors to `pending` and returns true.
    fn unmask(&mut self, flat: &mut Vec<(NodeId, i32)>, pending: &mut Vec<(NodeId, i32)>) -> bool {
        if !self.has_masks {
            return false;
        }
        for k in 0..flat.len() {
            let Node::Sum(terms, constant) = self.node(flat[k].0).clone() else {
                continue;
            };
            let masked = |graph: &ExprGraph, id: NodeId| {
                graph
                    .monomial(id)
                    .iter()
                    .any(|&(factor, _)| match graph.node(factor) {
                        Node::Call(MathFunction::NonZero, x) => {
                            flat.iter().any(|(known, _)| known == x)
                                || flat.iter().any(|&(known, _)| known == factor)
                        }
                        _ => false,
                    })
            };
            if !terms.iter().any(|&(_, term)| masked(self, term)) {
                continue;
            }
            let lifted: Vec<_> = terms
                .iter()
                .map(|&(c, term)| {
                    if !masked(self, term) {
                        return (c, term);
                    }
                    let kept = self.monomial(term);
                    let kept = kept
                        .into_iter()
                        .filter(|&(factor, _)| match self.node(factor) {
                            Node::Call(MathFunction::NonZero, x) => {
                                !flat.iter().any(|(known, _)| known == x || *known == factor)
                            }
                            _ => true,
                        });
                    let kept = kept.collect();
                    (c, self.product(kept))
                })
                .collect();
            let replaced = self.sum(lifted, constant);
            let (_, exponent) = flat.remove(k);
            pending.append(flat);
            pending.push((replaced, exponent));
            return true;
        }
        false
    }

    pub(super) fn content(&mut self, id: NodeId) -> Content {
        if let Some(known) = self.contents.get(&id) {
            return known.clone();
        }
        let content = self.find_content(id);
        self.contents.insert(id, content.clone());
        content
    }

    fn find_content(&mut self, id: NodeId) -> Content {
        let whole = Content {
            coefficient: Number::ONE,
            factors: Box::new([]),
            rest: id,
        };
        let Node::Sum(terms, constant) = self.node(id).clone() else {
            return whole;
        };
        let mut common = if constant.is_zero() {
            self.monomial(terms[0].1)
        } else {
            Vec::new()
        };
        for &(_, term) in &terms[1..] {
            if common.is_empty() {
                break;
            }
            let other = self.monomial(term);
            common.retain_mut(|(base, exponent)| {
                let Some(&(_, e)) = other.iter().find(|(b, _)| b == base) else {
                    return false;
                };
                let same_side = e.signum() == exponent.signum();
                *exponent = exponent.signum() * exponent.abs().min(e.abs());
                same_side
            });
        }
        if terms.len() == 1 && constant.is_zero() {
            return Content {
                coefficient: terms[0].0,
                factors: common.into(),
                rest: self.whole(1),
            };
        }
        let magnitude = terms[0].0.abs();
        let even = terms.iter().all(|(c, _)| c.abs() == magnitude)
            && (constant.is_zero() || constant.abs() == magnitude);
        let mut coefficient = if even { magnitude } else { Number::ONE };
        if common.is_empty() && coefficient.is_one() && !terms[0].0.is_negative() {
            return whole;
        }
        let divided: Vec<_> = terms
            .iter()
            .map(|&(c, term)| {
                let monomial = self.monomial(term);
                let quotient = divide(&monomial, &common).unwrap_or(monomial);
                (c.times(coefficient.recip()), self.product(quotient))
            })
            .collect();
        let mut rest = self.sum(divided, constant.times(coefficient.recip()));
        // a - b and b - a share one canonical factor: the one whose first term is positive
        if let Node::Sum(terms, _) = self.node(rest)
            && terms[0].0.is_negative()
        {
            rest = self.neg(rest);
            coefficient = coefficient.opposite();
        }
        Content {
            coefficient,
            factors: common.into(),
            rest,
        }
    }
}
