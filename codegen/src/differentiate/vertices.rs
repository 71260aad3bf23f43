//! Vertices of the linearized graph: the values that an optimised schedule computes once.

use crate::graph::{ExprGraph, Node, NodeId, Symbol, ValueFacts};
use crate::schedule::Namer;
use crate::ssa::{Ssa, SsaDef};

/// Makes the sums and the products with several users leaves of the graph, with their values as definitions.
/// Returns the roots over these leaves, which bear the names that `namer` gives the values.
pub(crate) fn share_values(ssa: &Ssa, graph: &mut ExprGraph, namer: &mut Namer) -> Vec<NodeId> {
    let uses = ssa.uses();
    let order = ssa.order();
    let mut rooted = ssa.side_table(false);
    for &id in &order {
        if let SsaDef::Root(x) = ssa.defs[id] {
            rooted[x] = true;
        }
    }
    // operands come first in the order: none of these zeros is ever read
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
        // derivatives are named after these
        let vertex = match graph.node(node) {
            Node::Symbol(Symbol::Local(_)) | Node::Call(..) | Node::Atan2(..) => true,
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
    let roots = roots.map(|&(minus, id)| match minus {
        true => graph.neg(nodes[id]),
        false => nodes[id],
    });
    roots.collect()
}

/// The leaf of a sum, or the square of the leaf of its root.
fn share_sum(graph: &mut ExprGraph, sum: NodeId, facts: ValueFacts, rooted: bool) -> NodeId {
    if rooted && matches!(graph.node(sum), Node::Sum(..)) {
        let root = graph.local_root(facts, sum);
        graph.power(root, 4)
    } else {
        graph.local(facts, sum)
    }
}
