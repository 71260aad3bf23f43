//! Formulas in terms of the auxiliary variables of the model, with derivatives by the chain rule.

use super::find::{FoundQuantity, symbol_of};
use crate::differentiate::partials;
use crate::graph::{ExprGraph, FastMap, Node, NodeId, Symbol, ValueFacts};
use crate::latex::node;
use crate::latex::piece::{Bind, Piece};
use crate::layout::Layout;
use crate::number::Number;
use model_spec::model::Model;

pub(super) struct Formulas {
    pub values: Vec<String>,
    pub derivatives: Vec<String>,
}

/// Writes the LaTeX formulas of a quantity and, if `by` is given, of its derivative with respect to that symbol.
pub(super) fn formulas(
    model: &Model,
    found: &FoundQuantity,
    by: Option<(Symbol, &str)>,
) -> Formulas {
    let mut cut = Cut::new(model, &found.compiler.lowered.graph, &found.nodes);
    let mut roots = cut.roots.clone();
    for root in &mut roots {
        *root = cut.inside(*root);
    }
    for root in &mut roots {
        *root = cut.share_repeated(*root);
    }
    let values = roots.iter().zip(&found.symbols);
    let values = values.map(|(&root, left)| format!("{left} = {}", cut.write(root)));
    let mut values: Vec<String> = values.collect();
    let mut derivatives = Vec::new();
    if let Some((symbol, wrt)) = by {
        cut.by = symbol;
        cut.wrt = symbol_of(model, wrt);
        let mut needed = Vec::new();
        for (&root, left) in roots.iter().zip(&found.symbols) {
            let derivative = cut.derivative(root);
            let left = fraction(left, &cut.wrt);
            derivatives.push(format!("{left} = {}", cut.write(derivative)));
            needed.push(derivative);
        }
        // Formulas precede the derivatives to which they refer.
        for local in cut.mentioned(&needed).into_iter().rev() {
            let (left, definition) = (cut.names[&local].clone(), cut.graph.definition(local));
            derivatives.push(format!("{left} = {}", cut.write(definition)));
        }
    }
    // Formulas precede the parts to which they refer.
    let last = if by.is_some() {
        &mut derivatives
    } else {
        &mut values
    };
    for &part in cut.parts.iter().rev() {
        let definition = cut.write(cut.graph.definition(part));
        last.push(format!("{} = {definition}", cut.names[&part]));
    }
    Formulas {
        values,
        derivatives,
    }
}

fn fraction(above: &str, below: &str) -> String {
    format!(r"\frac{{\partial {above}}}{{\partial {below}}}")
}

const MAX_FORMULA: u64 = 2_000;

/// Minimum size, in nodes, of a repeated subexpression with a name of its own.
const MIN_PART: u64 = 6;

/// Maps each nameless negative of a named sum to that sum.
fn opposites(source: &ExprGraph) -> FastMap<NodeId, NodeId> {
    let mut graph = source.clone();
    let mut opposites = FastMap::default();
    for id in (0..source.len()).map(NodeId::new) {
        if source.name_of(id).is_some() && matches!(source.node(id), Node::Sum(..)) {
            let opposite = graph.neg(id);
            let own = source.name_of(opposite);
            let own = own.filter(|own| own.strip_prefix("minus_") != source.name_of(id));
            if opposite.index() < source.len() && own.is_none() {
                opposites.insert(opposite, id);
            }
        }
    }
    opposites
}

/// Copy of an expression graph in which named nodes are local symbols.
pub(super) struct Cut {
    pub graph: ExprGraph,
    /// Nodes of the copy that correspond to the requested nodes of the original graph, in the same order.
    pub roots: Vec<NodeId>,
    layout: Layout,
    /// LaTeX name of each local symbol, by the index of the symbol.
    names: FastMap<u32, String>,
    /// For each sum whose square root is a named quantity V, the node V², where V is the local symbol of the quantity.
    squares: FastMap<NodeId, NodeId>,
    /// Indices of the local symbols that represent derivatives of named quantities, in order of creation.
    made: Vec<u32>,
    /// Indices of the local symbols that represent repeated subexpressions of large formulas, in order of creation.
    parts: Vec<u32>,
    pub by: Symbol,
    wrt: String,
    known: FastMap<NodeId, NodeId>,
}

impl Cut {
    pub fn new(model: &Model, source: &ExprGraph, roots: &[NodeId]) -> Cut {
        let mut cut = Cut {
            graph: source.emptied(),
            roots: Vec::new(),
            layout: Layout::new(model),
            names: FastMap::default(),
            squares: FastMap::default(),
            made: Vec::new(),
            parts: Vec::new(),
            by: Symbol::Time,
            wrt: String::new(),
            known: FastMap::default(),
        };
        let mut images: FastMap<NodeId, NodeId> = FastMap::default();
        let opposites = opposites(source);
        let mut wanted = roots.to_vec();
        // Named nodes that the roots do not reach are included for their names.
        let all = (0..source.len()).map(NodeId::new);
        wanted.extend(all.filter(|&id| source.name_of(id).is_some()));
        for id in source.reachable(&wanted) {
            if let Some(&named) = opposites.get(&id).and_then(|named| images.get(named)) {
                images.insert(id, cut.graph.neg(named));
                continue;
            }
            let image = cut.graph.rebuilt(source.node(id), &|id| images[&id]);
            let facts = source.facts(id);
            if facts.nonzero && cut.graph.as_number(image).is_none() {
                cut.graph.assume_nonzero(image);
            }
            let image = match source.name_of(id) {
                Some(name) => {
                    let local = cut.leaf(facts, image, symbol_of(model, name));
                    // If V is the named root of a sum, the sum is written V² in later nodes.
                    if let Node::Product(factors) = source.node(id)
                        && let [(square, 1)] = **factors
                    {
                        let power = cut.graph.power(local, 4);
                        if let Some(sum) = images.insert(square, power) {
                            cut.squares.insert(sum, power);
                        }
                    }
                    local
                }
                None => image,
            };
            images.insert(id, image);
        }
        cut.roots = roots.iter().map(|root| images[root]).collect();
        cut
    }

    /// Copies `roots`, with the squares of named square roots for their sums.
    pub fn tidy(&mut self, roots: &[NodeId]) -> Vec<NodeId> {
        let source = self.graph.clone();
        let mut images: FastMap<NodeId, NodeId> = FastMap::default();
        for id in source.reachable(roots) {
            let image = match (self.squares.get(&id), source.node(id)) {
                (Some(&square), _) => square,
                (None, Node::Symbol(_)) => id,
                (None, node) => self.graph.rebuilt(node, &|id| images[&id]),
            };
            images.insert(id, image);
        }
        roots.iter().map(|root| images[root]).collect()
    }

    pub fn share_repeated(&mut self, root: NodeId) -> NodeId {
        let order = self.graph.reachable(&[root]);
        let mut uses: FastMap<NodeId, u32> = FastMap::default();
        let mut sizes: FastMap<NodeId, u64> = FastMap::default();
        for &id in &order {
            let size = self.tree_size(id, &sizes);
            sizes.insert(id, size);
            self.graph
                .for_operands(id, |operand| *uses.entry(operand).or_default() += 1);
        }
        if sizes[&root] <= MAX_FORMULA {
            return root;
        }
        let source = self.graph.clone();
        let mut images: FastMap<NodeId, NodeId> = FastMap::default();
        for id in order {
            let mut size = self.tree_size(id, &sizes);
            let mut image = match source.node(id) {
                Node::Symbol(_) => id,
                node => self.graph.rebuilt(node, &|id| images[&id]),
            };
            if size >= MIN_PART && uses.get(&id).is_some_and(|&uses| uses > 1) {
                let name = format!("s_{{{}}}", self.parts.len() + 1);
                let part = self.leaf(source.facts(id), image, name);
                if let Node::Symbol(Symbol::Local(k)) = self.graph.node(part)
                    && part != image
                {
                    self.parts.push(*k);
                    (image, size) = (part, 1);
                }
            }
            sizes.insert(id, size);
            images.insert(id, image);
        }
        images[&root]
    }

    fn tree_size(&self, id: NodeId, sizes: &FastMap<NodeId, u64>) -> u64 {
        let mut size = 1_u64;
        self.graph
            .for_operands(id, |operand| size = size.saturating_add(sizes[&operand]));
        size
    }

    /// Local symbol with a LaTeX name; the definition itself if it is a multiple of a symbol.
    fn leaf(&mut self, facts: ValueFacts, definition: NodeId, name: String) -> NodeId {
        let inner = self.graph.split_coefficient(definition).1;
        if matches!(self.graph.node(inner), Node::Symbol(_) | Node::Number(_)) {
            return definition;
        }
        let leaf = self.graph.local(facts, definition);
        if let Node::Symbol(Symbol::Local(k)) = self.graph.node(leaf) {
            self.names.insert(*k, name);
        }
        leaf
    }

    /// Returns the definition of the node `id` if it is a local symbol; returns any other node unchanged.
    pub fn inside(&self, id: NodeId) -> NodeId {
        match self.graph.node(id) {
            Node::Symbol(Symbol::Local(k)) => self.graph.definition(*k),
            _ => id,
        }
    }

    /// Total derivative of a node by `by`; those of named quantities are local symbols.
    pub fn derivative(&mut self, id: NodeId) -> NodeId {
        let derivative = self.differentiated(id);
        self.tidy(&[derivative])[0]
    }

    fn differentiated(&mut self, id: NodeId) -> NodeId {
        if let Some(&known) = self.known.get(&id) {
            return known;
        }
        let derivative = match self.graph.node(id).clone() {
            Node::Number(_) => self.graph.whole(0),
            Node::Symbol(Symbol::Local(k)) => {
                let definition = self.share_repeated(self.graph.definition(k));
                let inner = self.derivative(definition);
                let name = fraction(&self.names[&k], &self.wrt);
                let leaf = self.leaf(self.graph.facts(inner), inner, name);
                if let Node::Symbol(Symbol::Local(made)) = self.graph.node(leaf)
                    && leaf != inner
                {
                    self.made.push(*made);
                }
                leaf
            }
            Node::Symbol(symbol) => self.graph.whole(i64::from(symbol == self.by)),
            _ => {
                let mut terms = Vec::new();
                for (operand, partial) in partials::of_operation(&mut self.graph, id) {
                    let inner = self.differentiated(operand);
                    terms.push((Number::ONE, self.graph.mul(partial, inner)));
                }
                self.graph.sum(terms, Number::ZERO)
            }
        };
        self.known.insert(id, derivative);
        derivative
    }

    /// Local symbols of derivatives on which `roots` depend, in order of creation.
    fn mentioned(&self, roots: &[NodeId]) -> Vec<u32> {
        let mut needed: Vec<u32> = Vec::new();
        let mut waiting = roots.to_vec();
        let mut next = 0;
        while next < waiting.len() {
            for id in self.graph.reachable(&waiting[next..=next]) {
                if let Node::Symbol(Symbol::Local(k)) = self.graph.node(id)
                    && self.made.contains(k)
                    && !needed.contains(k)
                {
                    needed.push(*k);
                    waiting.push(self.graph.definition(*k));
                }
            }
            next += 1;
        }
        let mut ordered = self.made.clone();
        ordered.retain(|k| needed.contains(k));
        ordered
    }

    fn write(&self, id: NodeId) -> String {
        let leaf = |_: NodeId, symbol: Symbol| match symbol {
            Symbol::Time => Piece::atom("t"),
            Symbol::Pi => Piece::atom(r"\pi"),
            Symbol::State(k) => self.named(&self.layout.states[k as usize]),
            Symbol::Parameter(k) => self.named(&self.layout.parameters[k as usize]),
            Symbol::Marker(k) => self.named(&self.layout.marker[k as usize]),
            Symbol::Local(k) => match &self.names[&k] {
                // A fraction needs parentheses before an exponent.
                name if self.made.contains(&k) => Piece::new(name.clone(), Bind::Product),
                name => Piece::atom(name.clone()),
            },
        };
        node::piece(&self.graph, id, &leaf).text
    }

    fn named(&self, name: &str) -> Piece {
        Piece::atom(crate::latex::name(name, crate::latex::Style::Scalar))
    }
}
