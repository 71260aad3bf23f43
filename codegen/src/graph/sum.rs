//! Construction of sums: like terms are merged, sums of squares contracted (|v|² and sin² + cos² = 1).

use super::{ExprGraph, Node, NodeId};
use crate::functions::MathFunction;
use crate::number::Number;

impl ExprGraph {
    /// Node of `constant + Σ coefficient · term`, simplified; terms are (coefficient, node) pairs.
    pub fn sum(&mut self, terms: Vec<(Number, NodeId)>, constant: Number) -> NodeId {
        let mut constant = constant;
        let mut flat = Vec::with_capacity(terms.len());
        for (coefficient, id) in terms {
            self.flatten_term(coefficient, id, &mut flat, &mut constant);
        }
        flat.sort_unstable_by_key(|&(_, id)| id);
        let mut merged: Vec<(Number, NodeId)> = Vec::with_capacity(flat.len());
        for (coefficient, id) in flat {
            match merged.last_mut() {
                Some(last) if last.1 == id => last.0 = last.0.plus(coefficient),
                _ => merged.push((coefficient, id)),
            }
        }
        merged.retain(|(coefficient, _)| !coefficient.is_zero());
        if let Some((shorter, constant)) = self.contract(&merged, constant) {
            return self.sum(shorter, constant);
        }
        match merged.as_slice() {
            [] => self.number(constant),
            [(coefficient, id)] if constant.is_zero() && coefficient.is_one() => *id,
            _ => {
                let id = self.intern(Node::Sum(merged.into(), constant));
                if let Some(&root) = self.root_of.get(&id) {
                    return self.product(vec![(root, 4)]);
                }
                // replaced by the local that a caller defined for this sum
                self.local_of.get(&id).copied().unwrap_or(id)
            }
        }
    }

    fn flatten_term(
        &self,
        c: Number,
        id: NodeId,
        flat: &mut Vec<(Number, NodeId)>,
        constant: &mut Number,
    ) {
        match self.node(id) {
            Node::Number(number) => *constant = constant.plus(c.times(*number)),
            Node::Sum(terms, inner) => {
                *constant = constant.plus(c.times(*inner));
                flat.extend(terms.iter().map(|&(inner, term)| (c.times(inner), term)));
            }
            _ => flat.push((c, id)),
        }
    }

    /// Node of the sum `a + b`.
    pub fn add(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.sum(vec![(Number::ONE, a), (Number::ONE, b)], Number::ZERO)
    }

    /// Node of the difference `a - b`.
    pub fn sub(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.sum(vec![(Number::ONE, a), (Number::MINUS_ONE, b)], Number::ZERO)
    }

    /// Node of the negation `-a`.
    pub fn neg(&mut self, a: NodeId) -> NodeId {
        self.scale(Number::MINUS_ONE, a)
    }

    /// Node of `c a` with a constant coefficient c.
    pub fn scale(&mut self, c: Number, a: NodeId) -> NodeId {
        if c.is_one() {
            a
        } else {
            self.sum(vec![(c, a)], Number::ZERO)
        }
    }

    /// Splits a node into its constant coefficient and the remaining node; the coefficient is 1 if the node has none.
    pub fn split_coefficient(&self, id: NodeId) -> (Number, NodeId) {
        match self.node(id) {
            Node::Sum(terms, constant) if terms.len() == 1 && constant.is_zero() => terms[0],
            _ => (Number::ONE, id),
        }
    }

    /// Node of `factor · id`, expanded term by term if `id` is a sum.
    pub fn distribute(&mut self, id: NodeId, factor: NodeId) -> NodeId {
        match self.node(id).clone() {
            Node::Sum(terms, constant) => {
                let mut products: Vec<_> = terms
                    .iter()
                    .map(|&(c, term)| (c, self.mul(term, factor)))
                    .collect();
                products.push((constant, factor));
                self.sum(products, Number::ZERO)
            }
            _ => self.mul(id, factor),
        }
    }

    /// Returns a term as a monomial: pairs of a base and twice its exponent.
    pub(super) fn monomial(&self, id: NodeId) -> Vec<(NodeId, i32)> {
        match self.node(id) {
            Node::Product(factors) => factors.to_vec(),
            _ => vec![(id, 2)],
        }
    }

    /// Contracts a sum by sin² + cos² = 1, or by Σ s² · P = X · P with X = Σ s² in P.
    fn contract(
        &mut self,
        terms: &[(Number, NodeId)],
        constant: Number,
    ) -> Option<(Vec<(Number, NodeId)>, Number)> {
        for k in 0..terms.len() {
            let Node::Product(factors) = self.node(terms[k].1) else {
                continue;
            };
            let factors = factors.clone();
            for &(base, exponent) in &factors {
                let identity = match self.node(base) {
                    Node::Sum(squares, rest)
                        if exponent < 0
                            && self.facts(base).nonneg
                            // a single term needs no contraction
                            && (squares.len() > 1 || !rest.is_zero()) =>
                    {
                        let mut parts: Vec<_> = squares
                            .iter()
                            .map(|&(c, s)| (c, self.monomial(s)))
                            .collect();
                        if !rest.is_zero() {
                            parts.push((*rest, Vec::new()));
                        }
                        (parts, vec![(base, 2)])
                    }
                    Node::Call(MathFunction::Sin, angle) if exponent >= 4 => {
                        let Some(cos) = self.find(&Node::Call(MathFunction::Cos, *angle)) else {
                            continue;
                        };
                        (
                            vec![
                                (Number::ONE, vec![(base, 4)]),
                                (Number::ONE, vec![(cos, 4)]),
                            ],
                            Vec::new(),
                        )
                    }
                    _ => continue,
                };
                let found =
                    self.contract_by(terms, constant, k, &factors, &identity.0, &identity.1);
                if found.is_some() {
                    return found;
                }
            }
        }
        None
    }

    fn contract_by(
        &mut self,
        terms: &[(Number, NodeId)],
        constant: Number,
        k: usize,
        factors: &[(NodeId, i32)],
        parts: &[(Number, Vec<(NodeId, i32)>)],
        whole: &[(NodeId, i32)],
    ) -> Option<(Vec<(Number, NodeId)>, Number)> {
        let cofactor = divide(factors, &parts[0].1)?;
        let scale = terms[k].0.times(parts[0].0.recip());
        let mut used = vec![k];
        let mut constant = constant;
        for (coefficient, part) in &parts[1..] {
            let wanted = scale.times(*coefficient);
            let partner = multiply(&cofactor, part);
            if partner.is_empty() {
                if constant.is_zero() || wanted != constant {
                    return None;
                }
                constant = Number::ZERO;
                continue;
            }
            let partner = match partner.as_slice() {
                [(single, 2)] => *single,
                _ => self.find(&Node::Product(partner.into()))?,
            };
            let at = terms
                .iter()
                .position(|&(c, id)| id == partner && c == wanted)?;
            used.push(at);
        }
        let mut rest: Vec<_> = (0..terms.len())
            .filter(|at| !used.contains(at))
            .map(|at| terms[at])
            .collect();
        let joined = self.product([cofactor.as_slice(), whole].concat());
        rest.push((scale, joined));
        Some((rest, constant))
    }
}

/// Quotient of monomials of (base, doubled exponent); `None` unless it divides.
pub(super) fn divide(
    factors: &[(NodeId, i32)],
    divisor: &[(NodeId, i32)],
) -> Option<Vec<(NodeId, i32)>> {
    let mut quotient = factors.to_vec();
    for &(base, exponent) in divisor {
        let at = quotient.iter().position(|&(b, _)| b == base)?;
        let have = quotient[at].1;
        if have.signum() != exponent.signum() || have.abs() < exponent.abs() {
            return None;
        }
        quotient[at].1 -= exponent;
    }
    quotient.retain(|&(_, exponent)| exponent != 0);
    Some(quotient)
}

/// Product of monomials, sorted by base, for comparison with others.
fn multiply(a: &[(NodeId, i32)], b: &[(NodeId, i32)]) -> Vec<(NodeId, i32)> {
    let mut product = a.to_vec();
    for &(base, exponent) in b {
        match product.iter_mut().find(|(known, _)| *known == base) {
            Some(factor) => factor.1 += exponent,
            None => product.push((base, exponent)),
        }
    }
    product.sort_unstable();
    product
}
