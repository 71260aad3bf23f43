//! Quotients of exponentials and sums of them, in a form that is finite where an exponential overflows: the derivatives
//! of smooth switches such as 1/(1 + e^u).

use super::{ExprGraph, Node, NodeId, Symbol};
use crate::functions::MathFunction;
use crate::number::Number;

impl ExprGraph {
    /// Rewrites e^u / w, where a term of the sum w has the factor e^u, as 1 / (e^-u w), which is finite where e^u
    /// overflows; if it did, moves all factors to `pending` and returns true.
    pub(super) fn saturate(
        &mut self,
        flat: &mut Vec<(NodeId, i32)>,
        pending: &mut Vec<(NodeId, i32)>,
    ) -> bool {
        if !self.has_exponentials {
            return false;
        }
        for &(exponential, above) in flat.iter() {
            let Node::Call(MathFunction::Exp, u) = *self.node(exponential) else {
                continue;
            };
            for k in 0..flat.len() {
                let (base, exponent) = flat[k];
                let Some((sum, doubled)) = self.power_of_sum(base) else {
                    let Some(factors) = self.product_with(base, exponent, exponential) else {
                        continue;
                    };
                    flat.remove(k);
                    pending.append(flat);
                    pending.extend(factors);
                    return true;
                };
                // The sum has the exponent `exponent * doubled / 2`.
                let below = above.min(-exponent * doubled / 2) / 2 * 2;
                let is_whole = below > 0 && 2 * below % doubled == 0;
                if !is_whole || !self.has_exponential(sum, exponential) {
                    continue;
                }
                let divided = self.divided_by_exponential(sum, exponential, u);
                for (factor, exponent) in std::mem::take(flat) {
                    let added = match factor {
                        _ if factor == exponential => -below,
                        _ if factor == base => 2 * below / doubled,
                        _ => 0,
                    };
                    pending.push((factor, exponent + added));
                }
                pending.push((divided, -below));
                return true;
            }
        }
        false
    }

    /// Sum of the terms of a product (e^u + …) / w, where a term of the sum w has the factor e^u too, so that each term is
    /// finite where e^u overflows; `None` for other products.
    pub(super) fn distributed_exponentials(&mut self, factors: &[(NodeId, i32)]) -> Option<NodeId> {
        if !self.has_exponentials {
            return None;
        }
        let place = factors.iter().position(|&(base, exponent)| {
            let sum = self.power_of_sum(base).filter(|_| exponent == 2);
            let sum = sum.filter(|(_, doubled)| *doubled == 2);
            sum.is_some_and(|(sum, _)| self.shares_exponential(sum, factors))
        })?;
        let (sum, _) = self.power_of_sum(factors[place].0)?;
        let Node::Sum(terms, constant) = self.node(sum).clone() else {
            return None;
        };
        let mut rest = factors.to_vec();
        rest.remove(place);
        let mut distributed = vec![(constant, self.product(rest.clone()))];
        for &(coefficient, term) in &terms {
            let mut factors = rest.clone();
            factors.push((term, 2));
            distributed.push((coefficient, self.product(factors)));
        }
        Some(self.sum(distributed, Number::ZERO))
    }

    /// Whether a term of `sum` has an exponential as factor that a term of a sum in a divisor among `factors` has too.
    fn shares_exponential(&self, sum: NodeId, factors: &[(NodeId, i32)]) -> bool {
        let Node::Sum(terms, _) = self.node(sum) else {
            return false;
        };
        let of_terms = terms.iter().flat_map(|&(_, term)| self.monomial(term));
        let is_exponential = |id| matches!(self.node(id), Node::Call(MathFunction::Exp, _));
        let mut exponentials = of_terms.filter(|&(base, e)| e >= 2 && is_exponential(base));
        exponentials.any(|(exponential, _)| {
            factors.iter().any(|&(base, exponent)| {
                let divisor = self.power_of_sum(base);
                divisor.is_some_and(|(divisor, doubled)| {
                    exponent * doubled < 0 && self.has_exponential(divisor, exponential)
                })
            })
        })
    }

    /// Node of the sum `sum` times e^-u, where `exponential` is e^u, a factor of some of its terms.
    pub(super) fn divided_by_exponential(
        &mut self,
        sum: NodeId,
        exponential: NodeId,
        u: NodeId,
    ) -> NodeId {
        let Node::Sum(terms, constant) = self.node(sum).clone() else {
            return sum;
        };
        let opposite = self.neg(u);
        let inverse = self.call(MathFunction::Exp, opposite);
        let mut divided = vec![(constant, inverse)];
        for &(coefficient, term) in &terms {
            let mut factors = self.monomial(term);
            match factors.iter_mut().find(|f| f.0 == exponential && f.1 >= 2) {
                Some((_, e)) => *e -= 2,
                None => factors.push((inverse, 2)),
            }
            factors.retain(|&(_, e)| e != 0);
            divided.push((coefficient, self.product(factors)));
        }
        let divided = self.sum(divided, Number::ZERO);
        if self.facts(sum).nonzero {
            self.assume_nonzero(divided);
        }
        divided
    }

    /// Whether a term of the sum has the factor `exponential`.
    fn has_exponential(&self, sum: NodeId, exponential: NodeId) -> bool {
        let Node::Sum(terms, _) = self.node(sum) else {
            return false;
        };
        let has = |id| {
            self.monomial(id)
                .iter()
                .any(|f| f.0 == exponential && f.1 >= 2)
        };
        terms.iter().any(|&(_, term)| has(term))
    }

    /// Factors of `base` to the doubled exponent `exponent`, if `base` is a local symbol of a product that divides by a
    /// sum with a term that has the factor `exponential`.
    fn product_with(
        &self,
        base: NodeId,
        exponent: i32,
        exponential: NodeId,
    ) -> Option<Vec<(NodeId, i32)>> {
        let Node::Symbol(Symbol::Local(local)) = *self.node(base) else {
            return None;
        };
        let Node::Product(factors) = self.node(self.definition(local)) else {
            return None;
        };
        let divides = |&(factor, e): &(NodeId, i32)| {
            let sum = self.power_of_sum(factor);
            e * exponent < 0 && sum.is_some_and(|(sum, _)| self.has_exponential(sum, exponential))
        };
        let is_whole = factors.iter().all(|(_, e)| e * exponent % 2 == 0);
        (is_whole && factors.iter().any(divides)).then(|| {
            factors
                .iter()
                .map(|&(f, e)| (f, e * exponent / 2))
                .collect()
        })
    }

    /// The sum `id` and 2, or the sum of which the local symbol `id` is a power and the doubled exponent.
    fn power_of_sum(&self, id: NodeId) -> Option<(NodeId, i32)> {
        match *self.node(id) {
            Node::Sum(..) => Some((id, 2)),
            Node::Symbol(Symbol::Local(local)) => match self.node(self.definition(local)) {
                Node::Product(factors) => match factors.as_ref() {
                    [(base, e)] => {
                        let (sum, doubled) = self.power_of_sum(*base)?;
                        (doubled == 2).then_some((sum, *e))
                    }
                    _ => None,
                },
                _ => self.power_of_sum(self.definition(local)),
            },
            _ => None,
        }
    }
}
