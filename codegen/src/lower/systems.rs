//! Lowering of blocks `solve { … }`: coefficients of the unknowns, and the unknowns as nodes.

use super::{Lowering, Value, linear, typical};
use crate::differentiate::partials;
use crate::graph::{Node, NodeId, Symbol, ValueFacts};

impl Lowering<'_> {
    /// Solves the systems in order. Until its system is solved, an unknown is a local symbol.
    pub(crate) fn systems(&mut self) {
        let model = self.model;
        let zero = self.graph.whole(0);
        for system in &model.systems {
            let placeholders = { system.unknowns.iter() }
                .map(|_| self.graph.local(ValueFacts::default(), zero))
                .collect();
            self.unknowns.push(placeholders);
            self.determinacies.push(zero);
        }
        let points = typical::Typical::points(model, &self.layout);
        self.is_provisional = true;
        for (index, system) in model.systems.iter().enumerate() {
            let symbols = self.unknowns[index].clone();
            let with_unknowns = self.implicit(index);
            self.unknowns[index] = vec![zero; symbols.len()];
            let without = self.implicit(index);
            let rows = with_unknowns.iter().map(|&equation| {
                let column = |&symbol: &NodeId| match *self.graph.node(symbol) {
                    Node::Symbol(local @ Symbol::Local(_)) => {
                        partials::total(&mut self.graph, equation, local)
                    }
                    _ => zero,
                };
                symbols.iter().map(column).collect::<Vec<_>>()
            });
            let matrix = rows.collect();
            let right = without.iter().map(|&node| self.graph.neg(node)).collect();
            let solution = linear::solve(&mut self.graph, matrix, right, &points);
            debug_assert_eq!(solution.unknowns.len(), system.unknowns.len());
            self.unknowns[index] = solution.unknowns;
            self.determinacies[index] = solution.determinacy;
        }
        self.is_provisional = false;
        self.component_rates = None;
        self.lets.clear();
    }

    /// Left-hand sides minus right-hand sides of a system's equations, for the unknowns as they stand.
    fn implicit(&mut self, system: usize) -> Vec<NodeId> {
        let model = self.model;
        self.lets.clear();
        for quantity in &model.aux_variables {
            let value = self.evaluate(&quantity.value);
            self.lets.push(value);
        }
        let mut rows = Vec::new();
        for equation in &model.systems[system].equations {
            match self.evaluate(equation) {
                Value::Scalar(node) => rows.push(node),
                Value::Vector(vector) => rows.extend(vector),
            }
        }
        rows
    }
}
