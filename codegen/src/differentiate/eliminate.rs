//! Accumulation of a Jacobian by vertex elimination on the linearised graph.
//!
//! Every vertex is a leaf-like node; its edges are partial derivatives by the vertices it depends on.
//! Eliminating a vertex joins the edges above it with those below it. The order decides how many
//! products there are, and no rule is always best: see [`Order`].

use super::partials;
use crate::graph::{FastMap, Graph, Node, NodeId, Symbol};

/// Which vertex goes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// The one that costs fewest products for the edges that it takes away.
    FewestProducts,
    /// The one that leaves fewest edges.
    FewestEdges,
}

/// A sparse Jacobian.
#[derive(Clone, Debug, Default)]
pub struct Jacobian {
    /// Row and column of each entry, row by row.
    pub pattern: Vec<(u32, u32)>,
    /// The entries.
    pub entries: Vec<NodeId>,
}

/// Most letters of two names that a derivative is named after.
const LONGEST: usize = 30;

struct Vertex {
    node: Option<NodeId>,
    name: Option<String>,
    /// Vertices it depends on, with the partial derivative.
    down: Vec<(usize, NodeId)>,
    /// Vertices that depend on it.
    up: Vec<usize>,
}

/// Derivatives of the roots by the symbols; both come with their names, for the derivatives'.
pub fn jacobian(
    graph: &mut Graph,
    (roots, rows): (&[NodeId], &[String]),
    (by, names): (&[Symbol], &[String]),
    order: Order,
) -> Jacobian {
    for (&symbol, name) in by.iter().zip(names) {
        let node = graph.symbol(symbol);
        graph.name(node, name.as_str());
    }
    let columns: FastMap<NodeId, u32> = by
        .iter()
        .enumerate()
        .map(|(k, &symbol)| (graph.symbol(symbol), k as u32))
        .collect();
    // the results come first, as vertices that nothing depends on
    let mut vertices: Vec<Vertex> = rows
        .iter()
        .map(|name| Vertex {
            node: None,
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
    prune(&mut vertices, &columns, roots.len());
    let mut inner: Vec<usize> = (roots.len()..vertices.len())
        .filter(|&v| {
            vertices[v]
                .node
                .is_some_and(|node| !columns.contains_key(&node))
        })
        .collect();
    while let Some(place) = cheapest(&vertices, &inner, order) {
        let v = inner.swap_remove(place);
        eliminate(graph, &mut vertices, v);
        inner.sort_unstable();
    }
    let mut jacobian = Jacobian::default();
    for row in 0..roots.len() {
        let mut entries: Vec<(u32, NodeId)> = vertices[row]
            .down
            .iter()
            .filter_map(|&(v, partial)| {
                vertices[v]
                    .node
                    .and_then(|node| columns.get(&node))
                    .map(|&c| (c, partial))
            })
            .filter(|&(_, partial)| !graph.is_zero(partial))
            .collect();
        entries.sort_unstable();
        for (column, entry) in entries {
            name_derivative(graph, entry, &rows[row], &names[column as usize]);
            jacobian.pattern.push((row as u32, column));
            jacobian.entries.push(entry);
        }
    }
    jacobian
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
                    node: Some(node),
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

fn add_edge(graph: &mut Graph, vertices: &mut [Vertex], from: usize, to: usize, partial: NodeId) {
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

/// Drops vertices from which no column can be reached.
fn prune(vertices: &mut [Vertex], columns: &FastMap<NodeId, u32>, roots: usize) {
    loop {
        let dead: Vec<usize> = (roots..vertices.len())
            .filter(|&v| {
                vertices[v].down.is_empty()
                    && !vertices[v].up.is_empty()
                    && vertices[v]
                        .node
                        .is_some_and(|node| !columns.contains_key(&node))
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

fn cheapest(vertices: &[Vertex], inner: &[usize], order: Order) -> Option<usize> {
    (0..inner.len()).min_by_key(|&place| {
        let v = inner[place];
        let (up, down) = (vertices[v].up.len(), vertices[v].down.len());
        let products = (up * down) as i64;
        let (up, down) = (up as i64, down as i64);
        let cost = match order {
            Order::FewestProducts => 2 * products - 2 * up - 3 * down,
            Order::FewestEdges => fill(vertices, v) - up - down,
        };
        // where equal, what is nearest to the inputs
        (cost, products, std::cmp::Reverse(v))
    })
}

/// Edges that would appear if a vertex went.
fn fill(vertices: &[Vertex], v: usize) -> i64 {
    let missing = |user: usize| {
        let known = &vertices[user].down;
        let down = vertices[v].down.iter();
        down.filter(|(to, _)| !known.iter().any(|(have, _)| have == to))
            .count() as i64
    };
    vertices[v].up.iter().map(|&user| missing(user)).sum()
}

fn eliminate(graph: &mut Graph, vertices: &mut [Vertex], v: usize) {
    let up = std::mem::take(&mut vertices[v].up);
    let down = std::mem::take(&mut vertices[v].down);
    for &(to, inner) in &down {
        name_edge(graph, vertices, v, to, inner);
    }
    for &user in &up {
        let Some(at) = vertices[user].down.iter().position(|&(to, _)| to == v) else {
            continue;
        };
        let (_, outer) = vertices[user].down.remove(at);
        name_edge(graph, vertices, user, v, outer);
        let outer = if down.len() > 1 {
            bind(graph, outer)
        } else {
            outer
        };
        for &(to, inner) in &down {
            let inner = if up.len() > 1 {
                bind(graph, inner)
            } else {
                inner
            };
            let product = graph.mul(outer, inner);
            add_edge(graph, vertices, user, to, product);
        }
    }
    for &(to, _) in &down {
        vertices[to].up.retain(|&user| user != v);
    }
}

/// A derivative of a named quantity by a named quantity is named after both.
fn name_edge(graph: &mut Graph, vertices: &[Vertex], from: usize, to: usize, partial: NodeId) {
    if let (Some(from), Some(to)) = (&vertices[from].name, &vertices[to].name) {
        name_derivative(graph, partial, from, to);
    }
}

fn name_derivative(graph: &mut Graph, partial: NodeId, of: &str, by: &str) {
    let (_, rest) = graph.split_coefficient(partial);
    let trivial = !matches!(graph.node(rest), Node::Sum(..) | Node::Product(_));
    if !trivial && of.len() + by.len() <= LONGEST {
        graph.name(partial, format!("d_{of}_d_{by}"));
    }
}

/// A sum that goes into several products stays one factor of them.
fn bind(graph: &mut Graph, id: NodeId) -> NodeId {
    match graph.node(id) {
        Node::Sum(terms, _) if terms.len() > 1 => {
            let facts = graph.facts(id);
            let name = graph.name_of(id).map(str::to_string);
            let local = graph.local(facts, id);
            if let Some(name) = name {
                graph.name(local, name);
            }
            local
        }
        _ => id,
    }
}
