//! Partial evaluation: replaces symbols by constants and simplifies all expressions that depend on them.
//!
//! Nodes are rebuilt by the constructors of a new graph. Value facts carry over to the specialized nodes, since the
//! facts hold for all values of the symbols.

use crate::graph::{ExprGraph, FastMap, Node, NodeId, Symbol, ValueFacts};
use crate::number::Number;

/// Constant values of symbols such as parameters, which specialization substitutes for the symbols.
pub type Values = FastMap<Symbol, Number>;

#[derive(Debug)]
pub struct Specialized {
    pub graph: ExprGraph,
    images: Vec<Option<NodeId>>,
}

impl Specialized {
    /// Copies and simplifies what `roots` depend on, with `values` for symbols.
    pub fn new(old: &ExprGraph, roots: &[NodeId], values: &Values) -> Specialized {
        let mut new = Specialized {
            graph: old.emptied(),
            images: vec![None; old.len()],
        };
        let mut locals: FastMap<NodeId, NodeId> = FastMap::default();
        for (k, needed) in needed(old, roots).into_iter().enumerate() {
            if needed {
                let id = NodeId::new(k);
                let image = new.node(old, id, values, &mut locals);
                if new.graph.as_number(image).is_none() {
                    new.graph.know(image, old.facts(id));
                    if let Some(name) = old.name_of(id)
                        && !new.is_leaf(image)
                    {
                        new.graph.name(image, name);
                    }
                }
                new.images[k] = Some(image);
            }
        }
        new
    }

    /// Node of the new graph for `id`; 0 if the roots do not depend on it.
    pub fn image(&mut self, id: NodeId) -> NodeId {
        match self.images[id.index()] {
            Some(image) => image,
            None => self.graph.whole(0),
        }
    }

    fn is_leaf(&self, id: NodeId) -> bool {
        matches!(self.graph.node(id), Node::Symbol(s) if !matches!(s, Symbol::Local(_)))
    }

    fn node(
        &mut self,
        old: &ExprGraph,
        id: NodeId,
        values: &Values,
        locals: &mut FastMap<NodeId, NodeId>,
    ) -> NodeId {
        match old.node(id) {
            Node::Symbol(Symbol::Local(k)) => self.local(old, (id, *k), locals),
            Node::Symbol(symbol) => match values.get(symbol) {
                Some(&value) => self.graph.number(value),
                None => self.graph.symbol(*symbol),
            },
            Node::Product(factors) => {
                let factors = factors.iter().map(|&(base, exponent)| {
                    let base = self.image(base);
                    if exponent % 2 == 0 {
                        (base, exponent)
                    } else {
                        (self.graph.sqrt(base), 2 * exponent)
                    }
                });
                let factors = factors.collect();
                self.graph.product(factors)
            }
            node => {
                let images = &self.images;
                let image = |id: NodeId| images[id.index()].expect("operands precede their users");
                self.graph.rebuilt(node, &image)
            }
        }
    }

    /// Image of a local symbol: a local symbol again, unless its definition is a leaf.
    fn local(
        &mut self,
        old: &ExprGraph,
        (id, local): (NodeId, u32),
        locals: &mut FastMap<NodeId, NodeId>,
    ) -> NodeId {
        if let Some(sum) = old.rooted_sum(id) {
            let sum = self.image(sum);
            return match self.graph.node(sum) {
                Node::Sum(terms, constant) if terms.len() > 1 || !constant.is_zero() => {
                    let facts = self.graph.facts(sum);
                    self.graph.local_root(facts, sum)
                }
                _ => {
                    // An unguarded root has a nonnegative argument.
                    let facts = ValueFacts {
                        nonneg: true,
                        ..ValueFacts::default()
                    };
                    if self.graph.as_number(sum).is_none() {
                        self.graph.know(sum, facts);
                    }
                    self.graph.sqrt(sum)
                }
            };
        }
        let definition = self.image(old.definition(local));
        let worth = match self.graph.node(definition) {
            Node::Sum(terms, constant) => terms.len() > 1 || !constant.is_zero(),
            Node::Product(_) => true,
            _ => false,
        };
        if !worth {
            return definition;
        }
        if let Some(&known) = locals.get(&definition) {
            return known;
        }
        let facts = self.graph.facts(definition);
        let image = self.graph.local(facts, definition);
        locals.insert(definition, image);
        image
    }
}

/// Whether the roots depend on each node, also through local symbols.
fn needed(graph: &ExprGraph, roots: &[NodeId]) -> Vec<bool> {
    let mut needed = vec![false; graph.len()];
    for root in roots {
        needed[root.index()] = true;
    }
    // Operands and definitions precede their users.
    for k in (0..graph.len()).rev() {
        if needed[k] {
            let id = NodeId::new(k);
            graph.for_operands(id, |operand| needed[operand.index()] = true);
            if let Node::Symbol(Symbol::Local(local)) = graph.node(id) {
                needed[graph.definition(*local).index()] = true;
            }
        }
    }
    needed
}
