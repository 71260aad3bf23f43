//! The linearised graph: every leaf-like node a vertex, its partial derivatives the edges to the vertices below it.

use super::partials;
use crate::graph::{FastMap, Graph, Node, NodeId, Symbol};

/// A vertex: a result, a symbol that derivatives are taken by, or what lies between.
#[derive(Clone, Debug)]
pub(super) struct Vertex {
    /// The column it stands for.
    pub column: Option<u32>,
    pub name: Option<String>,
    /// Vertices it depends on, with the partial derivative.
    pub down: Vec<(usize, NodeId)>,
    /// Vertices that depend on it.
    pub up: Vec<usize>,
}

/// Vertices, and what is wanted of them.
#[derive(Clone, Debug)]
pub struct Edges {
    /// The results come first, as vertices that nothing depends on.
    pub(super) vertices: Vec<Vertex>,
    /// The names of the results.
    pub(super) rows: Vec<String>,
    /// The names of the symbols.
    pub(super) names: Vec<String>,
}

impl Edges {
    /// Of the roots and all that they depend on, towards the symbols; both come with their names, for the derivatives'.
    pub fn new(
        graph: &mut Graph,
        (roots, rows): (&[NodeId], &[String]),
        (by, names): (&[Symbol], &[String]),
    ) -> Edges {
        for (&symbol, name) in by.iter().zip(names) {
            let node = graph.symbol(symbol);
            graph.name(node, name.as_str());
        }
        let columns: FastMap<NodeId, u32> = by
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
        for (at, &root) in roots.iter().enumerate() {
            let partials = partials::of_expression(graph, root);
            attach(graph, at, partials, &columns, &mut vertices, &mut index);
        }
        let mut edges = Edges {
            vertices,
            rows: rows.to_vec(),
            names: names.to_vec(),
        };
        edges.prune();
        edges
    }

    /// The partial derivatives on all edges.
    pub fn partials(&self) -> Vec<NodeId> {
        let edges = self.vertices.iter().flat_map(|vertex| &vertex.down);
        edges.map(|&(_, partial)| partial).collect()
    }

    /// Puts others in their place, in the same order, nodes of `graph`; edges that are 0 there are dropped.
    pub fn replace(&mut self, graph: &Graph, partials: &[NodeId]) {
        let mut next = partials.iter().copied();
        let mut gone = Vec::new();
        for (from, vertex) in self.vertices.iter_mut().enumerate() {
            vertex.down.retain_mut(|(to, partial)| {
                *partial = next.next().unwrap_or(*partial);
                let vanishes = graph.is_zero(*partial);
                if vanishes {
                    gone.push((from, *to));
                }
                !vanishes
            });
        }
        for (from, to) in gone {
            self.vertices[to].up.retain(|&user| user != from);
        }
        self.prune();
    }

    /// Drops vertices from which no column can be reached.
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

/// Adds edges, and the vertices below them.
fn attach(
    graph: &mut Graph,
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

/// Partial derivatives of a vertex by the vertices below it.
fn partials_of_vertex(graph: &mut Graph, node: NodeId) -> Vec<(NodeId, NodeId)> {
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
    graph: &mut Graph,
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
