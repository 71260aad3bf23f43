//! Choice of the vertices of the linearized graph: the values that the optimised SSA definitions compute once.

use crate::graph::{ExprGraph, Node, NodeId, Symbol, ValueFacts};
use crate::schedule::Namer;
use crate::ssa::{Ssa, SsaDef};

/// Builds graph nodes for the SSA definitions of `ssa`. Every sum, and every product that is used several times,
/// becomes a local symbol defined by its value; `namer` names these symbols. Returns the nodes of the requested results
/// (roots).
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

/// Returns a new local symbol that is defined by the sum `sum`. If `rooted`, that is, if the square root of the sum is
/// also used, creates a local symbol for the square root instead and returns the square of that symbol. `facts` are the
/// known properties of the sum.
fn share_sum(graph: &mut ExprGraph, sum: NodeId, facts: ValueFacts, rooted: bool) -> NodeId {
    if rooted && matches!(graph.node(sum), Node::Sum(..)) {
        let root = graph.local_root(facts, sum);
        graph.power(root, 4)
    } else {
        graph.local(facts, sum)
    }
}
