//! Hash-consed expression graph: each expression is stored once; nodes are numbered in the order of creation.
//!
//! **Invariant:** nodes are immutable and hash-consed. The constructors simplify: expressions that a simplification
//! rule proves equal become one node, and every rule also holds at singular points. No output depends on the iteration
//! order of a hash map.

mod calls;
mod hash;
mod product;
mod project;
mod sum;

pub use hash::FastMap;

use crate::functions::MathFunction;
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
    /// Time since release (the start of the flight), s, as given by the time stamps of the measurements. In a model
    /// with a `clock` statement, it may run at another rate than true time; in other models it equals true time.
    Time,
    /// The constant π.
    Pi,
    /// State variable, by its index in the state vector.
    State(u32),
    /// Parameter, coefficient or input component, by its index among the layout's parameters.
    Parameter(u32),
    /// Body-fixed coordinate, m, of the marker, by its index (0 to 2).
    Marker(u32),
    /// Local symbol: stands for an intermediate value with its own definition, and is given by its index among the
    /// local symbols of the graph.
    Local(u32),
}

/// Expression whose operands are other nodes of the graph.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// Numerical constant.
    Number(Number),
    /// Leaf: state, parameter, time or another symbol.
    Symbol(Symbol),
    /// Sum Σ coefficient · node + constant: the pairs (coefficient, node), ordered by node, and the constant. There is
    /// at least one pair. If there is only one, the constant is nonzero or the coefficient is not 1.
    Sum(Box<[(Number, NodeId)]>, Number),
    /// Product of (base, *doubled* exponent) pairs, ordered by node; an odd number stands for a half-integer power. A
    /// factor with a negative exponent has the value 0 where its base is 0.
    Product(Box<[(NodeId, i32)]>),
    /// Elementary function of one argument.
    Call(MathFunction, NodeId),
    /// `atan2(y, x)` with operands y and x: angle of the point (x, y), rad; 0 at the origin.
    Atan2(NodeId, NodeId),
    /// Minimum of the two operands.
    Min(NodeId, NodeId),
    /// Maximum of the two operands.
    Max(NodeId, NodeId),
    /// Selection: the second operand where the first is 0, else the third operand.
    IfZero(NodeId, NodeId, NodeId),
}

/// Known properties of the value of an expression: whether it is constant during a flight, nonnegative, nonzero. A
/// field is `false` if the property is not known to hold.
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
    /// Definition of each local symbol (leaf that stands for an intermediate value), and the known properties of its
    /// value.
    locals: Vec<(ValueFacts, NodeId)>,
    local_of: FastMap<NodeId, NodeId>,
    /// For each sum whose square root is defined as a local symbol, the node of that symbol. Powers of the sum are
    /// written as powers of the symbol.
    root_of: FastMap<NodeId, NodeId>,
    names: FastMap<NodeId, String>,
    has_masks: bool,
    tables: Tables,
}

impl ExprGraph {
    /// Creates an empty graph.
    pub fn new() -> ExprGraph {
        ExprGraph::default()
    }

    /// Creates an empty graph whose expressions may look up values in `tables`.
    pub fn with_tables(tables: Tables) -> ExprGraph {
        ExprGraph {
            tables,
            ..ExprGraph::default()
        }
    }

    /// Tables (functions given by values at knots) that the expressions look up.
    pub fn tables(&self) -> &Tables {
        &self.tables
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

    /// Assumes that a node and all its factors are nonzero, for example because the model guarantees that a divisor is
    /// nonzero.
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

    /// Records that the value of a node is known to be ≥ 0 or nonzero, as stated by `facts.nonneg` and `facts.nonzero`.
    /// Properties already recorded remain, and `facts.fixed` is ignored.
    pub fn know(&mut self, id: NodeId, facts: ValueFacts) {
        self.facts[id.index()].nonneg |= facts.nonneg;
        if facts.nonzero {
            self.assume_nonzero(id);
        }
    }

    /// Gives a node the name `name` unless it already has one. If the node is a sum, its negative is also named, with
    /// the prefix `minus_`.
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

    /// Creates a local symbol: a leaf with the given definition, which simplification does not expand, so that a value
    /// used several times is computed once; `facts` are the known properties of this value. Sums equal to the
    /// definition are replaced by this leaf until the enclosing call of [`scope`](ExprGraph::scope) returns.
    pub fn local(&mut self, facts: ValueFacts, definition: NodeId) -> NodeId {
        self.locals.push((facts, definition));
        let id = self.intern(Node::Symbol(Symbol::Local(self.locals.len() as u32 - 1)));
        if matches!(self.node(definition), Node::Sum(..)) {
            self.local_of.insert(definition, id);
        }
        id
    }

    /// Creates a local symbol for the square root of a sum; `facts` are the known properties of the sum. Until the
    /// enclosing call of [`scope`](ExprGraph::scope) returns, the sum is replaced by the square of that symbol, so that
    /// no half-integer powers appear in derivatives.
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

    /// Runs `build` and returns its result. Meanwhile each sum that defines a local symbol is replaced by that symbol;
    /// this applies to the local symbols with indices in `locals` and to those that `build` creates. Afterwards such
    /// sums are no longer replaced, and the local symbols remain valid.
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

    /// Sum whose square root is the node `id`; `None` unless `id` is a local symbol that [`ExprGraph::local_root`]
    /// created for the square root of a sum.
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

    /// Adds the expression `node` of another graph to this graph, simplified anew, and returns the resulting node.
    /// `image` maps each direct operand of `node` to the node of this graph that takes its place.
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
            Node::Atan2(y, x) => self.atan2(image(y), image(x)),
            Node::Min(a, b) => self.min(image(a), image(b)),
            Node::Max(a, b) => self.max(image(a), image(b)),
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

    /// Nodes on which `roots` (the requested outputs) depend, roots included, in order of creation, so that operands
    /// precede their users.
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
