//! Jacobian accumulation by vertex elimination (Griewank and Walther, Evaluating Derivatives, chapter 9).
//!
//! Eliminating a vertex multiplies the partial derivative on each edge above the vertex with that on each edge below.
//! The order of elimination determines the number of products. Finding an optimal order is NP-complete;
//! [`EliminationOrder`] offers two greedy rules.

use super::linearized::{LinearizedGraph, Vertex, add_edge};
use crate::graph::{ExprGraph, Node, NodeId};
use std::cmp::Reverse;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum EliminationOrder {
    /// The vertex with the fewest added products less removed edges (variant of the Markowitz rule).
    FewestProducts,
    /// Selects the vertex whose elimination leaves the fewest edges (minimum fill).
    FewestEdges,
}

/// Sparse Jacobian: sparsity pattern and entries.
#[derive(Clone, Debug, Default)]
pub(crate) struct Jacobian {
    /// (row, column) of each entry, ordered by row.
    pub pattern: Vec<(u32, u32)>,
    pub entries: Vec<NodeId>,
}

const MAX_NAMES_LEN: usize = 30;

impl LinearizedGraph {
    pub fn eliminate_vertices(self, graph: &mut ExprGraph, order: EliminationOrder) -> Jacobian {
        let LinearizedGraph {
            mut vertices,
            rows,
            columns,
        } = self;
        let mut inner: Vec<usize> = (rows.len()..vertices.len())
            .filter(|&v| vertices[v].column.is_none())
            .collect();
        let mut marks = vec![false; vertices.len()];
        let mut costs: Vec<Cost> = (0..vertices.len())
            .map(|v| cost(&vertices, v, order, &mut marks))
            .collect();
        while let Some(place) = (0..inner.len()).min_by_key(|&place| costs[inner[place]]) {
            let v = inner.remove(place);
            for changed in eliminate(graph, &mut vertices, v) {
                costs[changed] = cost(&vertices, changed, order, &mut marks);
            }
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
                name_derivative(graph, entry, name, &columns[column as usize]);
                jacobian.pattern.push((row as u32, column));
                jacobian.entries.push(entry);
            }
        }
        jacobian
    }
}

/// Cost of eliminating a vertex. Ties are broken by fewer products, then by the later vertex, which is nearer to the inputs.
type Cost = (i64, i64, Reverse<usize>);

fn cost(vertices: &[Vertex], v: usize, order: EliminationOrder, marks: &mut [bool]) -> Cost {
    let (up, down) = (vertices[v].up.len() as i64, vertices[v].down.len() as i64);
    let products = up * down;
    let cost = match order {
        EliminationOrder::FewestProducts => 2 * products - 2 * up - 3 * down,
        EliminationOrder::FewestEdges => fill(vertices, v, marks) - up - down,
    };
    (cost, products, Reverse(v))
}

/// Fill of vertex `v`: number of new edges that eliminating the vertex would create. `marks` are all false before and after.
fn fill(vertices: &[Vertex], v: usize, marks: &mut [bool]) -> i64 {
    let Vertex { up, down, .. } = &vertices[v];
    down.iter().for_each(|&(to, _)| marks[to] = true);
    let users = up.iter().map(|&user| &vertices[user].down);
    let known = users.map(|known| known.iter().filter(|(to, _)| marks[*to]).count());
    let known: usize = known.sum();
    down.iter().for_each(|&(to, _)| marks[to] = false);
    (up.len() * down.len() - known) as i64
}

/// Eliminates vertex `v`; returns the vertices whose costs may have changed: its neighbours, and what its users depend on.
fn eliminate(graph: &mut ExprGraph, vertices: &mut [Vertex], v: usize) -> Vec<usize> {
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
    let below = up.iter().flat_map(|&user| &vertices[user].down);
    let below = below.chain(&down).map(|&(to, _)| to);
    let mut changed: Vec<usize> = below.chain(up.iter().copied()).collect();
    changed.sort_unstable();
    changed.dedup();
    changed
}

/// Names the partial derivative of an edge `d_A_d_B`, if both vertices have names.
fn name_edge(graph: &mut ExprGraph, vertices: &[Vertex], from: usize, to: usize, partial: NodeId) {
    if let (Some(from), Some(to)) = (&vertices[from].name, &vertices[to].name) {
        name_derivative(graph, partial, from, to);
    }
}

fn name_derivative(graph: &mut ExprGraph, partial: NodeId, of: &str, by: &str) {
    let (_, rest) = graph.split_coefficient(partial);
    let trivial = !matches!(graph.node(rest), Node::Sum(..) | Node::Product(_));
    if !trivial && of.len() + by.len() <= MAX_NAMES_LEN {
        graph.name(partial, format!("d_{of}_d_{by}"));
    }
}

/// Replaces a sum that becomes a factor of several products by a local symbol.
fn bind(graph: &mut ExprGraph, id: NodeId) -> NodeId {
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
