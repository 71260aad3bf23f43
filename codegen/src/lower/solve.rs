//! Symbolic solution of small linear systems.

use crate::graph::{ExprGraph, NodeId};
use crate::number::Number;

/// Inverse of a 3×3 matrix of nodes, by cofactors; the determinant is assumed nonzero.
pub fn inverse(graph: &mut ExprGraph, m: [[NodeId; 3]; 3]) -> [[NodeId; 3]; 3] {
    let mut cofactor = |i: usize, j: usize| {
        let [r, s] = [(i + 1) % 3, (i + 2) % 3];
        let [c, d] = [(j + 1) % 3, (j + 2) % 3];
        let (first, second) = (graph.mul(m[r][c], m[s][d]), graph.mul(m[r][d], m[s][c]));
        graph.sub(first, second)
    };
    let cofactors = [0, 1, 2].map(|i| [0, 1, 2].map(|j| cofactor(i, j)));
    let terms = (0..3)
        .map(|k| (Number::ONE, graph.mul(m[0][k], cofactors[0][k])))
        .collect();
    let determinant = graph.sum(terms, Number::ZERO);
    graph.assume_nonzero(determinant);
    for row in m {
        for entry in row {
            if !graph.is_zero(entry) && determinant_has(graph, determinant, entry) {
                graph.assume_nonzero(entry);
            }
        }
    }
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| graph.div(cofactors[j][i], determinant)))
}

fn determinant_has(graph: &ExprGraph, determinant: NodeId, entry: NodeId) -> bool {
    match graph.node(determinant) {
        crate::graph::Node::Product(factors) => factors.iter().any(|&(factor, _)| factor == entry),
        _ => determinant == entry,
    }
}

/// Solves a system: rows with a single unknown, then Cramer's rule; `None` if it is singular.
pub fn solve(
    graph: &mut ExprGraph,
    matrix: Vec<Vec<NodeId>>,
    right: Vec<NodeId>,
) -> Option<Vec<NodeId>> {
    let columns = matrix.first().map_or(0, Vec::len);
    let mut found: Vec<Option<NodeId>> = vec![None; columns];
    let mut right = right;
    let mut rows: Vec<usize> = (0..matrix.len()).collect();
    loop {
        let open = |row: usize, found: &[Option<NodeId>], graph: &ExprGraph| -> Vec<usize> {
            (0..columns)
                .filter(|&c| found[c].is_none() && !graph.is_zero(matrix[row][c]))
                .collect()
        };
        let Some(place) = rows
            .iter()
            .position(|&row| open(row, &found, graph).len() == 1)
        else {
            break;
        };
        let row = rows.remove(place);
        let column = open(row, &found, graph)[0];
        let value = graph.div(right[row], matrix[row][column]);
        found[column] = Some(value);
        for &other in &rows {
            let product = graph.mul(matrix[other][column], value);
            right[other] = graph.sub(right[other], product);
        }
    }
    let left: Vec<usize> = (0..columns).filter(|&c| found[c].is_none()).collect();
    let rows: Vec<usize> = rows
        .into_iter()
        .filter(|&row| left.iter().any(|&c| !graph.is_zero(matrix[row][c])))
        .collect();
    if !left.is_empty() && rows.len() == left.len() {
        let system: Vec<Vec<NodeId>> = rows
            .iter()
            .map(|&row| left.iter().map(|&c| matrix[row][c]).collect())
            .collect();
        let right: Vec<NodeId> = rows.iter().map(|&row| right[row]).collect();
        let determinant = determinant(graph, &system);
        for (column, value) in left
            .into_iter()
            .zip(cramer(graph, &system, &right, determinant))
        {
            found[column] = Some(value);
        }
    }
    found.into_iter().collect()
}

/// Unknowns of a system with the determinant `whole`, by Cramer's rule.
pub(super) fn cramer(
    graph: &mut ExprGraph,
    system: &[Vec<NodeId>],
    right: &[NodeId],
    whole: NodeId,
) -> Vec<NodeId> {
    let unknown = |k: usize| {
        let mut replaced = system.to_vec();
        for (row, &right) in replaced.iter_mut().zip(right) {
            row[k] = right;
        }
        let above = determinant(graph, &replaced);
        graph.div(above, whole)
    };
    (0..system.len()).map(unknown).collect()
}

/// Determinant of a square matrix by Laplace expansion along the first row.
pub(super) fn determinant(graph: &mut ExprGraph, m: &[Vec<NodeId>]) -> NodeId {
    if m.len() == 1 {
        return m[0][0];
    }
    let terms = (0..m.len())
        .map(|k| {
            let without = |row: &Vec<NodeId>| [&row[..k], &row[k + 1..]].concat();
            let minor: Vec<Vec<NodeId>> = m[1..].iter().map(without).collect();
            let inner = determinant(graph, &minor);
            (Number::sign(k % 2 == 1), graph.distribute(inner, m[0][k]))
        })
        .collect();
    graph.sum(terms, Number::ZERO)
}

#[cfg(test)]
mod tests {
    use super::solve;
    use crate::graph::{ExprGraph, NodeId, Symbol};

    #[test]
    fn unknowns_that_no_row_contains_are_not_determined() {
        let mut graph = ExprGraph::default();
        let [a, b] = [0, 1].map(|k| graph.symbol(Symbol::State(k)));
        let zero = graph.whole(0);
        let full: Vec<Vec<NodeId>> = vec![vec![a, b], vec![b, a]];
        let lacking = vec![vec![a, zero], vec![b, zero]];
        let unknowns = solve(&mut graph, full, vec![a, b]);
        assert_eq!(unknowns.map(|unknowns| unknowns.len()), Some(2));
        assert_eq!(solve(&mut graph, lacking, vec![a, b]), None);
    }
}
