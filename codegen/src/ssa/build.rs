//! Translation of graph nodes to SSA.

use super::{DefId, Signed, Ssa, SsaDef, sort_terms};
use crate::functions::{BinaryFunction, MathFunction};
use crate::graph::{ExprGraph, FastMap, Node, NodeId, Symbol, ValueFacts};
use crate::number::Number;

/// Translates the graph nodes on which `roots` depend into SSA definitions.
pub fn build(graph: &ExprGraph, roots: &[NodeId]) -> Ssa {
    let mut builder = Builder {
        graph,
        ssa: Ssa::default(),
        known: FastMap::default(),
        rooted: Vec::new(),
        opposite: FastMap::default(),
    };
    let needed = builder.needed(roots);
    builder.rooted = vec![false; graph.len()];
    for &id in &needed {
        match graph.node(id) {
            Node::Product(factors) => {
                for &(base, exponent) in factors {
                    builder.rooted[base.index()] |= exponent % 2 != 0;
                    if let Some(sum) = graph.rooted_sum(base) {
                        builder.rooted[sum.index()] = true;
                    }
                }
            }
            // the argument of a function sets the sign of a sum
            Node::Call(_, x) => builder.orient(*x),
            Node::Call2(BinaryFunction::Atan2, y, x) => {
                builder.orient(*y);
                builder.orient(*x);
            }
            _ => {}
        }
    }
    for &id in &needed {
        builder.signed(id);
    }
    let roots = roots.iter().map(|&root| builder.signed(root)).collect();
    builder.ssa.roots = roots;
    builder.ssa
}

struct Builder<'a> {
    graph: &'a ExprGraph,
    ssa: Ssa,
    known: FastMap<NodeId, Signed>,
    /// For each node, by index: whether the square root of the node is used.
    rooted: Vec<bool>,
    /// Maps the terms of the negative of a sum to the node of the sum, so that the negative is expressed by that node.
    opposite: FastMap<Vec<(Number, NodeId)>, NodeId>,
}

impl Builder<'_> {
    /// What `roots` depend on, definitions of local symbols included, operands first.
    fn needed(&self, roots: &[NodeId]) -> Vec<NodeId> {
        let mut order = Vec::new();
        let mut seen = vec![false; self.graph.len()];
        let mut stack: Vec<(NodeId, bool)> =
            roots.iter().rev().map(|&root| (root, false)).collect();
        while let Some((id, done)) = stack.pop() {
            if done {
                order.push(id);
                continue;
            }
            if std::mem::replace(&mut seen[id.index()], true) {
                continue;
            }
            stack.push((id, true));
            if let Node::Symbol(Symbol::Local(k)) = self.graph.node(id) {
                stack.push((self.graph.definition(*k), false));
            }
            self.graph
                .for_operands(id, |operand| stack.push((operand, false)));
        }
        order
    }

    fn orient(&mut self, id: NodeId) {
        if let Node::Sum(terms, constant) = self.graph.node(id)
            && constant.is_zero()
            && terms.len() > 1
        {
            let negated: Vec<_> = terms.iter().map(|&(c, t)| (c.opposite(), t)).collect();
            if !self.opposite.contains_key(terms.as_ref()) {
                self.opposite.insert(negated, id);
            }
        }
    }

    fn signed(&mut self, id: NodeId) -> Signed {
        if let Some(&known) = self.known.get(&id) {
            return known;
        }
        let signed = self.convert(id);
        self.known.insert(id, signed);
        signed
    }

    fn constant(&mut self, number: Number) -> DefId {
        let facts = ValueFacts {
            fixed: true,
            nonneg: true,
            nonzero: !number.is_zero(),
        };
        self.ssa.define(SsaDef::Constant(number), facts, None)
    }

    fn convert(&mut self, id: NodeId) -> Signed {
        let facts = self.graph.facts(id);
        let origin = Some((false, id));
        match self.graph.node(id) {
            Node::Number(number) => (number.is_negative(), self.constant(number.abs())),
            Node::Symbol(Symbol::Local(k)) => {
                let signed = self.signed(self.graph.definition(*k));
                // the local's name and facts take precedence
                if self.graph.name_of(id).is_some() {
                    self.ssa.origin[signed.1] = Some((signed.0, id));
                }
                if !signed.0 {
                    self.ssa.facts[signed.1] = facts;
                }
                signed
            }
            Node::Symbol(symbol) => (false, self.ssa.define(SsaDef::Leaf(*symbol), facts, origin)),
            Node::Sum(terms, constant) => self.sum(id, terms, *constant),
            Node::Product(factors) => self.product(Number::ONE, factors, id),
            Node::Call(function, base) => {
                let mut x = self.signed(*base);
                if *function == MathFunction::NonZero && self.rooted[base.index()] {
                    // test the norm for 0, whose reciprocal is used, instead of the square of the norm
                    let root = self.graph.root_node(*base).map(|node| (false, node));
                    let facts = self.graph.facts(*base);
                    x = (false, self.ssa.define(SsaDef::Root(x.1), facts, root));
                }
                let def = SsaDef::Call(*function, x);
                (false, self.ssa.define(def, facts, origin))
            }
            Node::Call2(function, a, b) => {
                let def = SsaDef::Call2(*function, self.signed(*a), self.signed(*b));
                (false, self.ssa.define(def, facts, origin))
            }
            Node::IfZero(condition, a, b) => {
                let condition = self.signed(*condition).1;
                let def = SsaDef::IfZero(condition, self.signed(*a), self.signed(*b));
                (false, self.ssa.define(def, facts, origin))
            }
        }
    }

    fn sum(&mut self, id: NodeId, terms: &[(Number, NodeId)], constant: Number) -> Signed {
        if let Some(&other) = self.opposite.get(terms)
            && constant.is_zero()
        {
            let (minus, def) = self.signed(other);
            return (!minus, def);
        }
        if let [(c, single)] = terms
            && constant.is_zero()
        {
            return self.term(*c, *single);
        }
        let mut signed: Vec<Signed> = terms.iter().map(|&(c, term)| self.term(c, term)).collect();
        if !constant.is_zero() {
            signed.push((constant.is_negative(), self.constant(constant.abs())));
        }
        sort_terms(&mut signed);
        let (facts, origin) = (self.graph.facts(id), Some((false, id)));
        (false, self.ssa.define(SsaDef::Sum(signed), facts, origin))
    }

    fn term(&mut self, coefficient: Number, id: NodeId) -> Signed {
        if coefficient.abs().is_one() {
            let (minus, def) = self.signed(id);
            return (minus != coefficient.is_negative(), def);
        }
        match self.graph.node(id) {
            Node::Product(factors) => self.product(coefficient, factors, id),
            _ => self.product(coefficient, &[(id, 2)], id),
        }
    }

    fn product(&mut self, coefficient: Number, factors: &[(NodeId, i32)], id: NodeId) -> Signed {
        let mut minus = coefficient.is_negative();
        let mut flat = Vec::new();
        if !coefficient.abs().is_one() {
            flat.push(self.constant(coefficient.abs()));
        }
        for &(base, exponent) in factors {
            // a local square root is written as a power of its sum
            let (base, exponent) = match self.graph.rooted_sum(base) {
                Some(sum) if exponent % 2 == 0 => (sum, exponent / 2),
                _ => (base, exponent),
            };
            let (negated, def) = self.signed(base);
            minus ^= negated && exponent % 4 != 0;
            let facts = self.graph.facts(base);
            let times = exponent.unsigned_abs() as usize;
            let root = |ssa: &mut Ssa| {
                let origin = self.graph.root_node(base).map(|node| (false, node));
                ssa.define(SsaDef::Root(def), facts, origin)
            };
            if exponent < 0 {
                let (x, times) = if self.rooted[base.index()] {
                    (root(&mut self.ssa), times)
                } else {
                    (def, times / 2)
                };
                let recip = self.ssa.define(SsaDef::Recip(x), facts, None);
                flat.extend(std::iter::repeat_n(recip, times));
            } else {
                if exponent % 2 != 0 {
                    flat.push(root(&mut self.ssa));
                }
                flat.extend(std::iter::repeat_n(def, times / 2));
            }
        }
        flat.sort_unstable();
        if let [single] = flat.as_slice() {
            return (minus, *single);
        }
        let facts = self.ssa.product_facts(&flat);
        // with a coefficient the value differs from the node
        let origin = coefficient.abs().is_one().then_some((minus, id));
        (minus, self.ssa.define(SsaDef::Product(flat), facts, origin))
    }
}
