//! Invariant hoisting: moves expressions of parameters to `prepare`, which runs once per flight.

use super::{Namer, schedule};
use crate::graph::{ExprGraph, FastMap, Node, NodeId, Symbol};
use crate::program::{Operand, Program};
use crate::ssa::{DefId, Ssa, build};
use std::collections::BTreeSet;

/// Hoisted expressions; a slot is an index among the results of `prepare`.
#[derive(Clone, Debug, Default)]
pub struct Hoisted {
    slots: Vec<NodeId>,
    names: Vec<String>,
    taken: BTreeSet<String>,
    slot_of: FastMap<NodeId, u32>,
    parameters: Vec<String>,
}

/// For each hoisted definition of one function, the graph node that expresses its value in terms of parameters.
pub(super) type HoistedNodes = FastMap<DefId, NodeId>;

impl Hoisted {
    /// Creates an empty set of hoisted expressions for a model; `parameters` contains the names of its parameters.
    pub fn new(parameters: &[String]) -> Hoisted {
        Hoisted {
            parameters: parameters.to_vec(),
            ..Hoisted::default()
        }
    }

    /// Names of the hoisted expressions, in the order of the results of `prepare`.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Operand of a hoisted definition or its negative: a constant, a parameter or a slot.
    pub(super) fn operand(
        &mut self,
        ssa: &Ssa,
        graph: &mut ExprGraph,
        nodes: &mut HoistedNodes,
        (minus, id): (bool, DefId),
    ) -> Operand {
        let mut node = expression(ssa, graph, nodes, id);
        if minus {
            node = graph.neg(node);
        }
        match graph.node(node) {
            Node::Number(number) => return Operand::Constant(number.value()),
            Node::Symbol(Symbol::Parameter(k)) => return Operand::Parameter(*k),
            Node::Symbol(Symbol::Pi) => return Operand::Constant(std::f64::consts::PI),
            _ => {}
        }
        if let Some(&slot) = self.slot_of.get(&node) {
            return Operand::Prepared(slot);
        }
        let slot = self.slots.len() as u32;
        self.slots.push(node);
        self.slot_of.insert(node, slot);
        let name = Namer::constant_name(&self.parameters, ssa, graph, id);
        let name = self.unique(if minus { format!("minus_{name}") } else { name });
        graph.name(node, name.clone());
        self.names.push(name);
        Operand::Prepared(slot)
    }

    fn unique(&mut self, name: String) -> String {
        let mut unique = name.clone();
        let mut k = 2;
        while !self.taken.insert(unique.clone()) {
            unique = format!("{name}_{k}");
            k += 1;
        }
        unique
    }

    pub fn program(&self, graph: &mut ExprGraph) -> Program {
        let mut ssa = build(graph, &self.slots);
        // `prepare` itself hoists nothing.
        for facts in ssa.facts.iter_mut() {
            facts.fixed = false;
        }
        ssa.optimise();
        let mut namer = Namer::new(&[], &self.parameters, &[]);
        schedule(&ssa, graph, &mut namer, None, &self.names)
    }
}

/// Returns the graph node that expresses the value of the hoisted definition `id` in terms of parameters.
fn expression(ssa: &Ssa, graph: &mut ExprGraph, nodes: &mut HoistedNodes, id: DefId) -> NodeId {
    if let Some(&node) = nodes.get(&id) {
        return node;
    }
    for operand in ssa.defs[id].operands() {
        expression(ssa, graph, nodes, operand);
    }
    let node = ssa.expression(id, graph, &|operand| nodes[&operand]);
    nodes.insert(id, node);
    node
}
