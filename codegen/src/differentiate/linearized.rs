//! Linearized computational graph: vertices are values other than sums and products.

use super::partials;
use crate::functions::BinaryFunction;
use crate::graph::{ExprGraph, FastMap, Node, NodeId, Symbol, ValueFacts};
use crate::schedule::Namer;
use crate::ssa::{Ssa, SsaDef};

/// Vertex of the linearized computational graph: a result, an independent symbol, or an intermediate value.
#[derive(Clone, Debug)]
pub(super) struct Vertex {
    /// Jacobian column of an independent symbol; `None` for other vertices.
    pub column: Option<u32>,
    pub name: Option<String>,
    /// Edges to the operands: (index of the operand's vertex, partial derivative with respect to the operand).
    pub down: Vec<(usize, NodeId)>,
    /// Indices of the vertices that depend directly on this vertex.
    pub up: Vec<usize>,
}

#[derive(Clone, Debug)]
pub(crate) struct LinearizedGraph {
    /// All vertices of the graph; the vertices of the results come first, in row order.
    pub(super) vertices: Vec<Vertex>,
    /// Names of the results, one per Jacobian row.
    pub(super) rows: Vec<String>,
    /// Names of the independent symbols, one per Jacobian column.
    pub(super) columns: Vec<String>,
}

impl LinearizedGraph {
    /// Linearized graph of `results`, named `rows`, with respect to `symbols`, named `columns`.
    pub fn new(
        graph: &mut ExprGraph,
        results: &[NodeId],
        rows: &[String],
        symbols: &[Symbol],
        columns: &[String],
    ) -> LinearizedGraph {
        for (&symbol, name) in symbols.iter().zip(columns) {
            let node = graph.symbol(symbol);
            graph.name(node, name.as_str());
        }
        let column_of: FastMap<NodeId, u32> = symbols
            .iter()
            .enumerate()
            .map(|(k, &symbol)| (graph.symbol(symbol), k as u32))
            .collect();
        let mut vertices: Vec<Vertex> = rows
            .iter()
            .map(|name| Vertex {
                column: None,
                name: Some(name.clone()),
                down: Vec::new(),
                up: Vec::new(),
            })
            .collect();
        let mut index: FastMap<NodeId, usize> = FastMap::default();
        for (at, &root) in results.iter().enumerate() {
            let partials = partials::of_expression(graph, root);
            attach(graph, at, partials, &column_of, &mut vertices, &mut index);
        }
        let mut linearized = LinearizedGraph {
            vertices,
            rows: rows.to_vec(),
            columns: columns.to_vec(),
        };
        linearized.prune();
        linearized
    }

    pub fn partials(&self) -> Vec<NodeId> {
        let edges = self.vertices.iter().flat_map(|vertex| &vertex.down);
        edges.map(|&(_, partial)| partial).collect()
    }

    pub fn set_partials(&mut self, graph: &ExprGraph, partials: &[NodeId]) {
        let mut next = partials.iter().copied();
        self.retain_edges(|_, partial| {
            *partial = next.next().unwrap_or(*partial);
            !graph.is_zero(*partial)
        });
    }

    pub fn towards_first(mut self, columns: usize) -> LinearizedGraph {
        let beyond: Vec<bool> = self
            .vertices
            .iter()
            .map(|vertex| {
                vertex
                    .column
                    .is_some_and(|column| column as usize >= columns)
            })
            .collect();
        self.retain_edges(|to, _| !beyond[to]);
        self.columns.truncate(columns);
        self
    }

    /// Keeps the edges for which `keep` holds; it may replace the partial derivative.
    fn retain_edges(&mut self, mut keep: impl FnMut(usize, &mut NodeId) -> bool) {
        let mut dropped = Vec::new();
        for (from, vertex) in self.vertices.iter_mut().enumerate() {
            vertex.down.retain_mut(|(to, partial)| {
                let kept = keep(*to, partial);
                if !kept {
                    dropped.push((from, *to));
                }
                kept
            });
        }
        for (from, to) in dropped {
            self.vertices[to].up.retain(|&user| user != from);
        }
        self.prune();
    }

    /// Disconnects inner vertices that lead to no symbol; they stay, so that indices remain valid.
    fn prune(&mut self) {
        let (vertices, roots) = (&mut self.vertices, self.rows.len());
        loop {
            let dead: Vec<usize> = (roots..vertices.len())
                .filter(|&v| {
                    let vertex = &vertices[v];
                    vertex.down.is_empty() && !vertex.up.is_empty() && vertex.column.is_none()
                })
                .collect();
            if dead.is_empty() {
                return;
            }
            for v in dead {
                for user in std::mem::take(&mut vertices[v].up) {
                    vertices[user].down.retain(|&(to, _)| to != v);
                }
            }
        }
    }
}

/// Adds the edges from `from` to its operands, and what these depend on.
fn attach(
    graph: &mut ExprGraph,
    from: usize,
    partials: Vec<(NodeId, NodeId)>,
    columns: &FastMap<NodeId, u32>,
    vertices: &mut Vec<Vertex>,
    index: &mut FastMap<NodeId, usize>,
) {
    for (node, partial) in partials {
        if graph.is_zero(partial) {
            continue;
        }
        let known = index.get(&node).copied();
        let to = match known {
            Some(to) => to,
            None => {
                let is_column = columns.contains_key(&node);
                if !is_column
                    && matches!(graph.node(node), Node::Symbol(s) if !matches!(s, Symbol::Local(_)))
                {
                    continue;
                }
                let name = graph.name_of(node).map(str::to_string);
                vertices.push(Vertex {
                    column: columns.get(&node).copied(),
                    name,
                    down: Vec::new(),
                    up: Vec::new(),
                });
                let to = vertices.len() - 1;
                index.insert(node, to);
                if !is_column {
                    let below = partials_of_vertex(graph, node);
                    attach(graph, to, below, columns, vertices, index);
                }
                to
            }
        };
        add_edge(graph, vertices, from, to, partial);
    }
}

fn partials_of_vertex(graph: &mut ExprGraph, node: NodeId) -> Vec<(NodeId, NodeId)> {
    if let Node::Symbol(Symbol::Local(k)) = graph.node(node) {
        let definition = graph.definition(*k);
        return partials::of_expression(graph, definition);
    }
    let mut all: Vec<(NodeId, NodeId)> = Vec::new();
    for (operand, outer) in partials::of_node(graph, node) {
        for (vertex, inner) in partials::of_expression(graph, operand) {
            let product = graph.mul(outer, inner);
            match all.iter_mut().find(|(known, _)| *known == vertex) {
                Some((_, sum)) => *sum = graph.add(*sum, product),
                None => all.push((vertex, product)),
            }
        }
    }
    all
}

pub(super) fn add_edge(
    graph: &mut ExprGraph,
    vertices: &mut [Vertex],
    from: usize,
    to: usize,
    partial: NodeId,
) {
    match vertices[from].down.iter().position(|&(v, _)| v == to) {
        Some(at) => {
            let sum = graph.add(vertices[from].down[at].1, partial);
            vertices[from].down[at].1 = sum;
        }
        None => {
            vertices[from].down.push((to, partial));
            vertices[to].up.push(from);
        }
    }
}

/// Graph nodes of the roots of `ssa`, whose sums and shared products become named local symbols.
pub(crate) fn share_values(ssa: &Ssa, graph: &mut ExprGraph, namer: &mut Namer) -> Vec<NodeId> {
    let uses = ssa.uses();
    let order = ssa.order();
    let mut rooted = ssa.side_table(false);
    for &id in &order {
        if let SsaDef::Root(x) = ssa.defs[id] {
            rooted[x] = true;
        }
    }
    // Operands precede their users, so these placeholder zeros are never read.
    let zero = graph.whole(0);
    let mut nodes = ssa.side_table(zero);
    for id in order {
        let value = ssa.expression(id, graph, &|operand| nodes[operand]);
        let facts = ssa.facts[id];
        let node = match &ssa.defs[id] {
            SsaDef::Sum(_) => share_sum(graph, value, facts, rooted[id]),
            SsaDef::Product(_) if uses[id] > 1 => graph.local(facts, value),
            _ => value,
        };
        // The names of derivatives are formed from these vertex names.
        let vertex = match graph.node(node) {
            Node::Symbol(Symbol::Local(_))
            | Node::Call(..)
            | Node::Call2(BinaryFunction::Atan2 | BinaryFunction::Table(_), ..) => true,
            Node::Product(_) => rooted[id],
            _ => false,
        };
        if vertex || namer.has_own_name(ssa, graph, id) {
            let name = namer.name(ssa, graph, id);
            graph.name(node, name);
        }
        nodes[id] = node;
    }
    let roots = ssa.roots.iter();
    let roots = roots.map(|&(minus, id)| {
        if minus {
            graph.neg(nodes[id])
        } else {
            nodes[id]
        }
    });
    roots.collect()
}

/// Local symbol of a sum, or the square of that of its square root if `rooted`.
fn share_sum(graph: &mut ExprGraph, sum: NodeId, facts: ValueFacts, rooted: bool) -> NodeId {
    if rooted && matches!(graph.node(sum), Node::Sum(..)) {
        let root = graph.local_root(facts, sum);
        graph.power(root, 4)
    } else {
        graph.local(facts, sum)
    }
}
