//! The shared graph: every expression once, numbered in the order of creation.
//!
//! **Invariant:** nodes are immutable and hash-consed; the constructors simplify, so that equal
//! nodes are (as far as the rules go) equal values, singular points included. Nothing that reaches
//! the output depends on the iteration order of a hash map.

mod calls;
mod hash;
mod print;
mod product;
mod project;
mod sum;

pub use hash::FastMap;

use crate::functions::MathFunction;
use crate::number::Number;
use std::ops::Range;

model_spec::index_type!(
    /// Index of a node in an [`ExprGraph`]; operands have smaller ones than their users.
    pub struct NodeId;
);

/// A leaf with a value from outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Symbol {
    /// Time since release.
    Time,
    /// The ratio of a circle's circumference to its diameter.
    Pi,
    /// A state, by its index in the layout.
    State(u32),
    /// A parameter, coefficient or component of an input, by its index in the layout.
    Parameter(u32),
    /// A coordinate of the marker.
    Marker(u32),
    /// An intermediate result of an earlier pass.
    Local(u32),
}

/// An expression over other nodes.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// A constant.
    Number(Number),
    /// A leaf.
    Symbol(Symbol),
    /// Constant plus terms, each with its coefficient, ordered by node. At least one term, and either
    /// two summands or a coefficient that is not 1.
    Sum(Box<[(Number, NodeId)]>, Number),
    /// Factors with *twice* their exponents, ordered by node; odd ones stand for roots. A negative
    /// exponent on a factor that may be zero gives 0 there.
    Product(Box<[(NodeId, i32)]>),
    /// A function of one argument.
    Call(MathFunction, NodeId),
    /// Angle of the point (second, first).
    Atan2(NodeId, NodeId),
    /// The smaller.
    Min(NodeId, NodeId),
    /// The greater.
    Max(NodeId, NodeId),
    /// The second where the first is 0, else the third.
    IfZero(NodeId, NodeId, NodeId),
}

/// What is known about a node.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ValueFacts {
    /// Depends on nothing that changes during a flight.
    pub fixed: bool,
    /// Never below 0.
    pub nonneg: bool,
    /// Never 0, proved or assumed.
    pub nonzero: bool,
}

/// What the opposite of something is called.
pub fn opposite_name(name: &str) -> String {
    name.strip_prefix("minus_")
        .map_or_else(|| format!("minus_{name}"), str::to_string)
}

/// The graph.
#[derive(Clone, Debug, Default)]
pub struct ExprGraph {
    nodes: Vec<Node>,
    facts: Vec<ValueFacts>,
    index: FastMap<Node, NodeId>,
    contents: FastMap<NodeId, product::Content>,
    /// ValueFacts and definitions of [`Symbol::Local`]s.
    locals: Vec<(ValueFacts, NodeId)>,
    local_of: FastMap<NodeId, NodeId>,
    /// Sums whose square root is a local: their powers are powers of that.
    root_of: FastMap<NodeId, NodeId>,
    names: FastMap<NodeId, String>,
    has_masks: bool,
}

impl ExprGraph {
    /// An empty graph.
    pub fn new() -> ExprGraph {
        ExprGraph::default()
    }

    /// How many nodes it has.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether it has none.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// A node.
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.index()]
    }

    /// What is known about it.
    pub fn facts(&self, id: NodeId) -> ValueFacts {
        self.facts[id.index()]
    }

    /// States that a node is never 0 (it is a divisor that the model's author answers for).
    pub fn assume_nonzero(&mut self, id: NodeId) {
        self.facts[id.index()].nonzero = true;
        match self.node(id).clone() {
            Node::Product(factors) => factors
                .iter()
                .for_each(|&(factor, _)| self.assume_nonzero(factor)),
            Node::Sum(terms, constant) if terms.len() == 1 && constant.is_zero() => {
                self.assume_nonzero(terms[0].1)
            }
            _ => {}
        }
    }

    /// States what is known of a node's value from elsewhere.
    pub fn know(&mut self, id: NodeId, facts: ValueFacts) {
        self.facts[id.index()].nonneg |= facts.nonneg;
        if facts.nonzero {
            self.assume_nonzero(id);
        }
    }

    /// Gives a node a name, unless it has one already; the opposite of a sum is called after it.
    pub fn name(&mut self, id: NodeId, name: impl Into<String>) {
        let name = name.into();
        if let Node::Sum(terms, _) = self.node(id)
            && terms.len() > 1
            && !self.names.contains_key(&id)
        {
            let opposite = self.neg(id);
            self.names
                .entry(opposite)
                .or_insert_with(|| opposite_name(&name));
        }
        self.names.entry(id).or_insert(name);
    }

    /// The name of a node.
    pub fn name_of(&self, id: NodeId) -> Option<&str> {
        self.names.get(&id).map(String::as_str)
    }

    /// A new leaf that stands for `definition`. The rules of simplification do not look inside, so that a value used
    /// several times is computed once. Within the current [scope](ExprGraph::scope) an equal sum becomes this leaf.
    pub fn local(&mut self, facts: ValueFacts, definition: NodeId) -> NodeId {
        self.locals.push((facts, definition));
        let id = self.intern(Node::Symbol(Symbol::Local(self.locals.len() as u32 - 1)));
        if matches!(self.node(definition), Node::Sum(..)) {
            self.local_of.insert(definition, id);
        }
        id
    }

    /// A new leaf that stands for the square root of a sum. Within the current scope the sum becomes the square of the
    /// leaf, so that no half powers appear in derivatives.
    pub fn local_root(&mut self, facts: ValueFacts, sum: NodeId) -> NodeId {
        let definition = self.intern(Node::Product(Box::new([(sum, 1)])));
        let root = self.local(
            ValueFacts {
                nonneg: true,
                ..facts
            },
            definition,
        );
        self.root_of.insert(sum, root);
        root
    }

    /// How many leaves with definitions there are.
    pub fn local_count(&self) -> usize {
        self.locals.len()
    }

    /// Runs `build` with sums replaced by the leaves `locals` that stand for them, and by those that `build` adds.
    /// Afterwards they are ordinary sums again; the leaves stay valid.
    pub fn scope<R>(&mut self, locals: Range<usize>, build: impl FnOnce(&mut ExprGraph) -> R) -> R {
        let first = self.locals.len();
        let contents = std::mem::take(&mut self.contents);
        for k in locals.clone() {
            let leaf = self.symbol(Symbol::Local(k as u32));
            let definition = self.locals[k].1;
            if matches!(self.node(definition), Node::Sum(..)) {
                self.local_of.insert(definition, leaf);
            } else if let Some(sum) = self.rooted_sum(leaf) {
                self.root_of.insert(sum, leaf);
            }
        }
        let result = build(self);
        for k in locals.chain(first..self.locals.len()) {
            let definition = self.locals[k].1;
            self.local_of.remove(&definition);
            let leaf = self.symbol(Symbol::Local(k as u32));
            if let Some(sum) = self.rooted_sum(leaf) {
                self.root_of.remove(&sum);
            }
        }
        self.contents = contents;
        result
    }

    /// The sum whose root a node is, if it is a local made by [`ExprGraph::local_root`].
    pub fn rooted_sum(&self, id: NodeId) -> Option<NodeId> {
        let Node::Symbol(Symbol::Local(k)) = self.node(id) else {
            return None;
        };
        match self.node(self.definition(*k)) {
            Node::Product(factors) => match factors.as_ref() {
                [(sum, 1)] => Some(*sum),
                _ => None,
            },
            _ => None,
        }
    }

    /// The node of the square root of a node, if there is one.
    pub fn root_node(&self, id: NodeId) -> Option<NodeId> {
        match self.root_of.get(&id) {
            Some(&root) => Some(root),
            None => self.find(&Node::Product(Box::new([(id, 1)]))),
        }
    }

    /// What a [`Symbol::Local`] stands for.
    pub fn definition(&self, local: u32) -> NodeId {
        self.locals[local as usize].1
    }

    /// A leaf.
    pub fn symbol(&mut self, symbol: Symbol) -> NodeId {
        self.intern(Node::Symbol(symbol))
    }

    /// A constant.
    pub fn number(&mut self, number: Number) -> NodeId {
        self.intern(Node::Number(number))
    }

    /// A whole constant.
    pub fn whole(&mut self, value: i64) -> NodeId {
        self.number(Number::whole(value))
    }

    /// Its value, where it is a constant.
    pub fn as_number(&self, id: NodeId) -> Option<Number> {
        match self.node(id) {
            Node::Number(number) => Some(*number),
            _ => None,
        }
    }

    /// Whether it is the constant 0.
    pub fn is_zero(&self, id: NodeId) -> bool {
        self.as_number(id).is_some_and(Number::is_zero)
    }

    /// The node, if it exists already.
    fn find(&self, node: &Node) -> Option<NodeId> {
        self.index.get(node).copied()
    }

    fn intern(&mut self, node: Node) -> NodeId {
        if let Some(&id) = self.index.get(&node) {
            return id;
        }
        let id = NodeId::new(self.nodes.len());
        let facts = self.derive_facts(&node);
        self.has_masks |= matches!(node, Node::Call(MathFunction::NonZero, _));
        self.index.insert(node.clone(), id);
        self.nodes.push(node);
        self.facts.push(facts);
        id
    }

    fn derive_facts(&self, node: &Node) -> ValueFacts {
        let of = |id: &NodeId| self.facts(*id);
        match node {
            Node::Number(n) => ValueFacts {
                fixed: true,
                nonneg: !n.is_negative(),
                nonzero: !n.is_zero(),
            },
            Node::Symbol(Symbol::Pi) => ValueFacts {
                fixed: true,
                nonneg: true,
                nonzero: true,
            },
            Node::Symbol(Symbol::Parameter(_)) => ValueFacts {
                fixed: true,
                ..ValueFacts::default()
            },
            Node::Symbol(Symbol::Local(k)) => self.locals[*k as usize].0,
            Node::Symbol(_) => ValueFacts::default(),
            Node::Sum(terms, constant) => {
                let nonneg = !constant.is_negative()
                    && terms.iter().all(|(c, t)| !c.is_negative() && of(t).nonneg);
                let scaled = terms.len() == 1 && constant.is_zero() && of(&terms[0].1).nonzero;
                ValueFacts {
                    fixed: terms.iter().all(|(_, t)| of(t).fixed),
                    nonneg,
                    nonzero: scaled
                        || nonneg
                            && (!constant.is_zero() || terms.iter().any(|(_, t)| of(t).nonzero)),
                }
            }
            Node::Product(factors) => ValueFacts {
                fixed: factors.iter().all(|(f, _)| of(f).fixed),
                nonneg: factors
                    .iter()
                    .all(|(f, e)| e % 4 == 0 || e % 2 != 0 || of(f).nonneg),
                nonzero: factors.iter().all(|(f, _)| of(f).nonzero),
            },
            Node::Call(function, x) => ValueFacts {
                fixed: of(x).fixed,
                nonneg: function.is_nonneg(),
                nonzero: function.is_nonzero(of(x).nonzero),
            },
            Node::Atan2(a, b) => ValueFacts {
                fixed: of(a).fixed && of(b).fixed,
                ..ValueFacts::default()
            },
            Node::Min(a, b) | Node::Max(a, b) => ValueFacts {
                fixed: of(a).fixed && of(b).fixed,
                nonneg: of(a).nonneg && of(b).nonneg,
                nonzero: of(a).nonzero && of(b).nonzero && of(a).nonneg && of(b).nonneg,
            },
            Node::IfZero(c, a, b) => ValueFacts {
                fixed: of(c).fixed && of(a).fixed && of(b).fixed,
                nonneg: of(a).nonneg && of(b).nonneg,
                nonzero: of(a).nonzero && of(b).nonzero,
            },
        }
    }

    /// Calls `visit` with every operand of a node.
    pub fn for_operands(&self, id: NodeId, mut visit: impl FnMut(NodeId)) {
        match self.node(id) {
            Node::Number(_) | Node::Symbol(_) => {}
            Node::Sum(terms, _) => terms.iter().for_each(|&(_, t)| visit(t)),
            Node::Product(factors) => factors.iter().for_each(|&(f, _)| visit(f)),
            Node::Call(_, x) => visit(*x),
            Node::Atan2(a, b) | Node::Min(a, b) | Node::Max(a, b) => {
                visit(*a);
                visit(*b);
            }
            Node::IfZero(a, b, c) => {
                visit(*a);
                visit(*b);
                visit(*c);
            }
        }
    }

    /// Every node that the roots need, operands first, in order of creation.
    pub fn reachable(&self, roots: &[NodeId]) -> Vec<NodeId> {
        let mut needed = vec![false; self.len()];
        for root in roots {
            needed[root.index()] = true;
        }
        // operands are created before their users
        for k in (0..self.len()).rev() {
            if needed[k] {
                self.for_operands(NodeId::new(k), |operand| needed[operand.index()] = true);
            }
        }
        (0..self.len())
            .filter(|&k| needed[k])
            .map(NodeId::new)
            .collect()
    }
}
