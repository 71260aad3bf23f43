//! What depends on parameters alone, collected over all functions of a model.

use super::{Namer, schedule};
use crate::graph::{FastMap, Graph, Node, NodeId, Symbol};
use crate::number::Number;
use crate::optimise::{Dag, Def, DefId, import};
use crate::program::{Operand, Program};

/// The constants of a flight, found while functions are scheduled.
#[derive(Clone, Debug, Default)]
pub struct Prepare {
    graph: Graph,
    slots: Vec<NodeId>,
    names: Vec<String>,
    index: FastMap<NodeId, u32>,
    parameters: Vec<String>,
}

impl Prepare {
    /// For a model with these parameters.
    pub fn new(parameters: &[String]) -> Prepare {
        Prepare {
            parameters: parameters.to_vec(),
            ..Prepare::default()
        }
    }

    /// Names of the constants, in order.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The operand that holds a definition (or its opposite), with a new place if it needs one.
    pub fn operand(&mut self, dag: &Dag, graph: &Graph, id: DefId, minus: bool) -> Operand {
        let mut known = FastMap::default();
        let mut node = self.node(dag, id, &mut known);
        if minus {
            node = self.graph.neg(node);
        }
        match self.graph.node(node) {
            Node::Number(number) => return Operand::Constant(number.value()),
            Node::Symbol(Symbol::Parameter(k)) => return Operand::Parameter(*k),
            Node::Symbol(Symbol::Pi) => return Operand::Constant(std::f64::consts::PI),
            _ => {}
        }
        if let Some(&slot) = self.index.get(&node) {
            return Operand::Prepared(slot);
        }
        let slot = self.slots.len() as u32;
        self.slots.push(node);
        self.index.insert(node, slot);
        let mut name = Namer::constant_name(&self.parameters, dag, graph, id);
        if minus {
            name = format!("minus_{name}");
        }
        let mut unique = name.clone();
        let mut k = 2;
        while self.names.contains(&unique) {
            unique = format!("{name}_{k}");
            k += 1;
        }
        self.graph.name(node, unique.clone());
        self.names.push(unique);
        Operand::Prepared(slot)
    }

    fn node(&mut self, dag: &Dag, id: DefId, known: &mut FastMap<DefId, NodeId>) -> NodeId {
        if let Some(&node) = known.get(&id) {
            return node;
        }
        let node = match &dag.defs[id as usize] {
            Def::Leaf(symbol) => self.graph.symbol(*symbol),
            Def::Constant(number) => self.graph.number(*number),
            Def::Sum(terms) => {
                let terms = terms
                    .iter()
                    .map(|&(minus, term)| {
                        (
                            if minus {
                                Number::MINUS_ONE
                            } else {
                                Number::ONE
                            },
                            self.node(dag, term, known),
                        )
                    })
                    .collect();
                self.graph.sum(terms, Number::ZERO)
            }
            Def::Product(factors) => {
                let factors = factors
                    .iter()
                    .map(|&factor| (self.node(dag, factor, known), 2))
                    .collect();
                self.graph.product(factors)
            }
            Def::Root(x) => {
                let x = self.node(dag, *x, known);
                self.graph.sqrt(x)
            }
            Def::Recip(x) => {
                let node = self.node(dag, *x, known);
                if dag.facts[*x as usize].nonzero {
                    self.graph.assume_nonzero(node);
                }
                self.graph.power(node, -2)
            }
            Def::Call(function, x) => {
                let x = self.signed(dag, *x, known);
                self.graph.call(*function, x)
            }
            Def::Atan2(y, x) => {
                let (y, x) = (self.signed(dag, *y, known), self.signed(dag, *x, known));
                self.graph.atan2(y, x)
            }
            Def::Min(a, b) => {
                let (a, b) = (self.signed(dag, *a, known), self.signed(dag, *b, known));
                self.graph.min(a, b)
            }
            Def::Max(a, b) => {
                let (a, b) = (self.signed(dag, *a, known), self.signed(dag, *b, known));
                self.graph.max(a, b)
            }
            Def::IfZero(c, a, b) => {
                let c = self.node(dag, *c, known);
                let (a, b) = (self.signed(dag, *a, known), self.signed(dag, *b, known));
                self.graph.if_zero(c, a, b)
            }
        };
        known.insert(id, node);
        node
    }

    fn signed(
        &mut self,
        dag: &Dag,
        (minus, id): (bool, DefId),
        known: &mut FastMap<DefId, NodeId>,
    ) -> NodeId {
        let node = self.node(dag, id, known);
        if minus { self.graph.neg(node) } else { node }
    }

    /// The function that computes them all.
    pub fn program(&self) -> Program {
        let mut dag = import(&self.graph, &self.slots);
        dag.optimise();
        let mut namer = Namer::new(&[], &self.parameters, &[]);
        schedule(&dag, &self.graph, &mut namer, None)
    }
}
