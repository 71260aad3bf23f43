//! Choice of the vertices of the linearized graph: the values that the optimised SSA definitions compute once.

use crate::functions::BinaryFunction;
use crate::graph::{ExprGraph, Node, NodeId, Symbol, ValueFacts};
use crate::schedule::Namer;
use crate::ssa::{Ssa, SsaDef};

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
            | Node::Call2(BinaryFunction::Atan2, ..) => true,
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
