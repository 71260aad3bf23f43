//! Simplification of projections: `(a·e1) e1 + (a·e2) e2` becomes `a` for orthonormal e1, e2 that span `a`.
//!
//! Products are expanded only here, and only where terms then cancel or merge: in sums of vector components with a
//! factor that is a negative power of the vector's length.

use super::{ExprGraph, Node, NodeId};
use crate::number::Number;

const MAX_TERMS: usize = 48;

impl ExprGraph {
    /// Expands products of sums, if projections onto orthonormal vectors then cancel.
    pub fn project(&mut self, id: NodeId) -> NodeId {
        let Node::Sum(terms, constant) = self.node(id).clone() else {
            return id;
        };
        let lengths = self.lengths(id, 3);
        for length in lengths {
            let Node::Sum(squares, _) = self.node(length).clone() else {
                continue;
            };
            let components: Vec<NodeId> = squares
                .iter()
                .filter_map(|&(_, square)| match self.node(square) {
                    Node::Product(factors) if factors.len() == 1 && factors[0].1 == 4 => {
                        Some(factors[0].0)
                    }
                    _ => None,
                })
                .collect();
            let mut open = Vec::new();
            for &(c, term) in &terms {
                self.open_term(c, term, &components, &mut open, 4);
            }
            if open.len() == terms.len() || open.len() > MAX_TERMS {
                continue;
            }
            let before = open.len();
            let result = self.sum(open, constant);
            let after = match self.node(result) {
                Node::Sum(terms, _) => terms.len(),
                _ => 1,
            };
            if after < before {
                return result;
            }
        }
        id
    }

    /// Sums in negative powers, which may be squared lengths, at most `depth` levels deep; sorted.
    fn lengths(&self, id: NodeId, depth: u32) -> Vec<NodeId> {
        let mut found = Vec::new();
        let mut pending = vec![(id, depth)];
        while let Some((at, depth)) = pending.pop() {
            if let Node::Product(factors) = self.node(at) {
                for &(base, exponent) in factors {
                    if exponent < 0 && matches!(self.node(base), Node::Sum(..)) {
                        found.push(base);
                    }
                }
            }
            if depth > 0 {
                self.for_operands(at, |operand| pending.push((operand, depth - 1)));
            }
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Expands `c · term` in sums with a factor of `components`, at most `depth` levels deep.
    fn open_term(
        &mut self,
        c: Number,
        term: NodeId,
        components: &[NodeId],
        open: &mut Vec<(Number, NodeId)>,
        depth: u32,
    ) {
        let factors = self.monomial(term);
        let holder = factors
            .iter()
            .position(|&(factor, exponent)| exponent == 2 && self.holds(factor, components, depth));
        let Some(holder) = holder else {
            open.push((c, term));
            return;
        };
        let mut others = factors.clone();
        let (sum, _) = others.remove(holder);
        let Node::Sum(inner, constant) = self.node(sum).clone() else {
            return;
        };
        for (inner_c, inner_term) in inner {
            let mut product = others.clone();
            product.push((inner_term, 2));
            let product = self.product(product);
            let (scale, product) = self.split_coefficient(product);
            self.open_term(
                c.times(inner_c).times(scale),
                product,
                components,
                open,
                depth - 1,
            );
        }
        if !constant.is_zero() {
            let product = self.product(others);
            self.open_term(c.times(constant), product, components, open, depth - 1);
        }
    }

    /// Whether a sum has one of `components` as a factor of a term, at most `depth` levels deep.
    fn holds(&self, id: NodeId, components: &[NodeId], depth: u32) -> bool {
        let Node::Sum(terms, _) = self.node(id) else {
            return false;
        };
        depth > 0
            && !components.contains(&id)
            && terms.iter().any(|&(_, term)| {
                self.monomial(term).iter().any(|&(factor, exponent)| {
                    exponent == 2
                        && (components.contains(&factor)
                            || self.holds(factor, components, depth - 1))
                })
            })
    }
}
