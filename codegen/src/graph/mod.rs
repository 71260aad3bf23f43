//! Hash-consed expression graph: each expression is stored once; nodes are numbered in the order of creation.
//!
//! **Invariant:** nodes are immutable and hash-consed. The constructors simplify: expressions that a simplification
//! rule proves equal become one node, and every rule also holds at singular points. No output depends on the iteration
//! order of a hash map.

mod calls;
mod hash;
mod held;
mod product;
mod project;
mod saturate;
mod sum;

pub use hash::FastMap;

use crate::functions::{BinaryFunction, MathFunction};
use crate::number::Number;
use crate::table::Tables;
use std::ops::Range;

model_spec::index_type!(
    /// Index of a node in an [`ExprGraph`]; operands have smaller indices than the nodes that use them.
    pub struct NodeId;
);

/// Leaf of an expression: a variable or constant whose value is not computed by the graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Symbol {
    /// Recorded time since release, s.
    Time,
    /// The constant π.
    Pi,
    /// State variable, by its index in the state vector.
    State(u32),
    /// Parameter, coefficient or input component, by its index among the layout's parameters.
    Parameter(u32),
    /// Body-fixed coordinate, m, of the marker, by its index (0 to 2).
    Marker(u32),
    /// Local symbol, which stands for an intermediate value, by its index.
    Local(u32),
}

/// Expression whose operands are other nodes of the graph.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// Numerical constant.
    Number(Number),
    /// Leaf: state, parameter, time or another symbol.
    Symbol(Symbol),
    /// Sum Σ coefficient · node + constant, ordered by node; a single term has a coefficient or a constant.
    Sum(Box<[(Number, NodeId)]>, Number),
    /// Product of (base, doubled exponent) pairs, ordered by node; 0 where a base of negative exponent is 0.
    Product(Box<[(NodeId, i32)]>),
    /// Elementary function of one argument.
    Call(MathFunction, NodeId),
    /// Function of two arguments.
    Call2(BinaryFunction, NodeId, NodeId),
    /// Selection: the second operand where the first is 0, else the third operand.
    IfZero(NodeId, NodeId, NodeId),
}

/// Properties of a value that are known to hold.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ValueFacts {
    /// Whether the value is constant during a flight, because it depends on constants and parameters only.
    pub fixed: bool,
    /// Whether the value is known to be ≥ 0.
    pub nonneg: bool,
    /// Whether the value is known to be nonzero, by proof or by assumption.
    pub nonzero: bool,
}

/// Name of the negative of a named quantity: adds the prefix `minus_`, or removes the prefix if present.
pub fn opposite_name(name: &str) -> String {
    name.strip_prefix("minus_")
        .map_or_else(|| format!("minus_{name}"), str::to_string)
}

/// Hash-consed graph of simplified scalar expressions: identical expressions share one node.
#[derive(Clone, Debug, Default)]
pub struct ExprGraph {
    nodes: Vec<Node>,
    facts: Vec<ValueFacts>,
    index: FastMap<Node, NodeId>,
    contents: FastMap<NodeId, product::Content>,
    /// Definition of each local symbol, and the known properties of its value.
    locals: Vec<(ValueFacts, NodeId)>,
    local_of: FastMap<NodeId, NodeId>,
    /// Local symbol of the square root of a sum, which replaces powers of the sum.
    root_of: FastMap<NodeId, NodeId>,
    names: FastMap<NodeId, String>,
    has_masks: bool,
    has_exponentials: bool,
    tables: Tables,
    /// Indices of the parameters that may vary during a flight.
    varying: Vec<u32>,
}

impl ExprGraph {
    /// Creates an empty graph whose expressions may look up values in `tables`, and in which the parameters with the
    /// indices `varying` may vary during a flight.
    pub fn with_tables(tables: Tables, varying: Vec<u32>) -> ExprGraph {
        ExprGraph {
            tables,
            varying,
            ..ExprGraph::default()
        }
    }

    /// Tables that the expressions look up.
    pub fn tables(&self) -> &Tables {
        &self.tables
    }

    /// An empty graph with the tables and the varying parameters of this one.
    pub(crate) fn emptied(&self) -> ExprGraph {
        ExprGraph::with_tables(self.tables.clone(), self.varying.clone())
    }

    /// Name of a function, such as `exp` or the name of a table, for printed expressions and names of variables.
    pub fn function_name(&self, function: MathFunction) -> String {
        match function {
            MathFunction::Table(function) => self.tables.name(function),
            _ => function.name().to_owned(),
        }
    }

    /// Number of nodes in the graph.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether the graph has no nodes.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Expression of the node with index `id`.
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.index()]
    }

    /// Known properties of the value of a node: whether it is constant during a flight, nonnegative, nonzero.
    pub fn facts(&self, id: NodeId) -> ValueFacts {
        self.facts[id.index()]
    }

    /// Assumes that a node and all its factors are nonzero.
    pub fn assume_nonzero(&mut self, id: NodeId) {
        self.facts[id.index()].nonzero = true;
        match self.node(id).clone() {
            Node::Product(factors) => factors
                .iter()
                .for_each(|&(factor, _)| self.assume_nonzero(factor)),
            Node::Sum(terms, constant) if terms.len() == 1 && constant.is_zero() => {
                self.assume_nonzero(terms[0].1);
            }
            _ => {}
        }
    }

    /// Adds `facts.nonneg` and `facts.nonzero` to what is known of a node.
    pub fn know(&mut self, id: NodeId, facts: ValueFacts) {
        self.facts[id.index()].nonneg |= facts.nonneg;
        if facts.nonzero {
            self.assume_nonzero(id);
        }
    }

    /// Names a node that has no name, and the negative of a sum.
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

    /// Name of a node; `None` if unnamed.
    pub fn name_of(&self, id: NodeId) -> Option<&str> {
        self.names.get(&id).map(String::as_str)
    }

    /// Creates a local symbol, which replaces the sum that defines it until [`scope`](ExprGraph::scope) returns.
    pub fn local(&mut self, facts: ValueFacts, definition: NodeId) -> NodeId {
        self.locals.push((facts, definition));
        let id = self.intern(Node::Symbol(Symbol::Local(self.locals.len() as u32 - 1)));
        if matches!(self.node(definition), Node::Sum(..)) {
            self.local_of.insert(definition, id);
        }
        id
    }

    /// Creates a local symbol for the square root of a sum, whose square replaces the sum in the scope.
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

    /// Number of local symbols, that is, leaves with a definition.
    pub fn local_count(&self) -> usize {
        self.locals.len()
    }

    /// Runs `build`, during which the sums of `locals` and of new local symbols are replaced by these symbols.
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

    /// Sum whose square root is the local symbol `id`.
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

    /// Existing node for the square root of the node `id`; `None` if the graph contains no such node.
    pub fn root_node(&self, id: NodeId) -> Option<NodeId> {
        match self.root_of.get(&id) {
            Some(&root) => Some(root),
            None => self.find(&Node::Product(Box::new([(id, 1)]))),
        }
    }

    /// Node that defines the local symbol with the index `local`.
    pub fn definition(&self, local: u32) -> NodeId {
        self.locals[local as usize].1
    }

    /// Node of a leaf symbol, created if missing.
    pub fn symbol(&mut self, symbol: Symbol) -> NodeId {
        self.intern(Node::Symbol(symbol))
    }

    /// Node of a numerical constant, created if missing.
    pub fn number(&mut self, number: Number) -> NodeId {
        self.intern(Node::Number(number))
    }

    /// Node of an integer constant, created if missing.
    pub fn whole(&mut self, value: i64) -> NodeId {
        self.number(Number::whole(value))
    }

    /// Value of a constant node; `None` for any other node.
    pub fn as_number(&self, id: NodeId) -> Option<Number> {
        match self.node(id) {
            Node::Number(number) => Some(*number),
            _ => None,
        }
    }

    /// Whether a node is the constant 0.
    pub fn is_zero(&self, id: NodeId) -> bool {
        self.as_number(id).is_some_and(Number::is_zero)
    }

    /// Index of an identical existing node; `None` if there is none.
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
        self.has_exponentials |= matches!(node, Node::Call(MathFunction::Exp, _));
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
            Node::Symbol(Symbol::Parameter(k)) => ValueFacts {
                fixed: !self.varying.contains(k),
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
            Node::Call2(function, a, b) => {
                let (a, b) = (of(a), of(b));
                let is_choice = matches!(function, BinaryFunction::Min | BinaryFunction::Max);
                let nonneg = is_choice && a.nonneg && b.nonneg;
                ValueFacts {
                    fixed: a.fixed && b.fixed,
                    nonneg,
                    nonzero: nonneg && a.nonzero && b.nonzero,
                }
            }
            Node::IfZero(c, a, b) => ValueFacts {
                fixed: of(c).fixed && of(a).fixed && of(b).fixed,
                nonneg: of(a).nonneg && of(b).nonneg,
                nonzero: of(a).nonzero && of(b).nonzero,
            },
        }
    }

    /// Adds a node of another graph, simplified anew; `image` maps its operands.
    pub fn rebuilt(&mut self, node: &Node, image: &dyn Fn(NodeId) -> NodeId) -> NodeId {
        match *node {
            Node::Number(number) => self.number(number),
            Node::Symbol(symbol) => self.symbol(symbol),
            Node::Sum(ref terms, constant) => {
                let terms = terms.iter().map(|&(c, term)| (c, image(term)));
                self.sum(terms.collect(), constant)
            }
            Node::Product(ref factors) => {
                let factors = factors.iter().map(|&(base, e)| (image(base), e));
                self.product(factors.collect())
            }
            Node::Call(function, x) => self.call(function, image(x)),
            Node::Call2(function, a, b) => self.call2(function, image(a), image(b)),
            Node::IfZero(c, a, b) => self.if_zero(image(c), image(a), image(b)),
        }
    }

    /// Calls `visit` with each direct operand of a node.
    pub fn for_operands(&self, id: NodeId, mut visit: impl FnMut(NodeId)) {
        match self.node(id) {
            Node::Number(_) | Node::Symbol(_) => {}
            Node::Sum(terms, _) => terms.iter().for_each(|&(_, t)| visit(t)),
            Node::Product(factors) => factors.iter().for_each(|&(f, _)| visit(f)),
            Node::Call(_, x) => visit(*x),
            Node::Call2(_, a, b) => {
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

    /// Nodes on which `roots` depend, roots included, in order of creation, so that operands precede their users.
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
