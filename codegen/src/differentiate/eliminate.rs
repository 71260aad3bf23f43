//! Accumulation of a Jacobian by vertex elimination on the linearised graph.
//!
//! Every vertex is a leaf-like node; its edges are partial derivatives by the vertices it depends on.
//! Eliminating a vertex joins the edges above it with those below it. The order decides how many
//! products there are, and no rule is always best: see [`Order`].

use super::edges::{Edges, Vertex, add_edge};
use crate::graph::{Graph, Node, NodeId};

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

impl Edges {
    /// The derivatives of the roots by the symbols.
    pub fn accumulate(self, graph: &mut Graph, order: Order) -> Jacobian {
        let Edges {
            mut vertices,
            rows,
            names,
        } = self;
        let mut inner: Vec<usize> = (rows.len()..vertices.len())
            .filter(|&v| vertices[v].column.is_none())
            .collect();
        while let Some(place) = cheapest(&vertices, &inner, order) {
            let v = inner.swap_remove(place);
            eliminate(graph, &mut vertices, v);
            inner.sort_unstable();
        }
        let mut jacobian = Jacobian::default();
        for (row, name) in rows.iter().enumerate() {
            let mut entries: Vec<(u32, NodeId)> = vertices[row]
                .down
                .iter()
                .filter_map(|&(v, partial)| Some((vertices[v].column?, partial)))
                .filter(|&(_, partial)| !graph.is_zero(partial))
                .collect();
            entries.sort_unstable();
            for (column, entry) in entries {
                name_derivative(graph, entry, name, &names[column as usize]);
                jacobian.pattern.push((row as u32, column));
                jacobian.entries.push(entry);
            }
        }
        jacobian
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
